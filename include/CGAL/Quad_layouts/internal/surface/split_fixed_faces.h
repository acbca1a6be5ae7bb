// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SPLIT_FIXED_FACES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SPLIT_FIXED_FACES_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// says if several edges of face f are fixed: a field cannot be aligned to all of them
inline bool is_overdetermined(const Triangle_surface& surface, int f)
{
  int fixed = 0;
  for (int h = 3 * f; h < 3 * f + 3; ++h)
    fixed += surface.is_fixed(h);
  return fixed > 1;
}

// Returns the surface with faces that have several fixed edges split at their centroids, such that
// none has. Faces keep their numbers and their first halfedges, new ones follow.
inline Triangle_surface split_fixed_faces(const Triangle_surface& surface)
{
  std::vector<Point> points = surface.points();
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> origins;
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    triangles.push_back({surface.source(3 * f), surface.source(3 * f + 1),
                         surface.source(3 * f + 2)});
    origins.push_back(f);
  }
  std::vector<int> fixed; // halfedges of the result
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    const bool is_split = is_overdetermined(surface, f);
    for (int k = 0; k < 3; ++k)
      if (surface.is_fixed(3 * f + k))
        fixed.push_back(is_split && k > 0 ? 3 * int(triangles.size() + k - 1) : 3 * f + k);
    if (!is_split)
      continue;
    const auto [a, b, c] = triangles[f];
    const int center = int(points.size());
    points.push_back((points[a] + points[b] + points[c]) / 3);
    triangles[f] = {a, b, center};
    triangles.push_back({b, c, center});
    triangles.push_back({c, a, center});
    origins.insert(origins.end(), 2, f);
  }
  if (triangles.size() == std::size_t(surface.number_of_faces()))
    return surface;
  Triangle_surface result(std::move(points), triangles, std::move(origins));
  for (const int h : fixed)
    result.fix(h);
  return result;
}

// returns the number of faces of the user's mesh
inline int number_of_original_faces(const Triangle_surface& surface)
{
  int result = surface.number_of_faces();
  while (result > 0 && surface.origin(result - 1) < result - 1)
    --result;
  return result;
}

// returns the number of vertices of the user's mesh: each face that is split adds one, and two faces
inline int number_of_original_vertices(const Triangle_surface& surface)
{
  const int added_faces = surface.number_of_faces() - number_of_original_faces(surface);
  return surface.number_of_vertices() - added_faces / 2;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SPLIT_FIXED_FACES_H
