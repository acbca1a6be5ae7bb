// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_compute_cross_field)

namespace QL = CGAL::Quad_layouts;
namespace params = QL::parameters;

using generated::Mesh;
using generated::Point;
using generated::Vector;
using Face_vectors = Mesh::Property_map<Mesh::Face_index, Vector>;

namespace {

constexpr double degree = CGAL_PI / 180;

// the least angle between a direction of face f and `v`, up to quarter turns
double deviation(const QL::Cross_field& field, int f, const Eigen::Vector3d& v)
{
  const double c = std::abs(field.direction(f, 0).dot(v.normalized()));
  const double s = std::abs(field.direction(f, 1).dot(v.normalized()));
  return std::atan2((std::min)(c, s), (std::max)(c, s));
}

std::vector<int> indices(const QL::Cross_field& field)
{
  std::vector<int> result;
  for (int v = 0; v < field.surface().number_of_vertices(); ++v)
    result.push_back(field.index(v));
  return result;
}

// Borders are lines of the field, with one quadrant or more at each vertex, and the sum of all
// indices is four times the Euler characteristic.
void check_borders(const QL::Cross_field& field)
{
  const auto& surface = field.surface();
  int euler = surface.number_of_vertices() - surface.number_of_edges() + surface.number_of_faces();
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    if (surface.is_border(h))
      BOOST_TEST(deviation(field, surface.face(h), surface.vector(h)) < 1e-9);
  for (int v = 0; v < surface.number_of_vertices(); ++v) {
    euler -= surface.halfedge(v) < 0;
    if (surface.is_on_border(v))
      BOOST_TEST(field.index(v) < 2);
  }
  BOOST_TEST(field.index_sum() == 4 * euler);
}

// the indices by position: copies of a mesh may number their vertices in another order
std::map<std::array<double, 3>, int> indices_in_space(const QL::Cross_field& field)
{
  std::map<std::array<double, 3>, int> result;
  for (int v = 0; v < field.surface().number_of_vertices(); ++v) {
    const auto& p = field.surface().point(v);
    result[{p.x(), p.y(), p.z()}] = field.index(v);
  }
  return result;
}

int strongest_index(const QL::Cross_field& field)
{
  const auto all = indices(field);
  return *std::max_element(all.begin(), all.end());
}

// what holds for every field: matchings of opposite halfedges cancel; going around a vertex they
// turn directions back by the index, as whole turns do not show; and the indices sum to 4 chi
void check_invariants(const QL::Cross_field& field)
{
  const auto& s = field.surface();
  for (int h = 0; h < s.number_of_halfedges(); ++h)
    BOOST_REQUIRE((field.matching(h) + field.matching(s.opposite(h))) % 4 == 0);
  for (int f = 0; f < s.number_of_faces(); ++f)
    BOOST_REQUIRE(std::isfinite(field.angle(f)));
  for (int v = 0; v < s.number_of_vertices(); ++v) {
    const int first = s.halfedge(v);
    double angle = field.angle(s.face(first)), corners = 0;
    int direction = 0;
    s.for_each_outgoing(v, [&](int h) {
      const int out = s.prev(h);
      direction += field.matching(out);
      angle += s.transport(out);
      corners += s.corner_angle(h);
    });
    // transported once around, the frame has turned by the angle defect; directions by the
    // matchings
    const double holonomy = std::remainder(angle - field.angle(s.face(first)) + corners,
                                           360 * degree);
    BOOST_REQUIRE_SMALL(holonomy, 1e-6);
    BOOST_REQUIRE((direction - field.index(v)) % 4 == 0);
  }
  BOOST_TEST(field.index_sum() ==
             4 * (s.number_of_vertices() - s.number_of_edges() + s.number_of_faces()));
}

QL::Cross_field checked_field(const Mesh& mesh, QL::Cross_field_method method = QL::DIFFUSION)
{
  const QL::Cross_field field = QL::compute_cross_field(mesh, params::cross_field_method(method));
  check_invariants(field);
  return field;
}

// the weighted sum of the squared angles by which a field turns across edges
double energy(const QL::Cross_field& field)
{
  const auto& s = field.surface();
  const QL::internal::Face_connection connection(s);
  double sum = 0;
  for (int e = 0; e < s.number_of_edges(); ++e) {
    const int h = s.halfedge_of_edge(e);
    if (s.is_border(h))
      continue;
    const int f = s.face(h), g = s.face(s.opposite(h));
    const double turn = std::remainder(field.angle(g) - field.angle(f) - connection.transport(h) +
                                           90 * degree * field.matching(h),
                                       360 * degree);
    sum += connection.weight(e) * turn * turn;
  }
  return sum;
}

Face_vectors vectors_on(Mesh& mesh, const Vector& v)
{
  return mesh.add_property_map<Mesh::Face_index, Vector>("f:test_vector", v).first;
}

template <class Exception>
std::function<bool(const Exception&)> message_contains(const std::string& text)
{
  return
      [text](const Exception& e) { return std::string(e.what()).find(text) != std::string::npos; };
}

} // namespace

