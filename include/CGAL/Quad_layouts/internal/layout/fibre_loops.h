// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_FIBRE_LOOPS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_FIBRE_LOOPS_H

#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/layout/fibres.h>

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

// Shortest paths and loops in the graph of points and connections of one fibre. The length of a
// path is the number of arcs behind its connections, because the fewer arcs a cut has, the stronger
// it is.
class Fibre_loops
{
public:
  Fibre_loops(const Fibres& fibres, int fibre) : m_fibres(fibres), m_fibre(fibres.fibre(fibre))
  {
    for (std::size_t i = 0; i < m_fibre.points.size(); ++i)
      m_local[m_fibre.points[i]] = int(i);
    for (std::size_t i = 0; i < m_fibre.patches.size(); ++i)
      m_local_patch[m_fibre.patches[i]] = int(i);
    m_incident.resize(m_fibre.points.size());
    for (int c : m_fibre.connections) {
      const Zero_connection& connection = fibres.connection(c);
      const int from = m_local.at(connection.from), to = m_local.at(connection.to);
      const int length = int(fibres.arcs(c).size());
      m_incident[from].push_back({c, to, length});
      m_incident[to].push_back({c, from, length});
    }
  }

  // the connections of a tree of shortest paths from the first of some points to the others
  std::vector<int> tree(const std::vector<int>& points) const
  {
    const Tree paths = shortest_paths({m_local.at(points.front())});
    std::vector<char> reached(m_incident.size(), 0);
    std::vector<int> result;
    for (int p : points)
      for (int v = m_local.at(p); paths.connection[v] >= 0 && !reached[v]; v = paths.parent[v]) {
        reached[v] = 1;
        result.push_back(paths.connection[v]);
      }
    return result;
  }

  // the connections of a shortest path from one of some points to one of some others
  std::vector<int> path(const std::vector<int>& from, const std::vector<int>& to) const
  {
    std::vector<int> roots;
    for (int p : from)
      roots.push_back(m_local.at(p));
    const Tree paths = shortest_paths(roots);
    const int end = *std::min_element(to.begin(), to.end(), [&](int p, int q) {
      return paths.distance[m_local.at(p)] < paths.distance[m_local.at(q)];
    });
    return path_to(paths, m_local.at(end));
  }

  // a basis of the loops that patches of zero size do not fill, with a shortest loop among them:
  // the tree-cotree decomposition of Eppstein (2003) with the greedy choice of Erickson and
  // Whittlesey (2005)
  std::vector<std::vector<int>> unfilled_loops() const
  {
    std::vector<std::vector<int>> best;
    int best_length = (std::numeric_limits<int>::max)();
    const int n = int(m_incident.size()), step = 1 + n / maximum_number_of_roots;
    for (int root = 0; root < n; root += step) {
      const Tree paths = shortest_paths({root});
      const std::vector<Loop> loops = generators(paths);
      if (!loops.empty() && loops.front().first < best_length) {
        best_length = loops.front().first;
        best.clear();
        for (const Loop& loop : loops)
          best.push_back(connections_of_loop(paths, loop.second));
      }
    }
    return best;
  }

private:
  static constexpr int maximum_number_of_roots = 100; // bounds the work in huge fibres

  struct Neighbour
  {
    int connection, point, length;
  };
  struct Tree
  {
    std::vector<int> distance, parent, connection; // per local point; -1 at roots
  };
  using Loop = std::pair<int, int>; // length, connection that closes it

  Tree shortest_paths(const std::vector<int>& roots) const
  {
    constexpr int infinity = (std::numeric_limits<int>::max)();
    const std::size_t n = m_incident.size();
    Tree tree{std::vector<int>(n, infinity), std::vector<int>(n, -1), std::vector<int>(n, -1)};
    using Entry = std::pair<int, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for (int root : roots) {
      tree.distance[root] = 0;
      queue.emplace(0, root);
    }
    while (!queue.empty()) {
      const auto [distance, v] = queue.top();
      queue.pop();
      if (distance > tree.distance[v])
        continue;
      for (const Neighbour& e : m_incident[v])
        if (distance + e.length < tree.distance[e.point]) {
          tree.distance[e.point] = distance + e.length;
          tree.parent[e.point] = v;
          tree.connection[e.point] = e.connection;
          queue.emplace(distance + e.length, e.point);
        }
    }
    return tree;
  }

  // the connections outside both the tree and a tree of dual edges that cross the longest loops,
  // ascending
  std::vector<Loop> generators(const Tree& paths) const
  {
    std::vector<Loop> candidates;
    for (std::size_t v = 0; v < m_incident.size(); ++v)
      for (const Neighbour& e : m_incident[v])
        if (paths.connection[v] != e.connection && paths.connection[e.point] != e.connection)
          candidates.emplace_back(paths.distance[v] + e.length + paths.distance[e.point],
                                  e.connection);
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());

    const int outside = int(m_fibre.patches.size()); // one dual node for all that is not filled
    Disjoint_sets sets(outside + 1);
    const auto dual_node = [&](int patch) { return patch < 0 ? outside : m_local_patch.at(patch); };
    std::vector<Loop> result;
    for (auto c = candidates.rbegin(); c != candidates.rend(); ++c) {
      const auto beside = m_fibres.patches_beside(c->second);
      const auto a = sets.find_set(dual_node(beside.first));
      const auto b = sets.find_set(dual_node(beside.second));
      if (a == b)
        result.push_back(*c);
      else
        sets.union_set(a, b);
    }
    std::reverse(result.begin(), result.end());
    return result;
  }

  // the connection and the two paths to it from where these part
  std::vector<int> connections_of_loop(const Tree& paths, int closing) const
  {
    const Zero_connection& c = m_fibres.connection(closing);
    std::vector<int> from = path_to(paths, m_local.at(c.from));
    std::vector<int> to = path_to(paths, m_local.at(c.to));
    while (!from.empty() && !to.empty() && from.back() == to.back()) {
      from.pop_back();
      to.pop_back();
    }
    from.push_back(closing);
    from.insert(from.end(), to.begin(), to.end());
    return from;
  }

  // the connections from a point to the root
  static std::vector<int> path_to(const Tree& paths, int v)
  {
    std::vector<int> result;
    for (; paths.connection[v] >= 0; v = paths.parent[v])
      result.push_back(paths.connection[v]);
    return result;
  }

  const Fibres& m_fibres;
  const Fibre& m_fibre;
  std::map<int, int> m_local, m_local_patch;      // numbers within the fibre
  std::vector<std::vector<Neighbour>> m_incident; // per local point
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_FIBRE_LOOPS_H
