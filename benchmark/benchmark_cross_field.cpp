// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Computes a cross field on each of the given meshes by either method, and prints a line of
// comma-separated values for each: the singularities, the energy (half of the weighted squares of
// the angles by which the field turns across edges) and the seconds of processor time.

#include <CGAL/Quad_layouts/compute_cross_field.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Timer.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace QL = CGAL::Quad_layouts;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

double energy(const QL::Cross_field& field)
{
  using QL::internal::right_angle;
  const auto& surface = field.surface();
  const QL::internal::Face_connection connection(surface);
  double sum = 0;
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    if (surface.is_border(h))
      continue;
    const int f = surface.face(h), g = surface.face(surface.opposite(h));
    const double turn = std::remainder(field.angle(g) - field.angle(f) - connection.transport(h) +
                                           field.matching(h) * right_angle,
                                       4 * right_angle);
    sum += connection.weight(surface.edge(h)) * turn * turn;
  }
  return sum / 4; // every edge has two halfedges
}

void run(const std::string& file, const Mesh& mesh, const char* name, QL::Cross_field_method method)
{
  CGAL::Timer timer;
  timer.start();
  const QL::Cross_field field = QL::compute_cross_field(mesh,
                                                        QL::parameters::cross_field_method(method));
  const double seconds = timer.time();
  std::cout << file << ',' << field.surface().number_of_faces() << ',' << name << ','
            << field.number_of_singularities() << ',' << energy(field) << ',' << seconds
            << std::endl;
}

int main(int argc, char* argv[])
{
  std::cout << "mesh,faces,method,singularities,energy,seconds" << std::endl;
  int failures = 0;
  for (int i = 1; i < argc; ++i)
    try {
      Mesh mesh;
      if (!CGAL::IO::read_polygon_mesh(argv[i], mesh))
        throw QL::Error("cannot be read");
      run(argv[i], mesh, "diffusion", QL::DIFFUSION);
      run(argv[i], mesh, "mixed-integer", QL::MIXED_INTEGER);
    } catch (const QL::Error& error) {
      std::cerr << argv[i] << ": " << error.what() << '\n';
      ++failures;
    }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
