// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/internal/field/matching.h>
#include <CGAL/Quad_layouts/internal/surface/make_triangle_surface.h>
#include <CGAL/Quad_layouts/internal/surface/separate_fixed_curves.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <limits>
#include <string>

BOOST_AUTO_TEST_SUITE(test_make_triangle_surface)

namespace QL = CGAL::Quad_layouts;
using QL::internal::euler_characteristic;
using QL::internal::make_checked_surface;
using QL::internal::make_triangle_surface;
using QL::internal::Triangle;
using QL::internal::Triangle_surface;

namespace {

using Mesh = generated::Mesh;
using Points = std::vector<QL::internal::Point>;
using Triangles = std::vector<Triangle>;

const double infinity = std::numeric_limits<double>::infinity();

Triangle_surface surface_of(const Mesh& mesh)
{
  return make_triangle_surface(mesh, get(CGAL::vertex_point, mesh));
}

const Points tetrahedron_points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Triangles tetrahedron = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

// checks that the surface is refused with an `Exception` whose message contains `text`
template <class Exception>
void check_refused(const Points& points, const Triangles& triangles, const std::string& text)
{
  BOOST_CHECK_EXCEPTION(make_checked_surface(points, triangles), Exception,
                        [&](const Exception& e) {
                          BOOST_TEST_MESSAGE(e.what());
                          return std::string(e.what()).find(text) != std::string::npos;
                        });
}

Points scaled(Points points, double scale)
{
  for (QL::internal::Point& p : points)
    p *= scale;
  return points;
}

} // namespace

BOOST_AUTO_TEST_CASE(scales_beyond_double_precision_are_refused)
{
  check_refused<QL::Unsuitable_scale>(scaled(tetrahedron_points, 1e70), tetrahedron,
                                      "vertex 1 has a coordinate that is too large");
  check_refused<QL::Unsuitable_scale>(scaled(tetrahedron_points, 1e-70), tetrahedron, "too small");
  for (const double scale : {1e-50, 1e-6, 1e6, 1e50})
    make_checked_surface(scaled(tetrahedron_points, scale), tetrahedron);
}

BOOST_AUTO_TEST_CASE(numbers_follow_the_mesh)
{
  Mesh mesh;
  const auto first = mesh.add_vertex();
  CGAL::copy_face_graph(generated::cube(2), mesh);
  mesh.remove_vertex(first); // leaves a gap in the indices of the mesh
  const Triangle_surface s = surface_of(mesh);
  BOOST_TEST(s.number_of_vertices() == 26);
  BOOST_TEST(s.number_of_faces() == 48);
  const auto vertex = QL::internal::descriptors(vertices(mesh));
  const auto number = QL::internal::vertex_numbers(mesh);
  int f = 0;
  for (const auto face : faces(mesh)) {
    auto h = halfedge(face, mesh);
    for (int i = 0; i < 3; ++i, h = next(h, mesh)) {
      BOOST_TEST(s.source(3 * f + i) == get(number, source(h, mesh)));
      BOOST_TEST(vertex[s.target(3 * f + i)] == target(h, mesh));
    }
    ++f;
  }
}

