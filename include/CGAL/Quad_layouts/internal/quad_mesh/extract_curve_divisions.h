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

// Raises the divisions of chords that cross fixed curves to what these need to be followed closely
// by quads. Takes the edges of the layout as polylines.
inline void raise_for_fixed_curves(const Quad_layout& layout,
                                   const std::vector<std::vector<Point>>& curves, double tolerance,
                                   std::vector<int>& divisions)
{
  for (int e = 0; e < layout.number_of_edges(); ++e)
    if (layout.is_fixed(e)) {
      int& parts = divisions[layout.chord(e)];
      parts = (std::max)(parts, int(knots_of(curves[e], tolerance).size()) - 1);
    }
}

// Raises the divisions of edges that lead straight from one corner of fixed curves to another. Both
// ends stay where they are, and the direction between them may leave a quad no room.
inline void raise_between_corners(const Quad_layout& layout, std::vector<int>& divisions)
{
  const auto is_corner = [&](int v) {
    return layout.is_on_fixed_curve(v) && !layout.goes_straight_on(v);
  };
  for (int e = 0; e < layout.number_of_edges(); ++e)
    if (!layout.is_fixed(e) && is_corner(layout.source(2 * e)) && is_corner(layout.target(2 * e)))
      divisions[layout.chord(e)] = (std::max)(divisions[layout.chord(e)], 2);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_CURVE_DIVISIONS_H
