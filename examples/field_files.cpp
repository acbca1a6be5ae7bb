// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Writes a cross field for another tool, and reads one that another tool has made.

#include <CGAL/Quad_layouts/IO/cross_field.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace QL = CGAL::Quad_layouts;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/eight.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto directions = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:direction").first;
  try {
    const QL::Cross_field smooth = QL::compute_cross_field(
        mesh, QL::parameters::cross_field_method(QL::MIXED_INTEGER));
    std::ofstream out("field.rawfield");
    if (!QL::IO::write_cross_field(out, smooth, QL::RAWFIELD))
      return EXIT_FAILURE;
    out.close();

    std::ifstream in("field.rawfield");
    QL::IO::read_cross_field(in, QL::RAWFIELD, mesh, directions);
    const QL::Cross_field given = QL::compute_cross_field(
        mesh, QL::parameters::face_direction_map(directions));
    std::cout << smooth.number_of_singularities() << " singularities written, "
              << given.number_of_singularities() << " read" << std::endl;
  } catch (const QL::Error& error) {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
