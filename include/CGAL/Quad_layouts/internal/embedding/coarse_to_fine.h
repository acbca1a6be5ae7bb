// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_COARSE_TO_FINE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_COARSE_TO_FINE_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/embedding/Newton.h>
#include <CGAL/Quad_layouts/internal/embedding/Vertex_neighbourhood.h>
#include <CGAL/Quad_layouts/internal/embedding/Vertex_removal.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// How triangles are measured while a map is improved, and for how long.
struct Relaxation_stage
{
  Likeness likeness;
  int max_steps;
};

// Minimizes a measure of the distortion. Large maps get fewer steps, as each takes long.
template <class Measure>
void relax(Map& map, const std::vector<char>& is_fixed, const Relaxation_stage& stage,
           const Monitor& monitor)
{
  constexpr double large = 1e5;
  const double effort = (std::min)(1., large / double(map.faces.size()));
  const int max_steps = int(std::ceil(effort * stage.max_steps));
  Newton<Measure> newton(map, is_fixed, stage.likeness);
  double value = newton.value(), decrease = 1;
  for (int i = 0; i < max_steps && decrease > 1e-4; ++i) {
    monitor.check("embed");
    const double before = std::exchange(value, newton.step(value));
    decrease = (before - value) / before;
  }
}

// Moves a vertex by some Newton steps, and on as long as they help much: from near the border of the
// polygon around it, where the measure is large, each leads away by only a part of the distance.
template <class Measure>
void improve_vertex(Map& map, const Vertex_removal& levels, int v, int steps,
                    const Likeness& likeness = {})
{
  const Vertex_neighbourhood<Measure> neighbourhood(map, v, levels.star(v), likeness);
  constexpr double much = 0.75;
  constexpr int most_steps = 100;
  double part = 1;
  for (int i = 0; i < steps || (part < much && i < most_steps); ++i)
    part = neighbourhood.improve(map.coordinates[v]);
}

// Brings back removed vertices until `left` are left, each at a place where no triangle gets
// inverted, and smooths the map around it.
//
// Such a place exists: the vertex into which the removed one was collapsed sees the whole polygon.
// Throws if rounding hides it.
template <class Measure>
void restore(Map& map, Vertex_removal& levels, int left, const std::vector<char>& is_fixed,
             const Monitor& monitor, const Likeness& likeness = {})
{
  for (int i = 0; levels.number_of_removals() > left; ++i) {
    if (i % 1024 == 0)
      monitor.check("embed");
    const int v = levels.restore();
    if (!Vertex_neighbourhood<Measure>(map, v, levels.star(v), likeness)
             .find_center(map.coordinates[v]))
      throw Stage_failure("embed: there is no room in the map for vertex " + std::to_string(v));
    improve_vertex<Measure>(map, levels, v, 4, likeness);
    levels.for_each_neighbour(v, [&](int w) {
      if (!is_fixed[w])
        improve_vertex<Measure>(map, levels, w, 1, likeness);
    });
  }
}

// improves the places of all vertices that there are in turn, several times
template <class Measure>
void sweep(Map& map, const Vertex_removal& levels, const std::vector<char>& is_fixed,
           const Monitor& monitor)
{
  constexpr int sweeps = 4;
  for (int i = 0; i < sweeps; ++i) {
    monitor.check("embed");
    for (int v = 0; v < int(map.points.size()); ++v)
      if (!is_fixed[v] && !levels.star(v).empty())
        improve_vertex<Measure>(map, levels, v, 1);
  }
}

// Improves the map that is left of a map when vertices are removed. It has no inverted triangles,
// but may be far from the best. As long as all of them have room it is put on the grid: narrow ones,
// which come out of the relaxation, could be inverted by that.
//
// At first all triangles are measured as if they were of the same size and not narrow, so that none
// dominates; then more and more as they are. At last squares count: vertices move one by one before
// all do together, where single triangles would leave no step any length.
inline void relax_coarse_map(Map& map, const Vertex_removal& levels,
                             const std::vector<char>& is_fixed, const Monitor& monitor)
{
  const auto relax_all = [&](const auto& change) {
    Map coarse = levels.coarse_map();
    change(coarse);
    map.coordinates = std::move(coarse.coordinates);
    map.spacing = coarse.spacing;
  };
  relax_all([&](Map& coarse) {
    put_on_grid(coarse);
    for (const Relaxation_stage& stage : {Relaxation_stage{{1, 0.5}, 20}, {{0.75, 0.1}, 20},
                                          {{0.5, 0.02}, 20}, {{0.25, 0.005}, 20}, {{}, 20}})
      relax<Distortion>(coarse, is_fixed, stage, monitor);
  });
  sweep<Squared_distortion>(map, levels, is_fixed, monitor);
  relax_all([&](Map& coarse) {
    relax<Squared_distortion>(coarse, is_fixed, {{}, 50}, monitor);
  });
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_COARSE_TO_FINE_H
