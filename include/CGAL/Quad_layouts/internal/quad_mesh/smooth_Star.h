// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_STAR_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_STAR_H

#include <CGAL/Quad_layouts/internal/parametrization/Regularized_distortion.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_shape.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A quad and the unit normals of the surface at its corners.
struct Quad_on_surface
{
  Quad quad;
  std::array<Eigen::Vector3d, 4> normals;
};

// the scaled Jacobian, or the least cosine of the angles between the quad and the surface at the
// corners if that is less
inline double quality(const Quad& quad, const std::array<Eigen::Vector3d, 4>& normals)
{
  const Eigen::Vector3d own = area_vector(quad).normalized();
  double result = least_sine(quad, own);
  for (const Eigen::Vector3d& n : normals)
    result = (std::min)(result, own.dot(n));
  return result;
}

inline Eigen::Vector3d mean_normal(const Quad_on_surface& q)
{
  const auto& n = q.normals;
  return (n[0] + n[1] + n[2] + n[3]).normalized();
}

// the determinant, about a unit vector, and the squared norm of the two sides at corner k
inline double determinant(const Quad& q, int k, const Eigen::Vector3d& axis)
{
  return (q[(k + 1) & 3] - q[k]).cross(q[(k + 3) & 3] - q[k]).dot(axis);
}
inline double squared_norm(const Quad& q, int k)
{
  return (q[(k + 1) & 3] - q[k]).squaredNorm() + (q[(k + 3) & 3] - q[k]).squaredNorm();
}

// the least determinant of the corners, which is an area
inline double least_determinant(const Quad_on_surface& q)
{
  return corner_angles(q.quad, mean_normal(q)).determinant.minCoeff();
}

// A decreasing, smooth function of a sine or cosine, given as d / sqrt(n): about n / d^2 for positive
// values, finite but large for negative ones. By this regularization Garanzha et al. 2021
// ("Foldover-free maps in 50 lines of code") untangle meshes.
inline double penalty_of_sine(double d, double n = 1)
{
  constexpr double epsilon = 0.1;
  const double twice_positive = d + std::sqrt(d * d + epsilon * epsilon * n);
  return 4 * n / (twice_positive * twice_positive);
}

// the sum of the penalties of the sines of a quad's angles, measured about a unit vector
inline double angle_energy(const Quad& q, const Eigen::Vector3d& axis)
{
  const Corner_angles angles = corner_angles(q, axis);
  double energy = 0;
  for (int k = 0; k < 4; ++k)
    energy += angles.squared_sides[k] > 0
                  ? penalty_of_sine(angles.determinant[k], angles.squared_sides[k])
                  : penalty_of_sine(0);
  return energy;
}

// An energy of a quad that is least if it is a rectangle of any aspect whose normal is that of the
// surface.
inline double shape_energy(const Quad& q, const Eigen::Vector3d& surface_normal)
{
  const Eigen::Vector3d own = area_vector(q).normalized();
  const double cosine = own.dot(surface_normal);
  return penalty_of_sine(cosine) + angle_energy(q, cosine > 0 ? own : surface_normal);
}

// what this energy is at least, whatever the normal of the surface
inline double least_shape_energy(const Quad& q)
{
  return (std::min)(penalty_of_sine(1) + angle_energy(q, area_vector(q).normalized()),
                    penalty_of_sine(0) + 4 * penalty_of_sine(1));
}

// The energy of an edge, by its squared length in a unit in which that is 1 on average. It resists
// short edges, too: quads, whose energy does not depend on their aspect, would lose all width where
// that is good for angles.
inline double spring_energy(double squared_length, double stiffness)
{
  constexpr double resistance = 0.005, least = 1e-8; // so that it is finite
  return stiffness * squared_length + resistance / (squared_length + least);
}

// The quads around a vertex as functions of its position x: all that smoothing one vertex looks at.
// The normals of the surface are taken where the corners have been.
class Star
{
public:
  using Vector = Eigen::Vector3d;

  // begins an empty star
  void clear()
  {
    m_sectors.clear();
    m_edges.clear();
  }

  // adds a quad whose corner 0 is the vertex; its side from corner 0 to corner 1 is an edge of the
  // star
  void add(const Quad_on_surface& q) { m_sectors.push_back({q, internal::mean_normal(q), 1., 1.}); }

  // adds an edge that is the first side of no quad, because it is on the border
  void add_edge(const Vector& end, const Vector& normal) { m_edges.push_back({end, normal, 1.}); }

  const Vector& position() const { return m_sectors.front().quad[0]; }

  // the mean of the squared lengths of the edges
  double squared_edge_length() const
  {
    double sum = 0;
    for (const Sector& s : m_sectors)
      sum += (s.quad[1] - s.quad[0]).squaredNorm();
    for (const Edge& e : m_edges)
      sum += (e.end - position()).squaredNorm();
    return sum / number_of_edges();
  }

  double least_squared_edge_length() const
  {
    double result = (std::numeric_limits<double>::infinity)();
    for (const Sector& s : m_sectors)
      result = (std::min)(result, (s.quad[1] - s.quad[0]).squaredNorm());
    for (const Edge& e : m_edges)
      result = (std::min)(result, (e.end - position()).squaredNorm());
    return result;
  }

