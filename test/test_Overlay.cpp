// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "embedding_cases.h"

#include <CGAL/Quad_layouts/internal/embedding/Overlay.h>

#include <vector>

BOOST_AUTO_TEST_SUITE(test_Overlay)

namespace QL = CGAL::Quad_layouts;
using QL::T_mesh;
using QL::internal::Overlay;
using QL::internal::Triangle_surface;

namespace {

double area(const Triangle_surface& s, int f)
{
  const auto& p = s.point(s.source(3 * f));
  return (s.point(s.source(3 * f + 1)) - p).cross(s.point(s.source(3 * f + 2)) - p).norm() / 2;
}

double total_area(const Triangle_surface& s)
{
  double sum = 0;
  for (int f = 0; f < s.number_of_faces(); ++f)
    sum += area(s, f);
  return sum;
}

int euler(const Triangle_surface& s)
{
  return s.number_of_vertices() - s.number_of_edges() + s.number_of_faces();
}

} // namespace

BOOST_AUTO_TEST_CASE(it_refines_the_surface)
{
  for (const Embedding_case& c : embedding_cases())
    BOOST_TEST_CONTEXT(c.name)
    {
      const Overlay overlay(c.t_mesh);
      const Triangle_surface refined(overlay.points, overlay.triangles); // throws unless manifold
      BOOST_TEST(refined.number_of_vertices() > c.t_mesh.surface().number_of_vertices());
      BOOST_TEST(euler(refined) == euler(c.t_mesh.surface()));
      BOOST_TEST(total_area(refined) == total_area(c.t_mesh.surface()),
                 boost::test_tools::tolerance(1e-9));
    }
}

BOOST_AUTO_TEST_CASE(each_edge_of_the_surface_is_a_chain)
{
  for (const Embedding_case& c : embedding_cases())
    BOOST_TEST_CONTEXT(c.name)
    {
      const Overlay overlay(c.t_mesh);
      int pieces = 0, expected = 0;
      for (const char is_original : overlay.is_original)
        pieces += is_original;
      for (const auto& crossings : c.t_mesh.edge_crossings)
        expected += 2 * (int(crossings.size()) + 1);
      BOOST_TEST(pieces == expected);
    }
}

BOOST_AUTO_TEST_CASE(patches_are_discs_between_arcs)
{
  for (const Embedding_case& c : embedding_cases())
    BOOST_TEST_CONTEXT(c.name)
    {
      const Overlay overlay(c.t_mesh);
      const Triangle_surface refined(overlay.points, overlay.triangles);
      // inside of a disc there are as many vertices and faces as edges, less one
      std::vector<int> difference(c.t_mesh.number_of_faces(), 0);
      std::vector<char> on_arc(refined.number_of_vertices(), 0);
      for (int f = 0; f < refined.number_of_faces(); ++f)
        ++difference[overlay.patch[f]];
      for (int h = 0; h < refined.number_of_halfedges(); ++h)
        if (overlay.arc_halfedge[h] >= 0) {
          on_arc[refined.source(h)] = 1;
          BOOST_TEST(c.t_mesh.face(overlay.arc_halfedge[h]) == overlay.patch[h / 3]);
          BOOST_TEST(overlay.arc_halfedge[refined.opposite(h)] ==
                     T_mesh::opposite(overlay.arc_halfedge[h]));
        } else if (h < refined.opposite(h))
          --difference[overlay.patch[h / 3]];
      for (int v = 0; v < refined.number_of_vertices(); ++v)
        if (!on_arc[v])
          ++difference[overlay.patch[refined.halfedge(v) / 3]];
      for (const int d : difference)
        BOOST_TEST(d == 1);
    }
}

BOOST_AUTO_TEST_SUITE_END()
