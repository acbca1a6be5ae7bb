// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "generated_fields.h"
#include "generated_meshes.h"
#include "invariants.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/number_type_config.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_trace_motorcycle_graph)

namespace QL = CGAL::Quad_layouts;
namespace parameters = CGAL::Quad_layouts::parameters;

using Mesh = generated::Mesh;
using Vector = Eigen::Vector3d;

namespace {

using generated::field_along;
using generated::random_field;

// circles around the z-axis
Vector around_z(const Vector& center)
{
  return Vector(-center.y(), center.x(), 0);
}

// two pyramids on a regular polygon, glued at their bases; the apexes are the vertices 0 and 1
Mesh double_pyramid(int n)
{
  std::vector<generated::Point> points = {{0, 0, 1}, {0, 0, -1}};
  std::vector<generated::Triangle> triangles;
  for (int i = 0; i < n; ++i) {
    points.emplace_back(std::cos(2 * CGAL_PI * i / n), std::sin(2 * CGAL_PI * i / n), 0);
    const int a = 2 + i, b = 2 + (i + 1) % n;
    triangles.push_back({a, b, 0});
    triangles.push_back({b, a, 1});
  }
  return generated::mesh_of(points, triangles);
}

int number_of_starts(const QL::T_mesh& t)
{
  const auto& vertices = t.node_surface_vertex;
  return int(std::count_if(vertices.begin(), vertices.end(), [](int v) { return v >= 0; }));
}

void check_stopping_rule(const QL::T_mesh& t, double alpha, double r)
{
  const double length = r * 0.01 * t.surface().diagonal();
  invariants::check_stopping_rule(t, std::tan(alpha * CGAL_PI / 180), length);
}

QL::T_mesh trace(const QL::Cross_field& field, double alpha, double r)
{
  const QL::T_mesh t = QL::trace_motorcycle_graph(
      field, parameters::maximum_deviation(alpha).maximum_displacement(r));
  invariants::check_t_mesh(t);
  invariants::check_distances(t);
  return t;
}

} // namespace

BOOST_AUTO_TEST_CASE(order_along_an_edge_is_that_of_insertion_limits)
{
  QL::internal::Edge_order order(1);
  const int a = order.insert(0, 0.5, -1, -1);
  const int b = order.insert(0, 0.9, -1, a); // proposed behind a, but limited by it
  const int c = order.insert(0, 0.1, a, -1);
  const int d = order.insert(0, 0.5, b, a);
  BOOST_TEST(order.points(0) == (std::vector<int>{b, d, a, c}), boost::test_tools::per_element());
  for (int i = 0; i < 3; ++i) {
    const int p = order.points(0)[i], q = order.points(0)[i + 1];
    BOOST_TEST(order.t(p) < order.t(q));
    BOOST_TEST(order.rank(p) < order.rank(q));
  }
  BOOST_TEST(order.t(a) == 0.5);
  BOOST_TEST(d == order.points(0)[1]);
}

BOOST_AUTO_TEST_CASE(order_along_an_edge_survives_a_thousand_insertions_in_one_place)
{
  QL::internal::Edge_order order(1);
  const int first = order.insert(0, 0.25, -1, -1), last = order.insert(0, 0.75, -1, -1);
  std::vector<int> expected = {first};
  for (int i = 0; i < 1000; ++i)
    expected.push_back(order.insert(0, 0.5, expected.back(), last));
  expected.push_back(last);
  BOOST_TEST((order.points(0) == expected));
  BOOST_TEST(invariants::violations(1001, [&](int i) {
               return order.rank(expected[i]) < order.rank(expected[i + 1]);
             }) == 0);
}

BOOST_AUTO_TEST_CASE(equal_lengths_are_ordered_by_trace)
{
  BOOST_TEST(QL::internal::is_longer(2, 0, 1, 1));
  BOOST_TEST(QL::internal::is_longer(1, 3, 1, 2));
  BOOST_TEST(!QL::internal::is_longer(1, 2, 1, 3));
}

// In each triangle and direction, a line further on leaves further back; and the reverse line comes
// back.
BOOST_AUTO_TEST_CASE(interval_map_is_monotone)
{
  const QL::Cross_field field = random_field(generated::icosphere(1), 5);
  const QL::internal::Labels labels = QL::internal::make_labels(field);
  const QL::internal::Interval_map map(field, labels);
  int wrong = 0;
  for (int f = 0; f < field.surface().number_of_faces(); ++f)
    for (int d = 0; d < 4; ++d)
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        if (labels.leaves(h, d))
          continue;
        for (int i = 1; i < 20; ++i) {
          const auto a = map.leave({h, i / 20.}, d), b = map.leave({h, (i + 1) / 20.}, d);
          const auto back = map.leave(a, d + 2);
          wrong += !labels.leaves(a.halfedge, d) || (a.halfedge == b.halfedge && a.t <= b.t);
          wrong += back.halfedge != h || std::abs(back.t - i / 20.) > 1e-12;
        }
      }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(cube_has_three_traces_from_each_corner)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::cube(4));
  const QL::T_mesh t = trace(field, 15, 2);
  BOOST_TEST(number_of_starts(t) == 8);
  BOOST_TEST(t.traces.size() == 24u);
  BOOST_TEST(invariants::violations(8, [&](int n) { return t.index(n) == 1; }) == 0);
  // a trace adds one arc, a crossing two, and each trace ends in a crossing; so there are twice as
  // many arcs
  BOOST_TEST(t.number_of_edges() == 2 * (t.number_of_vertices() - 8));
  check_stopping_rule(t, 15, 2);
}

