// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "hand_made_t_meshes.h"
#include "synthetic_maps.h"

#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_mesh.h>
#include <CGAL/Quad_layouts/measure_quad_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_extract_quad_mesh)

namespace QL = CGAL::Quad_layouts;
using QL::Integer_grid_map;
using QL::Quad_layout;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Arcs = std::vector<int>;

namespace {

Quad_layout layout_of(const QL::T_mesh& t, Arcs lengths)
{
  QL::Quantization quantization;
  quantization.arc_length = std::move(lengths);
  return QL::extract_quad_layout(t, quantization);
}

Quad_layout cube()
{
  return layout_of(hand_made::cube(), Arcs(12, 1));
}
Quad_layout box()
{
  return layout_of(hand_made::cube(), {3, 3, 3, 3, 2, 2, 2, 2, 1, 1, 1, 1});
}
Quad_layout pillow()
{
  return layout_of(hand_made::cube(), {0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1});
}
Quad_layout torus(int m, int n)
{
  return layout_of(hand_made::torus(m, n), Arcs(2 * m * n, 1));
}

Arcs lengths_for(const Quad_layout& layout)
{
  Arcs result;
  for (int c = 0; c < layout.number_of_chords; ++c)
    result.push_back(2 + c % 3);
  return result;
}

void check_mesh(const Quad_layout& layout, const Mesh& mesh)
{
  BOOST_TEST(CGAL::is_valid_polygon_mesh(mesh));
  BOOST_TEST(CGAL::is_closed(mesh));
  const QL::Quad_mesh_measures measures = QL::measure_quad_mesh(mesh);
  BOOST_TEST(measures.non_quads == 0);
  BOOST_TEST(measures.euler_characteristic == layout.euler_characteristic());
  BOOST_TEST(measures.irregular_vertices == layout.number_of_irregular_vertices());
  BOOST_TEST(measures.patches == layout.number_of_patches);
}

} // namespace

BOOST_AUTO_TEST_CASE(torus_of_one_face)
{
  const Quad_layout layout = torus(1, 1);
  Mesh mesh;
  QL::extract_quad_mesh(synthetic::make_map(layout, {3, 4}), layout, mesh);
  BOOST_TEST(num_faces(mesh) == 12u);
  BOOST_TEST(num_vertices(mesh) == 12u);
  check_mesh(layout, mesh);
}

// 1 x 1 squares on a torus: the mesh needs three parts in each direction
BOOST_AUTO_TEST_CASE(divisions_are_raised_until_the_mesh_is_simple)
{
  const Quad_layout layout = torus(1, 1);
  Mesh mesh;
  QL::extract_quad_mesh(synthetic::make_map(layout, {1, 1}), layout, mesh);
  BOOST_TEST(num_faces(mesh) == 9u);
  check_mesh(layout, mesh);
  // all edges of this layout are loops
  BOOST_TEST(QL::internal::chord_divisions(layout, 1e9) == Arcs({6, 6}),
             boost::test_tools::per_element());
  BOOST_TEST(QL::internal::chord_divisions(cube(), 1e9) == Arcs({1, 1, 1}),
             boost::test_tools::per_element());
}

// on an unmoved map of a cube, the vertices are those of a regular grid
BOOST_AUTO_TEST_CASE(points_of_a_cube)
{
  const Quad_layout layout = cube();
  synthetic::Options options;
  options.jitter = 0;
  Mesh mesh;
  QL::extract_quad_mesh(synthetic::make_map(layout, {4, 4, 4}, options), layout, mesh);
  BOOST_TEST(num_faces(mesh) == 96u);
  std::set<Kernel::Point_3> points;
  for (const auto v : vertices(mesh)) {
    const Kernel::Point_3& p = mesh.point(v);
    points.insert(p);
    for (int i = 0; i < 3; ++i)
      BOOST_TEST(p[i] * 4 == std::round(p[i] * 4));
  }
  BOOST_TEST(points.size() == num_vertices(mesh));
  check_mesh(layout, mesh);
}

