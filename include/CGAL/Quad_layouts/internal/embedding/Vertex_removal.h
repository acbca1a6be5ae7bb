// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_VERTEX_REMOVAL_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_VERTEX_REMOVAL_H

#include <CGAL/Quad_layouts/internal/embedding/refine_around_cones.h>
#include <CGAL/Quad_layouts/internal/embedding/solve_map.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A removed vertex and the faces that it had.
struct Removal
{
  int vertex, into;
  std::vector<int> faces;
  std::vector<Map::Face> before; // the faces' corners and charts
};

// Simplifies the triangles of a map by half-edge collapses, and takes the collapses back.
//
// Cones and the two rings around them stay: with the outer ring gone, a vertex could touch so much
// of the inner one that no valid map exists. Charts are carried along exactly, so that the
// coordinates of any vertex that is present keep their meaning on every level.
class Vertex_removal
{
public:
  Vertex_removal(Map& map, const std::vector<Cone>& cones)
    : m_map(map), m_star(stars(map)), m_kind(map.points.size(), FREE),
      m_is_present(map.faces.size(), 1), m_number_of_faces(int(map.faces.size())),
      m_is_queued(map.points.size(), 0)
  {
    for (const Cone& c : cones)
      for (const int ring_vertex : neighbours(c.vertex))
        for (const int f : m_star[ring_vertex])
          for (const int v : map.faces[f].vertex)
            m_kind[v] = RING;
    for (const Cone& c : cones)
      m_kind[c.vertex] = CONE;
  }

  // removes vertices, along the shortest edges first, until `target` faces are left or none may go
  void simplify(int target)
  {
    bound_edges(target);
    for (std::size_t v = 0; v < m_star.size(); ++v)
      enqueue(int(v));
    while (m_number_of_faces > target && !m_queue.empty()) {
      const auto [cost, u, v] = m_queue.top();
      m_queue.pop();
      m_is_queued[u] = 0;
      if (m_star[u].empty())
        continue;
      if (cost_of_collapse(u, v) == cost)
        collapse(u, v);
      else
        enqueue(u);
    }
    m_queue = {};
  }

  // the present faces with all vertices, absent ones being isolated
  Map coarse_map() const
  {
    Map result = m_map;
    result.faces.clear();
    for (std::size_t f = 0; f < m_map.faces.size(); ++f)
      if (m_is_present[f])
        result.faces.push_back(m_map.faces[f]);
    return result;
  }

  bool is_complete() const { return m_removals.empty(); }
  int number_of_removals() const { return int(m_removals.size()); }

  // brings back the vertex that was removed last and returns it; its coordinates are not set
  int restore()
  {
    const Removal removal = std::move(m_removals.back());
    m_removals.pop_back();
    for (std::size_t i = 0; i < removal.faces.size(); ++i) {
      const int f = removal.faces[i];
      if (m_is_present[f])
        remove(m_star[removal.into], f);
      else {
        for (const int v : removal.before[i].vertex)
          if (v != removal.vertex)
            m_star[v].push_back(f);
        m_is_present[f] = 1;
        ++m_number_of_faces;
      }
      m_map.faces[f] = removal.before[i];
    }
    m_star[removal.vertex] = removal.faces;
    return removal.vertex;
  }

  const std::vector<int>& star(int v) const { return m_star[v]; }
  bool is_cone(int v) const { return m_kind[v] == CONE; }

private:
  enum Kind : char { FREE, RING, CONE };
  using Entry = std::tuple<double, int, int>;

  static void remove(std::vector<int>& list, int x)
  {
    list.erase(std::find(list.begin(), list.end(), x));
  }

  static constexpr double forbidden = std::numeric_limits<double>::infinity();

  // edges may become about twice as long as those of an even mesh with `target` triangles
  void bound_edges(int target)
  {
    double area = 0;
    for (const Map::Face& f : m_map.faces)
      area += rest_shape(m_map, f).area;
    m_longest = 2 * std::sqrt(4 / std::sqrt(3.) * area / target);
  }

  void enqueue(int u)
  {
    if (m_is_queued[u] || m_kind[u] != FREE || m_star[u].empty())
      return;
    Entry best(forbidden, u, -1);
    for (const int f : m_star[u]) {
      const int v = m_map.faces[f].vertex[(m_map.faces[f].corner_of(u) + 1) % 3];
      best = (std::min)(best, Entry(cost_of_collapse(u, v), u, v));
    }
    if (std::get<0>(best) == forbidden)
      return;
    m_queue.push(best);
    m_is_queued[u] = 1;
  }

