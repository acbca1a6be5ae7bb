// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_RUNS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_RUNS_H

#include <CGAL/Quad_layouts/T_mesh.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A straight way out of a singularity or seed.
struct Run
{
  int start;
  std::vector<int> arcs;
  std::vector<double> lengths; // of the first 0, 1, 2, ... arcs
};

// The first `arcs` arcs of a run lead to where it meets another one.
struct Run_visit
{
  int run, arcs;
};

// Two runs that meet in a node.
struct Run_meeting
{
  Run_visit visits[2];
  bool on_fixed_curve; // that of the first run
};

// The runs of a T-mesh: its traces, with their numbers; then those on fixed curves once more, the
// other way, because they lead from one singularity or seed to the next.
class Runs
{
public:
  explicit Runs(const T_mesh& t_mesh) : m_reverse(t_mesh.traces.size(), -1)
  {
    for (const T_mesh::Trace& t : t_mesh.traces)
      add(t_mesh, t.start, t.arcs);
    for (std::size_t t = 0; t < t_mesh.traces.size(); ++t) {
      const std::vector<int>& arcs = t_mesh.traces[t].arcs;
      if (arcs.empty() || !t_mesh.is_fixed(arcs.front()))
        continue;
      m_reverse[t] = int(m_runs.size());
      add(t_mesh, t_mesh.target(2 * arcs.back()), {arcs.rbegin(), arcs.rend()});
    }
    for (int n = 0; n < t_mesh.number_of_vertices(); ++n)
      if (t_mesh.node_visits[n].size() == 2)
        add_meetings(t_mesh, n);
  }

  int size() const { return int(m_runs.size()); }
  const Run& operator[](int r) const { return m_runs[r]; }
  const std::vector<Run_meeting>& meetings() const { return m_meetings; }
  double length(const Run_visit& v) const { return m_runs[v.run].lengths[v.arcs]; }

private:
  void add(const T_mesh& t_mesh, int start, std::vector<int> arcs)
  {
    std::vector<double> lengths(1, 0.);
    for (int a : arcs)
      lengths.push_back(lengths.back() + t_mesh.length(a));
    m_runs.push_back({start, std::move(arcs), std::move(lengths)});
  }

  void add_meetings(const T_mesh& t_mesh, int n)
  {
    const T_mesh::Visit &first = t_mesh.node_visits[n][0], &second = t_mesh.node_visits[n][1];
    const int reverse = m_reverse[first.trace];
    const Run_visit other{second.trace, second.arcs};
    m_meetings.push_back({{{first.trace, first.arcs}, other}, reverse >= 0});
    if (reverse >= 0)
      m_meetings.push_back(
          {{{reverse, int(m_runs[reverse].arcs.size()) - first.arcs}, other}, true});
  }

  std::vector<int> m_reverse; // per trace
  std::vector<Run> m_runs;
  std::vector<Run_meeting> m_meetings;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_RUNS_H
