// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SECTORS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SECTORS_H

#include <CGAL/Quad_layouts/internal/field/matching.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The *sector* of a fixed halfedge reaches from it, counter-clockwise about its source, to the next
// fixed edge. The field is aligned to both, and so makes a number of quarter-turns in between.

// returns the fixed halfedge whose sector has the halfedge h inside or begins with it, -1 if no fixed
// edge is at its source
inline int sector_of(const Triangle_surface& surface, int h)
{
  for (int g = h; g >= 0;) {
    if (surface.is_fixed(g))
      return g;
    g = surface.turn_right(g);
    if (g == h)
      break;
  }
  return -1;
}

// returns the halfedges inside of the sector of h
inline std::vector<int> inside_of_sector(const Triangle_surface& surface, int h)
{
  std::vector<int> result;
  for (int g = surface.turn_left(h); g >= 0 && !surface.is_fixed(g); g = surface.turn_left(g))
    result.push_back(g);
  return result;
}

// returns the quadrants of the field in the sector of h; up to rounding errors it is an integer
inline int number_of_quadrants(const Face_connection& connection, const std::vector<double>& angles,
                               const std::vector<int>& jumps, int h)
{
  double turn = connection.corner_angle(h);
  for (int g : inside_of_sector(connection.surface(), h))
    turn += connection.corner_angle(g) + rotation(connection, angles, jumps, g);
  return int(std::lround(turn / right_angle));
}

// Lets the field have at least one quadrant in each sector, where a quad will be. Where fixed edges
// meet at an acute angle, the field that turns least has none. The quarter of index that this takes
// goes to the other end of an edge in the sector, which no fixed edge has.
inline void open_sectors(const Face_connection& connection, const std::vector<double>& angles,
                         std::vector<int>& jumps)
{
  const Triangle_surface& surface = connection.surface();
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    if (!surface.is_fixed(h))
      continue;
    const std::vector<int> inside = inside_of_sector(surface, h);
    const auto opened = [&](int g) {
      return std::abs(rotation(connection, angles, jumps, g) + right_angle);
    };
    for (int n = number_of_quadrants(connection, angles, jumps, h); n < 1 && !inside.empty(); ++n) {
      const int best = *std::min_element(inside.begin(), inside.end(),
                                         [&](int a, int b) { return opened(a) < opened(b); });
      ++jumps[best];
      --jumps[surface.opposite(best)];
    }
  }
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SECTORS_H