BOOST_AUTO_TEST_CASE(cube_has_its_corners_and_edges)
{
  const QL::Cross_field field = checked_field(generated::cube(4));
  BOOST_TEST(field.number_of_singularities() == 8);
  const auto& s = field.surface();
  for (int v = 0; v < s.number_of_vertices(); ++v) {
    const auto& p = s.point(v);
    const bool is_corner = ((p.array() == 0) || (p.array() == 1)).all();
    BOOST_TEST(field.index(v) == (is_corner ? 1 : 0));
  }
  for (int f = 0; f < s.number_of_faces(); ++f)
    for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0)})
      if (std::abs(s.normal(f).dot(axis)) < 0.5)
        BOOST_TEST(deviation(field, f, axis) < 1e-3);
}

BOOST_AUTO_TEST_CASE(spheres_tori_and_slabs)
{
  BOOST_TEST(checked_field(generated::icosphere(3)).number_of_singularities() == 8);
  BOOST_TEST(checked_field(generated::torus(24, 12)).number_of_singularities() == 0);
  BOOST_TEST(strongest_index(checked_field(generated::slab_with_holes(2, 3))) <= 1);
  const Mesh noisy = generated::noisy(generated::torus(40, 20), 0.1, 7);
  BOOST_TEST(checked_field(noisy).index_sum() == 0);
}

BOOST_AUTO_TEST_CASE(rounded_fields)
{
  const auto number = [](const Mesh& mesh) {
    return checked_field(mesh, QL::MIXED_INTEGER).number_of_singularities();
  };
  BOOST_TEST(number(generated::cube(4)) == 8);
  BOOST_TEST(number(generated::icosphere(3)) == 8);
  BOOST_TEST(number(generated::torus(24, 12)) == 0);
  BOOST_TEST(indices(checked_field(generated::tetrahedron(), QL::MIXED_INTEGER)) ==
                 std::vector<int>(4, 2),
             boost::test_tools::per_element());
  const Mesh holes = generated::slab_with_holes(2, 3);
  BOOST_TEST(strongest_index(checked_field(holes, QL::MIXED_INTEGER)) <= 1);
  const Mesh two = generated::disjoint_union(
      generated::icosphere(2), generated::translated(generated::cube(3), Vector(9, 0, 0)));
  BOOST_TEST(number(two) == 16);
}

BOOST_AUTO_TEST_CASE(rounded_fields_are_smoother)
{
  for (const Mesh& mesh : {generated::noisy(generated::icosphere(3), 0.05, 1),
                           generated::noisy(generated::torus(40, 20), 0.1, 7)})
    for (const double alignment : {0., 0.07}) {
      const auto np = params::curvature_alignment(alignment);
      const QL::Cross_field a = QL::compute_cross_field(mesh, np);
      const QL::Cross_field b = QL::compute_cross_field(mesh,
                                                        np.cross_field_method(QL::MIXED_INTEGER));
      check_invariants(b);
      BOOST_TEST(energy(b) < energy(a));
    }
}

BOOST_AUTO_TEST_CASE(rounded_fields_keep_borders_and_constraints)
{
  const auto rounded = params::cross_field_method(QL::MIXED_INTEGER);
  check_borders(QL::compute_cross_field(generated::plate_with_holes(3, 3, {{1, 1}}, 4), rounded));
  check_borders(QL::compute_cross_field(generated::annulus(0.5, 1, 8, 48), rounded));
  check_borders(QL::compute_cross_field(generated::disc(12), rounded));

  Mesh mesh = generated::icosphere(3);
  Face_vectors constraints = vectors_on(mesh, CGAL::NULL_VECTOR);
  for (int f : {5, 300, 301, 900})
    constraints[Mesh::Face_index(f)] = Vector(1, 2, 3 + f);
  const QL::Cross_field field = QL::compute_cross_field(
      mesh, rounded.face_constraint_map(constraints).curvature_alignment(0));
  check_invariants(field);
  for (int f : {5, 300, 301, 900}) {
    const Eigen::Vector3d v(1, 2, 3 + f), n = field.surface().normal(f);
    BOOST_TEST(deviation(field, f, v - v.dot(n) * n) < 1e-9);
  }
}

