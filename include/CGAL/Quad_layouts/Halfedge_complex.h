// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_HALFEDGE_COMPLEX_H
#define CGAL_QUAD_LAYOUTS_HALFEDGE_COMPLEX_H

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsClasses

is an oriented cell complex on a surface, with or without border, stored as a halfedge structure in
index arrays.

It is the common base of `T_mesh` and `Quad_layout`. Unlike most mesh structures it allows what
coarse layouts need: an edge may be a loop, a face may touch itself along an edge or in a vertex,
two vertices may be joined by several edges (a torus can have a single face).

Vertices, edges, halfedges and faces are numbered from 0. Edge `e` has the halfedges `2e` and
`2e+1`; halfedge `h` has its face on its left. Halfedges on the border have the face -1, and are
linked to the next ones along the border.

`Halfedge_complex` and the classes derived from it are models of `FaceListGraph` and
`HalfedgeListGraph`: include `CGAL/Quad_layouts/graph_traits_Halfedge_complex.h`.
*/
class Halfedge_complex
{
public:
  using Point = Eigen::Vector3d;

  int number_of_vertices() const { return int(vertex_halfedge.size()); }
  int number_of_halfedges() const { return int(halfedge_target.size()); }
  int number_of_edges() const { return number_of_halfedges() / 2; }
  int number_of_faces() const { return int(face_halfedge.size()); }
  /// returns the Euler characteristic.
  int euler_characteristic() const
  {
    return number_of_vertices() - number_of_edges() + number_of_faces();
  }

  static int opposite(int h) { return h ^ 1; }
  static int edge(int h) { return h / 2; }
  int target(int h) const { return halfedge_target[h]; }
  int source(int h) const { return halfedge_target[h ^ 1]; }
  int next(int h) const { return halfedge_next[h]; }
  /// returns the face on the left of `h`, -1 if there is none.
  int face(int h) const { return halfedge_face[h]; }
  bool is_border(int h) const { return halfedge_face[h] < 0; }
  bool is_border_edge(int e) const { return is_border(2 * e) || is_border(2 * e + 1); }
  /// returns the halfedge before `h` in its face, in time linear in the face's length.
  int prev(int h) const
  {
    int g = h;
    while (next(g) != h)
      g = next(g);
    return g;
  }
  /// returns a halfedge whose *source* is `v`, -1 if there is none; on the border the one that has
  /// the border on its right.
  int halfedge_from(int v) const { return vertex_halfedge[v]; }
  /// returns a halfedge of face `f`.
  int halfedge_of(int f) const { return face_halfedge[f]; }
  /// returns the next halfedge with the same source, clockwise.
  int turn_right(int h) const { return next(opposite(h)); }
  /// returns the next halfedge with the same source, counter-clockwise.
  int turn_left(int h) const { return opposite(prev(h)); }
  bool is_on_border(int v) const
  {
    return vertex_halfedge[v] >= 0 && is_border(opposite(vertex_halfedge[v]));
  }
  const Point& point(int v) const { return vertex_point[v]; }

  /// \name The arrays
  /// They are filled by the functions that make a complex.
  /// @{
  std::vector<int> halfedge_target, halfedge_next, halfedge_face;
  std::vector<int> vertex_halfedge, face_halfedge;
  std::vector<Point> vertex_point;
  /// @}
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_HALFEDGE_COMPLEX_H
