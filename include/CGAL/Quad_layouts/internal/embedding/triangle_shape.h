// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_TRIANGLE_SHAPE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_TRIANGLE_SHAPE_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <cmath>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// a normal as long as twice the area
inline Point triangle_normal(const Point& p, const Point& q, const Point& r)
{
  return (q - p).cross(r - p);
}

// 1 for an equilateral triangle, 0 for one without area
inline double triangle_quality(const Point& p, const Point& q, const Point& r)
{
  const double sum = (q - p).squaredNorm() + (r - q).squaredNorm() + (p - r).squaredNorm();
  return sum > 0 ? 2 * std::sqrt(3.) * triangle_normal(p, q, r).norm() / sum : 0;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_TRIANGLE_SHAPE_H
