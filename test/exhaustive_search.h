// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_TEST_EXHAUSTIVE_SEARCH_H
#define QUAD_LAYOUTS_TEST_EXHAUSTIVE_SEARCH_H

#include "generated_fields.h"
#include "generated_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/number_type_config.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

// What quantizations of tiny T-meshes are there, and which is the best?
namespace exhaustive_search {

namespace QL = CGAL::Quad_layouts;
namespace internal = CGAL::Quad_layouts::internal;
namespace parameters = CGAL::Quad_layouts::parameters;

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

inline std::vector<Case> cases()
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
    : m_case(c), m_demands{std::tan(40 * CGAL_PI / 180), 2 * c.displacement * c.edge_length,
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

inline QL::Quantization as_quantization(const Lengths& lengths)
{
  QL::Quantization result;
  result.arc_length = lengths;
  result.status = QL::Quantization::FEASIBLE;
  return result;
}

constexpr int largest_length = 2, most = 50000;

} // namespace exhaustive_search

#endif // QUAD_LAYOUTS_TEST_EXHAUSTIVE_SEARCH_H
