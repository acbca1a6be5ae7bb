// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_ALIGNED_ENERGY_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_ALIGNED_ENERGY_H

#include <CGAL/Quad_layouts/internal/embedding/Distortion.h>
#include <CGAL/Quad_layouts/internal/embedding/Rest_shape.h>
#include <CGAL/Quad_layouts/internal/embedding/first_loss_of_area.h>
#include <CGAL/Quad_layouts/internal/parametrization/Cut_graph.h>
#include <CGAL/Quad_layouts/internal/parametrization/Regularized_distortion.h>
#include <CGAL/Quad_layouts/internal/parametrization/Seam_constraints.h>
#include <CGAL/Quad_layouts/internal/parametrization/Target_lengths.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The energy of a parametrization in the coordinates x of the wedges:
//
//     sum over triangles  area (|J - 1|^2 + w distortion(J)),
//
// J being the Jacobian in the coordinates of the chart, its rows multiplied by the target lengths
// along the axes. The first part is that of Bommes, Zimmer and Kobbelt (2009): the map follows the
// field, with these lengths. The second part keeps triangles from being inverted, or turns them
// back. For some triangles another J than 1 can be demanded, which then counts more than all else.
class Aligned_energy
{
public:
  Aligned_energy(const Triangle_surface& surface, const Cut_graph& cut,
                 const Seam_constraints& seams, const Target_lengths& lengths)
  {
    const double unit = lengths.uniform();
    for (int f = 0; f < surface.number_of_faces(); ++f) {
      Face face;
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 2; ++i)
          face.unknown[2 * k + i] = seams.unknown(3 * f + k, i);
      const Rest_shape rest(surface.point(surface.source(3 * f)) / unit,
                            surface.point(surface.source(3 * f + 1)) / unit,
                            surface.point(surface.source(3 * f + 2)) / unit);
      const Eigen::Matrix2d to_chart = Eigen::Rotation2Dd(-cut.x_angle(f)).toRotationMatrix();
      const Eigen::Matrix2d b = rest.inverse * to_chart.transpose();
      face.weight = {Point2(-b.colwise().sum().transpose()), Point2(b.row(0).transpose()),
                     Point2(b.row(1).transpose())};
      face.area = rest.area;
      face.length = lengths.along_axes(f, cut.x_axis(f));
      m_faces.push_back(face);
    }
  }

  // the weight of the distortion, and how it is regularized
  void set_barrier(double weight, double epsilon)
  {
    m_barrier = weight;
    m_epsilon = epsilon;
  }

  // demands a shape of face f, given by its corners in a map with the target lengths
  void demand(int f, const std::array<Point2, 3>& corners)
  {
    constexpr double emphasis = 100;
    Face& face = m_faces[f];
    face.target = unsized_jacobian(face, corners);
    face.emphasis = emphasis;
  }

  // takes back all demands
  void release()
  {
    for (Face& face : m_faces) {
      face.target = Eigen::Matrix2d::Identity();
      face.emphasis = 1;
    }
  }

  double value(const Eigen::VectorXd& x) const
  {
    const Regularized_distortion distortion(m_epsilon);
    double sum = 0;
    for (const Face& face : m_faces) {
      const Eigen::Matrix2d j = jacobian(face, x);
      sum += face.area * face.emphasis * (j - face.target).squaredNorm();
      if (m_barrier > 0)
        sum += face.area * m_barrier * distortion.value(j);
    }
    return sum;
  }

  // computes the gradient, and a Hessian without negative curvature
  void derivatives(const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                   Eigen::SparseMatrix<double>& hessian) const
  {
    gradient = Eigen::VectorXd::Zero(x.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(36 * m_faces.size());
    for (const Face& face : m_faces) {
      Eigen::Vector4d by_j;
      Eigen::Matrix4d by_j_twice;
      derivatives_by_jacobian(face, jacobian(face, x), by_j, by_j_twice);
      Eigen::Matrix<double, 4, 6> corners = Eigen::Matrix<double, 4, 6>::Zero();
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 2; ++i)
          for (int c = 0; c < 2; ++c)
            corners(2 * c + i, 2 * k + i) = face.length[i] * face.weight[k][c];
      const Eigen::Matrix<double, 6, 1> g = face.area * corners.transpose() * by_j;
      const Eigen::Matrix<double, 6, 6> h = face.area * corners.transpose() * by_j_twice * corners;
      for (int a = 0; a < 6; ++a) {
        gradient[face.unknown[a]] += g[a];
        for (int b = 0; b < 6; ++b)
          entries.emplace_back(face.unknown[a], face.unknown[b], h(a, b));
      }
    }
    hessian.resize(x.size(), x.size());
    hessian.setFromTriplets(entries.begin(), entries.end());
  }

  double least_determinant(const Eigen::VectorXd& x) const
  {
    double result = (std::numeric_limits<double>::infinity)();
    for (const Face& face : m_faces)
      result = (std::min)(result, jacobian(face, x).determinant());
    return result;
  }

  // how far one can go before the first triangle loses its area
  double longest_step(const Eigen::VectorXd& x, const Eigen::VectorXd& move) const
  {
    double result = (std::numeric_limits<double>::infinity)();
    for (const Face& face : m_faces)
      result = (std::min)(result, first_loss_of_area(corners(face, x), corners(face, move)));
    return result;
  }

private:
  struct Face
  {
    std::array<int, 6> unknown;   // the coordinates of the corners
    Point2 length;                // the target lengths along the axes of the chart
    std::array<Point2, 3> weight; // the row vectors whose products with the corners sum to J if
                                  // these lengths are 1
    double area;                  // in squared target edge lengths
    Eigen::Matrix2d target = Eigen::Matrix2d::Identity(); // that J is to be near to
    double emphasis = 1;                                  // of that
  };

  static std::array<Point2, 3> corners(const Face& face, const Eigen::VectorXd& x)
  {
    std::array<Point2, 3> result;
    for (int k = 0; k < 3; ++k)
      result[k] = Point2(x[face.unknown[2 * k]], x[face.unknown[2 * k + 1]]);
    return result;
  }

  static Eigen::Matrix2d jacobian(const Face& face, const Eigen::VectorXd& x)
  {
    return face.length.asDiagonal() * unsized_jacobian(face, corners(face, x));
  }

  static Eigen::Matrix2d unsized_jacobian(const Face& face, const std::array<Point2, 3>& p)
  {
    Eigen::Matrix2d result = Eigen::Matrix2d::Zero();
    for (int k = 0; k < 3; ++k)
      result += p[k] * face.weight[k].transpose();
    return result;
  }

  void derivatives_by_jacobian(const Face& face, const Eigen::Matrix2d& j,
                               Eigen::Vector4d& gradient, Eigen::Matrix4d& hessian) const
  {
    gradient.setZero();
    hessian.setZero();
    if (m_barrier > 0) {
      Regularized_distortion(m_epsilon).derivatives(j, gradient, hessian);
      gradient *= m_barrier;
      hessian *= m_barrier;
      Distortion::make_positive(hessian);
    }
    const Eigen::Matrix2d difference = 2 * face.emphasis * (j - face.target);
    gradient += Eigen::Map<const Eigen::Vector4d>(difference.data()); // in column order
    hessian.diagonal().array() += 2 * face.emphasis;
  }

  std::vector<Face> m_faces;
  double m_barrier = 0, m_epsilon = 0;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_ALIGNED_ENERGY_H
