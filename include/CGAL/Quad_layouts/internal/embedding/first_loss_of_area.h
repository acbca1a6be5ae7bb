// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_FIRST_LOSS_OF_AREA_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_FIRST_LOSS_OF_AREA_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <array>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// the least positive t at which the triangle with the corners x + t dx, which is positive for t =
// 0, has no area; infinite if there is none
inline double first_loss_of_area(const std::array<Point2, 3>& x, const std::array<Point2, 3>& dx)
{
  const auto cross = [](const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); };
  const Point2 a = x[1] - x[0], b = x[2] - x[0], da = dx[1] - dx[0], db = dx[2] - dx[0];
  const double c0 = cross(a, b), c1 = cross(a, db) + cross(da, b), c2 = cross(da, db);
  const double discriminant = c1 * c1 - 4 * c0 * c2;
  if (discriminant < 0)
    return (std::numeric_limits<double>::infinity)();
  // c0 is positive, so the roots are 2 c0 / (-c1 +- sqrt(discriminant)), of which the larger
  // denominator belongs to the least positive one
  const double denominator = std::sqrt(discriminant) - c1;
  return denominator > 0 ? 2 * c0 / denominator : (std::numeric_limits<double>::infinity)();
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_FIRST_LOSS_OF_AREA_H
