// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MERGE_TREES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MERGE_TREES_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/T_mesh.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A place where index is handed on from a member of a merged cluster towards the cluster's root.
struct Index_transfer
{
  int index;             // what passes from the source of the path to its target, in quarters
  std::vector<int> path; // halfedges of the T-mesh along which the cut runs, on their left
  int halfedge;          // the layout vertex lies on this halfedge,
  int units;             // so many units after its source
  int level;             // order of execution: descending
};

// A layout vertex with cones: which node keeps the index of the whole cluster.
struct Cluster_root
{
  int node;
  int cluster;
};

// Finds how the members of each merged cluster are connected, and chooses the member that is to
// carry the whole index.
//
// The points that a layout vertex consists of are nodes and inner points of arcs at integer
// lengths. Two points are neighbours if they are the ends of an arc of length zero, or lie opposite
// each other on the long sides of a patch of zero width (a "fibre"). The quotient being valid, the
// points of a layout vertex form a tree but for cycles that are filled by patches of zero size, so
// any spanning tree will do.
class Merge_trees
{
public:
  Merge_trees(const T_mesh& t_mesh, const Quad_layout& layout) : m_t_mesh(t_mesh), m_layout(layout)
  {
    number_points();
    connect_through_arcs();
    connect_through_patches();
    for (int c = 0; c < int(layout.clusters.size()); ++c)
      gather(c);
    std::stable_sort(m_transfers.begin(), m_transfers.end(),
                     [](const auto& a, const auto& b) { return a.level > b.level; });
  }

  // What to hand on where, in the order in which it must be done: first along arcs, then through
  // patches from high to low, so that the cut of a lower fibre, which runs around those above,
  // comes last.
  const std::vector<Index_transfer>& transfers() const { return m_transfers; }
  // per cluster
  const std::vector<Cluster_root>& roots() const { return m_roots; }

private:
  // a connection of two points, seen from the first
  struct Link
  {
    int to;
    int transfer; // in m_pattern
    bool forward; // if the pattern's path leads from here to there
    double length;
  };

  void number_points()
  {
    m_first_inner_point.resize(m_t_mesh.number_of_edges());
    int n = m_t_mesh.number_of_vertices();
    for (int a = 0; a < m_t_mesh.number_of_edges(); ++a) {
      m_first_inner_point[a] = n;
      n += (std::max)(0, length(2 * a) - 1);
    }
    m_links.resize(n);
  }

  int length(int h) const { return int(m_layout.arc_halfedges[h / 2].size()); }
  int length(const std::vector<int>& side) const
  {
    return std::accumulate(side.begin(), side.end(), 0,
                           [&](int sum, int h) { return sum + length(h); });
  }

  // the point `units` after the source of h
  int point(int h, int units) const
  {
    if (units == 0)
      return m_t_mesh.source(h);
    const int from_start = h % 2 == 0 ? units : length(h) - units;
    return m_first_inner_point[h / 2] + from_start - 1;
  }

  void connect(int from, int to, double distance, Index_transfer pattern)
  {
    const int id = int(m_pattern.size());
    m_pattern.push_back(std::move(pattern));
    m_links[from].push_back({to, id, true, distance});
    m_links[to].push_back({from, id, false, distance});
  }

  void connect_through_arcs()
  {
    for (int a = 0; a < m_t_mesh.number_of_edges(); ++a)
      if (length(2 * a) == 0)
        connect(m_t_mesh.source(2 * a), m_t_mesh.target(2 * a), m_t_mesh.length(a),
                {0, {2 * a}, 2 * a, 0, (std::numeric_limits<int>::max)()});
  }

  void connect_through_patches()
  {
    for (int p = 0; p < m_t_mesh.number_of_faces(); ++p) {
      const auto sides = m_t_mesh.sides(p);
      const bool flat = length(sides[1]) == 0;
      const int s = flat ? 0 : 1; // the long sides are s and s + 2
      if (length(sides[1 - s]) != 0)
        continue;
      for (int level = 1; level < length(sides[s]); ++level)
        connect_fibre(sides[s], sides[s + 1], sides[(s + 2) % 4], level);
    }
  }

  struct Place
  {
    std::size_t position; // of the halfedge in its side
    int units;            // after its source, less than its length
  };

  Place place_at(const std::vector<int>& side, int level) const
  {
    for (std::size_t i = 0;; level -= length(side[i]), ++i)
      if (level < length(side[i]))
        return {i, level};
  }