BOOST_AUTO_TEST_CASE(torus_gets_one_seed)
{
  const auto angle = [](const Vector&) { return 0.1; };
  const QL::Cross_field field = field_along(generated::torus(20, 10), around_z, angle);
  BOOST_TEST_REQUIRE(field.number_of_singularities() == 0);
  const QL::T_mesh t = trace(field, 15, 2);
  BOOST_TEST(number_of_starts(t) == 1);
  BOOST_TEST(t.index(0) == 0);
  BOOST_TEST(t.traces.size() == 4u);
  check_stopping_rule(t, 15, 2);
}

BOOST_AUTO_TEST_CASE(each_component_gets_traces)
{
  const Mesh two = generated::disjoint_union(generated::torus(20, 10),
                                             generated::translated(generated::cube(3), {5, 0, 0}));
  const QL::T_mesh t = trace(QL::compute_cross_field(two), 15, 2);
  int seeds = 0;
  for (int n = 0; n < t.number_of_vertices(); ++n)
    seeds += t.is_singularity_or_seed(n) && t.index(n) == 0;
  BOOST_TEST(number_of_starts(t) == 9);
  BOOST_TEST(seeds == 1);
}

// The directions turn with the height, so that lines of one family wind towards limit cycles.
BOOST_AUTO_TEST_CASE(limit_cycles_end)
{
  for (double amount : {0.01, 0.1, 0.5}) {
    const auto angle = [&](const Vector& center) { return amount * center.z(); };
    const QL::Cross_field field = field_along(generated::torus(40, 20), around_z, angle);
    trace(field, 15, 2);
    trace(field, 0.2, 0);
  }
}

// Circles around the apex of a pyramid have index 4 there: no line starts, and lines can spiral in
// forever.
BOOST_AUTO_TEST_CASE(vertices_without_lines_share_their_index)
{
  const Mesh mesh = double_pyramid(16);
  for (double angle : {0., 0.4, 0.8}) {
    const QL::Cross_field field = field_along(mesh, around_z, [&](const Vector&) { return angle; });
    BOOST_TEST_REQUIRE(field.index(0) == 4);
    BOOST_TEST_REQUIRE(field.index(1) == 4);
    const QL::T_mesh t = trace(field, 15, 2);
    const int nodes = t.number_of_vertices();
    BOOST_TEST(invariants::violations(nodes, [&](int n) { return t.index(n) < 4; }) == 0);
  }
}

BOOST_AUTO_TEST_CASE(isolated_vertices_are_left_alone)
{
  Mesh mesh = generated::cube(3);
  for (int i = 0; i < 5; ++i)
    mesh.add_vertex(generated::Point(i, 0, 0));
  const QL::T_mesh t = trace(QL::compute_cross_field(mesh), 15, 2);
  BOOST_TEST(number_of_starts(t) == 8);
}

BOOST_AUTO_TEST_CASE(traces_stop_by_the_rule)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::slab_with_holes(2, 4));
  for (double alpha : {5., 15., 35., 80.})
    for (double r : {0., 2., 4.})
      check_stopping_rule(trace(field, alpha, r), alpha, r);
}

BOOST_AUTO_TEST_CASE(random_fields)
{
  const std::vector<Mesh> meshes = {generated::tetrahedron(), generated::icosphere(2),
                                    generated::torus(16, 8), generated::slab_with_holes(2, 2),
                                    generated::noisy(generated::cube(6), 0.05, 1)};
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    const double alpha = 1 + random() % 88, r = random() % 5;
    BOOST_TEST_CONTEXT("seed " << seed << ", deviation " << alpha << ", displacement " << r)
    trace(random_field(meshes[seed % meshes.size()], seed), alpha, r);
  }
}

BOOST_AUTO_TEST_CASE(square_has_a_patch)
{
  const QL::T_mesh t = trace(QL::compute_cross_field(generated::plate({{0, 0}}, 4)), 15, 2);
  BOOST_TEST(t.number_of_faces() == 1);
  BOOST_TEST(t.number_of_edges() == 4);
  BOOST_TEST(t.traces.size() == 4u);
  for (int a = 0; a < 4; ++a)
    BOOST_TEST(t.length(a) == 1, boost::test_tools::tolerance(1e-12));
}

