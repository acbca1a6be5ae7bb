// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ROW_COUNTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ROW_COUNTS_H

#include <CGAL/Quad_layouts/internal/quantization/evaluate_program.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Values of the variables of a reduced program and how its rows fare, kept up to date while the
// values change by one variable at a time. `Program_evaluation` looks at all rows instead.
//
// Covers, paths of indicators and cuts are the same thing here: *families* whose *support* is the
// number of their positive variables (for cuts, also of their indicators that are 1), and that are
// *open* without any.
class Row_counts
{
public:
  explicit Row_counts(const Reduced_program& program)
    : m_program(program), m_x(program.number_of_variables(), 0),
      m_families(program.number_of_variables()), m_open_rows(program.number_of_variables(), 0),
      m_index_terms(program.indicators.size()), m_cuts_of_indicator(program.indicators.size())
  {
    for (const auto& cover : program.covers)
      add_family(cover);
    for (const auto& indicator : program.indicators)
      add_family(indicator.path);
    for (std::size_t r = 0; r < program.index_rows.size(); ++r) {
      m_index.push_back(program.index_rows[r].base);
      for (const auto& term : program.index_rows[r].terms) {
        m_index_terms[term.first].emplace_back(int(r), term.second);
        m_index.back() += term.second;
      }
      m_excess += std::abs(excess_of(int(r)));
    }
    for (int c = 0; c < number_of_covers(); ++c)
      open_row(c, 1);
    update_cuts();
  }

  // to be called when the program has new cuts
  void update_cuts()
  {
    for (; m_known_cuts < program().cuts.size(); ++m_known_cuts) {
      const auto& cut = program().cuts[m_known_cuts];
      const int f = add_family(cut.variables);
      for (int v : cut.variables)
        m_support[f] += m_x[v] > 0;
      for (int k : cut.indicators) {
        m_cuts_of_indicator[k].push_back(f);
        m_support[f] += is_merged(k);
      }
      if (m_support[f] == 0)
        open_row(f, 1);
    }
  }

  Row_counts(const Row_counts&) = delete;

  const Reduced_program& program() const { return m_program; }
  const std::vector<int>& values() const { return m_x; }
  const std::vector<int>& families_of(int v) const { return m_families[v]; }
  const Reduced_program::Set& family(int f) const
  {
    if (f < number_of_covers())
      return program().covers[f];
    f -= number_of_covers();
    if (f < int(program().indicators.size()))
      return program().indicators[f].path;
    return program().cuts[f - program().indicators.size()].variables;
  }

  bool is_merged(int indicator) const { return is_open(number_of_covers() + indicator); }
  bool is_open(int f) const { return m_support[f] == 0; }
  int number_of_families() const { return int(m_support.size()); }
  // covers and cuts
  bool is_row(int f) const
  {
    return f < number_of_covers() || f >= number_of_covers() + int(program().indicators.size());
  }
  // how many open covers and cuts variable v would close
  int open_rows_of(int v) const { return m_open_rows[v]; }

  // of row r; negative below, positive above, 0 inside its range
  int excess_of(int r) const
  {
    const auto& row = program().index_rows[r];
    return excess(m_index[r], row.low, row.high);
  }

  // the variables of which one must become positive to bring the index of row r nearer to its
  // range; empty if it is inside, or if there are none
  Reduced_program::Set separating_set(int r) const
  {
    const int offence = excess_of(r);
    Reduced_program::Set result;
    if (offence == 0)
      return result;
    for (const auto& term : program().index_rows[r].terms)
      if ((term.second > 0) == (offence > 0) && is_merged(term.first)) {
        const auto& path = program().indicators[term.first].path;
        result.insert(result.end(), path.begin(), path.end());
      }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  bool is_feasible() const
  {
    return m_open == 0 && (m_excess == 0 || program().index_rows_are_soft);
  }
  double objective() const { return m_cost + program().penalty * m_excess; }

  // adds n to variable v
  void change(int v, int n)
  {
    const bool was_positive = m_x[v] > 0;
    m_x[v] += n;
    m_cost += n * program().cost[v];
    if (was_positive != (m_x[v] > 0))
      for (int f : m_families[v])
        change_support(f, was_positive ? -1 : 1);
  }

  void assign(const std::vector<int>& x)
  {
    for (std::size_t v = 0; v < x.size(); ++v)
      if (x[v] != m_x[v])
        change(int(v), x[v] - m_x[v]);
  }

private:
  int number_of_covers() const { return int(m_program.covers.size()); }

  int add_family(const Reduced_program::Set& variables)
  {
    const int f = int(m_support.size());
    m_support.push_back(0);
    for (int v : variables)
      m_families[v].push_back(f);
    return f;
  }

  void change_support(int f, int n)
  {
    const bool was_open = is_open(f);
    m_support[f] += n;
    if (was_open == is_open(f))
      return;
    if (is_row(f))
      open_row(f, was_open ? -1 : 1);
    else
      merge(f - number_of_covers(), was_open ? -1 : 1);
  }

  void open_row(int f, int n)
  {
    m_open += n;
    for (int v : family(f))
      m_open_rows[v] += n;
  }

  void merge(int indicator, int n)
  {
    for (const auto& term : m_index_terms[indicator]) {
      m_excess -= std::abs(excess_of(term.first));
      m_index[term.first] += n * term.second;
      m_excess += std::abs(excess_of(term.first));
    }
    for (int f : m_cuts_of_indicator[indicator])
      change_support(f, n);
  }

  const Reduced_program& m_program;
  std::vector<int> m_x;
  std::vector<std::vector<int>> m_families;                    // per variable
  std::vector<int> m_open_rows;                                // per variable
  std::vector<std::vector<std::pair<int, int>>> m_index_terms; // per indicator: row, coefficient
  std::vector<std::vector<int>> m_cuts_of_indicator;
  std::vector<int> m_support; // per family
  std::vector<int> m_index;   // per index row
  std::size_t m_known_cuts = 0;
  int m_open = 0, m_excess = 0;
  double m_cost = 0;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ROW_COUNTS_H
