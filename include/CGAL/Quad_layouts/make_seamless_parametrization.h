// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_MAKE_SEAMLESS_PARAMETRIZATION_H
#define CGAL_QUAD_LAYOUTS_MAKE_SEAMLESS_PARAMETRIZATION_H

#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/parametrization/import_charts.h>
#include <CGAL/Quad_layouts/internal/require_parameter.h>
#include <CGAL/Quad_layouts/internal/surface/fix_constrained_edges.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/boost/graph/iterator.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

namespace internal {

// takes coordinates for the corners of the undivided surface
template <class NamedParameters>
Seamless_parametrization make_seamless_parametrization(const Triangle_surface& whole,
                                                       std::vector<Point2> corners,
                                                       const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const Given_charts charts(std::make_shared<const Triangle_surface>(whole), std::move(corners));
  charts.check();
  const double edge_length = choose_parameter(get_parameter(np, internal_np::target_edge_length),
                                              edge_length_of(charts));
  require_positive("target_edge_length", edge_length);
  return import_charts(charts_between_fixed_curves(charts), edge_length);
}

} // namespace internal

/*!
\ingroup PkgQuadLayoutsFunctions

makes a `Seamless_parametrization` of coordinates that the corners of triangles have been given
elsewhere.

The two sides of each edge must be the same vector up to quarter-turns, and fixed edges, as those on
the border, must have a constant coordinate; an error of a thousandth of the mean length of the
edges in the map is taken as rounding. The result has exact coordinates nearby: those that the
relations leave free are rounded to integers, and the others follow (Mandad and Campen, <em>Exact
constraint satisfaction for truly seamless parametrization</em>, 2019). Cones are where the
triangles around a vertex cover another angle than elsewhere. Triangles that are inverted or flat
are counted, but not refused.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam CornerMap a model of `ReadablePropertyMap` with the halfedge descriptor of `TriangleMesh` as
        key type and a `Point_2` of any %CGAL kernel as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the mesh
\param coordinates for each halfedge inside, the coordinates of the corner of its face at its target
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
        below

\cgalNamedParamsBegin
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length on the surface that a length of 1 in the map stands for}
    \cgalParamType{double}
    \cgalParamDefault{the one for which the map keeps the area of the surface}
    \cgalParamExtra{It must be positive.}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{says which edges are fixed, beside those on the border}
    \cgalParamType{a class model of `ReadablePropertyMap` with the edge descriptor of `TriangleMesh`
                   as key type and `bool` as value type}
    \cgalParamDefault{none is}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of
                   `TriangleMesh` as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throw Invalid_mesh if the mesh cannot be used; the derived class says why.
\throw Invalid_parameter if `target_edge_length` is out of its range.
\throw Invalid_parametrization if coordinates are not finite, the map is not seamless, or a fixed
       edge has no constant coordinate; the worst edge is named.
\throw Stage_failure if the relations need numbers that are too large.

The time is linear but for the relations along the seams, of which each is put into the others.
*/
template <class TriangleMesh, class CornerMap,
          class NamedParameters = parameters::Default_named_parameters>
Seamless_parametrization make_seamless_parametrization(
    const TriangleMesh& tm, CornerMap coordinates,
    const NamedParameters& np = parameters::default_values())
{
  const internal::Triangle_surface whole = internal::surface_with_fixed_edges(tm, np);
  std::vector<internal::Point2> corners;
  for (const auto f : faces(tm))
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, tm), tm)) {
      const auto& p = get(coordinates, prev(h, tm)); // the surface has corners at sources
      corners.emplace_back(to_double(p.x()), to_double(p.y()));
    }
  return internal::make_seamless_parametrization(whole, std::move(corners), np);
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_MAKE_SEAMLESS_PARAMETRIZATION_H
