// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CHECK_MAP_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CHECK_MAP_H

#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/internal/quarter_turns.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

inline bool is_positive(const Integer_grid_map& map, int f)
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  const auto corner = [&](int k) {
    return Kernel::Point_2(map.coordinates(3 * f + k).x(), map.coordinates(3 * f + k).y());
  };
  return orientation(corner(0), corner(1), corner(2)) == LEFT_TURN;
}

// A vertex of the mesh that is held at an integer point of the map.
struct Cone
{
  int vertex;
  int index; // in quarters: how many fewer the map spans around it than around others
  int layout_vertex;
};

// Counts what keeps a map from being locally injective, and stores the counts in it.
inline void check(Integer_grid_map& map, const std::vector<Cone>& cones)
{
  const Triangle_surface& surface = map.surface();
  map.inverted = map.wrong_winding = 0;
  for (int f = 0; f < surface.number_of_faces(); ++f)
    map.inverted += !is_positive(map, f);
  std::vector<int> expected;
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    expected.push_back(surface.is_on_border(v) ? 2 : 4);
  for (const Cone& c : cones)
    expected[c.vertex] -= c.index;
  const auto corner = [&](int h) { return map.coordinates(h); };
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    map.wrong_winding += surface.halfedge(v) >= 0 &&
                         quarter_turns_around(surface, v, corner) != expected[v];
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CHECK_MAP_H