BOOST_AUTO_TEST_CASE(random_maps_and_fractional_divisions)
{
  for (const Quad_layout& layout : {cube(), box(), pillow(), torus(1, 1), torus(3, 4)})
    for (unsigned seed = 0; seed < 4; ++seed) {
      synthetic::Options options;
      options.seed = seed;
      options.jitter = seed % 2 ? 0.2 : 0; // without: lines along edges, through vertices
      const Integer_grid_map map = synthetic::make_map(layout, lengths_for(layout), options);
      Mesh as_map, fine;
      QL::extract_quad_mesh(map, layout, as_map);
      check_mesh(layout, as_map);
      QL::extract_quad_mesh(map, layout, fine, QL::parameters::target_edge_length(0.07));
      check_mesh(layout, fine);
    }
}

BOOST_AUTO_TEST_CASE(maps_that_are_filled)
{
  const Quad_layout layout = box();
  const Integer_grid_map map = synthetic::make_map(layout, Arcs(layout.number_of_chords, 2));
  Mesh mesh;
  const auto patch = mesh.add_property_map<Mesh::Face_index, int>("patch").first;
  const auto is_node = mesh.add_property_map<Mesh::Vertex_index, bool>("node").first;
  const auto is_layout_edge = mesh.add_property_map<Mesh::Edge_index, bool>("separatrix").first;
  QL::extract_quad_mesh(map, layout, mesh,
                        QL::parameters::face_patch_map(patch)
                            .vertex_is_layout_node_map(is_node)
                            .edge_is_layout_edge_map(is_layout_edge));
  std::vector<int> quads(6, 0);
  for (const auto f : faces(mesh))
    ++quads.at(patch[f]);
  // each box side has 4 quads per square
  std::sort(quads.begin(), quads.end());
  BOOST_TEST(quads == Arcs({8, 8, 12, 12, 24, 24}), boost::test_tools::per_element());
  int nodes = 0, edges_of_box = 0;
  for (const auto v : vertices(mesh)) {
    BOOST_TEST(is_node[v] == (degree(v, mesh) != 4));
    nodes += is_node[v];
  }
  for (const auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    BOOST_TEST(is_layout_edge[e] == (patch[face(h, mesh)] != patch[face(opposite(h, mesh), mesh)]));
    edges_of_box += is_layout_edge[e];
  }
  BOOST_TEST(nodes == 8);
  BOOST_TEST(edges_of_box == 2 * 4 * (3 + 2 + 1));
}

BOOST_AUTO_TEST_CASE(polyhedron)
{
  const Quad_layout layout = cube();
  CGAL::Polyhedron_3<Kernel> polyhedron;
  QL::extract_quad_mesh(synthetic::make_map(layout, {2, 3, 4}), layout, polyhedron);
  BOOST_TEST(polyhedron.is_closed());
  BOOST_TEST(polyhedron.size_of_facets() == 2u * (2 * 3 + 3 * 4 + 4 * 2));
}

BOOST_AUTO_TEST_CASE(curves_join_the_layout_vertices)
{
  const Quad_layout layout = box();
  const Integer_grid_map map = synthetic::make_map(layout, lengths_for(layout));
  const auto curves = QL::layout_curves(map, layout);
  BOOST_TEST(int(curves.size()) == layout.number_of_edges());
  std::vector<Eigen::Vector3d> end(layout.number_of_vertices(), Eigen::Vector3d::Constant(-1));
  for (int h = 0; h < layout.number_of_halfedges(); ++h) {
    const auto& curve = curves[h / 2];
    const Eigen::Vector3d p = h % 2 == 0 ? curve.front() : curve.back();
    Eigen::Vector3d& known = end[layout.source(h)];
    if (known.x() == -1)
      known = p;
    BOOST_TEST((known - p).norm() < 1e-12);
  }
}

