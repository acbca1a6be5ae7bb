// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "checked_derivatives.h"
#include "generated_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/embed_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/internal/embedding/coarse_to_fine.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_embed_quad_layout)

namespace QL = CGAL::Quad_layouts;
using QL::Integer_grid_map;
using QL::Quad_layout;

namespace {

// a surface and all that is computed on the way to its map
struct Embedded
{
  QL::Cross_field field;
  QL::T_mesh t_mesh;
  Quad_layout layout;
  Integer_grid_map map;

  Embedded(const generated::Mesh& mesh, double displacement, double edge_length_fraction)
    : field(QL::compute_cross_field(mesh))
  {
    const double h = edge_length_fraction * field.surface().diagonal();
    const auto np = QL::parameters::maximum_displacement(displacement).target_edge_length(h);
    t_mesh = QL::trace_motorcycle_graph(field, np);
    layout = QL::extract_quad_layout(t_mesh, QL::quantize(t_mesh, np));
    map = QL::embed_quad_layout(t_mesh, layout, np);
  }
};

double orientation(const Integer_grid_map& map, int f)
{
  const Eigen::Vector2d a = map.coordinates(3 * f + 1) - map.coordinates(3 * f);
  const Eigen::Vector2d b = map.coordinates(3 * f + 2) - map.coordinates(3 * f);
  return a.x() * b.y() - a.y() * b.x();
}

// the sum of the angles around each vertex, in quarter-turns
std::vector<double> angle_sums(const Integer_grid_map& map)
{
  std::vector<double> sum(map.surface().number_of_vertices(), 0);
  for (int h = 0; h < map.surface().number_of_halfedges(); ++h) {
    const Eigen::Vector2d a = map.coordinates(Integer_grid_map::Surface::next(h)) -
                              map.coordinates(h);
    const Eigen::Vector2d b = map.coordinates(Integer_grid_map::Surface::prev(h)) -
                              map.coordinates(h);
    sum[map.surface().source(h)] += std::acos(a.dot(b) / (a.norm() * b.norm())) / std::acos(0.);
  }
  return sum;
}

void check_transitions(const Integer_grid_map& map)
{
  using Surface = Integer_grid_map::Surface;
  int wrong = 0;
  for (int h = 0; h < map.surface().number_of_halfedges(); ++h) {
    const int twin = map.surface().opposite(h);
    const auto& t = map.transition(h);
    wrong += t(map.coordinates(h)) != map.coordinates(Surface::next(twin));
    wrong += t(map.coordinates(Surface::next(h))) != map.coordinates(twin);
    wrong += t.translation != Eigen::Vector2d(t.translation.array().round());
  }
  BOOST_TEST(wrong == 0);
}

// checks that the map is locally injective but for the irregular vertices of the layout
void check_map(const Embedded& e)
{
  BOOST_TEST(e.map.inverted == 0);
  BOOST_TEST(e.map.wrong_winding == 0);
  check_transitions(e.map);
  int inverted = 0;
  for (int f = 0; f < e.map.surface().number_of_faces(); ++f)
    inverted += !(orientation(e.map, f) > 0);
  BOOST_TEST(inverted == 0);

  std::map<int, int> valence; // of the anchored vertices
  for (const Integer_grid_map::Anchor& a : e.map.anchors)
    valence[e.map.surface().source(a.corner)] = e.layout.valence(
        e.layout.source(a.layout_halfedge));
  int irregular = 0, wrong = 0;
  for (const auto& entry : valence)
    irregular += entry.second != 4;
  BOOST_TEST(irregular == e.layout.number_of_irregular_vertices());
  const std::vector<double> sums = angle_sums(e.map);
  for (int v = 0; v < e.map.surface().number_of_vertices(); ++v)
    wrong += std::abs(sums[v] - (valence.count(v) ? valence[v] : 4)) > 1e-4;
  BOOST_TEST(wrong == 0);
}

// the identity of a regular hexagon, whose centre is vertex 0
QL::internal::Map map_of_hexagon()
{
  using QL::internal::Map;
  Map map;
  map.points.emplace_back(0, 0, 0);
  for (int k = 0; k < 6; ++k) {
    map.points.emplace_back(std::cos(k * CGAL_PI / 3), std::sin(k * CGAL_PI / 3), 0);
    map.faces.push_back(
        {{0, k + 1, (k + 1) % 6 + 1}, {}, {-1, -1, -1}, {Map::PLAIN, Map::PLAIN, Map::PLAIN}});
  }
  for (const auto& p : map.points)
    map.coordinates.push_back(p.head<2>());
  map.freedom.assign(map.points.size(), Map::FREE);
  return map;
}

// fixes up to `number` edges of a mesh inside of it, between which there are others
auto scattered_edges(generated::Mesh& mesh, int number, unsigned seed)
{
  using Mesh = generated::Mesh;
  const auto result = mesh.add_property_map<Mesh::Edge_index, bool>("e:fixed", false).first;
  std::minstd_rand random(seed);
  std::vector<char> is_taken(mesh.number_of_vertices(), 0); // or has a neighbour that is
  for (const auto v : mesh.vertices())
    is_taken[v] = mesh.is_border(v);
  for (int i = 0; i < number; ++i) {
    const auto h = mesh.halfedge(
        Mesh::Edge_index(Mesh::size_type(random()) % mesh.number_of_edges()));
    if (is_taken[mesh.source(h)] || is_taken[mesh.target(h)])
      continue;
    result[mesh.edge(h)] = true;
    for (const auto end : {h, mesh.opposite(h)})
      for (const auto v : vertices_around_target(end, mesh))
        is_taken[v] = 1;
  }
  return result;
}

// the angles on the surface between the lines of the map that begin at a vertex, in radians
std::vector<double> angles_between_lines(const Integer_grid_map& map, int v)
{
  using Surface = Integer_grid_map::Surface;
  const Surface& surface = map.surface();
  const auto angle_between = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
  };
  std::vector<double> lines;
  double sum = 0;
  surface.for_each_outgoing(v, [&](int h) {
    const int last = Surface::prev(h);
    const Eigen::Vector3d p = surface.vector(h), q = -surface.vector(last);
    Eigen::Matrix2d sides;
    sides << map.coordinates(Surface::next(h)) - map.coordinates(h),
        map.coordinates(last) - map.coordinates(h);
    for (const int sign : {1, -1})
      for (const Eigen::Vector2d& axis : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)})
        if (const Eigen::Vector2d w = sides.inverse() * (sign * axis); w[0] > 0 && w[1] >= 0)
          lines.push_back(sum + angle_between(p, w[0] * p + w[1] * q));
    sum += angle_between(p, q);
  });
  std::sort(lines.begin(), lines.end());
  std::vector<double> result;
  for (std::size_t i = 1; i < lines.size(); ++i)
    result.push_back(lines[i] - lines[i - 1]);
  result.push_back(lines.front() + sum - lines.back());
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(cube_has_its_corners)
{
  const Embedded e(generated::cube(6), 0, 0.05);
  check_map(e);
  BOOST_TEST(e.layout.number_of_patches == 6);
  BOOST_TEST(e.map.chord_length.size() == 3u);
}

