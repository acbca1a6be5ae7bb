// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_TEST_SOLVER_CASES_H
#define QUAD_LAYOUTS_TEST_SOLVER_CASES_H

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

// What holds for every model of QuadLayoutsMixedIntegerProgramTraits. Each solver's test runs all.
namespace solver_cases {

constexpr double infinity = 1e20; // of CGAL's traits

// 2 x + y >= 2.5 with small integers: 1.9 x + y is least at (1, 1)
template <class Traits>
void finds_the_optimum_and_tells_infeasibility()
{
  Traits traits;
  auto* x = traits.create_variable(Traits::Variable::INTEGER, 0, 10);
  auto* y = traits.create_variable(Traits::Variable::INTEGER, 0, 10);
  auto* row = traits.create_constraint(2.5, infinity);
  row->add_coefficient(x, 2);
  row->add_coefficient(y, 1);
  auto* objective = traits.create_objective();
  objective->add_coefficient(x, 1.9);
  objective->add_coefficient(y, 1);
  BOOST_TEST(traits.solve());
  BOOST_TEST(traits.status() == Traits::OPTIMAL);
  BOOST_TEST(traits.objective_value() == 2.9, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(traits.best_bound() == 2.9, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(x->solution_value() == 1);
  BOOST_TEST(y->solution_value() == 1);

  auto* contradiction = traits.create_constraint(-infinity, 1);
  contradiction->add_coefficient(x, 2);
  contradiction->add_coefficient(y, 1);
  BOOST_TEST(!traits.solve());
  BOOST_TEST(traits.status() == Traits::INFEASIBLE);
  BOOST_TEST(traits.solution().empty());
}

// The relaxation of 2 x - 2 y = 1 has solutions, but no integers satisfy it.
template <class Traits>
void tells_that_there_are_no_integers()
{
  Traits traits;
  auto* x = traits.create_variable(Traits::Variable::INTEGER, 0, 10);
  auto* y = traits.create_variable(Traits::Variable::INTEGER, 0, 10);
  auto* row = traits.create_constraint(1, 1);
  row->add_coefficient(x, 2);
  row->add_coefficient(y, -2);
  traits.create_objective()->add_coefficient(x, 1);
  BOOST_TEST(!traits.solve());
  BOOST_TEST(traits.status() == Traits::INFEASIBLE);
}

// 3 x + 2 y <= 12.5, x + 4 y <= 14.5: 2 x + 3 y + 1 is 13 at (3, 1), (2, 3) gives 14
template <class Traits>
void maximizes()
{
  Traits traits;
  auto* x = traits.create_variable(Traits::Variable::INTEGER, 0, infinity);
  auto* y = traits.create_variable(Traits::Variable::INTEGER, 0, infinity);
  auto* row = traits.create_constraint(-infinity, 12.5);
  row->add_coefficient(x, 3);
  row->add_coefficient(y, 2);
  row = traits.create_constraint(-infinity, 14.5);
  row->add_coefficient(x, 1);
  row->add_coefficient(y, 4);
  auto* objective = traits.create_objective(Traits::Linear_objective::MAXIMIZE);
  objective->add_coefficient(x, 2);
  objective->add_coefficient(y, 3);
  objective->set_offset(1);
  BOOST_TEST(traits.solve());
  BOOST_TEST(traits.status() == Traits::OPTIMAL);
  BOOST_TEST(traits.objective_value() == 14, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(traits.best_bound() >= 14 * (1 - 1e-9));
  BOOST_TEST(x->solution_value() == 2);
  BOOST_TEST(y->solution_value() == 3);
}

// a pure linear program, with a free variable: x + y >= 1, x - y >= -3 with x <= -1 is worst for
// -x - 2 y, thus x + 2 y at least, at (-1, 2)
template <class Traits>
void solves_linear_programs()
{
  Traits traits;
  auto* x = traits.create_variable(Traits::Variable::CONTINUOUS, -infinity, -1);
  auto* y = traits.create_variable(Traits::Variable::CONTINUOUS, -infinity, infinity);
  auto* row = traits.create_constraint(1, infinity);
  row->add_coefficient(x, 1);
  row->add_coefficient(y, 1);
  auto* objective = traits.create_objective();
  objective->add_coefficient(x, 1);
  objective->add_coefficient(y, 2);
  BOOST_TEST(traits.solve());
  BOOST_TEST(traits.status() == Traits::OPTIMAL);
  BOOST_TEST(traits.objective_value() == 3, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(traits.best_bound() == 3, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(x->solution_value() == -1, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(y->solution_value() == 2, boost::test_tools::tolerance(1e-9));
}

template <class Traits>
void bears_programs_without_rows_or_columns()
{
  Traits empty;
  empty.create_objective()->set_offset(3);
  BOOST_TEST(empty.solve());
  BOOST_TEST(empty.status() == Traits::OPTIMAL);
  BOOST_TEST(empty.objective_value() == 3);
  BOOST_TEST(empty.best_bound() == 3);
  empty.create_constraint(1, infinity);
  BOOST_TEST(!empty.solve());
  BOOST_TEST(empty.status() == Traits::INFEASIBLE);

  Traits without_rows;
  auto* x = without_rows.create_variable(Traits::Variable::INTEGER, 2, 5);
  without_rows.create_objective()->add_coefficient(x, 1);
  BOOST_TEST(without_rows.solve());
  BOOST_TEST(without_rows.status() == Traits::OPTIMAL);
  BOOST_TEST(without_rows.objective_value() == 2);

  Traits unbounded;
  x = unbounded.create_variable(Traits::Variable::INTEGER, -infinity, infinity);
  unbounded.create_objective()->add_coefficient(x, 1);
  BOOST_TEST(!unbounded.solve());
  BOOST_TEST(unbounded.status() == Traits::FAILED);
}

// A market split problem: binary sums that must hit several values exactly. Branch and bound has
// little to hold on to.
template <class Traits>
void make_hard(Traits& traits)
{
  constexpr int variables = 40, rows = 4;
  auto* objective = traits.create_objective();
  std::vector<typename Traits::Variable*> x;
  for (int i = 0; i < variables; ++i) {
    x.push_back(traits.create_variable(Traits::Variable::BINARY, 0, 1));
    objective->add_coefficient(x.back(), 1);
  }
  std::mt19937 random(1);
  for (int r = 0; r < rows; ++r) {
    std::vector<int> weights;
    for (int i = 0; i < variables; ++i)
      weights.push_back(int(random() % 100));
    const int half = std::accumulate(weights.begin(), weights.end(), 0) / 2;
    auto* row = traits.create_constraint(half, half);
    for (int i = 0; i < variables; ++i)
      row->add_coefficient(x[i], weights[i]);
  }
}

// The same with slacks, that make any start feasible; returns one that costs much.
template <class Traits>
std::vector<double> make_hard_but_feasible(Traits& traits)
{
  make_hard(traits);
  std::vector<double> start(traits.number_of_variables(), 0.);
  for (std::size_t r = 0; r < traits.number_of_constraints(); ++r) {
    auto* row = traits.constraints()[r];
    for (const int sign : {-1, 1}) {
      auto* slack = traits.create_variable(Traits::Variable::INTEGER, 0, infinity);
      row->add_coefficient(slack, sign);
      traits.objective()->add_coefficient(slack, 1000);
      start.push_back(sign > 0 ? row->lower_bound() : 0.);
    }
  }
  return start;
}

template <class Traits>
void respects_limits()
{
  Traits by_nodes;
  make_hard(by_nodes);
  by_nodes.set_node_limit(50);
  BOOST_TEST(!by_nodes.solve());
  BOOST_TEST(by_nodes.status() == Traits::UNKNOWN);

  Traits by_time;
  make_hard(by_time);
  by_time.set_time_limit(0.2);
  BOOST_TEST(!by_time.solve());
  BOOST_TEST(by_time.status() == Traits::UNKNOWN);

  Traits by_callback;
  make_hard(by_callback);
  by_callback.set_interrupt([] { return true; });
  BOOST_TEST(!by_callback.solve());
  BOOST_TEST(by_callback.status() == Traits::UNKNOWN);
  by_callback.set_interrupt([]() -> bool { throw std::logic_error("from the callback"); });
  BOOST_CHECK_THROW(by_callback.solve(), std::logic_error);
}

// Whatever ends the search early: the bound is one, and all is the same on every run.
template <class Traits>
void is_right_and_repeatable_where_it_ends()
{
  for (const int nodes : {1, 3, 10, 30, 100}) {
    Traits traits, again;
    make_hard_but_feasible(traits);
    make_hard_but_feasible(again);
    traits.set_node_limit(nodes);
    again.set_node_limit(nodes);
    BOOST_TEST(traits.solve() == again.solve());
    BOOST_TEST(traits.solution() == again.solution(), boost::test_tools::per_element());
    BOOST_TEST(traits.best_bound() == again.best_bound());
    if (!traits.solution().empty())
      BOOST_TEST(traits.best_bound() <= traits.objective_value() * (1 + 1e-9));
  }
}

// The start solution remains unless there is a better one, whenever the search ends.
template <class Traits>
void keeps_the_start_solution()
{
  for (int questions = 0; questions < 400; questions = 1 + questions * 5 / 4) {
    Traits traits;
    traits.set_start_solution(make_hard_but_feasible(traits));
    int asked = 0;
    traits.set_interrupt([&] { return ++asked > questions; });
    BOOST_TEST(traits.solve());
    BOOST_TEST(traits.status() == Traits::FEASIBLE);
    BOOST_TEST(traits.best_bound() <= traits.objective_value());
    for (const auto* row : traits.constraints()) {
      double value = 0;
      for (const auto& term : row->coefficients())
        value += term.second * term.first->solution_value();
      BOOST_TEST(value == row->lower_bound());
    }
  }
}

template <class Traits>
void does_not_trust_an_infeasible_start_solution()
{
  Traits traits;
  auto* x = traits.create_variable(Traits::Variable::INTEGER, 0, 10);
  traits.create_constraint(3, infinity)->add_coefficient(x, 1);
  traits.create_objective()->add_coefficient(x, 1);
  traits.set_start_solution({1});
  BOOST_TEST(traits.solve());
  BOOST_TEST(x->solution_value() == 3);
}

template <class Traits>
void check_all()
{
  finds_the_optimum_and_tells_infeasibility<Traits>();
  tells_that_there_are_no_integers<Traits>();
  maximizes<Traits>();
  solves_linear_programs<Traits>();
  bears_programs_without_rows_or_columns<Traits>();
  respects_limits<Traits>();
  is_right_and_repeatable_where_it_ends<Traits>();
}

} // namespace solver_cases

#endif // QUAD_LAYOUTS_TEST_SOLVER_CASES_H
