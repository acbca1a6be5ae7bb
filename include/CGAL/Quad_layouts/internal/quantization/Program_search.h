// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_PROGRAM_SEARCH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_PROGRAM_SEARCH_H

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

struct Search_limits
{
  double seconds = (std::numeric_limits<double>::infinity)();
  int nodes = (std::numeric_limits<int>::max)();
  double relative_gap = 0;
};

// What the searches of all solvers have in common: the program in, the solution out.
class Program_search
{
public:
  using Terms = std::vector<std::pair<int, double>>; // column, coefficient
  struct Column
  {
    double low, high;
    bool is_integer;
  };
  struct Row
  {
    double low, high;
    Terms terms;
  };
  enum class Outcome { COMPLETE, LIMIT, ERROR };

  std::vector<Column> columns;
  std::vector<Row> rows;
  Terms objective;
  double objective_offset = 0;
  bool maximize = false;
  std::vector<double> start; // empty, or a value per column
  Search_limits limits;
  std::function<bool()> stop; // must not throw

  Outcome outcome = Outcome::ERROR;
  bool has_solution = false;
  std::vector<double> values;
  double objective_value = 0;
  double bound = 0;
  std::string message;

protected:
  using Clock = std::chrono::steady_clock;

  // Begins a search: forgets the last one, and takes the start solution and programs of constants.
  // Says if there is anything to search.
  bool begin()
  {
    reset();
    take_solution(start);
    if (columns.empty())
      solve_without_columns();
    return !columns.empty();
  }

  void end_at_limit(const char* reason = "limit")
  {
    outcome = Outcome::LIMIT;
    message = reason;
  }

  // solvers cut off what is not better than the known solution
  void limit_bound()
  {
    if (has_solution)
      bound = maximize ? (std::max)(bound, objective_value) : (std::min)(bound, objective_value);
  }

  bool is_stopped() const { return stop && stop(); }

  void reset()
  {
    m_end = limits.seconds < 1e6
                ? Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double>((std::max)(limits.seconds, 0.)))
                : (Clock::time_point::max)();
    outcome = Outcome::ERROR;
    has_solution = false;
    values.assign(columns.size(), 0);
    objective_value = 0;
    bound = (maximize ? 1 : -1) * (std::numeric_limits<double>::infinity)();
    message.clear();
  }

  bool has_time_limit() const { return m_end != (Clock::time_point::max)(); }
  bool is_late() const { return Clock::now() > m_end; }

  double seconds_left() const
  {
    return has_time_limit() ? std::chrono::duration<double>(m_end - Clock::now()).count()
                            : (std::numeric_limits<double>::infinity)();
  }

  // Nodes of large programs can take thousands of iterations of the simplex method. That counts as
  // work, too.
  int iteration_limit(int iterations_per_node) const
  {
    constexpr int most = (std::numeric_limits<int>::max)();
    return limits.nodes < most / iterations_per_node ? limits.nodes * iterations_per_node : most;
  }

  // a program of constants
  void solve_without_columns()
  {
    outcome = Outcome::COMPLETE;
    take_solution({});
    if (has_solution)
      bound = objective_value;
  }

  // keeps `x` if it is feasible and better than what is known; says if it is feasible
  bool take_solution(std::vector<double> x)
  {
    if (x.size() != columns.size() || !round_integers(x) || !is_feasible(x))
      return false;
    const double value = objective_of(x);
    const bool is_better = maximize ? value > objective_value : value < objective_value;
    if (!has_solution || is_better) {
      has_solution = true;
      values = std::move(x);
      objective_value = value;
    }
    return true;
  }

  double objective_of(const std::vector<double>& x) const
  {
    return objective_offset + value_of(objective, x);
  }

  // up to the tolerance
  bool is_as_good(double value) const
  {
    return maximize ? is_in(value, objective_value, value) : is_in(value, value, objective_value);
  }

private:
  static constexpr double tolerance = 1e-6; // of solvers

  // says if the integers of `x` were nearly ones
  bool round_integers(std::vector<double>& x) const
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      if (columns[i].is_integer) {
        const double rounded = std::round(x[i]);
        if (!(std::abs(x[i] - rounded) <= tolerance))
          return false;
        x[i] = rounded;
      }
    return true;
  }

  bool is_feasible(const std::vector<double>& x) const
  {
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!is_in(x[i], columns[i].low, columns[i].high))
        return false;
    return std::all_of(rows.begin(), rows.end(), [&](const Row& row) {
      return is_in(value_of(row.terms, x), row.low, row.high);
    });
  }

  static double value_of(const Terms& terms, const std::vector<double>& x)
  {
    double result = 0;
    for (const auto& term : terms)
      result += term.second * x[term.first];
    return result;
  }

  static bool is_in(double value, double low, double high)
  {
    const double slack = tolerance * (std::max)(1., std::abs(value));
    return value >= low - slack && value <= high + slack;
  }

  Clock::time_point m_end;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_PROGRAM_SEARCH_H
