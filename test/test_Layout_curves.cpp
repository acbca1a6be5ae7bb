// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "embedding_cases.h"

#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/embedding/Layout_curves.h>
#include <CGAL/Quad_layouts/internal/embedding/Layout_squares.h>
#include <CGAL/Quad_layouts/internal/embedding/Overlay_reduction.h>
#include <CGAL/Quad_layouts/internal/embedding/check_embedded_layout.h>
#include <CGAL/Quad_layouts/internal/layout/chord_divisions.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_Layout_curves)

namespace QL = CGAL::Quad_layouts;
using QL::Quad_layout;
using QL::internal::Curve_mesh;
using QL::internal::Embedded_layout;
using QL::internal::Triangle_surface;

namespace {

Embedded_layout drawn(const Embedding_case& c)
{
  return QL::internal::Layout_curves(c.t_mesh, c.layout, QL::internal::Monitor()).result();
}

// checks that each cluster is at one of its singularities, the most like it in index of its kind
void check_places_of_clusters(const Embedded_layout& e, const Quad_layout& layout,
                              const QL::T_mesh& t_mesh)
{
  for (const Quad_layout::Cluster& cluster : layout.clusters) {
    const auto place = std::find_if(cluster.nodes.begin(), cluster.nodes.end(), [&](int n) {
      return t_mesh.surface_vertex(n) == e.vertices[cluster.vertex];
    });
    BOOST_REQUIRE((place != cluster.nodes.end()));
    const auto difference = [&](int n) { return std::abs(t_mesh.index(n) - cluster.index); };
    for (const int n : cluster.nodes)
      if (t_mesh.number_of_fixed_arcs(n) == t_mesh.number_of_fixed_arcs(*place) &&
          t_mesh.index(n) != 0)
        BOOST_TEST(difference(n) >= difference(*place));
  }
}

// checks that the curves lead from vertex to vertex and meet nowhere else, and that no other edge
// joins two of them
void check_curves(const Embedded_layout& e, const Quad_layout& layout)
{
  const Curve_mesh& mesh = e.mesh;
  std::vector<int> at(mesh.points.size(), 0); // number of halfedges of curves that leave a vertex
  std::vector<int> pieces(layout.number_of_halfedges(), 0);
  int wrong = 0;
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.curve[h] >= 0) {
      ++at[mesh.source(h)];
      ++pieces[mesh.curve[h]];
      wrong += mesh.curve[mesh.opposite(h)] != Quad_layout::opposite(mesh.curve[h]);
    }
  for (int l = 0; l < layout.number_of_halfedges(); ++l) {
    int v = e.vertices[layout.source(l)];
    for (int i = 0; i < pieces[l]; ++i)
      for (const int h : mesh.outgoing(v))
        if (mesh.curve[h] == l) {
          v = mesh.target(h);
          break;
        }
    wrong += pieces[l] == 0 || v != e.vertices[layout.target(l)];
  }
  for (int v = 0; v < layout.number_of_vertices(); ++v)
    at[e.vertices[v]] -= layout.valence(v) - 2;
  for (const int n : at)
    wrong += n != 0 && n != 2;
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    wrong += mesh.curve[h] < 0 && at[mesh.source(h)] > 0 && at[mesh.target(h)] > 0;
  BOOST_TEST(wrong == 0);
}

// counts for each face of the layout the vertices and faces less the edges inside of its regions
void check_regions(const Embedded_layout& e, const Quad_layout& layout)
{
  QL::internal::Disjoint_sets regions(e.mesh.number_of_faces());
  for (int h = 0; h < e.mesh.number_of_halfedges(); ++h)
    if (e.mesh.curve[h] < 0)
      regions.union_set(h / 3, e.mesh.opposite(h) / 3);
  std::vector<int> difference(e.mesh.number_of_faces(), 0), face(e.mesh.number_of_faces(), -1);
  int wrong = 0;
  for (int f = 0; f < e.mesh.number_of_faces(); ++f)
    ++difference[regions.find_set(f)];
  for (int h = 0; h < e.mesh.number_of_halfedges(); ++h) {
    const int region = int(regions.find_set(h / 3));
    if (e.mesh.curve[h] < 0 && h < e.mesh.opposite(h))
      --difference[region];
    if (e.mesh.curve[h] >= 0) {
      const int f = layout.face(e.mesh.curve[h]);
      wrong += face[region] >= 0 && face[region] != f;
      face[region] = f;
    }
  }
  for (int v = 0; v < int(e.mesh.points.size()); ++v) {
    bool is_inside = true;
    e.mesh.for_each_outgoing(v, [&](int h) { is_inside &= e.mesh.curve[h] < 0; });
    if (is_inside)
      ++difference[regions.find_set(e.mesh.outgoing(v).front() / 3)];
  }
  std::vector<int> seen(layout.number_of_faces(), 0);
  for (int f = 0; f < e.mesh.number_of_faces(); ++f)
    if (int(regions.find_set(f)) == f) {
      wrong += difference[f] != 1 || face[f] < 0;
      ++seen[face[f]];
    }
  for (const int n : seen)
    wrong += n != 1;
  BOOST_TEST(wrong == 0);
}

} // namespace

