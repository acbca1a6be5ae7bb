// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "generated_meshes.h"
#include "invariants.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/parametrize_seamlessly.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/number_type_config.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <random>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_trace_in_parametrization)

namespace QL = CGAL::Quad_layouts;
namespace parameters = CGAL::Quad_layouts::parameters;

using Map = QL::Seamless_parametrization;
using Mesh = generated::Mesh;
using QL::internal::Isoline;
using QL::internal::Isoline_cut;
using Point_2 = Isoline::Point_2;

namespace {

// the transition over an edge that has coordinates on both sides
Map::Transition transition_over(const Map& map, int h)
{
  const int next = map.surface().next(h), g = map.surface().opposite(h);
  const Point_2 source = map.coordinates(map.surface().next(g)), target = map.coordinates(g);
  Map::Transition result;
  while (result.turned(map.coordinates(next) - map.coordinates(h), result.quarter_turns) !=
         target - source)
    ++result.quarter_turns;
  result.translation = source - result(map.coordinates(h));
  return result;
}

// a map of a closed surface; chart(h) are the coordinates of the corner at halfedge h
template <class Chart>
Map map_by_charts(const Mesh& mesh, double unit, const Chart& chart)
{
  Map map;
  map.surface_pointer = QL::compute_cross_field(mesh).surface_pointer();
  map.unit = unit;
  const auto& surface = map.surface();
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    map.corner_coordinates.push_back(chart(surface, h));
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    map.halfedge_transition.push_back(transition_over(map, h));
  map.vertex_index.assign(surface.number_of_vertices(), -8);
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    while (!QL::internal::has_right_angle_sum(map, v))
      ++map.vertex_index[v];
  BOOST_TEST_REQUIRE(QL::internal::inexactness(map) == "");
  BOOST_TEST_REQUIRE(QL::internal::number_of_inverted_faces(map) == 0);
  return map;
}

// a torus of n times n squares; isolines run along edges and through vertices everywhere
Map square_torus(int n)
{
  return map_by_charts(generated::torus(n, n), 1, [n](const auto& surface, int h) {
    const int first = surface.source(h - h % 3), v = surface.source(h);
    const auto difference = [n](int a, int b) { return (a - b + n + 1) % n - 1; };
    return Point_2(difference(v / n, first / n), difference(v % n, first % n));
  });
}

// a cube the sides of which are n times n squares, not smoothed by an optimization
Map cube_of_squares(int n)
{
  return map_by_charts(generated::cube(n), 1. / n, [n](const auto& surface, int h) {
    const Eigen::Vector3d normal = surface.normal(h / 3), p = n * surface.point(surface.source(h));
    int axis;
    normal.cwiseAbs().maxCoeff(&axis);
    const auto x = std::llround(p[(axis + 1) % 3]), y = std::llround(p[(axis + 2) % 3]);
    return normal[axis] > 0 ? Point_2(x, y) : Point_2(y, x);
  });
}

// a map in which other charts say the same
Map with_other_charts(const Map& map, unsigned seed)
{
  Map result = map;
  std::mt19937 random(seed);
  const auto number = [&] { return std::int64_t(random() % 2001) - 1000; };
  for (int f = 0; f < map.surface().number_of_faces(); ++f) {
    const Map::Transition change{int(random() % 4), {number(), number()}};
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      result.corner_coordinates[h] = change(map.coordinates(h));
  }
  for (int h = 0; h < map.surface().number_of_halfedges(); ++h)
    if (!map.surface().is_border(h))
      result.halfedge_transition[h] = transition_over(result, h);
  return result;
}

QL::T_mesh trace(const Map& map, double alpha = 15, double r = 2)
{
  const QL::T_mesh t = QL::trace_motorcycle_graph(
      map, parameters::maximum_deviation(alpha).maximum_displacement(r));
  invariants::check_t_mesh(t);
  invariants::check_opposite_sides(t);
  return t;
}

void check_stopping_rule(const QL::T_mesh& t, double alpha, double r)
{
  invariants::check_stopping_rule(t, std::tan(alpha * CGAL_PI / 180),
                                  r * 0.01 * t.surface().diagonal());
}

QL::Cross_field field_along_features(Mesh& mesh)
{
  const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 40, is_sharp);
  return QL::compute_cross_field(mesh,
                                 parameters::default_values().edge_is_constrained_map(is_sharp));
}

} // namespace

