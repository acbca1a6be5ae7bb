// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_RIGHT_ANGLE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_RIGHT_ANGLE_H

#include <CGAL/number_type_config.h>

#include <cmath>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// the unit of all that a cross field turns by
constexpr double right_angle = CGAL_PI / 2;

inline int nearest_quarter_turns(double angle)
{
  return int(std::lround(angle / right_angle));
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_RIGHT_ANGLE_H
