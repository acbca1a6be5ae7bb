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
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Quad_untangler.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Quads_on_surface.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Vertex_steps.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_follow_curves.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Moves the vertices of a quad mesh on a surface so that its quads get closer to rectangles.
//
// All passes are sweeps of Gauss-Seidel kind over the vertices in fixed order, so the result does
// not depend on anything but the input.
class Quad_smoother
{
public:
  using Vector = Eigen::Vector3d;

  // takes a mesh of quads
  Quad_smoother(Polygons& mesh, const Surface_walk& walk)
    : m_quads(mesh, walk), m_steps(m_quads), m_last_move(mesh.number_of_vertices(), 0)
  {
  }

  // Relaxation carries vertices far, with cheap steps; shape optimization needs to do the rest
  // only. Ends early if there is no more time.
  void run(int number_of_iterations, const Monitor& monitor)
  {
    const int n = number_of_iterations;
    follow_curves(m_quads);
    const std::vector<Surface_walk::Place> first = m_quads.places(m_quads.movable());
    Quad_untangler untangler(m_quads, monitor);
    untangler.unfold();
    for (int i = 0; i < 2 * n && monitor.has_time("smooth_quad_mesh"); ++i) {
      monitor.tell("smooth_quad_mesh", double(i) / (4 * n));
      sweep_unsettled(m_quads.movable(), [this](int v) { m_steps.relax(v); });
    }
    for (int i = 0; i < n && monitor.has_time("smooth_quad_mesh"); ++i) {
      monitor.tell("smooth_quad_mesh", 0.5 + double(i) / (2 * n));
      sweep_unsettled(m_quads.movable(), [this](int v) { m_steps.improve_shape(v); });
    }
    polish_worst(monitor);
    untangler.repair();
    untangler.repair_from(first);
  }

  // the quads that are inverted or oppose the surface, ascending
  std::vector<int> bad_quads() const { return m_quads.bad_quads(); }

private:
  // sweeps forwards or backwards in turn over those of some vertices around which something has
  // moved lately
  template <class Step>
  void sweep_unsettled(const std::vector<int>& vertices, const Step& step)
  {
    ++m_round;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const int v = m_round % 2 == 1 ? vertices[i] : vertices[vertices.size() - 1 - i];
      if (is_settled(v))
        continue;
      const Vector before = m_quads.mesh().points[v];
      step(v);
      const double settled = 1e-3 * m_quads.edge_length(v);
      if ((m_quads.mesh().points[v] - before).norm() > settled)
        m_last_move[v] = m_round;
    }
  }

  bool is_settled(int v) const
  {
    const Polygons& mesh = m_quads.mesh();
    const int recent = m_round - 2;
    const auto has_moved = [&](int u) { return m_last_move[u] >= recent; };
    const std::vector<int>& corners = m_quads.corners(v);
    return !has_moved(v) && std::none_of(corners.begin(), corners.end(), [&](int h) {
      const int g = mesh.next(h);
      return has_moved(mesh.source[g]) || has_moved(mesh.target(g));
    });
  }

  // optimizes angles near the worst quads again, with hardly any regard to lengths
  void polish_worst(const Monitor& monitor)
  {
    constexpr double poor = 0.6, weak_spring = 0.05;
    for (int rings = 1; rings <= 3; ++rings) {
      std::vector<int> quads;
      for (int f = 0; f < m_quads.mesh().number_of_faces(); ++f)
        if (scaled_jacobian(m_quads.quad(f)) < poor)
          quads.push_back(f);
      const std::vector<int> region = m_quads.surroundings(quads, rings);
      for (const int v : region)
        m_last_move[v] = m_round;
      for (int i = 0; i < 20 && monitor.has_time("smooth_quad_mesh"); ++i)
        sweep_unsettled(region, [&](int v) { m_steps.improve_shape(v, weak_spring); });
    }
  }

  Quads_on_surface m_quads;
  Vertex_steps m_steps;
  std::vector<int> m_last_move; // per vertex the round of its last move of some size
  int m_round = 0;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUAD_SMOOTHER_H
