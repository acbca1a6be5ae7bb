// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <CGAL/Quad_layouts/internal/quantization/Neighbourhood_schedule.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_Neighbourhood_schedule)

using Schedule = CGAL::Quad_layouts::internal::Neighbourhood_schedule;

namespace {

constexpr int variables = 10; // of kind 0; those of kind k have k + 1 times as many

// returns how often each kind comes in many searches, of which those of `successful` improve
std::vector<int> frequencies(int searches, int successful = Schedule::NUMBER_OF_KINDS)
{
  Schedule schedule(100, variables);
  std::vector<int> result(Schedule::NUMBER_OF_KINDS, 0);
  for (int i = 0; i < searches; ++i) {
    const auto kind = schedule.next();
    ++result[kind];
    schedule.begin(kind, (kind + 1) * variables);
    schedule.end(kind, (kind + 1) * variables, true, kind == successful);
  }
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(kinds_have_the_same_share_of_the_work)
{
  const std::vector<int> often = frequencies(1000);
  for (int kind = 0; kind < Schedule::NUMBER_OF_KINDS; ++kind) {
    const int work = often[kind] * (kind + 1), work_of_first = often[0];
    BOOST_TEST(work >= work_of_first - Schedule::NUMBER_OF_KINDS);
    BOOST_TEST(work <= work_of_first + Schedule::NUMBER_OF_KINDS);
  }
}

BOOST_AUTO_TEST_CASE(success_is_followed_up)
{
  const std::vector<int> often = frequencies(1000, Schedule::LOOP);
  BOOST_TEST(often[Schedule::LOOP] > 500);
  BOOST_TEST(*std::min_element(often.begin(), often.end()) > 0);
}

BOOST_AUTO_TEST_CASE(searches_that_end_at_their_limit_are_dear)
{
  Schedule schedule(100, variables);
  schedule.begin(Schedule::REGION, variables);
  schedule.end(Schedule::REGION, variables, false, false);
  int others = 0;
  for (; schedule.next() != Schedule::REGION; ++others)
    schedule.begin(schedule.next(), variables);
  BOOST_TEST(others > 2 * Schedule::NUMBER_OF_KINDS);
}

BOOST_AUTO_TEST_CASE(sizes_fit_what_can_be_solved)
{
  constexpr int most = 50, solvable = 20;
  Schedule schedule(most, variables);
  const auto search = [&](int largest, bool improved) {
    const int size = schedule.size(Schedule::LOOP);
    schedule.begin(Schedule::LOOP, variables);
    schedule.end(Schedule::LOOP, variables, size <= largest, improved);
    return size;
  };
  for (int i = 0; i < 100; ++i) {
    const int size = search(solvable, false);
    if (i > 10) {
      BOOST_TEST(size > solvable / 2);
      BOOST_TEST(size < 2 * solvable);
    }
  }
  const int size = schedule.size(Schedule::LOOP);
  BOOST_TEST(search(most, true) == size);
  BOOST_TEST(search(most, true) == size); // good as it is
  for (int i = 0; i < 100; ++i)
    search(most, false);
  BOOST_TEST(schedule.size(Schedule::LOOP) == most);
  for (int i = 0; i < 100; ++i)
    search(0, false);
  BOOST_TEST(schedule.size(Schedule::LOOP) >= 1);
}

BOOST_AUTO_TEST_SUITE_END()
