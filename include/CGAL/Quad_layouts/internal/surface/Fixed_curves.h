// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_FIXED_CURVES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_FIXED_CURVES_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The curves that the fixed edges of a surface form, from one vertex where none or several of them
// go on to the next; or closed. Places on them are measured by their distance from the beginning,
// along the curve.
class Fixed_curves
{
public:
  struct Position
  {
    int curve = -1;
    double distance = 0;
  };

  explicit Fixed_curves(const Triangle_surface& surface)
    : m_surface(surface), m_first_end(surface.number_of_edges(), -1),
      m_position(surface.number_of_edges())
  {
    for (int h = 0; h < surface.number_of_halfedges(); ++h)
      for (const int v : {surface.source(h), surface.target(h)})
        if (surface.is_fixed(h) && surface.other_fixed_halfedge(h, v) < 0)
          trace(h, v);
    for (int h = 0; h < surface.number_of_halfedges(); ++h)
      if (surface.is_fixed(h))
        trace(h, surface.source(h));
  }

  int number_of_curves() const { return int(m_curves.size()); }
  double length(int curve) const { return m_curves[curve].distances.back(); }
  bool is_closed(int curve) const { return m_curves[curve].is_closed; }
  int first_vertex(int curve) const { return m_curves[curve].vertices.front(); }
  int last_vertex(int curve) const { return m_curves[curve].vertices.back(); }

  // the position of a point on the edge of a fixed halfedge
  Position position(int h, const Point& p) const
  {
    const int e = m_surface.edge(h);
    const double along = (p - m_surface.point(m_first_end[e])).norm();
    return {m_position[e].curve, m_position[e].distance + along};
  }

  struct Location
  {
    Point point;
    int halfedge; // of its edge
  };

  // the point at a distance along a curve, which may be that from one of its ends; beyond the
  // length closed curves begin anew
  Location location(int curve, double distance) const
  {
    const Curve& c = m_curves[curve];
    if (is_closed(curve))
      distance -= length(curve) * std::floor(distance / length(curve));
    const auto after = std::upper_bound(c.distances.begin(), c.distances.end(), distance);
    const auto last = std::ptrdiff_t(c.halfedges.size()) - 1;
    const auto i = std::clamp<std::ptrdiff_t>(after - c.distances.begin() - 1, 0, last);
    const Point &p = m_surface.point(c.vertices[i]), &q = m_surface.point(c.vertices[i + 1]);
    const double edge = c.distances[i + 1] - c.distances[i];
    const double fraction = edge > 0 ? (std::min)((distance - c.distances[i]) / edge, 1.) : 0;
    return {fraction < 1 ? Point(p + fraction * (q - p)) : q, c.halfedges[i]};
  }

  // calls visit(vertex, distance) for the vertices of the surface inside a part of a curve; beyond
  // the length closed curves begin anew
  template <class Visit>
  void for_each_vertex_between(int curve, double begin, double end, const Visit& visit) const
  {
    const Curve& c = m_curves[curve];
    const int n = int(c.vertices.size()) - 1; // edges
    const auto first = std::upper_bound(c.distances.begin(), c.distances.end(), begin);
    int i = int(first - c.distances.begin());
    for (double turns = 0; i <= n || is_closed(curve); ++i) {
      if (i > n) {
        i = 1;
        turns += length(curve);
      }
      const double distance = c.distances[i] + turns;
      if (distance >= end)
        return;
      visit(c.vertices[i], distance);
    }
  }

private:
  struct Curve
  {
    std::vector<int> vertices, halfedges; // halfedge i is of the edge between vertices i and i + 1
    std::vector<double> distances;        // of the vertices
    bool is_closed;                       // else it may still end where it begins
  };

  // follows the curve that begins with the edge of h at vertex v, unless that has been done
  void trace(int h, int v)
  {
    if (m_first_end[m_surface.edge(h)] >= 0)
      return;
    Curve curve{{v}, {}, {0}, false};
    while (h >= 0 && m_first_end[m_surface.edge(h)] < 0) {
      m_first_end[m_surface.edge(h)] = v;
      m_position[m_surface.edge(h)] = {number_of_curves(), curve.distances.back()};
      curve.halfedges.push_back(h);
      curve.distances.push_back(curve.distances.back() + m_surface.length(h));
      v = m_surface.source(h) == v ? m_surface.target(h) : m_surface.source(h);
      curve.vertices.push_back(v);
      h = m_surface.other_fixed_halfedge(h, v);
    }
    curve.is_closed = h >= 0;
    m_curves.push_back(std::move(curve));
  }

  const Triangle_surface& m_surface;
  std::vector<int> m_first_end; // per edge, the end that comes first on its curve; -1: not fixed
  std::vector<Position> m_position; // per edge, that of this end
  std::vector<Curve> m_curves;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_FIXED_CURVES_H
