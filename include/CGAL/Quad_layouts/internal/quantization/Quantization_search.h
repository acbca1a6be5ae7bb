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
#include <CGAL/Quad_layouts/internal/quantization/Loop_exchange.h>
#include <CGAL/Quad_layouts/internal/quantization/Neighbourhood_schedule.h>
#include <CGAL/Quad_layouts/internal/quantization/Neighbourhoods.h>
#include <CGAL/Quad_layouts/internal/quantization/Quantization_options.h>
#include <CGAL/Quad_layouts/internal/quantization/check_quantization.h>
#include <CGAL/Quad_layouts/internal/quantization/lazy_index_rows.h>
#include <CGAL/Quad_layouts/internal/quantization/solve_in_boxes.h>
#include <CGAL/Quad_layouts/internal/quantization/strengthen_relaxation.h>
#include <CGAL/Quad_layouts/internal/tracing/Squeezed_singularities.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Solves the program of [LCK21b] for a T-mesh, in steps that each begin with the best solution so
// far:
// - a greedy sum of dual loops;
// - the relaxation with cutting planes, for a bound;
// - a short branch and cut in the whole program, which is enough for many models;
// - rounds of growing effort: branch and cut where solution and relaxation differ; in
//   neighbourhoods of the best solution, then of others made of it by exchange of loops at random,
//   and where both differ; and from the second round on in the whole program;
// - between them, whenever bound and solution have come close, in the whole program for the proof.
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
      m_limited_monitor(monitor.limited_to(options.seconds)), m_timer(started_timer()),
      m_seconds((std::min)(options.search_seconds, options.seconds)), m_end(options.seconds),
      m_paper(
          build_quantization_program(t_mesh, options.demands, options.wishes, m_limited_monitor)),
      m_graph(t_mesh, m_paper.zero_arcs()),
      m_program(reduce(t_mesh, m_paper, m_graph, m_limited_monitor)),
      m_incumbent(t_mesh, m_paper, m_graph, m_program, m_limited_monitor),
      m_neighbourhoods(t_mesh, m_graph),
      m_schedule(int(m_paper.singularities.size()), m_program.number_of_variables()),
      m_exchange(m_program, m_graph)
  {
  }

  Quantization run()
  {
    if (m_incumbent.start() || find_first_solution()) {
      limit_search();
      report_improvement();
      make_index_rows_lazy_if_many(m_program);
      m_can_search_whole_program = solve_relaxation();
      if (m_can_search_whole_program)
        search_whole_program(200, 0.1);
      for (int factor = 1; !is_done() && factor <= largest_factor; factor *= 4) {
        finish_if_close();
        search_disagreement(200 * factor);
        finish_if_close();
        search_neighbourhoods(m_incumbent, 60 * factor);
        finish_if_close();
        if (!is_done())
          search_elsewhere(60 * factor);
        if (factor > 1 && !is_done())
          search_whole_program(20 * factor, 0.25);
      }
    }
    return result();
  }

