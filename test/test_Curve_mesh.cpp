// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/internal/embedding/Curve_mesh.h>

#include <algorithm>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_Curve_mesh)

namespace QL = CGAL::Quad_layouts;
using QL::internal::Curve_mesh;
using QL::internal::Triangle_surface;

namespace {

Curve_mesh curve_mesh_of(const generated::Mesh& mesh)
{
  return Curve_mesh(QL::compute_cross_field(mesh).surface());
}

int common_neighbours(const Curve_mesh& mesh, int u, int v)
{
  int result = 0;
  for (const int g : mesh.outgoing(u))
    result += mesh.halfedge_between(v, mesh.target(g)) >= 0;
  return result;
}

// checks what `Triangle_surface` does not, and lets it check the rest
void check(const Curve_mesh& mesh)
{
  const Triangle_surface surface(mesh.points, mesh.triangles());
  int wrong = 0;
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    wrong += mesh.opposite(mesh.opposite(h)) != h;
    wrong += surface.opposite(h) != mesh.opposite(h);
    wrong += mesh.is_original[h] != mesh.is_original[mesh.opposite(h)];
    wrong += (mesh.curve[h] < 0) != (mesh.curve[mesh.opposite(h)] < 0);
  }
  for (int v = 0; v < int(mesh.points.size()); ++v)
    for (const int h : mesh.outgoing(v))
      wrong += mesh.source(h) != v;
  BOOST_TEST(wrong == 0);
  BOOST_TEST(surface.number_of_vertices() - surface.number_of_edges() + surface.number_of_faces() ==
             2);
}

int number_of_marks(const Curve_mesh& mesh)
{
  return int(std::count(mesh.is_original.begin(), mesh.is_original.end(), 1));
}

} // namespace

BOOST_AUTO_TEST_CASE(splits_keep_marks)
{
  Curve_mesh mesh = curve_mesh_of(generated::icosphere(2));
  std::mt19937 random(1);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    mesh.is_original[h] = 1;
  const int marks = number_of_marks(mesh);
  for (int i = 0; i < 500; ++i) {
    const int h = int(random() % unsigned(mesh.number_of_halfedges()));
    const int added = mesh.is_original[h] ? 2 : 0, before = number_of_marks(mesh);
    const int m = mesh.split(h, 0.25);
    BOOST_TEST(m == int(mesh.points.size()) - 1);
    BOOST_TEST(mesh.outgoing(m).size() == 4u);
    BOOST_TEST(number_of_marks(mesh) == before + added);
  }
  BOOST_TEST(number_of_marks(mesh) > marks);
  check(mesh);
}

BOOST_AUTO_TEST_CASE(collapses_undo_splits)
{
  Curve_mesh mesh = curve_mesh_of(generated::icosphere(2));
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    mesh.is_original[h] = 1;
  const Curve_mesh before = mesh;
  const int vertices = int(mesh.points.size());
  for (int h = 0; h < 100; ++h)
    if (mesh.is_original[h])
      mesh.split(h);
  // backwards, along one half of the edge that was split
  for (int u = int(mesh.points.size()) - 1; u >= vertices; --u) {
    const std::vector<int> around = mesh.outgoing(u);
    const auto half = std::find_if(around.begin(), around.end(), [&](int h) {
      return mesh.is_original[h] && mesh.target(h) < u &&
             common_neighbours(mesh, u, mesh.target(h)) == 2;
    });
    BOOST_TEST_REQUIRE((half != around.end()));
    mesh.collapse(*half);
    BOOST_TEST(mesh.is_removed(u));
  }
  const std::vector<int> number = mesh.compact();
  check(mesh);
  BOOST_TEST((mesh.points == before.points));
  BOOST_TEST(number_of_marks(mesh) == number_of_marks(before));
  for (int v = 0; v < int(number.size()); ++v)
    BOOST_TEST(number[v] == (v < vertices ? v : -1));
}

BOOST_AUTO_TEST_CASE(collapses_keep_curves)
{
  // a closed curve around a vertex
  Curve_mesh mesh = curve_mesh_of(generated::icosphere(3));
  for (const int h : mesh.outgoing(0)) {
    mesh.curve[Curve_mesh::next(h)] = 0;
    mesh.curve[mesh.opposite(Curve_mesh::next(h))] = 1;
  }
  const auto length = [&] { return std::count(mesh.curve.begin(), mesh.curve.end(), 0); };
  const auto before = length();
  const int outside = mesh.target(mesh.opposite(Curve_mesh::next(mesh.outgoing(0).front())));
  // a vertex on the curve goes along it
  for (const int h : mesh.outgoing(outside))
    if (mesh.curve[h] >= 0 && common_neighbours(mesh, outside, mesh.target(h)) == 2) {
      mesh.collapse(h);
      break;
    }
  BOOST_TEST(length() == before - 1);
  // so do vertices beside it, which hand the curve on to the faces behind
  int moved = 0;
  for (int v = 0; v < int(mesh.points.size()) && moved < 20; ++v) {
    const std::vector<int> around = mesh.outgoing(v);
    const bool is_beside = v != 0 && std::none_of(around.begin(), around.end(),
                                                  [&](int h) { return mesh.curve[h] >= 0; });
    for (const int h : around)
      if (is_beside && !mesh.is_removed(v) && common_neighbours(mesh, v, mesh.target(h)) == 2) {
        mesh.collapse(h);
        ++moved;
      }
  }
  mesh.compact();
  check(mesh);
  BOOST_TEST(moved == 20);
  BOOST_TEST(length() == before - 1);
  BOOST_TEST(length() == std::count(mesh.curve.begin(), mesh.curve.end(), 1));
}

// Beyond the border are triangles with a vertex at infinity, until they are removed.
BOOST_AUTO_TEST_CASE(the_outside)
{
  Curve_mesh mesh = curve_mesh_of(generated::plate_with_holes(3, 3, {{1, 1}}, 2));
  const int vertices = int(mesh.points.size()), faces = int(mesh.triangles().size());
  for (int h = 0; h < 200; ++h)
    if (mesh.source(h) < vertices && mesh.target(h) < vertices)
      mesh.split(h);
  for (int u = int(mesh.points.size()) - 1; u >= vertices; --u)
    for (const int h : mesh.outgoing(u))
      if (mesh.target(h) < vertices && !mesh.is_removed(u) &&
          (mesh.border_halfedge_from(u) < 0 || mesh.is_border_edge(h)) &&
          common_neighbours(mesh, u, mesh.target(h)) == (mesh.is_border_edge(h) ? 1 : 2)) {
        mesh.collapse(h);
        break;
      }
  mesh.compact();
  BOOST_TEST(int(mesh.points.size()) == vertices);
  int outer = 0, wrong = 0;
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    outer += mesh.is_outer(h);
    wrong += mesh.source(h) < 0 || mesh.source(h) >= vertices;
    wrong += mesh.opposite(mesh.opposite(h)) != h ||
             mesh.source(mesh.opposite(h)) != mesh.target(h);
  }
  BOOST_TEST(outer == 3 * 32); // of 24 edges around the plate, 8 around its hole
  BOOST_TEST(wrong == 0);
  mesh.remove_outside();
  mesh.compact();
  BOOST_TEST(mesh.infinite_vertex() == -1);
  const Triangle_surface surface(mesh.points, mesh.triangles());
  BOOST_TEST(surface.number_of_faces() == faces);
  BOOST_TEST(surface.number_of_vertices() == vertices - 1);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    BOOST_TEST(mesh.opposite(h) == surface.opposite(h));
}

BOOST_AUTO_TEST_SUITE_END()
