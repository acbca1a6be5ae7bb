// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Place_search.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Quad_untangler.h>
#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/smooth_quad_mesh.h>

#include "generated_quad_meshes.h"

#include <CGAL/Polyhedron_3.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_smooth_quad_mesh)

namespace QL = CGAL::Quad_layouts;
using generated::Mesh;
using generated::Point;
using generated::Vector;

namespace {

// a smooth function on space, to make bumps with
double bump(const Vector& x)
{
  return 1 + 0.2 * std::sin(3 * x.x() + 1) * std::cos(4 * x.y()) + 0.15 * std::sin(5 * x.z());
}

Mesh bumpy(Mesh mesh)
{
  for (const auto v : vertices(mesh)) {
    const Vector x = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + bump(x) * x;
  }
  return mesh;
}

// pulls three thin flat ears out of a sphere, each narrower than few quads of a coarse mesh
Mesh with_ears(Mesh mesh)
{
  for (const auto v : vertices(mesh)) {
    const Vector x = mesh.point(v) - CGAL::ORIGIN;
    double height = 0;
    for (const Vector& tip : {Vector(0.8, 0.6, 0), Vector(-0.6, 0, 0.8), Vector(0, -0.8, -0.6)}) {
      const Vector turned(tip.y(), tip.z(), tip.x()), across = turned - (turned * tip) * tip;
      const double distance = (x - tip) * across / std::sqrt(across * across);
      height += std::exp(-((x - tip) * (x - tip) + 15 * distance * distance) / 0.12);
    }
    mesh.point(v) = CGAL::ORIGIN + (1 + height) * x;
  }
  return mesh;
}

template <class NamedParametersQuads = QL::parameters::Default_named_parameters,
          class NamedParametersSurface = QL::parameters::Default_named_parameters>
QL::Quad_mesh_measures smoothed(
    Mesh& quads, const Mesh& surface,
    const NamedParametersQuads& np_quads = QL::parameters::default_values(),
    const NamedParametersSurface& np_surface = QL::parameters::default_values())
{
  QL::smooth_quad_mesh(quads, surface, np_quads, np_surface);
  const QL::Quad_mesh_measures result = QL::measure_quad_mesh(quads, surface);
  BOOST_TEST(result.inverted_quads == 0);
  BOOST_TEST(result.quads_against_surface == 0);
  return result;
}

double squared_distance(const Mesh& a, const Mesh& b)
{
  double result = 0;
  for (const auto v : vertices(a))
    result += CGAL::squared_distance(a.point(v), b.point(v));
  return result;
}

// a strip of `columns` polygons: quads, or pairs of triangles, between points of two lines
Mesh strip(const std::vector<Point>& bottom, const std::vector<Point>& top, bool of_triangles)
{
  std::vector<Point> points = bottom;
  points.insert(points.end(), top.begin(), top.end());
  std::vector<std::vector<int>> polygons;
  const int n = int(bottom.size());
  for (int i = 0; i + 1 < n; ++i)
    polygons.push_back({i, i + 1, n + i + 1, n + i});
  const Mesh result = generated::mesh_of_polygons(points, polygons);
  return of_triangles ? generated::triangulated(result) : result;
}

} // namespace

// The sides of a slit are in one place, but vertices stay on their own one.
BOOST_AUTO_TEST_CASE(sides_of_a_slit)
{
  constexpr int n = 8, tip = 3, row = 4;
  std::vector<Point> points;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      points.emplace_back(i + 0.3 * std::sin(i) * (i % n != 0), j, 0);
  for (int i = tip + 1; i <= n; ++i)
    points.push_back(points[row * (n + 1) + i]);
  const auto vertex = [&](int i, int j, bool above) {
    return j == row && i > tip && above ? (n + 1) * (n + 1) + i - tip - 1 : j * (n + 1) + i;
  };
  std::vector<std::vector<int>> squares;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      squares.push_back({vertex(i, j, j >= row), vertex(i + 1, j, j >= row),
                         vertex(i + 1, j + 1, j >= row), vertex(i, j + 1, j >= row)});
  Mesh quads = generated::mesh_of_polygons(points, squares);
  BOOST_TEST(smoothed(quads, generated::triangulated(quads)).msj_minimum > 0.9);
}

