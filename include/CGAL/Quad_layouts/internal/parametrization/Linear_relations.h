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
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Homogeneous linear equations with rational coefficients, solved exactly: each unknown that an
// equation determines becomes a combination of others, and in the end of free ones only (compare
// Mandad and Campen, "Exact constraint satisfaction for truly seamless parametrization", 2019).
class Linear_relations
{
public:
  using Number = boost::rational<std::int64_t>;
  using Combination = std::map<int, Number>; // of unknowns; no number is 0

  explicit Linear_relations(int number_of_unknowns) : m_position(number_of_unknowns, -1) {}

  // demands that the combination is 0
  void add(Combination equation)
  {
    substitute(equation);
    if (equation.empty())
      return;
    const auto pivot = smallest_term(equation);
    const int unknown = pivot->first;
    const Number factor = -1 / pivot->second;
    equation.erase(pivot);
    for (auto& term : equation)
      term.second = checked(term.second * factor);
    m_position[unknown] = int(m_determined.size());
    m_determined.push_back({unknown, std::move(equation)});
  }

  // lets all combinations be of free unknowns
  void finish()
  {
    for (auto d = m_determined.rbegin(); d != m_determined.rend(); ++d)
      substitute(d->combination);
  }

  bool is_free(int unknown) const { return m_position[unknown] < 0; }
  // of an unknown that is not free
  const Combination& combination(int unknown) const
  {
    return m_determined[m_position[unknown]].combination;
  }

  // the least common multiple of all denominators: multiples of it for the free unknowns make all
  // unknowns integers
  std::int64_t common_denominator() const
  {
    std::int64_t result = 1;
    for (const Determined& d : m_determined)
      for (const auto& term : d.combination)
        result = checked(std::lcm(result, term.second.denominator())).numerator();
    return result;
  }

private:
  struct Determined
  {
    int unknown;
    Combination combination;
  };

  // Coefficients stay small if the pivot is; of equals, the last unknown is determined by the
  // others.
  static Combination::iterator smallest_term(Combination& equation)
  {
    auto result = equation.begin();
    for (auto term = equation.begin(); term != equation.end(); ++term)
      if (size(term->second) <= size(result->second))
        result = term;
    return result;
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

  // Replaces determined unknowns, the one determined first of them first: others in its combination
  // are determined later, so this ends.
  void substitute(Combination& combination) const
  {
    for (;;) {
      int first = -1;
      for (const auto& term : combination)
        if (!is_free(term.first) && (first < 0 || m_position[term.first] < m_position[first]))
          first = term.first;
      if (first < 0)
        return;
      const Number factor = combination[first];
      combination.erase(first);
      for (const auto& term : this->combination(first)) {
        Number& sum = combination[term.first];
        sum = checked(sum + checked(factor * term.second));
        if (sum == 0)
          combination.erase(term.first);
      }
    }
  }

  std::vector<int> m_position; // per unknown, among those that are determined; -1 if free
  std::vector<Determined> m_determined;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_LINEAR_RELATIONS_H
