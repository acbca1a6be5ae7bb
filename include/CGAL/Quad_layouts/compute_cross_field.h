// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_COMPUTE_CROSS_FIELD_H
#define CGAL_QUAD_LAYOUTS_COMPUTE_CROSS_FIELD_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/field/face_vectors.h>
#include <CGAL/Quad_layouts/internal/field/smooth_cross_field.h>
#include <CGAL/Quad_layouts/internal/parametrization/Given_charts.h>
#include <CGAL/Quad_layouts/internal/require_parameter.h>
#include <CGAL/Quad_layouts/internal/surface/fix_constrained_edges.h>
#include <CGAL/Quad_layouts/internal/surface/separate_fixed_curves.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/visitor.h>

#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

namespace internal {

// throws unless the options are in their ranges
inline void check_field_options(const Cross_field_options& options)
{
  require_not_negative("curvature_alignment", options.curvature_alignment);
  require_positive("diffusion_time", options.diffusion_time);
  require_parameter(options.number_of_iterations >= 1, "number_of_iterations",
                    options.number_of_iterations, "at least 1");
}

} // namespace internal

/*!
\ingroup PkgQuadLayoutsFunctions

computes a smooth cross field on a triangle mesh, or completes one that is given.

A smooth field minimises the difference between adjacent faces, softly aligned to the directions of
principal curvature and exactly to the directions that are prescribed. There are two methods.
`DIFFUSION` is that of Merriman, Bence and Osher (Viertel and Osting, <em>An approach to quad
meshing based on harmonic cross-valued maps and the Ginzburg-Landau theory</em>, 2019).
`MIXED_INTEGER` chooses how often the field turns by a right angle from face to face, by greedy
rounding (Bommes, Zimmer and Kobbelt,
<em>Mixed-integer quadrangulation</em>, 2009) and a local search. It takes longer and finds smoother
fields with fewer singularities, but the lines of the field join them less often: layouts tend to
have more patches. Then singularities of valence 2 and less are spread over several vertices where
the mesh has them; in such places the matching is not always the one that turns the field least. A
given field keeps its directions; only the matchings and indices are computed.

Along *fixed* edges, which are those on the border and the constrained ones, the field always has
the direction of the edges, also where another direction is prescribed or given. Between two of them
that follow each other around a vertex it has a quadrant at least, however acute the angle is. On
the field's surface, other edges that join two vertices of fixed ones are divided, and so are faces
with three fixed edges: a field needs room.

The indices of the field sum to four times the Euler characteristic. The components of the mesh do
not influence one another, neither do scale and position; and the same input has the same output on
every run.

@tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
@tparam NamedParameters a sequence of named parameters

@param tm the surface, with or without border, with triangles that are not degenerate
@param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{curvature_alignment}
    \cgalParamDescription{how strongly the field follows the directions of principal curvature, and
                          so sharp edges: 0 for not at all; large values keep more of the details
                          and of the noise of a scanned surface in the field}
    \cgalParamType{double}
    \cgalParamDefault{`0.07`}
    \cgalParamExtra{It must not be negative.}
  \cgalParamNEnd
  \cgalParamNBegin{cross_field_method}
    \cgalParamDescription{how a smooth field is found}
    \cgalParamType{`Cross_field_method`}
    \cgalParamDefault{`DIFFUSION`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges of feature curves, which are kept: they are lines of the field,
                          of the T-mesh and of the layout, and quad vertices stay on them}
    \cgalParamType{a class model of `ReadablePropertyMap` with the edge descriptor of `TriangleMesh`
                   as key type and `bool` as value type}
    \cgalParamDefault{none: only the border is kept}
    \cgalParamExtra{The curves may be open, closed or branching.
                    `CGAL::Polygon_mesh_processing::detect_sharp_edges()` finds sharp edges.}
  \cgalParamNEnd
  \cgalParamNBegin{face_constraint_map}
    \cgalParamDescription{a direction for some of the faces, which one direction of the cross there
                          shall have; the null vector leaves a face free. Vectors are projected to
                          their faces.}
    \cgalParamType{a class model of `ReadablePropertyMap` with the face descriptor of `TriangleMesh`
                   as key type and a `Vector_3` of any %CGAL kernel as value type}
    \cgalParamDefault{all faces are free}
  \cgalParamNEnd
  \cgalParamNBegin{face_direction_map}
    \cgalParamDescription{the direction of the field in each face, up to projection to the face.
                          The parameters of smooth fields have no effect then.}
    \cgalParamType{a class model of `ReadablePropertyMap` with the face descriptor of `TriangleMesh`
                   as key type and a `Vector_3` of any %CGAL kernel as value type}
    \cgalParamDefault{a smooth field is computed}
  \cgalParamNEnd
  \cgalParamNBegin{diffusion_time}
    \cgalParamDescription{how far a step of `DIFFUSION` reaches: the time of a step, in squared
                          edge lengths. Short times keep more of the principal directions that the
                          diffusion starts from, long ones ignore small details of the surface.}
    \cgalParamType{double}
    \cgalParamDefault{`32`}
    \cgalParamExtra{It must be positive; values from 8 to 128 make sense.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the maximum number of steps of `DIFFUSION`, which ends earlier when the
                          field hardly changes}
    \cgalParamType{int}
    \cgalParamDefault{`40`}
    \cgalParamExtra{It must be positive.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of
                   `TriangleMesh` as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
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

\pre All faces of `tm` are triangles.

\throw Invalid_mesh if the mesh cannot be used; the derived class says why.
\throw Invalid_parameter if a parameter is out of its range, or a given direction is not finite or
       normal to its face, or, in `face_direction_map`, zero.
\throw Time_limit_exceeded if the work is not done within `maximum_running_time`.
\throw Cancelled if the visitor asks to stop.

The time is dominated by one sparse factorization and two triangular solutions a step, or some ten
factorizations for `MIXED_INTEGER`; it grows a little faster than the number of faces.
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Cross_field compute_cross_field(const TriangleMesh& tm,
                                const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  internal::Cross_field_options options;
  options.method = choose_parameter(get_parameter(np, internal_np::cross_field_method),
                                    options.method);
  options.curvature_alignment = choose_parameter(
      get_parameter(np, internal_np::curvature_alignment), options.curvature_alignment);
  options.diffusion_time = choose_parameter(get_parameter(np, internal_np::diffusion_time),
                                            options.diffusion_time);
  options.number_of_iterations = choose_parameter(
      get_parameter(np, internal_np::number_of_iterations), options.number_of_iterations);
  internal::check_field_options(options);

  const auto directions = internal::read_face_vectors(
      tm, get_parameter(np, internal_np::face_direction_map));
  const auto constraints = internal::read_face_vectors(
      tm, get_parameter(np, internal_np::face_constraint_map));

  const internal::Monitor monitor = internal::monitor_from(np);
  return monitor.run("compute_cross_field", [&] {
    const auto surface = std::make_shared<const internal::Triangle_surface>(
        internal::separate_fixed_curves(internal::surface_with_fixed_edges(tm, np)));
    monitor.check("compute_cross_field");
    return directions.empty() ? internal::smooth_cross_field(surface, constraints, options, monitor)
                              : internal::given_cross_field(surface, directions);
  });
}

/*!
\ingroup PkgQuadLayoutsFunctions

returns the cross field of the directions in which the lines of constant coordinates of a seamless
parametrization run: along fixed edges exactly, and elsewhere as if each triangle was mapped by the
rotation that is nearest to its map. Its surface is that of the parametrization.

The time is linear in the number of faces.
*/
inline Cross_field compute_cross_field(const Seamless_parametrization& map)
{
  std::vector<internal::Point2> corners;
  for (int h = 0; h < map.surface().number_of_halfedges(); ++h)
    corners.push_back(map.point(h));
  return internal::Given_charts(map.surface_pointer, std::move(corners)).field();
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_COMPUTE_CROSS_FIELD_H
