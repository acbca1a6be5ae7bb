// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "hand_made_t_meshes.h"

#include <CGAL/Quad_layouts/extract_quad_layout.h>

#include <algorithm>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_extract_quad_layout)

namespace QL = CGAL::Quad_layouts;
using boost::test_tools::per_element;
using QL::Quad_layout;
using QL::T_mesh;
using QL::internal::examine_quotient;
using Arcs = std::vector<int>;

namespace {

QL::Quantization quantization(Arcs lengths)
{
  QL::Quantization result;
  result.arc_length = std::move(lengths);
  result.status = QL::Quantization::FEASIBLE;
  return result;
}

// lengths of a box
Arcs box(int x, int y, int z)
{
  return {x, x, x, x, y, y, y, y, z, z, z, z};
}

// lengths of hand_made::torus(columns.size(), rows.size())
Arcs torus_lengths(const Arcs& columns, const Arcs& rows)
{
  Arcs result;
  for (int row : rows)
    for (int column : columns) {
      result.push_back(column);
      result.push_back(row);
    }
  return result;
}

void check_structure(const Quad_layout& layout)
{
  for (int h = 0; h < layout.number_of_halfedges(); ++h) {
    BOOST_TEST(layout.source(layout.next(h)) == layout.target(h));
    BOOST_TEST(layout.face(layout.next(h)) == layout.face(h));
    BOOST_TEST(layout.next(layout.next(layout.next(layout.next(h)))) == h);
    BOOST_TEST(layout.chord(h / 2) == layout.chord(layout.next(layout.next(h)) / 2));
  }
  for (int v = 0; v < layout.number_of_vertices(); ++v)
    BOOST_TEST(layout.source(layout.halfedge_from(v)) == v);
  for (int f = 0; f < layout.number_of_faces(); ++f)
    BOOST_TEST(layout.face(layout.halfedge_of(f)) == f);
  for (double length : layout.chord_length)
    BOOST_TEST(length > 0);
  for (const auto& point : layout.vertex_point)
    BOOST_TEST(point.allFinite());
}

void check_relation_to_t_mesh(const T_mesh& t, const Arcs& lengths, const Quad_layout& layout)
{
  int index = 0, nodes = 0, extra = 0;
  for (const auto& cluster : layout.clusters) {
    BOOST_TEST(layout.valence(cluster.vertex) == 4 - cluster.index);
    BOOST_TEST(std::is_sorted(cluster.nodes.begin(), cluster.nodes.end()));
    for (int n : cluster.nodes)
      BOOST_TEST(layout.node_vertex[n] == cluster.vertex);
    index += cluster.index;
    nodes += int(cluster.nodes.size());
  }
  for (int n = 0; n < t.number_of_vertices(); ++n)
    nodes -= t.is_singularity_or_seed(n);
  BOOST_TEST(nodes == 0);
  for (int v = 0; v < layout.number_of_vertices(); ++v)
    extra += 4 - layout.valence(v);
  BOOST_TEST(extra == index);
  for (int a = 0; a < t.number_of_edges(); ++a) {
    BOOST_TEST(int(layout.arc_halfedges[a].size()) == lengths[a]);
    int v = layout.node_vertex[t.source(2 * a)];
    for (int h : layout.arc_halfedges[a]) {
      BOOST_TEST(layout.source(h) == v);
      v = layout.target(h);
    }
    BOOST_TEST(layout.node_vertex[t.target(2 * a)] == v);
  }
}

// squares of a grid are numbered row by row, with x along the given halfedge
void check_grids(const T_mesh& t, const Quad_layout& layout)
{
  int squares = 0;
  for (int p = 0; p < t.number_of_faces(); ++p) {
    const Quad_layout::Grid& grid = layout.grids[p];
    squares += int(grid.squares.size());
    for (int j = 0; j < grid.height && grid.width > 0; ++j)
      for (int i = 0; i < grid.width; ++i) {
        const int right = layout.next(grid.square(i, j)), top = layout.next(right);
        if (i + 1 < grid.width)
          BOOST_TEST(layout.next(layout.next(layout.next(grid.square(i + 1, j)))) == (right ^ 1));
        if (j + 1 < grid.height)
          BOOST_TEST(grid.square(i, j + 1) == (top ^ 1));
      }
    const int corner = t.source(t.halfedge_of(p));
    if (!grid.squares.empty())
      BOOST_TEST(layout.source(grid.square(0, 0)) == layout.node_vertex[corner]);
  }
  BOOST_TEST(squares == layout.number_of_faces());
}

Quad_layout extract_and_check(const T_mesh& t, const Arcs& lengths)
{
  const Quad_layout layout = QL::extract_quad_layout(t, quantization(lengths));
  check_structure(layout);
  check_relation_to_t_mesh(t, lengths, layout);
  check_grids(t, layout);
  BOOST_TEST(layout.euler_characteristic() == t.euler_characteristic());
  return layout;
}

} // namespace

