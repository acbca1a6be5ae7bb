// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "solver_comparison.h"

#include <CGAL/Quad_layouts/Mixed_integer_program_traits_adaptor.h>

#include <CGAL/GLPK_mixed_integer_program_traits.h>

#include <boost/test/unit_test.hpp>

#include <limits>
#include <stdexcept>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_Mixed_integer_program_traits_adaptor)

using CGAL::Quad_layouts::Mixed_integer_program_traits_adaptor;
using solver_cases::infinity;

// CGAL's traits, which claim success for infeasible programs
using Plain = CGAL::GLPK_mixed_integer_program_traits<double>;
using Cautious = Mixed_integer_program_traits_adaptor<Plain>;
using Trusting = Mixed_integer_program_traits_adaptor<Plain, CGAL::Tag_true>;

namespace {

// 2 x + 2 y >= low with integers up to 10, and a row that takes them up to `high`
template <class Traits>
void make_sum(Traits& traits, double low, double high)
{
  auto* row = traits.create_constraint(low, high);
  auto* objective = traits.create_objective();
  for (const double cost : {1.9, 1.}) {
    auto* v = traits.create_variable(Traits::Variable::INTEGER, 0, 10);
    row->add_coefficient(v, 2);
    objective->add_coefficient(v, cost);
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(believes_optima_only_if_told_to)
{
  Cautious cautious;
  make_sum(cautious, 3, infinity);
  BOOST_TEST(cautious.solve());
  BOOST_TEST(cautious.status() == Cautious::FEASIBLE);
  BOOST_TEST(cautious.objective_value() == 2);
  BOOST_TEST(cautious.best_bound() == 0);

  Trusting trusting;
  make_sum(trusting, 3, infinity);
  BOOST_TEST(trusting.solve());
  BOOST_TEST(trusting.status() == Trusting::OPTIMAL);
  BOOST_TEST(trusting.objective_value() == 2);
  BOOST_TEST(trusting.best_bound() == 2);
}

// The best that the bounds allow is optimal, whatever the solver may find.
BOOST_AUTO_TEST_CASE(proves_what_needs_no_solver)
{
  Cautious traits;
  make_sum(traits, -1, infinity);
  traits.objective()->set_offset(3);
  BOOST_TEST(traits.solve());
  BOOST_TEST(traits.status() == Cautious::OPTIMAL);
  BOOST_TEST(traits.objective_value() == 3);
  solver_cases::bears_programs_without_rows_or_columns<Cautious>();
}

BOOST_AUTO_TEST_CASE(does_not_believe_in_solutions_of_infeasible_programs)
{
  Plain plain; // 3 <= 2 x + 2 y <= 3.5 has solutions, but no integers
  make_sum(plain, 3, 3.5);
  BOOST_TEST_MESSAGE("CGAL's traits claim to have solved it: " << plain.solve());

  Trusting integers, reals;
  make_sum(integers, 3, 3.5);
  BOOST_TEST(!integers.solve());
  BOOST_TEST(integers.status() == Trusting::FAILED);
  BOOST_TEST(!integers.error_message().empty());
  BOOST_TEST(integers.solution().empty());

  auto* x = reals.create_variable(Trusting::Variable::CONTINUOUS, 0, 1);
  reals.create_constraint(2, infinity)->add_coefficient(x, 1);
  reals.create_objective()->add_coefficient(x, 1);
  BOOST_TEST(!reals.solve());
  BOOST_TEST(reals.status() == Trusting::FAILED);
}

// CGAL's traits return any solution of an unbounded linear program.
BOOST_AUTO_TEST_CASE(does_not_take_solutions_of_unbounded_programs_for_optima)
{
  Trusting traits;
  auto* x = traits.create_variable(Trusting::Variable::CONTINUOUS, -infinity, infinity);
  auto* y = traits.create_variable(Trusting::Variable::CONTINUOUS, 0, infinity);
  auto* row = traits.create_constraint(-infinity, 1);
  row->add_coefficient(x, 1);
  row->add_coefficient(y, 1);
  traits.create_objective()->add_coefficient(x, 1);
  traits.solve();
  BOOST_TEST(traits.status() != Trusting::OPTIMAL);
  BOOST_TEST(traits.best_bound() == -(std::numeric_limits<double>::infinity)());
}

// A solver that finds nothing, or something bad
template <int value>
class Bad_solver : public CGAL::Mixed_integer_program_traits<double>
{
public:
  bool solve() override
  {
    for (auto* v : variables())
      v->set_solution_value(value);
    return value >= 0;
  }
};

BOOST_AUTO_TEST_CASE(keeps_the_start_solution)
{
  Mixed_integer_program_traits_adaptor<Bad_solver<-1>, CGAL::Tag_true> idle;
  make_sum(idle, 3, infinity);
  idle.set_start_solution({0, 3});
  BOOST_TEST(idle.solve());
  BOOST_TEST(idle.status() == idle.FEASIBLE);
  BOOST_TEST(idle.solution() == std::vector<double>({0, 3}), boost::test_tools::per_element());

  Mixed_integer_program_traits_adaptor<Bad_solver<5>, CGAL::Tag_true> wasteful;
  make_sum(wasteful, 3, infinity);
  wasteful.set_start_solution({0, 3});
  BOOST_TEST(wasteful.solve());
  BOOST_TEST(wasteful.status() == wasteful.FEASIBLE); // 5, 5 was no optimum
  BOOST_TEST(wasteful.objective_value() == 3);
  solver_cases::does_not_trust_an_infeasible_start_solution<Cautious>();
}

BOOST_AUTO_TEST_CASE(asks_before_it_begins)
{
  Trusting late, stopped, failing;
  for (Trusting* traits : {&late, &stopped, &failing})
    make_sum(*traits, 3, infinity);
  late.set_time_limit(0);
  BOOST_TEST(!late.solve());
  BOOST_TEST(late.status() == Trusting::UNKNOWN);
  stopped.set_interrupt([] { return true; });
  BOOST_TEST(!stopped.solve());
  BOOST_TEST(stopped.status() == Trusting::UNKNOWN);
  failing.set_interrupt([]() -> bool { throw std::logic_error("from the callback"); });
  BOOST_CHECK_THROW(failing.solve(), std::logic_error);
}

BOOST_AUTO_TEST_CASE(agrees_with_glpk)
{
  solver_comparison::agrees_with_glpk_on_random_programs<Trusting>();
  solver_comparison::agrees_with_glpk_on_random_programs<Cautious>();
}

// Quantizations are as good as with the solver that knows limits; bounds are where they are
// believed.
BOOST_AUTO_TEST_CASE(quantizes)
{
  namespace QL = CGAL::Quad_layouts;
  for (const auto& mesh : {generated::cube(4), generated::torus(24, 12)}) {
    const QL::T_mesh t_mesh = solver_comparison::traced(mesh);
    const QL::Quantization expected = QL::quantize(t_mesh);
    const QL::Quantization trusting = QL::quantize<Trusting>(t_mesh);
    const QL::Quantization cautious = QL::quantize<Cautious>(t_mesh);
    BOOST_TEST(trusting.objective == expected.objective, boost::test_tools::tolerance(0.01));
    BOOST_TEST(cautious.objective == expected.objective, boost::test_tools::tolerance(0.01));
    BOOST_TEST((trusting.status == QL::Quantization::OPTIMAL));
    BOOST_TEST((cautious.status == QL::Quantization::FEASIBLE));
  }
}

BOOST_AUTO_TEST_SUITE_END()