// Two lines to the right, one unit behind the other on the same coordinate, and one that comes
// back, through the edge from (8, -1) to (8, 1): all in its middle. What has come farther is
// farther right.
BOOST_AUTO_TEST_CASE(lines_on_one_coordinate)
{
  const Point_2 source(8, -1), target(8, 1);
  const Isoline_cut near(Isoline{{5, 0}, 0}, source, target),
      far(Isoline{{4, 0}, 0}, source, target), back(Isoline{{9, 0}, 2}, source, target);
  for (const Isoline_cut& cut : {near, far, back})
    BOOST_TEST(cut.fraction() == 0.5);
  BOOST_TEST(near.length() == 3);
  BOOST_TEST(far.length() == 4);
  BOOST_TEST(back.length() == 1);
  BOOST_TEST((far < near));
  BOOST_TEST(!(near < far));
  BOOST_TEST((near < back));
  BOOST_TEST((far < back));
}

// compared with lines that are turned by a small, but positive angle
BOOST_AUTO_TEST_CASE(order_of_cuts_is_that_of_turned_lines)
{
  constexpr std::int64_t cotangent = 1000000;
  std::mt19937 random(1);
  const auto number = [&] { return Isoline::Integer(random() % 7) - 3; };
  struct Fraction
  {
    std::int64_t numerator, denominator; // positive
  };
  const auto cut_of = [&](const Isoline& line, const Point_2& p, const Point_2& q) {
    const Point_2 a = line.seen(p), b = line.seen(q);
    const std::int64_t at_p = cotangent * a.y() + a.x(), at_q = cotangent * b.y() + b.x();
    return at_p > at_q ? Fraction{at_p, at_p - at_q} : Fraction{-at_p, at_q - at_p};
  };
  int compared = 0, wrong = 0;
  while (compared < 20000) {
    const Point_2 p(number(), number()), q(number(), number());
    const Isoline a{{number(), number()}, int(random() % 4)},
        b{{number(), number()}, int(random() % 4)};
    if (a.seen(p).y() == a.seen(q).y() || b.seen(p).y() == b.seen(q).y())
      continue;
    const Fraction s = cut_of(a, p, q), t = cut_of(b, p, q);
    const std::int64_t difference = s.numerator * t.denominator - t.numerator * s.denominator;
    if (difference == 0)
      continue;
    ++compared;
    const Isoline_cut first(a, p, q), second(b, p, q);
    wrong += (first < second) != (difference < 0) || (second < first) != (difference > 0);
  }
  BOOST_TEST(wrong == 0);
}

BOOST_AUTO_TEST_CASE(lengths_are_rounded_down)
{
  // the line y = 0 cuts the edge at x = 7/3, its reverse 2/3 before 3
  const Point_2 source(2, -1), target(3, 2);
  BOOST_TEST(Isoline_cut(Isoline{{0, 0}, 0}, source, target).length() == 2);
  BOOST_TEST(Isoline_cut(Isoline{{3, 0}, 2}, source, target).length() == 0);
  BOOST_TEST(Isoline_cut(Isoline{{3, 0}, 0}, source, target).length() == -1);
}

// From the seed of a torus of 4 times 4 squares lines run in four directions, and pass the seed on
// its left after each round. At every seed, row k of a line (0 to 2) crosses column j >= 1 of the
// next one, after lengths 4k and 4j. With a tangent of 0.6 and no displacement, the first column is
// an acceptable candidate for row 2, and on the left the seed is one from row 1 on. So each line
// stops in row 2 at column 1, and crosses the next line in (0,1), (0,2), (1,1), (1,2) and (2,1).
BOOST_AUTO_TEST_CASE(torus_by_hand)
{
  const double alpha = std::atan(0.6) * 180 / CGAL_PI;
  const QL::T_mesh t = trace(square_torus(4), alpha, 0);
  BOOST_TEST(t.traces.size() == 4u);
  BOOST_TEST(t.number_of_vertices() == 1 + 4 * 5);
  BOOST_TEST(t.number_of_edges() == 40);
  BOOST_TEST(t.number_of_faces() == 19);
  for (const QL::T_mesh::Trace& trace : t.traces) {
    double length = 0;
    for (const int a : trace.arcs)
      length += t.length(a);
    BOOST_TEST(length == 8);
  }
  check_stopping_rule(t, alpha, 0);
}

BOOST_AUTO_TEST_CASE(cubes_of_squares)
{
  for (const int n : {1, 2, 4})
    for (const double alpha : {3., 15., 40., 80.})
      for (const double r : {0., 2.}) {
        const QL::T_mesh t = trace(cube_of_squares(n), alpha, r);
        BOOST_TEST(t.traces.size() == 24u);
        check_stopping_rule(t, alpha, r);
        // all lines run along edges of the cube and through its vertices
        BOOST_TEST(invariants::violations(t.number_of_edges(), [&](int a) {
                     return std::floor(t.length(a)) == t.length(a);
                   }) == 0);
      }
}