BOOST_AUTO_TEST_CASE(cube)
{
  const Quad_layout layout = extract_and_check(hand_made::cube(), box(1, 1, 1));
  BOOST_TEST(layout.number_of_vertices() == 8);
  BOOST_TEST(layout.number_of_patches == 6);
  BOOST_TEST(layout.number_of_chords == 3);
  BOOST_TEST(layout.number_of_irregular_vertices() == 8);
  for (int e = 0; e < 12; ++e)
    BOOST_TEST(layout.is_on_separatrix(e));
  for (double length : layout.chord_length)
    BOOST_TEST(std::abs(length - 1) < 1e-12);
}

BOOST_AUTO_TEST_CASE(box_has_the_patches_of_a_cube)
{
  const Quad_layout layout = extract_and_check(hand_made::cube(), box(3, 2, 1));
  BOOST_TEST(layout.number_of_faces() == 2 * (3 * 2 + 2 * 1 + 1 * 3));
  BOOST_TEST(layout.number_of_patches == 6);
  BOOST_TEST(layout.number_of_chords == 6);
  // the three parts of an edge of length 1 share it
  for (int e = 0; e < layout.number_of_edges(); ++e) {
    const double parts = 1 / layout.chord_length[layout.chord(e)];
    BOOST_TEST(std::abs(parts - std::round(parts)) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(flattened_cube_is_a_pillow)
{
  const Quad_layout layout = extract_and_check(hand_made::cube(), box(0, 1, 1));
  BOOST_TEST(layout.number_of_vertices() == 4);
  BOOST_TEST(layout.number_of_faces() == 2);
  BOOST_TEST(layout.clusters.size() == 4u);
  for (const auto& cluster : layout.clusters) {
    BOOST_TEST(cluster.index == 2);
    BOOST_TEST(cluster.nodes.size() == 2u);
  }
}

BOOST_AUTO_TEST_CASE(cube_without_width_and_height_is_a_ring)
{
  const auto report = examine_quotient(hand_made::cube(), box(3, 0, 0));
  BOOST_TEST(!report.valid);
  // around the cube: two arcs along y and two along z
  BOOST_REQUIRE(report.cuts.size() == 1u);
  BOOST_TEST(report.cuts[0].arcs.size() == 4u);
  BOOST_TEST(report.clusters.size() == 2u);
  BOOST_TEST(report.clusters[0].index == 4);
  BOOST_CHECK_THROW(QL::extract_quad_layout(hand_made::cube(), quantization(box(3, 0, 0))),
                    QL::Stage_failure);
}

BOOST_AUTO_TEST_CASE(vanished_cube)
{
  const auto report = examine_quotient(hand_made::cube(), box(0, 0, 0));
  BOOST_TEST(!report.valid);
  BOOST_REQUIRE(report.cuts.size() == 1u);
  BOOST_TEST(report.cuts[0].arcs.size() == 12u);
}

BOOST_AUTO_TEST_CASE(torus_of_one_patch)
{
  const T_mesh t = hand_made::torus(1, 1);
  const Quad_layout layout = extract_and_check(t, {1, 1});
  BOOST_TEST(layout.number_of_vertices() == 1);
  BOOST_TEST(layout.number_of_patches == 1);
  BOOST_TEST(layout.number_of_chords == 2);
  BOOST_TEST(layout.valence(0) == 4);
  BOOST_TEST(extract_and_check(t, {2, 3}).number_of_patches == 1);
  for (const int zero : {0, 1}) {
    const auto cuts = examine_quotient(t, {zero, 1 - zero}).cuts;
    BOOST_REQUIRE(cuts.size() == 1u);
    BOOST_TEST(cuts[0].arcs == Arcs({zero}), per_element());
    BOOST_TEST(cuts[0].is_exact); // around the torus
  }
  // a handle that vanishes altogether needs both cuts
  BOOST_TEST(examine_quotient(t, {0, 0}).cuts.size() == 2u);
}

BOOST_AUTO_TEST_CASE(merged_seeds_of_a_torus)
{
  const T_mesh t = hand_made::torus(3, 3);
  const Quad_layout layout = extract_and_check(t, torus_lengths({0, 1, 2}, {1, 0, 1}));
  BOOST_TEST(layout.number_of_faces() == 6);
  BOOST_TEST(layout.clusters.size() == 4u);
  BOOST_TEST(layout.clusters[0].nodes == Arcs({0, 1}), per_element());
  BOOST_TEST(layout.clusters[2].nodes == Arcs({3, 4, 6, 7}), per_element());
}

// no loop of zero arcs leads around, but a line straight through three patches of zero width does
BOOST_AUTO_TEST_CASE(ring_through_patches)
{
  const auto report = examine_quotient(hand_made::torus(3, 1), torus_lengths({0, 0, 0}, {4}));
  BOOST_TEST(!report.valid);
  BOOST_REQUIRE(report.cuts.size() == 1u);
  BOOST_TEST(report.cuts[0].arcs == Arcs({0, 2, 4}), per_element());
}

BOOST_AUTO_TEST_CASE(inconsistent_lengths_are_refused)
{
  Arcs lengths = box(1, 1, 1);
  lengths[0] = 2;
  BOOST_CHECK_THROW(examine_quotient(hand_made::cube(), lengths), QL::Stage_failure);
  lengths[0] = -1;
  BOOST_CHECK_THROW(examine_quotient(hand_made::cube(), lengths), QL::Stage_failure);
}

// The search for cuts and the count of cells are independent: they must agree on what is valid.
BOOST_AUTO_TEST_CASE(cuts_and_counts_agree)
{
  const unsigned seed = 1;
  BOOST_TEST_MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  int valid = 0;
  for (int round = 0; round < 500; ++round) {
    Arcs columns(1 + random() % 4), rows(1 + random() % 4);
    for (int& n : columns)
      n = int(random() % 3) / 2;
    for (int& n : rows)
      n = int(random() % 3) / 2;
    const T_mesh t = hand_made::torus(int(columns.size()), int(rows.size()));
    const Arcs lengths = torus_lengths(columns, rows);
    const auto report = examine_quotient(t, lengths);
    const QL::internal::Arc_grid grid(t, lengths);
    const QL::internal::Fibres fibres(grid);
    const QL::internal::Glued_squares squares(grid);
    BOOST_TEST(report.cuts.empty() == QL::internal::difference_to_surface(fibres, squares).empty());
    for (const auto& [cut, is_exact] : report.cuts)
      BOOST_TEST(std::all_of(cut.begin(), cut.end(), [&](int a) { return lengths[a] == 0; }));
    const auto is_positive = [](int n) { return n > 0; };
    const bool expected = std::any_of(columns.begin(), columns.end(), is_positive) &&
                          std::any_of(rows.begin(), rows.end(), is_positive);
    BOOST_TEST(report.valid == expected);
    valid += report.valid;
  }
  BOOST_TEST(valid > 50);
}

BOOST_AUTO_TEST_SUITE_END()
