// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <CGAL/Quad_layouts/try_layout_routes.h>

#include <boost/test/unit_test.hpp>

#include <functional>
#include <map>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_try_layout_routes)

namespace QL = CGAL::Quad_layouts;
namespace parameters = CGAL::Quad_layouts::parameters;

namespace {

struct Result
{
  QL::Layout_route route;
  std::size_t number_of_bad_quads;
};

// makes results that are prepared, or fails, and notes the routes that it is asked for
struct Attempt
{
  std::map<QL::Layout_route, std::function<Result()>> prepared;
  std::vector<QL::Layout_route>& asked;

  Result operator()(QL::Layout_route route) const
  {
    asked.push_back(route);
    return prepared.at(route)();
  }
};

std::function<Result()> made(QL::Layout_route route, std::size_t number_of_bad_quads)
{
  return [=] { return Result{route, number_of_bad_quads}; };
}

template <class Exception>
std::function<Result()> failed(const char* reason)
{
  return [=]() -> Result { throw Exception(reason); };
}

struct Diary : QL::Default_visitor
{
  std::string reason;
  void changed_route(const char* why) { reason = why; }
};

// what there was, and what came of it
struct Trial
{
  std::vector<QL::Layout_route> asked;
  Diary diary;
  Result result;

  Trial(std::function<Result()> automatic, std::function<Result()> by_field)
    : result(
          QL::try_layout_routes(Attempt{{{QL::AUTOMATIC, automatic}, {QL::FIELD, by_field}}, asked},
                                parameters::visitor(std::ref(diary))))
  {
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(a_good_result_is_taken_at_once)
{
  for (const QL::Layout_route route : {QL::FIELD, QL::PARAMETRIZATION}) {
    const Trial trial(made(route, 0), failed<QL::Stage_failure>("not tried"));
    BOOST_TEST(trial.asked.size() == 1u);
    BOOST_TEST(trial.result.route == route);
    BOOST_TEST(trial.diary.reason == "");
  }
}

BOOST_AUTO_TEST_CASE(the_other_route_is_tried_once)
{
  const Trial better(made(QL::PARAMETRIZATION, 2), made(QL::FIELD, 1));
  BOOST_TEST((better.asked == std::vector<QL::Layout_route>{QL::AUTOMATIC, QL::FIELD}));
  BOOST_TEST(better.result.route == QL::FIELD);
  BOOST_TEST(better.diary.reason == "2 bad quads");
  const Trial equal(made(QL::PARAMETRIZATION, 1), made(QL::FIELD, 1));
  BOOST_TEST(equal.result.route == QL::PARAMETRIZATION);
  const Trial same_route(made(QL::FIELD, 1), failed<QL::Stage_failure>("not tried"));
  BOOST_TEST(same_route.result.number_of_bad_quads == 1u);
}

BOOST_AUTO_TEST_CASE(failures_are_overcome)
{
  const Trial first(failed<QL::Stage_failure>("no layout"), made(QL::FIELD, 0));
  BOOST_TEST(first.result.route == QL::FIELD);
  BOOST_TEST(first.diary.reason == "no layout");
  const Trial second(made(QL::PARAMETRIZATION, 3), failed<QL::Stage_failure>("no layout"));
  BOOST_TEST(second.result.number_of_bad_quads == 3u);
  const Trial late(made(QL::PARAMETRIZATION, 3), failed<QL::Time_limit_exceeded>("too late"));
  BOOST_TEST(late.result.number_of_bad_quads == 3u);
  BOOST_CHECK_THROW(
      Trial(failed<QL::Stage_failure>("no layout"), failed<QL::Stage_failure>("none, either")),
      QL::Stage_failure);
  BOOST_CHECK_THROW(Trial(failed<QL::Cancelled>("stop"), made(QL::FIELD, 0)), QL::Cancelled);
  BOOST_CHECK_THROW(Trial(made(QL::PARAMETRIZATION, 1), failed<QL::Cancelled>("stop")),
                    QL::Cancelled);
}

BOOST_AUTO_TEST_CASE(a_route_that_was_asked_for_is_kept)
{
  for (const QL::Layout_route route : {QL::FIELD, QL::PARAMETRIZATION}) {
    std::vector<QL::Layout_route> asked;
    const Attempt attempt{{{route, made(route, 5)}}, asked};
    BOOST_TEST(
        QL::try_layout_routes(attempt, parameters::layout_route(route)).number_of_bad_quads == 5u);
    BOOST_TEST((asked == std::vector<QL::Layout_route>{route}));
  }
}

BOOST_AUTO_TEST_SUITE_END()
