// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_CHORD_SPLITTER_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_CHORD_SPLITTER_H

#include <CGAL/Quad_layouts/Cross_field.h>

#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Divides the edges of a surface that are not fixed but join two vertices on fixed curves, and carries the
// field over. A straight part of a fixed curve becomes a straight line in a parametrization: an edge that
// joins two of its vertices would lie on the line, too, and what is between them would have no area.
class Chord_splitter
{
public:
  explicit Chord_splitter(const Cross_field& field)
    : m_field(field), m_surface(field.surface()), m_middle(m_surface.number_of_edges(), -1),
      m_points(m_surface.points())
  {
    for (int e = 0; e < m_surface.number_of_edges(); ++e) {
      const int h = m_surface.halfedge_of_edge(e), v = m_surface.source(h), w = m_surface.target(h);
      if (m_surface.is_fixed(h) || !is_on_curve(v) || !is_on_curve(w))
        continue;
      m_middle[e] = int(m_points.size());
      m_points.push_back((m_surface.point(v) + m_surface.point(w)) / 2);
    }
  }

  // returns the field on the divided surface, itself if there is nothing to divide
  Cross_field split()
  {
    if (int(m_points.size()) == m_surface.number_of_vertices())
      return m_field;
    for (int f = 0; f < m_surface.number_of_faces(); ++f)
      split_face(f);
    std::vector<int> origins, indices;
    for (const int f : m_old_face)
      origins.push_back(m_surface.origin(f));
    for (int v = 0; v < int(m_points.size()); ++v)
      indices.push_back(v < m_surface.number_of_vertices() ? m_field.index(v) : 0);
    auto surface = std::make_shared<Triangle_surface>(std::move(m_points), m_triangles,
                                                      std::move(origins));
    std::vector<double> angles;
    std::vector<signed char> matchings;
    for (int f = 0; f < surface->number_of_faces(); ++f)
      angles.push_back(m_field.angle(m_old_face[f]) -
                       old_angle(m_old_face[f], surface->vector(3 * f)));
    for (int h = 0; h < surface->number_of_halfedges(); ++h) {
      const int old = m_old_halfedge[h];
      matchings.push_back(static_cast<signed char>(old < 0 ? 0 : m_field.matching(old)));
      if (old >= 0 && m_surface.is_fixed(old))
        surface->fix(h);
    }
    return Cross_field(std::move(surface), std::move(angles), std::move(matchings),
                       std::move(indices));
  }

private:
  bool is_on_curve(int v) const { return m_surface.number_of_fixed_edges(v) > 0; }

  int middle(int h) const { return m_middle[m_surface.edge(h)]; }

  // `old`: the halfedges that the sides are part of, -1 inside of the face
  void add(int f, const std::array<int, 3>& corners, const std::array<int, 3>& old)
  {
    m_triangles.push_back(corners);
    m_old_face.push_back(f);
    m_old_halfedge.insert(m_old_halfedge.end(), old.begin(), old.end());
  }

  void split_face(int f)
  {
    int divided = 0, h = 3 * f;
    for (int side = 3 * f; side < 3 * f + 3; ++side)
      divided += middle(side) >= 0;
    // h is divided and, if two are, the one before it
    if (divided == 1 || divided == 2)
      while (middle(h) < 0 || (divided == 2 && middle(Triangle_surface::prev(h)) < 0))
        ++h;
    const int i = Triangle_surface::next(h), j = Triangle_surface::prev(h);
    const int a = m_surface.source(h), b = m_surface.source(i), c = m_surface.source(j);
    const int ab = middle(h), bc = middle(i), ca = middle(j);
    switch (divided) {
      case 0: add(f, {a, b, c}, {h, i, j}); break;
      case 1:
        add(f, {a, ab, c}, {h, -1, j});
        add(f, {ab, b, c}, {h, i, -1});
        break;
      case 2:
        add(f, {a, ab, ca}, {h, -1, j});
        add(f, {ab, b, c}, {h, i, -1});
        add(f, {ab, c, ca}, {-1, j, -1});
        break;
      default:
        add(f, {a, ab, ca}, {h, -1, j});
        add(f, {b, bc, ab}, {i, -1, h});
        add(f, {c, ca, bc}, {j, -1, i});
        add(f, {ab, bc, ca}, {-1, -1, -1});
    }
  }

  // the angle of a vector in the plane of face f, in its frame
  double old_angle(int f, const Point& vector) const
  {
    const Point x = m_surface.direction(f, 0), y = m_surface.normal(f).cross(x);
    return std::atan2(vector.dot(y), vector.dot(x));
  }

  const Cross_field& m_field;
  const Triangle_surface& m_surface;
  std::vector<int> m_middle; // per edge: the vertex that divides it, or -1
  std::vector<Point> m_points;
  std::vector<std::array<int, 3>> m_triangles;
  std::vector<int> m_old_face, m_old_halfedge; // per face and halfedge of the result
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_CHORD_SPLITTER_H
