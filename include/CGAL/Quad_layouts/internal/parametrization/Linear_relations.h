// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_LINEAR_RELATIONS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_LINEAR_RELATIONS_H

#include <CGAL/Quad_layouts/exceptions.h>

#include <boost/rational.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Homogeneous linear equations with rational coefficients, solved exactly: as many unknowns as
// there are independent equations become combinations of the other ones, which are free (compare
// Mandad and Campen, "Exact constraint satisfaction for truly seamless parametrization", 2019).
//
// Combinations are kept short: the next to become one is always the unknown whose substitution adds
// fewest terms to the others (Markowitz, "The elimination form of the inverse and its application
// to linear programming", 1957).
class Linear_relations
{
public:
  using Number = boost::rational<std::int64_t>;
  using Combination = std::map<int, Number>; // of unknowns; no number is 0

  explicit Linear_relations(int number_of_unknowns)
    : m_row(number_of_unknowns, -1), m_rows_with(number_of_unknowns),
      m_equations_with(number_of_unknowns, 0)
  {
  }

  // demands that the combination is 0
  void add(Combination equation)
  {
    const int row = int(m_rows.size());
    m_rows.push_back(std::move(equation));
    m_is_solved.push_back(0);
    for (const auto& term : m_rows[row])
      enter(term.first, row);
  }

  // solves the equations
  void finish()
  {
    using Entry = std::pair<Cost, int>; // of a row
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> next;
    for (int row = 0; row < int(m_rows.size()); ++row)
      if (!m_rows[row].empty())
        next.emplace(cost(row), row);
    while (!next.empty()) {
      const auto [known_cost, row] = next.top();
      next.pop();
      if (m_rows[row].empty()) // it follows from others
        continue;
      if (const Cost now = cost(row); now > known_cost)
        next.emplace(now, row);
      else
        determine(row);
    }
  }

  bool is_free(int unknown) const { return m_row[unknown] < 0; }
  // of an unknown that is not free
  const Combination& combination(int unknown) const { return m_rows[m_row[unknown]]; }

  // the least common multiple of all denominators: multiples of it for the free unknowns make all
  // unknowns integers
  std::int64_t common_denominator() const
  {
    std::int64_t result = 1;
    for (const Combination& row : m_rows)
      for (const auto& term : row)
        result = checked(std::lcm(result, term.second.denominator())).numerator();
    return result;
  }

private:
  // What it costs to let an unknown be determined by a row: large coefficients, as others grow by
  // them, and how many terms the rows get at most: those that are not solved yet, which hand them
  // on, and all. Halves and doubles are not large: were they avoided, combinations would get long.
  using Cost = std::tuple<std::int64_t, std::size_t, std::size_t>;

  Cost cost(const Combination& equation, const Combination::value_type& term) const
  {
    const std::size_t others = equation.size() - 1, rows = m_rows_with[term.first].size() - 1;
    return {(std::max)(std::int64_t(2), size(term.second)),
            others * (m_equations_with[term.first] - 1), others * rows};
  }

  Combination::const_iterator pivot(const Combination& equation) const
  {
    return std::min_element(equation.begin(), equation.end(), [&](const auto& a, const auto& b) {
      return cost(equation, a) < cost(equation, b);
    });
  }

  Cost cost(int row) const { return cost(m_rows[row], *pivot(m_rows[row])); }

  void enter(int unknown, int row)
  {
    m_rows_with[unknown].insert(row);
    m_equations_with[unknown] += !m_is_solved[row];
  }

  void leave(int unknown, int row)
  {
    m_rows_with[unknown].erase(row);
    m_equations_with[unknown] -= !m_is_solved[row];
  }

  // lets the equation of a row determine an unknown, and substitutes that everywhere
  void determine(int row)
  {
    Combination& equation = m_rows[row];
    const auto term = pivot(equation);
    const int unknown = term->first;
    const Number factor = -1 / term->second;
    for (auto& other : equation) {
      other.second = checked(other.second * factor);
      --m_equations_with[other.first];
    }
    equation.erase(term);
    m_is_solved[row] = 1;
    m_row[unknown] = row;
    leave(unknown, row);
    const std::set<int> rows = m_rows_with[unknown];
    for (const int other : rows)
      substitute(unknown, other);
  }

  // replaces a determined unknown in a row
  void substitute(int unknown, int row)
  {
    Combination& terms = m_rows[row];
    const auto replaced = terms.find(unknown);
    const Number factor = replaced->second;
    terms.erase(replaced);
    leave(unknown, row);
    for (const auto& term : combination(unknown)) {
      const auto [sum, is_new] = terms.emplace(term.first, 0);
      sum->second = checked(sum->second + checked(factor * term.second));
      if (is_new)
        enter(term.first, row);
      else if (sum->second == 0) {
        terms.erase(sum);
        leave(term.first, row);
      }
    }
  }

  static std::int64_t size(const Number& x)
  {
    return (std::max)(std::abs(x.numerator()), x.denominator());
  }

  // throws if further sums and products of such numbers could overflow
  static Number checked(const Number& x)
  {
    constexpr std::int64_t largest = std::int64_t(1) << 30;
    if (size(x) > largest)
      throw Stage_failure("seamless parametrization: the relations along the seams need numbers "
                          "that are too large");
    return x;
  }

  std::vector<Combination> m_rows; // what is 0 or, once solved, what the unknown of the row equals
  std::vector<char> m_is_solved;   // per row
  std::vector<int> m_row;          // per unknown the row that determines it, -1 if none does
  std::vector<std::set<int>> m_rows_with; // per unknown those that it is a term of
  std::vector<int> m_equations_with;      // the number of those that are not solved
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_LINEAR_RELATIONS_H
