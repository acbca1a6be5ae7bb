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

  // the derivatives of the value by the squared norm of J and by its determinant
  struct Partial_derivatives
  {
    double by_norm, by_det, by_norm_and_det, by_det_twice;
  };
  Partial_derivatives partial_derivatives(double squared_norm, double d) const
  {
    const double root = root_of(d), c = chi(d);
    const double c1 = c / root, c2 = m_epsilon * m_epsilon / (2 * root * root * root);
    const double n = numerator(squared_norm, d), a = m_area_weight;
    return {1 / c, (2 * a * d - n * c1 / c) / c, -c1 / (c * c),
            (2 * a - 4 * a * d * c1 / c + n * (2 * c1 * c1 / c - c2) / c) / c};
  }

  // computes gradient and Hessian by the entries of J in column order, where the value is finite
  void derivatives(const Eigen::Matrix2d& j, Vector4& gradient, Matrix4& hessian) const
  {
    const Partial_derivatives p = partial_derivatives(j.squaredNorm(), j.determinant());
    const Vector4 twice_j(2 * j(0, 0), 2 * j(1, 0), 2 * j(0, 1), 2 * j(1, 1)),
        cofactor(j(1, 1), -j(0, 1), -j(1, 0), j(0, 0));
    gradient = p.by_norm * twice_j + p.by_det * cofactor;
    hessian = p.by_det_twice * cofactor * cofactor.transpose() +
              p.by_norm_and_det * (twice_j * cofactor.transpose() + cofactor * twice_j.transpose());
    hessian.diagonal().array() += 2 * p.by_norm;
    hessian(0, 3) += p.by_det;
    hessian(3, 0) += p.by_det;
    hessian(1, 2) -= p.by_det;
    hessian(2, 1) -= p.by_det;
  }

private:
  double numerator(double squared_norm, double d) const
  {
    return squared_norm + m_area_weight * (d * d + 1);
  }

  double root_of(double d) const { return std::sqrt(d * d + m_epsilon * m_epsilon); }

  // in a form that does not cancel for negative d
  double chi(double d) const
  {
    const double root = root_of(d);
    return d > 0 ? (d + root) / 2 : m_epsilon * m_epsilon / (2 * (root - d));
  }

  double m_epsilon, m_area_weight;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_REGULARIZED_DISTORTION_H
