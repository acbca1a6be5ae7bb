// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TEST_HAND_MADE_T_MESHES_H
#define CGAL_QUAD_LAYOUTS_TEST_HAND_MADE_T_MESHES_H

#include <CGAL/Quad_layouts/T_mesh.h>

#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace hand_made {

using CGAL::Quad_layouts::T_mesh;
using Point = T_mesh::Point;

// The four sides of a patch, counter-clockwise, each a list of halfedges.
using Sides = std::array<std::vector<int>, 4>;

// Makes a T-mesh in which each arc is a trace of its own. A node is marked as a singularity if the
// number of corners around it is not that of a crossing or a T-joint; others are marked by `seeds`.
// Lengths are 1.
inline T_mesh make_t_mesh(const std::vector<Point>& points,
                          const std::vector<std::pair<int, int>>& arcs,
                          const std::vector<Sides>& patches, const std::vector<int>& seeds = {})
{
  T_mesh t;
  const int nv = int(points.size()), ne = int(arcs.size());
  t.vertex_point = points;
  t.vertex_halfedge.assign(nv, -1);
  t.halfedge_target.resize(2 * ne);
  t.halfedge_next.assign(2 * ne, -1);
  t.halfedge_face.assign(2 * ne, -1);
  t.halfedge_is_corner.assign(2 * ne, 0);
  t.arc_length.assign(ne, 1);
  t.node_surface_vertex.assign(nv, -1);
  t.node_index.assign(nv, 0);
  t.node_visits.resize(nv);
  for (int a = 0; a < ne; ++a) {
    t.halfedge_target[2 * a] = arcs[a].second;
    t.halfedge_target[2 * a + 1] = arcs[a].first;
    t.vertex_halfedge[arcs[a].first] = 2 * a;
    t.vertex_halfedge[arcs[a].second] = 2 * a + 1;
    t.arc_trace.push_back(a);
    t.traces.push_back({arcs[a].first, {a}});
  }
  for (const Sides& sides : patches) {
    std::vector<int> loop;
    for (const auto& side : sides) {
      loop.insert(loop.end(), side.begin(), side.end());
      t.halfedge_is_corner[side.back()] = 1;
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
      t.halfedge_next[loop[i]] = loop[(i + 1) % loop.size()];
      t.halfedge_face[loop[i]] = int(t.face_halfedge.size());
    }
    t.face_halfedge.push_back(loop.front());
  }
  std::vector<int> corners(nv, 0), valence(nv, 0);
  for (int h = 0; h < 2 * ne; ++h) {
    ++valence[t.target(h)];
    corners[t.target(h)] += t.halfedge_is_corner[h];
  }
  for (int v = 0; v < nv; ++v)
    if (corners[v] != 4 && !(corners[v] == 2 && valence[v] == 3)) {
      t.node_index[v] = 4 - corners[v];
      t.node_surface_vertex[v] = v;
    }
  for (int v : seeds)
    t.node_surface_vertex[v] = v;
  return t;
}

// The unit cube. Node x + 2 y + 4 z; arcs 0 to 3 along x, 4 to 7 along y, 8 to 11 along z.
inline T_mesh cube()
{
  std::vector<Point> points;
  for (int v = 0; v < 8; ++v)
    points.emplace_back(v & 1, v >> 1 & 1, v >> 2);
  const std::vector<std::pair<int, int>> arcs = {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3},
                                                 {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  const auto halfedge = [&](int u, int v) {
    for (int a = 0;; ++a) {
      if (arcs[a] == std::make_pair(u, v))
        return 2 * a;
      if (arcs[a] == std::make_pair(v, u))
        return 2 * a + 1;
    }
  };
  std::vector<Sides> patches;
  for (const std::array<int, 4>& q : {std::array<int, 4>{0, 2, 3, 1},
                                      {4, 5, 7, 6},
                                      {0, 1, 5, 4},
                                      {2, 6, 7, 3},
                                      {0, 4, 6, 2},
                                      {1, 3, 7, 5}}) {
    Sides sides;
    for (int k = 0; k < 4; ++k)
      sides[k] = {halfedge(q[k], q[(k + 1) % 4])};
    patches.push_back(sides);
  }
  return make_t_mesh(points, arcs, patches);
}

// A torus of m x n patches, each node a seed. Node j m + i; arc 2 (j m + i) along i, the next one
// along j.
inline T_mesh torus(int m, int n)
{
  const double turn = 2 * CGAL_PI;
  std::vector<Point> points;
  std::vector<std::pair<int, int>> arcs;
  std::vector<Sides> patches;
  std::vector<int> seeds;
  const auto node = [&](int i, int j) { return (j % n) * m + i % m; };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      const double u = turn * i / m, v = turn * j / n, radius = 3 + std::cos(v);
      points.emplace_back(radius * std::cos(u), radius * std::sin(u), std::sin(v));
      seeds.push_back(node(i, j));
      arcs.emplace_back(node(i, j), node(i + 1, j));
      arcs.emplace_back(node(i, j), node(i, j + 1));
      patches.push_back({std::vector<int>{4 * node(i, j)},
                         {4 * node(i + 1, j) + 2},
                         {4 * node(i, j + 1) + 1},
                         {4 * node(i, j) + 3}});
    }
  return make_t_mesh(points, arcs, patches, seeds);
}

} // namespace hand_made

#endif // CGAL_QUAD_LAYOUTS_TEST_HAND_MADE_T_MESHES_H
