// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "generated_meshes.h"
#include "hand_made_t_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/number_type_config.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_lazy_index_rows)

namespace QL = CGAL::Quad_layouts;
namespace internal = CGAL::Quad_layouts::internal;

namespace {

using Solver = QL::GLPK_mixed_integer_program_traits<double>;

internal::Reduced_program reduced(const QL::T_mesh& t, const internal::Dual_graph& graph,
                                  double reach)
{
  return internal::reduce(t, internal::build_quantization_program(t, {0.27, reach, -4, 1}), graph);
}

void hide_index_rows(internal::Reduced_program& program)
{
  for (auto& row : program.index_rows)
    row.is_lazy = true;
}

internal::Box_solution solve(const internal::Reduced_program& program, internal::Domain domain)
{
  const internal::Box everything(program.number_of_variables());
  const internal::Search_effort effort{60, (std::numeric_limits<int>::max)(), 0, {}};
  return internal::solve_in_box<Solver>(program, everything, {}, effort, domain);
}

QL::T_mesh traced_sphere()
{
  return QL::trace_motorcycle_graph(
      QL::compute_cross_field(generated::noisy(generated::icosphere(3), 0.08, 3)));
}

} // namespace

// Corners of index 1 may not merge: length 0 violates all rows, length 1 none.
BOOST_AUTO_TEST_CASE(demands_what_is_violated)
{
  const QL::T_mesh t = hand_made::cube();
  const internal::Dual_graph graph(t);
  internal::Reduced_program program = reduced(t, graph, 1);
  BOOST_REQUIRE_EQUAL(program.index_rows.size(), 8u);
  hide_index_rows(program);
  BOOST_TEST(internal::demand_index_rows(program, std::vector<int>(3, 1)) == 0);
  BOOST_TEST(internal::demand_index_rows(program, std::vector<double>(3, 1), 10) == 0);
  BOOST_TEST(program.number_of_visible_rows(internal::Reduced_program::Rows::ALL) == 0);
  BOOST_TEST(internal::demand_index_rows(program, std::vector<int>(3, 0)) == 8);
  BOOST_TEST(internal::demand_index_rows(program, std::vector<int>(3, 0)) == 0);
  BOOST_TEST(program.number_of_visible_rows(internal::Reduced_program::Rows::ALL) == 8);
}

BOOST_AUTO_TEST_CASE(small_programs_have_all_rows)
{
  const QL::T_mesh t = hand_made::cube();
  const internal::Dual_graph graph(t);
  internal::Reduced_program program = reduced(t, graph, 1);
  internal::make_index_rows_lazy_if_many(program);
  BOOST_TEST(program.number_of_visible_rows(internal::Reduced_program::Rows::ALL) == 8);
}

// Lazy rows leave the optimum as it is; bounds without all rows are below it.
BOOST_AUTO_TEST_CASE(find_the_same_optimum)
{
  const QL::T_mesh t = traced_sphere();
  const internal::Dual_graph graph(t);
  const auto eager = reduced(t, graph, 0.04 * t.surface().diagonal());
  BOOST_REQUIRE(!eager.index_rows.empty());
  const internal::Box_solution expected = solve(eager, internal::Domain::INTEGERS);
  BOOST_REQUIRE_EQUAL(expected.status, internal::Box_solution::OPTIMAL);

  internal::Reduced_program lazy = eager;
  hide_index_rows(lazy);
  internal::Box_solution found;
  std::vector<int> x;
  do {
    found = solve(lazy, internal::Domain::INTEGERS);
    BOOST_REQUIRE_EQUAL(found.status, internal::Box_solution::OPTIMAL);
    BOOST_TEST(found.bound <= expected.bound * (1 + 1e-9));
    x.assign(found.x.begin(), found.x.end());
  } while (internal::demand_index_rows(lazy, x) > 0);
  BOOST_TEST(found.bound == expected.bound, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(internal::Program_evaluation(eager, x).is_feasible());
}

// A search that a limit of work ends finds the same again.
BOOST_AUTO_TEST_CASE(limits_of_work_repeat_results)
{
  const QL::T_mesh t = traced_sphere();
  const internal::Dual_graph graph(t);
  const auto program = reduced(t, graph, 0.04 * t.surface().diagonal());
  const internal::Box everything(program.number_of_variables());
  const internal::Search_effort little{60, 1, 0, {}};
  const auto once = internal::solve_in_box<Solver>(program, everything, {}, little);
  const auto again = internal::solve_in_box<Solver>(program, everything, {}, little);
  BOOST_TEST(once.status == again.status);
  BOOST_TEST(once.x == again.x, boost::test_tools::per_element());
  BOOST_TEST(once.bound == again.bound);
}

BOOST_AUTO_TEST_CASE(quantizations_repeat_and_are_no_worse_than_the_start)
{
  const QL::T_mesh t = traced_sphere();
  const QL::Quantization q = QL::quantize(t), again = QL::quantize(t);
  BOOST_TEST(q.arc_length == again.arc_length, boost::test_tools::per_element());

  const internal::Dual_graph graph(t);
  const double h = 0.01 * t.surface().diagonal();
  const auto paper = internal::build_quantization_program(
      t, {std::tan(15 * CGAL_PI / 180), 4 * h, -4, 1});
  auto program = internal::reduce(t, paper, graph);
  const internal::Monitor monitor;
  internal::Incumbent start(t, paper, graph, program, monitor);
  BOOST_REQUIRE(start.start());
  BOOST_TEST(q.objective <= start.objective() * (1 + 1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
