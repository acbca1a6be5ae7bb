// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#define BOOST_TEST_MODULE GLPK_mixed_integer_program_traits
#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>

#include <CGAL/Real_timer.h>

#include <boost/test/unit_test.hpp>

#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace internal = CGAL::Quad_layouts::internal;

using Traits = CGAL::Quad_layouts::GLPK_mixed_integer_program_traits<double>;

constexpr double infinity = 1e20; // of CGAL's traits

// 2 x + y >= 2.5 with small integers: 1.9 x + y is least at (1, 1)
BOOST_AUTO_TEST_CASE(finds_the_optimum_and_tells_infeasibility)
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

// A market split problem: binary sums that must hit several values exactly. Branch and bound has
// little to hold on to.
void make_hard(Traits& traits)
{
  constexpr int variables = 40, rows = 4;
  auto* objective = traits.create_objective();
  std::vector<Traits::Variable*> x;
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

BOOST_AUTO_TEST_CASE(respects_limits)
{
  Traits by_nodes;
  make_hard(by_nodes);
  by_nodes.set_node_limit(50);
  BOOST_TEST(!by_nodes.solve());
  BOOST_TEST(by_nodes.status() == Traits::UNKNOWN);

  Traits by_time;
  make_hard(by_time);
  by_time.set_time_limit(0.2);
  CGAL::Real_timer timer;
  timer.start();
  BOOST_TEST(!by_time.solve());
  BOOST_TEST(timer.time() < 5);
  BOOST_TEST(by_time.status() == Traits::UNKNOWN);

  Traits by_callback;
  make_hard(by_callback);
  by_callback.set_interrupt([] { return true; });
  BOOST_TEST(!by_callback.solve());
  BOOST_TEST(by_callback.status() == Traits::UNKNOWN);
  by_callback.set_interrupt([]() -> bool { throw std::logic_error("from the callback"); });
  BOOST_CHECK_THROW(by_callback.solve(), std::logic_error);
}

BOOST_AUTO_TEST_CASE(survives_fatal_errors_of_glpk)
{
  BOOST_TEST(!internal::run_guarded_from_glpk([](void*) { glp_add_rows(glp_create_prob(), -1); },
                                              nullptr));
  BOOST_TEST(
      internal::run_guarded_from_glpk([](void*) { glp_delete_prob(glp_create_prob()); }, nullptr));
}
