// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_CHART_TRANSITION_H
#define CGAL_QUAD_LAYOUTS_CHART_TRANSITION_H

#include <Eigen/Core>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsClasses

is a change of chart of a map to the plane: x goes to (x turned left by `quarter_turns`) +
`translation`.

\tparam Number the type of coordinates
*/
template <class Number>
struct Chart_transition
{
  using Point_2 = Eigen::Matrix<Number, 2, 1>;

  int quarter_turns = 0; ///< 0 to 3
  Point_2 translation = Point_2::Zero();

  /// returns `x` turned left about the origin.
  static Point_2 turned(const Point_2& x, int quarter_turns)
  {
    switch (quarter_turns & 3) {
      case 0: return x;
      case 1: return Point_2(-x.y(), x.x());
      case 2: return -x;
      default: return Point_2(x.y(), -x.x());
    }
  }
  Point_2 operator()(const Point_2& x) const { return turned(x, quarter_turns) + translation; }
  /// returns the change that applies `first` and then this one.
  Chart_transition after(const Chart_transition& first) const
  {
    return {(quarter_turns + first.quarter_turns) & 3,
            turned(first.translation, quarter_turns) + translation};
  }
  Chart_transition inverse() const
  {
    return {(4 - quarter_turns) & 3, -turned(translation, 4 - quarter_turns)};
  }
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_CHART_TRANSITION_H