BOOST_AUTO_TEST_CASE(squares_do_not_matter)
{
  const QL::T_mesh coarse = trace(cube_of_squares(1)), fine = trace(cube_of_squares(4));
  BOOST_TEST(coarse.number_of_vertices() == fine.number_of_vertices());
  BOOST_TEST(coarse.number_of_faces() == fine.number_of_faces());
}

BOOST_AUTO_TEST_CASE(charts_do_not_matter)
{
  const Map round = QL::parametrize_seamlessly(QL::compute_cross_field(generated::icosphere(2)));
  for (const Map& map : {square_torus(4), cube_of_squares(2), round}) {
    const QL::T_mesh expected = trace(map);
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const QL::T_mesh t = trace(with_other_charts(map, seed));
      BOOST_TEST((t.halfedge_next == expected.halfedge_next));
      BOOST_TEST((t.arc_length == expected.arc_length));
      BOOST_TEST((t.edge_crossings == expected.edge_crossings));
    }
  }
}

BOOST_AUTO_TEST_CASE(features_are_patches)
{
  Mesh mesh = generated::cube(3);
  const QL::T_mesh t = trace(QL::parametrize_seamlessly(field_along_features(mesh)));
  BOOST_TEST(t.number_of_vertices() == 8);
  BOOST_TEST(t.number_of_faces() == 6);
}

BOOST_AUTO_TEST_CASE(generated_surfaces)
{
  std::vector<Mesh> meshes = {
      generated::tetrahedron(),
      generated::icosphere(3),
      generated::torus(24, 12),
      generated::cube(3),
      generated::slab_with_holes(2, 3),
      generated::noisy(generated::icosphere(3), 0.1, 3),
      generated::disjoint_union(generated::icosphere(2),
                                generated::translated(generated::cube(3), {9, 0, 0}))};
  for (const Mesh& mesh : generated::meshes_with_borders(4))
    meshes.push_back(mesh);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    BOOST_TEST_CONTEXT("mesh " << i)
    {
      const Map map = QL::parametrize_seamlessly(QL::compute_cross_field(meshes[i]));
      if (map.is_locally_injective())
        for (const double alpha : {5., 15., 60.})
          trace(map, alpha, 2);
      else
        BOOST_TEST_MESSAGE("mesh " << i << " is not locally injective");
    }
}

BOOST_AUTO_TEST_CASE(features_and_lines_across)
{
  Mesh slab = generated::slab_with_holes(2, 3);
  for (const double alpha : {5., 15., 60.})
    trace(QL::parametrize_seamlessly(field_along_features(slab)), alpha, 2);
}

BOOST_AUTO_TEST_CASE(bad_parametrizations_are_refused)
{
  const Map good = cube_of_squares(2);
  const auto expect = [](const Map& map, const std::string& words) {
    try {
      QL::trace_motorcycle_graph(map);
      BOOST_ERROR("accepted");
    } catch (const QL::Stage_failure& failure) {
      BOOST_TEST(std::string(failure.what()).find(words) != std::string::npos, failure.what());
    }
  };
  Map inexact = good;
  inexact.corner_coordinates[1].x() += 1;
  expect(inexact, "transition does not fit");
  Map flat = good;
  for (Point_2& p : flat.corner_coordinates)
    p.setZero();
  for (Map::Transition& t : flat.halfedge_transition)
    t.translation.setZero();
  expect(flat, "no positive area");
  Map wound = good;
  wound.vertex_index[3] -= 4;
  expect(wound, "vertex 3 has index");
}

BOOST_AUTO_TEST_CASE(parameters_out_of_range_are_refused)
{
  BOOST_CHECK_THROW(
      QL::trace_motorcycle_graph(cube_of_squares(1), parameters::maximum_deviation(90)),
      QL::Invalid_parameter);
}

BOOST_AUTO_TEST_CASE(models)
{
  for (const char* name : {"elk", "hand", "knot1", "rotor", "cow", "bones", "star"}) {
    std::ifstream in(CGAL::data_file_path("meshes/" + std::string(name) + ".off"));
    Mesh mesh;
    if (!(in >> mesh)) {
      BOOST_TEST_MESSAGE(name << " skipped");
      continue;
    }
    BOOST_TEST_CONTEXT(name)
    {
      const QL::T_mesh t = trace(QL::parametrize_seamlessly(QL::compute_cross_field(mesh)));
      if (is_closed(mesh))
        check_stopping_rule(t, 15, 2);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