BOOST_AUTO_TEST_CASE(a_regular_cube_stays)
{
  const Mesh before = generated::quad_box({6, 6, 6});
  Mesh after = before;
  QL::smooth_quad_mesh(after, generated::triangulated(before),
                       CGAL::parameters::number_of_iterations(0));
  BOOST_TEST(squared_distance(before, after) < 1e-20);
}

BOOST_AUTO_TEST_CASE(noisy_sphere)
{
  const int n = 16;
  Mesh quads = generated::noisy(generated::quad_sphere(n), 0.4 / n, 7);
  BOOST_TEST(QL::measure_quad_mesh(quads).msj_average < 0.9);
  const QL::Quad_mesh_measures m = smoothed(quads, generated::icosphere(5));
  BOOST_TEST(m.msj_average > 0.99);
  BOOST_TEST(m.msj_minimum > 0.8); // 0.866 is all that a vertex of valence 3 allows
  BOOST_TEST(m.patches == 6);
  BOOST_TEST(m.maximum_distance_to_surface < 0.01);
}

BOOST_AUTO_TEST_CASE(noisy_torus)
{
  Mesh quads = generated::noisy(generated::quad_torus(48, 16), 0.1, 3);
  const Mesh surface = generated::triangulated(generated::quad_torus(96, 32));
  const QL::Quad_mesh_measures m = smoothed(quads, surface);
  BOOST_TEST(m.msj_average > 0.99);
  BOOST_TEST(m.msj_minimum > 0.95);
}

BOOST_AUTO_TEST_CASE(bumpy_sphere)
{
  Mesh quads = bumpy(generated::quad_sphere(20));
  const Mesh surface = bumpy(generated::icosphere(5));
  const QL::Quad_mesh_measures before = QL::measure_quad_mesh(quads, surface),
                               after = smoothed(quads, surface);
  BOOST_TEST(after.msj_average > 0.97);
  BOOST_TEST(after.msj_average > before.msj_average);
  BOOST_TEST(after.msj_minimum > before.msj_minimum);
  BOOST_TEST(after.maximum_distance_from_surface < 0.05);
}

// The sheets of the slab are nearer to each other than the vertices of one sheet.
BOOST_AUTO_TEST_CASE(sheets_of_a_thin_slab_stay_apart)
{
  const double thickness = 0.02;
  Mesh quads = generated::quad_box({20, 20, 1}, 1, 1, thickness);
  const Mesh surface = generated::triangulated(generated::quad_box({15, 15, 1}, 1, 1, thickness));
  std::mt19937 random(5);
  const auto noise = [&] { return 0.03 * (2. * random() / double(random.max()) - 1); };
  const auto is_inside = [](const Point& p) {
    return std::abs(p.x()) < 0.85 && std::abs(p.y()) < 0.85;
  };
  for (const auto v : vertices(quads)) {
    const Point& p = quads.point(v);
    if (is_inside(p))
      quads.point(v) = Point(p.x() + noise(), p.y() + noise(), p.z());
  }
  const Mesh before = quads;
  const QL::Quad_mesh_measures m = smoothed(quads, surface);
  BOOST_TEST(m.msj_average > 0.93);
  int changed_sides = 0;
  for (const auto v : vertices(quads))
    changed_sides += is_inside(before.point(v)) && before.point(v).z() * quads.point(v).z() < 0;
  BOOST_TEST(changed_sides == 0);
}

BOOST_AUTO_TEST_CASE(folds_are_untangled)
{
  const int n = 16;
  Mesh quads = generated::noisy(generated::quad_sphere(n), 0.12, 11);
  BOOST_TEST(QL::measure_quad_mesh(quads).inverted_quads > 0);
  const QL::Quad_mesh_measures m = smoothed(quads, generated::icosphere(4));
  BOOST_TEST(m.msj_average > 0.98);
}

