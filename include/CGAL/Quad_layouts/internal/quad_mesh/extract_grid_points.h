// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_GRID_POINTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_GRID_POINTS_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/layout/divided_layout.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_Layout_tracer.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Follows the grid lines of a face from the lower to the upper side, where they must arrive
// exactly.
inline void locate_inside_face(const Layout_tracer& tracer, const Divided_layout& divided, int f,
                               std::vector<Map_heading>& location)
{
  const Quad_layout& layout = divided.layout();
  const Line_tracer& lines = tracer.lines();
  const int bottom = layout.halfedge_of(f), right = layout.next(bottom), top = layout.next(right);
  const int w = divided.width(f), h = divided.height(f);
  for (int i = 1; i < w; ++i) {
    const Map_heading up = lines.entered(tracer.stop(bottom, i).turned(1));
    const Map_heading down = lines.entered(tracer.stop(top, w - i).turned(1));
    std::vector<Map_heading> line;
    if (up.is_valid())
      line = lines.follow(up, tracer.distances(right));
    if (int(line.size()) != h || lines.entered(line.back().turned(2)) != down)
      throw Stage_failure("quad mesh: grid lines do not join opposite sides of layout face " +
                          std::to_string(f));
    for (int j = 1; j < h; ++j)
      location[divided.vertex_in(f, i, j)] = line[j - 1];
  }
}

// Returns where in the map each vertex of the divided layout lies.
inline std::vector<Map_heading> locate_grid(const Layout_tracer& tracer,
                                            const Divided_layout& divided)
{
  const Quad_layout& layout = divided.layout();
  std::vector<Map_heading> location(divided.number_of_vertices());
  for (int v = 0; v < layout.number_of_vertices(); ++v)
    location[v] = tracer.start(layout.halfedge_from(v));
  for (int h = 0; h < layout.number_of_halfedges(); h += 2)
    for (int k = 1; k < divided.parts(h); ++k)
      location[divided.vertex_on(h, k)] = tracer.stop(h, k);
  for (int f = 0; f < layout.number_of_faces(); ++f)
    locate_inside_face(tracer, divided, f, location);
  return location;
}

// Returns the points of the surface that the vertices of the divided layout are.
inline std::vector<Eigen::Vector3d> grid_points(const Layout_tracer& tracer,
                                                const Divided_layout& divided)
{
  std::vector<Eigen::Vector3d> result;
  for (const Map_heading& at : locate_grid(tracer, divided))
    result.push_back(tracer.lines().point(at));
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_GRID_POINTS_H
