// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Surfaces, fields and parameters of all kinds on their way through all stages. The random ones are
// from the seeds FIRST, FIRST + 1, ...:
//
//   test_all_stages [OPTION OF BOOST.TEST]... -- [--first FIRST] [--runs N] [--seconds S]

#include <boost/test/unit_test.hpp>

#include "all_stages.h"
#include "generated_fields.h"
#include "random_tasks.h"

#include <CGAL/Quad_layouts/internal/tracing/repair_labels.h>

#include <CGAL/Real_timer.h>

#include <boost/test/results_collector.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <string>

BOOST_AUTO_TEST_SUITE(test_all_stages)

namespace QL = CGAL::Quad_layouts;
using all_stages::Results;
using all_stages::Task;
using generated::Mesh;
using invariants::violations;

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

Mesh scaled(Mesh mesh, double scale)
{
  random_tasks::change_points(mesh, [&](const generated::Vector& p) { return scale * p; });
  return mesh;
}

// takes a mesh through all stages with its own smooth field
void check_valid(const std::string& name, const Mesh& mesh)
{
  BOOST_TEST_CONTEXT(name)
  {
    Task task(mesh);
    BOOST_TEST(outcome(task) == "valid");
  }
}

// takes a mesh through all stages with a field that has a given direction in each face: by its
// angle to circles around the z-axis, as a function of the face's centre
template <class Angle>
void check_valid(const std::string& name, const Mesh& mesh, const Angle& angle)
{
  const QL::Cross_field field = generated::field_along(
      mesh, [](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p.y(), p.x(), 0); }, angle);
  BOOST_TEST_CONTEXT(name)
  {
    Task task(mesh);
    for (int f = 0; f < field.surface().number_of_faces(); ++f)
      task.directions.push_back(field.direction(f, 0));
    BOOST_TEST(outcome(task) == "valid");
  }
}

} // namespace

