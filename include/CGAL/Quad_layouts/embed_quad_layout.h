// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_EMBED_QUAD_LAYOUT_H
#define CGAL_QUAD_LAYOUTS_EMBED_QUAD_LAYOUT_H

#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Deviation_limits.h>
#include <CGAL/Quad_layouts/internal/embedding/Layout_embedding.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/visitor.h>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsFunctions

maps a surface onto a quad layout: computes a locally injective integer-grid map.

The map is found by construction. The quantization maps the common refinement of surface and T-mesh
onto the layout, but takes whole regions to points and segments. These preimages of the layout's
vertices have neighbourhoods that are discs: in each one a vertex is chosen, and the edges of the
layout are led to it along disjoint paths. That embeds the layout on the mesh. Each of its faces is
then mapped to a rectangle of integer size by Tutte's method (\cgalCite{t-hdg-63}), on a coarse
version of the mesh in which the curves remain. From there the map minimizes a distortion that no
inverted triangle can reach (\cgalCite{g-fffl-21}), the curves being free to move and only the
irregular vertices held, and the removed vertices are brought back one by one, each inside the
kernel of its star. Only lists, integers and paths decide about the structure. Coordinates are
multiples of a power of two, which all charts express exactly.

The result is valid if no triangle is inverted *and* the angles around every vertex sum up to what
the layout says; both are verified, with exact predicates for the first. Beyond that every layout
edge is followed in the map and verified to lead to where the layout says, which proves that the
layout is embedded.

Triangles that the curves cross are divided, so the map comes with a surface of its own, which has
all the vertices of the surface of the T-mesh, and more behind them.

@tparam NamedParameters a sequence of named parameters

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
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{when to give up, in seconds}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{unlimited}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told the progress, and can stop the work}
    \cgalParamType{a class like `Default_visitor`}
    \cgalParamDefault{`Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throw Invalid_parameter if a parameter is out of its range.
\throw Stage_failure if no valid map was found, with the place where it failed. An invalid map is
never returned.
\throw Time_limit_exceeded if the work is not done within `maximum_running_time`.
\throw Cancelled if the visitor asks to stop.

The time is about linear in the number of triangles of the common refinement, plus that of
optimizing the coarse mesh, which grows with the number of layout vertices.
*/
template <class NamedParameters = parameters::Default_named_parameters>
Integer_grid_map embed_quad_layout(const T_mesh& t_mesh, const Quad_layout& layout,
                                   const NamedParameters& np = parameters::default_values())
{
  const double h = internal::target_edge_length(t_mesh.surface(), np);
  const internal::Monitor monitor = internal::monitor_from(np);
  return monitor.run("embed_quad_layout",
                     [&] { return internal::Layout_embedding(t_mesh, layout, h, monitor).map(); });
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_EMBED_QUAD_LAYOUT_H
