// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CURVE_MESH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CURVE_MESH_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A triangle mesh with curves along its edges, which can be split and collapsed.
//
// Halfedges are numbered as in Triangle_surface. Beyond the border there are *outer* triangles,
// each of which joins an edge of the border to one vertex at infinity: so all edges have two
// halfedges, and the structure is closed. New vertices and faces are appended. When a halfedge is
// split, those that leave its source keep their numbers. What collapses remove stays in the arrays,
// without connections, until `compact()`.
class Curve_mesh
{
public:
  explicit Curve_mesh(const Triangle_surface& surface)
    : points(surface.points()), curve(surface.number_of_halfedges(), -1),
      is_original(surface.number_of_halfedges(), 0), is_fixed(surface.number_of_halfedges(), 0)
  {
    for (int h = 0; h < surface.number_of_halfedges(); ++h) {
      m_source.push_back(surface.source(h));
      m_opposite.push_back(surface.opposite(h));
    }
    for (int v = 0; v < surface.number_of_vertices(); ++v)
      m_vertex_halfedge.push_back(surface.halfedge(v));
    add_outer_triangles(surface);
  }

  static int next(int h) { return Triangle_surface::next(h); }
  static int prev(int h) { return Triangle_surface::prev(h); }
  int number_of_halfedges() const { return int(m_source.size()); }
  int number_of_faces() const { return number_of_halfedges() / 3; }
  int source(int h) const { return m_source[h]; }
  int target(int h) const { return m_source[next(h)]; }
  int opposite(int h) const { return m_opposite[h]; }

  // the vertex at infinity, -1 if there is none
  int infinite_vertex() const { return m_infinite_vertex; }
  // whether h is a side of an outer triangle
  bool is_outer(int h) const
  {
    return m_infinite_vertex >= 0 &&
           (m_source[h] == m_infinite_vertex || target(h) == m_infinite_vertex ||
            m_source[prev(h)] == m_infinite_vertex);
  }
  bool is_border_edge(int h) const { return is_outer(h) != is_outer(m_opposite[h]); }
  bool is_on_fixed_curve(int v) const
  {
    bool result = false;
    for_each_outgoing(v, [&](int h) { result |= is_fixed[h] != 0; });
    return result;
  }

  bool is_removed(int v) const { return m_vertex_halfedge[v] < 0; }

  // calls `visit` for the halfedges that leave v, except that to infinity, counter-clockwise
  template <class Visit>
  void for_each_outgoing(int v, Visit&& visit) const
  {
    for_each_around(v, [&](int h) {
      if (target(h) != m_infinite_vertex)
        visit(h);
    });
  }

  // the halfedge on the border that leaves v, with the surface on its left; -1 if v is not on the
  // border
  int border_halfedge_from(int v) const
  {
    int result = -1;
    for_each_outgoing(v, [&](int h) {
      if (!is_outer(h) && is_outer(m_opposite[h]))
        result = h;
    });
    return result;
  }

  std::vector<int> outgoing(int v) const
  {
    std::vector<int> result;
    for_each_outgoing(v, [&](int h) { result.push_back(h); });
    return result;
  }

  // the halfedge from u to v, -1 if there is none
  int halfedge_between(int u, int v) const
  {
    int result = -1;
    for_each_outgoing(u, [&](int h) {
      if (target(h) == v)
        result = h;
    });
    return result;
  }

  // without the outer ones
  std::vector<std::array<int, 3>> triangles() const
  {
    std::vector<std::array<int, 3>> result;
    for (int h = 0; h < number_of_halfedges(); h += 3)
      if (!is_outer(h))
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
    glue(front, back);
    curve[front] = curve[h];
    curve[back] = curve[twin];
    is_original[front] = is_original[back] = is_original[h];
    is_fixed[front] = is_fixed[back] = is_fixed[h];
    m_vertex_halfedge.push_back(front);
    m_vertex_halfedge[v] = back;
    return m;
  }

  // Moves the source of h to its target, which removes the source and the faces on both sides of h.
  // The ends of h must have two common neighbours.
  void collapse(int h)
  {
    const int u = m_source[h], v = target(h), twin = m_opposite[h];
    for_each_around(u, [&](int g) { m_source[g] = v; });
    m_vertex_halfedge[u] = -1;
    m_vertex_halfedge[v] = close(next(h), prev(h));
    m_vertex_halfedge[m_source[m_opposite[next(twin)]]] = m_opposite[next(twin)];
    close(next(twin), prev(twin));
    remove_face(h);
    remove_face(twin);
  }

  // Removes what lies beyond the border: from now on, the opposite of a halfedge on it is -1.
  void remove_outside()
  {
    for (int v = 0; v < int(points.size()); ++v)
      if (const int h = is_removed(v) ? -1 : border_halfedge_from(v); h >= 0)
        m_vertex_halfedge[v] = h;
    for (int h = 0; h < number_of_halfedges(); ++h)
      if (is_outer(h) && !is_outer(m_opposite[h]))
        m_opposite[m_opposite[h]] = -1;
    for (int h = 0; h < number_of_halfedges(); h += 3)
      if (is_outer(h))
        remove_face(h);
    if (m_infinite_vertex >= 0)
      m_vertex_halfedge[std::exchange(m_infinite_vertex, -1)] = -1;
  }

