// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUARTER_TURNS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUARTER_TURNS_H

#include <CGAL/Quad_layouts/internal/right_angle.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <cmath>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// the angle by which a must be turned left to have the direction of b, in [-pi, pi]
inline double signed_angle(const Point2& a, const Point2& b)
{
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

// The number of quarter-turns that the triangles around v span in a map in which the corner at the
// source of h is at corner(h). Where charts turn into each other by quarter-turns, and the border
// runs along axes, the angles sum to a multiple of one, so rounding loses nothing.
template <class Corner>
int quarter_turns_around(const Triangle_surface& surface, int v, const Corner& corner)
{
  double angle = 0;
  surface.for_each_outgoing(v, [&](int h) {
    const Point2 p = corner(h);
    angle += signed_angle(corner(Triangle_surface::next(h)) - p,
                          corner(Triangle_surface::prev(h)) - p);
  });
  return nearest_quarter_turns(angle);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUARTER_TURNS_H
