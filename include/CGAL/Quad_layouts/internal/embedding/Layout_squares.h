// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_SQUARES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_SQUARES_H

#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/Quad_layout.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

using Chart_change = Integer_grid_map::Transition;

// One chart per face of a layout: its first side begins at the origin and runs along +x.
class Layout_squares
{
public:
  Layout_squares(const Quad_layout& layout, const std::vector<int>& chord_length)
    : m_layout(layout), m_chord_length(chord_length), m_start(layout.number_of_halfedges()),
      m_direction(layout.number_of_halfedges())
  {
    for (int f = 0; f < layout.number_of_faces(); ++f) {
      int h = layout.halfedge_of(f);
      Point2 position(0, 0);
      for (int k = 0; k < 4; ++k, h = layout.next(h)) {
        m_start[h] = position;
        m_direction[h] = k;
        position = point(h, 1);
      }
    }
  }

  // the point at a fraction of h, in the chart of its face
  Point2 point(int h, double fraction) const
  {
    const double length = m_chord_length[m_layout.chord(Quad_layout::edge(h))];
    return m_start[h] + Chart_change::turned(Point2(fraction * length, 0), m_direction[h]);
  }

  // that of h in the chart of its face, in quarter-turns from +x
  int direction(int h) const { return m_direction[h]; }

  bool is_border(int h) const { return m_layout.is_border(h); }

  // the change from the chart of the face of h to that on the other side; none if h is -1 or there
  // is no other side
  Chart_change across(int h) const
  {
    if (h < 0 || is_border(Quad_layout::opposite(h)))
      return {};
    const int twin = Quad_layout::opposite(h), turns = (m_direction[twin] + 2 - m_direction[h]) & 3;
    return {turns, point(twin, 1) - Chart_change::turned(m_start[h], turns)};
  }

private:
  const Quad_layout& m_layout;
  const std::vector<int>& m_chord_length;
  std::vector<Point2> m_start;  // per halfedge, in the chart of its face
  std::vector<int> m_direction; // per halfedge, in quarter-turns from +x
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_SQUARES_H
