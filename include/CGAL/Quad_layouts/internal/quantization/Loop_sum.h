// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_SUM_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_SUM_H

#include <CGAL/Quad_layouts/internal/quantization/Loop_search.h>
#include <CGAL/Quad_layouts/internal/quantization/evaluate_program.h>

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
  explicit Loop_sum(int variables) : m_x(variables, 0) {}

  const std::vector<int>& values() const { return m_x; }

  void add(Loop loop)
  {
    count(loop, 1);
    m_loops.push_back(std::move(loop));
  }

  // adds cheapest loops, where passing v costs `price[v]`, until all rows of `program` hold; of
  // soft index rows, all that can
  void complete(const Reduced_program& program, const std::vector<double>& price,
                Loop_search& search)
  {
    const Program_evaluation rows(program, m_x);
    satisfy_covers(program, price, search);
    for (bool changed = true; changed;) {
      changed = false;
      const auto separate = [&](const Reduced_program::Set& set) {
        if (set.empty())
          return;
        add(search.cheapest_loop(set, price));
        changed = true;
      };
      for (const auto& row : program.index_rows)
        separate(rows.separating_set(row));
      for (const auto& cut : program.cuts)
        if (!rows.is_satisfied(cut))
          separate(cut.variables);
    }
  }

  // takes away loops, expensive ones first, as long as this makes the objective smaller and keeps
  // all rows
  void prune(const Reduced_program& program)
  {
    const Program_evaluation rows(program, m_x);
    const auto cost = [&](const Loop& loop) {
      return std::accumulate(loop.begin(), loop.end(), 0.,
                             [&](double c, int v) { return c + program.cost[v]; });
    };
    std::stable_sort(m_loops.begin(), m_loops.end(),
                     [&](const Loop& a, const Loop& b) { return cost(a) > cost(b); });
    std::vector<Loop> kept;
    double objective = rows.objective();
    for (Loop& loop : m_loops) {
      count(loop, -1);
      if (rows.is_feasible() && rows.satisfies_cuts() && rows.objective() < objective) {
        objective = rows.objective();
        continue;
      }
      count(loop, 1);
      kept.push_back(std::move(loop));
    }
    m_loops = std::move(kept);
  }

private:
  void count(const Loop& loop, int n)
  {
    for (int v : loop)
      m_x[v] += n;
  }

  // a variable is the cheaper the more open rows it would satisfy
  void satisfy_covers(const Reduced_program& program, const std::vector<double>& price,
                      Loop_search& search)
  {
    const Program_evaluation rows(program, m_x);
    std::vector<int> open_rows(m_x.size(), 0);
    std::vector<char> is_open(program.covers.size(), 0);
    const auto update = [&](std::size_t k, bool open) {
      if (open == bool(is_open[k]))
        return;
      is_open[k] = open;
      for (int v : program.covers[k])
        open_rows[v] += open ? 1 : -1;
    };
    for (std::size_t k = 0; k < program.covers.size(); ++k)
      update(k, !rows.is_positive(program.covers[k]));
    std::vector<double> shared_price(price.size());
    for (std::size_t k = 0; k < program.covers.size(); ++k) {
      if (!is_open[k])
        continue;
      for (std::size_t v = 0; v < price.size(); ++v)
        shared_price[v] = price[v] / (1 + open_rows[v]);
      add(search.cheapest_loop(program.covers[k], shared_price));
      for (std::size_t j = k; j < program.covers.size(); ++j)
        update(j, !rows.is_positive(program.covers[j]));
    }
  }

  std::vector<Loop> m_loops;
  std::vector<int> m_x;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_SUM_H
