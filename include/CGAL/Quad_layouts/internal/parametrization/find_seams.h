// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_FIND_SEAMS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_FIND_SEAMS_H

#include <CGAL/Quad_layouts/internal/parametrization/Cut_graph.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A *seam* is a chain of cut edges that ends where others meet it, at cones and at the border.

// returns the halfedge by which the seam of h goes on at its target, -1 if it ends there
inline int next_on_seam(const Triangle_surface& surface, const Cut_graph& cut, int h)
{
  const int v = surface.target(h);
  if (surface.is_on_border(v))
    return -1;
  int result = -1, count = 0;
  surface.for_each_outgoing(v, [&](int g) {
    if (cut.is_cut(g) && g != surface.opposite(h)) {
      result = g;
      ++count;
    }
  });
  // at a cone the charts turn into each other in another way
  return count == 1 && cut.quarter_turns(result) == cut.quarter_turns(h) ? result : -1;
}

// returns, for each seam, its halfedges on one side
inline std::vector<std::vector<int>> find_seams(const Triangle_surface& surface,
                                                const Cut_graph& cut)
{
  std::vector<std::vector<int>> result;
  std::vector<char> is_found(surface.number_of_edges(), 0);
  for (int first = 0; first < surface.number_of_halfedges(); ++first) {
    if (surface.is_border(first) || !cut.is_cut(first) || is_found[surface.edge(first)])
      continue;
    result.emplace_back();
    const auto add = [&](int h) {
      if (h < 0 || is_found[surface.edge(h)])
        return false;
      is_found[surface.edge(h)] = 1;
      result.back().push_back(h);
      return true;
    };
    for (int h = first; add(h);)
      h = next_on_seam(surface, cut, h);
    for (int back = surface.opposite(first);;) {
      back = next_on_seam(surface, cut, back);
      if (back < 0 || !add(surface.opposite(back)))
        break;
    }
  }
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_FIND_SEAMS_H
