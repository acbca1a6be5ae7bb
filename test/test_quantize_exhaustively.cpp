// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "exhaustive_search.h"

#include <CGAL/Quad_layouts/extract_quad_layout.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_quantize_exhaustively)

using namespace exhaustive_search;

namespace {

bool are_zero(const std::vector<int>& arcs, const Lengths& lengths)
{
  return std::all_of(arcs.begin(), arcs.end(), [&](int a) { return lengths[a] == 0; });
}

} // namespace

// No consistent quantization that makes a legal layout is better than what is returned as optimal.
BOOST_AUTO_TEST_CASE(the_optimum_is_one)
{
  int proven = 0, reached = 0;
  for (const Case& c : cases())
    BOOST_TEST_CONTEXT(c.name)
    {
      const QL::Quantization q = QL::quantize(c.t_mesh, parameters::maximum_deviation(40.)
                                                            .maximum_displacement(c.displacement)
                                                            .target_edge_length(c.edge_length)
                                                            .relative_gap(0.)
                                                            .maximum_running_time(2.));
      const Judge judge(c);
      const Verdict own = judge(q.arc_length);
      BOOST_TEST(own.is_valid);
      double best = (std::numeric_limits<double>::max)(), best_legal = best;
      Enumeration(c.t_mesh, largest_length).run(most, [&](const Lengths& lengths) {
        const double objective = judge.objective(lengths);
        if (objective >= best && objective >= best_legal)
          return;
        const Verdict other = judge(lengths);
        if (other.is_valid)
          best = (std::min)(best, objective);
        if (other.is_valid && other.is_legal)
          best_legal = (std::min)(best_legal, objective);
      });
      // what is illegal is put up with where nothing legal exists
      BOOST_TEST((own.is_legal || best_legal > best));
      const double least = own.is_legal ? best_legal : best;
      BOOST_TEST(q.bound <= least * (1 + 1e-9));
      if (q.status == QL::Quantization::OPTIMAL) {
        ++proven;
        BOOST_TEST(least >= q.objective * (1 - 1e-9));
        reached += least <= q.objective * (1 + 1e-9);
      }
      BOOST_TEST_MESSAGE(c.name << ": " << q.objective << ", bound " << q.bound << ", enumerated "
                                << least);
    }
  BOOST_TEST(proven > 30);
  BOOST_TEST(reached > 25); // where lengths up to the bound are enough
}

// What is not valid gets a cut that excludes it, and no valid layout if it is said to be exact.
BOOST_AUTO_TEST_CASE(cuts_exclude_what_is_not_valid)
{
  int invalid = 0, uncut = 0, exact = 0, wrong = 0;
  for (const Case& c : cases()) {
    std::set<std::vector<int>> exact_cuts;
    std::vector<Lengths> valid;
    Enumeration(c.t_mesh, 2).run(500, [&](const Lengths& lengths) {
      const auto report = internal::examine_quotient(c.t_mesh, lengths);
      invalid += !report.valid;
      uncut += report.valid != report.cuts.empty();
      if (report.valid)
        valid.push_back(lengths);
      for (const auto& [arcs, is_exact] : report.cuts) {
        uncut += !are_zero(arcs, lengths);
        if (is_exact)
          exact_cuts.insert(arcs);
      }
    });
    exact += int(exact_cuts.size());
    for (const std::vector<int>& arcs : exact_cuts)
      for (const Lengths& lengths : valid)
        wrong += are_zero(arcs, lengths);
  }
  BOOST_TEST(invalid > 100);
  BOOST_TEST(uncut == 0);
  BOOST_TEST(exact > 20);
  BOOST_TEST(wrong == 0);
}

// What is said to be valid makes a layout of the same surface, whose irregular vertices are the
// merged singularities.
BOOST_AUTO_TEST_CASE(valid_quantizations_make_layouts)
{
  int layouts = 0, merged = 0;
  for (const Case& c : cases()) {
    const Judge judge(c);
    Enumeration(c.t_mesh, 2).run(200, [&](const Lengths& lengths) {
      const Verdict v = judge(lengths);
      if (!v.is_valid)
        return;
      ++layouts;
      const QL::Quad_layout layout = QL::extract_quad_layout(c.t_mesh, as_quantization(lengths));
      BOOST_TEST(layout.euler_characteristic() == c.t_mesh.euler_characteristic());
      std::vector<int> index(layout.number_of_vertices(), 0);
      for (const auto& cluster : v.report.clusters) {
        merged += cluster.nodes.size() > 1;
        for (const int n : cluster.nodes)
          index[layout.node_vertex[n]] += c.t_mesh.index(n);
      }
      int wrong = 0;
      for (int w = 0; w < layout.number_of_vertices(); ++w)
        wrong += layout.valence(w) != 4 - index[w];
      BOOST_TEST(wrong == 0);
    });
  }
  BOOST_TEST(layouts > 100);
  BOOST_TEST(merged > 100);
}

BOOST_AUTO_TEST_SUITE_END()
