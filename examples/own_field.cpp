// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Remeshes a model with quads that follow a field of our own: in each face the horizontal
// direction, so that one family of lines runs level around the model.

#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/quad_remesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

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
  Mesh mesh, quads;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
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
    QL::quad_remesh(mesh, quads, QL::parameters::face_direction_map(directions));
  } catch (const QL::Error& error) {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  const QL::Quad_mesh_measures quality = QL::measure_quad_mesh(quads);
  std::cout << quality.quads << " quads, " << quality.irregular_vertices << " irregular vertices, "
            << quality.patches << " patches" << std::endl;
  return CGAL::IO::write_polygon_mesh("quads.off", quads) ? EXIT_SUCCESS : EXIT_FAILURE;
}
