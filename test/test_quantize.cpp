// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "generated_fields.h"
#include "generated_meshes.h"
#include "hand_made_t_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/number_type_config.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_quantize)

namespace QL = CGAL::Quad_layouts;
namespace internal = CGAL::Quad_layouts::internal;
namespace parameters = CGAL::Quad_layouts::parameters;

namespace {

QL::T_mesh with_surface(QL::T_mesh t_mesh)
{
  t_mesh.surface_pointer = std::make_shared<const internal::Triangle_surface>();
  return t_mesh;
}

internal::Quantization_demands demands_of(const QL::T_mesh& t, double alpha, double r)
{
  const double h = 0.01 * t.surface().diagonal();
  return {std::tan(alpha * CGAL_PI / 180), 2 * r * h, -4, 1};
}

// what must hold for every result
void check(const QL::T_mesh& t, const QL::Quantization& q,
           const internal::Quantization_demands& demands)
{
  BOOST_REQUIRE_NE(q.status, QL::Quantization::INFEASIBLE);
  const auto program = internal::build_quantization_program(t, demands);
  const auto checked = internal::check_quantization(t, program, q.arc_length);
  BOOST_TEST(checked.consistent);
  BOOST_TEST(checked.violated() == q.violated);
  BOOST_TEST(checked.objective == q.objective, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(q.bound <= q.objective * (1 + 1e-9));
  const auto report = internal::examine_quotient(t, q.arc_length);
  BOOST_TEST(report.valid, report.reason);
  for (const auto& cluster : report.clusters)
    if (cluster.nodes.size() > 1 && q.violated == 0)
      BOOST_TEST(
          (cluster.index >= demands.minimum_index && cluster.index <= demands.maximum_index));
}

QL::T_mesh traced(const generated::Mesh& mesh, double alpha, double r)
{
  return QL::trace_motorcycle_graph(QL::compute_cross_field(mesh),
                                    parameters::maximum_deviation(alpha).maximum_displacement(r));
}

// Results are compared with those of a second run: no part of the search may reach its share of time.
void check_on(const generated::Mesh& mesh)
{
  double coarsest = (std::numeric_limits<double>::max)();
  for (const double r : {0., 2.}) {
    const QL::T_mesh t = traced(mesh, 15, r);
    const auto np = parameters::maximum_deviation(15).maximum_displacement(r).maximum_search_time(
        120);
    const QL::Quantization q = QL::quantize(t, np);
    check(t, q, demands_of(t, 15, r));
    BOOST_TEST(q.objective <= coarsest * (1 + 1e-9));
    coarsest = q.objective;
    if (q.status == QL::Quantization::OPTIMAL)
      BOOST_TEST(QL::quantize(t, np).arc_length == q.arc_length, boost::test_tools::per_element());
  }
}

void check_that_all_remain(const QL::Cross_field& field)
{
  const auto np = parameters::maximum_displacement(0.).maximum_running_time(20);
  const QL::T_mesh t = QL::trace_motorcycle_graph(field, np);
  const auto report = internal::examine_quotient(t, QL::quantize(t, np).arc_length);
  BOOST_TEST(report.valid, report.reason);
  for (const auto& cluster : report.clusters)
    BOOST_TEST(cluster.nodes.size() == 1);
}

} // namespace

BOOST_AUTO_TEST_SUITE(reduction)

BOOST_AUTO_TEST_CASE(keeps_minimal_sets)
{
  const std::vector<std::vector<int>> minimal = {{5}, {1, 2}, {2, 3, 4}};
  BOOST_TEST(
      (internal::minimal_sets({{1, 2, 3}, {2, 3, 4}, {1, 2}, {4, 5}, {5}, {1, 2}}) == minimal));
}

// The arcs of the cube in one direction share a variable; four arcs make a loop that costs 4.
BOOST_AUTO_TEST_CASE(shares_the_variables_of_the_cube)
{
  const QL::T_mesh t = hand_made::cube();
  const internal::Dual_graph graph(t);
  BOOST_TEST(graph.number_of_variables() == 3);
  const auto program = internal::build_quantization_program(t, {1, 0, -4, 1});
  const auto reduced = internal::reduce(t, program, graph);
  BOOST_TEST(reduced.equations.empty());
  BOOST_TEST(reduced.covers.size() == 3u);
  BOOST_TEST(reduced.cost == std::vector<double>(3, 4), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(decomposes_into_loops)
{
  const QL::T_mesh t = traced(generated::noisy(generated::icosphere(3), 0.05, 1), 15, 2);
  const internal::Dual_graph graph(t);
  internal::Loop_search search(graph);
  std::vector<int> x(graph.number_of_variables(), 0);
  const std::vector<double> price(x.size(), 1);
  for (std::size_t v = 0; v < x.size(); v += 3)
    for (int w : search.cheapest_loop({int(v)}, price))
      ++x[w];
  const auto program = internal::build_quantization_program(t, {1, 0, -4, 1});
  const auto reduced = internal::reduce(t, program, graph);
  BOOST_TEST(internal::check_quantization(t, program, reduced.arc_lengths(x)).consistent);
  std::vector<int> sum(x.size(), 0);
  for (const auto& loop : internal::dual_loops(t, graph, x))
    for (int v : loop)
      ++sum[v];
  BOOST_TEST(sum == x, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(by_hand)

// Every edge of the cube is longer than 2r: all get length 1.
BOOST_AUTO_TEST_CASE(separates_the_corners_of_a_cube)
{
  const QL::T_mesh t = with_surface(hand_made::cube());
  const auto q = QL::quantize(t, parameters::maximum_displacement(0).target_edge_length(1));
  BOOST_TEST(q.status == QL::Quantization::OPTIMAL);
  BOOST_TEST(q.objective == 12);
  BOOST_TEST(q.bound == 12);
  BOOST_TEST(q.arc_length == std::vector<int>(12, 1), boost::test_tools::per_element());
}

// The ends of each edge are within reach, but two corners of index 1 have index 2, which is valence
// 2.
BOOST_AUTO_TEST_CASE(merges_corners_only_where_the_valence_allows)
{
  const QL::T_mesh t = with_surface(hand_made::cube());
  const auto np = parameters::maximum_displacement(0.5).target_edge_length(1);
  const auto strict = QL::quantize(t, np);
  BOOST_TEST(strict.status == QL::Quantization::OPTIMAL);
  BOOST_TEST(strict.objective == 12);
  BOOST_TEST(strict.indicators == 12);
  const auto pillow = QL::quantize(t, np.minimum_valence(2));
  BOOST_TEST(pillow.status == QL::Quantization::OPTIMAL);
  BOOST_TEST(pillow.objective == 8);
  BOOST_TEST(internal::examine_quotient(t, pillow.arc_length).valid);
}

// Nothing keeps the seeds apart, so the rows alone allow length 0 everywhere: the cuts leave one
// dual loop per direction.
BOOST_AUTO_TEST_CASE(keeps_the_handle_of_a_torus)
{
  const QL::T_mesh t = with_surface(hand_made::torus(3, 2));
  const auto q = QL::quantize(t, parameters::maximum_displacement(10).target_edge_length(1));
  BOOST_TEST(q.status == QL::Quantization::OPTIMAL);
  BOOST_TEST(q.objective == 5);
  BOOST_TEST(q.rounds > 0);
  BOOST_TEST(internal::examine_quotient(t, q.arc_length).valid);
}

BOOST_AUTO_TEST_CASE(the_checker_finds_what_is_wrong)
{
  const QL::T_mesh t = hand_made::cube();
  const auto program = internal::build_quantization_program(t, {1, 0, -4, 1});
  std::vector<int> q(12, 1);
  BOOST_TEST(internal::check_quantization(t, program, q).consistent);
  q[0] = 2;
  BOOST_TEST(!internal::check_quantization(t, program, q).consistent);
  q = {0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
  const auto merged = internal::check_quantization(t, program, q);
  BOOST_TEST(merged.consistent);
  BOOST_TEST(merged.violated_rows == 4);
  BOOST_TEST(merged.objective == 8 + 4 * 12);
  const auto close = internal::build_quantization_program(t, {1, 1, -4, 1});
  BOOST_TEST(internal::check_quantization(t, close, q).violated_rows == 0);
  BOOST_TEST(internal::check_quantization(t, close, q).index_excess == 8);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(on_traced_fields)

BOOST_AUTO_TEST_CASE(generated_surfaces)
{
  check_on(generated::cube(8));
  check_on(generated::noisy(generated::icosphere(3), 0.05, 7));
  check_on(generated::slab_with_holes(2, 4));
  check_on(generated::torus(24, 12));
  check_on(generated::disjoint_union(
      generated::cube(6),
      generated::translated(generated::icosphere(3), generated::Vector(5, 0, 0))));
}

// Where nothing may move, every singularity remains: also in fields with limit cycles and spirals.
BOOST_AUTO_TEST_CASE(no_displacement_keeps_all_singularities)
{
  for (unsigned seed = 1; seed <= 9; ++seed)
    BOOST_TEST_CONTEXT("random field " << seed)
  check_that_all_remain(generated::random_field(
      seed % 2 == 0 ? generated::icosphere(1) : generated::torus(10, 6), seed));
  generated::Mesh mesh;
  const std::string path = CGAL::data_file_path("meshes/triceratops.off");
  if (std::ifstream(path) && CGAL::IO::read_polygon_mesh(path, mesh))
    check_that_all_remain(QL::compute_cross_field(mesh));
  else
    BOOST_TEST_MESSAGE("skipped: " << path << " is not there");
}

// Units do not matter: by powers of two everything scales exactly.
BOOST_AUTO_TEST_CASE(result_does_not_depend_on_the_scale)
{
  const auto quantized = [](int exponent) {
    generated::Mesh mesh = generated::noisy(generated::icosphere(2), 0.3, 3);
    for (const auto v : vertices(mesh))
      mesh.point(v) = CGAL::ORIGIN + std::ldexp(1., exponent) * (mesh.point(v) - CGAL::ORIGIN);
    return QL::quantize(traced(mesh, 15, 2), parameters::maximum_displacement(2));
  };
  const QL::Quantization expected = quantized(0);
  BOOST_REQUIRE_EQUAL(expected.status, QL::Quantization::OPTIMAL); // not ended by the time limit
  for (const int exponent : {-30, 30}) {
    const QL::Quantization q = quantized(exponent);
    BOOST_REQUIRE_EQUAL(q.status, QL::Quantization::OPTIMAL);
    BOOST_TEST(q.arc_length == expected.arc_length, boost::test_tools::per_element());
    BOOST_TEST(q.objective == std::ldexp(expected.objective, exponent));
    BOOST_TEST(q.bound == std::ldexp(expected.bound, exponent));
  }
}

BOOST_AUTO_TEST_CASE(real_surfaces)
{
  for (const char* name :
       {"meshes/elephant.off", "meshes/blobby.off", "meshes/fandisk_large.off"}) {
    const std::string path = CGAL::data_file_path(name);
    generated::Mesh mesh;
    if (!std::ifstream(path) || !CGAL::IO::read_polygon_mesh(path, mesh)) {
      BOOST_TEST_MESSAGE("skipped: " << path << " is not there");
      continue;
    }
    BOOST_TEST_CONTEXT(name)
    check_on(mesh);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(parameters_and_visitors)

BOOST_AUTO_TEST_CASE(refuses_parameters_out_of_range)
{
  const QL::T_mesh t = with_surface(hand_made::cube());
  const auto np = parameters::target_edge_length(1);
  BOOST_CHECK_THROW(QL::quantize(t, np.maximum_deviation(90)), QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::quantize(t, np.maximum_displacement(-1)), QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::quantize(t, parameters::target_edge_length(0)), QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::quantize(t, np.minimum_valence(5)), QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::quantize(t, np.minimum_valence(1)), QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::quantize(t, np.maximum_valence(3)), QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::quantize(t, np.relative_gap(-0.1)), QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::quantize(t, np.concurrent_searches(0)), QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::quantize(t, np.maximum_running_time(0)), QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::quantize(t, np.maximum_search_time(0)), QL::Invalid_parameter);
}

// However short the search, there is the solution that it begins with.
BOOST_AUTO_TEST_CASE(limits_the_search_and_everything)
{
  const QL::T_mesh t = traced(generated::noisy(generated::icosphere(3), 0.08, 5), 25, 3);
  const auto np = parameters::maximum_deviation(25).maximum_displacement(3);
  const QL::Quantization first = QL::quantize(t, np.maximum_search_time(1e-9));
  BOOST_TEST(first.status == QL::Quantization::FEASIBLE);
  BOOST_TEST(QL::quantize(t, np.maximum_search_time(2)).objective < first.objective);
  BOOST_CHECK_THROW(QL::quantize(t, np.maximum_running_time(1e-9)), QL::Time_limit_exceeded);
}

struct Impatient : QL::Default_visitor
{
  bool go_on() { return false; }
};

struct Curious : QL::Default_visitor
{
  void improved(double objective, double bound, double)
  {
    BOOST_TEST(bound <= objective);
    last = objective;
  }
  double last = 0;
};

BOOST_AUTO_TEST_CASE(listens_to_the_visitor)
{
  const QL::T_mesh t = with_surface(hand_made::cube());
  const auto np = parameters::target_edge_length(1).maximum_displacement(0);
  BOOST_CHECK_THROW(QL::quantize(t, np.visitor(Impatient())), QL::Cancelled);
  Curious curious;
  QL::quantize(t, np.visitor(std::ref(curious)));
  BOOST_TEST(curious.last == 12);
}

// solves only programs that are small, such as those of neighbourhoods
struct Small_programs_traits : QL::GLPK_mixed_integer_program_traits<double>
{
  bool solve() override
  {
    return number_of_variables() < 200 && QL::GLPK_mixed_integer_program_traits<double>::solve();
  }
};

// the first objectives of a search, which it ends
struct Beginning : QL::Default_visitor
{
  void improved(double objective, double, double) { objectives.push_back(objective); }
  bool go_on() const { return objectives.size() < 20; }
  std::vector<double> objectives;
};

// Threads come and go in another order in each run.
BOOST_AUTO_TEST_CASE(concurrent_searches_can_be_repeated)
{
  const QL::T_mesh t = traced(generated::noisy(generated::icosphere(3), 0.08, 5), 25, 3);
  const auto beginning = [&] {
    Beginning result;
    const auto np = parameters::maximum_deviation(25)
                        .maximum_displacement(3)
                        .maximum_search_time(1000)
                        .concurrent_searches(3)
                        .visitor(std::ref(result));
    BOOST_CHECK_THROW(QL::quantize<Small_programs_traits>(t, np), QL::Cancelled);
    return result.objectives;
  };
  BOOST_TEST(beginning() == beginning(), boost::test_tools::per_element());
}

// A solver that never finds anything leaves the solution of the start.
class Idle_traits : public CGAL::Mixed_integer_program_traits<double>
{
public:
  enum Status { OPTIMAL, FEASIBLE, INFEASIBLE, UNKNOWN, FAILED };
  void set_time_limit(double) {}
  void set_node_limit(int) {}
  void set_relative_gap(double) {}
  void set_start_solution(const std::vector<double>&) {}
  void set_interrupt(const std::function<bool()>&) {}
  Status status() const { return UNKNOWN; }
  double objective_value() const { return 0; }
  double best_bound() const { return 0; }
  bool solve() override { return false; }
};

BOOST_AUTO_TEST_CASE(takes_any_solver)
{
  const QL::T_mesh t = with_surface(hand_made::cube());
  const auto q = QL::quantize<Idle_traits>(
      t, parameters::target_edge_length(1).maximum_displacement(0));
  BOOST_TEST(q.status == QL::Quantization::FEASIBLE);
  BOOST_TEST(q.objective == 12);
  BOOST_TEST(q.gap() == 1);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
