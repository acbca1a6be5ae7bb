// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "hand_made_t_meshes.h"

#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/measure_quad_layout.h>

#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_measure_quad_layout)

namespace QL = CGAL::Quad_layouts;

namespace {

QL::Quad_layout layout_of(const QL::T_mesh& t, std::vector<int> lengths)
{
  QL::Quantization quantization;
  quantization.arc_length = std::move(lengths);
  return QL::extract_quad_layout(t, quantization);
}

} // namespace

BOOST_AUTO_TEST_CASE(box)
{
  const auto measures = QL::measure_quad_layout(
      layout_of(hand_made::cube(), {2, 2, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1}));
  BOOST_TEST(measures.vertices == 12);
  BOOST_TEST(measures.edges == 20);
  BOOST_TEST(measures.faces == 10);
  BOOST_TEST(measures.chords == 4);
  BOOST_TEST(measures.euler_characteristic == 2);
  BOOST_TEST(measures.irregular_vertices == 8);
  BOOST_TEST(measures.valences.at(3) == 8);
  BOOST_TEST(measures.valences.at(4) == 4);
  BOOST_TEST(measures.minimum_valence() == 3);
  BOOST_TEST(measures.maximum_valence() == 4);
  BOOST_TEST(measures.patches == 6);
  BOOST_TEST(measures.patches_floor == 6);
  BOOST_TEST(measures.t_junctions == 0);
}

BOOST_AUTO_TEST_CASE(torus)
{
  const auto measures = QL::measure_quad_layout(
      layout_of(hand_made::torus(2, 3), std::vector<int>(12, 1)));
  BOOST_TEST(measures.irregular_vertices == 0);
  BOOST_TEST(measures.patches == 1);
  BOOST_TEST(measures.patches_floor == 0);
  BOOST_TEST(measures.t_junctions == 0);
  BOOST_TEST(measures.euler_characteristic == 0);
}

// a separatrix that is not continued through a regular vertex is a T-junction on its side
BOOST_AUTO_TEST_CASE(interrupted_separatrix)
{
  QL::Quad_layout layout = layout_of(hand_made::cube(), {2, 2, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1});
  for (int h = 0; h < layout.number_of_halfedges(); ++h)
    if (layout.valence(layout.source(h)) == 3 && layout.valence(layout.target(h)) == 4) {
      layout.edge_on_separatrix[h / 2] = 0;
      break;
    }
  BOOST_TEST(QL::measure_quad_layout(layout).t_junctions == 1);
}

BOOST_AUTO_TEST_SUITE_END()