  // Gives each edge a weight, 1 on average, that grows with its length and with the turn of the
  // normal along it, as if it were measured in the six-dimensional space of points and normals. So
  // vertices gather where the surface bends.
  void weigh_edges()
  {
    constexpr double bending = 20;
    const double bend = bending * squared_edge_length();
    double sum = 0;
    for (Sector& s : m_sectors) {
      s.weight = std::sqrt((s.quad[1] - s.quad[0]).squaredNorm() +
                           bend * (s.normals[1] - s.normals[0]).squaredNorm());
      sum += s.weight;
    }
    for (Edge& e : m_edges) {
      e.weight = std::sqrt((e.end - position()).squaredNorm() +
                           bend * (e.normal - m_sectors.front().normals[0]).squaredNorm());
      sum += e.weight;
    }
    if (!(sum > 0))
      return;
    for (Sector& s : m_sectors)
      s.weight *= number_of_edges() / sum;
    for (Edge& e : m_edges)
      e.weight *= number_of_edges() / sum;
  }

  // the weighted mean of the neighbours
  Vector barycentre() const
  {
    Vector sum = Vector::Zero();
    for (const Sector& s : m_sectors)
      sum += s.weight * s.quad[1];
    for (const Edge& e : m_edges)
      sum += e.weight * e.end;
    return sum / number_of_edges();
  }

  // notes how good the quads are, for `permits()`
  void assess()
  {
    m_least_quality = 1;
    for (Sector& s : m_sectors) {
      s.quality = quality(s.quad, s.normals);
      m_least_quality = (std::min)(m_least_quality, s.quality);
    }
  }

  // Says if each quad stays as good as it was, or at least sufficiently good, when the vertex moves
  // to x. Around a bad quad, good ones need not stay better than that, so that it does not hold all
  // the others where they are; but they must not be inverted.
  bool permits(const Vector& x) const
  {
    constexpr double sufficient = 0.5;
    return std::all_of(m_sectors.begin(), m_sectors.end(), [&](const Sector& s) {
      const double q = quality(s.moved_to(x), s.normals);
      return q >= sufficient || q >= s.quality || (q > 0 && q >= m_least_quality);
    });
  }

  // the sum of the energies of the quads, and of springs along the weighted edges, whose squared
  // lengths have a unit
  double energy(const Vector& x, double stiffness, double squared_unit) const
  {
    double sum = 0;
    for (const Sector& s : m_sectors)
      sum += shape_energy(s.moved_to(x), s.mean_normal) +
             spring_energy((s.quad[1] - x).squaredNorm() / squared_unit, stiffness * s.weight);
    for (const Edge& e : m_edges)
      sum += spring_energy((e.end - x).squaredNorm() / squared_unit, stiffness * e.weight);
    return sum;
  }

  // The sum of the distortions of the maps from squares with edges of length `unit` to those
  // corners of the quads that depend on x. It has no unit.
  double distortion(const Vector& x, const Regularized_distortion& measure, double unit) const
  {
    double sum = 0;
    for (const Sector& s : m_sectors) {
      const Quad q = s.moved_to(x);
      for (const int k : moving_corners)
        sum += measure.value(squared_norm(q, k) / (unit * unit),
                             determinant(q, k, s.mean_normal) / (unit * unit));
    }
    return sum;
  }

  // computes its gradient and Hessian at the present position
  void derive_distortion(const Regularized_distortion& measure, double unit, Vector& gradient,
                         Eigen::Matrix3d& hessian) const
  {
    gradient.setZero();
    hessian.setZero();
    const double area = unit * unit;
    for (const Sector& s : m_sectors) {
      const Quad& q = s.quad;
      const Vector& n = s.mean_normal;
      const std::array<Vector, 4> by_norm = {2 * (2 * q[0] - q[1] - q[3]) / area,
                                             2 * (q[0] - q[1]) / area, Vector::Zero(),
                                             2 * (q[0] - q[3]) / area};
      const std::array<Vector, 4> by_det = {n.cross(q[3] - q[1]) / area,
                                            n.cross(q[2] - q[1]) / area, Vector::Zero(),
                                            n.cross(q[3] - q[2]) / area};
      for (const int k : moving_corners) {
        const auto p = measure.partial_derivatives(squared_norm(q, k) / area,
                                                   determinant(q, k, n) / area);
        gradient += p.by_norm * by_norm[k] + p.by_det * by_det[k];
        const Eigen::Matrix3d mixed = by_norm[k] * by_det[k].transpose();
        hessian += p.by_norm_and_det * (mixed + mixed.transpose()) +
                   p.by_det_twice * by_det[k] * by_det[k].transpose();
        hessian.diagonal().array() += p.by_norm * (k == 0 ? 4 : 2) / area;
      }
    }
  }

private:
  struct Edge
  {
    Vector end, normal;
    double weight;
  };

  struct Sector : Quad_on_surface
  {
    Quad moved_to(const Vector& x) const { return {x, quad[1], quad[2], quad[3]}; }

    Vector mean_normal;
    double weight, quality;
  };

  static constexpr std::array<int, 3> moving_corners = {0, 1, 3}; // of quads, whose sides end at x

  double number_of_edges() const { return double(m_sectors.size() + m_edges.size()); }

  std::vector<Sector> m_sectors;
  std::vector<Edge> m_edges;
  double m_least_quality = 1; // of the quads
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_STAR_H
