// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Surfaces, fields and parameters of all kinds on their way through all stages. The random ones are
// from the seeds FIRST, FIRST + 1, ...:
//
//   test_all_stages [OPTION OF BOOST.TEST]... -- [--first FIRST] [--runs N] [--seconds S]

#define BOOST_TEST_MODULE all_stages
#include <boost/test/unit_test.hpp>

#include "all_stages.h"
#include "generated_fields.h"
#include "random_tasks.h"

#include <CGAL/Real_timer.h>

#include <boost/test/results_collector.hpp>

#include <iostream>
#include <map>
#include <string>

namespace QL = CGAL::Quad_layouts;
using all_stages::Results;
using all_stages::Task;
using generated::Mesh;

namespace {

// the options behind "--"
double option(const std::string& name, double value)
{
  const auto& suite = boost::unit_test::framework::master_test_suite();
  for (int i = 1; i + 1 < suite.argc; ++i)
    if (suite.argv[i] == name)
      value = std::stod(suite.argv[i + 1]);
  return value;
}

// runs a task; what comes of it in one or two words
std::string outcome(Task& task)
{
  Results results;
  try {
    return all_stages::run(task, results) ? "valid" : "no valid quantization";
  } catch (const QL::Invalid_mesh& error) {
    return "refused";
  } catch (const QL::Time_limit_exceeded& error) {
    return "time limit";
  } catch (const std::exception& error) {
    BOOST_ERROR(error.what());
    return "failure";
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(random_inputs)
{
  const auto first = unsigned(option("--first", 1));
  const int runs = int(option("--runs", 1000));
  const double seconds = option("--seconds", 20);
  CGAL::Real_timer timer;
  timer.start();
  std::map<std::string, int> outcomes;
  for (int i = 0; i < runs && timer.time() < seconds; ++i) {
    const unsigned seed = first + unsigned(i);
    Task task = random_tasks::random_task(seed);
    const double start = timer.time();
    std::cout << "seed " << seed << ": " << random_tasks::description(task) << std::flush;
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const std::string result = outcome(task);
      ++outcomes[result];
      std::cout << ": " << result << ", " << timer.time() - start << " s" << std::endl;
    }
  }
  for (const auto& [name, count] : outcomes)
    std::cout << name << ": " << count << '\n';
}