  std::vector<int> neighbours(int u) const
  {
    std::vector<int> result;
    for (const int f : m_star[u])
      result.push_back(m_map.faces[f].vertex[(m_map.faces[f].corner_of(u) + 1) % 3]);
    return result;
  }

  double cost_of_collapse(int u, int v) const
  {
    if (m_kind[v] == CONE || !keeps_manifold(u, v))
      return forbidden;
    const double change = change_of_shape(u, v);
    return change == forbidden ? forbidden
                               : (m_map.points[u] - m_map.points[v]).norm() * (1 + change);
  }

  // checks the link condition, the valences, and that rings get no chords and are not joined
  bool keeps_manifold(int u, int v) const
  {
    const std::vector<int> of_u = neighbours(u), of_v = neighbours(v);
    if (std::find(of_u.begin(), of_u.end(), v) == of_u.end())
      return false;
    int common = 0;
    for (const int w : of_u) {
      const bool is_common = std::find(of_v.begin(), of_v.end(), w) != of_v.end();
      common += is_common;
      if (is_common && m_star[w].size() < 5)
        return false;
      if (!is_common && w != v && m_kind[v] == RING && m_kind[w] == RING)
        return false;
    }
    const std::size_t valence = of_u.size() + of_v.size() - 4;
    return common == 2 && valence >= 4 && valence <= (std::max<std::size_t>)(11, of_v.size());
  }

  // how far the normals of the faces turn (0 to 1/2); forbidden if too far or the shapes suffer too
  // much
  double change_of_shape(int u, int v) const
  {
    double worst_before = 1, worst_after = 1, change = 0;
    for (const int f : m_star[u]) {
      const Map::Face& face = m_map.faces[f];
      const int k = face.corner_of(u);
      const Point &a = m_map.points[face.vertex[(k + 1) % 3]],
                  &b = m_map.points[face.vertex[(k + 2) % 3]];
      const Point before = normal(m_map.points[u], a, b);
      worst_before = (std::min)(worst_before, quality(m_map.points[u], a, b));
      if (face.has(v))
        continue;
      const Point after = normal(m_map.points[v], a, b);
      const double cosine = before.dot(after) / (before.norm() * after.norm());
      if (!(cosine > 0.5) || (m_map.points[v] - a).norm() > m_longest)
        return forbidden;
      change = (std::max)(change, 1 - cosine);
      worst_after = (std::min)(worst_after, quality(m_map.points[v], a, b));
    }
    return worst_after < (std::min)(0.3, 0.9 * worst_before) ? forbidden : change;
  }

  static Point normal(const Point& p, const Point& q, const Point& r)
  {
    return (q - p).cross(r - p);
  }

  // 1 for an equilateral triangle, 0 for one without area
  static double quality(const Point& p, const Point& q, const Point& r)
  {
    return 2 * std::sqrt(3.) * normal(p, q, r).norm() /
           ((q - p).squaredNorm() + (r - q).squaredNorm() + (p - r).squaredNorm());
  }

  void collapse(int u, int v)
  {
    const int shared = *std::find_if(m_star[u].begin(), m_star[u].end(),
                                     [&](int f) { return m_map.faces[f].has(v); });
    const Map::Face& s = m_map.faces[shared];
    const Chart_change into = s.chart[s.corner_of(u)].inverse().after(s.chart[s.corner_of(v)]);
    const std::vector<int> around = neighbours(u);
    Removal removal{u, v, std::exchange(m_star[u], {}), {}};
    for (const int f : removal.faces) {
      Map::Face& face = m_map.faces[f];
      removal.before.push_back(face);
      if (face.has(v)) {
        for (const int w : face.vertex)
          if (w != u)
            remove(m_star[w], f);
        m_is_present[f] = 0;
        --m_number_of_faces;
      } else {
        const int k = face.corner_of(u);
        face.vertex[k] = v;
        face.chart[k] = face.chart[k].after(into);
        m_star[v].push_back(f);
      }
    }
    m_removals.push_back(std::move(removal));
    for (const int w : around)
      enqueue(w);
  }

  Map& m_map;
  std::vector<std::vector<int>> m_star; // per vertex its faces, in no order
  std::vector<Kind> m_kind;             // per vertex
  std::vector<char> m_is_present;       // per face
  int m_number_of_faces;
  double m_longest = 0;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
  std::vector<char> m_is_queued; // per vertex
  std::vector<Removal> m_removals;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_VERTEX_REMOVAL_H
