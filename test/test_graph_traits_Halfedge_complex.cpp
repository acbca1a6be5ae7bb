// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/graph_traits_Halfedge_complex.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_concepts.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <array>
#include <map>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_graph_traits_Halfedge_complex)

namespace QL = CGAL::Quad_layouts;
namespace PMP = CGAL::Polygon_mesh_processing;
using QL::edge; // a solver has a type of this name, too
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

BOOST_CONCEPT_ASSERT((CGAL::HalfedgeListGraphConcept<QL::Halfedge_complex>));
BOOST_CONCEPT_ASSERT((CGAL::FaceListGraphConcept<QL::Halfedge_complex>));
BOOST_CONCEPT_ASSERT((CGAL::FaceListGraphConcept<QL::T_mesh>));
BOOST_CONCEPT_ASSERT((CGAL::HalfedgeListGraphConcept<QL::Quad_layout>));
BOOST_CONCEPT_ASSERT((CGAL::FaceListGraphConcept<QL::Quad_layout>));
BOOST_CONCEPT_ASSERT((boost::concepts::BidirectionalGraph<QL::Quad_layout>));
BOOST_CONCEPT_ASSERT((boost::concepts::AdjacencyGraph<QL::Quad_layout>));
BOOST_CONCEPT_ASSERT((boost::concepts::VertexAndEdgeListGraph<QL::Quad_layout>));

namespace {

// makes the complex of the unit cube with its six quadrilaterals
template <class Complex>
Complex make_cube()
{
  const std::vector<std::array<int, 4>> quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  Complex complex;
  for (int v = 0; v < 8; ++v)
    complex.vertex_point.emplace_back(v & 1, (v >> 1) & 1, v >> 2);
  complex.vertex_halfedge.resize(8);
  std::map<std::pair<int, int>, int> halfedge;
  int edges = 0;
  for (const auto& quad : quads)
    for (int i = 0; i < 4; ++i) {
      const int a = quad[i], b = quad[(i + 1) % 4];
      if (halfedge.count({a, b}) == 0) {
        halfedge[{a, b}] = 2 * edges;
        halfedge[{b, a}] = 2 * edges++ + 1;
      }
    }
  complex.halfedge_target.resize(2 * edges);
  complex.halfedge_next.resize(2 * edges);
  complex.halfedge_face.resize(2 * edges);
  for (int f = 0; f < 6; ++f) {
    const auto& quad = quads[f];
    for (int i = 0; i < 4; ++i) {
      const int a = quad[i], b = quad[(i + 1) % 4], c = quad[(i + 2) % 4];
      const int h = halfedge[{a, b}];
      complex.halfedge_target[h] = b;
      complex.halfedge_next[h] = halfedge[{b, c}];
      complex.halfedge_face[h] = f;
      complex.vertex_halfedge[a] = h;
    }
    complex.face_halfedge.push_back(halfedge[{quad[0], quad[1]}]);
  }
  return complex;
}

// makes the torus of one vertex, two edges and one quadrilateral
QL::Quad_layout smallest_torus()
{
  QL::Quad_layout torus;
  torus.vertex_point.emplace_back(0, 0, 0);
  torus.vertex_halfedge = {0};
  torus.face_halfedge = {0};
  torus.halfedge_target = {0, 0, 0, 0};
  torus.halfedge_next = {2, 3, 1, 0};
  torus.halfedge_face = {0, 0, 0, 0};
  return torus;
}

} // namespace

