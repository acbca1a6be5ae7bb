// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_ASSEMBLE_LAYOUT_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_ASSEMBLE_LAYOUT_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/internal/layout/glued_squares.h>
#include <CGAL/Quad_layouts/internal/layout/quotient.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The side on the border that ends where another one, s, begins.
inline int border_side_before(const Glued_squares& squares, int s)
{
  int before = Glued_squares::prev(s);
  while (squares.opposite(before) >= 0)
    before = Glued_squares::prev(squares.opposite(before));
  return before;
}

// Makes halfedges of the sides of squares; square s becomes face s. Returns the halfedge of each
// side.
inline std::vector<int> assemble_halfedges(const Glued_squares& squares, Quad_layout& layout)
{
  const int n = squares.number_of_sides();
  std::vector<int> side_of_halfedge, halfedge_of_side(n);
  for (int s = 0; s < n; ++s)
    if (const int twin = squares.opposite(s); twin < 0 || s < twin)
      for (int side : {s, twin}) {
        if (side >= 0)
          halfedge_of_side[side] = int(side_of_halfedge.size());
        side_of_halfedge.push_back(side);
      }
  layout.vertex_halfedge.assign(squares.number_of_vertices(), -1);
  for (std::size_t h = 0; h < side_of_halfedge.size(); ++h) {
    const int s = side_of_halfedge[h];
    if (s < 0) { // on the border, opposite the side of the halfedge before
      const int inner = side_of_halfedge[h - 1];
      layout.halfedge_target.push_back(squares.vertex(inner));
      layout.halfedge_next.push_back(halfedge_of_side[border_side_before(squares, inner)] + 1);
      layout.halfedge_face.push_back(-1);
      layout.vertex_halfedge[squares.vertex(inner)] = int(h) - 1;
      continue;
    }
    layout.halfedge_target.push_back(squares.vertex(Glued_squares::next(s)));
    layout.halfedge_next.push_back(halfedge_of_side[Glued_squares::next(s)]);
    layout.halfedge_face.push_back(s / 4);
    if (!squares.is_on_border(squares.vertex(s)))
      layout.vertex_halfedge[squares.vertex(s)] = int(h);
  }
  for (int s = 0; s < n; s += 4)
    layout.face_halfedge.push_back(halfedge_of_side[s]);
  return halfedge_of_side;
}

// Says what patches and arcs of the T-mesh have become.
inline void relate_to_t_mesh(const Glued_squares& squares, const std::vector<int>& halfedge_of_side,
                             Quad_layout& layout)
{
  const Arc_grid& grid = squares.grid();
  layout.grids.resize(grid.t_mesh().number_of_faces());
  for (int p = 0; p < grid.t_mesh().number_of_faces(); ++p) {
    layout.grids[p].width = grid.width(p);
    layout.grids[p].height = grid.height(p);
    for (int i = 0; i < grid.width(p) * grid.height(p); ++i)
      layout.grids[p].squares.push_back(halfedge_of_side[4 * (squares.first_square(p) + i)]);
  }
  layout.arc_halfedges.resize(grid.t_mesh().number_of_edges());
  layout.edge_is_fixed.assign(layout.number_of_edges(), 0);
  for (int s = 0; s < grid.number_of_half_segments(); s += 2) {
    const int left = squares.side_on(s);
    layout.arc_halfedges[grid.arc(s)].push_back(
        left >= 0 ? halfedge_of_side[left]
                  : Quad_layout::opposite(halfedge_of_side[squares.side_on(s + 1)]));
    if (grid.t_mesh().is_fixed(grid.arc(s)))
      layout.edge_is_fixed[Quad_layout::edge(layout.arc_halfedges[grid.arc(s)].back())] = 1;
  }
}

// Gives clusters and nodes their vertices; `vertex_of_fibre` is that of `vertex_of_fibres`.
inline void place_clusters(const Fibres& fibres, const std::vector<int>& vertex_of_fibre,
                           const std::vector<Merged_cluster>& clusters, Quad_layout& layout)
{
  const auto vertex_of_node = [&](int n) { return vertex_of_fibre[fibres.fibre_of_point(n)]; };
  for (int n = 0; n < fibres.grid().t_mesh().number_of_vertices(); ++n)
    layout.node_vertex.push_back(vertex_of_node(n));
  for (const Merged_cluster& c : clusters)
    layout.clusters.push_back({vertex_of_node(c.nodes.front()), c.index, c.nodes});
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_ASSEMBLE_LAYOUT_H