BOOST_AUTO_TEST_CASE(generated_meshes_are_what_they_say)
{
  const auto volume = [](const Mesh& m) { return CGAL::Polygon_mesh_processing::volume(m); };
  for (const Mesh& sphere :
       {generated::tetrahedron(), generated::cube(3), generated::icosphere(0),
        generated::icosphere(3), generated::noisy(generated::icosphere(2), 0.02, 7)}) {
    BOOST_TEST(euler_characteristic(surface_of(sphere)) == 2);
    BOOST_TEST(volume(sphere) > 0);
  }
  BOOST_TEST(volume(generated::icosphere(4)) == 4.18879, boost::test_tools::tolerance(0.01));
  BOOST_TEST(euler_characteristic(surface_of(generated::torus(20, 10))) == 0);
  BOOST_TEST(volume(generated::torus(60, 60)) == 39.478, boost::test_tools::tolerance(0.01));
  for (int genus = 1; genus < 4; ++genus)
    BOOST_TEST(euler_characteristic(surface_of(generated::slab_with_holes(genus, 2))) ==
               2 - 2 * genus);
  const Mesh two = generated::disjoint_union(generated::cube(2),
                                             generated::translated(generated::cube(1), {3, 0, 0}));
  BOOST_TEST(euler_characteristic(surface_of(two)) == 4);
  BOOST_TEST(volume(two) == 2., boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(takes_a_polyhedron)
{
  const Mesh mesh = generated::torus(6, 5);
  CGAL::Polyhedron_3<generated::Kernel> polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  const Triangle_surface s = make_triangle_surface(polyhedron, get(CGAL::vertex_point, polyhedron));
  BOOST_TEST(s.number_of_vertices() == 30);
  BOOST_TEST(euler_characteristic(s) == 0);
}

BOOST_AUTO_TEST_CASE(isolated_vertices_stay)
{
  Points points = tetrahedron_points;
  points.insert(points.begin() + 4, {7, 7, 7});
  const Triangle_surface s = make_checked_surface(points, tetrahedron);
  BOOST_TEST(s.number_of_vertices() == 5);
  BOOST_TEST(s.halfedge(4) == -1);
}

BOOST_AUTO_TEST_CASE(refuses_faces_that_are_no_triangles)
{
  Mesh mesh;
  const auto p = [](double x, double y, double z) { return generated::Point(x, y, z); };
  CGAL::make_hexahedron(p(0, 0, 0), p(1, 0, 0), p(1, 1, 0), p(0, 1, 0), p(0, 1, 1), p(0, 0, 1),
                        p(1, 0, 1), p(1, 1, 1), mesh);
  BOOST_CHECK_THROW(surface_of(mesh), QL::Non_triangle_face);
}

BOOST_AUTO_TEST_CASE(refuses_an_empty_mesh)
{
  BOOST_CHECK_THROW(surface_of(Mesh()), QL::Empty_mesh);
  check_refused<QL::Empty_mesh>(tetrahedron_points, {}, "no face");
}

BOOST_AUTO_TEST_CASE(refuses_degenerate_faces)
{
  check_refused<QL::Degenerate_face>(tetrahedron_points, {{0, 2, 1}, {0, 1, 1}},
                                     "face 1 (vertices 0, 1, 1) repeats");
  Points points = tetrahedron_points;
  points[3] = {0.5, 0.5, 0};
  check_refused<QL::Degenerate_face>(points, tetrahedron, "face 3 (vertices 1, 2, 3) has no area");
  // as flat as doubles can be, but not degenerate
  points[3] = {0.5, 0.5, 1e-300};
  BOOST_TEST(make_checked_surface(points, tetrahedron).number_of_faces() == 4);
}

BOOST_AUTO_TEST_CASE(refuses_duplicate_faces)
{
  Triangles triangles = tetrahedron;
  triangles.push_back({3, 2, 1});
  check_refused<QL::Duplicate_face>(tetrahedron_points, triangles,
                                    "face 3 (vertices 1, 2, 3) and face 4");
}

BOOST_AUTO_TEST_CASE(refuses_points_that_are_not_finite)
{
  for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    Points points = tetrahedron_points;
    points[2].y() = bad;
    check_refused<QL::Non_finite_point>(points, tetrahedron, "vertex 2");
  }
}

BOOST_AUTO_TEST_CASE(knows_borders)
{
  Triangles triangles = tetrahedron;
  triangles.pop_back();
  const Triangle_surface s = make_checked_surface(tetrahedron_points, triangles);
  int on_border = 0, fixed = 0;
  for (int v = 0; v < s.number_of_vertices(); ++v) {
    on_border += s.is_on_border(v);
    if (s.is_on_border(v)) {
      BOOST_TEST(s.is_border(s.halfedge(v)));
      BOOST_TEST(s.is_border(s.border_halfedge_to(v)));
      BOOST_TEST(s.target(s.border_halfedge_to(v)) == v);
    }
  }
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    fixed += s.is_fixed(h);
  BOOST_TEST(on_border == 3);
  BOOST_TEST(fixed == 3);
}

BOOST_AUTO_TEST_CASE(refuses_edges_that_are_not_manifold)
{
  Triangles triangles = tetrahedron;
  std::swap(triangles[3][0], triangles[3][1]);
  check_refused<QL::Non_manifold_edge>(tetrahedron_points, triangles, "face 3");
}

BOOST_AUTO_TEST_CASE(refuses_vertices_with_several_fans)
{
  Points points = tetrahedron_points;
  Triangles triangles = tetrahedron;
  for (int i = 1; i < 4; ++i)
    points.push_back(-tetrahedron_points[i]);
  for (const auto& [a, b, c] : tetrahedron) {
    const auto mirrored = [](int v) { return v == 0 ? 0 : v + 3; };
    triangles.push_back({mirrored(a), mirrored(c), mirrored(b)});
  }
  check_refused<QL::Non_manifold_vertex>(points, triangles, "vertex 0");
}

// Faces are divided where curves are close, in several steps: all that comes behind the elements of
// the given surface knows where it comes from.
BOOST_AUTO_TEST_CASE(divided_surfaces)
{
  Triangle_surface whole = make_checked_surface(tetrahedron_points, tetrahedron);
  const Triangle_surface same = QL::internal::separate_fixed_curves(whole);
  BOOST_TEST(same.number_of_vertices() == 4);
  BOOST_TEST(same.original().number_of_vertices() == 4);
  for (const int h : {0, 1, 2, 4}) // the sides of the first face, and another one
    whole.fix(h);
  const Triangle_surface divided = QL::internal::separate_fixed_curves(whole);
  BOOST_TEST(euler_characteristic(divided) == 2);
  BOOST_TEST(divided.original().number_of_vertices() == 4);
  BOOST_TEST(divided.original().number_of_faces() == 4);
  BOOST_TEST(divided.number_of_faces() > 4);
  std::vector<double> area(4, 0.);
  int fixed = 0;
  for (int f = 0; f < divided.number_of_faces(); ++f) {
    const int origin = divided.origin(f);
    if (f < 4) {
      BOOST_TEST(origin == f);
      BOOST_TEST(divided.source(3 * f) == whole.source(3 * f));
    }
    area[origin] += divided.area(f);
    BOOST_TEST(divided.normal(f).dot(whole.normal(origin)) > 1 - 1e-12);
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      fixed += divided.is_fixed(h);
  }
  for (int f = 0; f < 4; ++f) {
    BOOST_TEST(area[f] == whole.area(f), boost::test_tools::tolerance(1e-12));
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      BOOST_TEST(divided.original().is_fixed(h) == whole.is_fixed(h));
  }
  BOOST_TEST(fixed == 2 * 4);
  for (int v = 4; v < divided.number_of_vertices(); ++v) {
    QL::internal::Point sum(0, 0, 0);
    for (const int parent : divided.parents(v)) {
      BOOST_TEST(parent < v);
      sum += divided.point(parent);
    }
    BOOST_TEST((divided.point(v) - sum / double(divided.parents(v).size())).norm() < 1e-12);
  }
}

BOOST_AUTO_TEST_SUITE_END()
