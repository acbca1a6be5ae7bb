// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_PREIMAGES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_PREIMAGES_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/embedding/Quantized_overlay.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Tells, per vertex of a quantized overlay with grid lines, the layout vertex to which it is
// mapped, or -1.
//
// The preimage of a layout vertex is a connected, simply connected set of arcs of length zero, of
// patches of size zero and of lines through patches of zero width.
inline std::vector<int> preimages(const Quantized_overlay& overlay)
{
  const Curve_mesh& mesh = overlay.mesh();
  const int n = int(mesh.points.size());
  Disjoint_sets sets(n);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (overlay.is_contracted(h))
      sets.union_set(mesh.source(h), mesh.target(h));
  std::vector<int> of_set(n, -1), result(n);
  for (int v = 0; v < n; ++v)
    if (const int l = overlay.layout_vertex(v); l >= 0) {
      int& known = of_set[sets.find_set(v)];
      if (known >= 0 && known != l)
        throw Stage_failure("embed: layout vertices " + std::to_string(l) + " and " +
                            std::to_string(known) + " are not separated");
      known = l;
    }
  for (int v = 0; v < n; ++v)
    result[v] = of_set[sets.find_set(v)];
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_PREIMAGES_H
