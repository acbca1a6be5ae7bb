// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_CHECK_PARAMETRIZATION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_CHECK_PARAMETRIZATION_H

#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/internal/parametrization/Integer_128.h>
#include <CGAL/Quad_layouts/internal/quarter_turns.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// These functions know a parametrization only, not how it was made.

// twice the area of face f in the map, in squared units
inline Integer_128 area_in_map(const Seamless_parametrization& map, int f)
{
  const auto &p = map.coordinates(3 * f), &q = map.coordinates(3 * f + 1),
             &r = map.coordinates(3 * f + 2);
  return Integer_128(q.x() - p.x()) * (r.y() - p.y()) -
         Integer_128(q.y() - p.y()) * (r.x() - p.x());
}

// Says what is not exact: a transition that does not take the ends of its edge to where they are on
// the other side, two opposite ones that are no inverses, a fixed edge without a constant
// coordinate, or a vertex around which the quarter-turns do not sum to its index. Empty if all is
// exact.
inline std::string inexactness(const Seamless_parametrization& map)
{
  const Triangle_surface& surface = map.surface();
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    const int next = Triangle_surface::next(h), g = surface.opposite(h);
    const std::string where = "the halfedge from vertex " + std::to_string(surface.source(h)) +
                              " to vertex " + std::to_string(surface.target(h));
    const auto vector = (map.coordinates(next) - map.coordinates(h)).eval();
    if (surface.is_fixed(h) && vector.x() != 0 && vector.y() != 0)
      return where + " is fixed, but has no constant coordinate";
    if (g < 0)
      continue;
    if (map.transition(h)(map.coordinates(h)) != map.coordinates(Triangle_surface::next(g)) ||
        map.transition(h)(map.coordinates(next)) != map.coordinates(g))
      return "the transition does not fit " + where;
    const auto back = map.transition(g).after(map.transition(h));
    if (back.quarter_turns != 0 || !back.translation.isZero(0))
      return "the transitions of " + where + " and its opposite are no inverses";
  }
  for (int v = 0; v < surface.number_of_vertices(); ++v) {
    if (surface.halfedge(v) < 0 || surface.is_on_border(v))
      continue;
    int turns = 0;
    surface.for_each_outgoing(
        v, [&](int h) { turns += map.transition(Triangle_surface::prev(h)).quarter_turns; });
    if ((turns - map.vertex_index[v]) % 4 != 0)
      return "the quarter-turns around vertex " + std::to_string(v) + " do not fit its index";
  }
  return "";
}

inline int number_of_inverted_faces(const Seamless_parametrization& map)
{
  int result = 0;
  for (int f = 0; f < map.surface().number_of_faces(); ++f)
    result += area_in_map(map, f) <= 0;
  return result;
}

// says if the triangles around v span the angle that its index demands
inline bool has_right_angle_sum(const Seamless_parametrization& map, int v)
{
  const int quadrants = (map.surface().is_on_border(v) ? 2 : 4) - map.vertex_index[v];
  return quarter_turns_around(map.surface(), v, [&](int h) { return map.point(h); }) == quadrants;
}

// the vertices without the angle that their index demands
inline std::vector<int> wrong_windings(const Seamless_parametrization& map)
{
  std::vector<int> result;
  for (int v = 0; v < map.surface().number_of_vertices(); ++v)
    if (map.surface().halfedge(v) >= 0 && !has_right_angle_sum(map, v))
      result.push_back(v);
  return result;
}

// how much is wrong with a map
inline int number_of_defects(const Seamless_parametrization& map)
{
  return map.inverted + map.wrong_winding;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_CHECK_PARAMETRIZATION_H
