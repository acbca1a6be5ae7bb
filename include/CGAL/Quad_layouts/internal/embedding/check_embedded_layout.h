// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CHECK_EMBEDDED_LAYOUT_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CHECK_EMBEDDED_LAYOUT_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/embedding/Embedded_layout.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// throws unless the curve of every layout halfedge leaves the place of its source
inline void check_ends(const Embedded_layout& embedded, const Quad_layout& layout)
{
  const Curve_mesh& mesh = embedded.mesh;
  for (int l = 0; l < layout.number_of_halfedges(); ++l) {
    if (layout.is_border(l))
      continue;
    const std::vector<int> around = mesh.outgoing(embedded.vertices[layout.source(l)]);
    if (std::none_of(around.begin(), around.end(), [&](int h) { return mesh.curve[h] == l; }))
      throw Stage_failure("embed: layout edge " + std::to_string(l / 2) +
                          " does not reach its end");
  }
}

// writes f to all faces of the region between curves in which `first` is
inline void spread_region(const Curve_mesh& mesh, const Quad_layout& layout, int first, int f,
                          std::vector<int>& face)
{
  std::vector<int> stack{first};
  face[first] = f;
  while (!stack.empty()) {
    const int t = stack.back();
    stack.pop_back();
    for (int h = 3 * t; h < 3 * t + 3; ++h) {
      if (mesh.curve[h] >= 0 && layout.face(mesh.curve[h]) != f)
        throw Stage_failure("embed: the curves around layout face " + std::to_string(f) +
                            " are in disorder");
      if (mesh.opposite(h) < 0)
        continue;
      const int g = mesh.opposite(h) / 3;
      if (mesh.curve[h] < 0 && face[g] < 0) {
        face[g] = f;
        stack.push_back(g);
      }
    }
  }
}

// throws unless the regions between curves are the faces of the layout
inline void check_regions(const Curve_mesh& mesh, const Quad_layout& layout)
{
  std::vector<int> face(mesh.number_of_faces(), -1), regions(layout.number_of_faces(), 0);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.curve[h] >= 0 && face[h / 3] < 0) {
      const int f = layout.face(mesh.curve[h]);
      ++regions[f];
      spread_region(mesh, layout, h / 3, f, face);
    }
  for (int f = 0; f < layout.number_of_faces(); ++f)
    if (regions[f] != 1)
      throw Stage_failure("embed: layout face " + std::to_string(f) + " has " +
                          std::to_string(regions[f]) + " regions on the surface");
}

// throws unless the curves of fixed layout edges, and no others, run along fixed edges
inline void check_fixed_curves(const Curve_mesh& mesh, const Quad_layout& layout)
{
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if ((mesh.curve[h] >= 0 && layout.is_fixed(Quad_layout::edge(mesh.curve[h]))) !=
        (mesh.is_fixed[h] != 0))
      throw Stage_failure("embed: fixed curves are not made of fixed edges of the layout");
}

inline void check_embedded_layout(const Embedded_layout& embedded, const Quad_layout& layout)
{
  check_ends(embedded, layout);
  check_fixed_curves(embedded.mesh, layout);
  check_regions(embedded.mesh, layout);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_CHECK_EMBEDDED_LAYOUT_H