BOOST_AUTO_TEST_CASE(smallest_surfaces)
{
  check_valid("triangle", generated::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  check_valid("square", generated::plate({{0, 0}}, 1));
  check_valid("tetrahedron", generated::tetrahedron());
  check_valid("cube of 12 triangles", generated::cube(1));
  check_valid("torus of 40 triangles", generated::torus(5, 4));
  check_valid("annulus of 6 triangles", generated::annulus(0.5, 1, 1, 3));
}

BOOST_AUTO_TEST_CASE(many_components_of_uneven_scales)
{
  Mesh all = generated::icosphere(2);
  int i = 0;
  for (const Mesh& mesh : {generated::torus(12, 8), generated::tetrahedron(), generated::cube(1),
                           generated::plate({{0, 0}}, 1), generated::disc(4),
                           generated::annulus(0.5, 1, 2, 12), generated::slab_with_holes(2, 1)})
    for (const double scale : {1e-3, 1., 100.})
      all = generated::disjoint_union(all,
                                      generated::translated(scaled(mesh, scale), {7. * ++i, 0, 0}));
  check_valid("22 components", all);
}

BOOST_AUTO_TEST_CASE(coordinates_of_all_sizes)
{
  const Mesh mesh = generated::slab_with_holes(1, 2);
  for (const double scale : {1e-6, 1e6})
    check_valid("scale " + std::to_string(scale), scaled(mesh, scale));
  check_valid("far away", generated::translated(mesh, {1e6, -1e6, 1e6}));
  check_valid("small and far away", generated::translated(scaled(mesh, 1e-3), {1e5, 0, 0}));
}

BOOST_AUTO_TEST_CASE(bad_triangles)
{
  random_tasks::Dice dice(1);
  Mesh needles = generated::cube(4);
  random_tasks::divide_faces(needles, dice, 100);
  check_valid("needles and caps", needles);
  Mesh needle = generated::icosphere(3);
  random_tasks::change_points(needle, [](const generated::Vector& p) {
    return generated::Vector(1e-3 * p.x(), 1e-3 * p.y(), p.z());
  });
  check_valid("a surface that is a needle itself", needle);
  check_valid("surface that intersects itself", generated::noisy(generated::icosphere(2), 0.3, 1));
  check_valid("components that intersect",
              generated::disjoint_union(generated::icosphere(2),
                                        generated::translated(generated::cube(2), {0.1, 0, 0})));
  check_valid("components in the same place",
              generated::disjoint_union(generated::cube(2), generated::cube(2)));
}

BOOST_AUTO_TEST_CASE(fields_that_cannot_be_integrated)
{
  const Mesh torus = generated::torus(40, 20);
  const auto limit_cycles = [](const Eigen::Vector3d& p) { return 0.3 * p.z(); };
  check_valid("limit cycles", torus, limit_cycles);
  check_valid("spirals", torus, [](const Eigen::Vector3d&) { return 0.1; });
  check_valid("spirals into the poles of a sphere", generated::icosphere(3), limit_cycles);
  check_valid("spirals on an annulus", generated::annulus(0.2, 1, 8, 40),
              [](const Eigen::Vector3d& p) { return 0.5 * p.norm(); });
  // No quad mesh of a torus has one vertex of valence 3 and one of valence 5 only.
  check_valid("3-5 pair", torus, [](const Eigen::Vector3d& p) {
    const double u = std::atan2(p.y(), p.x()), v = std::atan2(p.z(), std::hypot(p.x(), p.y()) - 2);
    return (std::atan2(v, u - 0.3) - std::atan2(v, u + 0.3)) / 4;
  });
}

// Three singularities of valence 3 fall together in every quantization of this T-mesh.
BOOST_AUTO_TEST_CASE(no_vertex_of_valence_1)
{
  Task task = random_tasks::random_task(5023);
  task.route = QL::FIELD;
  BOOST_TEST(outcome(task) == "no valid quantization");
}

// In the first field more than one label of a face is wrong; the second one is on a tetrahedron
// whose vertices all need other valences.
BOOST_AUTO_TEST_CASE(labels_of_random_fields)
{
  for (const unsigned seed : {5003, 5056}) {
    Task task = random_tasks::random_task(seed);
    const QL::Cross_field field = all_stages::field_of(
        task, QL::parameters::edge_is_constrained_map(task.is_feature));
    const QL::internal::Labels labels = QL::internal::make_labels(field);
    BOOST_TEST(violations(field.surface().number_of_faces(),
                          [&](int f) { return labels.is_valid(f); }) == 0);
    BOOST_TEST(violations(field.surface().number_of_vertices(),
                          [&](int v) { return labels.valence(v) >= 2; }) == 0);
  }
}

// Vertices of the first map have so little room that rounding them could invert a triangle; the
// system of equations for a seamless parametrization of the second has no solution in numbers. In
// the others there was no room for a vertex: triangles without area were pushed flat, and needles
// along a fixed curve pushed each vertex on it nearer to the next.
BOOST_AUTO_TEST_CASE(little_room_for_numbers)
{
  for (const unsigned seed : {20077, 20415, 70288, 70579}) {
    Task task = random_tasks::random_task(seed);
    BOOST_TEST(outcome(task) == "valid");
  }
}

// Quads of no width may have good angles.
BOOST_AUTO_TEST_CASE(quads_keep_their_width)
{
  for (const unsigned seed : {624, 1218, 1220}) {
    Task task = random_tasks::random_task(seed);
    task.route = QL::FIELD;
    task.seconds = 20;
    Results results;
    BOOST_TEST_REQUIRE(all_stages::run(task, results));
    double shortest = (std::numeric_limits<double>::infinity)();
    for (const auto e : edges(results.quads)) {
      const auto h = halfedge(e, results.quads);
      shortest = (std::min)(shortest, std::sqrt(CGAL::squared_distance(
                                          results.quads.point(source(h, results.quads)),
                                          results.quads.point(target(h, results.quads)))));
    }
    BOOST_TEST(shortest > 1e-3 * random_tasks::mean_edge_length(results.quads));
  }
}

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

BOOST_AUTO_TEST_SUITE_END()
