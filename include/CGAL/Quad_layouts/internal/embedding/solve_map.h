// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SOLVE_MAP_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SOLVE_MAP_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/embedding/Newton.h>
#include <CGAL/Quad_layouts/internal/embedding/rosettes.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The energy of Bommes, Zimmer and Kobbelt (2009), |J - R|^2: it asks +x of each chart to point in
// its target direction, at length one. Being quadratic, one Newton step from anywhere minimizes it.
class Alignment_energy
{
public:
  explicit Alignment_energy(const Map& map)
  {
    for (const Map::Face& f : map.faces)
      m_target.push_back(Eigen::Rotation2Dd(-target_angle(map, f)).toRotationMatrix());
  }

  double value(std::size_t f, const Eigen::Matrix2d& j) const
  {
    return (j - m_target[f]).squaredNorm();
  }

  void derivatives(std::size_t f, const Eigen::Matrix2d& j, Eigen::Vector4d& gradient,
                   Eigen::Matrix4d& hessian) const
  {
    const Eigen::Matrix2d difference = 2 * (j - m_target[f]);
    gradient = Eigen::Map<const Eigen::Vector4d>(difference.data());
    hessian = 2 * Eigen::Matrix4d::Identity();
  }

private:
  std::vector<Eigen::Matrix2d> m_target;
};

// The distortion of all triangles alike. Without regularization it is a barrier: infinite for
// inverted triangles.
class Distortion_energy
{
public:
  explicit Distortion_energy(double epsilon = 0)
    : m_distortion(area_weight, epsilon), m_epsilon(epsilon)
  {
  }

  static constexpr double area_weight = 0.25;

  double value(std::size_t, const Eigen::Matrix2d& j) const
  {
    if (m_epsilon == 0 && j.determinant() <= 0)
      return (std::numeric_limits<double>::infinity)();
    return m_distortion.value(j);
  }

  void derivatives(std::size_t, const Eigen::Matrix2d& j, Eigen::Vector4d& gradient,
                   Eigen::Matrix4d& hessian) const
  {
    m_distortion.derivatives(j, gradient, hessian);
    Distortion::make_positive(hessian);
  }

private:
  Distortion m_distortion;
  double m_epsilon;
};

// Makes all triangles positive by minimizing the regularized distortion for falling epsilon
// (Garanzha et al. 2021). Several steps per epsilon are essential: with one, folded tubes lock.
// `haste`, between 0 and 1, is how much less of a chi the worst triangle is allowed from one
// epsilon to the next. Returns whether it succeeded; it gives up where the worst triangle stays as
// it is.
inline bool untangle(Newton& newton, double haste, const Monitor& monitor)
{
  constexpr int max_steps = 300, patience = 5;
  double epsilon = 1, best = newton.least_determinant();
  for (int steps = 0, stuck = 0; steps < max_steps && stuck < patience;) {
    const Distortion_energy energy(epsilon);
    double value = newton.value(energy), decrease = 1;
    for (int i = 0; i < 3 || (decrease > 1e-3 && i < 10); ++i, ++steps) {
      if (newton.least_determinant() > 0)
        return true;
      monitor.report("embed", double(steps) / max_steps);
      const double before = std::exchange(value, newton.step(energy, value));
      decrease = (before - value) / before;
    }
    const double least = newton.least_determinant();
    if (least > 0)
      return true;
    stuck = least > 0.99 * best ? 0 : stuck + 1;
    best = (std::max)(best, least);
    const double mu = (1 - (std::max)(decrease, haste)) * Distortion::chi(least, epsilon);
    if (least < mu)
      epsilon = 2 * std::sqrt(mu * (mu - least));
    else
      epsilon /= 2;
  }
  return newton.least_determinant() > 0;
}

// improves a map without inverted triangles, at most `max_steps` times
inline void relax(Newton& newton, int max_steps, const Monitor& monitor)
{
  const Distortion_energy energy;
  double value = newton.value(energy);
  for (int i = 0; i < max_steps; ++i) {
    monitor.check("embed");
    const double before = std::exchange(value, newton.step(energy, value));
    if (before - value < 1e-4 * before)
      return;
  }
}

// How to look for a valid map.
struct Solution_attempt
{
  int coarse_faces; // number of triangles of the mesh to solve on
  double haste;     // see `untangle`
  bool is_even;     // whether small triangles count as much as large ones: easier where the layout
                    // gives much space to what is small on the surface
};

// lists the faces at each vertex
inline std::vector<std::vector<int>> stars(const Map& map)
{
  std::vector<std::vector<int>> result(map.points.size());
  for (std::size_t f = 0; f < map.faces.size(); ++f)
    for (const int v : map.faces[f].vertex)
      result[v].push_back(int(f));
  return result;
}

// Finds coordinates for all vertices such that no triangle is inverted and the angle sum is right
// everywhere, starting from the target directions alone. Returns whether it succeeded.
inline bool solve_map(Map& map, const std::vector<Cone>& cones, const Solution_attempt& attempt,
                      const Monitor& monitor)
{
  const auto star = stars(map);
  std::vector<char> is_cone(map.points.size(), 0);
  for (std::size_t v = 0; v < star.size(); ++v)
    is_cone[v] = star[v].empty();
  for (const Cone& c : cones)
    is_cone[c.vertex] = 1;
  std::vector<char> is_fixed = is_cone;
  for (const Cone& c : cones) {
    place_ring(map, star[c.vertex], c, 0.25);
    for (const int f : star[c.vertex])
      for (const int v : map.faces[f].vertex)
        is_fixed[v] = 1;
  }
  Newton with_rings(map, is_fixed);
  if (attempt.is_even)
    with_rings.even_out();
  const Alignment_energy alignment(map);
  with_rings.step(alignment, with_rings.value(alignment));
  if (!untangle(with_rings, attempt.haste, monitor))
    return false;
  Newton free(map, is_cone);
  relax(free, 50, monitor);
  return true;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SOLVE_MAP_H
