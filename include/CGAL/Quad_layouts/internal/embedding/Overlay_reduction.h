// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_OVERLAY_REDUCTION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_OVERLAY_REDUCTION_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/embedding/Embedded_layout.h>
#include <CGAL/Quad_layouts/internal/embedding/triangle_shape.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Removes from the overlay of a surface and curves the vertices that are needed for neither, by
// half-edge collapses.
//
// The mesh remains a refinement of the surface: vertices on edges of the surface move along these,
// vertices on curves along those, others stay in their face of the surface. As everywhere, no edge
// other than those of the curves joins two vertices of curves, unless it did so before. A vertex
// takes in others of its own group only.
class Overlay_reduction
{
public:
  // Vertices that are held stay. `group` is per vertex.
  Overlay_reduction(Curve_mesh& mesh, std::vector<char> is_held, const std::vector<int>& group)
    : m_mesh(mesh), m_is_held(std::move(is_held)), m_group(group), m_is_due(mesh.points.size(), 1),
      m_on_curve(mesh.points.size(), 0), m_degree(mesh.points.size(), 0)
  {
    if (m_mesh.infinite_vertex() >= 0)
      m_is_held[m_mesh.infinite_vertex()] = 1;
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h) {
      ++m_degree[m_mesh.source(h)];
      if (m_mesh.curve[h] >= 0)
        m_on_curve[m_mesh.source(h)] = 1;
    }
  }

  void operator()(const Monitor& monitor)
  {
    while (remove_some(monitor))
      ;
  }

