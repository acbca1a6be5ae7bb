// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_MOTORCYCLES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_MOTORCYCLES_H

#include <CGAL/Quad_layouts/internal/tracing/Squeezed_singularities.h>
#include <CGAL/Quad_layouts/internal/tracing/T_mesh_assembly.h>
#include <CGAL/Quad_layouts/internal/tracing/check_t_mesh.h>
#include <CGAL/Quad_layouts/internal/tracing/starting_vertices.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// returns the rule for stopping. Traces that are many times longer than the surface is wide run
// around a limit cycle or into a spiral; the first goes on forever, the second has finite length
// but no last triangle.
inline Motorcycles::Rule stopping_rule(const Triangle_surface& surface, double tangent,
                                       double displacement)
{
  double area = 0;
  for (int f = 0; f < surface.number_of_faces(); ++f)
    area += surface.area(f);
  const int steps = 1000 + int(100 * std::sqrt(double(surface.number_of_faces())));
  return {tangent, displacement, 50 * std::sqrt(area), steps};
}

// returns a vertex of face f, or of the faces around it, at which no trace starts
inline int seed_beside(const Labels& labels, int f)
{
  const Triangle_surface& surface = labels.surface();
  int seed = -1;
  for (int h = 3 * f; h < 3 * f + 3 && seed < 0; ++h)
    surface.for_each_outgoing(surface.source(h), [&](int g) {
      const int v = surface.target(g);
      if (seed < 0 && labels.index(v) == 0 && surface.number_of_fixed_edges(v) == 0)
        seed = v;
    });
  return seed;
}

// Traces the extended motorcycle graph of what `RouteChords` run in, a field or a parametrization of a
// surface; `tangent` is that of the maximum deviation, `displacement` a length.
template <class RouteChords, class Route>
T_mesh trace_motorcycles(const std::shared_ptr<const Triangle_surface>& surface, const Route& route,
                         const Labels& labels, double tangent, double displacement,
                         const Monitor& monitor)
{
  const Motorcycles::Rule rule = stopping_rule(*surface, tangent, displacement);
  std::vector<int> seeds;
  std::vector<char> is_hasty;
  for (;;) {
    RouteChords chords(route, labels);
    Motorcycles motorcycles(chords, rule, starting_vertices(labels, seeds), is_hasty);
    const int lonely = motorcycles.run(monitor);
    if (lonely < 0) {
      T_mesh result = T_mesh_assembly(surface, chords, motorcycles)();
      check_t_mesh(result);
      if (Squeezed_singularities(result).release(is_hasty))
        continue;
      return result;
    }
    // A trace that runs through a region without singularities meets those of a seed there.
    const int seed = seed_beside(labels, lonely);
    if (seed < 0 || std::find(seeds.begin(), seeds.end(), seed) != seeds.end())
      throw Stage_failure("trace_motorcycle_graph: a trace in face " + std::to_string(lonely) +
                          " finds no other to stop at");
    seeds.push_back(seed);
    is_hasty.clear(); // traces are numbered by their starts
  }
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_MOTORCYCLES_H
