// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/IO/seamless_parametrization.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/parametrize_seamlessly.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_seamless_parametrization_IO)

namespace QL = CGAL::Quad_layouts;
namespace params = QL::parameters;

using generated::Mesh;
using QL::Seamless_parametrization;

namespace {

using Point_2 = CGAL::Simple_cartesian<double>::Point_2;
using Vector_2 = CGAL::Simple_cartesian<double>::Vector_2;
using Edge_flags = Mesh::Property_map<Mesh::Edge_index, bool>;

Edge_flags sharp_edges(Mesh& mesh, const char* name)
{
  const auto result = mesh.add_property_map<Mesh::Edge_index, bool>(name, false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 40, result);
  return result;
}

Seamless_parametrization parametrization(const Mesh& mesh, Edge_flags is_sharp)
{
  return QL::parametrize_seamlessly(
      QL::compute_cross_field(mesh, params::default_values().edge_is_constrained_map(is_sharp)));
}

// writes the map with some digits, reads the file as a mesh and as a map
Seamless_parametrization through_file(const Seamless_parametrization& map, int digits)
{
  std::stringstream file;
  BOOST_TEST(QL::IO::write_seamless_parametrization(file, map));
  if (digits < std::numeric_limits<double>::max_digits10) {
    std::stringstream coarse;
    coarse.precision(digits);
    for (std::string line; std::getline(file, line);) {
      std::istringstream words(line);
      double u, v;
      std::string keyword;
      if (words >> keyword && keyword == "vt" && words >> u >> v)
        coarse << "vt " << u << ' ' << v << '\n';
      else
        coarse << line << '\n';
    }
    file.swap(coarse);
  }
  Mesh mesh;
  std::istringstream copy(file.str());
  BOOST_TEST(CGAL::IO::read_OBJ(copy, mesh));
  const Edge_flags is_sharp = sharp_edges(mesh, "e:sharp");
  return QL::IO::read_seamless_parametrization(
      file, mesh, params::target_edge_length(map.edge_length).edge_is_constrained_map(is_sharp));
}

void check_round_trip(Mesh mesh)
{
  const Seamless_parametrization map = parametrization(mesh, sharp_edges(mesh, "e:sharp"));
  BOOST_TEST(map.is_locally_injective());
  const auto& surface = map.surface();
  for (const int digits : {6, 17}) {
    const Seamless_parametrization same = through_file(map, digits);
    BOOST_TEST(same.is_locally_injective());
    BOOST_TEST(same.edge_length == map.edge_length);
    BOOST_TEST(same.vertex_index == map.vertex_index);
    BOOST_TEST_REQUIRE(same.surface().number_of_faces() == surface.number_of_faces());
    const double most = 1e4 * std::pow(10., -digits);
    for (int f = 0; f < surface.number_of_faces(); ++f) {
      // a face may begin with another corner
      const int h = 3 * f, other = same.surface().source(h) == surface.source(h)       ? h
                                   : same.surface().source(h + 1) == surface.source(h) ? h + 1
                                                                                       : h + 2;
      const double length = (map.point(surface.next(h)) - map.point(h)).norm();
      const double rounding = 4 * same.unit / same.edge_length;
      BOOST_TEST(std::abs((same.point(surface.next(other)) - same.point(other)).norm() - length) <
                 most * (1 + length) + rounding);
    }
  }
}

// a square of n x n squares, and coordinates for the corner at the target of each halfedge: at
// first those of the points, times a scale
struct Square
{
  explicit Square(int n, double scale = 1) : mesh(generated::plate({{0, 0}}, n))
  {
    for (const auto h : mesh.halfedges()) {
      const auto& p = mesh.point(mesh.target(h));
      corners.emplace_back(scale * p.x(), scale * p.y());
    }
  }

  Seamless_parametrization parametrization() const
  {
    return QL::make_seamless_parametrization(
        mesh, boost::make_function_property_map<Mesh::Halfedge_index>(
                  [this](Mesh::Halfedge_index h) { return corners[h]; }));
  }

  std::string refusal() const
  {
    try {
      parametrization();
    } catch (const QL::Invalid_parametrization& error) {
      return error.what();
    }
    return "";
  }

