// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_MEASURE_QUAD_LAYOUT_H
#define CGAL_QUAD_LAYOUTS_MEASURE_QUAD_LAYOUT_H

#include <CGAL/Quad_layouts/Quad_layout.h>

#include <map>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsClasses

describes a quad layout by the figures that tables of results usually give.
*/
struct Quad_layout_measures
{
  int vertices = 0;
  int edges = 0;
  int faces = 0;
  int chords = 0;
  int euler_characteristic = 0;

  int irregular_vertices = 0;  ///< those of a valence other than 4, or 3 on the border (\#S)
  std::map<int, int> valences; ///< number of vertices of each valence that occurs
  int patches = 0;             ///< faces of the base complex (\#P)
  int patches_floor = 0; ///< least number of patches that the irregular vertices allow: each is a
                         ///< corner of as many patches as its valence, and a patch has four corners
  int t_junctions = 0;   ///< ends of separatrices at regular vertices, and corners by which faces
                         ///< exceed four

  int minimum_valence() const { return valences.empty() ? 0 : valences.begin()->first; }
  int maximum_valence() const { return valences.empty() ? 0 : valences.rbegin()->first; }
};

namespace internal {

inline int number_of_t_junctions(const Quad_layout& layout)
{
  int result = 0;
  for (int f = 0; f < layout.number_of_faces(); ++f) {
    int corners = 0, h = layout.halfedge_of(f);
    do {
      ++corners;
      h = layout.next(h);
    } while (h != layout.halfedge_of(f));
    result += corners > 4 ? corners - 4 : 0;
  }
  for (int h = 0; h < layout.number_of_halfedges(); ++h)
    if (layout.is_on_separatrix(Quad_layout::edge(h)) && layout.is_regular(layout.source(h)) &&
        !layout.is_on_border(layout.source(h))) {
      const int straight_on = layout.turn_left(layout.turn_left(h));
      result += !layout.is_on_separatrix(Quad_layout::edge(straight_on));
    }
  return result;
}

} // namespace internal

/*!
\ingroup PkgQuadLayoutsFunctions

measures a quad layout.

The time is linear in the size of the layout.
*/
inline Quad_layout_measures measure_quad_layout(const Quad_layout& layout)
{
  Quad_layout_measures result;
  result.vertices = layout.number_of_vertices();
  result.edges = layout.number_of_edges();
  result.faces = layout.number_of_faces();
  result.chords = layout.number_of_chords;
  result.euler_characteristic = layout.euler_characteristic();
  result.patches = layout.number_of_patches;
  result.t_junctions = internal::number_of_t_junctions(layout);
  int corners = 0;
  for (int v = 0; v < layout.number_of_vertices(); ++v) {
    const int valence = layout.valence(v);
    ++result.valences[valence];
    if (!layout.is_regular(v)) {
      ++result.irregular_vertices;
      corners += layout.is_on_border(v) ? valence - 1 : valence;
    }
  }
  result.patches_floor = (corners + 3) / 4;
  return result;
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_MEASURE_QUAD_LAYOUT_H
