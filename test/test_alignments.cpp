// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "generated_fields.h"
#include "generated_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/property_map.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_alignments)

namespace QL = CGAL::Quad_layouts;
namespace internal = CGAL::Quad_layouts::internal;
namespace parameters = CGAL::Quad_layouts::parameters;

namespace {

// A field along the axes: every line of a slab of cubes runs exactly through its corners.
QL::Cross_field field_along_axes(const generated::Mesh& mesh)
{
  const auto direction = [](const Eigen::Vector3d& center) {
    const bool is_across = std::abs(center.x() - std::round(center.x())) < 1e-9;
    return is_across ? Eigen::Vector3d(0, 1, 0) : Eigen::Vector3d(1, 0, 0);
  };
  return generated::field_along(mesh, direction, [](const Eigen::Vector3d&) { return 0.; });
}

bool ends_in_singularity(const QL::T_mesh& t, const QL::T_mesh::Trace& trace)
{
  return t.is_singularity_or_seed(t.target(2 * trace.arcs.back()));
}

std::vector<QL::T_mesh> aligned_t_meshes(double displacement)
{
  const auto np = parameters::maximum_displacement(displacement);
  std::vector<QL::T_mesh> result;
  for (const auto& mesh :
       {generated::cube(4), generated::slab_with_holes(1, 2), generated::slab_with_holes(2, 3)}) {
    result.push_back(QL::trace_motorcycle_graph(field_along_axes(mesh), np));
    result.push_back(QL::trace_motorcycle_graph(QL::compute_cross_field(mesh), np));
  }
  return result;
}

} // namespace

// Singularities on a common line stay free: their traces pass each other by.
BOOST_AUTO_TEST_CASE(no_trace_runs_into_a_singularity)
{
  for (const QL::T_mesh& t : aligned_t_meshes(0)) {
    int ends = 0;
    for (const auto& trace : t.traces)
      ends += ends_in_singularity(t, trace);
    BOOST_TEST(ends == 0);
    const internal::Runs runs(t);
    const std::vector<std::vector<int>> free(t.traces.size());
    BOOST_TEST(internal::Alignments(t, runs, free).number_of_candidates() > 8);
  }
}

// Which of two legs is the longer one is decided once.
BOOST_AUTO_TEST_CASE(rows_have_the_order_of_tracing)
{
  for (const QL::T_mesh& t : aligned_t_meshes(1)) {
    const internal::Runs runs(t);
    int wrong = 0;
    for (const auto& visits : t.node_visits)
      if (visits.size() == 2) {
        const double first = runs.length({visits[0].trace, visits[0].arcs});
        wrong += first > runs.length({visits[1].trace, visits[1].arcs}) * (1 + 1e-12);
      }
    BOOST_TEST(wrong == 0);
  }
}

// Weights that make a dual loop through a leg cheap make it worthwhile to offset the singularities,
// unless they are locked.
BOOST_AUTO_TEST_CASE(locked_ones_have_no_offset)
{
  int locked = 0, was_offset = 0;
  for (const QL::T_mesh& t : aligned_t_meshes(0)) {
    const auto np = parameters::maximum_displacement(0.).maximum_running_time(5);
    const auto options = internal::quantization_options(t, np.lock_alignments(true));
    const auto program = internal::build_quantization_program(t, options.demands, options.wishes);
    const internal::Dual_graph graph(t);
    for (const int a : program.locked)
      BOOST_TEST(graph.variable(a) >= 0); // it can be positive
    internal::Loop_search search(graph);
    const internal::Loop loop = search.cheapest_loop(
        {graph.variable(program.locked.front())},
        std::vector<double>(graph.number_of_variables(), 1));
    std::vector<double> weights(t.number_of_edges(), 1);
    for (int a = 0; a < t.number_of_edges(); ++a)
      if (std::count(loop.begin(), loop.end(), graph.variable(a)) > 0)
        weights[a] = 1e-3;
    const auto cheap = np.arc_weight_map(CGAL::make_property_map(weights));

    const QL::Quantization free = QL::quantize(t, cheap);
    const QL::Quantization q = QL::quantize(t, cheap.lock_alignments(true));
    BOOST_REQUIRE((q.status != QL::Quantization::INFEASIBLE));
    BOOST_TEST(internal::sum_over(program.locked, q.arc_length) == 0);
    BOOST_TEST(q.objective >= free.bound * (1 - 1e-9));
    BOOST_TEST(QL::extract_quad_layout(t, q).euler_characteristic() == t.euler_characteristic());
    locked += int(program.locked.size());
    was_offset += internal::sum_over(program.locked, free.arc_length) > 0;
  }
  BOOST_TEST(locked > 50);
  BOOST_TEST(was_offset > 3);
}

BOOST_AUTO_TEST_SUITE_END()
