// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_DISTORTION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_DISTORTION_H

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <limits>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The distortion of a triangle under a map with the Jacobian J:
//   (|J|^2 + w (det J)^2 + w) / det J.
// It is finite for det J > 0 only, and least for rotations; the first part measures the loss of
// angles, the others, of weight w, that of area (Garanzha, Kaporin, Kudryavtseva, Protais, Ray and
// Sokolov 2021).
struct Distortion
{
  using Vector4 = Eigen::Vector4d;
  using Matrix4 = Eigen::Matrix4d;

  static constexpr double area_weight = 0.25;

  static double value(const Eigen::Matrix2d& j)
  {
    const double d = j.determinant();
    return d > 0 ? (j.squaredNorm() + area_weight * (d * d + 1)) / d
                 : (std::numeric_limits<double>::infinity)();
  }

  // computes gradient and Hessian by the entries of J in column order
  static void derivatives(const Eigen::Matrix2d& j, Vector4& gradient, Matrix4& hessian)
  {
    const double d = j.determinant(), shape = (j.squaredNorm() + area_weight) / (d * d);
    const Vector4 by_j(j(0, 0), j(1, 0), j(0, 1), j(1, 1)),
        cofactor(j(1, 1), -j(0, 1), -j(1, 0), j(0, 0));
    const double by_det = area_weight - shape;
    gradient = 2 / d * by_j + by_det * cofactor;
    const Matrix4 mixed = by_j * cofactor.transpose();
    hessian = -2 / (d * d) * (mixed + mixed.transpose()) +
              2 * shape / d * cofactor * cofactor.transpose();
    hessian.diagonal().array() += 2 / d;
    hessian(0, 3) += by_det;
    hessian(3, 0) += by_det;
    hessian(1, 2) -= by_det;
    hessian(2, 1) -= by_det;
  }

  // removes negative curvature, so that Newton steps go downhill
  static void make_positive(Matrix4& hessian)
  {
    const Eigen::SelfAdjointEigenSolver<Matrix4> solver(hessian);
    if (solver.eigenvalues()[0] < 0)
      hessian = solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
                solver.eigenvectors().transpose();
  }
};

// The square of the distortion. In a sum over triangles that are weighted by area, narrow ones
// count so little that their distortion may grow beyond all bounds; not that of the square.
struct Squared_distortion
{
  static double value(const Eigen::Matrix2d& j) { return CGAL::square(Distortion::value(j)); }

  // computes gradient and Hessian by the entries of J in column order
  static void derivatives(const Eigen::Matrix2d& j, Distortion::Vector4& gradient,
                          Distortion::Matrix4& hessian)
  {
    const double value = Distortion::value(j);
    Distortion::derivatives(j, gradient, hessian);
    hessian = 2 * (value * hessian + gradient * gradient.transpose()).eval();
    gradient *= 2 * value;
  }
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_DISTORTION_H
