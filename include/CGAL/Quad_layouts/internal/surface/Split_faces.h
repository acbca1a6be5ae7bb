// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SPLIT_FACES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SPLIT_FACES_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>
#include <CGAL/Quad_layouts/internal/surface/split_fixed_faces.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// What `split_fixed_faces()` has made of the faces of the user's mesh. Side i of face f is the one that was
// halfedge 3f + i before.
class Split_faces
{
public:
  explicit Split_faces(const Triangle_surface& surface) : m_surface(surface)
  {
    for (int f = 0; f < number_of_original_faces(surface); ++f)
      m_parts.push_back({f, f, f});
    for (int f = number_of_faces(); f < surface.number_of_faces(); f += 2)
      m_parts[surface.origin(f)] = {surface.origin(f), f, f + 1};
  }

  int number_of_faces() const { return int(m_parts.size()); }
  bool is_split(int f) const { return m_parts[f][1] != f; }
  // the face of the surface at a side, and its halfedge there
  int part(int f, int side) const { return m_parts[f][side]; }
  int halfedge(int f, int side) const { return is_split(f) ? 3 * part(f, side) : 3 * f + side; }
  // the side of the user's face that halfedge h, which is at one, belongs to
  int side_of(int h) const
  {
    const auto& parts = m_parts[m_surface.origin(m_surface.face(h))];
    return parts[1] == parts[0]
               ? h % 3
               : int(std::find(parts.begin(), parts.end(), m_surface.face(h)) - parts.begin());
  }

  // the surface before the faces were split; no edge inside is fixed
  Triangle_surface whole() const
  {
    std::vector<std::array<int, 3>> triangles;
    for (int f = 0; f < number_of_faces(); ++f)
      triangles.push_back({m_surface.source(halfedge(f, 0)), m_surface.source(halfedge(f, 1)),
                           m_surface.source(halfedge(f, 2))});
    std::vector<Point> points = m_surface.points();
    points.resize(number_of_original_vertices(m_surface));
    return Triangle_surface(std::move(points), triangles);
  }

private:
  const Triangle_surface& m_surface;
  std::vector<std::array<int, 3>> m_parts;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SPLIT_FACES_H
