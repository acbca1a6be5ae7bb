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

BOOST_AUTO_TEST_CASE(survives_fatal_errors_of_glpk)
{
  BOOST_TEST(!internal::run_guarded_from_glpk([](void*) { glp_add_rows(glp_create_prob(), -1); },
                                              nullptr));
  BOOST_TEST(
      internal::run_guarded_from_glpk([](void*) { glp_delete_prob(glp_create_prob()); }, nullptr));
}

BOOST_AUTO_TEST_SUITE_END()
