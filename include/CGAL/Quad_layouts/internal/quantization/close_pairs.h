// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_CLOSE_PAIRS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_CLOSE_PAIRS_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/quantization/Runs.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Two singularities that may merge, and the shortest path of arcs between them, P_ij of [LCK21b],
// Section 4.2.
struct Close_pair
{
  int i, j; // nodes, i < j
  std::vector<int> path;
};

// Shortest paths of arcs from one or several nodes, up to a given length. The arrays are kept
// between searches.
class Arc_distances
{
public:
  explicit Arc_distances(const T_mesh& t_mesh)
    : m_t_mesh(t_mesh), m_distance(t_mesh.number_of_vertices(), infinity()),
      m_halfedge(t_mesh.number_of_vertices(), -1)
  {
  }

  void search(int source, double limit) { search(std::vector<int>(1, source), limit); }

  void search(const std::vector<int>& sources, double limit)
  {
    for (int n : m_reached) {
      m_distance[n] = infinity();
      m_halfedge[n] = -1;
    }
    m_reached.clear();
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto relax = [&](int n, double d, int h) {
      if (d > limit || d >= m_distance[n])
        return;
      if (m_distance[n] == infinity())
        m_reached.push_back(n);
      m_distance[n] = d;
      m_halfedge[n] = h;
      queue.emplace(d, n);
    };
    for (int n : sources)
      relax(n, 0, -1);
    while (!queue.empty()) {
      const Entry top = queue.top();
      queue.pop();
      if (top.first > m_distance[top.second])
        continue;
      const int first = m_t_mesh.halfedge_from(top.second);
      int h = first;
      if (h >= 0)
        do {
          relax(m_t_mesh.target(h), top.first + m_t_mesh.length(T_mesh::edge(h)), h);
          h = m_t_mesh.turn_right(h);
        } while (h != first);
    }
  }

  // the nodes within the limit, in no useful order
  const std::vector<int>& reached() const { return m_reached; }
  double distance(int n) const { return m_distance[n]; }

  std::vector<int> path_to(int n) const
  {
    std::vector<int> result;
    for (int h = m_halfedge[n]; h >= 0; h = m_halfedge[m_t_mesh.source(h)])
      result.push_back(T_mesh::edge(h));
    return result;
  }

private:
  static constexpr double infinity() { return (std::numeric_limits<double>::max)(); }

  const T_mesh& m_t_mesh;
  std::vector<double> m_distance;
  std::vector<int> m_halfedge, m_reached;
};

// returns the pairs of singularities that rows (2) do not separate: those whose runs meet within
// `reach` of both, and those joined by a path of at most this length
inline std::vector<Close_pair> close_pairs(const T_mesh& t_mesh, const Runs& runs, double reach,
                                           const Monitor& monitor)
{
  std::map<std::pair<int, int>, bool> is_close;
  for (const Run_meeting& m : runs.meetings()) {
    if (runs.length(m.visits[0]) > reach || runs.length(m.visits[1]) > reach)
      continue;
    const int i = runs[m.visits[0].run].start, j = runs[m.visits[1].run].start;
    is_close[std::minmax(i, j)] = true;
  }
  std::vector<Close_pair> result;
  Arc_distances distances(t_mesh);
  for (int i = 0; i < t_mesh.number_of_vertices(); ++i) {
    if (!t_mesh.is_singularity_or_seed(i))
      continue;
    monitor.check("quantize");
    // the legs of a crossing within reach are together at most twice as long
    distances.search(i, 2 * reach);
    std::vector<int> reached = distances.reached();
    std::sort(reached.begin(), reached.end());
    for (int j : reached)
      if (j > i && t_mesh.is_singularity_or_seed(j) &&
          (distances.distance(j) <= reach || is_close.count({i, j}) > 0))
        result.push_back({i, j, distances.path_to(j)});
  }
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_CLOSE_PAIRS_H