  // Gives new numbers, in the old order, to the vertices and faces that are left. Returns those of
  // the vertices, -1 for removed ones.
  std::vector<int> compact()
  {
    std::vector<int> new_vertex(points.size(), -1), new_halfedge(m_source.size(), -1);
    int vertices = 0, halfedges = 0;
    for (int v = 0; v < int(points.size()); ++v)
      if (!is_removed(v)) {
        new_vertex[v] = vertices++;
        points[new_vertex[v]] = points[v];
        m_vertex_halfedge[new_vertex[v]] = m_vertex_halfedge[v];
      }
    for (int h = 0; h < number_of_halfedges(); ++h)
      if (m_source[h] >= 0)
        new_halfedge[h] = halfedges++;
    for (int h = 0; h < number_of_halfedges(); ++h)
      if (const int g = new_halfedge[h]; g >= 0) {
        m_source[g] = new_vertex[m_source[h]];
        m_opposite[g] = m_opposite[h] < 0 ? -1 : new_halfedge[m_opposite[h]];
        curve[g] = curve[h];
        is_original[g] = is_original[h];
        is_fixed[g] = is_fixed[h];
      }
    if (m_infinite_vertex >= 0)
      m_infinite_vertex = new_vertex[m_infinite_vertex];
    points.resize(vertices);
    m_vertex_halfedge.resize(vertices);
    for (int& h : m_vertex_halfedge)
      h = new_halfedge[h];
    m_source.resize(halfedges);
    m_opposite.resize(halfedges);
    curve.resize(halfedges);
    is_original.resize(halfedges);
    is_fixed.resize(halfedges);
    return new_vertex;
  }

  std::vector<Point> points;
  std::vector<int> curve;        // per halfedge: what it runs along, or -1
  std::vector<char> is_original; // per halfedge: whether it is part of an edge of the surface
  std::vector<char> is_fixed;    // per halfedge: whether this edge is fixed

private:
  template <class Visit>
  void for_each_around(int v, Visit&& visit) const
  {
    int h = m_vertex_halfedge[v];
    if (h >= 0)
      do {
        visit(h);
        h = m_opposite[prev(h)];
      } while (h >= 0 && h != m_vertex_halfedge[v]);
  }

  void add_outer_triangles(const Triangle_surface& surface)
  {
    std::vector<int> outer(surface.number_of_halfedges(), -1);
    for (int h = 0; h < surface.number_of_halfedges(); ++h)
      if (surface.is_border(h)) {
        if (m_infinite_vertex < 0)
          add_infinite_vertex();
        outer[h] = number_of_halfedges();
        m_source.insert(m_source.end(), {surface.target(h), surface.source(h), m_infinite_vertex});
        m_opposite.insert(m_opposite.end(), 3, -1);
        curve.insert(curve.end(), 3, -1);
        is_original.insert(is_original.end(), 3, 0);
        is_fixed.insert(is_fixed.end(), 3, 0);
        glue(h, outer[h]);
        m_vertex_halfedge[m_infinite_vertex] = outer[h] + 2;
      }
    for (int h = 0; h < surface.number_of_halfedges(); ++h)
      if (surface.is_border(h))
        glue(outer[h] + 1, outer[surface.border_halfedge_to(surface.source(h))] + 2);
  }

  void add_infinite_vertex()
  {
    m_infinite_vertex = int(points.size());
    points.emplace_back(0, 0, 0);
    m_vertex_halfedge.push_back(-1);
  }

  // Cuts the face of h from a new vertex m on h to the opposite corner. The part at the target of h
  // becomes a new face, or that at the source if `keep_target`. Returns the half of h that is in
  // the new face.
  int split_face(int h, int m, bool keep_target)
  {
    const int n = next(h), p = prev(h), first = number_of_halfedges();
    const std::array<int, 3> corners = keep_target
                                           ? std::array<int, 3>{m_source[h], m, m_source[p]}
                                           : std::array<int, 3>{m, m_source[n], m_source[p]};
    for (const int corner : corners) {
      m_source.push_back(corner);
      m_opposite.push_back(-1);
      curve.push_back(-1);
      is_original.push_back(0);
      is_fixed.push_back(0);
    }
    // of the two sides of the old face beside h, one moves to the new face and the cut takes its
    // place
    const int moved = keep_target ? p : n, heir = keep_target ? first + 2 : first + 1;
    const int cut = keep_target ? first + 1 : first + 2;
    glue(heir, m_opposite[moved]);
    curve[heir] = std::exchange(curve[moved], -1);
    is_original[heir] = std::exchange(is_original[moved], 0);
    is_fixed[heir] = std::exchange(is_fixed[moved], 0);
    glue(moved, cut);
    m_vertex_halfedge[m_source[p]] = keep_target ? first + 2 : p;
    m_source[keep_target ? h : n] = m;
    return first;
  }

  // removes the face of h; what lies around it is not told
  void remove_face(int h)
  {
    for (int g = 3 * (h / 3), k = 0; k < 3; ++g, ++k) {
      m_source[g] = curve[g] = -1;
      is_original[g] = is_fixed[g] = 0;
    }
  }

  // joins what lies behind two sides of a face; returns what was behind the second
  int close(int first, int second)
  {
    const int a = m_opposite[first], b = m_opposite[second];
    curve[a] = (std::max)(curve[a], curve[second]);
    curve[b] = (std::max)(curve[b], curve[first]);
    is_original[a] = is_original[b] = is_original[a] | is_original[b];
    is_fixed[a] = is_fixed[b] = is_fixed[a] | is_fixed[b];
    glue(a, b);
    m_vertex_halfedge[m_source[a]] = a;
    return b;
  }

  void glue(int h, int g)
  {
    m_opposite[h] = g;
    m_opposite[g] = h;
  }

  std::vector<int> m_source, m_opposite, m_vertex_halfedge;
  int m_infinite_vertex = -1;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CURVE_MESH_H
