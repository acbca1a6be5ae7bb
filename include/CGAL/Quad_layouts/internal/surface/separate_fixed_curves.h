// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SEPARATE_FIXED_CURVES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SEPARATE_FIXED_CURVES_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Splits faces such that none has several fixed edges, to which no field could be aligned, and that
// there are free vertices between any two fixed edges: where a coarse mesh has no other place for
// singularities, they would be on the fixed curves.
//
// - Edges that join two vertices of fixed curves, but are not fixed, are split at their midpoints.
// - Faces with three fixed edges are split at their centroids.
//
// Vertices and faces keep their numbers, and faces the source of their first halfedge; new ones follow.
class Fixed_curve_separation
{
public:
  explicit Fixed_curve_separation(const Triangle_surface& surface)
    : m_surface(surface), m_points(surface.points()), m_midpoint(surface.number_of_edges(), -1),
      m_triangles(surface.number_of_faces())
  {
    for (int f = 0; f < surface.number_of_faces(); ++f)
      m_origins.push_back(f);
    split_edges();
    for (int f = 0; f < surface.number_of_faces(); ++f)
      split(f);
  }

  Triangle_surface operator()() &&
  {
    if (m_points.size() == m_surface.points().size())
      return m_surface;
    Triangle_surface result(std::move(m_points), m_triangles, std::move(m_origins));
    for (int h = 0; h < result.number_of_halfedges(); ++h)
      if (is_fixed(result.origin(Triangle_surface::face(h)), result.source(h), result.target(h)))
        result.fix(h);
    return result;
  }

private:
  using Triangle = std::array<int, 3>;

  void split_edges()
  {
    std::vector<char> is_on_curve(m_surface.number_of_vertices(), 0);
    for (int h = 0; h < m_surface.number_of_halfedges(); ++h)
      if (m_surface.is_fixed(h))
        is_on_curve[m_surface.source(h)] = is_on_curve[m_surface.target(h)] = 1;
    for (int e = 0; e < m_surface.number_of_edges(); ++e) {
      const int h = m_surface.halfedge_of_edge(e), u = m_surface.source(h), v = m_surface.target(h);
      if (!m_surface.is_fixed(h) && is_on_curve[u] && is_on_curve[v])
        m_midpoint[e] = add((m_points[u] + m_points[v]) / 2);
    }
  }

  int add(const Point& p)
  {
    m_points.push_back(p);
    return int(m_points.size()) - 1;
  }

  void split(int f)
  {
    std::vector<Triangle> parts{{m_surface.source(3 * f), m_surface.source(3 * f + 1),
                                 m_surface.source(3 * f + 2)}};
    std::array<int, 3> sides{3 * f, 3 * f + 1, 3 * f + 2};
    std::stable_sort(sides.begin(), sides.end(), [this](int g, int h) {
      return m_surface.length(g) > m_surface.length(h);
    });
    for (const int h : sides)
      if (const int m = m_midpoint[m_surface.edge(h)]; m >= 0)
        bisect(m_surface.source(h), m_surface.target(h), m, parts);
    if (std::all_of(sides.begin(), sides.end(), [this](int h) { return m_surface.is_fixed(h); }))
      split_at_centroid(parts);
    m_triangles[f] = parts.front();
    m_triangles.insert(m_triangles.end(), parts.begin() + 1, parts.end());
    m_origins.insert(m_origins.end(), parts.size() - 1, f);
  }

  // splits the one of some triangles that has an edge from u to v, which has the midpoint m
  static void bisect(int u, int v, int m, std::vector<Triangle>& triangles)
  {
    for (Triangle& t : triangles)
      for (int i = 0; i < 3; ++i)
        if (t[i] == u && t[(i + 1) % 3] == v) {
          const int moved = i == 0 ? 1 : 2, other = i == moved ? (i + 1) % 3 : i;
          Triangle rest = t;
          t[moved] = rest[other] = m;
          triangles.push_back(rest);
          return;
        }
  }

  void split_at_centroid(std::vector<Triangle>& triangles)
  {
    const auto [a, b, c] = triangles.front();
    const int center = add((m_points[a] + m_points[b] + m_points[c]) / 3);
    triangles = {{a, b, center}, {b, c, center}, {c, a, center}};
  }

  // says if face f of the given surface has a fixed edge from u to v
  bool is_fixed(int f, int u, int v) const
  {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      if (m_surface.source(h) == u && m_surface.target(h) == v)
        return m_surface.is_fixed(h);
    return false;
  }

  const Triangle_surface& m_surface;
  std::vector<Point> m_points;
  std::vector<int> m_midpoint; // per edge, -1 for those that are not split
  std::vector<Triangle> m_triangles;
  std::vector<int> m_origins;
};

// returns the surface with faces split as `Fixed_curve_separation` does
inline Triangle_surface separate_fixed_curves(const Triangle_surface& surface)
{
  return Fixed_curve_separation(surface)();
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SEPARATE_FIXED_CURVES_H
