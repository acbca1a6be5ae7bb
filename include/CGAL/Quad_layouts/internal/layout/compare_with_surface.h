// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_COMPARE_WITH_SURFACE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_COMPARE_WITH_SURFACE_H

#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/layout/fibres.h>
#include <CGAL/Quad_layouts/internal/layout/glued_squares.h>
#include <CGAL/Quad_layouts/internal/layout/number_classes.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// This header decides if glued squares are the surface again, without asking why they are not: it
// counts vertices, edges and faces of both, and does not use what `Fibre_loops` knows.

// Returns the vertex of the squares that each fibre has become, -1 if none, -2 if several.
inline std::vector<int> vertex_of_fibres(const Fibres& fibres, const Glued_squares& squares)
{
  std::vector<int> result(fibres.size(), -1);
  for (int s = 0; s < squares.number_of_sides(); ++s) {
    if (squares.half_segment(s) < 0)
      continue;
    int& v = result[fibres.fibre_of_point(fibres.grid().source(squares.half_segment(s)))];
    v = v == -1 || v == squares.vertex(s) ? squares.vertex(s) : -2;
  }
  return result;
}

// Says at which node the squares differ from the surface, or nothing.
inline std::string local_difference(const Fibres& fibres, const Glued_squares& squares)
{
  const T_mesh& t = fibres.grid().t_mesh();
  std::vector<int> index(fibres.size(), 0);
  for (int n = 0; n < t.number_of_vertices(); ++n)
    index[fibres.fibre_of_point(n)] += t.index(n);
  const std::vector<int> vertex = vertex_of_fibres(fibres, squares);
  for (int f = 0; f < fibres.size(); ++f) {
    const std::string node = std::to_string(fibres.fibre(f).points.front());
    if (vertex[f] == -1)
      return "no square is left at node " + node;
    if (vertex[f] == -2)
      return "the surface is pinched at node " + node;
    if (squares.is_on_border(vertex[f]) != fibres.is_on_border(f))
      return "the border is changed at node " + node;
    if (squares.number_of_squares_at(vertex[f]) != (fibres.is_on_border(f) ? 2 : 4) - index[f])
      return "the valence at node " + node + " does not fit its index";
  }
  return "";
}

// Returns the component of the T-mesh that each patch belongs to, numbered from 0.
inline std::vector<int> component_of_patches(const T_mesh& t)
{
  Disjoint_sets sets(t.number_of_faces());
  for (int a = 0; a < t.number_of_edges(); ++a)
    if (!t.is_border_edge(a))
      sets.union_set(t.face(2 * a), t.face(2 * a + 1));
  return number_classes(sets, t.number_of_faces()).class_of;
}

// Returns the Euler characteristic of each component.
inline std::vector<int> euler_characteristics(const T_mesh& t, const std::vector<int>& component)
{
  std::vector<int> result(t.number_of_faces(), 0);
  for (int c : component)
    ++result[c];
  for (int a = 0; a < t.number_of_edges(); ++a)
    --result[component[(std::max)(t.face(2 * a), t.face(2 * a + 1))]];
  for (int n = 0; n < t.number_of_vertices(); ++n)
    ++result[component[t.face(t.halfedge_from(n))]];
  return result;
}

// Returns the Euler characteristic of the squares of each component.
inline std::vector<int> euler_characteristics(const Glued_squares& squares,
                                              const std::vector<int>& component)
{
  std::vector<int> result(component.size(), 0);
  std::vector<char> counted(squares.number_of_vertices(), 0);
  for (int s = 0; s < squares.number_of_sides(); ++s) {
    const bool is_new_vertex = !counted[squares.vertex(s)];
    counted[squares.vertex(s)] = 1;
    result[component[squares.patch(s / 4)]] += int(is_new_vertex) + int(s % 4 == 0) -
                                               int(squares.opposite(s) < 0 ||
                                                   s < squares.opposite(s));
  }
  return result;
}

// Says how the squares differ from the surface, or nothing: one vertex per fibre, the valences that
// the indices ask for, and the same Euler characteristic of each component. Neighbours in the
// T-mesh remain neighbours or become one, so components cannot fall apart.
inline std::string difference_to_surface(const Fibres& fibres, const Glued_squares& squares)
{
  const std::string reason = local_difference(fibres, squares);
  if (!reason.empty())
    return reason;
  const T_mesh& t = fibres.grid().t_mesh();
  const std::vector<int> component = component_of_patches(t);
  return euler_characteristics(t, component) == euler_characteristics(squares, component)
             ? ""
             : "the Euler characteristic changes";
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_COMPARE_WITH_SURFACE_H
