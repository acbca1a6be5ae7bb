// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTEGER_GRID_MAP_H
#define CGAL_QUAD_LAYOUTS_INTEGER_GRID_MAP_H

#include <CGAL/Quad_layouts/Chart_transition.h>
#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsClasses

is a map of a surface onto a quad layout, whose edges have integer lengths: an integer-grid map.

Each triangle of the (refined) surface has a chart, in which its corners have coordinates. Across an
edge the chart changes by a number of quarter-turns and an integer translation. Layout vertices are
at integer points, layout edges on integer lines. Around an *anchor*, a surface vertex that is a
layout vertex of valence n, the triangles span n quarter-turns, around every other vertex four. On
the border it is one quarter-turn less. Fixed curves, like the border, are on integer lines.

All coordinates are multiples of one power of two, at most 2^-24, and below 2^48 times that in
magnitude. So transitions are exact in double precision, and predicates on them can be decided
exactly.
*/
class Integer_grid_map
{
public:
  using Surface = internal::Triangle_surface;
  using Point_2 = Eigen::Vector2d;

  /// is a change of chart, with integer translation.
  using Transition = Chart_transition<double>;

  /// ties a surface vertex to a layout vertex, and a direction there to a layout edge.
  struct Anchor
  {
    int corner;    ///< halfedge of the surface whose source is the anchored vertex
    int direction; ///< in the chart of the corner's face: 0 is +x, 1 is +y, 2 is -x, 3 is -y. The
                   ///< line in this direction leaves through this corner: it lies in the half-open
                   ///< sector from `corner` counter-clockwise to the next outgoing halfedge
    int layout_halfedge; ///< the layout halfedge that begins at the anchor in that direction
  };

  /// returns the surface. Its fixed edges are mapped to the fixed edges of the layout.
  const Surface& surface() const { return *surface_pointer; }
  /// returns the coordinates of the corner at the source of halfedge `h` in the chart of the face
  /// of `h`.
  const Point_2& coordinates(int h) const { return corner_coordinates[h]; }
  /// returns the change from the chart of the face of `h` to the chart of the face on the other
  /// side.
  const Transition& transition(int h) const { return halfedge_transition[h]; }

  /// \name The arrays
  /// @{
  std::shared_ptr<const Surface> surface_pointer;
  std::vector<Point_2> corner_coordinates;
  std::vector<Transition> halfedge_transition;
  std::vector<Anchor>
      anchors; ///< at all irregular layout vertices and corners of fixed curves, one per layout
               ///< halfedge that begins there and has a face
  std::vector<int>
      chord_length;      ///< per chord of the layout, at least 1: length of its edges in the map
  int inverted = 0;      ///< number of triangles without positive area in the map
  int wrong_winding = 0; ///< number of vertices whose angle sum is not what the layout says
  /// @}
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTEGER_GRID_MAP_H
