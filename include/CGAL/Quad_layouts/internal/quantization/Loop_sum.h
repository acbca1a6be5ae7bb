// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_SUM_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_SUM_H

#include <CGAL/Quad_layouts/internal/quantization/Loop_search.h>
#include <CGAL/Quad_layouts/internal/quantization/Row_counts.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A consistent quantization as a sum of dual loops.
class Loop_sum
{
public:
  explicit Loop_sum(const Reduced_program& program)
    : m_rows(program), m_shared_price(program.number_of_variables())
  {
  }

  const Row_counts& rows() const { return m_rows; }
  const std::vector<int>& values() const { return m_rows.values(); }
  const std::vector<Loop>& loops() const { return m_loops; }

  void add(Loop loop)
  {
    count(loop, 1);
    m_loops.push_back(std::move(loop));
  }

  // takes away loop k; the last one gets its number
  void remove(std::size_t k)
  {
    count(m_loops[k], -1);
    m_loops[k] = std::move(m_loops.back());
    m_loops.pop_back();
  }

  void replace(std::vector<Loop> loops)
  {
    std::vector<int> x(values().size(), 0);
    for (const Loop& loop : loops)
      for (int v : loop)
        ++x[v];
    m_rows.assign(x);
    m_loops = std::move(loops);
  }

  // to be called when the program has new cuts
  void update_cuts() { m_rows.update_cuts(); }

  // Adds cheapest loops, where passing v costs `price[v]`, until all rows hold that can; of a row,
  // `choose(set)` returns the variables that are tried. A variable is the cheaper the more rows it
  // would satisfy.
  template <class Choose>
  void complete(const std::vector<double>& price, Loop_search& search, const Choose& choose)
  {
    const auto satisfy = [&](const Reduced_program::Set& set) {
      for (std::size_t v = 0; v < price.size(); ++v)
        m_shared_price[v] = price[v] / (1 + m_rows.open_rows_of(int(v)));
      add(search.cheapest_loop(choose(set), m_shared_price));
    };
    for (bool changed = true; changed;) {
      changed = false;
      for (int f = 0; f < m_rows.number_of_families(); ++f)
        if (m_rows.is_row(f) && m_rows.is_open(f) && !m_rows.family(f).empty()) {
          satisfy(m_rows.family(f));
          changed = true;
        }
      for (int r = 0; r < int(m_rows.program().index_rows.size()); ++r)
        if (const auto set = m_rows.separating_set(r); !set.empty()) {
          satisfy(set);
          changed = true;
        }
    }
  }

  // takes away loops, expensive ones first, as long as this makes the objective smaller and keeps
  // all rows; loop k counts as `weight(k)` times as expensive as it is
  template <class Weight>
  void prune(const Weight& weight)
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t k = 0; k < m_loops.size(); ++k)
      order.emplace_back(-weight(k) * cost(m_loops[k]), k);
    std::sort(order.begin(), order.end());
    std::vector<char> is_kept(m_loops.size(), 1);
    double objective = m_rows.objective();
    for (const auto& entry : order) {
      const std::size_t k = entry.second;
      count(m_loops[k], -1);
      is_kept[k] = !m_rows.is_feasible() || !(m_rows.objective() < objective);
      if (is_kept[k])
        count(m_loops[k], 1);
      else
        objective = m_rows.objective();
    }
    std::vector<Loop> kept;
    for (std::size_t k = 0; k < m_loops.size(); ++k)
      if (is_kept[k])
        kept.push_back(std::move(m_loops[k]));
    m_loops = std::move(kept);
  }

private:
  void count(const Loop& loop, int n)
  {
    for (int v : loop)
      m_rows.change(v, n);
  }

  double cost(const Loop& loop) const
  {
    return std::accumulate(loop.begin(), loop.end(), 0.,
                           [&](double c, int v) { return c + m_rows.program().cost[v]; });
  }

  Row_counts m_rows;
  std::vector<Loop> m_loops;
  std::vector<double> m_shared_price;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_SUM_H
