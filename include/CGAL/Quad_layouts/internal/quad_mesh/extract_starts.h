// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_STARTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_STARTS_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_Line_tracer.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Sets where all layout halfedges around the source of h begin, `heading` being that of h, and
// tells `reached` each of them. Returns false if the map does not turn around the place once.
template <class Reached>
bool set_starts_inside(const Line_tracer& lines, const Quad_layout& layout, int h,
                       Map_heading heading, std::vector<Map_heading>& start, const Reached& reached)
{
  const Map_heading first = heading;
  int g = h;
  do {
    if (!heading.is_valid())
      return false;
    start[g] = heading;
    reached(g);
    g = layout.turn_left(g);
    heading = lines.entered(heading.turned(1));
  } while (g != h);
  return heading == first;
}

// The same at layout vertex v on the border, which is at `place`. The last halfedge has no face and
// gets no start: no line can be followed with the surface on its right.
template <class Reached>
bool set_starts_on_border(const Line_tracer& lines, const Quad_layout& layout, int v,
                          const Map_heading& place, std::vector<Map_heading>& start,
                          const Reached& reached)
{
  Map_heading heading = lines.along_border(place);
  for (int g = layout.halfedge_from(v); !layout.is_border(g); g = layout.turn_left(g)) {
    if (g != layout.halfedge_from(v))
      heading = lines.entered(heading.turned(1));
    if (!heading.is_valid())
      return false;
    start[g] = heading;
    reached(g);
  }
  return true;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_STARTS_H
