// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_ISOLINE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_ISOLINE_H

#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/internal/parametrization/Integer_128.h>

#include <CGAL/assertions.h>

#include <cstdlib>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A line of constant coordinate in the chart of a face, which began at `origin`, where that would be in this
// chart if the charts on its way were laid out one beside the other.
//
// Lines run through vertices, along edges and over each other, on symmetric surfaces everywhere. So all
// of them are turned right by the same infinitesimal angle: at length x a line is infinitely little, but
// proportionally to x, to the right of where it should be. Charts agree about that, as they agree about
// right angles; such lines of one family are parallel everywhere, and none runs through a vertex. They
// cross the same edges on any surface on which they are turned little enough, hence all orders that they
// have are consistent. Lengths are those without the turn.
struct Isoline
{
  using Integer = Seamless_parametrization::Integer;
  using Point_2 = Seamless_parametrization::Point_2;
  using Transition = Seamless_parametrization::Transition;

  Point_2 origin;
  int direction; // a number of quarter-turns from the x-axis of the chart

  // the same line in the chart behind a change of chart
  Isoline continued(const Transition& transition) const
  {
    return {transition(origin), (direction + transition.quarter_turns) & 3};
  }

  // a point in the frame of the line: x ahead of its origin, y to the left
  Point_2 seen(const Point_2& p) const { return Transition::turned(p - origin, 4 - direction); }

  // Says if a point that the line comes to, or passes, is on its left. Those on the line are.
  bool has_on_left(const Point_2& p) const { return seen(p).y() >= 0; }

  // the length of the line up to where it meets a line of the other family
  Integer length_before(const Isoline& other) const
  {
    const bool is_horizontal = direction % 2 == 0;
    const Point_2 meeting = is_horizontal ? Point_2(other.origin.x(), origin.y())
                                          : Point_2(origin.x(), other.origin.y());
    return seen(meeting).x();
  }
};

// The point in which an isoline cuts a segment, which it crosses.
class Isoline_cut
{
public:
  using Integer = Isoline::Integer;
  using Point_2 = Isoline::Point_2;

  Isoline_cut(const Isoline& line, const Point_2& source, const Point_2& target)
    : m_source(line.seen(source)), m_vector(line.seen(target) - m_source)
  {
    CGAL_assertion(m_vector.y() != 0); // lines do not cross those parallel to them
  }

  // the fraction of the segment before the cut, rounded
  double fraction() const { return -double(m_source.y()) / double(m_vector.y()); }

  // the distance of the cut from the source of a segment at a right angle to the line
  Integer distance_from_source() const { return std::abs(m_source.y()); }

  // the length of the line before the cut, rounded down
  Integer length() const
  {
    const Integer_128 product = Integer_128(m_source.x()) * m_vector.y() -
                                Integer_128(m_source.y()) * m_vector.x();
    const Integer_128 quotient = product / m_vector.y(), rest = product % m_vector.y();
    return static_cast<Integer>(rest != 0 && (rest < 0) != (m_vector.y() < 0) ? quotient - 1
                                                                              : quotient);
  }

  // Says if this cut of a segment is nearer to its source than another one. Turned right by an angle with
  // the tangent e, a line is where y + e x = 0, and so cuts a segment from a on along v at the fraction
  // -(a.y + e a.x) / (v.y + e v.x). The difference of two fractions has the sign of a polynomial in e,
  // which is that of the first coefficient that is not 0. All three are 0 only for lines from one origin.
  friend bool operator<(const Isoline_cut& s, const Isoline_cut& t)
  {
    const auto &a = s.m_source, &v = s.m_vector, &b = t.m_source, &w = t.m_vector;
    const auto product = [](Integer x, Integer y) { return Integer_128(x) * y; };
    const bool is_reversed = (v.y() < 0) != (w.y() < 0);
    Integer_128 difference = product(b.y(), v.y()) - product(a.y(), w.y());
    if (difference == 0)
      difference = product(b.y(), v.x()) + product(b.x(), v.y()) - product(a.y(), w.x()) -
                   product(a.x(), w.y());
    if (difference == 0)
      difference = product(b.x(), v.x()) - product(a.x(), w.x());
    CGAL_assertion(difference != 0);
    return is_reversed ? difference > 0 : difference < 0;
  }

private:
  Point_2 m_source, m_vector; // of the segment, in the frame of the line
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_ISOLINE_H
