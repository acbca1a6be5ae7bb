// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_SMOOTH_GRID_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_SMOOTH_GRID_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_Layout_tracer.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_build_mesh.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_grid_points.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Quad_smoother.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A divided layout whose vertices have been smoothed on a surface.
struct Smooth_grid
{
  Divided_layout divided;
  std::vector<Eigen::Vector3d> points; // per vertex of `divided`
  std::vector<int> bad_quads;          // inverted, or opposing the surface; in order
};

// the quads of a divided layout with the edges on its fixed curves marked
inline Polygons polygons_of(const Divided_layout& divided,
                            const std::vector<Eigen::Vector3d>& points)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Mesh mesh;
  const auto on_curve = mesh.add_property_map<Mesh::Edge_index, bool>("e:on_curve", false).first;
  build_mesh(divided, points, mesh, parameters::edge_is_constrained_map(on_curve));
  Polygons result = make_polygons(mesh, mesh.points());
  mark_features(mesh, on_curve, result);
  return result;
}

inline Smooth_grid smooth_grid(const Integer_grid_map& map, const Quad_layout& layout,
                               const std::vector<int>& divisions, const Surface_walk& walk,
                               int number_of_iterations, const Monitor& monitor)
{
  Divided_layout divided(layout, divisions);
  Polygons polygons = polygons_of(divided,
                                  grid_points(Layout_tracer(map, layout, divisions), divided));
  Quad_smoother smoother(polygons, walk);
  smoother.run(number_of_iterations, monitor);
  std::vector<int> bad_quads = smoother.bad_quads();
  return {std::move(divided), std::move(polygons.points), std::move(bad_quads)};
}

// divides the edges of the chords through the bad quads of a grid into twice as many parts
inline void refine_at_bad_quads(const Smooth_grid& grid, std::vector<int>& divisions)
{
  const Quad_layout& layout = grid.divided.layout();
  std::vector<int> face_of_quad;
  grid.divided.for_each_quad([&](int f, const auto&) { face_of_quad.push_back(f); });
  std::set<int> chords;
  for (const int q : grid.bad_quads) {
    const int h = layout.halfedge_of(face_of_quad[q]);
    chords.insert(layout.chord(Quad_layout::edge(h)));
    chords.insert(layout.chord(Quad_layout::edge(layout.next(h))));
  }
  for (const int c : chords)
    divisions[c] *= 2;
}

// Returns the grid with the fewest bad quads of those that refinement leads to, as long as it does
// not get much finer by that.
inline Smooth_grid best_smooth_grid(const Integer_grid_map& map, const Quad_layout& layout,
                                    std::vector<int> divisions, const Triangle_surface& surface,
                                    int number_of_iterations, const Monitor& monitor)
{
  constexpr int number_of_refinements = 3;
  constexpr double greatest_growth = 2.5;
  const Surface_walk walk(surface);
  const auto smoothed = [&] {
    return smooth_grid(map, layout, divisions, walk, number_of_iterations, monitor);
  };
  Smooth_grid best = smoothed(), latest = best;
  const double most_vertices = greatest_growth * double(best.points.size());
  for (int i = 0;
       i < number_of_refinements && !best.bad_quads.empty() && monitor.has_time("smooth_quad_mesh");
       ++i) {
    refine_at_bad_quads(latest, divisions);
    if (Divided_layout(layout, divisions).number_of_vertices() > most_vertices)
      break;
    latest = smoothed();
    if (latest.bad_quads.size() < best.bad_quads.size())
      best = latest;
  }
  return best;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_SMOOTH_GRID_H
