// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_REST_SHAPE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_REST_SHAPE_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The shape of a triangle on the surface, as needed to measure how a map distorts it.
//
// Narrow triangles, and those without area, are measured as if they were wider: `aspect` is the
// least ratio of their two stretches against an equilateral triangle.
struct Rest_shape
{
  static constexpr double least_aspect = 1e-3;
  static constexpr double least_weight = 1e-6; // against the area

  Eigen::Matrix2d
      inverse; // of the matrix of its edges from corner 0, in a frame with x along its first edge
  double area; // as it is measured

  // The area that the triangle has on the surface, but not nothing. A needle that is measured as if
  // it were wide must not count as if it were large: then it would take the room of the others.
  double weight;

  Rest_shape(const Point& p, const Point& q, const Point& r, double aspect = least_aspect)
  {
    const Point a = q - p, b = r - p;
    const double length = a.norm();
    Eigen::Matrix2d edges;
    if (length > 0)
      edges << length, a.dot(b) / length, 0, a.cross(b).norm() / length;
    else
      edges << 0, 0, 0, b.norm();
    const double area_on_surface = edges.determinant() / 2;
    widen(edges, aspect);
    inverse = edges.inverse();
    area = edges.determinant() / 2;
    weight = (std::max)(area_on_surface, least_weight * area);
  }

  Eigen::Matrix2d jacobian(const std::array<Point2, 3>& corners) const
  {
    Eigen::Matrix2d image;
    image << corners[1] - corners[0], corners[2] - corners[0];
    return image * inverse;
  }

private:
  static void widen(Eigen::Matrix2d& edges, double aspect)
  {
    constexpr double least_stretch = 1e-6; // where all corners are at the same place
    Eigen::Matrix2d equilateral;
    equilateral << 1, 0.5, 0, std::sqrt(0.75);
    const Eigen::Matrix2d stretch = edges * equilateral.inverse();
    const double size = (std::max)(stretch.squaredNorm(), least_stretch * least_stretch);
    if (stretch.determinant() >= aspect * size) // then its singular values differ less than that
      return;
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(stretch, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector2d values = svd.singularValues();
    values[0] = (std::max)(values[0], least_stretch);
    values[1] = (std::max)(values[1], aspect * values[0]);
    edges = svd.matrixU() * values.asDiagonal() * svd.matrixV().transpose() * equilateral;
    if (edges.determinant() < 0) // possible for triangles without area only
      edges.row(1) *= -1;
  }
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_REST_SHAPE_H
