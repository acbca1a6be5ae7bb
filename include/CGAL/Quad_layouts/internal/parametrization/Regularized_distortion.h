// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_REGULARIZED_DISTORTION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_REGULARIZED_DISTORTION_H

#include <CGAL/Quad_layouts/internal/embedding/Distortion.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// `Distortion` with its denominator d = det J replaced by
//   chi = (d + sqrt(d^2 + epsilon^2)) / 2,
// which is positive for inverted triangles, too, and d for positive ones if epsilon is 0 (Garanzha
// et al. 2021).
class Regularized_distortion
{
public:
  using Vector4 = Eigen::Vector4d;
  using Matrix4 = Eigen::Matrix4d;

  explicit Regularized_distortion(double epsilon, double area_weight = Distortion::area_weight)
    : m_epsilon(epsilon), m_area_weight(area_weight)
  {
  }

  double value(const Eigen::Matrix2d& j) const { return value(j.squaredNorm(), j.determinant()); }
  // the same for the squared norm of J and its determinant
  double value(double squared_norm, double d) const
  {
    if (m_epsilon == 0 && d <= 0)
      return (std::numeric_limits<double>::infinity)();
    return numerator(squared_norm, d) / chi(d);
  }

  // computes gradient and Hessian by the entries of J in column order, where the value is finite
  void derivatives(const Eigen::Matrix2d& j, Vector4& gradient, Matrix4& hessian) const
  {
    const double d = j.determinant(), root = std::hypot(d, m_epsilon), c = chi(d);
    const double c1 = c / root, c2 = m_epsilon * m_epsilon / (2 * root * root * root);
    const double n = numerator(j.squaredNorm(), d), a = m_area_weight;
    const double by_det = (2 * a * d - n * c1 / c) / c;
    const double by_det_twice = (2 * a - 4 * a * d * c1 / c + n * (2 * c1 * c1 / c - c2) / c) / c;
    const double mixed = -c1 / (c * c);
    const Vector4 twice_j(2 * j(0, 0), 2 * j(1, 0), 2 * j(0, 1), 2 * j(1, 1)),
        cofactor(j(1, 1), -j(0, 1), -j(1, 0), j(0, 0));
    gradient = twice_j / c + by_det * cofactor;
    hessian = by_det_twice * cofactor * cofactor.transpose() +
              mixed * (twice_j * cofactor.transpose() + cofactor * twice_j.transpose());
    hessian.diagonal().array() += 2 / c;
    hessian(0, 3) += by_det;
    hessian(3, 0) += by_det;
    hessian(1, 2) -= by_det;
    hessian(2, 1) -= by_det;
  }

private:
  double numerator(double squared_norm, double d) const
  {
    return squared_norm + m_area_weight * (d * d + 1);
  }

  // in a form that does not cancel for negative d
  double chi(double d) const
  {
    const double root = std::hypot(d, m_epsilon);
    return d > 0 ? (d + root) / 2 : m_epsilon * m_epsilon / (2 * (root - d));
  }

  double m_epsilon, m_area_weight;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_REGULARIZED_DISTORTION_H
