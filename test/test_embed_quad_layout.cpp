// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/embed_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <cmath>
#include <map>
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

BOOST_AUTO_TEST_CASE(bad_parameters_are_refused)
{
  const Embedded e(generated::cube(4), 0, 0.1);
  for (const double h : {0., -1., std::nan("")})
    BOOST_CHECK_THROW(
        QL::embed_quad_layout(e.t_mesh, e.layout, QL::parameters::target_edge_length(h)),
        QL::Invalid_parameter);
}

BOOST_AUTO_TEST_SUITE_END()
