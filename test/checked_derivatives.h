// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_TEST_CHECKED_DERIVATIVES_H
#define QUAD_LAYOUTS_TEST_CHECKED_DERIVATIVES_H

#include <boost/test/unit_test.hpp>

#include <Eigen/Core>

// compares gradient and Hessian of a measure of Jacobians with differences of its values and
// gradients, by the entries of the Jacobian in column order
template <class Measure>
void check_derivatives(const Measure& measure, const Eigen::Vector4d& entries)
{
  constexpr double step = 1e-5;
  const auto jacobian = [](const Eigen::Vector4d& v) -> Eigen::Matrix2d {
    return Eigen::Map<const Eigen::Matrix2d>(v.data());
  };
  Eigen::Vector4d gradient, gradient_up, gradient_down;
  Eigen::Matrix4d hessian, unused;
  measure.derivatives(jacobian(entries), gradient, hessian);
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector4d up = entries + step * Eigen::Vector4d::Unit(i),
                          down = entries - step * Eigen::Vector4d::Unit(i);
    measure.derivatives(jacobian(up), gradient_up, unused);
    measure.derivatives(jacobian(down), gradient_down, unused);
    const double slope = (measure.value(jacobian(up)) - measure.value(jacobian(down))) / (2 * step);
    BOOST_TEST(slope == gradient[i], boost::test_tools::tolerance(1e-6));
    BOOST_TEST(((gradient_up - gradient_down) / (2 * step) - hessian.col(i)).norm() <
               1e-6 * hessian.norm());
  }
}

#endif // QUAD_LAYOUTS_TEST_CHECKED_DERIVATIVES_H
