// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_FACE_DIVISION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_FACE_DIVISION_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Divides faces of a surface. Vertices and faces keep their numbers, and faces the source of their
// first halfedge; new ones follow. Fixed edges stay whole and fixed.
class Face_division
{
public:
  explicit Face_division(const Triangle_surface& surface)
    : m_surface(surface), m_points(surface.points()), m_triangles(surface.number_of_faces()),
      m_divided(surface.number_of_faces())
  {
    std::iota(m_divided.begin(), m_divided.end(), 0);
    for (int f = 0; f < surface.number_of_faces(); ++f)
      for (int k = 0; k < 3; ++k)
        m_triangles[f][k] = surface.source(3 * f + k);
  }

  // joins the corners of face f to its centroid
  void split_at_centroid(int f)
  {
    const auto [a, b, c] = m_triangles[f];
    const int center = add_in_the_middle({a, b, c});
    m_triangles[f][2] = center;
    add(f, {b, c, center});
    add(f, {c, a, center});
  }

  // splits edges, of which none is fixed, at their midpoints, and in each face the longest one
  // first
  void split(const std::vector<int>& edges)
  {
    std::vector<std::pair<double, int>> order;
    for (int e : edges)
      order.emplace_back(-m_surface.length(m_surface.halfedge_of_edge(e)), e);
    std::sort(order.begin(), order.end());
    std::vector<std::vector<int>> parts(m_surface.number_of_faces());
    for (const auto& entry : order) {
      const int h = m_surface.halfedge_of_edge(entry.second), g = m_surface.opposite(h);
      CGAL_precondition(!m_surface.is_fixed(h));
      const int m = add_in_the_middle({m_surface.source(h), m_surface.target(h)});
      bisect(h, m, parts[Triangle_surface::face(h)]);
      bisect(g, m, parts[Triangle_surface::face(g)]);
    }
  }

  Triangle_surface result() const
  {
    if (m_points.size() == m_surface.points().size())
      return m_surface;
    Triangle_surface result(m_surface, m_points, m_triangles, m_divided, m_parents);
    for (int h = 0; h < result.number_of_halfedges(); ++h)
      if (is_fixed(m_divided[Triangle_surface::face(h)], result.source(h), result.target(h)))
        result.fix(h);
    return result;
  }

private:
  using Triangle = std::array<int, 3>;

  int add_in_the_middle(std::vector<int> vertices)
  {
    Point sum = Point::Zero();
    for (const int v : vertices)
      sum += m_points[v];
    m_points.push_back(sum / double(vertices.size()));
    std::sort(vertices.begin(), vertices.end());
    m_parents.push_back(std::move(vertices));
    return int(m_points.size()) - 1;
  }

  void add(int divided, const Triangle& t)
  {
    m_triangles.push_back(t);
    m_divided.push_back(divided);
  }

  // splits the part of the face of h that has the edge of h, which gets the midpoint m; `added` are
  // the parts of the face but the first
  void bisect(int h, int m, std::vector<int>& added)
  {
    const int f = Triangle_surface::face(h);
    const int u = m_surface.source(h), v = m_surface.target(h);
    int part = f, i = position(m_triangles[f], u, v);
    for (std::size_t k = 0; i < 0; ++k)
      i = position(m_triangles[part = added[k]], u, v);
    // the first corner of the first part stays
    const int moved = i == 0 ? 1 : 2, other = i == moved ? (i + 1) % 3 : i;
    Triangle rest = m_triangles[part];
    m_triangles[part][moved] = rest[other] = m;
    added.push_back(int(m_triangles.size()));
    add(f, rest);
  }

  // where in t the edge from u to v begins, -1 if it is not there
  static int position(const Triangle& t, int u, int v)
  {
    for (int i = 0; i < 3; ++i)
      if (t[i] == u && t[(i + 1) % 3] == v)
        return i;
    return -1;
  }

  // says if face f of the given surface has a fixed edge from u to v
  bool is_fixed(int f, int u, int v) const
  {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      if (m_surface.source(h) == u && m_surface.target(h) == v)
        return m_surface.is_fixed(h);
    return false;
  }

  const Triangle_surface& m_surface;
  std::vector<Point> m_points;
  std::vector<Triangle> m_triangles;
  std::vector<int> m_divided;              // per triangle the face that it is a part of
  std::vector<std::vector<int>> m_parents; // per added vertex those that it is in the middle of
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_FACE_DIVISION_H