private:
  static Real_timer started_timer()
  {
    Real_timer timer;
    timer.start();
    return timer;
  }

  using Kind = Neighbourhood_schedule::Kind;

  static constexpr int largest_factor = 1 << 16; // of the effort; ends the search of poor solvers
  // of the time that is left for one of many searches, so that none takes it from the others
  static constexpr double small_share = 0.03;

  static constexpr double rounding = 1e-9; // relative error of objectives and bounds

  double gap() const { return 1 - m_bound / m_incumbent.objective(); }
  bool is_proven() const
  {
    const double gap = (std::max)(m_options.relative_gap, rounding);
    return m_incumbent.objective() - m_bound <= gap * m_incumbent.objective();
  }
  bool is_done() const { return is_proven() || m_is_exhausted || seconds_left() <= 0; }
  double seconds_left() const { return m_end - m_timer.time(); }

  // from the first solution on
  void limit_search()
  {
    m_seconds = (std::min)(m_options.search_seconds, seconds_left());
    m_end = m_timer.time() + m_seconds;
    m_limited_monitor = m_monitor.limited_to(m_seconds);
  }

  void report() const
  {
    const double lost = m_program.penalty * m_program.violated_rows;
    m_monitor.improved(m_incumbent.objective() + lost, m_bound + lost, m_timer.time());
  }

  // Bounds hold for solutions with short paths, see Box::longest_path, or with paths as long as the
  // best one had. Better ones with longer paths refute them.
  void report_improvement()
  {
    if (m_incumbent.objective() < m_bound * (1 - rounding))
      m_bound = 0;
    report();
  }

  Search_effort effort(int nodes, double share_of_time, double gap = 0.001) const
  {
    return {(std::min)(seconds_left(), share_of_time * m_seconds), nodes, gap,
            [this] { return m_monitor.stopped(); }};
  }

  // solves in a box, takes over what is better, and returns the outcome
  Box_solution search(const Box& box, const Search_effort& effort)
  {
    const std::vector<int> start = m_incumbent.values();
    const Box_solution solution = solve_in_box<Traits>(m_program, box, start, effort);
    m_monitor.check("quantize");
    take_over(solution, start, m_incumbent);
    return solution;
  }

  // Takes over a solution that began with `start`, and says if that makes the incumbent better. The
  // incumbent may have changed since: then both changes are made, if that is possible.
  bool take_over(const Box_solution& solution, const std::vector<int>& start, Incumbent& incumbent)
  {
    if (solution.x.empty())
      return false;
    const std::vector<int> x = rounded(solution.x);
    const bool improved = incumbent.improve_by(with_changes(x, start, incumbent.values())) ||
                          (incumbent.values() != start && incumbent.improve_by(x));
    if (improved && &incumbent == &m_incumbent)
      report_improvement();
    return improved;
  }

  // returns `x` with all that has changed from `start` to `now`, if this leaves nothing negative
  static std::vector<int> with_changes(const std::vector<int>& x, const std::vector<int>& start,
                                       const std::vector<int>& now)
  {
    if (now == start)
      return x;
    std::vector<int> result = x;
    for (std::size_t v = 0; v < x.size(); ++v)
      result[v] += now[v] - start[v];
    const bool is_possible = *std::min_element(result.begin(), result.end()) >= 0;
    return is_possible ? result : x;
  }

  static std::vector<int> rounded(const std::vector<double>& x)
  {
    std::vector<int> result;
    for (double value : x)
      result.push_back(int(std::lround(value)));
    return result;
  }

  // is for programs with rows that sums of dual loops do not satisfy; says if there is a solution
  bool find_first_solution()
  {
    if (m_program.mirrored.empty())
      return false;
    constexpr int nodes = 1000;
    const auto all = Box::Rows::ALL;
    int seen;
    do {
      seen = m_program.number_of_visible_rows(all);
      search(Box(m_program.number_of_variables(), all), effort(nodes, 0.5, m_options.relative_gap));
    } while (m_incumbent.values().empty() && m_program.number_of_visible_rows(all) > seen &&
             seconds_left() > 0);
    return !m_incumbent.values().empty();
  }

  // An objective above the penalty could fall by violating a row: then bounds must come from the
  // soft program.
  Box whole_program(Box::Rows rows) const
  {
    Box box(m_program.number_of_variables(), rows);
    box.covers_are_soft = m_incumbent.objective() > m_program.penalty;
    return box;
  }

  // Solves again as long as the solution violates what the solver did not see; at last with all
  // cuts. Once this has come to its end nothing more can be found.
  void search_whole_program(int nodes, double share_of_time)
  {
    const Search_effort limits = effort(nodes_of_relaxation() + nodes, share_of_time,
                                        m_options.relative_gap / 2);
    auto rows = Box::Rows::EXACT;
    while (!is_done()) {
      const int seen = m_program.number_of_visible_rows(rows);
      const Box_solution solution = search(whole_program(rows), limits);
      if (rows == Box::Rows::EXACT)
        raise_bound(solution.bound);
      if (solution.status != Box_solution::OPTIMAL && solution.status != Box_solution::INFEASIBLE)
        return;
      if (m_program.number_of_visible_rows(rows) > seen)
        continue;
      m_is_exhausted = rows == Box::Rows::ALL;
      rows = Box::Rows::ALL;
    }
  }

  // A short search that begins with a better solution, whose costs exclude more, proves what a long
  // one does not. So it is tried again whenever the gap is half of what it was.
  void finish_if_close()
  {
    if (!m_can_search_whole_program || is_done() || gap() > m_close_gap)
      return;
    m_close_gap = gap() / 2;
    search_whole_program(2000, 0.2);
  }

  // what the relaxation of the whole program takes at most
  int nodes_of_relaxation() const { return 20 + m_program.number_of_variables() / 50; }

  // Strengthens the relaxation by cutting planes as long as this pays. Says if there was time for
  // it, so that a search in the whole program may have success, too.
  bool solve_relaxation()
  {
    constexpr double least_gain = 0.0005;
    const Box everything = whole_program(Box::Rows::EXACT);
    for (double previous = 0;;) {
      Box_solution solution = solve_in_box<Traits>(m_program, everything, m_incumbent.values(),
                                                   effort(nodes_of_relaxation(), 0.1),
                                                   Domain::REALS);
      m_monitor.check("quantize");
      if (solution.x.empty())
        return false;
      m_relaxation = solution.x;
      raise_bound(solution.bound);
      if (seconds_left() < 0.8 * m_seconds)
        return false;
      if (demand_index_rows(m_program, m_relaxation, everything.longest_path) > 0)
        continue;
      if (everything.covers_are_soft || m_program.index_rows_are_soft || is_done() ||
          m_bound - previous <= least_gain * m_bound)
        return true;
      previous = m_bound;
      solution.x.insert(solution.x.end(), solution.indicators.begin(), solution.indicators.end());
      if (strengthen_relaxation(m_program, solution.x) == 0)
        return true;
    }
  }

  void raise_bound(double bound)
  {
    if (bound <= m_bound)
      return;
    m_bound = bound;
    report();
  }

  std::vector<Loop> loops_of(const Incumbent& incumbent) const
  {
    return dual_loops(m_t_mesh, m_graph, incumbent.values());
  }

  // keeps variables at 0 that are 0 in the solution and in the relaxation, and paths short
  void restrict_to_support(Box& box, const Incumbent& incumbent) const
  {
    constexpr double positive = 1e-6;
    if (m_relaxation.empty())
      return;
    box.longest_path = 4;
    for (int v = 0; v < m_program.number_of_variables(); ++v)
      if (m_relaxation[v] < positive && incumbent.values()[v] == 0)
        box.low[v] = box.high[v] = 0;
  }

  // searches where the solution and the relaxation differ
  void search_disagreement(int nodes)
  {
    constexpr double tolerance = 1e-6;
    if (m_relaxation.empty() || is_done())
      return;
    Box box(m_program.number_of_variables(), Box::Rows::ALL);
    for (int v = 0; v < m_program.number_of_variables(); ++v)
      if (const int x = m_incumbent.values()[v]; std::abs(m_relaxation[v] - x) < tolerance)
        box.low[v] = box.high[v] = x;
    search(box, effort(nodes, 2 * small_share));
  }

  // Improves another solution, into which many exchanges have turned the best one, and searches
  // where both differ.
  void search_elsewhere(int nodes)
  {
    constexpr double slack = 1.1;
    constexpr int exchanges = 30;
    m_exchange.start_from(loops_of(m_incumbent));
    for (int i = 0; i < exchanges; ++i)
      m_exchange.step(slack * m_incumbent.objective());
    Incumbent other(m_t_mesh, m_paper, m_graph, m_program, m_limited_monitor);
    if (!m_program.mirrored.empty() || !other.improve_by(m_exchange.values()))
      return;
    search_neighbourhoods(other, nodes);
    Box between(m_program.number_of_variables(), Box::Rows::ALL);
    for (int v = 0; v < m_program.number_of_variables(); ++v)
      if (const int x = other.values()[v]; m_incumbent.values()[v] == x)
        between.low[v] = between.high[v] = x;
    if (m_incumbent.improve_by(other.values()))
      report_improvement();
    search(between, effort(nodes, small_share));
  }

  // Searches in neighbourhoods of all kinds, some at a time; ends when many in a row bring nothing.
  void search_neighbourhoods(Incumbent& incumbent, int nodes)
  {
    const int patience = 20 + int(m_paper.singularities.size()) / 4;
    for (int failures = 0; !is_done() && failures < patience;) {
      std::vector<Kind> kinds;
      std::vector<Box> boxes;
      while (int(boxes.size()) < m_options.concurrent_searches) {
        kinds.push_back(m_schedule.next());
        boxes.push_back(neighbourhood(kinds.back(), m_schedule.size(kinds.back()), incumbent));
        m_schedule.begin(kinds.back(), boxes.back().number_of_free_variables());
      }
      const std::vector<int> start = incumbent.values();
      const auto solutions = solve_in_boxes<Traits>(m_program, boxes, start,
                                                    effort(nodes, small_share));
      m_monitor.report("quantize", 1 - (std::max)(0., seconds_left() / m_seconds));
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const bool improved = take_over(solutions[i], start, incumbent);
        m_schedule.end(kinds[i], boxes[i].number_of_free_variables(),
                       solutions[i].status == Box_solution::OPTIMAL, improved);
        failures = improved ? 0 : failures + 1;
      }
      if (failures > patience / 4 && &incumbent == &m_incumbent)
        finish_if_close();
    }
  }

  Box neighbourhood(Kind kind, int size, const Incumbent& incumbent)
  {
    using Schedule = Neighbourhood_schedule;
    Box box = kind == Schedule::WITHOUT_LOOPS
                  ? without_loops(size, incumbent)
                  : m_neighbourhoods.near(centre(kind, incumbent), size, incumbent.values());
    if (kind != Schedule::WITHOUT_LOOPS && kind != Schedule::REGION)
      m_neighbourhoods.free_loops_through(box, incumbent.values());
    free_mirrored(m_program, box);
    if (kind == Schedule::SINGULARITY_ON_SUPPORT || kind == Schedule::LOOP_ON_SUPPORT)
      restrict_to_support(box, incumbent);
    return box;
  }

  std::vector<int> centre(Kind kind, const Incumbent& incumbent)
  {
    const auto choose = [this](std::size_t n) { return m_random() % n; };
    std::vector<int> result;
    if (kind == Neighbourhood_schedule::LOOP || kind == Neighbourhood_schedule::LOOP_ON_SUPPORT)
      result = m_neighbourhoods.along_a_loop(incumbent.values(), choose);
    if (result.empty())
      result.push_back(m_paper.singularities[choose(m_paper.singularities.size())]);
    return result;
  }

  // Other loops may take the place of `count` loops anywhere. Few rows are open then, so that this
  // is solved fast although all variables are free.
  Box without_loops(int count, const Incumbent& incumbent)
  {
    m_exchange.start_from(loops_of(incumbent));
    m_exchange.ruin(std::size_t(count));
    Box box(m_exchange.values());
    for (std::size_t v = 0; v < box.high.size(); ++v)
      box.high[v] = incumbent.values()[v] + 1;
    return box;
  }

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
    if (m_incumbent.values().empty()) {
      result.reason = Squeezed_singularities(m_t_mesh).first_place();
      return result;
    }
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
  Monitor m_limited_monitor; // until the first solution for that, then for the search
  Real_timer m_timer;
  double m_seconds; // for the search
  double m_end;     // of it, by the timer
  const Quantization_program m_paper;
  const Dual_graph m_graph;
  Reduced_program m_program;
  Incumbent m_incumbent;
  Neighbourhoods m_neighbourhoods;
  Neighbourhood_schedule m_schedule;
  Loop_exchange m_exchange;
  std::vector<double> m_relaxation;
  std::mt19937 m_random;
  bool m_can_search_whole_program = false; // as there is time for its relaxation
  bool m_is_exhausted = false;
  double m_close_gap = 0.05; // half of that of the last search for the proof
  double m_bound = 0;        // all costs are positive
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_SEARCH_H
