// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_TRIANGLE_SURFACE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_TRIANGLE_SURFACE_H

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

using Point = Eigen::Vector3d;
using Point2 = Eigen::Vector2d;

// The working copy of the input: an oriented, manifold triangle mesh in index arrays.
//
// Vertex v and face f are the v-th vertex and f-th face of the user's mesh, or the first part of
// that face. What is added when faces are divided comes behind. Face f owns the halfedges 3f, 3f+1,
// 3f+2; halfedge h runs from `source(h)` to `target(h)` with `face(h)` on its left. A halfedge also
// stands for the corner of its face at its source. Border halfedges do not exist: the opposite of a
// halfedge on the border is -1.
//
// *Fixed* edges form the curves that the field is aligned to, that are lines of the T-mesh and of
// the layout, and on which vertices of the quad mesh stay. Edges on the border are fixed.
//
// Each face has a frame: x along its halfedge 3f, y to the left of it. Angles in a face are in
// radians, counter-clockwise, in this frame. All of it is intrinsic: it needs lengths, not normals.
class Triangle_surface
{
public:
  Triangle_surface() = default;

  // takes faces whose directed edges are unique (checked) and whose vertices are manifold (not
  // checked)
  Triangle_surface(std::vector<Point> points, const std::vector<std::array<int, 3>>& triangles)
    : m_points(std::move(points))
  {
    m_source.reserve(3 * triangles.size());
    for (const auto& t : triangles)
      m_source.insert(m_source.end(), t.begin(), t.end());
    connect();
  }

  // takes the parts that the faces of `whole` are divided into: per part the face, and per added
  // vertex those, in order, that it lies in the middle of. Edges have to be fixed again.
  Triangle_surface(const Triangle_surface& whole, std::vector<Point> points,
                   const std::vector<std::array<int, 3>>& parts, const std::vector<int>& divided,
                   const std::vector<std::vector<int>>& parents)
    : Triangle_surface(std::move(points), parts)
  {
    m_original = whole.m_original ? whole.m_original
                                  : std::make_shared<const Triangle_surface>(whole);
    for (const int f : divided)
      m_origin.push_back(whole.origin(f));
    m_parents = whole.m_parents;
    m_parents.insert(m_parents.end(), parents.begin(), parents.end());
  }

  int number_of_vertices() const { return int(m_points.size()); }
  int number_of_halfedges() const { return int(m_source.size()); }
  int number_of_faces() const { return number_of_halfedges() / 3; }
  int number_of_edges() const { return int(m_edge_halfedge.size()); }

