// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUAD_SMOOTHER_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUAD_SMOOTHER_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_shape.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Star.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Surface_walk.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Moves the vertices of a quad mesh on a surface so that its quads get closer to rectangles.
//
// All passes are sweeps of Gauss-Seidel kind over the vertices in fixed order, so the result does
// not depend on anything but the input. A vertex moves only if no quad becomes bad or worse by it,
// so quads that are not inverted stay so. Only untangling ignores this rule, and is undone unless
// it pays.
class Quad_smoother
{
public:
  using Vector = Eigen::Vector3d;

  // takes a mesh of quads; vertices on its border do not move
  Quad_smoother(Polygons& mesh, const Surface_walk& walk)
    : m_mesh(mesh), m_walk(walk), m_corners(mesh.number_of_vertices()),
      m_normals(mesh.number_of_vertices()), m_last_move(mesh.number_of_vertices(), 0)
  {
    std::vector<char> fixed(mesh.number_of_vertices(), 0);
    for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
      m_corners[mesh.source[h]].push_back(h);
      if (mesh.is_border(h))
        fixed[mesh.source[h]] = fixed[mesh.target(h)] = 1;
    }
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      if (!fixed[v] && !m_corners[v].empty())
        m_movable.push_back(v);
    place_vertices();
  }

  // Relaxation carries vertices far, with cheap steps; shape optimization needs to do the rest
  // only.
  void run(int number_of_iterations, const Monitor& monitor)
  {
    const int n = number_of_iterations;
    untangle();
    for (int i = 0; i < 2 * n; ++i) {
      monitor.report("smooth_quad_mesh", double(i) / (4 * n));
      sweep_unsettled([this](int v) { relax(v); });
    }
    for (int i = 0; i < n; ++i) {
      monitor.report("smooth_quad_mesh", 0.5 + double(i) / (2 * n));
      sweep_unsettled([this](int v) { improve_shape(v); });
    }
    untangle();
    polish_worst();
  }