BOOST_AUTO_TEST_CASE(torus_is_held_at_its_seed)
{
  const Embedded e(generated::torus(30, 20), 2, 0.02);
  check_map(e);
  BOOST_TEST(e.map.anchors.size() == 4u);
}

BOOST_AUTO_TEST_CASE(merged_singularities_are_gathered)
{
  int merged = 0;
  for (const double displacement : {0., 2., 4.}) {
    const Embedded e(generated::noisy(generated::icosphere(3), 0.05, 7), displacement, 0.04);
    check_map(e);
    for (const Quad_layout::Cluster& c : e.layout.clusters)
      merged += c.nodes.size() > 1;
  }
  BOOST_TEST(merged > 0);
}

// Lines that go around the end of a feature must not do so in the narrow triangles that curves of the
// layout have cut: edges of quads, which are straight, would cross the feature.
BOOST_AUTO_TEST_CASE(lines_have_room_at_ends_of_features)
{
  constexpr double sufficient = 10 * CGAL_PI / 180;
  int number_of_ends = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    generated::Mesh mesh = generated::noisy(generated::plate_with_holes(12, 12, {}, 1), 0.2, seed);
    const auto is_fixed = scattered_edges(mesh, 40, seed);
    const auto np = QL::parameters::target_edge_length(1.).maximum_deviation(25.);
    const QL::Cross_field field = QL::compute_cross_field(mesh,
                                                          np.edge_is_constrained_map(is_fixed));
    const QL::T_mesh t_mesh = QL::trace_motorcycle_graph(field, np);
    const Quad_layout layout = QL::extract_quad_layout(t_mesh, QL::quantize(t_mesh, np));
    const Integer_grid_map map = QL::embed_quad_layout(t_mesh, layout, np);
    for (int v = 0; v < map.surface().number_of_vertices(); ++v) {
      int degree = 0;
      map.surface().for_each_outgoing(v, [&](int h) { degree += map.surface().is_fixed(h); });
      if (degree != 1 || map.surface().is_on_border(v))
        continue;
      ++number_of_ends;
      const std::vector<double> angles = angles_between_lines(map, v);
      BOOST_TEST(*std::min_element(angles.begin(), angles.end()) > sufficient);
    }
  }
  BOOST_TEST(number_of_ends > 50);
}

