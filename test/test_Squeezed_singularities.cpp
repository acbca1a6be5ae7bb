// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "generated_fields.h"
#include "generated_meshes.h"
#include "invariants.h"
#include "traced_graphs.h"

#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <map>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_Squeezed_singularities)

namespace QL = CGAL::Quad_layouts;
namespace internal = CGAL::Quad_layouts::internal;
using traced_graphs::motorcycle_graph;

namespace {

// By a linear program: says which arcs are positive in some consistent quantization. As these can
// be added and scaled, some are at least 1 wherever they can be positive.
std::vector<char> can_be_positive(const QL::T_mesh& t)
{
  using Program = QL::GLPK_mixed_integer_program_traits<double>;
  constexpr double infinity = (std::numeric_limits<double>::max)();
  Program program;
  Program::Linear_objective* objective = program.create_objective(
      Program::Linear_objective::MAXIMIZE);
  std::vector<Program::Variable*> length, part; // part <= length, part <= 1
  for (int a = 0; a < t.number_of_edges(); ++a) {
    length.push_back(program.create_variable(Program::Variable::CONTINUOUS, 0, infinity));
    part.push_back(program.create_variable(Program::Variable::CONTINUOUS, 0, 1));
    Program::Linear_constraint* row = program.create_constraint(0, infinity);
    row->add_coefficient(length[a], 1);
    row->add_coefficient(part[a], -1);
    objective->add_coefficient(part[a], 1);
  }
  for (int p = 0; p < t.number_of_faces(); ++p) {
    const auto sides = t.sides(p);
    for (const int k : {0, 1}) {
      std::map<int, int> difference; // of opposite sides, which may share arcs
      for (const int h : sides[k])
        ++difference[QL::T_mesh::edge(h)];
      for (const int h : sides[k + 2])
        --difference[QL::T_mesh::edge(h)];
      Program::Linear_constraint* row = program.create_constraint(0, 0);
      for (const auto& [arc, coefficient] : difference)
        row->add_coefficient(length[arc], coefficient);
    }
  }
  BOOST_REQUIRE(program.solve());
  std::vector<char> result;
  for (const Program::Variable* p : part)
    result.push_back(p->solution_value() > 0.5);
  return result;
}

// the node at the end of a chain of arcs that begins at a node
int end_of_chain(const QL::T_mesh& t, int node, const std::vector<int>& chain)
{
  for (const int a : chain) {
    BOOST_TEST((t.source(2 * a) == node || t.target(2 * a) == node));
    node = t.source(2 * a) == node ? t.target(2 * a) : t.source(2 * a);
  }
  return node;
}

QL::Cross_field field_of(unsigned seed)
{
  switch (seed % 3) {
    case 0: return generated::random_field(generated::torus(9, 6), seed);
    case 1: return generated::random_field(generated::icosphere(1), seed);
    default: return generated::random_field(generated::cube(3), seed);
  }
}

// A field along the rings of a torus, but for two singularities. There is no quad mesh of a torus
// with just one vertex of valence 3 and one of valence 5 (Izmestiev et al. 2013).
QL::Cross_field dipole_on_torus()
{
  const auto around_z = [](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p.y(), p.x(), 0); };
  const auto turn = [](const Eigen::Vector3d& p) {
    const double radius = std::hypot(p.x(), p.y());
    const std::complex<double> z(3 * std::atan2(p.y(), p.x()), std::atan2(p.z(), radius - 2));
    return std::arg((z - 0.5) / (z + 0.5)) / 4;
  };
  return generated::field_along(generated::torus(41, 21), around_z, turn);
}

} // namespace

BOOST_AUTO_TEST_CASE(chains_are_squeezed_in_all_consistent_quantizations)
{
  int chains = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const QL::T_mesh t = motorcycle_graph(field_of(seed), {});
    const std::vector<char> positive = can_be_positive(t);
    const internal::Squeezed_singularities squeezed(t);
    for (const std::vector<int>& chain : squeezed.chains()) {
      ++chains;
      BOOST_TEST_REQUIRE(!chain.empty());
      BOOST_TEST(std::none_of(chain.begin(), chain.end(), [&](int a) { return positive[a]; }));
      const int a = chain.front();
      const int start = t.index(t.source(2 * a)) != 0 ? t.source(2 * a) : t.target(2 * a);
      BOOST_TEST(t.index(start) != 0);
      BOOST_TEST(t.index(end_of_chain(t, start, chain)) != 0);
    }
  }
  BOOST_TEST(chains > 0);
}

// Where the linear program finds no chain, neither does the search along strips.
BOOST_AUTO_TEST_CASE(finds_all_groups)
{
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const QL::T_mesh t = motorcycle_graph(field_of(seed), {});
    const std::vector<char> positive = can_be_positive(t);
    internal::Disjoint_sets nodes(t.number_of_vertices());
    for (int a = 0; a < t.number_of_edges(); ++a)
      if (!positive[a])
        nodes.union_set(t.source(2 * a), t.target(2 * a));
    std::map<int, int> singularities;
    for (int n = 0; n < t.number_of_vertices(); ++n)
      if (t.index(n) != 0)
        ++singularities[nodes.find_set(n)];
    const auto groups = std::count_if(singularities.begin(), singularities.end(),
                                      [](const auto& group) { return group.second > 1; });
    BOOST_TEST(groups == int(internal::Squeezed_singularities(t).chains().size()));
  }
}

BOOST_AUTO_TEST_CASE(hasty_traces_release_them)
{
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const QL::Cross_field field = field_of(seed);
    std::vector<char> is_hasty;
    QL::T_mesh t = motorcycle_graph(field, is_hasty);
    while (internal::Squeezed_singularities(t).release(is_hasty))
      t = motorcycle_graph(field, is_hasty);
    BOOST_TEST_CONTEXT("seed " << seed)
    BOOST_TEST(internal::Squeezed_singularities(t).chains().empty());
    invariants::check_t_mesh(t);
  }
}

BOOST_AUTO_TEST_CASE(gives_up_where_no_quad_mesh_has_these_valences)
{
  const QL::Cross_field field = dipole_on_torus();
  BOOST_REQUIRE_EQUAL(field.number_of_singularities(), 2);
  const QL::T_mesh t = QL::trace_motorcycle_graph(field);
  invariants::check_t_mesh(t);
  const internal::Squeezed_singularities squeezed(t);
  BOOST_TEST(squeezed.chains().size() == 1);
  BOOST_TEST(squeezed.number_of_losses() == 1);
  std::vector<char> is_hasty(t.traces.size(), 1);
  BOOST_TEST(!squeezed.release(is_hasty));
}

// All were shortened, in vain.
BOOST_AUTO_TEST_CASE(what_falls_together_anyway_shortens_no_traces)
{
  const QL::Cross_field field = dipole_on_torus();
  const QL::T_mesh extended = QL::trace_motorcycle_graph(field);
  std::vector<char> is_hasty(extended.traces.size(), 1);
  BOOST_TEST(extended.number_of_edges() > motorcycle_graph(field, is_hasty).number_of_edges());
}

BOOST_AUTO_TEST_CASE(does_not_touch_what_can_be_separated)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::cube(4));
  std::vector<char> is_hasty;
  const QL::T_mesh t = motorcycle_graph(field, is_hasty);
  const internal::Squeezed_singularities squeezed(t);
  BOOST_TEST(squeezed.chains().empty());
  BOOST_TEST(!squeezed.release(is_hasty));
  BOOST_TEST(std::count(is_hasty.begin(), is_hasty.end(), 1) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
