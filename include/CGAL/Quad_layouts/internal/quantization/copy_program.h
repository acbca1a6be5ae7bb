// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_COPY_PROGRAM_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_COPY_PROGRAM_H

#include <CGAL/Quad_layouts/internal/quantization/Program_search.h>

#include <CGAL/Mixed_integer_program_traits.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// CGAL stores coefficients by address; their order must not depend on it.
template <class Expression>
Program_search::Terms sorted_terms(const Expression& expression)
{
  Program_search::Terms terms;
  for (const auto& term : expression.coefficients())
    terms.emplace_back(term.first->index(), double(term.second));
  std::sort(terms.begin(), terms.end());
  return terms;
}

// CGAL has a large number for infinity.
template <class FT>
double with_true_infinity(FT bound)
{
  using Variable = typename CGAL::Mixed_integer_program_traits<FT>::Variable;
  constexpr double infinity = (std::numeric_limits<double>::infinity)();
  return bound >= Variable::infinity()    ? infinity
         : bound <= -Variable::infinity() ? -infinity
                                          : double(bound);
}

// writes a program of CGAL into an empty one
template <class FT>
void copy_program(const CGAL::Mixed_integer_program_traits<FT>& from, Program_search& to)
{
  using Program = CGAL::Mixed_integer_program_traits<FT>;
  FT low, high;
  for (const auto* v : from.variables()) {
    v->get_bounds(low, high);
    const bool is_binary = v->variable_type() == Program::Variable::BINARY;
    to.columns.push_back({is_binary ? 0. : with_true_infinity(low),
                          is_binary ? 1. : with_true_infinity(high),
                          v->variable_type() != Program::Variable::CONTINUOUS});
  }
  for (const auto* c : from.constraints()) {
    c->get_bounds(low, high);
    to.rows.push_back({with_true_infinity(low - c->offset()),
                       with_true_infinity(high - c->offset()), sorted_terms(*c)});
  }
  const auto& objective = *from.objective();
  to.maximize = objective.sense() == Program::Linear_objective::MAXIMIZE;
  to.objective = sorted_terms(objective);
  to.objective_offset = double(objective.offset());
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_COPY_PROGRAM_H
