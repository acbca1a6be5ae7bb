// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_REFINE_AROUND_CONES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_REFINE_AROUND_CONES_H

#include <CGAL/Quad_layouts/internal/embedding/Charted_mesh.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A surface vertex that is held at an integer point of the map.
struct Cone
{
  int vertex;
  int index;   // in quarters; the map spans 4 - index quarter-turns around it
  int cluster; // of the layout
};

// splits edges opposite to `v`, those of the widest corners first, until v has `degree` neighbours
inline void raise_degree(Charted_mesh& mesh, int v, int degree)
{
  for (;;) {
    const std::vector<int> spokes = mesh.outgoing(v);
    if (int(spokes.size()) >= degree)
      return;
    const auto corner_angle = [&](int h) {
      const Point a = mesh.points[mesh.target(h)] - mesh.points[v];
      const Point b = mesh.points[mesh.source(Charted_mesh::prev(h))] - mesh.points[v];
      return std::atan2(a.cross(b).norm(), a.dot(b));
    };
    mesh.split(
        Charted_mesh::next(*std::max_element(spokes.begin(), spokes.end(), [&](int g, int h) {
          return corner_angle(g) < corner_angle(h);
        })));
  }
}

// Gives every cone two rings of vertices of its own: no vertex is then next to two cones, no edge
// joins the inner rings of two cones, and there are at least two triangles per quarter-turn, so
// that none needs to be wide. Without this a valid map need not exist on the mesh: two held
// vertices joined by an edge may belong to one layout point, and three triangles cannot span five
// quarter-turns.
inline void refine_around_cones(Charted_mesh& mesh, const std::vector<Cone>& cones)
{
  std::vector<char> cone_mark(mesh.points.size(), 0);
  for (const Cone& c : cones)
    cone_mark[c.vertex] = 1;
  const auto is_cone = [&](int v) { return v < int(cone_mark.size()) && cone_mark[v] != 0; };
  // to the end of the halfedges by then: a split gives new numbers to edges beside it
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (is_cone(mesh.source(h)) && is_cone(mesh.target(h)))
      mesh.split(h);
  for (const Cone& c : cones)
    raise_degree(mesh, c.vertex, 2 * (4 - c.index));
  for (int ring = 0; ring < 2; ++ring)
    for (const Cone& c : cones)
      for (const int h : mesh.outgoing(c.vertex))
        mesh.split(h);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_REFINE_AROUND_CONES_H
