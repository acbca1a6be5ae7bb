// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_IO_FIRST_HALFEDGE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_IO_FIRST_HALFEDGE_H

#include <CGAL/Quad_layouts/internal/IO/Line_reader.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <array>
#include <string>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// the halfedge of face f that begins in the first of its vertices, as a file gives them in order,
// which it may begin with another one than the surface
inline int first_halfedge(const Line_reader& reader, const Triangle_surface& surface, int f,
                          const std::array<int, 3>& vertices)
{
  for (int h = 3 * f; h < 3 * f + 3; ++h)
    if (surface.source(h) == vertices[0] && surface.target(h) == vertices[1] &&
        surface.target(Triangle_surface::next(h)) == vertices[2])
      return h;
  reader.fail("face " + std::to_string(f) + " has other vertices in the mesh");
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_IO_FIRST_HALFEDGE_H
