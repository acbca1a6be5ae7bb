// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_INTERVAL_MAP_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_INTERVAL_MAP_H

#include <CGAL/Quad_layouts/internal/right_angle.h>
#include <CGAL/Quad_layouts/internal/tracing/Labels.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The way of lines through triangles, as a monotone and piecewise linear map of the sides that they
// enter onto the sides that they leave (Ray and Sokolov, Robust polylines tracing for N-symmetry
// direction field on triangulated surfaces, 2014). Monotone maps can neither merge nor cross lines
// of one family.
//
// Of the three sides, the family of lines in a direction and in its reverse has a *base*, opposite
// an *apex*. The line through the apex hits the base in the split point; what is left of it goes to
// the one other side, what is right of it to the other. Lines along a side all go to the other one:
// then the split point is an end of the base.
class Interval_map
{
public:
  // is a point of the boundary of a triangle: on halfedge `halfedge`, t (0 to 1) from its source
  struct Position
  {
    int halfedge;
    double t;
  };

  Interval_map(const Cross_field& field, const Labels& labels) : m_field(&field), m_labels(&labels)
  {
  }

  // the point where the line of `direction` that enters at `entry` leaves the face
  Position leave(Position entry, int direction) const
  {
    const int base = m_labels->base(Labels::Surface::face(entry.halfedge), direction);
    const int before = Labels::Surface::prev(base), after = Labels::Surface::next(base);
    const double s = split(base, direction), t = entry.t;
    if (entry.halfedge == before)
      return {base, s * (1 - t)};
    if (entry.halfedge == after)
      return {base, 1 - t * (1 - s)};
    return t < s || s == 1 ? Position{before, 1 - t / s} : Position{after, (1 - t) / (1 - s)};
  }

  // the point where the line of `direction` that starts at the source of `corner` leaves the face
  Position leave_from_corner(int corner, int direction) const
  {
    const int base = Labels::Surface::next(corner);
    return {base, split(base, direction)};
  }

private:
  // keeps both parts of the base from vanishing, and the splits of the two families apart
  static constexpr double margin = 0.02, gap = 0.01;

  double split(int base, int direction) const
  {
    const int f = Labels::Surface::face(base);
    if (m_labels->runs_along(Labels::Surface::prev(base), direction))
      return 0;
    if (m_labels->runs_along(Labels::Surface::next(base), direction))
      return 1;
    if (m_labels->base(f, direction + 1) != base || runs_along_a_side(f, direction + 1))
      return hit(base, direction);
    // Both families share the apex. Of two directions towards it the left one comes from further
    // right, which is the larger t.
    const int right = m_labels->quadrant(base) + 2, left = right + 1;
    double of_right = hit(base, right), of_left = hit(base, left);
    if (of_left - of_right < gap) {
      const double mean = (of_left + of_right) / 2;
      of_right = mean - gap / 2;
      of_left = mean + gap / 2;
    }
    return ((direction - right) & 1) == 0 ? of_right : of_left;
  }

  bool runs_along_a_side(int f, int direction) const
  {
    return m_labels->runs_along(3 * f, direction) || m_labels->runs_along(3 * f + 1, direction) ||
           m_labels->runs_along(3 * f + 2, direction);
  }

  // where the straight line through the apex along `direction` meets the base
  double hit(int base, int direction) const
  {
    const int f = Labels::Surface::face(base), k = base % 3;
    const auto corners = m_field->surface().planar_corners(f);
    const double angle = m_field->angle(f) + direction * right_angle;
    const Point2 line(std::cos(angle), std::sin(angle));
    const Point2 to_apex = corners[(k + 2) % 3] - corners[k];
    const Point2 along = corners[(k + 1) % 3] - corners[k];
    const double t = cross(line, to_apex) / cross(line, along);
    return std::isfinite(t) ? std::clamp(t, margin, 1 - margin) : 0.5;
  }

  static double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

  const Cross_field* m_field;
  const Labels* m_labels;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_INTERVAL_MAP_H
