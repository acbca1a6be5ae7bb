// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <CGAL/Quad_layouts/measure_quad_mesh.h>

#include "generated_quad_meshes.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_measure_quad_mesh)

namespace QL = CGAL::Quad_layouts;
using generated::Mesh;
using generated::Point;

namespace {

Mesh single_quad(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return generated::mesh_of_polygons({a, b, c, d}, {{0, 1, 2, 3}});
}

double scaled_jacobian(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return QL::measure_quad_mesh(single_quad(a, b, c, d)).msj_minimum;
}

// an L of three squares, each of n x n quads
Mesh l_shape(int n)
{
  std::vector<Point> points;
  std::vector<std::vector<int>> quads;
  std::map<std::pair<int, int>, int> number;
  const auto corner = [&](int i, int j) {
    const auto [position, is_new] = number.try_emplace({i, j}, int(points.size()));
    if (is_new)
      points.emplace_back(i, j, 0);
    return position->second;
  };
  for (int i = 0; i < 2 * n; ++i)
    for (int j = 0; j < 2 * n; ++j)
      if (i < n || j < n)
        quads.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)});
  return generated::mesh_of_polygons(points, quads);
}

} // namespace

BOOST_AUTO_TEST_CASE(scaled_jacobian_of_known_quads)
{
  const Point o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), xy(1, 1, 0);
  BOOST_TEST(scaled_jacobian(o, x, xy, y) == 1.);
  BOOST_TEST(scaled_jacobian(o, Point(9, 0, 0), Point(9, 1, 0), y) == 1.);
  BOOST_TEST(scaled_jacobian(o, Point(2, 0, 0), xy, y) == std::sqrt(0.5),
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(scaled_jacobian(o, x, Point(.2, .1, 0), y) < 0.);
  BOOST_TEST(scaled_jacobian(o, x, x, y) <= 0.);
  BOOST_TEST(QL::measure_quad_mesh(single_quad(o, x, Point(.2, .1, 0), y)).inverted_quads == 1);
}

