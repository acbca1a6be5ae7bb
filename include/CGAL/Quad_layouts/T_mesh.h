// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_T_MESH_H
#define CGAL_QUAD_LAYOUTS_T_MESH_H

#include <CGAL/Quad_layouts/Halfedge_complex.h>
#include <CGAL/Quad_layouts/Layout_route.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <array>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsClasses

is a T-mesh: a partition of a surface into four-sided patches by the traces of an extended
motorcycle graph
(\cgalCite{lck-sqlrs-21}, Section 3.1).

As a cell complex its vertices are called *nodes*, its edges *arcs*, its faces *patches*. Node kinds
are singularities and seeds (both at a vertex of the surface), crossings of two traces, and
T-joints, where a trace ends on another. *Fixed* curves, like the border, are made of traces, too,
which run from one of their singularities or seeds to the next, on the border with the surface on
their left; the last arc of each ends there. Arc `a` belongs to one trace; its halfedge `2a` points
the way the trace runs.

A patch is a disc with four corners; `is_corner(h)` says that the patch of `h` has a corner between
`h` and `next(h)`. A patch's *side* is a maximal chain of halfedges without a corner inside.
`halfedge_of(p)` is the first halfedge of a side.
*/
class T_mesh : public Halfedge_complex
{
public:
  /// is the path of one motorcycle.
  struct Trace
  {
    int start;             ///< the node (singularity or seed) where it begins
    std::vector<int> arcs; ///< its arcs in the order of travel; arc `a` is run along halfedge `2a`
  };

  /// says that trace `trace` passes (or ends in) a node after its first `arcs` arcs.
  struct Visit
  {
    int trace;
    int arcs;
  };

  /// is a place where an arc crosses an edge of the surface.
  struct Crossing
  {
    int halfedge; ///< of the surface, in the face that the arc enters
    int position; ///< of the place in the list `edge_crossings` of the edge
  };

  using Surface = internal::Triangle_surface;

  const Surface& surface() const { return *surface_pointer; }

  double length(int arc) const { return arc_length[arc]; }
  int trace(int arc) const { return arc_trace[arc]; }
  /// says if an arc is part of a fixed curve.
  bool is_fixed(int arc) const
  {
    return is_border_edge(arc) || (arc < int(arc_pieces.size()) && !arc_pieces[arc].empty());
  }
  /// returns the number of arcs of fixed curves at node `n`.
  int number_of_fixed_arcs(int n) const
  {
    int result = 0, h = halfedge_from(n);
    do {
      result += is_fixed(edge(h));
      h = turn_right(h);
    } while (h != halfedge_from(n));
    return result;
  }
  /// says if node `n` is on a fixed curve.
  bool is_on_fixed_curve(int n) const { return is_on_border(n) || number_of_fixed_arcs(n) > 0; }
  bool is_corner(int h) const { return halfedge_is_corner[h] != 0; }
  /// returns the vertex of the surface at which node `n` lies, -1 for crossings and T-joints.
  int surface_vertex(int n) const { return node_surface_vertex[n]; }
  /// returns the index of node `n` in quarters; 0 for crossings, T-joints and seeds. On the border
  /// it is two minus the number of quadrants.
  int index(int n) const { return node_index[n]; }
  /// says if traces begin at node `n`.
  bool is_singularity_or_seed(int n) const { return node_surface_vertex[n] >= 0; }

  /// returns the four sides of patch `p` in counter-clockwise order, beginning with
  /// `halfedge_of(p)`.
  std::array<std::vector<int>, 4> sides(int p) const
  {
    std::array<std::vector<int>, 4> result;
    int h = halfedge_of(p);
    for (auto& side : result)
      do {
        side.push_back(h);
        h = next(h);
      } while (!is_corner(side.back()));
    CGAL_postcondition(h == halfedge_of(p));
    return result;
  }

  /// \name The arrays
  /// @{
  std::shared_ptr<const Surface> surface_pointer;
  Layout_route route = FIELD; ///< what the traces run in: `FIELD` or `PARAMETRIZATION`
  std::vector<double>
      arc_length; ///< on the surface; by the route `PARAMETRIZATION` in the map, and exact
  std::vector<int> arc_trace;
  std::vector<char> halfedge_is_corner;
  std::vector<int> node_surface_vertex;
  std::vector<int> node_index;
  std::vector<Trace> traces;
  /// per node the passing traces: none at singularities and seeds, else two (the second one ends
  /// here at a T-joint or both pass). A trace that crosses itself is listed twice. The second visit
  /// is that of the longer trace: l_ij > l_ji for i the second and j the first, equal lengths being
  /// ordered by the numbers of the traces. On fixed curves the second visit is that of the other
  /// trace.
  std::vector<std::vector<Visit>> node_visits;

  /// per edge of the surface the halfedges of the arcs that cross it, in order from the source of
  /// `surface().halfedge_of_edge(e)` to its target; the patch of each is on the side of that
  /// source.
  std::vector<std::vector<int>> edge_crossings;
  /// per edge of the surface the halfedges of the arcs that run along it, in order along
  /// `surface().halfedge_of_edge(e)` and in that direction; empty unless it is fixed.
  std::vector<std::vector<int>> edge_arcs;
  /// where each of `edge_crossings`, or each node between two of `edge_arcs`, lies: the fraction of
  /// the edge before it. It never decreases along an edge; where lines converge beyond the
  /// resolution of numbers it stays the same.
  std::vector<std::vector<double>> crossing_parameters;
  /// per arc the edges of the surface that it crosses, in the order of travel; none on fixed
  /// curves.
  std::vector<std::vector<Crossing>> arc_crossings;
  /// per arc of a fixed curve the pieces of edges that it runs along, in the order of travel: the
  /// halfedge of the surface in its direction, and the position in `edge_arcs`; empty for others.
  std::vector<std::vector<Crossing>> arc_pieces;
  /// per corner (halfedge of the surface) the halfedges of the arcs that leave the node at its
  /// source into its face, counter-clockwise; empty away from nodes. Arcs along edges are not among
  /// them.
  std::vector<std::vector<int>> corner_arcs;
  /// @}
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_T_MESH_H
