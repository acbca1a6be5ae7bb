// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_SHAPE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_SHAPE_H

#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

using Quad = std::array<Eigen::Vector3d, 4>;

inline Quad quad_of(const Polygons& mesh, int f)
{
  return {mesh.corner_point(f, 0), mesh.corner_point(f, 1), mesh.corner_point(f, 2),
          mesh.corner_point(f, 3)};
}

// twice the vector area of a quad: the sum of the area vectors of its corners, halved
inline Eigen::Vector3d area_vector(const Quad& q)
{
  return (q[2] - q[0]).cross(q[3] - q[1]);
}

inline Eigen::Vector3d centre(const Quad& q)
{
  return (q[0] + q[1] + q[2] + q[3]) / 4;
}

// the least sine of the angles at the four corners, measured about the unit vector `normal`; 0 if a
// side has no length
inline double least_sine(const Quad& q, const Eigen::Vector3d& normal)
{
  std::array<Eigen::Vector3d, 4> side;
  for (int k = 0; k < 4; ++k)
    side[k] = (q[(k + 1) & 3] - q[k]).normalized();
  double least = 1;
  for (int k = 0; k < 4; ++k)
    least = (std::min)(least, side[(k + 3) & 3].cross(side[k]).dot(normal));
  return least;
}

// the scaled Jacobian: 1 for a rectangle, not positive for a quad that is not convex
inline double scaled_jacobian(const Quad& q)
{
  return least_sine(q, area_vector(q).normalized());
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_SHAPE_H
