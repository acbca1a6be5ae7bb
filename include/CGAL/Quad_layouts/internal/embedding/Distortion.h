// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_DISTORTION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_DISTORTION_H

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The distortion of a triangle under a map with the Jacobian J:
//   (|J|^2 + w (det J)^2 + w) / chi(det J),   chi(d) = (d + sqrt(d^2 + epsilon^2)) / 2.
// With epsilon = 0 it is finite for det J > 0 only, and least for rotations; the first part
// measures the loss of angles, the second that of area. With epsilon > 0 it is finite everywhere
// and pulls inverted triangles right (Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov
// 2021).
class Distortion
{
public:
  using Vector4 = Eigen::Vector4d;
  using Matrix4 = Eigen::Matrix4d;

  explicit Distortion(double area_weight, double epsilon = 0)
    : m_weight(area_weight), m_epsilon(epsilon)
  {
  }

  static double chi(double d, double epsilon)
  {
    const double root = std::hypot(d, epsilon);
    return d > 0 ? (d + root) / 2 : epsilon * epsilon / (2 * (root - d));
  }

  double value(const Eigen::Matrix2d& j) const
  {
    const double d = j.determinant();
    return (j.squaredNorm() + m_weight * (d * d + 1)) / chi(d, m_epsilon);
  }

  // computes gradient and Hessian by the entries of J in column order
  void derivatives(const Eigen::Matrix2d& j, Vector4& gradient, Matrix4& hessian) const
  {
    const double d = j.determinant(), s = j.squaredNorm() + m_weight * (d * d + 1);
    const double c = chi(d, m_epsilon), root = std::hypot(d, m_epsilon);
    const double c1 = root > 0 ? c / root : 1;
    const double c2 = root > 0 ? m_epsilon * m_epsilon / (2 * root * root * root) : 0;
    const double by_norm = 1 / c, by_both = -c1 / (c * c);
    const double by_det = 2 * m_weight * d / c + s * by_both;
    const double by_det2 = 2 * m_weight / c + 4 * m_weight * d * by_both +
                           s * (2 * c1 * c1 / c - c2) / (c * c);
    const Vector4 by_j(j(0, 0), j(1, 0), j(0, 1), j(1, 1)),
        cofactor(j(1, 1), -j(0, 1), -j(1, 0), j(0, 0));
    gradient = 2 * by_norm * by_j + by_det * cofactor;
    const Matrix4 mixed = by_j * cofactor.transpose();
    hessian = 2 * by_both * (mixed + mixed.transpose()) + by_det2 * cofactor * cofactor.transpose();
    hessian.diagonal().array() += 2 * by_norm;
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

private:
  double m_weight, m_epsilon;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_DISTORTION_H
