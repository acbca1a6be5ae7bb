// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CHARTED_MESH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CHARTED_MESH_H

#include <CGAL/Quad_layouts/internal/embedding/Layout_charts.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A triangle mesh with a chart per face, whose edges can be split.
//
// Halfedges are numbered as in Triangle_surface. New vertices and faces are appended; a face keeps
// its number and chart when it is split, and its new part gets the same chart.
class Charted_mesh
{
public:
  explicit Charted_mesh(const Triangle_surface& surface)
    : points(surface.points()), transition(surface.number_of_halfedges()),
      cone_position(surface.number_of_halfedges(), Point2(0, 0)),
      direction(surface.number_of_faces())
  {
    for (int h = 0; h < surface.number_of_halfedges(); ++h) {
      m_source.push_back(surface.source(h));
      m_opposite.push_back(surface.opposite(h));
    }
    for (int v = 0; v < surface.number_of_vertices(); ++v)
      m_vertex_halfedge.push_back(surface.halfedge(v));
  }

  static int next(int h) { return Triangle_surface::next(h); }
  static int prev(int h) { return Triangle_surface::prev(h); }
  int number_of_halfedges() const { return int(m_source.size()); }
  int number_of_faces() const { return number_of_halfedges() / 3; }
  int source(int h) const { return m_source[h]; }
  int target(int h) const { return m_source[next(h)]; }
  int opposite(int h) const { return m_opposite[h]; }

  // the halfedges that leave v, counter-clockwise
  std::vector<int> outgoing(int v) const
  {
    std::vector<int> result;
    int h = m_vertex_halfedge[v];
    if (h >= 0)
      do {
        result.push_back(h);
        h = m_opposite[prev(h)];
      } while (h != m_vertex_halfedge[v]);
    return result;
  }

  Point normal(int f) const
  {
    const Point &p = points[m_source[3 * f]], &q = points[m_source[3 * f + 1]],
                &r = points[m_source[3 * f + 2]];
    return (q - p).cross(r - p).normalized();
  }

  std::vector<std::array<int, 3>> triangles() const
  {
    std::vector<std::array<int, 3>> result;
    for (int h = 0; h < number_of_halfedges(); h += 3)
      result.push_back({m_source[h], m_source[h + 1], m_source[h + 2]});
    return result;
  }

  // inserts a vertex into the edge of h, at the fraction `t` of the way along h; returns it
  int split(int h, double t = 0.5)
  {
    const int m = int(points.size()), v = target(h), twin = m_opposite[h];
    points.push_back((1 - t) * points[m_source[h]] + t * points[v]);
    // the faces of h and its twin keep their corners at the source of h; the rest goes to new faces
    const int front = split_face(h, m, false), back = split_face(twin, m, true);
    glue(front, back, transition[h]);
    m_vertex_halfedge.push_back(front);
    m_vertex_halfedge[v] = back;
    return m;
  }

  std::vector<Point> points;
  std::vector<Chart_change>
      transition; // per halfedge, from the chart of its face to that on the other side
  std::vector<Point2> cone_position; // per corner of a cone: its place in the chart of the face
  std::vector<Point>
      direction; // per face: a unit vector in space along which +x of its chart should point

private:
  // Cuts the face of h from a new vertex m on h to the opposite corner. The part at the target of h
  // becomes a new face, or that at the source if `keep_target`. Returns the half of h that is in
  // the new face.
  int split_face(int h, int m, bool keep_target)
  {
    const int n = next(h), p = prev(h), first = number_of_halfedges();
    const std::array<int, 3> corners = keep_target
                                           ? std::array<int, 3>{m_source[h], m, m_source[p]}
                                           : std::array<int, 3>{m, m_source[n], m_source[p]};
    const std::array<int, 3> old = keep_target ? std::array<int, 3>{h, h, p}
                                               : std::array<int, 3>{h, n, p};
    for (int k = 0; k < 3; ++k) {
      m_source.push_back(corners[k]);
      m_opposite.push_back(-1);
      transition.push_back({});
      cone_position.push_back(cone_position[old[k]]);
    }
    direction.push_back(Point(direction[h / 3]));
    // of the two sides of the old face beside h, one moves to the new face and the cut takes its
    // place
    const int moved = keep_target ? p : n, heir = keep_target ? first + 2 : first + 1;
    const int cut = keep_target ? first + 1 : first + 2;
    glue(heir, m_opposite[moved], transition[moved]);
    glue(moved, cut, {});
    m_vertex_halfedge[m_source[p]] = keep_target ? first + 2 : p;
    m_source[keep_target ? h : n] = m;
    return first;
  }

  void glue(int h, int g, const Chart_change& change)
  {
    m_opposite[h] = g;
    m_opposite[g] = h;
    transition[h] = change;
    transition[g] = change.inverse();
  }

  std::vector<int> m_source, m_opposite, m_vertex_halfedge;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CHARTED_MESH_H
