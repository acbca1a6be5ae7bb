// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_IS_CONTRACTIBLE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_IS_CONTRACTIBLE_H

#include <CGAL/Quad_layouts/T_mesh.h>

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The patches that can be reached from `first` without crossing arcs of a loop.
inline std::vector<int> patches_beside(const T_mesh& t_mesh, const std::vector<char>& is_on_loop,
                                       int first)
{
  std::vector<char> is_reached(t_mesh.number_of_faces(), 0);
  std::vector<int> result{first};
  is_reached[first] = 1;
  for (std::size_t i = 0; i < result.size(); ++i) {
    int h = t_mesh.halfedge_of(result[i]);
    do {
      const int beside = t_mesh.face(T_mesh::opposite(h));
      if (!is_on_loop[T_mesh::edge(h)] && beside >= 0 && !std::exchange(is_reached[beside], 1))
        result.push_back(beside);
      h = t_mesh.next(h);
    } while (h != t_mesh.halfedge_of(result[i]));
  }
  return result;
}

// Says whether a simple loop of arcs bounds a disc of patches: then, on one side, the patches and
// the nodes less the arcs, those of the loop included, are one.
inline bool is_contractible(const T_mesh& t_mesh, const std::vector<int>& loop)
{
  std::vector<char> is_on_loop(t_mesh.number_of_edges(), 0);
  for (const int a : loop)
    is_on_loop[a] = 1;
  const int left = t_mesh.face(2 * loop.front()), right = t_mesh.face(2 * loop.front() + 1);
  for (const int first : {left, right}) {
    if (first < 0)
      continue;
    const std::vector<int> patches = patches_beside(t_mesh, is_on_loop, first);
    std::set<int> nodes, arcs;
    bool is_left = false, is_right = false;
    for (const int p : patches) {
      is_left |= p == left;
      is_right |= p == right;
      int h = t_mesh.halfedge_of(p);
      do {
        nodes.insert(t_mesh.target(h));
        arcs.insert(T_mesh::edge(h));
        h = t_mesh.next(h);
      } while (h != t_mesh.halfedge_of(p));
    }
    if (is_left && is_right) // the loop does not separate its sides
      return false;
    if (int(nodes.size()) - int(arcs.size()) + int(patches.size()) == 1)
      return true;
  }
  return false;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_IS_CONTRACTIBLE_H
