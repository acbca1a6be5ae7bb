// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_EMBEDDED_LAYOUT_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_EMBEDDED_LAYOUT_H

#include <CGAL/Quad_layouts/internal/embedding/Curve_mesh.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A layout drawn on a triangle mesh: its vertices are vertices of the mesh, its edges disjoint
// paths of edges. The curves of the mesh are the halfedges of the layout.
struct Embedded_layout
{
  Curve_mesh mesh;
  std::vector<int> vertices; // per layout vertex its place on the mesh
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_EMBEDDED_LAYOUT_H