// a corner's chart has four directions, though fewer lines leave a vertex of valence 2 or 3
BOOST_AUTO_TEST_CASE(all_directions_at_low_valences)
{
  for (const Quad_layout& layout : {cube(), pillow()}) {
    const Integer_grid_map map = synthetic::make_map(layout, lengths_for(layout));
    const QL::internal::Line_tracer lines(map);
    for (const Integer_grid_map::Anchor& anchor : map.anchors)
      for (int direction = 0; direction < 4; ++direction) {
        const int face = synthetic::Surface::face(anchor.corner);
        const auto heading = lines.entered({face, map.coordinates(anchor.corner), direction});
        BOOST_REQUIRE(heading.is_valid());
        BOOST_TEST((lines.entered(heading) == heading));
      }
  }
}

// whatever is broken in a map, extraction notices it
BOOST_AUTO_TEST_CASE(broken_maps_are_refused)
{
  const Quad_layout layout = cube();
  const Integer_grid_map map = synthetic::make_map(layout, {3, 3, 3});
  const auto check_refused = [&](const Integer_grid_map& broken) {
    Mesh mesh;
    BOOST_CHECK_THROW(QL::extract_quad_mesh(broken, layout, mesh), QL::Stage_failure);
    BOOST_TEST(num_vertices(mesh) == 0u);
  };
  Integer_grid_map broken = map;
  broken.inverted = 1;
  check_refused(broken);
  broken = map;
  broken.wrong_winding = 1;
  check_refused(broken);
  broken = map;
  broken.chord_length = {3, 3, 4};
  check_refused(broken);
  broken = map;
  broken.anchors[0].direction = (broken.anchors[0].direction + 1) & 3;
  check_refused(broken);
  broken = map;
  broken.anchors.clear();
  check_refused(broken);
  broken = map;
  std::swap(broken.anchors[0].layout_halfedge, broken.anchors[1].layout_halfedge);
  check_refused(broken);
  broken = map;
  for (auto& t : broken.halfedge_transition)
    t.translation.x() += 1;
  check_refused(broken);
}

BOOST_AUTO_TEST_CASE(parameters_out_of_range)
{
  const Quad_layout layout = cube();
  const Integer_grid_map map = synthetic::make_map(layout, {3, 3, 3});
  Mesh mesh;
  for (double length :
       {0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    BOOST_CHECK_THROW(
        QL::extract_quad_mesh(map, layout, mesh, QL::parameters::target_edge_length(length)),
        QL::Invalid_parameter);
  // more quads than can be numbered
  BOOST_CHECK_THROW(
      QL::extract_quad_mesh(map, layout, mesh, QL::parameters::target_edge_length(1e-9)),
      QL::Stage_failure);
  BOOST_TEST(num_vertices(mesh) == 0u);
}

// A quarter of a circle takes few segments, a straight line one, a corner two.
BOOST_AUTO_TEST_CASE(segments_of_curves)
{
  const auto number_of_segments = [](const std::vector<Eigen::Vector3d>& polyline,
                                     double tolerance) {
    return QL::internal::knots_of(polyline, tolerance).size() - 1;
  };
  std::vector<QL::internal::Point> circle;
  for (int i = 0; i <= 90; ++i)
    circle.emplace_back(std::cos(i * CGAL_PI / 180), std::sin(i * CGAL_PI / 180), 0);
  // each covers an angle whose half has a cosine of at least 1 - tolerance
  BOOST_TEST(number_of_segments(circle, 1) == 1);
  BOOST_TEST(number_of_segments(circle, 1 - std::cos(0.1)) == 9); // 11 degrees each
  BOOST_TEST(number_of_segments(circle, 0) == 90);
  BOOST_TEST(number_of_segments({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, 0) == 1);
  BOOST_TEST(number_of_segments({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 0.1) == 2);
}

BOOST_AUTO_TEST_SUITE_END()
