// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ADAPTED_SEARCH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ADAPTED_SEARCH_H

#include <CGAL/Quad_layouts/internal/quantization/Program_search.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// One search of a solver that only says whether it succeeded. CGAL's GLPK traits say so of
// infeasible programs too, and of unbounded linear ones. So nothing is believed that is not checked
// here, but optimality, if `believes_optima` says so and nothing speaks against it.
template <class PlainTraits, bool believes_optima>
class Adapted_search : public Program_search
{
public:
  void run()
  {
    if (!begin())
      return;
    const std::vector<double> corner = best_corner();
    bound = objective_of(corner);
    if (std::isfinite(bound) && take_solution(corner))
      outcome = Outcome::COMPLETE;
    else if (rows.empty()) // some solvers do not bear that
      message = "the program is unbounded";
    else if (seconds_left() <= 0 || is_stopped())
      end_at_limit();
    else
      search();
  }

private:
  using Variable = typename PlainTraits::Variable;
  using FT = decltype(std::declval<const Variable&>().solution_value());

  // the point of the box where the objective is best, whatever the rows ask for
  std::vector<double> best_corner() const
  {
    std::vector<double> cost(columns.size(), 0.), result;
    for (const auto& term : objective)
      cost[term.first] = term.second;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Column& c = columns[i];
      const double low = c.is_integer ? std::ceil(c.low) : c.low;
      const double high = c.is_integer ? std::floor(c.high) : c.high;
      const bool is_high = (cost[i] > 0) == maximize;
      result.push_back(cost[i] == 0 ? (std::max)(low, (std::min)(0., high)) : is_high ? high : low);
    }
    return result;
  }

  void search()
  {
    PlainTraits solver;
    load(solver);
    const bool succeeded = solver.solve();
    const bool is_feasible = succeeded && take_solution(solution_of(solver));
    if (is_stopped())
      end_at_limit("stopped");
    else if (is_feasible && is_believed(solution_of(solver))) {
      outcome = Outcome::COMPLETE;
      bound = objective_value;
    } else if (has_solution)
      end_at_limit("nothing proves that the solution is optimal");
    else
      message = succeeded ? "the solution of the solver is infeasible" : solver.error_message();
  }

  // A solution in an unbounded program is not optimal, nor is one that is worse than the start.
  bool is_believed(const std::vector<double>& found) const
  {
    return believes_optima && std::isfinite(bound) && is_as_good(objective_of(found));
  }

  void load(PlainTraits& solver) const
  {
    for (const Column& c : columns)
      solver.create_variable(c.is_integer ? Variable::INTEGER : Variable::CONTINUOUS,
                             with_infinity_of_solver(c.low), with_infinity_of_solver(c.high));
    for (const Row& r : rows) {
      auto* row = solver.create_constraint(with_infinity_of_solver(r.low),
                                           with_infinity_of_solver(r.high));
      add_terms(r.terms, *row, solver);
    }
    using Objective = typename PlainTraits::Linear_objective;
    add_terms(objective,
              *solver.create_objective(maximize ? Objective::MAXIMIZE : Objective::MINIMIZE),
              solver);
  }

  template <class Expression>
  static void add_terms(const Terms& terms, Expression& expression, const PlainTraits& solver)
  {
    for (const auto& term : terms)
      expression.add_coefficient(solver.variables()[term.first], FT(term.second));
  }

  static FT with_infinity_of_solver(double x)
  {
    const FT infinity = Variable::infinity();
    return x >= infinity ? infinity : x <= -infinity ? -infinity : FT(x);
  }

  static std::vector<double> solution_of(const PlainTraits& solver)
  {
    std::vector<double> result;
    for (const Variable* v : solver.variables())
      result.push_back(double(v->solution_value()));
    return result;
  }
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_ADAPTED_SEARCH_H