// What the search relies on: the resistance that the elimination tree gives is that of a network
// computed by dense algebra, and each change saves what it promises.
BOOST_AUTO_TEST_CASE(resistances_of_springs)
{
  using namespace QL::internal;
  const Mesh mesh = generated::noisy(generated::icosphere(1), 0.05, 4);
  const Triangle_surface surface = make_triangle_surface(mesh, mesh.points());
  const Face_connection connection(surface);
  const Cross_springs springs(connection, Curvature_pulls(connection).weighted(0.07),
                              std::vector<char>(surface.number_of_faces(), 0));
  Spring_solver solver(springs);
  std::vector<char> active(springs.number_of_springs());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(surface.number_of_faces(),
                                                    surface.number_of_faces());
  const auto ends = [&](int s) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(surface.number_of_faces());
    result[springs.from(s)] = 1;
    if (springs.to(s) != Cross_springs::ground)
      result[springs.to(s)] = -1;
    return result;
  };
  for (int s = 0; s < springs.number_of_springs(); ++s) {
    active[s] = springs.is_spring(s);
    if (active[s])
      stiffness += springs.weight(s) * ends(s) * ends(s).transpose();
  }
  solver.factorize(active);
  const Eigen::MatrixXd inverse = stiffness.inverse();
  for (int s = 0; s < springs.number_of_springs(); ++s)
    if (active[s])
      BOOST_TEST(solver.resistance(s) == ends(s).dot(inverse * ends(s)),
                 boost::test_tools::tolerance(1e-6));

  std::vector<double> angles(surface.number_of_faces(), 0.1);
  std::vector<int> jumps(springs.number_of_springs(), 0);
  solver.solve(angles, jumps);
  for (const int s : {0, 7, 31}) {
    const double d = 90 * degree, w = springs.weight(s), before = springs.energy(angles, jumps);
    const double promised =
        w * d * (2 * springs.rotation(angles, jumps, s) + d * (1 - w * solver.resistance(s)));
    ++jumps[s];
    solver.solve(angles, jumps);
    BOOST_TEST(springs.energy(angles, jumps) - before == promised,
               boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(curvature_is_followed)
{
  // a torus, sheared in its parameters by the diagonals of its triangles only: its principal
  // directions are those of its grid
  const QL::Cross_field field = checked_field(generated::torus(40, 20));
  const auto& s = field.surface();
  for (int f = 0; f < s.number_of_faces(); ++f) {
    const Eigen::Vector3d center = (s.point(s.source(3 * f)) + s.point(s.source(3 * f + 1)) +
                                    s.point(s.source(3 * f + 2))) /
                                   3;
    BOOST_TEST(deviation(field, f, Eigen::Vector3d(-center.y(), center.x(), 0)) < 10 * degree);
  }
}

BOOST_AUTO_TEST_CASE(tips_are_split)
{
  // four vertices share the index 8
  const QL::Cross_field field = checked_field(generated::tetrahedron());
  BOOST_TEST(indices(field) == std::vector<int>(4, 2), boost::test_tools::per_element());

  Mesh spiked = generated::icosphere(3);
  for (int v : {0, 3, 17, 40}) {
    Point& tip = spiked.point(Mesh::Vertex_index(v));
    tip = CGAL::ORIGIN + 4 * (tip - CGAL::ORIGIN);
  }
  BOOST_TEST(strongest_index(checked_field(spiked)) == 1);
}

BOOST_AUTO_TEST_CASE(same_answer_twice)
{
  const Mesh mesh = generated::noisy(generated::icosphere(3), 0.02, 1);
  const QL::Cross_field a = checked_field(mesh), b = checked_field(mesh);
  for (int f = 0; f < a.surface().number_of_faces(); ++f)
    BOOST_REQUIRE(a.angle(f) == b.angle(f));
  BOOST_TEST(indices(a) == indices(b), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(scale_and_shape_of_triangles)
{
  const Mesh mesh = generated::noisy(generated::slab_with_holes(1, 5), 0.05, 3);
  const QL::Cross_field field = checked_field(mesh);
  for (double scale : {1e-6, 1e6}) {
    Mesh scaled = mesh;
    for (auto v : vertices(scaled))
      scaled.point(v) = CGAL::ORIGIN + scale * (scaled.point(v) - CGAL::ORIGIN);
    BOOST_TEST(indices(checked_field(scaled)) == indices(field), boost::test_tools::per_element());
  }
  for (double scale : {1e-2, 1e-4, 1e-8}) {
    Mesh squashed = mesh;
    for (auto v : vertices(squashed)) {
      const Point p = squashed.point(v);
      squashed.point(v) = Point(p.x(), scale * p.y(), p.z());
    }
    checked_field(squashed);
  }
}

BOOST_AUTO_TEST_CASE(needles)
{
  // a tetrahedron with a point so near to one of its edges that areas vanish by rounding
  for (double distance : {1e-3, 1e-17, 1e-300}) {
    const Point near_edge(0.5, distance, distance);
    const Mesh mesh = generated::mesh_of(
        {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), near_edge},
        {{0, 2, 1}, {1, 2, 3}, {0, 3, 2}, {0, 4, 3}, {4, 1, 3}, {0, 1, 4}});
    BOOST_TEST(strongest_index(checked_field(mesh)) == 2);
  }
}

BOOST_AUTO_TEST_CASE(components_are_independent)
{
  const Mesh a = generated::noisy(generated::cube(5), 0.02, 5);
  const Mesh b = generated::torus(30, 15, 200, 80);
  auto expected = indices(checked_field(a));
  const auto rest = indices(checked_field(b));
  expected.insert(expected.end(), rest.begin(), rest.end());
  const QL::Cross_field both = checked_field(
      generated::disjoint_union(a, generated::translated(b, Vector(900, 0, 0))));
  BOOST_TEST(indices(both) == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(constraints_are_kept)
{
  Mesh mesh = generated::icosphere(3);
  Face_vectors constraints = vectors_on(mesh, CGAL::NULL_VECTOR);
  for (int f : {5, 300, 301, 900})
    constraints[Mesh::Face_index(f)] = Vector(1, 2, 3 + f);
  const QL::Cross_field field = QL::compute_cross_field(
      mesh, params::face_constraint_map(constraints).curvature_alignment(0));
  check_invariants(field);
  for (int f : {5, 300, 301, 900}) {
    const Eigen::Vector3d v(1, 2, 3 + f), n = field.surface().normal(f);
    BOOST_TEST(deviation(field, f, v - v.dot(n) * n) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(given_directions_are_kept)
{
  // by hand: the cube's own axes, which meet at the edges without any turn
  Mesh mesh = generated::cube(3);
  Face_vectors directions = vectors_on(mesh, Vector(1, 0, 0));
  for (auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const Vector n = CGAL::normal(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                                  mesh.point(target(next(h, mesh), mesh)));
    if (n.x() != 0)
      directions[f] = Vector(7, -5, 0);
  }
  const QL::Cross_field field = QL::compute_cross_field(mesh,
                                                        params::face_direction_map(directions));
  check_invariants(field);
  BOOST_TEST(field.number_of_singularities() == 8);
  for (auto f : faces(mesh)) {
    Eigen::Vector3d expected(directions[f].x(), directions[f].y(), 0);
    const Eigen::Vector3d n = field.surface().normal(int(f));
    expected -= expected.dot(n) * n;
    BOOST_TEST((field.direction(int(f), 0) - expected.normalized()).norm() < 1e-12);
  }

  // all faces constrained: the same directions
  const QL::Cross_field again = QL::compute_cross_field(mesh,
                                                        params::face_constraint_map(directions));
  BOOST_TEST(indices(again) == indices(field), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(random_directions)
{
  Mesh mesh = generated::noisy(generated::slab_with_holes(1, 4), 0.05, 9);
  Face_vectors directions = vectors_on(mesh, CGAL::NULL_VECTOR);
  std::mt19937 random(11);
  const auto coordinate = [&] { return int(random() % 1000) - 499.5; };
  for (auto f : faces(mesh)) {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    directions[f] = Vector(x, y, z);
  }
  check_invariants(QL::compute_cross_field(mesh, params::face_direction_map(directions)));
}

BOOST_AUTO_TEST_CASE(impossible_directions_are_refused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  Mesh mesh = generated::tetrahedron(); // face 0 is normal to the z-axis
  Face_vectors directions = vectors_on(mesh, Vector(1, 3, 9));
  const auto expect = [&](const auto& np, const Vector& v, const char* text) {
    directions[Mesh::Face_index(0)] = v;
    BOOST_CHECK_EXCEPTION(QL::compute_cross_field(mesh, np), QL::Invalid_parameter,
                          message_contains<QL::Invalid_parameter>(text));
  };
  const auto given = params::face_direction_map(directions);
  expect(given, CGAL::NULL_VECTOR, "face_direction_map: the vector of face 0 is zero");
  expect(given, Vector(0, 0, -2), "face_direction_map: the vector of face 0 is normal");
  expect(given, Vector(0, nan, 1), "face_direction_map: the vector of face 0 is not finite");
  const auto constrained = params::face_constraint_map(directions);
  expect(constrained, Vector(0, 0, 1e-200), "face_constraint_map: the vector of face 0 is normal");
  expect(constrained, Vector(infinity, 0, 1),
         "face_constraint_map: the vector of face 0 is not finite");
}

BOOST_AUTO_TEST_CASE(parameters_out_of_range_are_refused)
{
  const Mesh mesh = generated::tetrahedron();
  const auto expect = [&](const auto& np, const char* text) {
    BOOST_CHECK_EXCEPTION(QL::compute_cross_field(mesh, np), QL::Invalid_parameter,
                          message_contains<QL::Invalid_parameter>(text));
  };
  expect(params::curvature_alignment(-1), "curvature_alignment: -1");
  expect(params::diffusion_time(0), "diffusion_time: 0");
  expect(params::diffusion_time(std::numeric_limits<double>::infinity()), "diffusion_time: inf");
  expect(params::number_of_iterations(0), "number_of_iterations: 0");
}

BOOST_AUTO_TEST_CASE(visitor_can_stop)
{
  struct Visitor : QL::Default_visitor
  {
    int calls = 0;
    void progress(const char*, double) { ++calls; }
    bool go_on() { return calls < 3; }
  } visitor;
  const Mesh mesh = generated::icosphere(2);
  BOOST_CHECK_THROW(QL::compute_cross_field(mesh, params::visitor(std::ref(visitor))),
                    QL::Cancelled);
  BOOST_TEST(visitor.calls == 3);
}

BOOST_AUTO_TEST_CASE(corners_of_a_plate)
{
  const Mesh mesh = generated::plate_with_holes(3, 3, {{1, 1}}, 4);
  const QL::Cross_field field = QL::compute_cross_field(mesh);
  check_borders(field);
  // four convex corners outside, four concave ones around the hole
  std::map<int, int> count;
  for (int i : indices(field))
    ++count[i];
  BOOST_TEST(count[1] == 4);
  BOOST_TEST(count[-1] == 4);
  BOOST_TEST(field.number_of_singularities() == 8);
}

BOOST_AUTO_TEST_CASE(smooth_borders_have_no_corners)
{
  for (const Mesh& mesh : {generated::disc(12), generated::annulus(0.5, 1, 8, 48)}) {
    const QL::Cross_field field = QL::compute_cross_field(mesh);
    check_borders(field);
    const auto& surface = field.surface();
    for (int v = 0; v < surface.number_of_vertices(); ++v)
      if (surface.is_on_border(v))
        BOOST_TEST(field.index(v) == 0);
  }
}

BOOST_AUTO_TEST_CASE(single_triangle)
{
  const Mesh mesh = generated::mesh_of({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)},
                                       {{0, 1, 2}});
  const QL::Cross_field field = QL::compute_cross_field(mesh);
  check_borders(field);
  BOOST_TEST(field.surface().number_of_faces() == 9);
}

BOOST_AUTO_TEST_CASE(given_directions_are_aligned_to_the_border)
{
  Mesh mesh = generated::plate_with_holes(3, 3, {{1, 1}}, 4);
  Face_vectors directions = mesh.add_property_map<Mesh::Face_index, Vector>("f:v").first;
  for (const auto f : faces(mesh))
    directions[f] = Vector(1, 0.4, 0);
  check_borders(QL::compute_cross_field(mesh, params::face_direction_map(directions)));
  check_borders(QL::compute_cross_field(mesh, params::face_constraint_map(directions)));
}

BOOST_AUTO_TEST_CASE(polyhedron)
{
  const Mesh mesh = generated::noisy(generated::slab_with_holes(1, 3), 0.02, 2);
  CGAL::Polyhedron_3<generated::Kernel> polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  const QL::Cross_field field = QL::compute_cross_field(polyhedron);
  check_invariants(field);
  BOOST_TEST(indices_in_space(field) == indices_in_space(QL::compute_cross_field(mesh)));
}

BOOST_AUTO_TEST_CASE(real_meshes)
{
  for (const char* name : {"anchor_dense", "cow", "hand", "knot1", "retinal", "fandisk"}) {
    std::ifstream in(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
    Mesh mesh;
    if (!(in >> mesh) || !CGAL::is_triangle_mesh(mesh) || !CGAL::is_closed(mesh)) {
      BOOST_TEST_MESSAGE(name << " skipped");
      continue;
    }
    for (const auto method : {QL::DIFFUSION, QL::MIXED_INTEGER}) {
      const QL::Cross_field field = checked_field(mesh, method);
      BOOST_TEST_MESSAGE(name << ": " << field.number_of_singularities() << " singularities");
      BOOST_TEST(strongest_index(field) <= 1);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
