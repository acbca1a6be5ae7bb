// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Makes a seamless parametrization of coordinates that the program knows itself: a tube is
// unrolled, and the triangles on both sides of the cut have charts that differ by the
// circumference.

#include <CGAL/Quad_layouts/make_seamless_parametrization.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace QL = CGAL::Quad_layouts;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Coordinates = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;

struct Position
{
  int around, along;
};

// adds a triangle of a tube whose vertices come ring after ring, and coordinates of its corners
void add_triangle(Mesh& tube, Coordinates& coordinates, int ring, const Position (&corners)[3])
{
  const auto vertex = [&](const Position& p) {
    return Mesh::Vertex_index(Mesh::size_type(p.along * ring + p.around % ring));
  };
  const auto f = tube.add_face(vertex(corners[0]), vertex(corners[1]), vertex(corners[2]));
  for (const auto h : halfedges_around_face(halfedge(f, tube), tube))
    for (const Position& p : corners)
      if (target(h, tube) == vertex(p))
        coordinates[h] = Kernel::Point_2(p.around, p.along);
}

int main()
{
  const int ring = 12, length = 5;
  const double radius = ring / (2 * CGAL_PI);
  Mesh tube;
  Coordinates coordinates =
      tube.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:coordinates").first;
  for (int along = 0; along <= length; ++along)
    for (int around = 0; around < ring; ++around)
      tube.add_vertex(Kernel::Point_3(radius * std::cos(around / radius),
                                      radius * std::sin(around / radius), along));
  for (int along = 0; along < length; ++along)
    for (int around = 0; around < ring; ++around) {
      const Position a{around, along}, b{around + 1, along}, c{around + 1, along + 1},
          d{around, along + 1};
      add_triangle(tube, coordinates, ring, {a, b, c});
      add_triangle(tube, coordinates, ring, {a, c, d});
    }
  try {
    const QL::Seamless_parametrization map = QL::make_seamless_parametrization(tube, coordinates);
    const QL::T_mesh t_mesh = QL::trace_motorcycle_graph(map);
    std::cout << "1 in the map stands for " << map.edge_length << ", " << map.inverted
              << " triangles are inverted, the T-mesh has " << t_mesh.number_of_faces()
              << " patches" << std::endl;
    // a tear is refused
    coordinates[halfedge(Mesh::Vertex_index(ring + 1), tube)] += Kernel::Vector_2(.1, 0);
    QL::make_seamless_parametrization(tube, coordinates);
  } catch (const QL::Invalid_parametrization& error) {
    std::cout << error.what() << std::endl;
    return EXIT_SUCCESS;
  } catch (const QL::Error& error) {
    std::cerr << error.what() << std::endl;
  }
  return EXIT_FAILURE;
}
