// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "noisy_program.h"

#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>
#include <CGAL/Quad_layouts/internal/quantization/evaluate_program.h>
#include <CGAL/Quad_layouts/internal/quantization/solve_in_boxes.h>

#include <boost/test/unit_test.hpp>

#include <functional>
#include <random>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_solve_in_boxes)

namespace QL = CGAL::Quad_layouts;
namespace internal = QL::internal;

// searches until it is stopped
class Endless_traits : public QL::GLPK_mixed_integer_program_traits<double>
{
public:
  void set_interrupt(std::function<bool()> stop) { m_stop = std::move(stop); }
  Status status() const { return UNKNOWN; }
  bool solve() override
  {
    while (!m_stop())
      std::this_thread::yield();
    return false;
  }

private:
  std::function<bool()> m_stop;
};

struct Fixture : Noisy_program
{
  // consistent, and satisfies all rows
  std::vector<int> known = sum_of(loops());

  // in each, every third variable is free
  std::vector<internal::Box> boxes() const
  {
    std::mt19937 random;
    std::vector<internal::Box> result(5, internal::Box(known));
    for (internal::Box& box : result)
      for (int v = 0; v < program.number_of_variables(); ++v)
        if (random() % 3 == 0)
          box.free(v);
    return result;
  }

  template <class Traits>
  std::vector<internal::Box_solution> solve(const std::vector<internal::Box>& boxes,
                                            const internal::Search_effort& effort) const
  {
    return internal::solve_in_boxes<Traits>(program, boxes, known, effort);
  }
};

BOOST_FIXTURE_TEST_CASE(threads_do_not_change_solutions, Fixture)
{
  const internal::Search_effort effort{100, 50, 0, [] { return false; }};
  using Traits = QL::GLPK_mixed_integer_program_traits<double>;
  const auto together = solve<Traits>(boxes(), effort);
  BOOST_REQUIRE_EQUAL(together.size(), boxes().size());
  const double first = internal::Program_evaluation(program, known).objective();
  for (std::size_t i = 0; i < together.size(); ++i) {
    const internal::Box_solution alone = solve<Traits>({boxes()[i]}, effort).front();
    BOOST_TEST(together[i].status == alone.status);
    BOOST_TEST(together[i].bound == alone.bound);
    BOOST_TEST(together[i].x == alone.x, boost::test_tools::per_element());
    BOOST_REQUIRE(!alone.x.empty());
    BOOST_TEST(alone.bound < first);
  }
}

// The user's function is asked in the thread that began the searches, and ends all of them.
BOOST_FIXTURE_TEST_CASE(searches_can_be_stopped, Fixture)
{
  const std::vector<internal::Box> several = boxes();
  const auto thread = std::this_thread::get_id();
  int asked = 0;
  const internal::Search_effort effort{100, 50, 0, [&] {
                                         BOOST_REQUIRE(std::this_thread::get_id() == thread);
                                         return ++asked > 2;
                                       }};
  for (const auto& solution : solve<Endless_traits>(several, effort))
    BOOST_TEST(solution.status == internal::Box_solution::UNKNOWN);
  BOOST_TEST(asked > 2);
  const internal::Search_effort failing{100, 50, 0,
                                        []() -> bool { throw std::runtime_error("enough"); }};
  BOOST_CHECK_THROW(solve<Endless_traits>(several, failing), std::runtime_error);
}

BOOST_AUTO_TEST_SUITE_END()
