// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_SEARCH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_SEARCH_H

#include <CGAL/Quad_layouts/Quantization.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/quantization/Incumbent.h>
#include <CGAL/Quad_layouts/internal/quantization/Neighbourhoods.h>
#include <CGAL/Quad_layouts/internal/quantization/Quantization_options.h>
#include <CGAL/Quad_layouts/internal/quantization/check_quantization.h>
#include <CGAL/Quad_layouts/internal/quantization/lazy_index_rows.h>
#include <CGAL/Quad_layouts/internal/quantization/solve_in_box.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Solves the program of [LCK21b] for a T-mesh, in four steps that each begin with the best solution
// so far:
// - a greedy sum of dual loops;
// - branch and cut in the whole program, which ends with the optimum for some hundred singularities
//   that rarely can merge, and gives a bound for the others;
// - branch and cut where only variables that are positive in the solution or in the relaxation are
//   free;
// - branch and cut in ever larger neighbourhoods.
//
// The effort of the solver is bounded by nodes of its search tree, so that results can be repeated;
// time limits are the last resort. Of many index rows solvers see those that some solution has
// violated. What solvers do not see can only lower a bound, and each solution is checked against
// all rows.
template <class Traits>
class Quantization_search
{
public:
  Quantization_search(const T_mesh& t_mesh, const Quantization_options& options,
                      const Monitor& monitor)
    : m_t_mesh(t_mesh), m_options(options), m_monitor(monitor),
      m_paper(build_quantization_program(t_mesh, options.demands, options.wishes)),
      m_graph(t_mesh, m_paper.zero_arcs()), m_program(reduce(t_mesh, m_paper, m_graph)),
      m_incumbent(t_mesh, m_paper, m_graph, m_program), m_neighbourhoods(t_mesh, m_graph)
  {
    m_timer.start();
  }

  Quantization run()
  {
    if (m_incumbent.start() || find_first_solution()) {
      report();
      make_index_rows_lazy_if_many(m_program);
      solve_relaxation();
      search_whole_program();
      if (!is_done() && !m_relaxation.empty())
        search_support();
      if (!is_done())
        search_neighbourhoods();
    }
    return result();
  }

private:
  bool is_proven() const
  {
    constexpr double rounding = 1e-9;
    const double gap = (std::max)(m_options.relative_gap, rounding);
    return m_incumbent.objective() - m_bound <= gap * m_incumbent.objective();
  }
  bool is_done() const { return is_proven() || seconds_left() <= 0; }
  double seconds_left() const { return m_options.seconds - m_timer.time(); }

  void report() const
  {
    const double lost = m_program.penalty * m_program.violated_rows;
    m_monitor.improved(m_incumbent.objective() + lost, m_bound + lost, m_timer.time());
  }

  Search_effort effort(int nodes, double share_of_time, double gap) const
  {
    return {(std::min)(seconds_left(), share_of_time * m_options.seconds), nodes, gap,
            [this] { return m_monitor.stopped(); }};
  }

  // solves in a box, takes over what is better, and returns the outcome
  Box_solution search(const Box& box, const Search_effort& effort, bool& improved)
  {
    Box_solution solution = solve_in_box<Traits>(m_program, box, m_incumbent.values(), effort);
    m_monitor.check("quantize");
    improved = !solution.x.empty() && m_incumbent.improve_by(rounded(solution.x));
    if (improved)
      report();
    return solution;
  }

  static std::vector<int> rounded(const std::vector<double>& x)
  {
    std::vector<int> result;
    for (double value : x)
      result.push_back(int(std::lround(value)));
    return result;
  }

  // The time of a node is about quadratic in the size of the program; whole programs that are far
  // too large to be solved get little of it.
  int nodes_of_whole_program() const
  {
    const double n = m_program.number_of_variables();
    return int((std::max)(1., (std::min)(200., 4e7 / (n * n))));
  }

  // is for programs with rows that sums of dual loops do not satisfy; says if there is a solution
  bool find_first_solution()
  {
    if (m_program.mirrored.empty())
      return false;
    constexpr int nodes = 1000;
    m_program.inexact_cuts_are_visible = true;
    bool found;
    int rows;
    do {
      rows = m_program.number_of_visible_rows();
      search(Box(m_program.number_of_variables()), effort(nodes, 0.5, m_options.relative_gap),
             found);
    } while (!found && m_program.number_of_visible_rows() > rows && seconds_left() > 0);
    m_program.inexact_cuts_are_visible = false;
    return found;
  }

