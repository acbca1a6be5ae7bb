// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_VERTEX_REMOVAL_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_VERTEX_REMOVAL_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/embedding/Map.h>
#include <CGAL/Quad_layouts/internal/embedding/triangle_shape.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
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
// The curves of the map stay: their vertices move along them only, their ends not at all, and no
// other edge ever joins two vertices of curves. No vertex is removed into a cone: around one of
// more than a full turn, its polygon could become so wide there that no place sees all of it.
// Charts are carried along exactly, so that the coordinates of any vertex that is present keep
// their meaning on every level.
class Vertex_removal
{
public:
  // `ends`: where curves end, cones among them
  Vertex_removal(Map& map, const std::vector<int>& ends, const std::vector<char>& is_cone)
    : m_map(map), m_is_cone(is_cone), m_star(stars(map)), m_kind(map.points.size(), FREE),
      m_on_border(map.points.size(), 0), m_is_present(map.faces.size(), 1),
      m_number_of_faces(int(map.faces.size())), m_is_queued(map.points.size(), 0),
      m_seen(map.points.size(), 0)
  {
    for (const Map::Face& f : map.faces)
      for (int k = 0; k < 3; ++k)
        if (f.curve[k] >= 0)
          m_kind[f.vertex[k]] = ON_CURVE;
    for (const Map::Face& f : map.faces)
      for (int k = 0; k < 3; ++k)
        if (f.side[k] == Map::BORDER)
          m_on_border[f.vertex[k]] = 1;
    for (const int v : ends)
      m_kind[v] = HELD;
  }

  // Removes vertices, along the shortest edges first, until `target` faces are left or none may go.
  // Where curves run closely together, triangles are too narrow for all care.
  void simplify(int target, const Monitor& monitor)
  {
    bound_edges(target);
    for (const Care care : {SHAPES, NORMALS, NONE}) {
      m_care = care;
      for (std::size_t v = 0; v < m_star.size(); ++v)
        enqueue(int(v));
      collapse_queued(target, monitor);
    }
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

  template <class Visit>
  void for_each_neighbour(int u, Visit&& visit) const
  {
    for (const int f : m_star[u]) {
      const Map::Face& face = m_map.faces[f];
      const int k = face.corner_of(u), before = (k + 2) % 3;
      visit(face.vertex[(k + 1) % 3]);
      if (face.side[before] == Map::BORDER)
        visit(face.vertex[before]);
    }
  }

private:
  // what a collapse must keep: the shapes and normals of triangles, or their normals only, or
  // neither
  enum Care : char { SHAPES, NORMALS, NONE };
  enum Kind : char { FREE, ON_CURVE, HELD };
  using Entry = std::tuple<double, int, int>;

  static void remove(std::vector<int>& list, int x)
  {
    list.erase(std::find(list.begin(), list.end(), x));
  }

  void collapse_queued(int target, const Monitor& monitor)
  {
    for (int i = 0; m_number_of_faces > target && !m_queue.empty(); ++i) {
      if (i % 4096 == 0)
        monitor.check("embed");
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
    std::fill(m_is_queued.begin(), m_is_queued.end(), 0);
  }

  static constexpr double forbidden = std::numeric_limits<double>::infinity();

  // edges may become about twice as long as those of an even mesh with `target` triangles
  void bound_edges(int target)
  {
    double area = 0;
    for (const Map::Face& f : m_map.faces)
      area += triangle_normal(m_map.points[f.vertex[0]], m_map.points[f.vertex[1]],
                              m_map.points[f.vertex[2]])
                  .norm() /
              2;
    m_longest = 2 * std::sqrt(4 / std::sqrt(3.) * area / target);
  }

  void enqueue(int u)
  {
    if (m_is_queued[u] || m_kind[u] == HELD || m_star[u].empty())
      return;
    Entry best(forbidden, u, -1);
    for_each_neighbour(
        u, [&](int v) { best = (std::min)(best, Entry(cost_of_collapse(u, v), u, v)); });
    if (std::get<0>(best) == forbidden)
      return;
    m_queue.push(best);
    m_is_queued[u] = 1;
  }

  double cost_of_collapse(int u, int v)
  {
    if (m_is_cone[v] || !keeps_curves(u, v) || !keeps_manifold(u, v))
      return forbidden;
    const double change = m_care == NONE ? 0 : change_of_shape(u, v);
    return change == forbidden ? forbidden
                               : (m_map.points[u] - m_map.points[v]).norm() * (1 + change);
  }

  bool keeps_curves(int u, int v) const { return m_kind[u] == FREE || is_curve(u, v); }

  // whether the edge from u to v is part of a curve
  bool is_curve(int u, int v) const
  {
    return std::any_of(m_star[u].begin(), m_star[u].end(), [&](int f) {
      const Map::Face& face = m_map.faces[f];
      const int k = face.corner_of(u), before = (k + 2) % 3;
      return (face.curve[k] >= 0 && face.vertex[(k + 1) % 3] == v) ||
             (face.curve[before] >= 0 && face.vertex[before] == v);
    });
  }

  bool is_border(int u, int v) const
  {
    return std::any_of(m_star[u].begin(), m_star[u].end(), [&](int f) {
      const Map::Face& face = m_map.faces[f];
      const int k = face.corner_of(u), before = (k + 2) % 3;
      return (face.side[k] == Map::BORDER && face.vertex[(k + 1) % 3] == v) ||
             (face.side[before] == Map::BORDER && face.vertex[before] == v);
    });
  }

  // checks the link condition, the valences, and that no new edge joins two curves
  bool keeps_manifold(int u, int v)
  {
    ++m_stamp;
    for_each_neighbour(v, [&](int w) { m_seen[w] = m_stamp; });
    int common = 0;
    bool result = m_seen[u] == m_stamp;
    for_each_neighbour(u, [&](int w) {
      const bool is_common = m_seen[w] == m_stamp;
      common += is_common;
      if (is_common && room_at(w) < 5)
        result = false;
      if (!is_common && w != v && m_kind[u] == FREE && m_kind[v] != FREE && m_kind[w] != FREE)
        result = false;
    });
    const int shared = is_border(u, v) ? 1 : 2;
    const std::size_t valence = m_star[u].size() + m_star[v].size() - 2 * shared;
    return result && common == shared && valence + (m_on_border[v] ? 2 : 0) >= 4 &&
           valence <= (std::max<std::size_t>)(11, m_star[v].size());
  }

  // the number of faces at v; on the border, where half of a turn is missing, two more
  std::size_t room_at(int v) const { return m_star[v].size() + (m_on_border[v] ? 2 : 0); }

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
      const Point before = triangle_normal(m_map.points[u], a, b);
      worst_before = (std::min)(worst_before, triangle_quality(m_map.points[u], a, b));
      if (face.has(v))
        continue;
      const Point after = triangle_normal(m_map.points[v], a, b);
      const double cosine = before.dot(after) / (before.norm() * after.norm());
      if (!(cosine > 0.5) || (m_map.points[v] - a).norm() > m_longest)
        return forbidden;
      change = (std::max)(change, 1 - cosine);
      worst_after = (std::min)(worst_after, triangle_quality(m_map.points[v], a, b));
    }
    return m_care == SHAPES && worst_after < (std::min)(0.3, 0.9 * worst_before) ? forbidden
                                                                                 : change;
  }

