// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_QUOTIENT_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_QUOTIENT_H

#include <CGAL/Quad_layouts/internal/layout/arc_grid.h>
#include <CGAL/Quad_layouts/internal/layout/compare_with_surface.h>
#include <CGAL/Quad_layouts/internal/layout/fibre_loops.h>
#include <CGAL/Quad_layouts/internal/layout/fibres.h>
#include <CGAL/Quad_layouts/internal/layout/glued_squares.h>
#include <CGAL/Quad_layouts/internal/layout/is_contractible.h>
#include <CGAL/Quad_layouts/internal/layout/number_classes.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The singularities and seeds that fall onto one vertex of the quotient.
struct Merged_cluster
{
  std::vector<int> nodes; // ascending
  int index = 0;          // sum of the nodes' indices, in quarters
  // arcs of length 0 that join all nodes; if positive they separate some, unless other zero
  // connections join the same nodes
  std::vector<int> tree_arcs;
  // nothing but these arcs is needed to join them
  bool is_joined_by_arcs = true;
};

// Arcs whose lengths should not all be 0; sorted, unique.
struct Quotient_cut
{
  std::vector<int> arcs;
  // No valid layout has length 0 on all of them. For others there may be some, in rare cases: where
  // more is collapsed, or patches are shifted.
  bool is_exact;

  // of those with the same arcs the exact one comes first, and stays
  bool operator<(const Quotient_cut& other) const
  {
    return arcs != other.arcs ? arcs < other.arcs : is_exact > other.is_exact;
  }
  bool operator==(const Quotient_cut& other) const { return arcs == other.arcs; }
};

// What a quantization makes of a T-mesh.
struct Quotient_report
{
  // the quotient is the same surface, and a cluster's vertex has valence 4 - index
  bool valid = false;
  // the first defect found
  std::string reason;
  std::vector<Quotient_cut> cuts; // one or more per defect
  // of all singularities and seeds, in ascending order of their first nodes, singletons included;
  // filled for invalid quotients too
  std::vector<Merged_cluster> clusters;
};

