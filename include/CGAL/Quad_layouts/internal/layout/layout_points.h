// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_POINTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_POINTS_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/internal/layout/fibres.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Returns the point among some nodes, those on fixed curves if there are any, that has the least
// greatest distance to the others.
inline Point central_point(const T_mesh& t, const std::vector<int>& nodes)
{
  Point best = t.point(nodes.front());
  double least = (std::numeric_limits<double>::infinity)();
  const bool on_curve = std::any_of(nodes.begin(), nodes.end(),
                                    [&](int n) { return t.is_on_fixed_curve(n); });
  for (int n : nodes) {
    if (t.is_on_fixed_curve(n) != on_curve)
      continue;
    double greatest = 0;
    for (int m : nodes)
      greatest = (std::max)(greatest, (t.point(n) - t.point(m)).squaredNorm());
    if (greatest < least) {
      least = greatest;
      best = t.point(n);
    }
  }
  return best;
}

// Returns a point for each integer point of the arcs, on straight lines between the nodes.
inline std::vector<Point> points_on_arcs(const Arc_grid& grid)
{
  const T_mesh& t = grid.t_mesh();
  std::vector<Point> result(t.vertex_point);
  result.resize(grid.number_of_points());
  for (int s = 0, i = 0; s < grid.number_of_half_segments(); s += 2) {
    const int a = grid.arc(s), q = grid.length(a);
    i = s > 0 && grid.arc(s - 2) == a ? i + 1 : 0;
    const Point& from = t.point(t.source(2 * a));
    const Point& to = t.point(t.target(2 * a));
    if (i > 0)
      result[grid.source(s)] = from + double(i) / q * (to - from);
  }
  return result;
}

// Fills in the vertices inside a patch by the transfinite interpolation of Coons between its sides.
inline void interpolate_inside(const Quad_layout::Grid& grid, Quad_layout& layout)
{
  const int w = grid.width, h = grid.height;
  std::vector<int> vertex(std::size_t(w + 1) * (h + 1));
  const auto at = [&](int i, int j) -> int& { return vertex[std::size_t(j) * (w + 1) + i]; };
  for (int j = 0; j < h; ++j)
    for (int i = 0; i < w; ++i) {
      const int bottom = grid.square(i, j), top = layout.next(layout.next(bottom));
      at(i, j) = layout.source(bottom);
      at(i + 1, j) = layout.target(bottom);
      at(i + 1, j + 1) = layout.source(top);
      at(i, j + 1) = layout.target(top);
    }
  const auto point = [&](int i, int j) -> Point& { return layout.vertex_point[at(i, j)]; };
  for (int j = 1; j < h; ++j)
    for (int i = 1; i < w; ++i) {
      const double x = double(i) / w, y = double(j) / h;
      point(i, j) = (1 - y) * point(i, 0) + y * point(i, h) + (1 - x) * point(0, j) +
                    x * point(w, j) - (1 - x) * ((1 - y) * point(0, 0) + y * point(0, h)) -
                    x * ((1 - y) * point(w, 0) + y * point(w, h));
    }
}

// Places the vertices: merged nodes at the central one of them, others where the T-mesh has them,
// or between.
inline void place_vertices(const Fibres& fibres, const std::vector<int>& vertex_of_fibre,
                           Quad_layout& layout)
{
  const T_mesh& t = fibres.grid().t_mesh();
  layout.vertex_point.assign(layout.number_of_vertices(), Point::Zero());
  const std::vector<Point> points = points_on_arcs(fibres.grid());
  for (int f = 0; f < fibres.size(); ++f) {
    const std::vector<int>& of_fibre = fibres.fibre(f).points;
    const auto on_curve = std::find_if(of_fibre.begin(), of_fibre.end(),
                                       [&](int p) { return fibres.grid().is_on_fixed_curve(p); });
    layout.vertex_point[vertex_of_fibre[f]] =
        points[on_curve == of_fibre.end() ? of_fibre.front() : *on_curve];
  }
  for (const Quad_layout::Cluster& c : layout.clusters)
    layout.vertex_point[c.vertex] = central_point(t, c.nodes);
  for (const Quad_layout::Grid& grid : layout.grids)
    if (!grid.squares.empty())
      interpolate_inside(grid, layout);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_LAYOUT_POINTS_H
