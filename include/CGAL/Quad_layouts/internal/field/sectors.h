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

// returns the fixed halfedge whose sector has the halfedge h inside or begins with it, -1 if no
// fixed edge is at its source
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

// returns the angle of the surface in the sector of h
inline double sector_angle(const Face_connection& connection, int h)
{
  double result = connection.corner_angle(h);
  for (int g : inside_of_sector(connection.surface(), h))
    result += connection.corner_angle(g);
  return result;
}

// returns the quadrants that a sector with this angle needs at least, such that the quads there can
// be convex
inline int least_number_of_quadrants(double sector_angle)
{
  constexpr double widest = 5. / 3 * right_angle;
  return (std::max)(1, int(std::ceil(sector_angle / widest)));
}

// returns the quadrants of the field in the sector of h; up to rounding errors it is an integer
inline int number_of_quadrants(const Face_connection& connection, const std::vector<double>& angles,
                               const std::vector<int>& jumps, int h)
{
  double turn = sector_angle(connection, h);
  for (int g : inside_of_sector(connection.surface(), h))
    turn += rotation(connection, angles, jumps, g);
  return nearest_quarter_turns(turn);
}

// whether a halfedge is inside of a sector that has no quadrant to spare
inline bool is_in_narrow_sector(const Face_connection& connection,
                                const std::vector<double>& angles, const std::vector<int>& jumps,
                                int h)
{
  const int first = connection.surface().is_fixed(h) ? -1 : sector_of(connection.surface(), h);
  return first >= 0 && number_of_quadrants(connection, angles, jumps, first) <=
                           least_number_of_quadrants(sector_angle(connection, first));
}

// Lets the field have as many quadrants in each sector as that needs at least: where fixed edges
// meet at an acute angle, the field that turns least has none. The quarter of index that this takes
// goes to the other end of an edge in the sector, which no fixed edge has. Returns the vertices
// where this was needed.
inline std::vector<int> open_sectors(const Face_connection& connection,
                                     const std::vector<double>& angles, std::vector<int>& jumps)
{
  const Triangle_surface& surface = connection.surface();
  std::vector<int> result;
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    if (!surface.is_fixed(h))
      continue;
    const std::vector<int> inside = inside_of_sector(surface, h);
    const auto opened = [&](int g) {
      return std::abs(rotation(connection, angles, jumps, g) + right_angle);
    };
    const int missing = least_number_of_quadrants(sector_angle(connection, h)) -
                        number_of_quadrants(connection, angles, jumps, h);
    for (int i = 0; i < missing && !inside.empty(); ++i) {
      const int best = *std::min_element(inside.begin(), inside.end(),
                                         [&](int a, int b) { return opened(a) < opened(b); });
      ++jumps[best];
      --jumps[surface.opposite(best)];
      result.push_back(surface.source(h));
    }
  }
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SECTORS_H
