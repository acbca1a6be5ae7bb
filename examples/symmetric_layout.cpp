// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Computes a layout of a rounded box that is the same on the left and on the right, although
// patches on the left are dearer; and that keeps the box's alignments.

#include <CGAL/Quad_layouts/quad_remesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <iostream>
#include <vector>

namespace QL = CGAL::Quad_layouts;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

// a box with rounded edges, whose triangles are symmetric, too
Mesh rounded_box()
{
  Mesh mesh;
  CGAL::make_hexahedron(Point(-3, -1, -2), Point(3, -1, -2), Point(3, 1, -2), Point(-3, 1, -2),
                        Point(-3, 1, 2), Point(-3, -1, 2), Point(3, -1, 2), Point(3, 1, 2), mesh);
  CGAL::Subdivision_method_3::CatmullClark_subdivision(mesh,
                                                       CGAL::parameters::number_of_iterations(3));
  const std::vector<Mesh::Face_index> squares(faces(mesh).begin(), faces(mesh).end());
  for (const Mesh::Face_index f : squares) {
    std::vector<Point> corners;
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh))
      corners.push_back(mesh.point(v));
    const auto h = CGAL::Euler::add_center_vertex(halfedge(f, mesh), mesh);
    mesh.point(target(h, mesh)) = CGAL::centroid(corners[0], corners[1], corners[2], corners[3]);
  }
  return mesh;
}

// for each vertex the one at the mirrored place
std::vector<int> mirror_images(const Mesh& mesh)
{
  std::vector<int> result;
  for (const auto v : vertices(mesh)) {
    const Point p(-mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
    for (const auto w : vertices(mesh))
      if (CGAL::squared_distance(p, mesh.point(w)) < 1e-12)
        result.push_back(int(w));
  }
  return result;
}

int main()
{
  Mesh mesh = rounded_box(), layout;
  auto weight = mesh.add_property_map<Mesh::Face_index, double>("f:weight", 1.).first;
  for (const auto f : faces(mesh))
    if (mesh.point(target(halfedge(f, mesh), mesh)).x() < 0)
      weight[f] = 3;
  try {
    QL::quad_layout(mesh, layout,
                    QL::parameters::face_weight_map(weight)
                        .vertex_symmetry(mirror_images(mesh))
                        .lock_alignments(true));
  } catch (const QL::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  std::cout << num_faces(layout) << " squares in the layout\n";
  return CGAL::IO::write_polygon_mesh("layout.off", layout) ? EXIT_SUCCESS : EXIT_FAILURE;
}
