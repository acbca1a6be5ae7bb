// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Traces a T-mesh in a field of our own: in each face the horizontal direction, so that one family
// of lines runs level around the model.

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace QL = CGAL::Quad_layouts;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/knot1.off");
  Mesh mesh;
  if (!PMP::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // One vector per face; it need not lie in the face, nor have a length of one.
  auto directions = mesh.add_property_map<Mesh::Face_index, Vector>("f:direction").first;
  for (Mesh::Face_index f : faces(mesh)) {
    const Vector normal = PMP::compute_face_normal(f, mesh);
    const Vector level = CGAL::cross_product(normal, Vector(0, 0, 1));
    directions[f] = level.squared_length() > 0.01 ? level : Vector(1, 0, 0);
  }

  try {
    const QL::Cross_field field =
      QL::compute_cross_field(mesh, QL::parameters::face_direction_map(directions));
    const QL::T_mesh t_mesh = QL::trace_motorcycle_graph(field);
    std::cout << field.number_of_singularities() << " singularities, " << t_mesh.number_of_faces()
              << " patches in the T-mesh" << std::endl;
  } catch (const QL::Error& error) {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