  // Inner points of an arc are taken to lie just after the start of the arc. So whether a cut that
  // begins or ends on a halfedge runs along it, too, depends on which way the halfedge points along
  // its arc.
  static std::size_t first_after(const std::vector<int>& side, const Place& place)
  {
    return place.position + (place.units > 0 && side[place.position] % 2 == 1);
  }

  // The fibre leads from the right-hand long side to the left-hand one, the cut from its one end
  // around the upper part of the patch to its other end.
  void connect_fibre(const std::vector<int>& right, const std::vector<int>& top,
                     const std::vector<int>& left, int level)
  {
    const Place from = place_at(right, level), to = place_at(left, length(left) - level);
    std::vector<int> path(right.begin() + first_after(right, from), right.end());
    path.insert(path.end(), top.begin(), top.end());
    path.insert(path.end(), left.begin(), left.begin() + first_after(left, to));
    const double width = std::accumulate(top.begin(), top.end(), 0., [&](double sum, int h) {
      return sum + m_t_mesh.length(h / 2);
    });
    connect(point(right[from.position], from.units), point(left[to.position], to.units), width,
            {0, std::move(path), right[from.position], from.units, level});
  }

  using Tree =
      std::vector<std::pair<int, const Link*>>; // point and the link from its parent, root first

  // the shortest paths from `root` to all points of its layout vertex, in order of distance; fills
  // m_distance
  Tree shortest_paths(int root)
  {
    using Entry = std::tuple<double, int, const Link*>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    Tree tree;
    queue.push({0., root, nullptr});
    while (!queue.empty()) {
      const auto [distance, point, link] = queue.top();
      queue.pop();
      if (m_distance.size() != m_links.size())
        m_distance.assign(m_links.size(), -1.);
      if (m_distance[point] >= 0)
        continue;
      m_distance[point] = distance;
      tree.emplace_back(point, link);
      for (const Link& l : m_links[point])
        if (m_distance[l.to] < 0)
          queue.push({distance + l.length, l.to, &l});
    }
    return tree;
  }

  void forget(const Tree& tree)
  {
    for (const auto& entry : tree)
      m_distance[entry.first] = -1;
  }

  // the member whose largest distance to another member is smallest
  int central_member(const std::vector<int>& members)
  {
    int best = members.front();
    double best_radius = (std::numeric_limits<double>::infinity)();
    for (const int root : members) {
      const Tree tree = shortest_paths(root);
      double radius = 0;
      for (const int m : members)
        radius = (std::max)(radius, m_distance[m]);
      forget(tree);
      if (radius < best_radius) {
        best_radius = radius;
        best = root;
      }
    }
    return best;
  }

  void gather(int cluster)
  {
    const std::vector<int>& members = m_layout.clusters[cluster].nodes;
    const int root = members.size() == 1 ? members.front() : central_member(members);
    m_roots.push_back({root, cluster});
    if (members.size() == 1)
      return;
    const Tree tree = shortest_paths(root);
    hand_on(tree);
    forget(tree);
  }

  // sums up the indices from the leaves to the root
  void hand_on(const Tree& tree)
  {
    if (m_load.size() != m_links.size())
      m_load.assign(m_links.size(), 0);
    for (const auto& entry : tree)
      m_load[entry.first] = entry.first < m_t_mesh.number_of_vertices()
                                ? m_t_mesh.index(entry.first)
                                : 0;
    for (auto it = tree.rbegin(); it != tree.rend(); ++it) {
      const int child = it->first;
      const Link* link = it->second;
      const int load = std::exchange(m_load[child], 0);
      if (!link || load == 0)
        continue;
      const Link& back = *std::find_if(
          m_links[child].begin(), m_links[child].end(), [&](const Link& l) {
            return l.transfer == link->transfer && l.forward != link->forward;
          });
      m_load[back.to] += load;
      m_transfers.push_back(m_pattern[link->transfer]);
      m_transfers.back().index = back.forward ? load : -load;
    }
  }

  const T_mesh& m_t_mesh;
  const Quad_layout& m_layout;
  std::vector<int> m_first_inner_point;   // per arc
  std::vector<std::vector<Link>> m_links; // per point
  std::vector<Index_transfer> m_pattern;  // per link, without an index
  std::vector<double> m_distance;         // per point, -1 where not yet reached
  std::vector<int> m_load;                // per point
  std::vector<Index_transfer> m_transfers;
  std::vector<Cluster_root> m_roots;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MERGE_TREES_H
