// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_IS_CONTRACTIBLE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_IS_CONTRACTIBLE_H

#include <CGAL/Quad_layouts/T_mesh.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Says whether a simple loop of arcs bounds a disc of patches: then it separates them, and on one
// side are as many patches and nodes as arcs, and one more, those of the loop not being counted.
inline bool is_contractible(const T_mesh& t_mesh, const std::vector<int>& loop)
{
  std::vector<char> is_on_loop(t_mesh.number_of_edges(), 0);
  std::vector<char> node_is_seen(t_mesh.number_of_vertices(), 0);
  for (const int a : loop) {
    is_on_loop[a] = 1;
    node_is_seen[t_mesh.source(2 * a)] = node_is_seen[t_mesh.target(2 * a)] = 1;
  }
  std::vector<char> patch_is_seen(t_mesh.number_of_faces(), 0);
  const int sides[] = {t_mesh.face(2 * loop.front()), t_mesh.face(2 * loop.front() + 1)};
  for (const int first : sides) {
    if (patch_is_seen[first]) // the loop does not separate its two sides
      return false;
    std::vector<int> patches{first};
    patch_is_seen[first] = 1;
    int nodes = 0, halves_of_arcs = 0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
      int h = t_mesh.halfedge_of(patches[i]);
      do {
        const int beside = t_mesh.face(T_mesh::opposite(h));
        if (!is_on_loop[T_mesh::edge(h)]) {
          ++halves_of_arcs;
          if (!patch_is_seen[beside]) {
            patch_is_seen[beside] = 1;
            patches.push_back(beside);
          }
        }
        if (!node_is_seen[t_mesh.target(h)]) {
          node_is_seen[t_mesh.target(h)] = 1;
          ++nodes;
        }
        h = t_mesh.next(h);
      } while (h != t_mesh.halfedge_of(patches[i]));
    }
    if (nodes - halves_of_arcs / 2 + int(patches.size()) == 1)
      return true;
  }
  return false;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_IS_CONTRACTIBLE_H
