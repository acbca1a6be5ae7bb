// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_PROGRAM_TRAITS_BASE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_PROGRAM_TRAITS_BASE_H

#include <CGAL/Quad_layouts/internal/quantization/Program_search.h>
#include <CGAL/Quad_layouts/internal/quantization/copy_program.h>

#include <CGAL/Mixed_integer_program_traits.h>

#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Makes a model of QuadLayoutsMixedIntegerProgramTraits of a class that is derived from
// Program_search and has a function run().
template <class FT, class Search>
class Program_traits_base : public CGAL::Mixed_integer_program_traits<FT>
{
  using Base = CGAL::Mixed_integer_program_traits<FT>;

public:
  using Variable = typename Base::Variable;
  using Linear_constraint = typename Base::Linear_constraint;
  using Linear_objective = typename Base::Linear_objective;

  // is the outcome of `solve()`
  enum Status {
    OPTIMAL,    // the solution is optimal within the relative gap
    FEASIBLE,   // there is a solution, but a limit ended the search
    INFEASIBLE, // there is no solution
    UNKNOWN,    // a limit ended the search before a solution was found
    FAILED      // the solver gave up
  };

  void set_time_limit(double seconds) { m_limits.seconds = seconds; }
  void set_node_limit(int nodes) { m_limits.nodes = nodes; }
  void set_relative_gap(double gap) { m_limits.relative_gap = gap; }
  // sets what is asked now and then if the search is to end; an exception thrown by it leaves
  // `solve()`.
  void set_interrupt(std::function<bool()> stop) { m_stop = std::move(stop); }

  // gives a feasible solution to begin with, a value per variable.
  void set_start_solution(std::vector<FT> values) { m_start = std::move(values); }

  Status status() const { return m_status; }
  FT objective_value() const { return FT(m_objective); }
  // returns a value that no solution is better than.
  FT best_bound() const { return FT(m_bound); }

  // solves the program and says if a solution was found.
  bool solve() override
  {
    Search search;
    search.limits = m_limits;
    copy_program(*this, search);
    search.start.assign(m_start.begin(), m_start.end());
    std::exception_ptr exception;
    search.stop = [&] {
      try {
        return m_stop && m_stop();
      } catch (...) { // it must not pass through the frames of a C library
        exception = std::current_exception();
        return true;
      }
    };
    search.run();
    if (exception)
      std::rethrow_exception(exception);
    return take_result(search);
  }

private:
  bool take_result(const Search& search)
  {
    using Outcome = typename Search::Outcome;
    const bool has_solution = search.has_solution;
    switch (search.outcome) {
      case Outcome::COMPLETE: m_status = has_solution ? OPTIMAL : INFEASIBLE; break;
      case Outcome::LIMIT: m_status = has_solution ? FEASIBLE : UNKNOWN; break;
      case Outcome::ERROR: m_status = FAILED; break;
    }
    m_objective = search.objective_value;
    m_bound = search.bound;
    this->error_message_ = search.message;
    this->result_.clear();
    if (!has_solution || m_status == FAILED)
      return false;
    for (std::size_t i = 0; i < this->variables_.size(); ++i) {
      Variable* v = this->variables_[i];
      const bool is_integer = v->variable_type() != Variable::CONTINUOUS;
      const FT x = FT(is_integer ? std::round(search.values[i]) : search.values[i]);
      v->set_solution_value(x);
      this->result_.push_back(x);
    }
    return true;
  }

  Search_limits m_limits;
  std::function<bool()> m_stop;
  std::vector<FT> m_start;
  Status m_status = UNKNOWN;
  double m_objective = 0, m_bound = -(std::numeric_limits<double>::infinity)();
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_PROGRAM_TRAITS_BASE_H