// Two traces start in each concave corner, and end on the border.
BOOST_AUTO_TEST_CASE(plate_with_a_hole)
{
  const Mesh mesh = generated::plate_with_holes(3, 3, {{1, 1}}, 4);
  const QL::T_mesh t = trace(QL::compute_cross_field(mesh), 15, 2);
  BOOST_TEST(number_of_starts(t) == 8);
  BOOST_TEST(t.traces.size() == 16u);
  BOOST_TEST(t.number_of_faces() == 8);
  BOOST_TEST(t.euler_characteristic() == 0);
}

BOOST_AUTO_TEST_CASE(borders_without_corners_get_seeds)
{
  const Mesh mesh = generated::annulus(0.5, 1, 6, 40);
  const QL::T_mesh t = trace(QL::compute_cross_field(mesh), 15, 2);
  BOOST_TEST(number_of_starts(t) == 2);
  BOOST_TEST(t.traces.size() == 4u);
  BOOST_TEST(t.number_of_faces() == 2);
  trace(QL::compute_cross_field(generated::disc(10)), 15, 2);
}

BOOST_AUTO_TEST_CASE(random_fields_with_borders)
{
  const std::vector<Mesh> meshes = generated::meshes_with_borders(4);
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    const double alpha = 1 + random() % 88, r = random() % 5;
    BOOST_TEST_CONTEXT("seed " << seed << ", deviation " << alpha << ", displacement " << r)
    trace(random_field(meshes[seed % meshes.size()], seed), alpha, r);
  }
}

BOOST_AUTO_TEST_CASE(needles)
{
  Mesh mesh = generated::noisy(generated::icosphere(3), 1e-3, 1);
  for (const auto v : vertices(mesh)) {
    const auto p = mesh.point(v);
    mesh.point(v) = generated::Point(0.005 * p.x(), p.y(), p.z());
  }
  trace(QL::compute_cross_field(mesh), 15, 2);
  trace(random_field(mesh, 1), 15, 2);
}

BOOST_AUTO_TEST_CASE(models)
{
  for (const char* name : {"elephant", "cow", "bones", "star", "fandisk", "knot1", "rotor"}) {
    const std::string file = CGAL::data_file_path("meshes/" + std::string(name) + ".off");
    Mesh mesh;
    if (!std::ifstream(file) || !CGAL::IO::read_polygon_mesh(file, mesh) || !is_closed(mesh)) {
      BOOST_TEST_MESSAGE(name << " skipped");
      continue;
    }
    BOOST_TEST_CONTEXT(name)
    trace(QL::compute_cross_field(mesh), 15, 2);
  }
}

BOOST_AUTO_TEST_CASE(same_answer_twice)
{
  const QL::Cross_field field = random_field(generated::icosphere(2), 1);
  const QL::T_mesh a = QL::trace_motorcycle_graph(field), b = QL::trace_motorcycle_graph(field);
  BOOST_TEST((a.halfedge_next == b.halfedge_next));
  BOOST_TEST((a.arc_length == b.arc_length));
  BOOST_TEST((a.edge_crossings == b.edge_crossings));
}

BOOST_AUTO_TEST_CASE(longer_target_edges_allow_more_displacement)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::cube(6));
  const double diagonal = field.surface().diagonal();
  const QL::T_mesh a = QL::trace_motorcycle_graph(field, parameters::maximum_displacement(4));
  const QL::T_mesh b = QL::trace_motorcycle_graph(field,
                                                  parameters::target_edge_length(0.02 * diagonal));
  BOOST_TEST((a.halfedge_next == b.halfedge_next));
}

BOOST_AUTO_TEST_CASE(parameters_out_of_range_are_refused)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::cube(2));
  const auto is_refused = [&](const auto& np) {
    BOOST_CHECK_THROW(QL::trace_motorcycle_graph(field, np), QL::Invalid_parameter);
  };
  for (double alpha : {0., 90., -1., std::nan("")})
    is_refused(parameters::maximum_deviation(alpha));
  for (double r : {-1., std::nan("")})
    is_refused(parameters::maximum_displacement(r));
  for (double h : {0., -1., std::nan("")})
    is_refused(parameters::target_edge_length(h));
}

BOOST_AUTO_TEST_CASE(a_visitor_can_stop_the_work)
{
  struct Impatient : QL::Default_visitor
  {
    bool go_on() { return false; }
  };
  const QL::Cross_field field = random_field(generated::icosphere(3), 1);
  BOOST_CHECK_THROW(QL::trace_motorcycle_graph(field, parameters::visitor(Impatient())),
                    QL::Cancelled);
}

BOOST_AUTO_TEST_SUITE_END()
