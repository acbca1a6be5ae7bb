// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_EVALUATE_PROGRAM_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_EVALUATE_PROGRAM_H

#include <CGAL/Quad_layouts/internal/quantization/Reduced_program.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// How far a value is outside a range: negative below, positive above, 0 inside.
inline int excess(int value, int low, int high)
{
  return value < low ? value - low : value > high ? value - high : 0;
}

// The rows of a reduced program at given values of its variables.
class Program_evaluation
{
public:
  Program_evaluation(const Reduced_program& program, const std::vector<int>& x)
    : m_program(program), m_x(x)
  {
  }

  bool is_positive(const Reduced_program::Set& set) const
  {
    return std::any_of(set.begin(), set.end(), [&](int v) { return m_x[v] > 0; });
  }

  bool is_merged(int indicator) const { return !is_positive(m_program.indicators[indicator].path); }

  bool is_satisfied(const Reduced_program::Cut& cut) const
  {
    return is_positive(cut.variables) || std::any_of(cut.indicators.begin(), cut.indicators.end(),
                                                     [&](int k) { return is_merged(k); });
  }

  int index_excess(const Reduced_program::Index_row& row) const
  {
    int index = row.base;
    for (const auto& term : row.terms)
      if (is_merged(term.first))
        index += term.second;
    return excess(index, row.low, row.high);
  }

  int total_index_excess() const
  {
    int result = 0;
    for (const auto& row : m_program.index_rows)
      result += std::abs(index_excess(row));
    return result;
  }

  // holds for all sums of dual loops
  bool is_consistent() const { return satisfies(m_program.equations); }

  bool grants_wishes() const
  {
    const auto first = m_program.cuts.begin();
    return satisfies(m_program.mirrored) &&
           std::all_of(first, first + m_program.wished_cuts,
                       [&](const auto& cut) { return is_satisfied(cut); });
  }

  bool satisfies_cuts() const
  {
    return std::all_of(m_program.cuts.begin(), m_program.cuts.end(),
                       [&](const auto& cut) { return is_satisfied(cut); });
  }

  // says if all other rows hold
  bool is_feasible() const
  {
    return std::all_of(m_program.covers.begin(), m_program.covers.end(),
                       [&](const auto& cover) { return is_positive(cover); }) &&
           (m_program.index_rows_are_soft || total_index_excess() == 0);
  }

  // Equation (9), without the penalty for the rows that are violated in every quantization
  double objective() const
  {
    double result = 0;
    for (std::size_t v = 0; v < m_x.size(); ++v)
      result += m_program.cost[v] * m_x[v];
    return result + m_program.penalty * total_index_excess();
  }

private:
  bool satisfies(const std::vector<std::vector<std::pair<int, int>>>& equations) const
  {
    return std::all_of(equations.begin(), equations.end(), [&](const auto& equation) {
      return std::accumulate(equation.begin(), equation.end(), 0L, [&](long sum, const auto& term) {
               return sum + long(term.second) * m_x[term.first];
             }) == 0;
    });
  }

  const Reduced_program& m_program;
  const std::vector<int>& m_x;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_EVALUATE_PROGRAM_H
