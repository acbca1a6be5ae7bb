// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <CGAL/Quad_layouts/internal/quantization/zero_half_cuts.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_zero_half_cuts)

namespace internal = CGAL::Quad_layouts::internal;
using internal::Integer_row;

namespace {

using Point = std::vector<double>;

std::vector<Integer_row> cuts_of(const std::vector<Integer_row>& rows, const Point& x)
{
  return internal::Zero_half_separation(rows, x).cuts(100, 2);
}

bool satisfies(const Point& x, const std::vector<Integer_row>& rows)
{
  return std::all_of(rows.begin(), rows.end(),
                     [&](const Integer_row& row) { return row.slack(x) >= -1e-9; });
}

// calls `visit` with all points of {0, ..., largest}^n
template <class Visit>
void for_each_point(std::size_t n, int largest, const Visit& visit)
{
  Point x(n, 0);
  for (;;) {
    visit(x);
    std::size_t j = 0;
    while (j < n && x[j] == largest)
      x[j++] = 0;
    if (j == n)
      return;
    ++x[j];
  }
}

} // namespace

// x0 + x1, x1 + x2, x0 + x2 >= 1 has the vertex (1/2, 1/2, 1/2), but two of three are needed.
BOOST_AUTO_TEST_CASE(finds_the_cut_of_a_triangle)
{
  const std::vector<Integer_row> rows{
      {{{0, -1}, {1, -1}}, -1}, {{{1, -1}, {2, -1}}, -1}, {{{0, -1}, {2, -1}}, -1}};
  const auto cuts = cuts_of(rows, {0.5, 0.5, 0.5});
  BOOST_REQUIRE_EQUAL(cuts.size(), 1u);
  const std::vector<std::pair<int, int>> expected{{0, -1}, {1, -1}, {2, -1}};
  BOOST_TEST((cuts.front().terms == expected));
  BOOST_TEST(cuts.front().bound == -2);
}

// 2x <= 3 is x <= 1; 2x >= 3 is x >= 2; both are violated by half at 3/2.
BOOST_AUTO_TEST_CASE(rounds_towards_minus_infinity)
{
  const auto below = cuts_of({{{{0, 2}}, 3}}, {1.5});
  BOOST_REQUIRE_EQUAL(below.size(), 1u);
  BOOST_TEST(below.front().terms.front().second == 1);
  BOOST_TEST(below.front().bound == 1);
  const auto above = cuts_of({{{{0, -2}}, -3}}, {1.5});
  BOOST_REQUIRE_EQUAL(above.size(), 1u);
  BOOST_TEST(above.front().terms.front().second == -1);
  BOOST_TEST(above.front().bound == -2);
}

BOOST_AUTO_TEST_CASE(integers_are_not_cut_off)
{
  BOOST_TEST(cuts_of({{{{0, 2}, {1, 1}}, 3}, {{{1, -1}}, -1}}, {1, 1}).empty());
}

BOOST_AUTO_TEST_CASE(returns_as_many_as_are_wanted)
{
  const std::vector<Integer_row> rows{{{{0, 2}}, 3}, {{{1, 2}}, 3}, {{{2, 2}}, 3}};
  const Point x(3, 1.5);
  BOOST_TEST(internal::Zero_half_separation(rows, x).cuts(2, 0).size() == 2u);
}

// In random programs each cut is violated by the point and by no integer solution.
BOOST_AUTO_TEST_CASE(cuts_keep_all_integer_solutions)
{
  std::mt19937 random(1);
  int found = 0;
  for (int run = 0; run < 500; ++run) {
    const std::size_t n = 4;
    std::vector<Integer_row> rows(6);
    Point x(n);
    for (double& value : x)
      value = (random() % 7) / 2.;
    for (Integer_row& row : rows) {
      row.bound = 0;
      for (int j = 0; j < int(n); ++j)
        if (const int coefficient = int(random() % 7) - 3; coefficient != 0)
          row.terms.emplace_back(j, coefficient);
      row.bound = int(std::ceil(-row.slack(x))); // x satisfies it, with little slack
    }
    const auto cuts = cuts_of(rows, x);
    found += int(cuts.size());
    for (const Integer_row& cut : cuts)
      BOOST_TEST(cut.slack(x) < 0);
    for_each_point(n, 4, [&](const Point& candidate) {
      if (satisfies(candidate, rows))
        BOOST_TEST(satisfies(candidate, cuts));
    });
  }
  BOOST_TEST(found > 200);
}

BOOST_AUTO_TEST_SUITE_END()
