// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ZERO_HALF_CUTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ZERO_HALF_CUTS_H

#include <CGAL/Quad_layouts/internal/quantization/Integer_row.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Looks for violated {0, 1/2}-cuts (Caprara and Fischetti 1996): where half a sum of rows is
// rounded down, nothing is lost for non-negative integers. Sums of rows with odd bound and hardly
// any slack and odd coefficients are found by elimination modulo 2, as in Koster, Zymolka and
// Kutschka (2009).
class Zero_half_separation
{
public:
  // `x`, which must not be negative, is the point to cut off
  Zero_half_separation(const std::vector<Integer_row>& rows, const std::vector<double>& x)
    : m_rows(rows), m_x(x)
  {
    for (std::size_t r = 0; r < rows.size(); ++r)
      if (const double slack = (std::max)(0., rows[r].slack(x)); slack < 1)
        m_tight.push_back({slack, odd_columns(rows[r]), rows[r].bound % 2 != 0, {int(r)}});
  }

  // returns at most `count` cuts, those first that are farthest from x. Columns are eliminated in
  // the order of decreasing values first, then `orders` times in random order.
  std::vector<Integer_row> cuts(std::size_t count, int orders)
  {
    std::vector<int> columns = columns_of_interest();
    eliminate(columns);
    for (; orders > 0; --orders) {
      for (std::size_t i = columns.size(); i > 1; --i)
        std::swap(columns[i - 1], columns[m_random() % i]);
      eliminate(columns);
    }
    return best(count);
  }

private:
  // a sum of rows
  struct Combination
  {
    double slack;
    std::vector<int> odd; // the columns with odd coefficients where x is positive, sorted
    bool bound_is_odd;
    std::vector<int> rows; // sorted

    // more slack than half of the bound's rounding leaves no cut
    bool is_useful() const { return slack < 1; }

    void add(const Combination& other)
    {
      slack += other.slack;
      odd = symmetric_difference(odd, other.odd);
      bound_is_odd = bound_is_odd != other.bound_is_odd;
      rows = symmetric_difference(rows, other.rows);
    }
  };

  static std::vector<int> symmetric_difference(const std::vector<int>& a, const std::vector<int>& b)
  {
    std::vector<int> result;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                  std::back_inserter(result));
    return result;
  }

  std::vector<int> odd_columns(const Integer_row& row) const
  {
    constexpr double positive = 1e-7;
    std::vector<int> result;
    for (const auto& term : row.terms)
      if (term.second % 2 != 0 && m_x[term.first] > positive)
        result.push_back(term.first);
    return result;
  }

  std::vector<int> columns_of_interest() const
  {
    std::vector<int> result;
    for (const Combination& c : m_tight)
      result.insert(result.end(), c.odd.begin(), c.odd.end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    std::stable_sort(result.begin(), result.end(), [&](int i, int j) { return m_x[i] > m_x[j]; });
    return result;
  }

  // One pass over the columns: a combination with an odd coefficient makes it even in all others,
  // and is used up.
  void eliminate(const std::vector<int>& columns)
  {
    std::vector<Combination> combinations = m_tight;
    std::vector<std::vector<int>> users(m_x.size()); // per column; some have become even since
    const auto use = [&](int k, const std::vector<int>& odd) {
      note(combinations[k]);
      for (int j : odd)
        users[j].push_back(k);
    };
    for (int k = 0; k < int(combinations.size()); ++k)
      use(k, combinations[k].odd);
    for (int column : columns) {
      const std::vector<int> odd = odd_ones(combinations, users[column], column);
      if (odd.empty())
        continue;
      const int pivot = pivot_of(combinations, odd);
      for (int k : odd) {
        if (k == pivot)
          continue;
        combinations[k].add(combinations[pivot]);
        if (combinations[k].is_useful())
          use(k, combinations[pivot].odd);
      }
      combinations[pivot].slack = 1; // it is used up
    }
  }

  // those of `candidates`, with repetitions, that have an odd coefficient in `column`, ascending
  static std::vector<int> odd_ones(const std::vector<Combination>& combinations,
                                   std::vector<int> candidates, int column)
  {
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [&](int k) {
                                      const Combination& c = combinations[k];
                                      return !c.is_useful() ||
                                             !std::binary_search(c.odd.begin(), c.odd.end(),
                                                                 column);
                                    }),
                     candidates.end());
    return candidates;
  }

  // the one with the least slack, of those the one with the fewest odd coefficients
  static int pivot_of(const std::vector<Combination>& combinations, const std::vector<int>& odd)
  {
    const auto key = [&](int k) {
      return std::make_pair(combinations[k].slack, combinations[k].odd.size());
    };
    return *std::min_element(odd.begin(), odd.end(), [&](int a, int b) { return key(a) < key(b); });
  }

  // keeps the cut of a combination if x violates it
  void note(const Combination& c)
  {
    constexpr double least_violation = 1e-3;
    double loss = c.slack;
    for (int j : c.odd)
      loss += m_x[j];
    if (!c.bound_is_odd || 1 - loss < 2 * least_violation)
      return;
    Integer_row cut = half(c.rows);
    double norm = 0;
    for (const auto& term : cut.terms)
      norm += double(term.second) * term.second;
    const double distance = -cut.slack(m_x) / std::sqrt(norm);
    m_cuts.emplace(std::move(cut), distance);
  }

  static int floor_of_half(int n) { return (n - (n % 2 != 0 && n < 0)) / 2; }

  Integer_row half(const std::vector<int>& rows) const
  {
    std::map<int, int> coefficients;
    int bound = 0;
    for (int r : rows) {
      for (const auto& term : m_rows[r].terms)
        coefficients[term.first] += term.second;
      bound += m_rows[r].bound;
    }
    Integer_row result{{}, floor_of_half(bound)};
    for (const auto& [column, coefficient] : coefficients)
      if (const int rounded = floor_of_half(coefficient); rounded != 0)
        result.terms.emplace_back(column, rounded);
    return result;
  }

  std::vector<Integer_row> best(std::size_t count) const
  {
    std::vector<std::pair<double, const Integer_row*>> order;
    for (const auto& [cut, distance] : m_cuts)
      order.emplace_back(-distance, &cut);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Integer_row> result;
    for (std::size_t i = 0; i < (std::min)(count, order.size()); ++i)
      result.push_back(*order[i].second);
    return result;
  }

  const std::vector<Integer_row>& m_rows;
  const std::vector<double>& m_x;
  std::vector<Combination> m_tight;
  std::map<Integer_row, double> m_cuts; // and their distances from x
  std::mt19937 m_random;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ZERO_HALF_CUTS_H
