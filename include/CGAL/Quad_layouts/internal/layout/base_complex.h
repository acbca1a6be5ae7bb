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

// Marks the fixed curves, and the chains of edges that leave irregular vertices, and those where
// fixed curves do not go straight on, and go straight on through others, up to the border.
inline void mark_separatrices(Quad_layout& layout)
{
  const int n = layout.number_of_vertices();
  std::vector<char> straight(n), goes_on(n);
  for (int v = 0; v < n; ++v) {
    straight[v] = layout.goes_straight_on(v);
    goes_on[v] = straight[v] && !layout.is_on_border(v);
  }
  layout.edge_on_separatrix.assign(layout.number_of_edges(), 0);
  for (int first = 0; first < layout.number_of_halfedges(); ++first) {
    if (layout.is_fixed(Quad_layout::edge(first)))
      layout.edge_on_separatrix[Quad_layout::edge(first)] = 1;
    if (straight[layout.source(first)] || layout.is_border(first))
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
    if (!layout.is_on_separatrix(e))
      sets.union_set(layout.face(2 * e), layout.face(2 * e + 1));
  Numbered_classes patches = number_classes(sets, layout.number_of_faces());
  layout.number_of_patches = patches.number;
  layout.face_patch = std::move(patches.class_of);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_BASE_COMPLEX_H
