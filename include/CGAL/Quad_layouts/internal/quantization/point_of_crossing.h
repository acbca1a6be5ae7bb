// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_POINT_OF_CROSSING_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_POINT_OF_CROSSING_H

#include <CGAL/Quad_layouts/T_mesh.h>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// returns where an arc crosses an edge of the surface
inline T_mesh::Point point_of(const T_mesh& t_mesh, const T_mesh::Crossing& crossing)
{
  const T_mesh::Surface& surface = t_mesh.surface();
  const int e = surface.edge(crossing.halfedge), h = surface.halfedge_of_edge(e);
  const double t = t_mesh.crossing_parameters[e][crossing.position];
  return (1 - t) * surface.point(surface.source(h)) + t * surface.point(surface.target(h));
}

// returns the length on the surface of a piece of an edge that an arc runs along
inline double length_of_piece(const T_mesh& t_mesh, const T_mesh::Crossing& piece)
{
  const int e = t_mesh.surface().edge(piece.halfedge), k = piece.position;
  const std::vector<double>& nodes = t_mesh.crossing_parameters[e];
  const double begin = k == 0 ? 0 : nodes[k - 1];
  const double end = k == int(nodes.size()) ? 1 : nodes[k];
  return (end - begin) * t_mesh.surface().length(piece.halfedge);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_POINT_OF_CROSSING_H
