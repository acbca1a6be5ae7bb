// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_EMBED_QUAD_LAYOUT_H
#define CGAL_QUAD_LAYOUTS_EMBED_QUAD_LAYOUT_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/embedding/Layout_embedding.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/visitor.h>

#include <cmath>
#include <string>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsFunctions

maps a surface onto a quad layout: computes a locally injective integer-grid map.

The mesh is not cut along the layout. Each triangle has a chart, and the changes of chart across the
edges of the mesh are products of those across the arcs of the T-mesh, which the quantization makes
integer. The cones of merged singularities are gathered in one of them. With the cones at their
integer points, the coordinates of all other vertices are found by untangling (\cgalCite{g-fffl-21})
and relaxing a coarse version of the mesh and then bringing back the removed vertices one by one,
each inside the kernel of its star. The result is valid if no triangle is inverted *and* the angles
around every vertex sum up to what the layout says; both are verified, with exact predicates for the
first. Beyond that every layout edge is followed in the map and verified to lead to where the layout
says, which proves that the layout is embedded.

Triangles around cones are split where the mesh is too coarse for a valid map, so the map comes with
a surface of its own, which has all the vertices of the surface of the field, and more behind them.

@tparam NamedParameters a sequence of named parameters

@param field the cross field that the T-mesh was traced in
@param t_mesh the T-mesh
@param layout the layout extracted from the T-mesh
@param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length of the edges of the quad mesh to come. It is the unit of the
                          map: an edge of the layout gets the length, rounded to an integer of at
                          least one, that it has on the surface in this unit.}
    \cgalParamType{double}
    \cgalParamDefault{one percent of the diagonal of the bounding box of the surface}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told the progress, and can stop the work}
    \cgalParamType{a class like `Default_visitor`}
    \cgalParamDefault{`Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throw Invalid_parameter if a parameter is out of its range.
\throw Stage_failure if no valid map was found. An invalid map is never returned.
\throw Cancelled if the visitor asks to stop.

The time is that of simplifying and refining the mesh, about linear in the number of triangles, plus
that of solving for the coarse mesh, which grows with the number of layout vertices.
*/
template <class NamedParameters = parameters::Default_named_parameters>
Integer_grid_map embed_quad_layout(const Cross_field& field, const T_mesh& t_mesh,
                                   const Quad_layout& layout,
                                   const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const double h = choose_parameter(get_parameter(np, internal_np::target_edge_length),
                                    0.01 * field.surface().diagonal());
  if (!(h > 0 && std::isfinite(h)))
    throw Invalid_parameter("target_edge_length is " + std::to_string(h) +
                            ", but must be positive and finite");
  const internal::Monitor monitor = internal::monitor_from(np);
  return monitor.run("embed_quad_layout", [&] {
    return internal::Layout_embedding(field, t_mesh, layout, h, monitor).map();
  });
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_EMBED_QUAD_LAYOUT_H