private:
  void place_vertices()
  {
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v) {
      Vector normal = Vector::Zero();
      double length = 0;
      for (const int h : m_corners[v]) {
        normal += area_vector(quad_of(m_mesh, m_mesh.face[h]));
        length += (m_mesh.points[m_mesh.target(h)] - m_mesh.points[v]).norm();
      }
      const double tolerance = 0.25 * length / (std::max)(double(m_corners[v].size()), 1.);
      m_places.push_back(m_walk.locate(m_mesh.points[v], normal, tolerance));
      m_normals[v] = m_walk.normal(m_places[v]);
    }
    for (const int v : m_movable)
      m_mesh.points[v] = m_places[v].point;
  }

  void move(int v, const Surface_walk::Place& place)
  {
    m_places[v] = place;
    m_mesh.points[v] = place.point;
    m_normals[v] = m_walk.normal(place);
  }

  template <class Step>
  void sweep(const std::vector<int>& vertices, const Step& step)
  {
    for (const int v : vertices) {
      gather_star(v);
      step(v);
    }
  }

  // sweeps forwards or backwards in turn over the vertices around which something has moved lately
  template <class Step>
  void sweep_unsettled(const Step& step)
  {
    ++m_round;
    for (std::size_t i = 0; i < m_movable.size(); ++i) {
      const int v = m_round % 2 == 1 ? m_movable[i] : m_movable[m_movable.size() - 1 - i];
      if (is_settled(v))
        continue;
      gather_star(v);
      const Vector before = m_star.position();
      step(v);
      const double settled = 1e-6 * m_star.squared_edge_length();
      if ((m_mesh.points[v] - before).squaredNorm() > settled)
        m_last_move[v] = m_round;
    }
  }

  bool is_settled(int v) const
  {
    const int recent = m_round - 2;
    if (m_last_move[v] >= recent)
      return false;
    return std::none_of(m_corners[v].begin(), m_corners[v].end(), [&](int h) {
      const int g = m_mesh.next(h);
      return m_last_move[m_mesh.source[g]] >= recent || m_last_move[m_mesh.target(g)] >= recent;
    });
  }

  Quad_on_surface quad_from(int h) const
  {
    Quad_on_surface result;
    for (int k = 0; k < 4; ++k, h = m_mesh.next(h)) {
      result.quad[k] = m_mesh.points[m_mesh.source[h]];
      result.normals[k] = m_normals[m_mesh.source[h]];
    }
    return result;
  }

  void gather_star(int v)
  {
    m_star.clear();
    for (const int h : m_corners[v])
      m_star.add(quad_from(h));
    m_star.weigh_edges();
  }

  // moves v by `step`, or less, to where its quads and `accepts` say yes
  template <class Accepts>
  void try_move(int v, const Vector& step, const Accepts& accepts)
  {
    for (const double fraction : {1., 0.5, 0.25, 0.0625}) {
      const auto place = m_walk.slide(m_places[v], m_star.position() + fraction * step);
      if (m_star.permits(place.point) && accepts(place.point))
        return move(v, place);
    }
  }

  void relax(int v)
  {
    try_move(v, m_star.barycentre() - m_star.position(), [](const Vector&) { return true; });
  }

  // makes a Newton step on the energy of the star
  void improve_shape(int v, double spring_weight = 1)
  {
    const double l2 = m_star.squared_edge_length();
    if (!(l2 > 0))
      return;
    const double spring = spring_weight / l2, before = m_star.energy(m_star.position(), spring);
    try_move(v, newton_step(m_normals[v], spring, std::sqrt(l2)),
             [&](const Vector& y) { return m_star.energy(y, spring) < before; });
  }

  // the step in the plane with the given normal to the minimum of a quadratic model of the energy,
  // found from six samples. Negative curvatures are made positive, so that it leads downhill.
  Vector newton_step(const Vector& normal, double spring, double edge_length) const
  {
    const Vector t1 = normal.unitOrthogonal(), t2 = normal.cross(t1);
    const double h = 1e-3 * edge_length, longest = 0.5 * edge_length;
    const auto at = [&](double a, double b) {
      return m_star.energy(m_star.position() + a * t1 + b * t2, spring);
    };
    const double e00 = at(0, 0), e10 = at(h, 0), em0 = at(-h, 0), e01 = at(0, h), e0m = at(0, -h),
                 e11 = at(h, h);
    const Eigen::Vector2d gradient((e10 - em0) / (2 * h), (e01 - e0m) / (2 * h));
    const double mixed = (e11 - e10 - e01 + e00) / (h * h);
    Eigen::Matrix2d hessian;
    hessian << (e10 - 2 * e00 + em0) / (h * h), mixed, mixed, (e01 - 2 * e00 + e0m) / (h * h);
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
    eigen.computeDirect(hessian);
    const double least = (std::max)(1e-3 * eigen.eigenvalues().cwiseAbs().maxCoeff(), 1e-300);
    const Eigen::Vector2d curvature = eigen.eigenvalues().cwiseAbs().cwiseMax(least);
    Eigen::Vector2d d = -(eigen.eigenvectors() *
                          (eigen.eigenvectors().transpose() * gradient).cwiseQuotient(curvature));
    if (d.norm() > longest)
      d *= longest / d.norm();
    return d.x() * t1 + d.y() * t2;
  }

  // the quads that are inverted or oppose the surface
  std::vector<int> bad_quads() const
  {
    std::vector<int> result;
    for (int f = 0; f < m_mesh.number_of_faces(); ++f) {
      const Quad quad = quad_of(m_mesh, f);
      const int nearest = m_walk.nearest_face(centre(quad));
      if (!(scaled_jacobian(quad) > 0) ||
          area_vector(quad).dot(m_walk.surface().area_vector(nearest)) < 0)
        result.push_back(f);
    }
    return result;
  }

  // the movable vertices up to `rings` quads away from the given ones, ascending
  std::vector<int> surroundings(const std::vector<int>& quads, int rings) const
  {
    std::vector<char> inside(m_mesh.number_of_vertices(), 0);
    const auto add = [&](int f, std::vector<int>& added) {
      for (int k = 0; k < 4; ++k)
        if (!inside[m_mesh.corner(f, k)]) {
          inside[m_mesh.corner(f, k)] = 1;
          added.push_back(m_mesh.corner(f, k));
        }
    };
    std::vector<int> front, next;
    for (const int f : quads)
      add(f, front);
    for (; rings > 0; --rings, front.swap(next)) {
      next.clear();
      for (const int v : front)
        for (const int h : m_corners[v])
          add(m_mesh.face[h], next);
    }
    std::vector<int> result;
    std::copy_if(m_movable.begin(), m_movable.end(), std::back_inserter(result),
                 [&](int v) { return inside[v]; });
    return result;
  }

  // Relaxes larger and larger surroundings of bad quads with nothing to hinder it, which unfolds
  // them where the surface is nearly flat, and improves the shape there.
  void untangle()
  {
    std::vector<int> bad = bad_quads();
    for (int rings = 1; rings <= 16 && !bad.empty(); rings *= 2) {
      const std::vector<int> region = surroundings(bad, rings);
      std::vector<Surface_walk::Place> old;
      for (const int v : region)
        old.push_back(m_places[v]);
      for (int i = 0; i < 10 * rings; ++i)
        sweep(region, [this](int v) { move(v, m_walk.slide(m_places[v], m_star.barycentre())); });
      for (int i = 0; i < 10; ++i)
        sweep(region, [this](int v) { improve_shape(v); });
      std::vector<int> remaining = bad_quads();
      if (remaining.size() < bad.size())
        bad.swap(remaining);
      else
        for (std::size_t i = 0; i < region.size(); ++i)
          move(region[i], old[i]);
    }
  }

  // optimizes angles near the worst quads again, with hardly any regard to lengths
  void polish_worst()
  {
    constexpr double poor = 0.6, weak_spring = 0.05;
    for (int rings = 1; rings <= 3; ++rings) {
      std::vector<int> quads;
      for (int f = 0; f < m_mesh.number_of_faces(); ++f)
        if (scaled_jacobian(quad_of(m_mesh, f)) < poor)
          quads.push_back(f);
      const std::vector<int> region = surroundings(quads, rings);
      for (int i = 0; i < 20; ++i)
        sweep(region, [this](int v) { improve_shape(v, weak_spring); });
    }
  }

  Polygons& m_mesh;
  const Surface_walk& m_walk;
  std::vector<std::vector<int>> m_corners; // per vertex the halfedges from it
  std::vector<int> m_movable;
  std::vector<Surface_walk::Place> m_places;
  std::vector<Vector> m_normals; // of the surface at the places
  std::vector<int> m_last_move;  // per vertex the round of its last move of some size
  int m_round = 0;
  Star m_star; // of the vertex that is being moved
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUAD_SMOOTHER_H
