// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_PROGRAM_SEARCH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_PROGRAM_SEARCH_H

#include <algorithm>
#include <chrono>
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

  // is called when a search begins
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

private:
  Clock::time_point m_end;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_PROGRAM_SEARCH_H