BOOST_AUTO_TEST_CASE(cube_as_a_graph)
{
  const auto cube = make_cube<QL::Quad_layout>();
  BOOST_TEST(num_vertices(cube) == 8);
  BOOST_TEST(num_edges(cube) == 12);
  BOOST_TEST(num_halfedges(cube) == 24);
  BOOST_TEST(num_faces(cube) == 6);
  BOOST_TEST(CGAL::is_closed(cube));
  BOOST_TEST(CGAL::is_quad_mesh(cube));
  BOOST_TEST(CGAL::is_valid_polygon_mesh(cube));
  for (const auto v : vertices(cube)) {
    BOOST_TEST(degree(v, cube) == 3);
    BOOST_TEST(target(halfedge(v, cube), cube) == v);
    for (const auto e : CGAL::make_range(out_edges(v, cube)))
      BOOST_TEST(source(e, cube) == v);
    for (const auto e : CGAL::make_range(in_edges(v, cube)))
      BOOST_TEST(target(e, cube) == v);
    for (const auto u : adjacent_vertices(v, cube)) {
      BOOST_TEST(edge(u, v, cube).second);
      BOOST_TEST(edge(u, v, cube).first == edge(v, u, cube).first);
    }
  }
  const auto v = vertices(cube).begin();
  BOOST_TEST(!halfedge(*v, *v, cube).second);
}

BOOST_AUTO_TEST_CASE(numbers_and_points)
{
  const auto cube = make_cube<QL::T_mesh>();
  std::size_t n = 0;
  for (const auto f : faces(cube))
    BOOST_TEST(get(get(CGAL::face_index, cube), f) == n++);
  for (const auto e : edges(cube))
    BOOST_TEST(get(CGAL::edge_index, cube, e) ==
               get(CGAL::halfedge_index, cube, halfedge(e, cube)) / 2);
  for (const auto v : vertices(cube)) {
    const Kernel::Point_3 p = get(CGAL::vertex_point, cube, v);
    BOOST_TEST(p.x() == cube.point(v.id()).x());
    BOOST_TEST(get(CGAL::vertex_index, cube, v) == std::size_t(v.id()));
  }
}

BOOST_AUTO_TEST_CASE(functions_of_CGAL_read_complexes)
{
  const auto cube = make_cube<QL::Quad_layout>();
  Mesh mesh;
  CGAL::copy_face_graph(cube, mesh);
  BOOST_TEST(CGAL::is_valid_polygon_mesh(mesh));
  BOOST_TEST(num_faces(mesh) == 6u);
  BOOST_TEST(PMP::edge_length(*halfedges(mesh).begin(), mesh) == 1.);
  BOOST_TEST(PMP::edge_length(halfedge(*edges(cube).begin(), cube), cube) == 1.);
  BOOST_TEST(PMP::face_border_length(halfedge(*faces(cube).begin(), cube), cube) == 4.);
  const auto component = get(CGAL::dynamic_face_property_t<int>(), cube);
  BOOST_TEST(PMP::connected_components(cube, component) == 1u);
}

BOOST_AUTO_TEST_CASE(algorithms_of_Boost_read_complexes)
{
  const auto cube = make_cube<QL::Quad_layout>();
  std::vector<int> distance(8);
  boost::dijkstra_shortest_paths(cube, *vertices(cube).begin(),
                                 boost::weight_map(boost::static_property_map<int>(1))
                                     .distance_map(boost::make_iterator_property_map(
                                         distance.begin(), get(boost::vertex_index, cube))));
  BOOST_TEST(distance == (std::vector<int>{0, 1, 1, 2, 1, 2, 2, 3}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(loops_are_allowed)
{
  const auto torus = smallest_torus();
  BOOST_TEST(torus.euler_characteristic() == 0);
  const auto v = *vertices(torus).begin();
  BOOST_TEST(degree(v, torus) == 4);
  BOOST_TEST(degree(*faces(torus).begin(), torus) == 4);
  BOOST_TEST(halfedge(v, v, torus).second);
  BOOST_TEST(CGAL::is_closed(torus));
  Mesh mesh;
  CGAL::copy_face_graph(torus, mesh);
  BOOST_TEST(num_vertices(mesh) == 1u);
  BOOST_TEST(num_edges(mesh) == 2u);
  BOOST_TEST(num_faces(mesh) == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
