// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_SEARCH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_SEARCH_H

#include <CGAL/Quad_layouts/internal/tracing/Dual_graph.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The variables that a dual loop crosses, with repetitions.
using Loop = std::vector<int>;

// Finds cheapest dual loops by Dijkstra's algorithm on the states of a dual graph. The arrays are
// kept between searches.
class Loop_search
{
public:
  explicit Loop_search(const Dual_graph& graph)
    : m_graph(graph), m_distance(graph.number_of_states(), infinity()),
      m_parent(graph.number_of_states(), -1)
  {
  }

  // returns the cheapest loop through one of `variables`, where each passage of variable v costs
  // `price[v]`, which must not be negative. There is one: the graph has no dead ends.
  Loop cheapest_loop(const std::vector<int>& variables, const std::vector<double>& price)
  {
    Loop best;
    double limit = infinity();
    for (int v : variables) {
      // the reverse of a loop is a loop: one direction is enough
      const double length = search(2 * v, price, limit);
      if (length < limit) {
        limit = length;
        best = loop_to(2 * v);
      }
    }
    return best;
  }

private:
  static constexpr double infinity() { return (std::numeric_limits<double>::max)(); }

  // returns the length of the shortest closed walk from `start` if it is below `limit`, else
  // infinity
  double search(int start, const std::vector<double>& price, double limit)
  {
    for (int s : m_reached)
      m_distance[s] = infinity();
    m_reached.clear();
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto expand = [&](int from, double distance) {
      for (int s : m_graph.successors(from)) {
        const double d = distance + (s == m_graph.outside() ? 0 : price[s / 2]);
        if (d >= m_distance[s] || d >= limit)
          continue;
        if (m_distance[s] == infinity())
          m_reached.push_back(s);
        m_distance[s] = d;
        m_parent[s] = from;
        queue.emplace(d, s);
      }
    };
    expand(start, 0);
    while (!queue.empty()) {
      const Entry top = queue.top();
      queue.pop();
      if (top.second == start)
        return top.first;
      if (top.first <= m_distance[top.second])
        expand(top.second, top.first);
    }
    return infinity();
  }

  Loop loop_to(int start) const
  {
    Loop result(1, start / 2);
    for (int s = m_parent[start]; s != start; s = m_parent[s])
      if (s != m_graph.outside())
        result.push_back(s / 2);
    return result;
  }

  const Dual_graph& m_graph;
  std::vector<double> m_distance;
  std::vector<int> m_parent, m_reached;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_SEARCH_H