template <class T>
std::vector<T> sorted_unique(std::vector<T> values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

inline std::vector<int> arcs_of(const Fibres& fibres, const std::vector<int>& connections)
{
  std::vector<int> result;
  for (int c : connections)
    for (int a : fibres.arcs(c))
      result.push_back(a);
  return sorted_unique(std::move(result));
}

// says whether connections are arcs, and none leads through a patch
inline bool are_arcs(const Fibres& fibres, const std::vector<int>& connections)
{
  return std::all_of(connections.begin(), connections.end(),
                     [&](int c) { return fibres.connection(c).arc >= 0; });
}

// of a loop that must not have length 0
inline Quotient_cut cut_of(const Fibres& fibres, const std::vector<int>& loop)
{
  std::vector<int> arcs = arcs_of(fibres, loop);
  const bool is_exact = are_arcs(fibres, loop) && !is_contractible(fibres.grid().t_mesh(), arcs);
  return {std::move(arcs), is_exact};
}

inline std::vector<Merged_cluster> merged_clusters(const Fibres& fibres)
{
  const T_mesh& t = fibres.grid().t_mesh();
  std::vector<Merged_cluster> result;
  std::vector<int> cluster_of_fibre(fibres.size(), -1);
  for (int n = 0; n < t.number_of_vertices(); ++n) {
    if (!t.is_singularity_or_seed(n))
      continue;
    int& c = cluster_of_fibre[fibres.fibre_of_point(n)];
    if (c < 0) {
      c = int(result.size());
      result.emplace_back();
    }
    result[c].nodes.push_back(n);
    result[c].index += t.index(n);
  }
  for (Merged_cluster& c : result)
    if (c.nodes.size() > 1) {
      const Fibre_loops paths(fibres, fibres.fibre_of_point(c.nodes.front()));
      const std::vector<int> tree = paths.tree(c.nodes);
      c.tree_arcs = arcs_of(fibres, tree);
      c.is_joined_by_arcs = are_arcs(fibres, tree);
    }
  return result;
}

// says if two nodes fall together
inline bool are_merged(const Quotient_report& report, int i, int j)
{
  return std::any_of(report.clusters.begin(), report.clusters.end(), [&](const auto& cluster) {
    return std::binary_search(cluster.nodes.begin(), cluster.nodes.end(), i) &&
           std::binary_search(cluster.nodes.begin(), cluster.nodes.end(), j);
  });
}

// Arcs of which one must be positive for two nodes that fall together to be separate; exact if no
// connection through patches joins them.
inline Quotient_cut cut_between(const T_mesh& t_mesh, const std::vector<int>& arc_length, int i,
                                int j)
{
  const Arc_grid grid(t_mesh, arc_length);
  const Fibres fibres(grid);
  const std::vector<int> path = Fibre_loops(fibres, fibres.fibre_of_point(i)).tree({i, j});
  return {arcs_of(fibres, path), are_arcs(fibres, path)};
}

// Collects defects; the first one gives the reason.
inline void add_defect(Quotient_report& report, const std::string& reason, Quotient_cut cut)
{
  if (report.reason.empty())
    report.reason = reason;
  report.cuts.push_back(std::move(cut));
}

// Finds loops of zero length that patches of zero size do not fill, and spheres that vanish.
inline void find_unfilled_loops(const Fibres& fibres, Quotient_report& report)
{
  for (int f = 0; f < fibres.size(); ++f) {
    const Fibre& fibre = fibres.fibre(f);
    const std::string node = std::to_string(fibre.points.front());
    if (fibre.euler_characteristic() == 1)
      continue;
    if (fibre.euler_characteristic() == 2)
      add_defect(report, "the whole component of node " + node + " has length 0",
                 {arcs_of(fibres, fibre.connections), true});
    for (const std::vector<int>& loop : Fibre_loops(fibres, f).unfilled_loops())
      add_defect(report,
                 "a loop of length 0 at node " + node + " is not filled by patches of size 0",
                 cut_of(fibres, loop));
  }
}

// The points of a fibre on fixed curves, by pieces that arcs of length 0 on these join.
inline std::vector<std::vector<int>> fixed_pieces(const Fibres& fibres, int fibre)
{
  std::map<int, int> number; // within the fibre
  std::vector<int> points;
  for (int p : fibres.fibre(fibre).points)
    if (fibres.grid().is_on_fixed_curve(p)) {
      number[p] = int(points.size());
      points.push_back(p);
    }
  Disjoint_sets sets(int(points.size()));
  for (int c : fibres.fibre(fibre).connections)
    if (fibres.is_fixed(c))
      sets.union_set(number.at(fibres.connection(c).from), number.at(fibres.connection(c).to));
  const Numbered_classes classes = number_classes(sets, int(points.size()));
  std::vector<std::vector<int>> result(classes.number);
  for (std::size_t i = 0; i < points.size(); ++i)
    result[classes.class_of[i]].push_back(points[i]);
  return result;
}

// the connections of a fibre that are part of fixed curves
inline std::vector<int> fixed_connections(const Fibres& fibres, int fibre)
{
  std::vector<int> result;
  for (int c : fibres.fibre(fibre).connections)
    if (fibres.is_fixed(c))
      result.push_back(c);
  return result;
}

// the nodes of a fibre where fixed curves meet
inline std::vector<int> junctions(const Fibres& fibres, int fibre)
{
  const T_mesh& t = fibres.grid().t_mesh();
  std::vector<int> result;
  for (int p : fibres.fibre(fibre).points)
    if (p < t.number_of_vertices() && t.number_of_fixed_arcs(p) > 2)
      result.push_back(p);
  return result;
}

// Finds places where fixed curves fall together, because one fibre has several pieces of them, or
// several junctions; and closed ones that vanish.
inline void find_defects_of_fixed_curves(const Fibres& fibres, Quotient_report& report)
{
  for (int f = 0; f < fibres.size(); ++f) {
    const std::vector<std::vector<int>> pieces = fixed_pieces(fibres, f);
    const std::vector<int> connections = fixed_connections(fibres, f);
    const std::string node = std::to_string(fibres.fibre(f).points.front());
    const std::vector<int> met = junctions(fibres, f);
    std::size_t points = 0;
    for (const auto& piece : pieces)
      points += piece.size();
    if (points < pieces.size() + connections.size())
      add_defect(report, "a closed fixed curve at node " + node + " has length 0",
                 {arcs_of(fibres, connections), false});
    else if (pieces.size() > 1)
      add_defect(
          report, "fixed curves fall together at node " + node,
          {arcs_of(fibres, Fibre_loops(fibres, f).path(pieces.front(), pieces.back())), false});
    else if (met.size() > 1) {
      const std::vector<int> path = Fibre_loops(fibres, f).path({met[0]}, {met[1]});
      add_defect(report, "junctions of fixed curves fall together at node " + node,
                 {arcs_of(fibres, path), are_arcs(fibres, path)});
    }
  }
}

// The number of segments of fixed curves that flat patches join to that of half-segment s, behind
// which there is none, s itself included.
inline int number_of_joined_fixed_segments(const Arc_grid& grid, int s)
{
  int result = grid.t_mesh().is_fixed(grid.arc(s));
  for (int t = s ^ 1; grid.across(t) >= 0; t = grid.across(t) ^ 1)
    result += grid.t_mesh().is_fixed(grid.arc(grid.across(t)));
  return result;
}

// Finds rings of patches of zero width, each glued to the next along its long sides, and chains of
// them from one fixed curve to another.
inline void find_flat_rings(const Fibres& fibres, Quotient_report& report)
{
  const Arc_grid& grid = fibres.grid();
  std::vector<char> visited(grid.number_of_half_segments(), 0);
  const auto walk = [&](int s, std::vector<int>& patches) {
    for (; grid.across(s) >= 0 && !visited[s]; s = grid.across(s) ^ 1) {
      visited[s] = visited[grid.across(s)] = 1;
      patches.push_back(grid.patch(s));
    }
  };
  const auto add = [&](const std::string& shape, const std::vector<int>& patches) {
    std::vector<int> cut;
    for (int p : patches)
      for (int a : fibres.short_side(p))
        cut.push_back(a);
    add_defect(report,
               "patches without extent form a " + shape + " through patch " +
                   std::to_string(patches.front()),
               {sorted_unique(std::move(cut)), false});
  };
  for (int s = 0; s < grid.number_of_half_segments(); ++s)
    if (grid.across(s) < 0) {
      std::vector<int> patches;
      walk(s ^ 1, patches);
      if (!patches.empty() && number_of_joined_fixed_segments(grid, s) > 1)
        add("strip between fixed curves", patches);
    }
  for (int s = 0; s < grid.number_of_half_segments(); ++s) {
    std::vector<int> patches;
    walk(s, patches);
    if (!patches.empty())
      add("ring", patches);
  }
}

// Examines the quotient complex that integer arc lengths define. Throws `Stage_failure` if lengths
// are negative or differ on opposite sides of a patch. Expects a length per arc.
inline Quotient_report examine_quotient(const T_mesh& t_mesh, const std::vector<int>& arc_length)
{
  const Arc_grid grid(t_mesh, arc_length);
  const Fibres fibres(grid);
  Quotient_report report;
  report.clusters = merged_clusters(fibres);
  find_unfilled_loops(fibres, report);
  find_defects_of_fixed_curves(fibres, report);
  find_flat_rings(fibres, report);
  report.cuts = sorted_unique(std::move(report.cuts));
  if (report.cuts.empty())
    report.reason = difference_to_surface(fibres, Glued_squares(grid));
  report.valid = report.reason.empty();
  return report;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_QUOTIENT_H
