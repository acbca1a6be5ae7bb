// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SEPARATE_FIXED_CURVES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SEPARATE_FIXED_CURVES_H

#include <CGAL/Quad_layouts/internal/surface/Face_division.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The coarser a mesh is, the less room it leaves for a field between fixed curves. No field can be
// aligned to several edges of one face; and a singularity that finds no vertex between two curves
// ends up on one of them, or with others in one vertex. Where fixed curves are joined by a face or
// an edge, the following makes room for three rows of vertices in between.

// returns the surface with faces that have three fixed edges split at their centroids
inline Triangle_surface split_fixed_faces(const Triangle_surface& surface)
{
  Face_division division(surface);
  for (int f = 0; f < surface.number_of_faces(); ++f)
    if (surface.is_fixed(3 * f) && surface.is_fixed(3 * f + 1) && surface.is_fixed(3 * f + 2))
      division.split_at_centroid(f);
  return division.result();
}

// returns the surface with those edges that join vertices of fixed curves, but are not fixed, split
inline Triangle_surface split_bridges(const Triangle_surface& surface)
{
  std::vector<char> is_on_curve(surface.number_of_vertices(), 0);
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    if (surface.is_fixed(h))
      is_on_curve[surface.source(h)] = is_on_curve[surface.target(h)] = 1;
  std::vector<int> bridges;
  for (int e = 0; e < surface.number_of_edges(); ++e) {
    const int h = surface.halfedge_of_edge(e);
    if (!surface.is_fixed(h) && is_on_curve[surface.source(h)] && is_on_curve[surface.target(h)])
      bridges.push_back(e);
  }
  Face_division division(surface);
  division.split(bridges);
  return division.result();
}

// the vertices for which there has to be more room: those from the number `first` on, and those
// inside of a fan of faces with a fixed boundary, which would get all of the index in there
inline std::vector<char> crowded_vertices(const Triangle_surface& surface, int first)
{
  std::vector<char> result(surface.number_of_vertices());
  for (int v = 0; v < surface.number_of_vertices(); ++v) {
    bool is_enclosed = surface.halfedge(v) >= 0 && surface.number_of_fixed_edges(v) == 0;
    surface.for_each_outgoing(v, [&](int h) {
      is_enclosed = is_enclosed && surface.is_fixed(Triangle_surface::next(h));
    });
    result[v] = v >= first || is_enclosed;
  }
  return result;
}

// returns the surface with the edges at some vertices split
inline Triangle_surface split_edges_at(const Triangle_surface& surface,
                                       const std::vector<char>& is_chosen)
{
  std::vector<int> edges;
  for (int e = 0; e < surface.number_of_edges(); ++e) {
    const int h = surface.halfedge_of_edge(e);
    if (is_chosen[surface.source(h)] || is_chosen[surface.target(h)])
      edges.push_back(e);
  }
  Face_division division(surface);
  division.split(edges);
  return division.result();
}

// returns the surface with faces divided such that none has several fixed edges, and that there are
// free vertices between any two fixed edges. Vertices and faces keep their numbers, and faces the
// source of their first halfedge; new ones follow.
inline Triangle_surface separate_fixed_curves(const Triangle_surface& surface)
{
  const Triangle_surface separate = split_bridges(split_fixed_faces(surface));
  return split_edges_at(separate, crowded_vertices(separate, surface.number_of_vertices()));
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_SEPARATE_FIXED_CURVES_H
