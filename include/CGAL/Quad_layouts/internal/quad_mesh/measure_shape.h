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

// The angles at the four corners of a quad, as sine[k] = determinant[k] / sqrt(squared_sides[k]) of
// the corner k, measured about a unit vector.
struct Corner_angles
{
  Eigen::Array4d determinant;
  Eigen::Array4d squared_sides; // the product of the squared lengths of both sides
};

inline Corner_angles corner_angles(const Quad& q, const Eigen::Vector3d& axis)
{
  std::array<Eigen::Vector3d, 4> side;
  for (int k = 0; k < 4; ++k)
    side[k] = q[(k + 1) & 3] - q[k];
  Corner_angles result;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector3d& before = side[(k + 3) & 3];
    result.determinant[k] = before.cross(side[k]).dot(axis);
    result.squared_sides[k] = before.squaredNorm() * side[k].squaredNorm();
  }
  return result;
}

// the least sine of the angles at the four corners, measured about the unit vector `normal`; 0 if a
// side has no length
inline double least_sine(const Quad& q, const Eigen::Vector3d& normal)
{
  const Corner_angles angles = corner_angles(q, normal);
  const double least = (angles.squared_sides > 0)
                           .select(angles.determinant / angles.squared_sides.sqrt(), 0)
                           .minCoeff();
  return (std::min)(least, 1.); // rounding may exceed it
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
