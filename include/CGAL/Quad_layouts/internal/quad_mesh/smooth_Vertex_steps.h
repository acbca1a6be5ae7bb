// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_VERTEX_STEPS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_VERTEX_STEPS_H

#include <CGAL/Quad_layouts/internal/parametrization/Regularized_distortion.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Quads_on_surface.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Star.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Moves single vertices of a quad mesh to places where the quads around them are closer to
// rectangles. Unless it is to unfold quads, a vertex moves only if none becomes bad or worse by it,
// so those that are not inverted stay so.
class Vertex_steps
{
public:
  using Vector = Eigen::Vector3d;

  explicit Vertex_steps(Quads_on_surface& quads) : m_quads(quads) {}

  // moves v towards the weighted mean of its neighbours
  void relax(int v)
  {
    m_quads.gather_star(v, m_star);
    m_star.assess();
    try_move(v, centre_of_neighbours(v) - m_star.position(),
             [this](const Vector& x) { return m_star.permits(x); });
  }

  // makes a Newton step on the energy of the star
  void improve_shape(int v, double stiffness = 1)
  {
    m_quads.gather_star(v, m_star);
    const double l2 = m_star.squared_edge_length();
    if (!(l2 > 0))
      return;
    m_star.assess();
    const auto energy = [&](const Vector& x) { return m_star.energy(x, stiffness, l2); };
    const double before = energy(m_star.position());
    try_move(v, newton_step(v, energy, std::sqrt(l2)),
             [&](const Vector& x) { return m_star.permits(x) && energy(x) < before; });
  }

  // makes a Newton step on the distortion of the quads around v, by which some may turn over
  void unfold(int v, const Regularized_distortion& measure, double unit)
  {
    m_quads.gather_star(v, m_star);
    const double l2 = m_star.squared_edge_length();
    if (!(l2 > 0))
      return;
    const auto energy = [&](const Vector& x) { return m_star.distortion(x, measure, unit); };
    const double before = energy(m_star.position());
    Vector gradient;
    Eigen::Matrix3d hessian;
    m_star.derive_distortion(measure, unit, gradient, hessian);
    try_move(v, newton_step(v, gradient, hessian, std::sqrt(l2)),
             [&](const Vector& x) { return energy(x) < before; });
  }

private:
  using Plane = Eigen::Matrix<double, 3, 2>;

  // the weighted mean of the neighbours, on a curve the mean of those on the curve
  Vector centre_of_neighbours(int v) const
  {
    return m_quads.is_on_curve(v) ? m_quads.middle_on_curve(v) : m_star.barycentre();
  }

  // moves v by `step`, or less, to where its curve and `accepts` say yes
  template <class Accepts>
  void try_move(int v, const Vector& step, const Accepts& accepts)
  {
    for (const double fraction : {1., 0.5, 0.25, 0.0625}) {
      const auto place = m_quads.reached(v, m_star.position() + fraction * step);
      if (accepts(place.point) && m_quads.is_permitted(v, place))
        return m_quads.move(v, place);
    }
  }

  // the step of v in the surface, or along its curve, to the minimum of a quadratic model
  Vector newton_step(int v, const Vector& gradient, const Eigen::Matrix3d& hessian,
                     double edge_length) const
  {
    const Surface_walk::Place& place = m_quads.place(v);
    if (place.fixed_halfedge >= 0) {
      const Vector t = m_quads.walk().tangent(place);
      return step_downhill(gradient.dot(t), t.dot(hessian * t), edge_length) * t;
    }
    const Plane plane = tangent_plane(v);
    return plane * step_downhill(Eigen::Vector2d(plane.transpose() * gradient),
                                 Eigen::Matrix2d(plane.transpose() * hessian * plane), edge_length);
  }

  // the same for an energy, of which samples make the model: so close that no edge, unless it is
  // tiny, changes much from one to the other
  template <class Energy>
  Vector newton_step(int v, const Energy& energy, double edge_length) const
  {
    const double shortest = std::sqrt(m_star.least_squared_edge_length()),
                 h = 1e-3 * (std::max)(shortest, 1e-4 * edge_length);
    const Surface_walk::Place& place = m_quads.place(v);
    if (place.fixed_halfedge >= 0) {
      const Vector t = m_quads.walk().tangent(place);
      const auto at = [&](double a) { return energy(m_star.position() + a * t); };
      const double e0 = at(0), after = at(h), before = at(-h);
      return step_downhill((after - before) / (2 * h), (after - 2 * e0 + before) / (h * h),
                           edge_length) *
             t;
    }
    const Plane plane = tangent_plane(v);
    const auto at = [&](double a, double b) {
      return energy(m_star.position() + plane * Eigen::Vector2d(a, b));
    };
    const double e00 = at(0, 0), e10 = at(h, 0), em0 = at(-h, 0), e01 = at(0, h), e0m = at(0, -h),
                 e11 = at(h, h);
    const Eigen::Vector2d gradient((e10 - em0) / (2 * h), (e01 - e0m) / (2 * h));
    const double mixed = (e11 - e10 - e01 + e00) / (h * h);
    Eigen::Matrix2d hessian;
    hessian << (e10 - 2 * e00 + em0) / (h * h), mixed, mixed, (e01 - 2 * e00 + e0m) / (h * h);
    return plane * step_downhill(gradient, hessian, edge_length);
  }

  // two orthonormal vectors as columns
  Plane tangent_plane(int v) const
  {
    Plane result;
    result.col(0) = m_quads.normal(v).unitOrthogonal();
    result.col(1) = m_quads.normal(v).cross(result.col(0));
    return result;
  }

  // The step to the minimum of a quadratic model, at most half an edge. Negative curvatures are
  // made positive, so that it leads downhill.
  static Eigen::Vector2d step_downhill(const Eigen::Vector2d& gradient,
                                       const Eigen::Matrix2d& hessian, double edge_length)
  {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
    eigen.computeDirect(hessian);
    const double least = (std::max)(1e-3 * eigen.eigenvalues().cwiseAbs().maxCoeff(), 1e-300);
    const Eigen::Vector2d curvature = eigen.eigenvalues().cwiseAbs().cwiseMax(least);
    const Eigen::Vector2d step = -(
        eigen.eigenvectors() *
        (eigen.eigenvectors().transpose() * gradient).cwiseQuotient(curvature));
    const double longest = 0.5 * edge_length;
    return step.norm() > longest ? Eigen::Vector2d(step * (longest / step.norm())) : step;
  }
  static double step_downhill(double slope, double curvature, double edge_length)
  {
    const double step = curvature != 0 ? -slope / std::abs(curvature) : 0;
    return std::clamp(step, -0.5 * edge_length, 0.5 * edge_length);
  }

  Quads_on_surface& m_quads;
  Star m_star; // of the vertex that is being moved
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_VERTEX_STEPS_H