// Quads around the ears are not small compared to them, so normals of the surface at their corners
// say little.
BOOST_AUTO_TEST_CASE(folds_at_thin_ears_are_untangled)
{
  Mesh quads = with_ears(generated::noisy(generated::quad_sphere(12), 0.3, 3));
  const Mesh surface = with_ears(generated::icosphere(5));
  BOOST_TEST(QL::measure_quad_mesh(quads, surface).inverted_quads > 400);
  const QL::Quad_mesh_measures m = smoothed(quads, surface);
  BOOST_TEST(m.msj_average > 0.94);
  BOOST_TEST(m.msj_minimum > 0.2);
}

// A sheet with its normals down lies above one with its normals up. No way on the surface leads
// back from the one to the other.
BOOST_AUTO_TEST_CASE(begins_anew_where_vertices_are_trapped)
{
  using namespace QL::internal;
  constexpr int n = 12;
  std::vector<Point> points;
  std::vector<std::vector<int>> polygons;
  for (const double height : {0., 1.}) {
    const int first = int(points.size());
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        points.emplace_back(height == 0 ? i : n - i, j, height);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int v = first + j * (n + 1) + i;
        polygons.push_back({v, v + 1, v + n + 2, v + n + 1});
      }
  }
  const Mesh sheets = generated::triangulated(generated::mesh_of_polygons(points, polygons));
  points.resize(points.size() / 2);
  polygons.resize(polygons.size() / 2);
  const Mesh lower = generated::mesh_of_polygons(points, polygons);

  const Triangle_surface surface = surface_with_fixed_edges(sheets,
                                                            QL::parameters::default_values());
  const Surface_walk walk(surface);
  Polygons mesh = make_polygons(lower, lower.points());
  Quads_on_surface quads(mesh, walk);
  const std::vector<Surface_walk::Place> first = quads.places(quads.movable());
  BOOST_TEST(quads.bad_quads().empty());
  for (const int v : quads.surroundings({n * n / 2 + n / 2}, 1))
    quads.move(v, walk.locate(mesh.points[v] + Eigen::Vector3d(0, 0, 1), {0, 0, -1}));
  BOOST_TEST(!quads.bad_quads().empty());
  const Monitor monitor;
  Quad_untangler(quads, monitor).repair_from(first);
  BOOST_TEST(quads.bad_quads().empty());
  for (const auto& p : mesh.points)
    BOOST_TEST(p.z() == 0);
}

// those of the distortion around a vertex, by differences
BOOST_AUTO_TEST_CASE(derivatives_of_distortion)
{
  using namespace QL::internal;
  using Point3 = Eigen::Vector3d;
  const double unit = 0.8, h = 1e-5;
  std::mt19937 random(7);
  const auto perturbed = [&](double x, double y, double z) {
    std::uniform_real_distribution<double> shift(-0.4, 0.4);
    return Point3(x + shift(random), y + shift(random), z + shift(random));
  };
  for (const double epsilon : {1e-2, 1.})
    for (int i = 0; i < 20; ++i) {
      const Regularized_distortion measure(epsilon, 1);
      Quad_on_surface q;
      q.quad = {perturbed(0, 0, 0), perturbed(1, 0, 0), perturbed(1, 1, 0), perturbed(0, 1, 0)};
      for (auto& normal : q.normals)
        normal = perturbed(0, 0, 1).normalized();
      Star star;
      Point3 gradient;
      Eigen::Matrix3d hessian;
      const auto derive_after = [&](const Point3& step) {
        Quad_on_surface moved = q;
        moved.quad[0] += step;
        star.clear();
        star.add(moved);
        star.derive_distortion(measure, unit, gradient, hessian);
        return gradient;
      };
      Eigen::Matrix3d columns;
      for (int k = 0; k < 3; ++k) {
        const Point3 step = h * Point3::Unit(k);
        columns.col(k) = (derive_after(step) - derive_after(-step)) / (2 * h);
      }
      derive_after(Point3::Zero());
      BOOST_TEST((hessian - columns).norm() < 1e-4 * (1 + hessian.norm()));
      for (int k = 0; k < 3; ++k) {
        const Point3 step = h * Point3::Unit(k);
        const double slope = (star.distortion(q.quad[0] + step, measure, unit) -
                              star.distortion(q.quad[0] - step, measure, unit)) /
                             (2 * h);
        BOOST_TEST(std::abs(gradient[k] - slope) < 1e-5 * (1 + gradient.norm() + hessian.norm()));
      }
    }
}

