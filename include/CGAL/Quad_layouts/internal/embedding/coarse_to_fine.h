// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_COARSE_TO_FINE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_COARSE_TO_FINE_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/embedding/Vertex_neighbourhood.h>
#include <CGAL/Quad_layouts/internal/embedding/Vertex_removal.h>
#include <CGAL/Quad_layouts/internal/embedding/solve_map.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

inline void improve_vertex(Map& map, const Vertex_removal& levels, int v, int steps)
{
  if (levels.is_cone(v) || levels.star(v).empty())
    return;
  const Vertex_neighbourhood neighbourhood(map, v, levels.star(v));
  for (int i = 0; i < steps; ++i)
    neighbourhood.improve(map.coordinates[v]);
}

// Brings back all removed vertices, each at a place where no triangle gets inverted, and smooths
// the map around it.
//
// Such a place exists: the vertex into which the removed one was collapsed sees the whole polygon.
// Returns whether rounding let it be found for every vertex.
inline bool restore_all(Map& map, Vertex_removal& levels, const Monitor& monitor)
{
  for (int i = 0; !levels.is_complete(); ++i) {
    if (i % 1024 == 0)
      monitor.check("embed");
    const int v = levels.restore();
    if (!Vertex_neighbourhood(map, v, levels.star(v)).find_center(map.coordinates[v]))
      return false;
    improve_vertex(map, levels, v, 4);
    for (const int f : levels.star(v))
      improve_vertex(map, levels, map.faces[f].vertex[(map.faces[f].corner_of(v) + 1) % 3], 1);
  }
  return true;
}

// Solves for a map on a simplified mesh of about `attempt.coarse_faces` triangles, then refines it.
// Returns whether it succeeded; if not, the coordinates are of no use.
//
// The difficulty of finding a valid map grows with the number of triangles, that of refining one
// does not.
inline bool solve_coarse_to_fine(Map& map, const std::vector<Cone>& cones,
                                 const Solution_attempt& attempt, const Monitor& monitor)
{
  constexpr int sweeps = 4;
  Vertex_removal levels(map, cones);
  levels.simplify(attempt.coarse_faces);
  Map coarse = levels.coarse_map();
  if (!solve_map(coarse, cones, attempt, monitor))
    return false;
  map.coordinates = std::move(coarse.coordinates);
  if (!restore_all(map, levels, monitor))
    return false;
  for (int i = 0; i < sweeps; ++i)
    for (int v = 0; v < int(map.points.size()); ++v)
      improve_vertex(map, levels, v, 1);
  return true;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_COARSE_TO_FINE_H
