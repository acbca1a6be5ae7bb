// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_LAYOUT_ROUTE_H
#define CGAL_QUAD_LAYOUTS_LAYOUT_ROUTE_H

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsFunctions

names the ways from a cross field to a T-mesh, see `compute_t_mesh()`.
*/
enum Layout_route {
  FIELD,           ///< traces run along the directions of the field
  PARAMETRIZATION, ///< traces are lines of constant coordinates of a seamless parametrization
  AUTOMATIC ///< `PARAMETRIZATION` up to 100,000 triangles and 1,000 singularities, `FIELD` beyond;
            ///< the whole chain also tries `FIELD` if it leads to inverted quads or to no layout
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_LAYOUT_ROUTE_H