BOOST_AUTO_TEST_CASE(layouts_are_drawn)
{
  for (const Embedding_case& c : embedding_cases())
    BOOST_TEST_CONTEXT(c.name)
    {
      const Embedded_layout e = drawn(c);
      const Triangle_surface surface(e.mesh.points, e.mesh.triangles()); // throws unless manifold
      check_curves(e, c.layout);
      check_regions(e, c.layout);
      check_places_of_clusters(e, c.layout, c.t_mesh);
    }
}

// Where all corners of a hole merge, their place is one with room for the quads around it, not the
// corner where only one quad fits, although that is the first of the vertices.
BOOST_AUTO_TEST_CASE(clusters_are_where_there_is_room)
{
  const std::vector<std::array<int, 2>> hole_and_first = {{3, 3}, {4, 3}, {3, 4}, {4, 4}};
  std::vector<std::array<int, 2>> cells = {hole_and_first.back()};
  for (int x = 0; x < 9; ++x)
    for (int y = 0; y < 9; ++y)
      if (std::array<int, 2> cell = {x, y};
          std::find(hole_and_first.begin(), hole_and_first.end(), cell) == hole_and_first.end())
        cells.push_back(cell);
  const Embedding_case c("plate with a hole", generated::plate(cells, 4), 4);
  BOOST_TEST(std::any_of(c.layout.clusters.begin(), c.layout.clusters.end(),
                         [](const Quad_layout::Cluster& x) { return x.nodes.size() > 1; }));
  check_places_of_clusters(drawn(c), c.layout, c.t_mesh);
}

// Each unit of the sides ends at a vertex of the surface, although (15 / 26.) * 26 is not 15.
BOOST_AUTO_TEST_CASE(units_end_where_edges_do)
{
  for (const int n : {22, 25, 26}) {
    const QL::T_mesh t = QL::trace_motorcycle_graph(
        QL::compute_cross_field(generated::plate_with_holes(1, 1, {}, n)));
    BOOST_REQUIRE_EQUAL(t.number_of_edges(), 4);
    QL::Quantization units;
    units.status = QL::Quantization::FEASIBLE;
    units.arc_length.assign(4, n);
    const Quad_layout layout = QL::extract_quad_layout(t, units);
    const Embedded_layout e =
        QL::internal::Layout_curves(t, layout, QL::internal::Monitor()).result();
    check_curves(e, layout);
    for (int l = 0; l < layout.number_of_edges(); ++l)
      for (const int end : {layout.source(2 * l), layout.target(2 * l)})
        BOOST_TEST((!layout.is_fixed(l) || e.vertices[end] < t.surface().number_of_vertices()));
  }
}

BOOST_AUTO_TEST_CASE(reduction_keeps_curves_and_surface)
{
  for (const Embedding_case& c : embedding_cases())
    BOOST_TEST_CONTEXT(c.name)
    {
      Embedded_layout e = drawn(c);
      const auto before = e.mesh.points.size();
      const Triangle_surface& surface = c.t_mesh.surface();
      QL::internal::reduce(e, surface.number_of_vertices(), QL::internal::Monitor());
      BOOST_TEST(e.mesh.points.size() < before);
      check_curves(e, c.layout);
      check_regions(e, c.layout);
      for (int v = 0; v < surface.number_of_vertices(); ++v)
        BOOST_TEST((e.mesh.points[v] == surface.point(v)));
      // the edges of the surface are there, in pieces
      double length = 0, expected = 0;
      for (int h = 0; h < e.mesh.number_of_halfedges(); ++h)
        if (e.mesh.is_original[h])
          length += (e.mesh.points[e.mesh.target(h)] - e.mesh.points[e.mesh.source(h)]).norm();
      for (int h = 0; h < surface.number_of_halfedges(); ++h)
        expected += (surface.point(surface.target(h)) - surface.point(surface.source(h))).norm();
      BOOST_TEST(length == expected, boost::test_tools::tolerance(1e-9));
    }
}

BOOST_AUTO_TEST_CASE(charts_close_around_regular_vertices)
{
  for (const Embedding_case& c : embedding_cases())
    BOOST_TEST_CONTEXT(c.name)
    {
      const Embedded_layout e = drawn(c);
      QL::internal::check_embedded_layout(e, c.layout);
      const std::vector<int> length = QL::internal::chord_divisions(c.layout, 1);
      const QL::internal::Layout_squares squares(c.layout, length);
      std::vector<int> turns(e.mesh.points.size(), 0);
      for (int v = 0; v < c.layout.number_of_vertices(); ++v)
        turns[e.vertices[v]] = (4 - c.layout.valence(v)) & 3;
      int wrong = 0;
      for (int v = 0; v < int(e.mesh.points.size()); ++v) {
        QL::internal::Chart_change around;
        e.mesh.for_each_outgoing(v, [&](int h) {
          around = squares.across(e.mesh.curve[Curve_mesh::prev(h)]).after(around);
        });
        wrong += around.quarter_turns != turns[v];
        wrong += turns[v] == 0 && !around.translation.isZero(0);
      }
      BOOST_TEST(wrong == 0);
    }
}

BOOST_AUTO_TEST_SUITE_END()