  void collapse(int u, int v)
  {
    const int shared = *std::find_if(m_star[u].begin(), m_star[u].end(),
                                     [&](int f) { return m_map.faces[f].has(v); });
    const Map::Face& s = m_map.faces[shared];
    const Chart_change into = s.chart[s.corner_of(u)].inverse().after(s.chart[s.corner_of(v)]);
    std::vector<int> around;
    for_each_neighbour(u, [&](int w) { around.push_back(w); });
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
    for (const Map::Face& face : removal.before)
      if (face.has(v))
        hand_over_curve(face, u, v);
    m_removals.push_back(std::move(removal));
    for (const int w : around)
      enqueue(w);
  }

  // The face behind a removed one takes the place of that one beside the curve, if there is one.
  void hand_over_curve(const Map::Face& removed, int u, int v)
  {
    const int side = (removed.corner_of(u) + 1) % 3;
    if (removed.curve[side] < 0)
      return;
    const int from = removed.vertex[side], to = removed.vertex[(side + 1) % 3];
    for (const int f : m_star[v])
      for (int k = 0; k < 3; ++k)
        if (m_map.faces[f].vertex[k] == from && m_map.faces[f].vertex[(k + 1) % 3] == to) {
          m_map.faces[f].curve[k] = removed.curve[side];
          m_map.faces[f].side[k] = removed.side[side];
        }
  }

  Map& m_map;
  const std::vector<char>& m_is_cone;   // per vertex
  std::vector<std::vector<int>> m_star; // per vertex its faces, in no order
  std::vector<Kind> m_kind;             // per vertex
  std::vector<char> m_on_border;        // per vertex
  std::vector<char> m_is_present;       // per face
  Care m_care = SHAPES;
  int m_number_of_faces;
  double m_longest = 0;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
  std::vector<char> m_is_queued; // per vertex
  std::vector<int> m_seen;       // per vertex, scratch of `keeps_manifold`
  int m_stamp = 0;
  std::vector<Removal> m_removals;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_VERTEX_REMOVAL_H