BOOST_AUTO_TEST_CASE(components_have_maps_of_their_own)
{
  const auto mesh = generated::disjoint_union(
      generated::slab_with_holes(2, 4),
      generated::translated(generated::torus(24, 16), {20, 0, 0}));
  check_map(Embedded(mesh, 2, 0.01));
}

BOOST_AUTO_TEST_CASE(same_input_same_map)
{
  const auto mesh = generated::slab_with_holes(1, 4);
  const Embedded a(mesh, 1, 0.03), b(mesh, 1, 0.03);
  BOOST_TEST((a.map.corner_coordinates == b.map.corner_coordinates));
}

BOOST_AUTO_TEST_CASE(derivatives_of_the_distortion_and_its_square)
{
  for (const Eigen::Vector4d& v :
       {Eigen::Vector4d(1, 0.2, -0.3, 0.8), Eigen::Vector4d(0.3, 3, -2, 1)}) {
    check_derivatives(QL::internal::Distortion(), v);
    check_derivatives(QL::internal::Squared_distortion(), v);
  }
}

// One step would make their distance from the border only half as large again.
BOOST_AUTO_TEST_CASE(vertices_leave_the_border_of_their_polygons)
{
  const auto check = [](auto measure, double distance) {
    QL::internal::Map map = map_of_hexagon();
    const double border = std::sqrt(0.75);
    map.coordinates[0].y() = border - distance;
    const std::vector<char> is_cone(map.points.size(), 0);
    const QL::internal::Vertex_removal levels(map, {}, is_cone);
    QL::internal::improve_vertex<decltype(measure)>(map, levels, 0, 1);
    BOOST_TEST(map.coordinates[0].y() < border - 0.02);
  };
  for (const double distance : {1e-3, 1e-6, 1e-9}) {
    check(QL::internal::Distortion(), distance);
    check(QL::internal::Squared_distortion(), distance);
  }
}

// Measured as wide, two needles would want to be larger than all other triangles together.
BOOST_AUTO_TEST_CASE(needles_leave_room)
{
  QL::internal::Map map = map_of_hexagon();
  map.points[1] *= 1000;
  const std::vector<char> is_cone(map.points.size(), 0);
  const QL::internal::Vertex_removal levels(map, {}, is_cone);
  const QL::internal::Likeness alike{1, 0.5};
  QL::internal::improve_vertex<QL::internal::Distortion>(map, levels, 0, 100, alike);
  BOOST_TEST(map.coordinates[0].norm() < 0.2);
}

BOOST_AUTO_TEST_CASE(bad_parameters_are_refused)
{
  const Embedded e(generated::cube(4), 0, 0.1);
  for (const double h : {0., -1., std::nan("")})
    BOOST_CHECK_THROW(
        QL::embed_quad_layout(e.t_mesh, e.layout, QL::parameters::target_edge_length(h)),
        QL::Invalid_parameter);
}

BOOST_AUTO_TEST_SUITE_END()
