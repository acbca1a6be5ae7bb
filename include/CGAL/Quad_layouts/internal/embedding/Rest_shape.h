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

  Eigen::Matrix2d
      inverse; // of the matrix of its edges from corner 0, in a frame with x along its first edge
  double area;

  Rest_shape(const Point& p, const Point& q, const Point& r, double aspect = least_aspect)
  {
    const Point a = q - p, b = r - p;
    const double length = a.norm();
    Eigen::Matrix2d edges;
    if (length > 0)
      edges << length, a.dot(b) / length, 0, a.cross(b).norm() / length;
    else
      edges << 0, 0, 0, b.norm();
    widen(edges, aspect);
    inverse = edges.inverse();
    area = edges.determinant() / 2;
  }

  // multiplies the area
  void scale(double factor)
  {
    inverse /= std::sqrt(factor);
    area *= factor;
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

// How much more alike triangles are than they are on the surface, when a map is measured: then none
// dominates the others.
struct Likeness
{
  double evenness = 0; // of areas: with 1 they are all the same
  double aspect = Rest_shape::least_aspect;
};

// Makes the areas differ less. `shape` tells the `Rest_shape` of an element.
template <class Triangles, class Shape>
void even_out(Triangles& triangles, double evenness, const Shape& shape)
{
  if (evenness == 0)
    return;
  double mean = 0;
  for (auto& t : triangles)
    mean += shape(t).area / double(triangles.size());
  for (auto& t : triangles)
    shape(t).scale(std::pow(mean / shape(t).area, evenness));
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_REST_SHAPE_H