  static int face(int h) { return h / 3; }
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int prev(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
  int source(int h) const { return m_source[h]; }
  int target(int h) const { return m_source[next(h)]; }
  int opposite(int h) const { return m_opposite[h]; }

  // an outgoing halfedge of v, -1 if v is isolated; at a border vertex the most clockwise one, so
  // that turning counter-clockwise from it visits the whole fan
  int halfedge(int v) const { return m_vertex_halfedge[v]; }

  // the next outgoing halfedge counter-clockwise about source(h), -1 past the border
  int turn_left(int h) const { return m_opposite[prev(h)]; }
  // the next outgoing halfedge clockwise about source(h), -1 past the border
  int turn_right(int h) const { return m_opposite[h] < 0 ? -1 : next(m_opposite[h]); }

  // edges are numbered; each has a canonical halfedge, the smaller of the two
  int edge(int h) const { return m_edge[h]; }
  int halfedge_of_edge(int e) const { return m_edge_halfedge[e]; }

  // the surface before any faces were divided, with the elements of the user's mesh
  const Triangle_surface& original() const { return m_original ? *m_original : *this; }
  // the face of the user's mesh that f is, or is a part of
  int origin(int f) const { return m_original ? m_origin[f] : f; }
  // the vertices, in order, that v, which was added, lies in the middle of
  const std::vector<int>& parents(int v) const
  {
    return m_parents[v - original().number_of_vertices()];
  }

  bool is_border(int h) const { return m_opposite[h] < 0; }
  bool is_on_border(int v) const { return halfedge(v) >= 0 && is_border(halfedge(v)); }
  // the halfedge on the border that ends in v, a vertex on the border
  int border_halfedge_to(int v) const
  {
    int last = halfedge(v);
    for_each_outgoing(v, [&](int h) { last = h; });
    return prev(last);
  }

  // of a halfedge: whether its edge is fixed
  bool is_fixed(int h) const { return m_is_fixed[m_edge[h]] != 0; }
  // of a vertex
  int number_of_fixed_edges(int v) const
  {
    int result = is_on_border(v);
    for_each_outgoing(v, [&](int h) { result += is_fixed(h); });
    return result;
  }

  void fix(int h) { m_is_fixed[m_edge[h]] = 1; }
  // of a face: its fixed halfedge, -1 if it has none, one of them if it has several
  int fixed_halfedge(int f) const
  {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      if (is_fixed(h))
        return h;
    return -1;
  }

  // a halfedge of the fixed edge that goes on at v, an end of the fixed edge of h; -1 if none does,
  // or several do
  int other_fixed_halfedge(int h, int v) const
  {
    int result = -1, count = 0;
    const auto consider = [&](int g) {
      if (is_fixed(g) && edge(g) != edge(h)) {
        result = g;
        ++count;
      }
    };
    for_each_outgoing(v, consider);
    if (is_on_border(v))
      consider(border_halfedge_to(v));
    return count == 1 ? result : -1;
  }

  const Point& point(int v) const { return m_points[v]; }
  const std::vector<Point>& points() const { return m_points; }

  // calls f(h) for the outgoing halfedges of v in counter-clockwise order
  template <class F>
  void for_each_outgoing(int v, F&& f) const
  {
    const int first = halfedge(v);
    int h = first;
    if (h >= 0)
      do {
        f(h);
        h = turn_left(h);
      } while (h >= 0 && h != first);
  }

  Point vector(int h) const { return m_points[target(h)] - m_points[source(h)]; }
  double length(int h) const { return vector(h).norm(); }

  // twice the area of f as a vector along the normal
  Point area_vector(int f) const { return vector(3 * f).cross(-vector(3 * f + 2)); }
  double area(int f) const { return area_vector(f).norm() / 2; }
  Point normal(int f) const { return area_vector(f).normalized(); }

  // the angle at source(h) in face(h), in (0, pi)
  double corner_angle(int h) const
  {
    const Point a = vector(h), b = -vector(prev(h));
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  // the direction of h in the frame of its face
  double halfedge_angle(int h) const
  {
    switch (h % 3) {
      case 0: return 0;
      case 1: return CGAL_PI - corner_angle(h);
      default: return CGAL_PI + corner_angle(h - 2);
    }
  }

  // what must be added to an angle in the frame of face(h) to express it in the frame of
  // face(opposite(h)), the two faces being unfolded about their edge
  double transport(int h) const
  {
    return halfedge_angle(m_opposite[h]) - halfedge_angle(h) + CGAL_PI;
  }

  // the corners of f in its frame, the first at the origin
  std::array<Point2, 3> planar_corners(int f) const
  {
    const Point a = vector(3 * f), b = -vector(3 * f + 2);
    const double l = a.norm();
    return {Point2(0, 0), Point2(l, 0), Point2(a.dot(b) / l, a.cross(b).norm() / l)};
  }

  // the unit vector in space that has the angle `angle` in the frame of f
  Point direction(int f, double angle) const
  {
    const Point x = vector(3 * f).normalized(), n = normal(f);
    return std::cos(angle) * x + std::sin(angle) * n.cross(x);
  }

  double diagonal() const
  {
    if (m_points.empty())
      return 0;
    Point low = m_points[0], high = m_points[0];
    for (const Point& p : m_points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    return (high - low).norm();
  }

  bool is_closed() const
  {
    return std::find(m_opposite.begin(), m_opposite.end(), -1) == m_opposite.end();
  }

private:
  // finds opposites by sorting the directed edges by their end points
  void connect()
  {
    const int nh = number_of_halfedges(), nv = number_of_vertices();
    std::vector<std::vector<int>> unmatched(nv); // outgoing halfedges by their smaller end
    m_opposite.assign(nh, -1);
    for (int h = 0; h < nh; ++h) {
      auto& waiting = unmatched[(std::min)(source(h), target(h))];
      const auto twin = std::find_if(waiting.begin(), waiting.end(), [&](int g) {
        return source(g) == target(h) && target(g) == source(h);
      });
      if (twin == waiting.end()) {
        waiting.push_back(h);
        continue;
      }
      m_opposite[h] = *twin;
      m_opposite[*twin] = h;
      waiting.erase(twin);
    }
    m_edge.assign(nh, -1);
    m_edge_halfedge.clear();
    m_vertex_halfedge.assign(nv, -1);
    for (int h = 0; h < nh; ++h) {
      if (m_opposite[h] < 0 || h < m_opposite[h]) {
        m_edge[h] = number_of_edges();
        m_edge_halfedge.push_back(h);
      } else
        m_edge[h] = m_edge[m_opposite[h]];
      if (m_vertex_halfedge[source(h)] < 0 || m_opposite[h] < 0)
        m_vertex_halfedge[source(h)] = h;
    }
    m_is_fixed.assign(number_of_edges(), 0);
    for (int h = 0; h < nh; ++h)
      if (m_opposite[h] < 0)
        m_is_fixed[m_edge[h]] = 1;
  }

  std::vector<Point> m_points;
  std::shared_ptr<const Triangle_surface> m_original; // none if no face was divided
  std::vector<int> m_origin;                          // per face
  std::vector<std::vector<int>> m_parents;            // per added vertex
  std::vector<int> m_source, m_opposite, m_edge, m_vertex_halfedge, m_edge_halfedge;
  std::vector<char> m_is_fixed; // per edge
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_TRIANGLE_SURFACE_H
