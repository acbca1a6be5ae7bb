// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_STRENGTHEN_RELAXATION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_STRENGTHEN_RELAXATION_H

#include <CGAL/Quad_layouts/internal/quantization/Reduced_program.h>
#include <CGAL/Quad_layouts/internal/quantization/zero_half_cuts.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The rows of a reduced program that make cutting planes for it: columns are its variables, then
// its indicators. Of indicators (3), the row that makes them 1 takes part, the other one with its
// arbitrary constant does not.
class Strengthening_rows
{
public:
  explicit Strengthening_rows(const Reduced_program& program)
    : m_program(program), m_is_used(program.indicators.size(), 0)
  {
    for (const auto& equation : program.equations) {
      add_at_most(equation, 0);
      add_at_least(equation, 0);
    }
    for (const auto& cover : program.covers)
      add_at_least(sum_of(cover, {}), 1);
    for (const auto& cut : program.cuts)
      if (cut.is_exact)
        add_at_least(sum_of(cut.variables, cut.indicators), 1);
    for (const auto& row : program.index_rows)
      if (!row.is_lazy)
        add_index_row(row);
    for (const auto& row : program.strengthening)
      m_rows.push_back(row);
  }

  const std::vector<Integer_row>& rows() const { return m_rows; }

private:
  using Terms = std::vector<std::pair<int, int>>;

  int column(int indicator) const { return m_program.number_of_variables() + indicator; }

  void add_at_most(Terms terms, int bound) { m_rows.push_back({std::move(terms), bound}); }

  void add_at_least(Terms terms, int bound)
  {
    for (auto& term : terms)
      term.second = -term.second;
    add_at_most(std::move(terms), -bound);
  }

  Terms sum_of(const Reduced_program::Set& variables, const std::vector<int>& indicators)
  {
    Terms result;
    for (int v : variables)
      result.emplace_back(v, 1);
    for (int k : indicators) {
      use(k);
      result.emplace_back(column(k), 1);
    }
    return result;
  }

  void add_index_row(const Reduced_program::Index_row& row)
  {
    Terms terms;
    for (const auto& term : row.terms) {
      use(term.first);
      terms.emplace_back(column(term.first), term.second);
    }
    std::sort(terms.begin(), terms.end());
    add_at_most(terms, row.high - row.base);
    add_at_least(std::move(terms), row.low - row.base);
  }

  // adds what is known about an indicator
  void use(int k)
  {
    if (m_is_used[k])
      return;
    m_is_used[k] = 1;
    add_at_most({{column(k), 1}}, 1);
    add_at_least(sum_of(m_program.indicators[k].path, {k}), 1);
  }

  const Reduced_program& m_program;
  std::vector<char> m_is_used;
  std::vector<Integer_row> m_rows;
};

// adds rows to `program` that all its solutions satisfy and the solution x of its relaxation does
// not, and drops those where x has slack; returns how many were added. `x` begins with the
// variables and ends with the indicators.
inline int strengthen_relaxation(Reduced_program& program, const std::vector<double>& x)
{
  constexpr double tolerance = 1e-6;
  constexpr std::size_t most_cuts = 150;
  constexpr int random_orders = 2;
  auto& rows = program.strengthening;
  rows.erase(std::remove_if(rows.begin(), rows.end(),
                            [&](const Integer_row& row) { return row.slack(x) > tolerance; }),
             rows.end());
  const Strengthening_rows all(program);
  const auto cuts = Zero_half_separation(all.rows(), x).cuts(most_cuts, random_orders);
  rows.insert(rows.end(), cuts.begin(), cuts.end());
  return int(cuts.size());
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_STRENGTHEN_RELAXATION_H
