// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "solver_cases.h"

#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_GLPK_mixed_integer_program_traits)

namespace internal = CGAL::Quad_layouts::internal;

using Traits = CGAL::Quad_layouts::GLPK_mixed_integer_program_traits<double>;

BOOST_AUTO_TEST_CASE(holds_what_holds_for_all_solvers)
{
  solver_cases::check_all<Traits>();
}

// Vertex covers of triangles: half of each vertex is enough for the relaxation.
BOOST_AUTO_TEST_CASE(branches_on_one_of_many_fractional_columns)
{
  constexpr int triangles = 100;
  Traits traits;
  auto* objective = traits.create_objective();
  for (int t = 0; t < triangles; ++t) {
    Traits::Variable* corner[3];
    for (auto& c : corner) {
      c = traits.create_variable(Traits::Variable::BINARY, 0, 1);
      objective->add_coefficient(c, 1);
    }
    for (int i : {0, 1, 2}) {
      auto* edge = traits.create_constraint(1, 2);
      edge->add_coefficient(corner[i], 1);
      edge->add_coefficient(corner[(i + 1) % 3], 1);
    }
  }
  traits.set_node_limit(1000);
  BOOST_TEST(traits.solve());
  BOOST_TEST(traits.objective_value() == 2 * triangles);
  BOOST_TEST(traits.best_bound() >= 1.5 * triangles);
}

BOOST_AUTO_TEST_CASE(survives_fatal_errors_of_glpk)
{
  BOOST_TEST(!internal::run_guarded_from_glpk([](void*) { glp_add_rows(glp_create_prob(), -1); },
                                              nullptr));
  BOOST_TEST(
      internal::run_guarded_from_glpk([](void*) { glp_delete_prob(glp_create_prob()); }, nullptr));
}

BOOST_AUTO_TEST_SUITE_END()
