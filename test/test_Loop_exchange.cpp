// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "noisy_program.h"

#include <CGAL/Quad_layouts/internal/quantization/Loop_exchange.h>
#include <CGAL/Quad_layouts/internal/quantization/evaluate_program.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_Loop_exchange)

namespace QL = CGAL::Quad_layouts;
namespace internal = QL::internal;

namespace {

void check(const internal::Row_counts& counts, const internal::Reduced_program& program)
{
  const internal::Program_evaluation rows(program, counts.values());
  BOOST_TEST(counts.objective() == rows.objective(), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(counts.is_feasible() == (rows.is_feasible() && rows.satisfies_cuts()));
  for (int k = 0; k < int(program.indicators.size()); ++k)
    BOOST_TEST(counts.is_merged(k) == rows.is_merged(k));
  for (int r = 0; r < int(program.index_rows.size()); ++r)
    BOOST_TEST(counts.excess_of(r) == rows.index_excess(program.index_rows[r]));
}

} // namespace

// The counts that are kept up to date are those of an evaluation from scratch, cuts that come in
// between included.
BOOST_FIXTURE_TEST_CASE(counts_keep_up_with_changes, Noisy_program)
{
  BOOST_REQUIRE(!program.indicators.empty());
  internal::Row_counts counts(program);
  check(counts, program);
  std::mt19937 random;
  for (int step = 0; step < 300; ++step) {
    const int v = int(random() % program.number_of_variables());
    counts.change(v, counts.values()[v] > 0 && random() % 2 == 0 ? -1 : 1);
    if (step % 50 == 0) {
      program.cuts.push_back({{v}, {int(random() % program.indicators.size())}, true});
      counts.update_cuts();
    }
    if (step % 10 == 0)
      check(counts, program);
  }
  counts.assign(std::vector<int>(program.number_of_variables(), 0));
  check(counts, program);
}

// Each state is a consistent solution of all rows that is not above the limit, and the best one is
// far better than the first.
BOOST_FIXTURE_TEST_CASE(improves_a_sum_of_loops, Noisy_program)
{
  internal::Loop_exchange exchange(program, graph);
  exchange.start_from(loops());
  const double first = exchange.objective();
  double best = first;
  for (int step = 0; step < 200; ++step) {
    const double limit = 1.01 * best;
    exchange.step(limit);
    BOOST_TEST(exchange.objective() <= limit);
    const internal::Program_evaluation rows(program, exchange.values());
    BOOST_TEST(rows.is_consistent());
    BOOST_TEST(rows.is_feasible());
    best = (std::min)(best, exchange.objective());
  }
  BOOST_TEST(best < 0.5 * first);
}

// New rows are satisfied from the next step on.
BOOST_FIXTURE_TEST_CASE(takes_notice_of_cuts, Noisy_program)
{
  internal::Loop_exchange exchange(program, graph);
  exchange.start_from(loops());
  for (int step = 0; step < 50; ++step)
    exchange.step(exchange.objective());
  internal::Reduced_program::Set unused;
  for (int v = 0; v < program.number_of_variables(); ++v)
    if (exchange.values()[v] == 0)
      unused.push_back(v);
  BOOST_REQUIRE(!unused.empty());
  program.cuts.push_back({unused, {}, true});
  BOOST_TEST(exchange.step(0)); // above the limit, but needed
  BOOST_TEST(internal::Program_evaluation(program, exchange.values()).satisfies_cuts());
}

BOOST_AUTO_TEST_SUITE_END()
