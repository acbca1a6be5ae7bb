// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "solver_comparison.h"

#include <CGAL/Quad_layouts/CBC_mixed_integer_program_traits.h>
#include <CGAL/Quad_layouts/IO/quantization_program.h>

#include <boost/test/unit_test.hpp>

#include <cstdio>
#include <fstream>
#include <string>

BOOST_AUTO_TEST_SUITE(test_CBC_mixed_integer_program_traits)

namespace QL = CGAL::Quad_layouts;
namespace parameters = CGAL::Quad_layouts::parameters;

using Traits = QL::CBC_mixed_integer_program_traits<double>;
using solver_comparison::traced;

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

BOOST_AUTO_TEST_CASE(its_reader_takes_written_programs)
{
  const QL::T_mesh t_mesh = traced(generated::cube(6));
  const std::string file = "cbc_program.mps";
  std::ofstream out(file);
  BOOST_TEST(QL::IO::write_quantization_program(out, t_mesh, parameters::relative_gap(0.)));
  out.close();
  OsiClpSolverInterface solver;
  solver.messageHandler()->setLogLevel(0);
  BOOST_TEST(solver.readMps(file.c_str()) == 0);
  std::remove(file.c_str());
  CbcModel model(solver);
  model.setLogLevel(0);
  model.branchAndBound();
  BOOST_TEST(model.getObjValue() == QL::quantize<Traits>(t_mesh).objective,
             boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(prints_nothing)
{
  solver_comparison::prints_nothing<Traits>();
}

BOOST_AUTO_TEST_SUITE_END()