  // solves again as long as the solution violates what the solver did not see; at last with all
  // cuts
  void search_whole_program()
  {
    const Box everything(m_program.number_of_variables());
    int rows;
    do {
      rows = m_program.number_of_visible_rows();
      bool improved;
      const Box_solution solution = search(
          everything, effort(nodes_of_whole_program(), 0.2, m_options.relative_gap / 2), improved);
      if (!m_program.inexact_cuts_are_visible)
        m_bound = (std::max)(m_bound, solution.bound);
      report();
      if (solution.status != Box_solution::OPTIMAL)
        break;
      m_program.inexact_cuts_are_visible |= m_program.number_of_visible_rows() == rows;
    } while (m_program.number_of_visible_rows() > rows && !is_done());
    m_program.covers_are_soft = false;
    m_program.inexact_cuts_are_visible = true;
  }

  // An objective above the penalty could fall by violating a row: then bounds must come from the
  // soft program.
  void solve_relaxation()
  {
    m_program.covers_are_soft = m_incumbent.objective() > m_program.penalty;
    const Box everything(m_program.number_of_variables());
    const int nodes = 20 + m_program.number_of_variables() / 50;
    do {
      Box_solution solution = solve_in_box<Traits>(m_program, everything, {}, effort(nodes, 0.2, 0),
                                                   Domain::REALS);
      m_monitor.check("quantize");
      if (solution.x.empty())
        return;
      m_relaxation = std::move(solution.x);
      m_bound = (std::max)(m_bound, solution.bound);
    } while (demand_index_rows(m_program, m_relaxation, everything.longest_path) > 0);
  }

  void search_support()
  {
    Box box(m_program.number_of_variables());
    restrict_to_support(box);
    bool improved;
    search(box, effort(1000, 0.15, 0.001), improved);
  }

  // keeps variables at 0 that are 0 in the solution and in the relaxation, and paths short
  void restrict_to_support(Box& box) const
  {
    constexpr double positive = 1e-6;
    box.longest_path = 4;
    for (int v = 0; v < m_program.number_of_variables(); ++v)
      if (m_relaxation[v] < positive && m_incumbent.values()[v] == 0)
        box.low[v] = box.high[v] = 0;
  }

  // searches around one singularity after another. The neighbourhoods grow while they are solved to
  // optimality, and every other one is restricted to the support. Ends when many in a row bring
  // nothing.
  void search_neighbourhoods()
  {
    std::vector<int> order = m_paper.singularities;
    const int patience = 20 + int(order.size()) / 4;
    std::mt19937 random;
    double size = 16;
    int failures = 0;
    for (std::size_t i = 0; !is_done() && failures < patience; ++i) {
      const std::size_t k = i % order.size();
      std::swap(order[k], order[k + random() % (order.size() - k)]);
      Box box = m_neighbourhoods.around(order[k], int(size), m_incumbent.values());
      free_mirrored(m_program, box);
      if (i % 2 == 1 && !m_relaxation.empty())
        restrict_to_support(box);
      bool improved;
      const Box_solution solution = search(box, effort(60, 0.15, 0.001), improved);
      failures = improved ? 0 : failures + 1;
      size = solution.status == Box_solution::OPTIMAL
                 ? (std::min)(size * growth(), double(order.size()))
                 : (std::max)(size / 1.1, 2.);
      m_monitor.report("quantize", (std::min)(1., m_timer.time() / m_options.seconds));
    }
  }

  // small steps for many singularities: there is more to gain from a size before it is time for the
  // next one
  double growth() const { return 1 + 6. / m_paper.singularities.size(); }

  // evaluates the solution anew, in the program of the paper
  Quantization result() const
  {
    Quantization result;
    result.variables = m_program.number_of_variables();
    result.indicators = int(m_program.indicators.size());
    result.constraints = int(m_program.equations.size() + m_program.covers.size() +
                             2 * m_program.indicators.size() + m_program.index_rows.size() +
                             m_program.cuts.size());
    result.rounds = m_incumbent.rounds();
    const double lost = m_program.penalty * m_program.violated_rows;
    result.bound = m_bound + lost;
    if (m_incumbent.values().empty())
      return result;
    result.arc_length = m_program.arc_lengths(m_incumbent.values());
    const Quantization_check check = check_quantization(m_t_mesh, m_paper, result.arc_length);
    CGAL_postcondition(check.consistent && check.grants_wishes);
    result.objective = check.objective;
    result.violated = check.violated();
    result.status = is_proven() ? Quantization::OPTIMAL : Quantization::FEASIBLE;
    return result;
  }

  const T_mesh& m_t_mesh;
  const Quantization_options m_options;
  const Monitor& m_monitor;
  Real_timer m_timer;
  const Quantization_program m_paper;
  const Dual_graph m_graph;
  Reduced_program m_program;
  Incumbent m_incumbent;
  Neighbourhoods m_neighbourhoods;
  std::vector<double> m_relaxation;
  double m_bound = 0; // all costs are positive
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_SEARCH_H