BOOST_AUTO_TEST_CASE(cube)
{
  for (const int n : {1, 4}) {
    const QL::Quad_mesh_measures m = QL::measure_quad_mesh(generated::quad_box({n, n, n}));
    BOOST_TEST(m.quads == 6 * n * n);
    BOOST_TEST(m.vertices == 6 * n * n + 2);
    BOOST_TEST(m.edges == 12 * n * n);
    BOOST_TEST(m.non_quads == 0);
    BOOST_TEST(m.t_junctions == 0);
    BOOST_TEST(m.euler_characteristic == 2);
    BOOST_TEST(m.components == 1);
    BOOST_TEST(m.border_edges == 0);
    BOOST_TEST(m.irregular_vertices == 8);
    BOOST_TEST(m.valences.at(3) == 8);
    BOOST_TEST(m.patches == 6);
    BOOST_TEST(m.patches_floor == 6);
    BOOST_TEST(m.msj_average == 1., boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(components_without_irregular_vertex_are_single_patches)
{
  const Mesh torus = generated::quad_torus(12, 8);
  const QL::Quad_mesh_measures m = QL::measure_quad_mesh(torus);
  BOOST_TEST(m.euler_characteristic == 0);
  BOOST_TEST(m.irregular_vertices == 0);
  BOOST_TEST(m.patches == 1);
  const Mesh two = generated::disjoint_union(
      torus, generated::translated(generated::quad_box({3, 3, 3}), {9, 0, 0}));
  BOOST_TEST(QL::measure_quad_mesh(two).components == 2);
  BOOST_TEST(QL::measure_quad_mesh(two).patches == 7);
}

BOOST_AUTO_TEST_CASE(borders)
{
  const QL::Quad_mesh_measures tube = QL::measure_quad_mesh(generated::quad_torus(12, 8, false));
  BOOST_TEST(tube.border_edges == 16);
  BOOST_TEST(tube.irregular_vertices == 0);
  BOOST_TEST(tube.patches == 1);
  const QL::Quad_mesh_measures l = QL::measure_quad_mesh(l_shape(3));
  BOOST_TEST(l.euler_characteristic == 1);
  BOOST_TEST(l.irregular_vertices == 6);
  BOOST_TEST(l.patches == 3);
}

BOOST_AUTO_TEST_CASE(t_junctions_are_counted)
{
  const std::vector<Point> points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0},
                                     {0, 2, 0}, {3, 0, 0}, {3, 1, 0}, {3, 2, 0}};
  const QL::Quad_mesh_measures m = QL::measure_quad_mesh(
      generated::mesh_of_polygons(points, {{0, 1, 2, 3, 4}, {1, 5, 6, 2}, {2, 6, 7, 3}}));
  BOOST_TEST(m.t_junctions == 1);
  BOOST_TEST(m.non_quads == 1);
  BOOST_TEST(m.quads == 2);
  BOOST_TEST(m.patches == 0);
}

BOOST_AUTO_TEST_CASE(distance_to_a_surface)
{
  const Mesh cube = generated::quad_box({4, 4, 4}), surface = generated::triangulated(cube);
  const QL::Quad_mesh_measures same = QL::measure_quad_mesh(cube, surface);
  BOOST_TEST(same.maximum_distance_to_surface < 1e-12);
  BOOST_TEST(same.maximum_distance_from_surface < 1e-12);
  BOOST_TEST(same.quads_against_surface == 0);

  const Mesh larger = generated::quad_box({4, 4, 4}, 1.5, 1, 1);
  const QL::Quad_mesh_measures m = QL::measure_quad_mesh(larger, surface);
  BOOST_TEST(m.maximum_distance_to_surface == 0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(m.maximum_distance_from_surface == 0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(m.mean_distance_to_surface > 0.);

  Mesh turned = surface;
  CGAL::Polygon_mesh_processing::reverse_face_orientations(turned);
  BOOST_TEST(QL::measure_quad_mesh(cube, turned).quads_against_surface == 96);
  BOOST_CHECK_THROW(QL::measure_quad_mesh(cube, Mesh()), QL::Empty_mesh);
}

BOOST_AUTO_TEST_CASE(other_meshes_and_point_maps)
{
  CGAL::Polyhedron_3<generated::Kernel> polyhedron;
  CGAL::copy_face_graph(generated::quad_sphere(5), polyhedron);
  BOOST_TEST(QL::measure_quad_mesh(polyhedron).patches == 6);

  Mesh mesh = generated::quad_box({2, 2, 2});
  const auto flat =
      mesh.add_property_map<Mesh::Vertex_index, Point>("v:flat", Point(0, 0, 0)).first;
  BOOST_TEST(QL::measure_quad_mesh(mesh, QL::parameters::vertex_point_map(flat)).inverted_quads ==
             24);
  BOOST_TEST(QL::measure_quad_mesh(mesh).inverted_quads == 0);
}

// the figures come from an independent program
BOOST_AUTO_TEST_CASE(meshes_of_cgal)
{
  struct Expected
  {
    std::string name;
    int patches, irregular, euler;
    double msj_minimum, msj_average;
  };
  for (const Expected& e : {Expected{"cross_quad", 22, 24, 2, 1, 1},
                            {"cube_quad", 6, 8, 2, 1, 1},
                            {"torus_quad", 1, 0, 0, 0.8291549773933942, 0.9070308517578854}}) {
    const std::string file = CGAL::data_file_path("meshes/" + e.name + ".off");
    Mesh mesh;
    if (!std::filesystem::exists(file) || !CGAL::IO::read_polygon_mesh(file, mesh)) {
      BOOST_TEST_MESSAGE(e.name << " skipped");
      continue;
    }
    const QL::Quad_mesh_measures m = QL::measure_quad_mesh(mesh);
    BOOST_TEST(m.patches == e.patches);
    BOOST_TEST(m.irregular_vertices == e.irregular);
    BOOST_TEST(m.euler_characteristic == e.euler);
    BOOST_TEST(m.msj_minimum == e.msj_minimum, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(m.msj_average == e.msj_average, boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_SUITE_END()
