// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <CGAL/Quad_layouts/try_layout_routes.h>

#include <boost/test/unit_test.hpp>

#include <functional>
#include <stdexcept>
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

// What is made of T-meshes is prepared: by the route that was asked for, and by the field where
// something else was. `automatic` is the route of the T-mesh that the route `AUTOMATIC` leads to.
struct Attempts
{
  QL::Layout_route automatic;
  std::function<Result()> made_first, made_by_field;
  std::vector<QL::Layout_route> asked;

  template <class NamedParameters>
  Result best(const NamedParameters& np)
  {
    const auto trace = [&](QL::Layout_route route) {
      asked.push_back(route);
      QL::T_mesh t_mesh;
      t_mesh.route = route == QL::AUTOMATIC ? automatic : route;
      return t_mesh;
    };
    const auto remesh = [&](const QL::T_mesh&) {
      return asked.size() == 1 ? made_first() : made_by_field();
    };
    return QL::try_layout_routes(trace, remesh, np);
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

const std::function<Result()> not_tried = failed<std::logic_error>("tried");

} // namespace

BOOST_AUTO_TEST_CASE(a_good_result_is_taken_at_once)
{
  for (const QL::Layout_route route : {QL::FIELD, QL::PARAMETRIZATION}) {
    Diary diary;
    Attempts attempts{route, made(route, 0), not_tried, {}};
    BOOST_TEST(attempts.best(parameters::visitor(std::ref(diary))).route == route);
    BOOST_TEST((attempts.asked == std::vector<QL::Layout_route>{QL::AUTOMATIC}));
    BOOST_TEST(diary.reason == "");
  }
}

BOOST_AUTO_TEST_CASE(the_other_route_is_tried_once)
{
  Diary diary;
  const auto np = parameters::visitor(std::ref(diary));
  Attempts better{QL::PARAMETRIZATION, made(QL::PARAMETRIZATION, 2), made(QL::FIELD, 1), {}};
  BOOST_TEST(better.best(np).route == QL::FIELD);
  BOOST_TEST((better.asked == std::vector<QL::Layout_route>{QL::AUTOMATIC, QL::FIELD}));
  BOOST_TEST(diary.reason == "2 bad quads");
  Attempts equal{QL::PARAMETRIZATION, made(QL::PARAMETRIZATION, 1), made(QL::FIELD, 1), {}};
  BOOST_TEST(equal.best(np).route == QL::PARAMETRIZATION);
}

// Where the automatic route is the field, the same would only happen again.
BOOST_AUTO_TEST_CASE(nothing_is_tried_twice)
{
  Attempts bad{QL::FIELD, made(QL::FIELD, 1), not_tried, {}};
  BOOST_TEST(bad.best(parameters::default_values()).number_of_bad_quads == 1u);
  Attempts failing{QL::FIELD, failed<QL::Stage_failure>("no layout"), not_tried, {}};
  BOOST_CHECK_THROW(failing.best(parameters::default_values()), QL::Stage_failure);
}

BOOST_AUTO_TEST_CASE(failures_are_overcome)
{
  Diary diary;
  const auto best = [&](std::function<Result()> first, std::function<Result()> by_field) {
    return Attempts{QL::PARAMETRIZATION, first, by_field, {}}.best(
        parameters::visitor(std::ref(diary)));
  };
  const auto failure = failed<QL::Stage_failure>("no layout"), stop = failed<QL::Cancelled>("stop");
  const auto bad = made(QL::PARAMETRIZATION, 3), good = made(QL::FIELD, 0);
  BOOST_TEST(best(failure, good).route == QL::FIELD);
  BOOST_TEST(diary.reason == "no layout");
  BOOST_TEST(best(bad, failure).number_of_bad_quads == 3u);
  BOOST_TEST(best(bad, failed<QL::Time_limit_exceeded>("late")).number_of_bad_quads == 3u);
  BOOST_CHECK_THROW(best(failure, failure), QL::Stage_failure);
  BOOST_CHECK_THROW(best(stop, good), QL::Cancelled);
  BOOST_CHECK_THROW(best(bad, stop), QL::Cancelled);
}

BOOST_AUTO_TEST_CASE(a_route_that_was_asked_for_is_kept)
{
  for (const QL::Layout_route route : {QL::FIELD, QL::PARAMETRIZATION}) {
    Attempts attempts{route, made(route, 5), not_tried, {}};
    BOOST_TEST(attempts.best(parameters::layout_route(route)).number_of_bad_quads == 5u);
    BOOST_TEST((attempts.asked == std::vector<QL::Layout_route>{route}));
  }
}

BOOST_AUTO_TEST_SUITE_END()
