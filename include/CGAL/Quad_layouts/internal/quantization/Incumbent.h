// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_INCUMBENT_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_INCUMBENT_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/quantization/Loop_sum.h>
#include <CGAL/Quad_layouts/internal/quantization/Validity.h>
#include <CGAL/Quad_layouts/internal/quantization/dual_loops.h>
#include <CGAL/Quad_layouts/internal/quantization/lazy_index_rows.h>

#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The best valid solution so far. Nothing gets in that has not been checked here, wherever it comes
// from.
class Incumbent
{
public:
  // `program` gets the cuts that are found; `monitor` ends what takes long
  Incumbent(const T_mesh& t_mesh, const Quantization_program& paper, const Dual_graph& graph,
            Reduced_program& program, const Monitor& monitor)
    : m_t_mesh(t_mesh), m_graph(graph), m_program(program), m_monitor(monitor),
      m_validity(t_mesh, paper, program), m_search(graph)
  {
  }

  // empty if there is none
  const std::vector<int>& values() const { return m_x; }
  // without the penalty for rows that every quantization violates
  double objective() const { return m_objective; }
  // how often a solution was found not to be a valid layout
  int rounds() const { return m_rounds; }

  // finds a first solution, and says if there is one: a cheap sum of loops, or one in which all
  // that can be separate is; throws if there is no time for it
  bool start()
  {
    Loop_sum sum(m_program);
    if (repair(sum))
      return true;
    for (int v = 0; v < m_program.number_of_variables(); ++v)
      if (sum.values()[v] == 0) {
        m_monitor.check("quantize");
        sum.add(m_search.cheapest_loop({v}, m_program.cost));
      }
    return accept(sum.values());
  }

  // takes over `x`, or a repaired `x`, if it is valid and better; says if so. Solvers get to see
  // the lazy index rows that `x` violates.
  bool improve_by(const std::vector<int>& x)
  {
    if (!Program_evaluation(m_program, x).is_consistent())
      return false;
    const bool was_unaware = demand_index_rows(m_program, x) > 0;
    if (!was_unaware && !is_better(x))
      return false;
    if (accept(x))
      return true;
    Loop_sum sum(m_program);
    for (Loop& loop : dual_loops(m_t_mesh, m_graph, x))
      sum.add(std::move(loop));
    try {
      return repair(sum);
    } catch (const Time_limit_exceeded&) {
      return false;
    }
  }

private:
  bool is_better(const std::vector<int>& x) const
  {
    constexpr double tolerance = 1e-9;
    return Program_evaluation(m_program, x).objective() < m_objective * (1 - tolerance);
  }

  bool accept(const std::vector<int>& x)
  {
    const Program_evaluation rows(m_program, x);
    if (!rows.is_feasible() || !rows.grants_wishes() || !is_better(x))
      return false;
    if (!m_validity.examine(x)) {
      ++m_rounds;
      return false;
    }
    m_x = x;
    m_objective = rows.objective();
    return true;
  }

  // adds loops until the layout is valid, and takes it over if it is better
  bool repair(Loop_sum& sum)
  {
    constexpr int most_rounds = 100;
    const auto all = [this](const Reduced_program::Set& set) {
      m_monitor.check("quantize");
      return set;
    };
    for (int round = 0; round < most_rounds; ++round) {
      const std::size_t cuts = m_program.cuts.size();
      sum.update_cuts();
      sum.complete(m_program.cost, m_search, all);
      sum.prune([](std::size_t) { return 1.; });
      if (accept(sum.values()))
        return true;
      if (m_program.cuts.size() == cuts)
        return false;
    }
    return false;
  }

  const T_mesh& m_t_mesh;
  const Dual_graph& m_graph;
  Reduced_program& m_program;
  const Monitor& m_monitor;
  Validity m_validity;
  Loop_search m_search;
  std::vector<int> m_x;
  double m_objective = (std::numeric_limits<double>::max)();
  int m_rounds = 0;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_INCUMBENT_H
