// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_CURVE_DISTANCE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_CURVE_DISTANCE_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// how far the edges of quads may be from fixed curves of a surface
inline double curve_tolerance(const Triangle_surface& surface)
{
  return 8e-4 * surface.diagonal();
}

// returns the distance of x from the segment between p and q
inline double distance_to_segment(const Point& x, const Point& p, const Point& q)
{
  const Point side = q - p;
  const double length = side.squaredNorm(), along = side.dot(x - p);
  const double fraction = length > 0 ? std::clamp(along / length, 0., 1.) : 0;
  return (p + fraction * side - x).norm();
}

// Returns the indices of those vertices of a polyline between which it is nowhere farther than
// `tolerance` from the straight line: the first, the last, and as few others as going as far as
// possible again and again leads to.
inline std::vector<std::size_t> knots_of(const std::vector<Point>& polyline, double tolerance)
{
  const auto is_near = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first + 1; i < last; ++i)
      if (distance_to_segment(polyline[i], polyline[first], polyline[last]) > tolerance)
        return false;
    return true;
  };
  std::vector<std::size_t> result = {0};
  for (std::size_t last; result.back() + 1 < polyline.size(); result.push_back(last))
    for (last = result.back() + 1; last + 1 < polyline.size() && is_near(result.back(), last + 1);)
      ++last;
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_CURVE_DISTANCE_H