// The surface has a notch close to a vertex of the border, which quads reach across: the straight
// way from the middle of the quads to the vertex ends at the notch.
BOOST_AUTO_TEST_CASE(border_vertices_begin_where_they_are)
{
  using namespace QL::internal;
  const auto strip_of_columns = [](const std::vector<std::array<double, 2>>& columns) {
    std::vector<Point> points;
    std::vector<std::vector<int>> squares;
    for (const auto& [x, height] : columns)
      for (const double y : {0., height / 2, height})
        points.emplace_back(x, y, 0);
    for (int i = 0; i + 3 < int(points.size()); i += 3)
      for (const int k : {i, i + 1})
        squares.push_back({k, k + 3, k + 4, k + 1});
    return generated::mesh_of_polygons(points, squares);
  };
  const Mesh surface = generated::triangulated(
      strip_of_columns({{0, 4}, {2, 4}, {2.1, 4}, {2.2, 2}, {2.3, 4}, {10, 4}}));
  const Mesh quads = strip_of_columns({{0, 4}, {2, 4}, {10, 4}});
  const Triangle_surface triangles = make_triangle_surface(surface, surface.points());
  const Surface_walk walk(triangles);
  const Polygons before = make_polygons(quads, quads.points());
  Polygons placed = before;
  const Quads_on_surface on_surface(placed, walk);
  for (int v = 0; v < placed.number_of_vertices(); ++v)
    BOOST_TEST((on_surface.place(v).point - before.points[v]).norm() < 1e-12);
}

// Two corners of the border with more than 180 degrees have one quad each, which nothing can mend,
// near to each other. The search for better places must end all the same.
BOOST_AUTO_TEST_CASE(search_ends_where_nothing_helps)
{
  constexpr int width = 5, height = 3;
  const auto vertex = [&](int x, int y) { return y * (width + 1) + x; };
  std::vector<Point> points;
  std::vector<std::vector<int>> squares;
  for (int y = 0; y <= height; ++y)
    for (int x = 0; x <= width; ++x)
      points.emplace_back(x, y, 0);
  points[vertex(0, 0)] = {0.8, 0.8, 0};
  points[vertex(width, 0)] = {width - 0.8, 0.8, 0};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      squares.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
  Mesh mesh = generated::mesh_of_polygons(points, squares);
  const Mesh surface = generated::triangulated(mesh);

  struct Impatient : QL::Default_visitor
  {
    int questions_left = 20000;
    bool go_on() { return --questions_left > 0; }
  };
  Impatient visitor;
  BOOST_CHECK_NO_THROW(
      QL::smooth_quad_mesh(mesh, surface, QL::parameters::visitor(std::ref(visitor))));
  BOOST_TEST(QL::measure_quad_mesh(mesh).inverted_quads == 2);
}

