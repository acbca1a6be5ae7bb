// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WISHED_CONNECTIONS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WISHED_CONNECTIONS_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/quantization/Runs.h>
#include <CGAL/Quad_layouts/internal/quantization/close_pairs.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A layout edge from node i to node j that the user asks for: from one of the two along its trace,
// as far as the trace of the other one meets it, where the leg of that trace has length 0.
struct Wished_connection
{
  int i, j;
  std::vector<int> zero, positive; // arcs: all are 0; some is positive
};

// "the singularities at the vertices 3 and 5", for messages
inline std::string name_of_pair(const T_mesh& t_mesh, int i, int j)
{
  return "the singularities at the vertices " + std::to_string(t_mesh.surface_vertex(i)) + " and " +
         std::to_string(t_mesh.surface_vertex(j));
}

inline Unsatisfiable_demand inseparable(const T_mesh& t_mesh, int i, int j)
{
  return Unsatisfiable_demand(name_of_pair(t_mesh, i, j) + " fall together in every quantization");
}

// Looks for the connections of nodes that no row of the paper's program excludes.
class Connection_search
{
public:
  // `prefixes`: per trace the numbers of arcs whose sum must be positive, ascending
  Connection_search(const T_mesh& t_mesh, const Runs& runs,
                    const std::vector<std::vector<int>>& prefixes)
    : m_t_mesh(t_mesh), m_runs(runs), m_prefixes(prefixes)
  {
  }

  // returns the shortest connection
  Wished_connection between(int i, int j) const
  {
    Wished_connection result{i, j, {}, {}};
    double shortest = (std::numeric_limits<double>::max)();
    const auto propose = [&](const T_mesh::Visit& zero, const T_mesh::Visit& positive) {
      const double length = length_of(zero) + length_of(positive);
      if (length >= shortest || !can_be_zero(zero))
        return;
      shortest = length;
      result.zero = arcs_of(zero);
      result.positive = arcs_of(positive);
    };
    for (const auto& visits : m_t_mesh.node_visits)
      if (visits.size() == 2 && are_of(visits, i, j))
        propose(visits[0], visits[1]); // the second one is longer
    for (const auto& [start, end] : {std::pair(i, j), std::pair(j, i)})
      for (std::size_t t = 0; t < m_t_mesh.traces.size(); ++t)
        if (m_t_mesh.traces[t].start == start && end_of(int(t)) == end)
          propose({int(t), 0}, {int(t), int(m_t_mesh.traces[t].arcs.size())});
    if (result.positive.empty())
      throw Unsatisfiable_demand("forced_connections: within the limits of deviation there is no "
                                 "layout edge between " +
                                 name_of_pair(m_t_mesh, i, j));
    return result;
  }

private:
  int start_of(const T_mesh::Visit& v) const { return m_t_mesh.traces[v.trace].start; }

  int end_of(int trace) const
  {
    const auto& arcs = m_t_mesh.traces[trace].arcs;
    return arcs.empty() ? -1 : m_t_mesh.target(2 * arcs.back());
  }

  bool are_of(const std::vector<T_mesh::Visit>& visits, int i, int j) const
  {
    return std::minmax(start_of(visits[0]), start_of(visits[1])) == std::minmax(i, j);
  }

  double length_of(const T_mesh::Visit& v) const { return m_runs.length({v.trace, v.arcs}); }

  bool can_be_zero(const T_mesh::Visit& v) const
  {
    const auto& prefixes = m_prefixes[v.trace];
    return prefixes.empty() || prefixes.front() > v.arcs;
  }

  std::vector<int> arcs_of(const T_mesh::Visit& v) const
  {
    const auto& arcs = m_t_mesh.traces[v.trace].arcs;
    return {arcs.begin(), arcs.begin() + v.arcs};
  }

  const T_mesh& m_t_mesh;
  const Runs& m_runs;
  const std::vector<std::vector<int>>& m_prefixes;
};

// returns the shortest path of arcs between two nodes; empty between components
inline std::vector<int> shortest_path(const T_mesh& t_mesh, int i, int j)
{
  Arc_distances distances(t_mesh);
  distances.search(i, (std::numeric_limits<double>::max)());
  return distances.path_to(j);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WISHED_CONNECTIONS_H
