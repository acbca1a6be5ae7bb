// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_BASE_COMPLEX_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_BASE_COMPLEX_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/layout/number_classes.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Collects edges that are opposite each other in faces into chords.
inline void collect_chords(Quad_layout& layout)
{
  Disjoint_sets sets(layout.number_of_edges());
  for (int h = 0; h < layout.number_of_halfedges(); ++h)
    if (!layout.is_border(h))
      sets.union_set(Quad_layout::edge(h), Quad_layout::edge(layout.next(layout.next(h))));
  Numbered_classes chords = number_classes(sets, layout.number_of_edges());
  layout.number_of_chords = chords.number;
  layout.edge_chord = std::move(chords.class_of);
}

// Marks the border, and the chains of edges that leave irregular vertices and go straight on through
// regular ones, up to the border.
inline void mark_separatrices(Quad_layout& layout)
{
  const int n = layout.number_of_vertices();
  std::vector<char> regular(n), goes_on(n);
  for (int v = 0; v < n; ++v) {
    regular[v] = layout.is_regular(v);
    goes_on[v] = regular[v] && !layout.is_on_border(v);
  }
  layout.edge_on_separatrix.assign(layout.number_of_edges(), 0);
  for (int first = 0; first < layout.number_of_halfedges(); ++first) {
    if (regular[layout.source(first)] && !layout.is_border(first))
      continue;
    int h = first;
    layout.edge_on_separatrix[Quad_layout::edge(h)] = 1;
    while (goes_on[layout.target(h)]) {
      h = layout.next(Quad_layout::opposite(layout.next(h)));
      layout.edge_on_separatrix[Quad_layout::edge(h)] = 1;
    }
  }
}

// Collects the faces that no separatrix divides into patches.
inline void collect_patches(Quad_layout& layout)
{
  Disjoint_sets sets(layout.number_of_faces());
  for (int e = 0; e < layout.number_of_edges(); ++e)
    if (!layout.is_on_separatrix(e) && !layout.is_border_edge(e))
      sets.union_set(layout.face(2 * e), layout.face(2 * e + 1));
  Numbered_classes patches = number_classes(sets, layout.number_of_faces());
  layout.number_of_patches = patches.number;
  layout.face_patch = std::move(patches.class_of);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_BASE_COMPLEX_H
