// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "generated_fields.h"
#include "generated_meshes.h"
#include "traced_graphs.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/internal/quantization/Incumbent.h>
#include <CGAL/Quad_layouts/internal/quantization/check_quantization.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/number_type_config.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

// Are the crossings of traces all there that rows are needed for, and do layout edges therefore
// keep to the maximum deviation? Traces that run on much farther show the crossings that a T-mesh
// lacks.

BOOST_AUTO_TEST_SUITE(test_completeness)

namespace QL = CGAL::Quad_layouts;
namespace internal = CGAL::Quad_layouts::internal;
namespace parameters = CGAL::Quad_layouts::parameters;
using internal::Quantization_program;
using traced_graphs::motorcycle_graph;

namespace {

constexpr double edge_length = 0.1;

QL::T_mesh traced(const QL::Cross_field& field, double deviation, double displacement)
{
  return QL::trace_motorcycle_graph(field, parameters::maximum_deviation(deviation)
                                               .maximum_displacement(displacement)
                                               .target_edge_length(edge_length));
}

struct Program_of
{
  Program_of(QL::T_mesh t, const internal::Quantization_demands& demands)
    : t_mesh(std::move(t)), runs(t_mesh),
      program(internal::build_quantization_program(t_mesh, demands))
  {
  }

  QL::T_mesh t_mesh;
  internal::Runs runs;
  Quantization_program program;
};

// Divides the rows (2) and (6) of a T-mesh into those of crossings that `other`, whose traces are
// shorter, has as well, and those of crossings that it lacks.
std::array<Quantization_program, 2> divided(const Program_of& far, const Program_of& other)
{
  std::array<Quantization_program, 2> result{far.program, far.program};
  for (auto& program : result)
    program.prefixes.assign(far.runs.size(), {});
  for (int r = 0; r < far.runs.size(); ++r)
    for (const int arcs : far.program.prefixes[r]) {
      const double length = far.runs[r].lengths[arcs];
      const auto& there = other.program.prefixes[r];
      const bool is_there = std::any_of(there.begin(), there.end(), [&](int k) {
        return std::abs(other.runs[r].lengths[k] - length) <= 1e-9 * length;
      });
      result[is_there ? 0 : 1].prefixes[r].push_back(arcs);
    }
  return result;
}

std::size_t number_of_rows(const Quantization_program& program)
{
  std::size_t result = 0;
  for (const auto& prefixes : program.prefixes)
    result += prefixes.size();
  return result;
}

// Makes quantizations of `known` rows that avoid the arcs of `unknown` rows, as these are dear,
// some of them at random, and counts the latter rows that are violated though they could hold.
class Adversary
{
public:
  Adversary(const QL::T_mesh& t_mesh, const Quantization_program& known,
            const Quantization_program& unknown)
    : m_t_mesh(t_mesh), m_known(known), m_unknown(unknown), m_graph(t_mesh)
  {
    for (int i = 0; i < 5; ++i)
      attack(dear_arcs());
  }

  int violated = 0;
  int violated_without_merge = 0; // where the singularity has not merged with another one

private:
  std::vector<char> dear_arcs()
  {
    std::vector<char> result(m_known.weight.size(), false);
    for (std::size_t r = 0; r < m_known.runs.size(); ++r) {
      const auto &known = m_known.prefixes[r], &unknown = m_unknown.prefixes[r];
      if (!unknown.empty() && (known.empty() || unknown.front() < known.front()) && m_random() % 2)
        for (int k = 0; k < unknown.front(); ++k)
          result[m_known.runs[r][k]] = true;
    }
    return result;
  }

  void attack(const std::vector<char>& is_dear)
  {
    Quantization_program program = m_known;
    for (std::size_t a = 0; a < is_dear.size(); ++a)
      program.weight[a] *= is_dear[a] ? 1000 : 1 + m_random() % 10;
    internal::Reduced_program reduced = internal::reduce(m_t_mesh, program, m_graph);
    const internal::Monitor monitor;
    internal::Incumbent incumbent(m_t_mesh, program, m_graph, reduced, monitor);
    BOOST_REQUIRE(incumbent.start());
    const std::vector<int> q = reduced.arc_lengths(incumbent.values()),
                           can_be_positive = reduced.arc_lengths(
                               std::vector<int>(incumbent.values().size(), 1));
    for (std::size_t r = 0; r < m_unknown.runs.size(); ++r) {
      const int n = internal::violated_prefixes(m_unknown, int(r), q) -
                    internal::violated_prefixes(m_unknown, int(r), can_be_positive);
      violated += n;
      if (!is_merged(m_t_mesh.traces[r].start, q))
        violated_without_merge += n;
    }
  }

  bool is_merged(int n, const std::vector<int>& q) const
  {
    const auto& pairs = m_known.pairs;
    return std::any_of(pairs.begin(), pairs.end(), [&](const internal::Close_pair& p) {
      return (p.i == n || p.j == n) && internal::sum_over(p.path, q) == 0;
    });
  }

  const QL::T_mesh& m_t_mesh;
  const Quantization_program &m_known, &m_unknown;
  internal::Dual_graph m_graph;
  std::mt19937 m_random;
};

} // namespace

// Section 3.1 of the paper extends traces for the crossings that rows are made of. Those that they
// would meet further on need no rows: these hold anyway, but for singularities that merge, whose
// group may reach further than one of them.
BOOST_AUTO_TEST_CASE(no_row_is_missing)
{
  for (const auto& mesh :
       {generated::noisy(generated::icosphere(3), 0.08, 2),
        generated::noisy(generated::torus(30, 15), 0.08, 1), generated::slab_with_holes(2, 3)}) {
    const QL::Cross_field field = QL::compute_cross_field(mesh);
    for (const double deviation : {15., 35.})
      for (const double displacement : {0., 1., 2.}) {
        const internal::Quantization_demands demands{std::tan(deviation * CGAL_PI / 180),
                                                     2 * displacement * edge_length, -4, 1};
        const Program_of usual(traced(field, deviation, displacement), demands),
            far(traced(field, 2, 0), demands);
        const auto [known, unknown] = divided(far, usual);
        BOOST_TEST(number_of_rows(known) == number_of_rows(usual.program));
        BOOST_TEST(number_of_rows(unknown) > number_of_rows(known));
        const Adversary adversary(far.t_mesh, known, unknown);
        BOOST_TEST(adversary.violated_without_merge == 0);
        if (displacement == 0)
          BOOST_TEST(adversary.violated == 0);
      }
  }
}

// The same comparison tells when traces are not extended.
BOOST_AUTO_TEST_CASE(missing_rows_are_noticed)
{
  const QL::Cross_field field = QL::compute_cross_field(
      generated::noisy(generated::icosphere(3), 0.08, 2));
  const internal::Quantization_demands demands{std::tan(15 * CGAL_PI / 180), 0, -4, 1};
  const Program_of plain(motorcycle_graph(field, std::vector<char>(1000, true)), demands),
      far(traced(field, 2, 0), demands);
  const auto [known, unknown] = divided(far, plain);
  BOOST_TEST(Adversary(far.t_mesh, known, unknown).violated > 0);
}

BOOST_AUTO_TEST_SUITE_END()
