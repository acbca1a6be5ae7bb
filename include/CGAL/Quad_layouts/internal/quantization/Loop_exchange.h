// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_EXCHANGE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_EXCHANGE_H

#include <CGAL/Quad_layouts/internal/quantization/Loop_sum.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Improves a sum of dual loops by ruin and recreate (Schrimpf et al. 2000): a few loops that have
// to do with each other are taken away, and the rows that this opens are satisfied by cheapest
// loops again, for prices that vary at random.
class Loop_exchange
{
public:
  Loop_exchange(const Reduced_program& program, const Dual_graph& graph)
    : m_program(program), m_search(graph), m_current(program)
  {
  }

  // goes on from the sum of these
  void start_from(std::vector<Loop> loops) { m_current.replace(std::move(loops)); }

  const std::vector<int>& values() const { return m_current.values(); }
  double objective() const { return m_current.rows().objective(); }

  // exchanges some loops, and says if the result is kept: not if the objective is above `limit`
  // then, unless there were new cuts to satisfy
  bool step(double limit)
  {
    m_current.update_cuts();
    const bool was_feasible = m_current.rows().is_feasible();
    std::vector<Loop> before = m_current.loops();
    ruin(1 + random_below(most_loops));
    recreate();
    const bool is_kept = m_current.rows().is_feasible() && (!was_feasible || objective() <= limit);
    if (!is_kept)
      m_current.replace(std::move(before));
    return is_kept;
  }

  // takes away up to `count` loops: one, and some that pass a row of one that was taken away
  void ruin(std::size_t count)
  {
    if (m_current.loops().empty())
      return;
    const std::size_t most_trials = 4 * count;
    Loop near = take_away(random_below(m_current.loops().size()));
    for (std::size_t trial = 1; --count > 0 && trial < most_trials; ++trial) {
      const auto candidates = loops_through(variable_near(random_of(near)));
      if (candidates.empty())
        continue;
      Loop taken = take_away(random_of(candidates));
      if (random() < 0.5)
        near = std::move(taken);
    }
  }

private:
  static constexpr std::size_t most_loops = 5; // that one step takes away

  // in [0, 1), the same on all machines
  double random() { return m_random() / 4294967296.; }
  std::size_t random_below(std::size_t n) { return m_random() % n; }
  template <class T>
  T random_of(const std::vector<T>& container)
  {
    return container[random_below(container.size())];
  }

  Loop take_away(std::size_t k)
  {
    Loop loop = m_current.loops()[k];
    m_current.remove(k);
    return loop;
  }

  // some variable of some row of v
  int variable_near(int v)
  {
    const auto& families = m_current.rows().families_of(v);
    return families.empty() ? v : random_of(m_current.rows().family(random_of(families)));
  }

  std::vector<std::size_t> loops_through(int v) const
  {
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < m_current.loops().size(); ++k)
      if (const Loop& loop = m_current.loops()[k];
          std::find(loop.begin(), loop.end(), v) != loop.end())
        result.push_back(k);
    return result;
  }

  void recreate()
  {
    constexpr double price_spread = 0.5, weight_spread = 0.3;
    std::vector<double> price = m_program.cost;
    for (double& p : price)
      p *= 1 + price_spread * (2 * random() - 1);
    m_current.complete(price, m_search,
                       [&](const Reduced_program::Set& set) { return some_of(set); });
    m_current.prune([&](std::size_t) { return 1 + weight_spread * (2 * random() - 1); });
  }

  // each of the variables costs a search
  Reduced_program::Set some_of(Reduced_program::Set set)
  {
    constexpr std::size_t most_variables = 6;
    for (std::size_t i = 0; i < most_variables && i < set.size(); ++i)
      std::swap(set[i], set[i + random_below(set.size() - i)]);
    set.resize((std::min)(set.size(), most_variables));
    return set;
  }

  const Reduced_program& m_program;
  Loop_search m_search;
  Loop_sum m_current;
  std::mt19937 m_random;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LOOP_EXCHANGE_H
