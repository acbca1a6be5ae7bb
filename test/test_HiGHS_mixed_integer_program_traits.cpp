// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "solver_comparison.h"

#include <CGAL/Quad_layouts/HiGHS_mixed_integer_program_traits.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(test_HiGHS_mixed_integer_program_traits)

namespace QL = CGAL::Quad_layouts;

using Traits = QL::HiGHS_mixed_integer_program_traits<double>;

BOOST_AUTO_TEST_CASE(holds_what_holds_for_all_solvers)
{
  solver_cases::check_all<Traits>();
  solver_cases::keeps_the_start_solution<Traits>();
  solver_cases::does_not_trust_an_infeasible_start_solution<Traits>();
}

BOOST_AUTO_TEST_CASE(agrees_with_glpk)
{
  solver_comparison::agrees_with_glpk<Traits>();
  solver_comparison::agrees_with_glpk_on_random_programs<Traits>();
}

// HiGHS refuses to run in fewer threads than it has been given before.
BOOST_AUTO_TEST_CASE(bears_threads_of_others)
{
  Highs other;
  other.setOptionValue("output_flag", false);
  other.setOptionValue("threads", 2);
  Highs::resetGlobalScheduler(true);
  other.addVar(0, 1);
  BOOST_REQUIRE((other.run() == HighsStatus::kOk));
  solver_cases::finds_the_optimum_and_tells_infeasibility<Traits>();
  Highs::resetGlobalScheduler(true);
}

BOOST_AUTO_TEST_CASE(prints_nothing)
{
  solver_comparison::prints_nothing<Traits>();
}

BOOST_AUTO_TEST_SUITE_END()
