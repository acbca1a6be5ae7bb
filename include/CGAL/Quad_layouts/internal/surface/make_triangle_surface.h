// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_MAKE_TRIANGLE_SURFACE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_MAKE_TRIANGLE_SURFACE_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>
#include <CGAL/Quad_layouts/internal/surface/mesh_numbering.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

using Triangle = std::array<int, 3>;

// returns "face f (vertices a, b, c)"
inline std::string named_face(int f, const Triangle& t)
{
  return "face " + std::to_string(f) + " (vertices " + std::to_string(t[0]) + ", " +
         std::to_string(t[1]) + ", " + std::to_string(t[2]) + ")";
}

// returns "edge (a, b)"
inline std::string named_edge(int source, int target)
{
  return "edge (" + std::to_string(source) + ", " + std::to_string(target) + ")";
}

inline void check_points(const std::vector<Point>& points)
{
  const auto bad = std::find_if_not(points.begin(), points.end(),
                                    [](const Point& p) { return p.allFinite(); });
  if (bad != points.end())
    throw Non_finite_point("vertex " + std::to_string(bad - points.begin()) +
                           " has a coordinate that is not a finite number");
}

// Squares of areas, the highest powers that occur, are then far from the limits of double
// precision.
inline void check_scale(const Triangle_surface& surface)
{
  constexpr double most = 1e60, least = 1e-60;
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    if (surface.point(v).lpNorm<Eigen::Infinity>() > most)
      throw Unsuitable_scale("vertex " + std::to_string(v) + " has a coordinate that is too large");
  if (surface.diagonal() < least)
    throw Unsuitable_scale("the mesh is too small");
}

// decides exactly, for the given double coordinates, whether the corners of `t` are on a line
inline bool has_no_area(const Triangle& t, const std::vector<Point>& points)
{
  using Point_3 = Exact_predicates_inexact_constructions_kernel::Point_3;
  const auto corner = [&](int i) {
    const Point& p = points[t[i]];
    return Point_3(p.x(), p.y(), p.z());
  };
  return collinear(corner(0), corner(1), corner(2));
}

inline void check_no_degenerate_face(const std::vector<Triangle>& triangles,
                                     const std::vector<Point>& points)
{
  for (int f = 0; f < int(triangles.size()); ++f) {
    const Triangle& t = triangles[f];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      throw Degenerate_face(named_face(f, t) + " repeats a vertex");
    if (has_no_area(t, points))
      throw Degenerate_face(named_face(f, t) + " has no area");
  }
}

// returns the permutation that sorts `keys`, equal ones by position
template <class Key>
std::vector<int> sorting_order(const std::vector<Key>& keys)
{
  std::vector<int> order(keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return keys[i] < keys[j]; });
  return order;
}

// returns the positions of two equal keys, {-1, -1} if all differ
template <class Key>
std::pair<int, int> find_equal_pair(const std::vector<Key>& keys)
{
  const std::vector<int> order = sorting_order(keys);
  const auto first = std::adjacent_find(order.begin(), order.end(),
                                        [&](int i, int j) { return keys[i] == keys[j]; });
  return first == order.end() ? std::make_pair(-1, -1) : std::make_pair(first[0], first[1]);
}

inline void check_no_duplicate_face(const std::vector<Triangle>& triangles)
{
  std::vector<Triangle> sorted = triangles;
  for (Triangle& t : sorted)
    std::sort(t.begin(), t.end());
  const auto [f, g] = find_equal_pair(sorted);
  if (f >= 0)
    throw Duplicate_face(named_face(f, triangles[f]) + " and face " + std::to_string(g) +
                         " have the same vertices");
}

// A directed edge may occur once: twice means that more than two faces, or two faces of opposite
// orientation, meet there, or that the graph has two edges between the same vertices.
inline void check_edges(const std::vector<Triangle>& triangles)
{
  std::vector<std::pair<int, int>> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i)
      edges.emplace_back(t[i], t[(i + 1) % 3]);
  const auto [h, g] = find_equal_pair(edges);
  if (h >= 0)
    throw Non_manifold_edge(named_edge(edges[h].first, edges[h].second) + " occurs in face " +
                            std::to_string(h / 3) + " and, in the same direction, in face " +
                            std::to_string(g / 3));
}

// The corners at a vertex form one cycle exactly if turning about it meets as many as there are.
inline void check_vertices(const Triangle_surface& surface)
{
  std::vector<int> missed(surface.number_of_vertices(), 0);
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    ++missed[surface.source(h)];
  for (int v = 0; v < surface.number_of_vertices(); ++v) {
    surface.for_each_outgoing(v, [&](int) { --missed[v]; });
    if (missed[v] != 0)
      throw Non_manifold_vertex("several fans of faces meet in vertex " + std::to_string(v));
  }
}

// returns the surface of the given faces, or throws if it is not a manifold of proper triangles; in
// time O(n log n)
inline Triangle_surface make_checked_surface(std::vector<Point> points,
                                             const std::vector<Triangle>& triangles)
{
  if (triangles.empty())
    throw Empty_mesh("the mesh has no face");
  check_points(points);
  check_no_degenerate_face(triangles, points);
  check_no_duplicate_face(triangles);
  check_edges(triangles);
  Triangle_surface surface(std::move(points), triangles);
  check_scale(surface);
  check_vertices(surface);
  return surface;
}

// returns the points of the vertices of `mesh` in their order, in double precision
template <class FaceGraph, class VertexPointMap>
std::vector<Point> numbered_points(const FaceGraph& mesh, VertexPointMap vertex_point)
{
  std::vector<Point> points;
  points.reserve(num_vertices(mesh));
  for (const auto v : vertices(mesh)) {
    const auto& p = get(vertex_point, v);
    points.emplace_back(to_double(p.x()), to_double(p.y()), to_double(p.z()));
  }
  return points;
}

// returns the numbers of the vertices of each face, from the source of `halfedge(f, mesh)` on
template <class FaceGraph>
std::vector<Triangle> numbered_triangles(const FaceGraph& mesh)
{
  const auto number = vertex_numbers(mesh);
  std::vector<Triangle> triangles;
  triangles.reserve(num_faces(mesh));
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const auto sides = halfedges_around_face(h, mesh).size();
    if (sides != 3)
      throw Non_triangle_face("face " + std::to_string(triangles.size()) + " has " +
                              std::to_string(sides) + " sides instead of three");
    triangles.push_back({get(number, source(h, mesh)), get(number, target(h, mesh)),
                         get(number, target(next(h, mesh), mesh))});
  }
  return triangles;
}

// returns the working copy of `mesh`, or throws an `Invalid_mesh` that names what cannot be used
template <class FaceGraph, class VertexPointMap>
Triangle_surface make_triangle_surface(const FaceGraph& mesh, VertexPointMap vertex_point)
{
  return make_checked_surface(numbered_points(mesh, vertex_point), numbered_triangles(mesh));
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_MAKE_TRIANGLE_SURFACE_H
