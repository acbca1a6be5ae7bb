// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_FIX_CONSTRAINED_EDGES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_FIX_CONSTRAINED_EDGES_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>
#include <CGAL/Quad_layouts/internal/surface/make_triangle_surface.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// fixes the edges of `surface`, the working copy of `mesh`, for which `is_constrained` is true
template <class FaceGraph, class EdgeMap>
void fix_constrained_edges(const FaceGraph& mesh, EdgeMap is_constrained, Triangle_surface& surface)
{
  int h = 0; // the halfedges of each face are numbered in order
  for (const auto f : faces(mesh))
    for (const auto side : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      if (get(is_constrained, edge(side, mesh)))
        surface.fix(h);
      ++h;
    }
}

// does nothing, if there is no map
template <class FaceGraph>
void fix_constrained_edges(const FaceGraph&, const internal_np::Param_not_found&, Triangle_surface&)
{
}

// the working copy of a mesh whose faces are not divided, with the edges fixed that the named
// parameter `edge_is_constrained_map` says
template <class FaceGraph, class NamedParameters>
Triangle_surface surface_with_fixed_edges(const FaceGraph& mesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, mesh));
  Triangle_surface result = make_triangle_surface(mesh, points);
  fix_constrained_edges(mesh, get_parameter(np, internal_np::edge_is_constrained), result);
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_FIX_CONSTRAINED_EDGES_H
