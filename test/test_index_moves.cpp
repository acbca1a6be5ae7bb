// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "generated_fields.h"
#include "generated_meshes.h"
#include "traced_graphs.h"

#include <CGAL/Quad_layouts/internal/tracing/index_moves.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstdlib>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_index_moves)

namespace QL = CGAL::Quad_layouts;
namespace internal = CGAL::Quad_layouts::internal;

namespace {

std::vector<int> valences(const internal::Labels& labels)
{
  std::vector<int> result;
  for (int v = 0; v < labels.surface().number_of_vertices(); ++v)
    result.push_back(labels.valence(v));
  return result;
}

bool all_faces_are_valid(const internal::Labels& labels)
{
  bool result = true;
  for (int f = 0; f < labels.surface().number_of_faces(); ++f)
    result = result && labels.is_valid(f);
  return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(they_move_a_quarter_along_an_edge)
{
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const QL::Cross_field field = generated::random_field(
        seed == 1 ? generated::icosphere(1) : generated::plate_with_holes(4, 4, {}, 2), seed);
    const auto& surface = field.surface();
    internal::Labels labels = internal::make_labels(field);
    const QL::T_mesh t = traced_graphs::motorcycle_graph(field, {});
    const std::vector<int> before = valences(labels);
    const std::vector<internal::Index_move> moves = internal::index_moves_near(t, {0}, labels);
    BOOST_TEST(!moves.empty());
    BOOST_TEST(valences(labels) == before);
    for (const internal::Index_move& move : moves) {
      move.apply(labels);
      std::vector<int> after = valences(labels);
      BOOST_TEST(all_faces_are_valid(labels));
      BOOST_TEST(*std::min_element(after.begin(), after.end()) >= 2);
      const int u = surface.source(move.halfedge), v = surface.target(move.halfedge);
      BOOST_TEST(std::abs(after[u] - before[u]) == 1);
      BOOST_TEST(after[v] - before[v] == before[u] - after[u]);
      after[u] = before[u];
      after[v] = before[v];
      BOOST_TEST(after == before);
      move.undo(labels);
      BOOST_TEST(valences(labels) == before);
    }
  }
}

BOOST_AUTO_TEST_CASE(nearest_faces_first)
{
  const QL::Cross_field field = generated::random_field(generated::icosphere(2), 1);
  const QL::T_mesh t = QL::trace_motorcycle_graph(field);
  for (int a = 0; a < t.number_of_edges(); a += 7) {
    const std::vector<int> along = internal::faces_near(t, {a}, 0);
    BOOST_TEST(!along.empty());
    for (const QL::T_mesh::Crossing& c : t.arc_crossings[a])
      BOOST_TEST((std::find(along.begin(), along.end(),
                            internal::Triangle_surface::face(c.halfedge)) != along.end()));
    std::vector<int> faces = internal::faces_near(t, {a}, 60);
    BOOST_TEST(faces.size() >= 60);
    BOOST_TEST((std::equal(along.begin(), along.end(), faces.begin())));
    std::sort(faces.begin(), faces.end());
    BOOST_TEST((std::adjacent_find(faces.begin(), faces.end()) == faces.end()));
  }
}

BOOST_AUTO_TEST_SUITE_END()
