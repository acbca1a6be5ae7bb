// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <functional>

BOOST_AUTO_TEST_SUITE(test_parameters)

namespace QL = CGAL::Quad_layouts;
namespace np_tags = QL::internal_np;
namespace params = QL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace {

struct Values
{
  double deviation;
  int iterations;
};

// reads a pack the way the functions of the package do
template <class NamedParameters = params::Default_named_parameters>
Values read(const NamedParameters& np = params::default_values())
{
  using params::choose_parameter;
  using params::get_parameter;
  const double deviation = choose_parameter(get_parameter(np, np_tags::maximum_deviation), 15.);
  const int iterations = choose_parameter(get_parameter(np, np_tags::number_of_iterations), 7);
  return {deviation, iterations};
}

struct Counter
{
  int calls = 0;
};

template <class NamedParameters>
void count(const NamedParameters& np)
{
  ++params::get_parameter_reference(np, np_tags::visitor).calls;
}

} // namespace

BOOST_AUTO_TEST_CASE(defaults)
{
  BOOST_TEST(read().deviation == 15.);
  BOOST_TEST(read().iterations == 7);
}

BOOST_AUTO_TEST_CASE(chains_in_any_order)
{
  const Values a = read(params::maximum_deviation(20).number_of_iterations(3));
  const Values b = read(
      params::number_of_iterations(3).maximum_displacement(1).maximum_deviation(20));
  BOOST_TEST(a.deviation == 20);
  BOOST_TEST(b.deviation == 20);
  BOOST_TEST(a.iterations == 3);
  BOOST_TEST(b.iterations == 3);
}

BOOST_AUTO_TEST_CASE(takes_packs_of_CGAL)
{
  const auto np = CGAL::parameters::number_of_iterations(3);
  BOOST_TEST(read(np).iterations == 3);
  BOOST_TEST(read(np).deviation == 15.);
  const Values extended = read(params::extend(np).maximum_deviation(20));
  BOOST_TEST(extended.iterations == 3);
  BOOST_TEST(extended.deviation == 20);
}

BOOST_AUTO_TEST_CASE(last_value_wins)
{
  BOOST_TEST(read(params::maximum_deviation(20).maximum_deviation(25.5)).deviation == 25.5);
}

BOOST_AUTO_TEST_CASE(knows_what_is_absent)
{
  using Pack = decltype(params::maximum_deviation(20).verbose(true));
  static_assert(!params::is_default_parameter<Pack, np_tags::maximum_deviation_t>::value);
  static_assert(!params::is_default_parameter<Pack, np_tags::verbose_t>::value);
  static_assert(params::is_default_parameter<Pack, np_tags::maximum_displacement_t>::value);
  static_assert(params::is_default_parameter<Pack, np_tags::visitor_t>::value);
  BOOST_TEST(read(Pack(params::maximum_deviation(20).verbose(true))).deviation == 20);
}

BOOST_AUTO_TEST_CASE(references_reach_the_user)
{
  Counter counter;
  count(params::maximum_deviation(20).visitor(std::ref(counter)).maximum_displacement(2));
  count(CGAL::parameters::visitor(std::ref(counter)));
  BOOST_TEST(counter.calls == 2);
}

BOOST_AUTO_TEST_CASE(functions_of_CGAL_take_our_packs)
{
  Mesh mesh;
  const Kernel::Point_3 o(0, 0, 0), a(1, 0, 0), b(1, 1, 0), c(0, 1, 0), d(0, 1, 1), e(0, 0, 1),
      f(1, 0, 1), g(1, 1, 1);
  CGAL::make_hexahedron(o, a, b, c, d, e, f, g, mesh);
  const auto np =
      params::maximum_deviation(20).vertex_point_map(mesh.points()).geom_traits(Kernel());
  BOOST_TEST(PMP::triangulate_faces(mesh, np));
  BOOST_TEST(CGAL::is_triangle_mesh(mesh));
  BOOST_TEST(PMP::volume(mesh, np) == 1., boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
