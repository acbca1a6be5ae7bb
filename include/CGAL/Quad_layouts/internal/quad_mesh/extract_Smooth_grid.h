// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_SMOOTH_GRID_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_SMOOTH_GRID_H

#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/layout/divided_layout.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_Layout_tracer.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_build_mesh.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_grid_points.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Quad_smoother.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
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
  std::size_t number_of_bad_quads;     // which are inverted or oppose the surface
  std::set<int> bad_chords;            // those through bad quads
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

// returns the chords of the layout that run through some quads of the grid
inline std::set<int> chords_through(const std::vector<int>& quads, const Divided_layout& divided)
{
  const Quad_layout& layout = divided.layout();
  std::vector<int> face_of_quad;
  divided.for_each_quad([&](int f, const auto&) { face_of_quad.push_back(f); });
  std::set<int> result;
  for (const int q : quads) {
    const int h = layout.halfedge_of(face_of_quad[q]);
    result.insert(layout.chord(Quad_layout::edge(h)));
    result.insert(layout.chord(Quad_layout::edge(layout.next(h))));
  }
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
  const std::vector<int> bad_quads = smoother.bad_quads();
  std::set<int> bad_chords = chords_through(bad_quads, divided);
  return {std::move(divided), std::move(polygons.points), bad_quads.size(), std::move(bad_chords)};
}

// Divides the edges of some chords into twice as many parts, or less where that would lead to more
// than `most_vertices`, beginning with those for which it is cheapest. Tells if it divided any.
inline bool divide_chords(const std::set<int>& chords, const Quad_layout& layout,
                          double most_vertices, std::vector<int>& divisions)
{
  const auto number_of_vertices = [&] {
    return Divided_layout(layout, divisions).number_of_vertices();
  };
  std::vector<std::pair<int, int>> by_cost;
  for (const int c : chords) {
    divisions[c] *= 2;
    by_cost.emplace_back(number_of_vertices(), c);
    divisions[c] /= 2;
  }
  std::sort(by_cost.begin(), by_cost.end());
  bool any = false;
  for (const auto& [cost, c] : by_cost) {
    const int parts = divisions[c];
    for (int more = parts; more > 0 && divisions[c] == parts; more /= 2) {
      divisions[c] = parts + more;
      if (number_of_vertices() > most_vertices)
        divisions[c] = parts;
    }
    any = any || divisions[c] > parts;
  }
  return any;
}

// Divides the edges of bad chords into more parts, again and again as long as there are any and the
// grid does not get much finer. Returns the grid with the fewest bad quads.
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
  Smooth_grid best = smoothed();
  const double most_vertices = greatest_growth * double(best.points.size());
  std::set<int> bad_chords = best.bad_chords;
  for (int i = 0; i < number_of_refinements && !bad_chords.empty(); ++i) {
    if (!monitor.has_time("smooth_quad_mesh") ||
        !divide_chords(bad_chords, layout, most_vertices, divisions))
      break;
    Smooth_grid finer = smoothed();
    bad_chords = finer.bad_chords;
    if (finer.number_of_bad_quads < best.number_of_bad_quads)
      best = std::move(finer);
  }
  return best;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_SMOOTH_GRID_H