  Mesh mesh;
  std::vector<Point_2> corners;
};

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

std::string refusal(const Mesh& mesh, const std::string& file)
{
  std::istringstream in(file);
  try {
    QL::IO::read_seamless_parametrization(in, mesh);
  } catch (const QL::Error& error) {
    return error.what();
  }
  return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(of_a_square)
{
  const Square square(4, 8);
  const Seamless_parametrization map = square.parametrization();
  BOOST_TEST(map.is_locally_injective());
  BOOST_TEST(map.edge_length == 1. / 8, boost::test_tools::tolerance(1e-12));
  const QL::Cross_field field = QL::compute_cross_field(map);
  for (int f = 0; f < map.surface().number_of_faces(); ++f)
    BOOST_TEST((field.direction(f, 0) - Eigen::Vector3d::UnitX()).norm() < 1e-12);
  BOOST_TEST(QL::trace_motorcycle_graph(map).number_of_faces() == 1);
}

BOOST_AUTO_TEST_CASE(charts_may_turn)
{
  Square square(4);
  for (const auto f : square.mesh.faces())
    for (const auto h : CGAL::halfedges_around_face(square.mesh.halfedge(f), square.mesh)) {
      Point_2& p = square.corners[h];
      switch (int(f) % 4) {
        case 0: p = Point_2(-p.y() + 3, p.x() + int(f)); break;
        case 1: p = Point_2(-p.x() - 1, -p.y()); break;
        case 2: p = Point_2(p.y(), -p.x()); break;
        default: break;
      }
    }
  const Seamless_parametrization map = square.parametrization();
  BOOST_TEST(map.is_locally_injective());
  BOOST_TEST(QL::compute_cross_field(map).number_of_singularities() == 4); // the corners
  BOOST_TEST(QL::trace_motorcycle_graph(map).number_of_faces() == 1);
}

BOOST_AUTO_TEST_CASE(the_worst_edge_is_named)
{
  const Square square(4);
  BOOST_TEST(square.refusal() == "");
  for (const auto e : square.mesh.edges()) {
    const auto h = square.mesh.halfedge(e);
    if (square.mesh.is_border(e))
      continue;
    Square torn = square; // all edges of one face differ, this one the most
    torn.corners[h] += Vector_2(.05, .02);
    torn.corners[square.mesh.prev(h)] -= Vector_2(.05, .02);
    const std::string message = torn.refusal();
    const auto names = [&](Mesh::Halfedge_index g) {
      return contains(message, "from vertex " + std::to_string(int(square.mesh.source(g))) +
                                   " to vertex " + std::to_string(int(square.mesh.target(g))) +
                                   " differ");
    };
    BOOST_TEST(contains(message, "not seamless"), message);
    BOOST_TEST((names(h) || names(square.mesh.opposite(h))), message);
  }

  Square skew(4);
  for (Point_2& p : skew.corners)
    p = Point_2(p.x() + .1 * p.y(), p.y());
  BOOST_TEST(contains(skew.refusal(), "no line of constant coordinates"));
}

BOOST_AUTO_TEST_CASE(unusable_coordinates)
{
  Square square(2);
  square.corners.assign(square.corners.size(), Point_2(0, 0));
  BOOST_TEST(contains(square.refusal(), "no positive area"));
  square.corners.assign(square.corners.size(), Point_2(std::numeric_limits<double>::infinity(), 0));
  BOOST_TEST(contains(square.refusal(), "not a finite number"));
}

BOOST_AUTO_TEST_CASE(inverted_triangles_are_counted)
{
  Square square(4);
  for (const auto v : square.mesh.vertices())
    if (!square.mesh.is_border(v)) { // out of its ring
      for (const auto h : CGAL::halfedges_around_target(square.mesh.halfedge(v), square.mesh))
        square.corners[h] += Vector_2(2. / 4, 0);
      break;
    }
  const Seamless_parametrization map = square.parametrization();
  BOOST_TEST(map.inverted > 0);
  BOOST_TEST(!map.is_locally_injective());
}

BOOST_AUTO_TEST_CASE(generated_surfaces)
{
  check_round_trip(generated::icosphere(2));
  check_round_trip(generated::torus(24, 12));
  check_round_trip(generated::cube(4));
  check_round_trip(generated::plate({{0, 0}, {1, 0}, {1, 1}}, 4));
}

BOOST_AUTO_TEST_CASE(real_models)
{
  for (const std::string name : {"eight", "cross", "spool"}) {
    const std::string file = CGAL::data_file_path("meshes/" + name + ".off");
    Mesh mesh;
    if (!std::ifstream(file) || !CGAL::IO::read_polygon_mesh(file, mesh)) {
      BOOST_TEST_MESSAGE("skipped: " << file);
      continue;
    }
    check_round_trip(mesh);
  }
}

BOOST_AUTO_TEST_CASE(files)
{
  Mesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}),
             c = mesh.add_vertex({1, 1, 0}), d = mesh.add_vertex({0, 1, 0});
  mesh.add_face(a, b, c);
  mesh.add_face(c, d, a);
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n",
                    texture = "vt 0 0 # a comment\nvt 2 0 0\nvt 2 2\nvt 0 2\n",
                    second = "f 3/3 4/4 1/1\n", head = points + texture + "o thing\ns off\n";
  // with or without normals, counted from the begin or the end, from any corner
  for (const std::string first :
       {"1/1 2/2 3/3", "1/1/1 2/2/1 3/3/1", "2/2 3/3 1/1", "-4/-4 -3/-3 -2/-2"}) {
    std::istringstream in(head + "f " + first + '\n' + second);
    const Seamless_parametrization map = QL::IO::read_seamless_parametrization(in, mesh);
    BOOST_TEST(map.edge_length == .5);
    BOOST_TEST(map.is_locally_injective());
  }

  const auto refused = [&](const std::string& rest, const std::string& reason) {
    const std::string message = refusal(mesh, head + rest);
    BOOST_TEST(contains(message, reason), message);
  };
  refused("f 1 2 3\n", "line 11: a corner with texture coordinates");
  refused("f 1//1 2//1 3//1\n", "line 11: a corner with texture coordinates");
  refused("f 1/1 2/2\n", "line 11: a corner with texture coordinates");
  refused("f 1/1 2/2 3/3 4/4\n", "line 11: the face is no triangle");
  refused("f 1/1 2/2 3/5\n", "no element 5");
  refused("f 1/0 2/2 3/3\n", "no element 0");
  refused("f 1/1 3/3 2/2\n", "face 0 has other vertices");
  refused("f 1/1 2/2 3/3\n", "the mesh has more faces");
  refused("f 1/1 2/2 3/3\n" + second + second, "the mesh has no such face");
  refused("vt 0 x\n", "line 11: a number is expected");
  refused("f 1/1 2/2 3/2\n" + second, "not seamless");
}

BOOST_AUTO_TEST_SUITE_END()
