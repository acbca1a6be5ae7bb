// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ALIGNMENTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ALIGNMENTS_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/quantization/Runs.h>
#include <CGAL/Quad_layouts/internal/tracing/Dual_graph.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Singularities that a line of the field joins.
//
// No trace runs into a singularity: its places on edges lie strictly between the vertices, and
// those of two traces of one family never coincide. So it passes on the left or on the right of a
// singularity on its line, and the trace that comes from there passes it by: both singularities are
// as free as if one were offset. What they would have in common is the leg of the other trace at
// the first crossing with it, if that leg has length 0. To pass a vertex, traces turn by a slope of
// up to 0.02 (see `Interval_map`); the tolerance for alignments is a little more.
class Alignments
{
public:
  static constexpr double tolerance = 0.025; // slope

  // `prefixes`: per trace the numbers of arcs whose sum must be positive, ascending
  Alignments(const T_mesh& t_mesh, const Runs& runs, const std::vector<std::vector<int>>& prefixes)
    : m_t_mesh(t_mesh), m_runs(runs), m_prefixes(prefixes)
  {
    for (std::size_t t = 0; t < t_mesh.traces.size(); ++t)
      find_first(int(t));
    // short lines first; each leg once
    std::sort(m_legs.begin(), m_legs.end());
  }

  // how many traces pass a singularity on their line
  int number_of_candidates() const { return int(m_legs.size()); }

  // returns the arcs that must be 0, where this does not make singularities fall together;
  // `zero_arcs` are 0 anyway
  std::vector<int> lock(std::vector<int> zero_arcs) const
  {
    const std::size_t old_size = zero_arcs.size();
    const int merged = merged_singularities(zero_arcs);
    lock(0, m_legs.size(), merged, zero_arcs);
    zero_arcs.erase(zero_arcs.begin(), zero_arcs.begin() + old_size);
    return zero_arcs;
  }

private:
  using Leg = std::pair<double, std::vector<int>>; // length of the line, arcs

  // the first singularity along a trace
  void find_first(int trace)
  {
    int arcs = 0;
    for (const int a : m_t_mesh.traces[trace].arcs) {
      ++arcs;
      for (const T_mesh::Visit& other : m_t_mesh.node_visits[m_t_mesh.target(2 * a)]) {
        const double line = m_runs.length({trace, arcs});
        const double leg = m_runs.length({other.trace, other.arcs});
        const auto& prefixes = m_prefixes[other.trace];
        if (m_t_mesh.traces[other.trace].start == m_t_mesh.traces[trace].start ||
            leg > tolerance * line || (!prefixes.empty() && prefixes.front() <= other.arcs))
          continue;
        const auto& all = m_t_mesh.traces[other.trace].arcs;
        m_legs.emplace_back(line, std::vector<int>(all.begin(), all.begin() + other.arcs));
        return;
      }
    }
  }

  // adds as many as possible of the legs from `first` on, by halving what is too much
  void lock(std::size_t first, std::size_t last, int merged, std::vector<int>& zero_arcs) const
  {
    if (first == last)
      return;
    std::vector<int> more = zero_arcs;
    for (std::size_t i = first; i < last; ++i)
      more.insert(more.end(), m_legs[i].second.begin(), m_legs[i].second.end());
    if (merged_singularities(more) == merged)
      zero_arcs = std::move(more);
    else if (last - first > 1) {
      const std::size_t middle = (first + last) / 2;
      lock(first, middle, merged, zero_arcs);
      lock(middle, last, merged, zero_arcs);
    }
  }

  // how many singularities have fallen onto others in all quantizations where these arcs are 0
  int merged_singularities(const std::vector<int>& zero_arcs) const
  {
    const Dual_graph graph(m_t_mesh, zero_arcs);
    Disjoint_sets sets(m_t_mesh.number_of_vertices());
    for (int a = 0; a < m_t_mesh.number_of_edges(); ++a)
      if (graph.variable(a) < 0)
        sets.union_set(m_t_mesh.source(2 * a), m_t_mesh.target(2 * a));
    std::vector<int> groups;
    int singularities = 0;
    for (int n = 0; n < m_t_mesh.number_of_vertices(); ++n)
      if (m_t_mesh.index(n) != 0) {
        ++singularities;
        groups.push_back(int(sets.find_set(n)));
      }
    std::sort(groups.begin(), groups.end());
    const auto end = std::unique(groups.begin(), groups.end());
    return singularities - int(end - groups.begin());
  }

  const T_mesh& m_t_mesh;
  const Runs& m_runs;
  const std::vector<std::vector<int>>& m_prefixes;
  std::vector<Leg> m_legs;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ALIGNMENTS_H
