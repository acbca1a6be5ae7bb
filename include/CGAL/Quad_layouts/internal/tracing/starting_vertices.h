// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_STARTING_VERTICES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_STARTING_VERTICES_H

#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/tracing/Labels.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// returns for every vertex the smallest vertex of its component
inline std::vector<int> components(const Triangle_surface& surface)
{
  std::vector<int> component(surface.number_of_vertices(), -1), stack;
  for (int v = 0; v < surface.number_of_vertices(); ++v) {
    if (component[v] >= 0)
      continue;
    component[v] = v;
    stack.push_back(v);
    while (!stack.empty()) {
      const int u = stack.back();
      stack.pop_back();
      surface.for_each_outgoing(u, [&](int h) {
        const int w = surface.target(h);
        if (component[w] < 0) {
          component[w] = v;
          stack.push_back(w);
        }
      });
    }
  }
  return component;
}

// Lets traces start at the first vertex of each closed curve of fixed edges, like a border, that
// would have no start otherwise. The curve must have one, and so must every patch at it, which
// would be no disc.
inline void start_on_each_fixed_curve(const Triangle_surface& surface, std::vector<char>& starts)
{
  Disjoint_sets curves(surface.number_of_vertices());
  std::vector<char> is_fixed(surface.number_of_vertices(), 0), has_start = is_fixed;
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    if (surface.is_fixed(h)) {
      curves.union_set(surface.source(h), surface.target(h));
      is_fixed[surface.source(h)] = is_fixed[surface.target(h)] = 1;
    }
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    has_start[curves.find_set(v)] |= starts[v];
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    if (is_fixed[v] && !has_start[curves.find_set(v)])
      starts[v] = has_start[curves.find_set(v)] = 1;
}

// returns the vertices where traces start, ascending: the singular ones, those where fixed curves
// end, meet or have corners, `seeds`, and the first vertex of each fixed curve and each component
// that would have none otherwise
inline std::vector<int> starting_vertices(const Labels& labels, const std::vector<int>& seeds)
{
  const Triangle_surface& surface = labels.surface();
  const std::vector<int> component = components(surface);
  std::vector<char> starts(surface.number_of_vertices(), 0), has_start = starts;
  for (int s : seeds)
    starts[s] = 1;
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    if (labels.index(v) != 0 || !labels.goes_straight_on(v))
      starts[v] = 1;
  start_on_each_fixed_curve(surface, starts);
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    has_start[component[v]] |= starts[v];
  std::vector<int> result;
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    if (surface.halfedge(v) >= 0 && (starts[v] || !has_start[component[v]])) {
      has_start[component[v]] = 1;
      result.push_back(v);
    }
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_STARTING_VERTICES_H
