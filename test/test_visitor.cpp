// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include <CGAL/Quad_layouts/visitor.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

BOOST_AUTO_TEST_SUITE(test_visitor)

namespace QL = CGAL::Quad_layouts;
namespace params = QL::parameters;

namespace {

// writes down what it is told, and stops the work after `patience` reports
struct Diary : QL::Default_visitor
{
  std::shared_ptr<std::string> text = std::make_shared<std::string>();
  int patience = 100;

  void before_stage(const char* name) { *text += std::string("<") + name; }
  void after_stage(const char* name, double seconds)
  {
    BOOST_TEST(seconds >= 0);
    *text += std::string(name) + ">";
  }
  void progress(const char*, double fraction) { *text += fraction < 1 ? "." : "!"; }
  void improved(double objective, double bound, double)
  {
    *text += std::to_string(int(objective)) + "/" + std::to_string(int(bound));
  }
  void changed_route(const char* reason) { *text += std::string("(") + reason + ")"; }
  bool go_on() { return --patience >= 0; }
};

template <class NamedParameters>
int work(const NamedParameters& np)
{
  const QL::internal::Monitor monitor = QL::internal::monitor_from(np);
  monitor.run("a", [&] { monitor.report("a", 0.5); });
  return monitor.run("b", [&] {
    monitor.improved(9, 8, 0.1);
    monitor.report("b", 1);
    monitor.changed_route("c");
    return 42;
  });
}

} // namespace

BOOST_AUTO_TEST_CASE(no_visitor)
{
  BOOST_TEST(work(params::default_values()) == 42);
  BOOST_TEST(work(params::visitor(QL::Default_visitor())) == 42);
}

BOOST_AUTO_TEST_CASE(visitor_by_reference)
{
  Diary diary;
  BOOST_TEST(work(params::visitor(std::ref(diary)).maximum_deviation(20)) == 42);
  BOOST_TEST(*diary.text == "<a.a><b9/8!(c)b>");
  BOOST_TEST(diary.patience == 96); // asked before each of two stages, and at each report
}

BOOST_AUTO_TEST_CASE(visitor_by_value)
{
  const Diary diary;
  BOOST_TEST(work(CGAL::parameters::visitor(diary)) == 42);
  BOOST_TEST(*diary.text == "<a.a><b9/8!(c)b>");
  BOOST_TEST(diary.patience == 100);
}

BOOST_AUTO_TEST_CASE(time_limit_stops_the_work)
{
  Diary diary;
  const auto np = params::visitor(std::ref(diary));
  BOOST_CHECK_THROW(work(np.maximum_running_time(1e-9)), QL::Time_limit_exceeded);
  BOOST_TEST(*diary.text == "<a.");
  BOOST_TEST(work(np.maximum_running_time(1e30)) == 42);
  for (const double seconds : {0., -1., std::nan("")})
    BOOST_CHECK_THROW(work(np.maximum_running_time(seconds)), QL::Invalid_parameter);
}

BOOST_AUTO_TEST_CASE(work_with_a_result_at_any_time_ends_early)
{
  const QL::internal::Monitor endless, limited = endless.limited_to(1e-9);
  BOOST_TEST(endless.has_time("a"));
  BOOST_TEST(!limited.has_time("a"));
  BOOST_TEST(!limited.limited_to(100).has_time("a"));
  BOOST_TEST(endless.limited_to(100).has_time("a"));
}

BOOST_AUTO_TEST_CASE(visitor_stops_the_work)
{
  Diary diary;
  diary.patience = 3;
  BOOST_CHECK_THROW(work(params::visitor(std::ref(diary))), QL::Cancelled);
  BOOST_TEST(*diary.text == "<a.a><b9/8!");
}

BOOST_AUTO_TEST_CASE(who_has_stopped_the_work_is_not_asked_again)
{
  int asked = 0;
  const QL::internal::Monitor monitor([&] { return ++asked != 2; }, {});
  const QL::internal::Monitor limited = monitor.limited_to(1000);
  BOOST_TEST(!limited.stopped());
  BOOST_TEST(limited.stopped());
  BOOST_TEST(limited.stopped());
  BOOST_CHECK_THROW(monitor.check("a"), QL::Cancelled);
  BOOST_TEST(asked == 2);
}

BOOST_AUTO_TEST_SUITE_END()