private:
  bool remove_some(const Monitor& monitor)
  {
    bool any = false;
    for (int u = 0; u < int(m_is_held.size()); ++u) {
      if (u % 1024 == 0)
        monitor.check("embed");
      if (m_is_held[u] || m_mesh.is_removed(u) || !std::exchange(m_is_due[u], 0))
        continue;
      if (const int h = best_collapse(u); h >= 0) {
        collapse(h);
        any = true;
      }
    }
    return any;
  }

  // Others than the neighbours of the source keep their neighbours, and what hinders them, but for
  // the edges between these, which get more.
  void collapse(int h)
  {
    m_mesh.for_each_outgoing(m_mesh.source(h), [this](int g) { m_is_due[m_mesh.target(g)] = 1; });
    m_degree[m_mesh.target(h)] += m_degree[m_mesh.source(h)] - 4;
    --m_degree[m_mesh.source(Curve_mesh::prev(h))];
    --m_degree[m_mesh.source(Curve_mesh::prev(m_mesh.opposite(h)))];
    m_mesh.collapse(h);
  }

  // the halfedge along which u should go, -1 if it has to stay
  int best_collapse(int u)
  {
    m_lines.clear();
    m_normal.setZero();
    m_mesh.for_each_outgoing(u, [&](int h) {
      if (is_line(h))
        m_lines.push_back(h);
      if (m_mesh.is_outer(h))
        return;
      const auto [a, b] = others(h);
      m_normal += triangle_normal(m_mesh.points[u], a, b);
    });
    if (m_lines.size() == 2 && is_same_line(m_lines[0], m_lines[1]))
      return better(m_lines[0], m_lines[1]);
    return m_lines.empty() ? best_of_all(u) : -1;
  }

  int better(int h, int g)
  {
    const double of_h = quality_without(h), of_g = quality_without(g);
    return (std::max)(of_h, of_g) == forbidden ? -1 : of_h >= of_g ? h : g;
  }

  int best_of_all(int u)
  {
    int best = -1;
    double quality = forbidden;
    m_mesh.for_each_outgoing(u, [&](int h) {
      if (const double q = quality_without(h); q > quality) {
        quality = q;
        best = h;
      }
    });
    return best;
  }

  bool is_line(int h) const { return m_mesh.is_original[h] || m_mesh.curve[h] >= 0; }
  bool is_same_line(int h, int g) const
  {
    return m_mesh.is_original[h] == m_mesh.is_original[g] &&
           (m_mesh.curve[h] >= 0) == (m_mesh.curve[g] >= 0);
  }

  static constexpr double forbidden = -(std::numeric_limits<double>::infinity)();
  static constexpr double degenerate = 1e-9;
  static constexpr int hub = 64; // a degree

  // The quality of the worst triangle that remains after the collapse of h; forbidden if one of
  // them would be inverted. Degenerate ones have no direction.
  double quality_without(int h)
  {
    if (leaves_group(h) || feeds_hub(h) || adds_chord(h) || !keeps_manifold(h))
      return forbidden;
    double worst = 1;
    const int u = m_mesh.source(h), v = m_mesh.target(h);
    m_mesh.for_each_outgoing(u, [&](int g) {
      const int end = Curve_mesh::prev(g);
      if (m_mesh.target(g) == v || m_mesh.source(end) == v || m_mesh.is_outer(g))
        return;
      const auto [a, b] = others(g);
      const Point n = triangle_normal(m_mesh.points[v], a, b);
      const double quality = triangle_quality(m_mesh.points[v], a, b);
      if (quality > degenerate && n.dot(m_normal) < 0.5 * n.norm() * m_normal.norm())
        worst = forbidden;
      worst = (std::min)(worst, quality);
    });
    return worst;
  }

  // the corners of the face of g that its source does not take
  std::pair<const Point&, const Point&> others(int g) const
  {
    return {m_mesh.points[m_mesh.target(g)], m_mesh.points[m_mesh.source(Curve_mesh::prev(g))]};
  }

  bool leaves_group(int h) const { return m_group[m_mesh.source(h)] != m_group[m_mesh.target(h)]; }

  // Vertices of many edges would take a time that is quadratic in their number.
  bool feeds_hub(int h) const
  {
    const int gain = m_degree[m_mesh.source(h)] - 4;
    return gain > 0 && m_degree[m_mesh.target(h)] + gain > hub;
  }

  // the link condition; neighbours on the border have the vertex at infinity in common
  bool keeps_manifold(int h) const
  {
    const int u = m_mesh.source(h), v = m_mesh.target(h);
    int common = 0;
    m_mesh.for_each_outgoing(u, [&](int g) { common += is_edge(m_mesh.target(g), v); });
    const bool on_border = m_mesh.border_halfedge_from(u) >= 0 &&
                           m_mesh.border_halfedge_from(v) >= 0;
    return common + on_border == 2;
  }

  bool is_edge(int v, int w) const
  {
    return (m_degree[v] < m_degree[w] ? m_mesh.halfedge_between(v, w)
                                      : m_mesh.halfedge_between(w, v)) >= 0;
  }

  // whether a new edge would join two curves
  bool adds_chord(int h) const
  {
    if (m_mesh.curve[h] >= 0 || !m_on_curve[m_mesh.target(h)])
      return false;
    const int left = m_mesh.source(Curve_mesh::prev(h)),
              right = m_mesh.source(Curve_mesh::prev(m_mesh.opposite(h)));
    bool result = false;
    m_mesh.for_each_outgoing(m_mesh.source(h), [&](int g) {
      const int w = m_mesh.target(g);
      result |= m_on_curve[w] && g != h && w != left && w != right;
    });
    return result;
  }

  Curve_mesh& m_mesh;
  std::vector<char> m_is_held;     // per vertex
  const std::vector<int>& m_group; // per vertex
  std::vector<char> m_is_due;   // per vertex: whether its surroundings have changed since it stayed
  std::vector<char> m_on_curve; // per vertex
  std::vector<int> m_degree;    // per vertex, with the edge to infinity
  std::vector<int> m_lines;     // at the present vertex
  Point m_normal;               // of the present vertex
};

// Reduces the overlay of a surface, of which the first vertices are those of the surface. Besides
// these, only those in `held` are held.
inline void reduce_overlay(Curve_mesh& mesh, int number_of_originals, const std::vector<int>& held,
                           const std::vector<int>& group, const Monitor& monitor)
{
  std::vector<char> is_held(mesh.points.size(), 0);
  std::fill_n(is_held.begin(), number_of_originals, 1);
  for (const int v : held)
    is_held[v] = 1;
  Overlay_reduction(mesh, std::move(is_held), group)(monitor);
}

// Reduces the mesh on which a layout is drawn to what shows the surface and the layout, and removes
// what lies beyond the border.
inline void reduce(Embedded_layout& embedded, int number_of_originals, const Monitor& monitor)
{
  Curve_mesh& mesh = embedded.mesh;
  reduce_overlay(mesh, number_of_originals, embedded.vertices,
                 std::vector<int>(mesh.points.size(), 0), monitor);
  mesh.remove_outside();
  const std::vector<int> number = mesh.compact();
  for (int& v : embedded.vertices)
    v = number[v];
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_OVERLAY_REDUCTION_H
