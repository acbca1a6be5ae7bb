// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#define BOOST_TEST_MODULE quantize_exhaustively
#include "generated_fields.h"
#include "generated_meshes.h"

#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace QL = CGAL::Quad_layouts;
namespace internal = CGAL::Quad_layouts::internal;
namespace parameters = CGAL::Quad_layouts::parameters;

namespace {

using Lengths = std::vector<int>; // per arc

// Lists all consistent quantizations of a T-mesh with lengths up to a bound: arcs are decided one
// after the other, and what follows from the equality of opposite sides is concluded at once.
class Enumeration
{
public:
  Enumeration(const QL::T_mesh& t_mesh, int largest)
    : m_largest(largest), m_length(t_mesh.number_of_edges(), UNKNOWN),
      m_equations_of(t_mesh.number_of_edges())
  {
    for (int p = 0; p < t_mesh.number_of_faces(); ++p) {
      const auto sides = t_mesh.sides(p);
      for (const int k : {0, 1})
        add_equation(sides[k], sides[k + 2]);
    }
  }

  // Calls `visit` for each; stops and returns false if there are more than `limit`.
  template <class Visit>
  bool run(int limit, Visit&& visit)
  {
    m_left = limit;
    return decide(0, visit);
  }

private:
  static constexpr int UNKNOWN = -1;
  struct Equation
  {
    std::vector<int> left, right;
  };

  void add_equation(const std::vector<int>& left, const std::vector<int>& right)
  {
    Equation e;
    for (const int h : left)
      e.left.push_back(QL::T_mesh::edge(h));
    for (const int h : right)
      e.right.push_back(QL::T_mesh::edge(h));
    for (const auto* side : {&e.left, &e.right})
      for (const int a : *side)
        m_equations_of[a].push_back(int(m_equations.size()));
    m_equations.push_back(std::move(e));
  }

  template <class Visit>
  bool decide(int arc, Visit&& visit)
  {
    while (arc < int(m_length.size()) && m_length[arc] != UNKNOWN)
      ++arc;
    if (arc == int(m_length.size())) {
      visit(m_length);
      return --m_left > 0;
    }
    for (int length = 0; length <= m_largest; ++length) {
      std::vector<int> decided;
      bool goes_on = true;
      if (set(arc, length, decided))
        goes_on = decide(arc, visit);
      for (const int a : decided)
        m_length[a] = UNKNOWN;
      if (!goes_on)
        return false;
    }
    return true;
  }

  // returns false if that contradicts an equation
  bool set(int arc, int length, std::vector<int>& decided)
  {
    if (m_length[arc] != UNKNOWN)
      return m_length[arc] == length;
    if (length < 0 || length > m_largest)
      return false;
    m_length[arc] = length;
    decided.push_back(arc);
    return std::all_of(m_equations_of[arc].begin(), m_equations_of[arc].end(),
                       [&](int e) { return conclude(m_equations[e], decided); });
  }

  bool conclude(const Equation& e, std::vector<int>& decided)
  {
    int unknown = -1, unknowns = 0, sign = 1, difference = 0; // of the right and the left
    for (const bool is_left : {true, false})
      for (const int a : is_left ? e.left : e.right)
        if (m_length[a] == UNKNOWN) {
          unknown = a;
          ++unknowns;
          sign = is_left ? 1 : -1;
        } else
          difference += is_left ? -m_length[a] : m_length[a];
    if (unknowns == 0)
      return difference == 0;
    return unknowns > 1 || set(unknown, sign * difference, decided);
  }

  int m_largest, m_left = 0;
  Lengths m_length;
  std::vector<Equation> m_equations;
  std::vector<std::vector<int>> m_equations_of; // per arc
};

// T-meshes with few arcs, and with merges to decide on
struct Case
{
  std::string name;
  QL::T_mesh t_mesh;
  double displacement, edge_length;
};

std::vector<Case> cases()
{
  std::vector<Case> result;
  const auto add = [&](const std::string& name, const QL::Cross_field& field) {
    const double h = 0.1 * field.surface().diagonal();
    for (const double r : {0., 1., 3.}) {
      const auto np = parameters::maximum_deviation(40.).maximum_displacement(r).target_edge_length(
          h);
      result.push_back({name + ", displacement " + std::to_string(int(r)),
                        QL::trace_motorcycle_graph(field, np), r, h});
    }
  };
  add("cube", QL::compute_cross_field(generated::cube(2)));
  add("torus", QL::compute_cross_field(generated::torus(12, 8)));
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const std::string number = std::to_string(seed);
    add("tetrahedron " + number, generated::random_field(generated::tetrahedron(), seed));
    add("small cube " + number, generated::random_field(generated::cube(1), seed));
    add("small torus " + number, generated::random_field(generated::torus(4, 3), seed));
  }
  return result;
}

// What a quantization amounts to, all told.
struct Verdict
{
  bool is_valid; // a layout of the same surface
  bool is_legal; // all merged indices are in range, and at displacement 0 nothing merges
  internal::Quotient_report report;
};

class Judge
{
public:
  explicit Judge(const Case& c)
    : m_case(c), m_demands{std::tan(40 * generated::pi / 180), 2 * c.displacement * c.edge_length,
                           -4, 1},
      m_program(internal::build_quantization_program(c.t_mesh, m_demands))
  {
  }

  // Equation (9)
  double objective(const Lengths& lengths) const
  {
    const auto check = internal::check_quantization(m_case.t_mesh, m_program, lengths);
    BOOST_REQUIRE(check.consistent);
    return check.objective;
  }

  Verdict operator()(const Lengths& lengths) const
  {
    internal::Quotient_report report = internal::examine_quotient(m_case.t_mesh, lengths);
    const bool legal = std::all_of(report.clusters.begin(), report.clusters.end(),
                                   [&](const auto& cluster) { return is_legal(cluster); });
    return {report.valid, legal, std::move(report)};
  }

private:
  bool is_legal(const internal::Merged_cluster& cluster) const
  {
    int singularities = 0, low = m_demands.minimum_index, high = m_demands.maximum_index;
    for (const int n : cluster.nodes) {
      const int index = m_case.t_mesh.index(n);
      singularities += index != 0;
      low = (std::min)(low, index);
      high = (std::max)(high, index);
    }
    return cluster.index >= low && cluster.index <= high &&
           (m_case.displacement > 0 || singularities < 2);
  }

  const Case& m_case;
  const internal::Quantization_demands m_demands;
  const internal::Quantization_program m_program;
};

QL::Quantization as_quantization(const Lengths& lengths)
{
  QL::Quantization result;
  result.arc_length = lengths;
  result.status = QL::Quantization::FEASIBLE;
  return result;
}

bool are_zero(const std::vector<int>& arcs, const Lengths& lengths)
{
  return std::all_of(arcs.begin(), arcs.end(), [&](int a) { return lengths[a] == 0; });
}

constexpr int largest_length = 2, most = 50000;

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
