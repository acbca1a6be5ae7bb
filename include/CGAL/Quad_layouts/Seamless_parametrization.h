// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_SEAMLESS_PARAMETRIZATION_H
#define CGAL_QUAD_LAYOUTS_SEAMLESS_PARAMETRIZATION_H

#include <CGAL/Quad_layouts/Chart_transition.h>
#include <CGAL/Quad_layouts/Cross_field.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsClasses

is a seamless parametrization of a triangle mesh: each triangle has a chart, in which its corners
have coordinates, and across an edge the chart changes by a number of quarter-turns and a
translation. So the lines of constant coordinates form one net on the surface, and lengths along
them agree everywhere.

Coordinates and translations are integer multiples of `unit`, and so are exact: the changes of chart
take the two ends of each edge to where they are in the other chart, without any error. Around a
*cone*, a vertex where the field has an index, the changes of chart compose to a rotation about the
vertex; around all others to the identity. Fixed edges have a constant coordinate.
*/
class Seamless_parametrization
{
public:
  using Surface = internal::Triangle_surface;
  using Integer = std::int64_t;
  using Point_2 = Eigen::Matrix<Integer, 2, 1>;

  /// is a change of chart, in units.
  using Transition = Chart_transition<Integer>;

  const Surface& surface() const { return *surface_pointer; }
  /// returns the coordinates, in units, of the corner at the source of halfedge `h` in the chart of
  /// the face of `h`.
  const Point_2& coordinates(int h) const { return corner_coordinates[h]; }
  /// returns the same in target edge lengths.
  Eigen::Vector2d point(int h) const
  {
    return unit / edge_length * corner_coordinates[h].cast<double>();
  }
  /// returns the change from the chart of the face of `h` to the chart of the face on the other
  /// side; the identity on the border.
  const Transition& transition(int h) const { return halfedge_transition[h]; }
  /// says if no triangle is inverted or flat, and the triangles around each vertex span the angle
  /// that its index says.
  bool is_locally_injective() const { return inverted == 0 && wrong_winding == 0; }

  /// \name The arrays
  /// @{
  std::shared_ptr<const Surface> surface_pointer;
  double unit = 1; ///< a power of two: the length of an integer step, like lengths on the surface
  double edge_length = 1; ///< the target edge length
  std::vector<Point_2> corner_coordinates;
  std::vector<Transition> halfedge_transition;
  std::vector<int> vertex_index; ///< of the field, in quarters: cones are where it is not 0
  int inverted = 0;              ///< number of triangles without positive area in the map
  int wrong_winding = 0;         ///< number of vertices whose angle sum is not what the index says
  /// @}
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_SEAMLESS_PARAMETRIZATION_H
