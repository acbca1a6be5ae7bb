// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_CURVE_DIVISIONS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_CURVE_DIVISIONS_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/curve_distance.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// returns how many segments between points of a polyline it takes, from its begin to its end, for
// none of its points to be farther from them than `tolerance`
inline int number_of_segments(const std::vector<Point>& polyline, double tolerance)
{
  const auto is_near = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first + 1; i < last; ++i)
      if (distance_to_segment(polyline[i], polyline[first], polyline[last]) > tolerance)
        return false;
    return true;
  };
  int result = 0;
  for (std::size_t first = 0, last; first + 1 < polyline.size(); first = last, ++result)
    for (last = first + 1; last + 1 < polyline.size() && is_near(first, last + 1);)
      ++last;
  return result;
}

// Raises the divisions of chords that cross fixed curves to what these need to be followed closely
// by quads. Takes the edges of the layout as polylines.
inline void raise_for_fixed_curves(const Quad_layout& layout,
                                   const std::vector<std::vector<Point>>& curves, double tolerance,
                                   std::vector<int>& divisions)
{
  for (int e = 0; e < layout.number_of_edges(); ++e)
    if (layout.is_fixed(e)) {
      int& parts = divisions[layout.chord(e)];
      parts = (std::max)(parts, number_of_segments(curves[e], tolerance));
    }
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_CURVE_DIVISIONS_H
