// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Computes a quad layout of a triangle mesh in one call, and a quad mesh in another.

#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/quad_remesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace QL = CGAL::Quad_layouts;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh, layout, quads;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "cannot read " << file << '\n';
    return EXIT_FAILURE;
  }

  try {
    QL::quad_layout(mesh, layout);
    std::cout << "a layout of " << layout.number_of_faces() << " faces\n";

    // Singularities may go farther than by default, for a simpler layout of the quads.
    QL::quad_remesh(mesh, quads, QL::parameters::maximum_displacement(4));
  } catch (const QL::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }

  const QL::Quad_mesh_measures quality = QL::measure_quad_mesh(quads, mesh);
  std::cout << quality.quads << " quads in " << quality.patches << " patches, scaled Jacobian "
            << quality.msj_average << " on average, " << quality.msj_minimum << " at least\n";
  return CGAL::IO::write_polygon_mesh("quads.off", quads) ? EXIT_SUCCESS : EXIT_FAILURE;
}
