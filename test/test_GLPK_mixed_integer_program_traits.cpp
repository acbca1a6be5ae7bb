// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#define BOOST_TEST_MODULE GLPK_mixed_integer_program_traits
#include "solver_cases.h"

#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>

#include <boost/test/unit_test.hpp>

namespace internal = CGAL::Quad_layouts::internal;

using Traits = CGAL::Quad_layouts::GLPK_mixed_integer_program_traits<double>;

BOOST_AUTO_TEST_CASE(finds_the_optimum_and_tells_infeasibility)
{
  solver_cases::finds_the_optimum_and_tells_infeasibility<Traits>();
}

BOOST_AUTO_TEST_CASE(tells_that_there_are_no_integers)
{
  solver_cases::tells_that_there_are_no_integers<Traits>();
}

BOOST_AUTO_TEST_CASE(maximizes)
{
  solver_cases::maximizes<Traits>();
}

BOOST_AUTO_TEST_CASE(solves_linear_programs)
{
  solver_cases::solves_linear_programs<Traits>();
}

BOOST_AUTO_TEST_CASE(bears_programs_without_rows_or_columns)
{
  solver_cases::bears_programs_without_rows_or_columns<Traits>();
}

BOOST_AUTO_TEST_CASE(respects_limits)
{
  solver_cases::respects_limits<Traits>();
}

BOOST_AUTO_TEST_CASE(is_right_and_repeatable_where_it_ends)
{
  solver_cases::is_right_and_repeatable_where_it_ends<Traits>();
}

BOOST_AUTO_TEST_CASE(survives_fatal_errors_of_glpk)
{
  BOOST_TEST(!internal::run_guarded_from_glpk([](void*) { glp_add_rows(glp_create_prob(), -1); },
                                              nullptr));
  BOOST_TEST(
      internal::run_guarded_from_glpk([](void*) { glp_delete_prob(glp_create_prob()); }, nullptr));
}