// A vertex is off its place by one and a half times the width of the slim quads there, far less
// than the mean length of its edges.
BOOST_AUTO_TEST_CASE(steps_fit_slim_quads)
{
  using namespace QL::internal;
  constexpr int width = 2, height = 4;
  constexpr double slimness = 1e-3;
  const auto vertex = [&](int x, int y) { return y * (width + 1) + x; };
  std::vector<Point> points;
  std::vector<std::vector<int>> squares;
  for (int y = 0; y <= height; ++y)
    for (int x = 0; x <= width; ++x)
      points.emplace_back(x, slimness * y, 0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      squares.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
  Mesh mesh = generated::mesh_of_polygons(points, squares);
  const Mesh surface = generated::triangulated(mesh);
  mesh.point(Mesh::Vertex_index(vertex(1, 1))) = Point(1, 2.5 * slimness, 0);

  const Triangle_surface triangles = make_triangle_surface(surface, surface.points());
  const Surface_walk walk(triangles);
  Polygons polygons = make_polygons(mesh, mesh.points());
  Quads_on_surface quads(polygons, walk);
  BOOST_TEST(quads.bad_quads().size() == 2u);
  Place_search(quads).improve({vertex(1, 1)});
  BOOST_TEST(quads.bad_quads().empty());
}

// Two sheets of a surface, which are bent along a diagonal, meet in a fold of nearly 360 degrees. A
// quad that reaches across the bend is nearer to the other sheet than to its own.
BOOST_AUTO_TEST_CASE(quads_are_thin_between_sheets)
{
  const auto mark_fold = [](Mesh& mesh) {
    const auto on_fold = mesh.add_property_map<Mesh::Edge_index, bool>("e:on_fold", false).first;
    for (const auto e : edges(mesh))
      on_fold[e] = mesh.point(mesh.vertex(e, 0)).x() == 0 && mesh.point(mesh.vertex(e, 1)).x() == 0;
    return on_fold;
  };
  for (const int n : {2, 3})
    for (const double bend : {0.2, 0.6})
      for (const double fold : {0.02, 0.05}) {
        const auto on_sheet = [&](int x, int y) {
          const double height = bend * (std::min)(std::abs(x), y) + fold * (std::min)(x, 0);
          return Point(std::abs(x), y, height);
        };
        const auto vertex = [&](int x, int y) { return y * (2 * n + 1) + x + n; };
        std::vector<Point> points;
        std::vector<std::vector<int>> squares;
        for (int y = 0; y <= n; ++y)
          for (int x = -n; x <= n; ++x)
            points.push_back(on_sheet(x, y));
        for (int y = 0; y < n; ++y)
          for (int x = -n; x < n; ++x)
            squares.push_back(
                {vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
        Mesh quads = generated::mesh_of_polygons(points, squares);
        Mesh surface = generated::mesh_of_polygons({on_sheet(0, 0), on_sheet(n, 0), on_sheet(n, n),
                                                    on_sheet(0, n), on_sheet(-n, n),
                                                    on_sheet(-n, 0)},
                                                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
        smoothed(quads, surface, QL::parameters::edge_is_constrained_map(mark_fold(quads)),
                 QL::parameters::edge_is_constrained_map(mark_fold(surface)));
      }
}

BOOST_AUTO_TEST_CASE(borders_stay)
{
  const Mesh before = generated::quad_torus(24, 12, false);
  Mesh after = generated::noisy(before, 0.05, 1);
  for (const auto v : vertices(before))
    if (before.is_border(v))
      after.point(v) = before.point(v);
  const Mesh surface = generated::triangulated(generated::quad_torus(48, 24));
  QL::smooth_quad_mesh(after, surface);
  for (const auto v : vertices(before))
    if (before.is_border(v))
      BOOST_TEST(after.point(v) == before.point(v));
}

// Uneven vertices on the border of a square spread over its sides, and do not leave them.
BOOST_AUTO_TEST_CASE(border_vertices_slide_along_the_border)
{
  const int n = 8;
  Mesh quads;
  std::vector<Mesh::Vertex_index> vertex;
  const auto uneven = [&](int i) { return std::pow(i / double(n), 1.5); };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      vertex.push_back(quads.add_vertex(generated::Point(uneven(i), uneven(j), 0)));
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int v = j * (n + 1) + i;
      quads.add_face(vertex[v], vertex[v + 1], vertex[v + n + 2], vertex[v + n + 1]);
    }
  QL::smooth_quad_mesh(quads, generated::plate({{0, 0}}, 5));
  for (int i = 0; i <= n; ++i) {
    BOOST_TEST(std::abs(quads.point(vertex[i]).x() - i / double(n)) < 0.02);
    BOOST_TEST(quads.point(vertex[i]).y() == 0);
    BOOST_TEST(quads.point(vertex[i * (n + 1) + n]).x() == 1);
  }
}

// All bends of the border are at one end, where few of the evenly spread vertices are; there are
// just enough of them, which have to come from far away.
BOOST_AUTO_TEST_CASE(edges_follow_the_bends_of_a_border)
{
  const std::vector<double> x = {0, 0.5, 1, 1.5, 2, 8}, y = {0, 0.3, 0, 0.3, 0, 0};
  std::vector<Point> bottom, top, quad_bottom, quad_top;
  for (std::size_t i = 0; i < x.size(); ++i) {
    bottom.emplace_back(x[i], y[i], 0);
    top.emplace_back(x[i], 2, 0);
    const double even = 8. * double(i) / double(x.size() - 1);
    quad_bottom.emplace_back(even, even == 1.6 ? 0.24 : 0, 0);
    quad_top.emplace_back(even, 2, 0);
  }
  Mesh quads = strip(quad_bottom, quad_top, false);
  QL::smooth_quad_mesh(quads, strip(bottom, top, true));
  for (const Point& p : bottom) {
    double least = 8;
    for (const auto e : edges(quads))
      least = (std::min)(least,
                         std::sqrt(CGAL::squared_distance(
                             p, generated::Kernel::Segment_3(quads.point(quads.vertex(e, 0)),
                                                             quads.point(quads.vertex(e, 1))))));
    BOOST_TEST(least < 1e-3 * std::sqrt(68.));
  }
}

// A vertex on a curve may go nearly to its neighbours, but neither to them nor beyond.
BOOST_AUTO_TEST_CASE(vertices_keep_their_order_along_curves)
{
  using namespace QL::internal;
  std::vector<Point> bottom, top;
  for (int i = 0; i < 5; ++i) {
    bottom.emplace_back(i, 0, 0);
    top.emplace_back(i, 1, 0);
  }
  const Mesh surface = strip(bottom, top, true), quads = strip(bottom, top, false);
  const Triangle_surface triangles = make_triangle_surface(surface, surface.points());
  const Surface_walk walk(triangles);
  Polygons mesh = make_polygons(quads, quads.points());
  const Quads_on_surface on_surface(mesh, walk);
  const auto may_go = [&](double x) {
    return on_surface.is_permitted(2, on_surface.reached(2, {x, 0, 0}));
  };
  BOOST_TEST(may_go(1.01));
  BOOST_TEST(may_go(2.99));
  for (const double x : {-0.1, 0.5, 1., 3., 3.5, 4.1})
    BOOST_TEST(!may_go(x));
}

// Where the sharp edges of a cube are fixed, a vertex that follows a point beyond an edge stays at
// the edge, and the normal there is that of its side; where they are not, it goes around.
BOOST_AUTO_TEST_CASE(vertices_stay_on_their_side_of_fixed_edges)
{
  using namespace QL::internal;
  const Mesh cube = generated::cube(4);
  const Triangle_surface free = make_triangle_surface(cube, cube.points());
  Triangle_surface fixed = free;
  for (int h = 0; h < free.number_of_halfedges(); ++h)
    if (free.normal(free.face(h)).dot(free.normal(free.face(free.opposite(h)))) < 0.5)
      fixed.fix(h);
  const Surface_walk::Vector up(0, 0, 1);
  const auto reached = [&](const Surface_walk& walk) {
    const Surface_walk::Place start = walk.locate({0.6, 0.55, 1}, up);
    return walk.slide(start, {2, 0.55, 0.4});
  };
  const Surface_walk free_walk(free), walk(fixed);
  BOOST_TEST(reached(free_walk).point.z() < 0.9);
  BOOST_TEST(reached(walk).point.z() == 1);
  BOOST_TEST(reached(walk).point.x() == 1);
  BOOST_TEST(walk.normal(reached(walk)).dot(up) > 0.999);
  BOOST_TEST(free_walk.normal(reached(walk)).dot(up) < 0.999);
}

// A wall stands on an edge of the ground, but is not connected with it, and leans over it a little.
// Of what is nearest beyond that edge, the wall opposes what lies on the ground; beyond the corner
// it is the same.
BOOST_AUTO_TEST_CASE(faces_that_only_touch_are_equally_near)
{
  using namespace QL::internal;
  const Point a(0, 0, 0), b(1, 0, 0);
  Mesh surface = strip({a, b}, {{0, 1, 0}, {1, 1, 0}}, true);
  CGAL::copy_face_graph(strip({{0, 0.01, 1}, {1, 0.01, 1}}, {a, b}, true), surface);
  const Triangle_surface triangles = make_triangle_surface(surface, surface.points());
  const Surface_walk walk(triangles);
  const Surface_walk::Vector up(0, 0, 1);
  const int ground = walk.locate({0.5, 0.5, 0}, up).face;
  BOOST_TEST(walk.nearest_normal({0.5, 0.5, 0}, up, ground) == up);
  for (const double x : {-0.1, 0.5, 1.1})
    BOOST_TEST(walk.nearest_normal({x, -0.1, 0}, up, ground).dot(up) < 0);
}

// Half way between the two sides of a plate both are equally near.
BOOST_AUTO_TEST_CASE(sides_of_a_plate_are_equally_near_in_its_middle)
{
  using namespace QL::internal;
  Mesh plate = strip({{0, 0, 0.1}, {1, 0, 0.1}}, {{0, 1, 0.1}, {1, 1, 0.1}}, true);
  CGAL::copy_face_graph(strip({{0, 1, -0.1}, {1, 1, -0.1}}, {{0, 0, -0.1}, {1, 0, -0.1}}, true),
                        plate);
  const Triangle_surface triangles = make_triangle_surface(plate, plate.points());
  const Surface_walk walk(triangles);
  for (const double z : {-1., 1.}) {
    const Surface_walk::Vector along(0.9, 0, z * 0.1);
    for (int face = 0; face < triangles.number_of_faces(); ++face) {
      BOOST_TEST(walk.nearest_normal({0.4, 0.3, 0}, along, face).z() == -z);
      BOOST_TEST(walk.nearest_normal({0.4, 0.3, z * 1e-6}, along, face).z() == z);
    }
  }
}

// None of the corners of a quad can move, so it remains upside down.
BOOST_AUTO_TEST_CASE(bad_quads_are_counted)
{
  const std::vector<Point> bottom = {{0, 0, 0}, {1, 0, 0}}, top = {{0, 1, 0}, {1, 1, 0}};
  const Mesh surface = strip(bottom, top, true);
  Mesh good = strip(bottom, top, false), bad = strip(top, bottom, false);
  BOOST_TEST(QL::smooth_quad_mesh(good, surface) == 0u);
  BOOST_TEST(QL::smooth_quad_mesh(bad, surface) == 1u);
}

BOOST_AUTO_TEST_CASE(same_result_again_and_on_other_meshes)
{
  const Mesh surface = bumpy(generated::icosphere(3)), quads = bumpy(generated::quad_sphere(8));
  Mesh first = quads, second = quads;
  QL::smooth_quad_mesh(first, surface);
  QL::smooth_quad_mesh(second, surface);
  BOOST_TEST(squared_distance(first, second) == 0.);

  CGAL::Polyhedron_3<generated::Kernel> polyhedron, polyhedral_surface;
  CGAL::copy_face_graph(quads, polyhedron);
  CGAL::copy_face_graph(surface, polyhedral_surface);
  QL::smooth_quad_mesh(polyhedron, polyhedral_surface);
  BOOST_TEST(QL::measure_quad_mesh(polyhedron).msj_average ==
                 QL::measure_quad_mesh(first).msj_average,
             boost::test_tools::tolerance(1e-2));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_smoothed)
{
  Mesh quads = generated::quad_sphere(4);
  const Mesh surface = generated::icosphere(2), before = quads;
  BOOST_CHECK_THROW(
      QL::smooth_quad_mesh(quads, surface, CGAL::parameters::number_of_iterations(-1)),
      QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::smooth_quad_mesh(quads, Mesh()), QL::Empty_mesh);
  Mesh triangles = surface;
  BOOST_CHECK_THROW(QL::smooth_quad_mesh(triangles, surface), QL::Stage_failure);

  struct Impatient : QL::Default_visitor
  {
    bool go_on() { return false; }
  };
  BOOST_CHECK_THROW(QL::smooth_quad_mesh(quads, surface, QL::parameters::visitor(Impatient())),
                    QL::Cancelled);
  BOOST_CHECK_THROW(QL::smooth_quad_mesh(quads, surface, QL::parameters::default_values(),
                                         QL::parameters::visitor(Impatient())),
                    QL::Cancelled);
  BOOST_TEST(squared_distance(quads, before) == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
