// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TRACE_MOTORCYCLE_GRAPH_H
#define CGAL_QUAD_LAYOUTS_TRACE_MOTORCYCLE_GRAPH_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Deviation_limits.h>
#include <CGAL/Quad_layouts/internal/tracing/trace_in_field.h>
#include <CGAL/Quad_layouts/internal/tracing/trace_in_parametrization.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/visitor.h>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsFunctions

traces an extended motorcycle graph in a cross field: a partition of the surface into patches with
four corners.

From every singularity of the field, motorcycles set out in all directions of the field, and all
advance at the same speed. Unlike those of a motorcycle graph they pass the traces of others. A
motorcycle stops at a trace when, there or before, it has met on its left and on its right the trace
of a singularity to which a layout edge would be acceptable (\cgalCite{lck-sqlrs-21}, Sections 3.1
and 4.3): one that deviates from the field by at most `maximum_deviation` when both singularities
are moved by up to `maximum_displacement`. So the result has a node wherever the quantization has to
decide between layout edges.

Traces of one family can neither merge nor cross, because each triangle maps the sides through which
lines enter monotonically to those through which they leave (Ray and Sokolov, <em>Robust polylines
tracing for N-symmetry direction field on triangulated surfaces</em>, 2014); the order of traces
along edges is kept explicitly, so rounding cannot change the partition. Traces around limit cycles
end when they are many times as long as the surface is wide. A component without singularities gets
a seed, a regular vertex from which four traces start.

Traces that wind around a limit cycle can leave arcs between them that have length 0 in all
consistent quantizations. Where such arcs join singularities, these traces are not extended: they
stop at the first trace that they meet, as in a motorcycle graph. So quantizations can keep all
singularities apart, but for those that fall together even if no trace at all is extended: to a
single pair of valence 3 and 5 on a torus, for instance, no quad mesh belongs
(\cgalCite{ikrss-ntt-13}). Where fixed curves would fall together even so, further pairs of
singularities, of valence 3 and 5, are put between them (\cgalCite{mpz-rfagp-14}), or quarters of
index are moved from vertex to vertex near the place, which may change the singularities and
the corners of the curves there.

The border and other fixed curves are made of traces, too. Motorcycles that get to the border stop;
fixed lines inside of the surface count as traces that start at both their ends. Closed fixed curves
without corners get a seed.

Where the field turns too fast for its triangles, the index of a singularity may appear at a
neighbor of its vertex, and vertices at which no line would start (index 4 and more), or only one,
which no quad mesh has, share their index with their neighbors. The indices in the T-mesh are those
that the traces obey; their sum is four times the Euler characteristic.

@tparam NamedParameters a sequence of named parameters

@param field a cross field
@param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{maximum_deviation}
    \cgalParamDescription{the angle, in degrees, by which layout edges may deviate from the field.
                          Small angles give long traces and large T-meshes.}
    \cgalParamType{double}
    \cgalParamDefault{`15`}
    \cgalParamExtra{It must be greater than 0 and less than 90.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_displacement}
    \cgalParamDescription{how far singularities may move, in units of the target edge length}
    \cgalParamType{double}
    \cgalParamDefault{`2`}
    \cgalParamExtra{It must not be negative.}
  \cgalParamNEnd
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length of the edges of the quad mesh to come}
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
\throw Stage_failure if the result is not a partition into discs with four corners; this is
       always checked.
\throw Time_limit_exceeded if the work is not done within `maximum_running_time`.
\throw Cancelled if the visitor asks to stop.

The time is about linear in the number of triangles that all traces cross, plus the crossings of
traces in them.
*/
template <class NamedParameters = parameters::Default_named_parameters>
T_mesh trace_motorcycle_graph(const Cross_field& field,
                              const NamedParameters& np = parameters::default_values())
{
  const internal::Deviation_limits limits = internal::deviation_limits(field.surface(), np);
  const internal::Monitor monitor = internal::monitor_from(np);
  return monitor.run("trace_motorcycle_graph", [&] {
    return internal::trace_in_field(field, limits.tangent, limits.displacement, monitor);
  });
}

/*!
\ingroup PkgQuadLayoutsFunctions

traces an extended motorcycle graph in a seamless parametrization, along lines of constant
coordinates.

Motorcycles start at the cones, and stop by the same rule as in a cross field. Their lengths are
those in the map: integer multiples of its unit, and exact, so that opposite sides of each patch
have exactly the same length. Integers alone decide which way lines take, which are crossed first,
and where they meet.

Lines that run through a vertex, along an edge or over another line, as they do on symmetric
surfaces, are decided by one rule: all lines are turned right by the same infinitesimal angle. So
they pass all vertices on their right, cones included, and a node may be at distance 0 from others.
`quantize()` can be told by `lock_alignments` to keep such cones on one line.

@tparam NamedParameters a sequence of named parameters

@param map a seamless parametrization, which must be locally injective
@param np an optional sequence of the same named parameters as for cross fields

@throw Invalid_parameter if a parameter is out of its range.
@throw Stage_failure if the parametrization is not exact or not locally injective, or if the result
       is not a partition into discs with four corners the opposite sides of which have equal
       lengths; this is always checked.
@throw Time_limit_exceeded if the work is not done within `maximum_running_time`.
@throw Cancelled if the visitor asks to stop.
*/
template <class NamedParameters = parameters::Default_named_parameters>
T_mesh trace_motorcycle_graph(const Seamless_parametrization& map,
                              const NamedParameters& np = parameters::default_values())
{
  const internal::Deviation_limits limits = internal::deviation_limits(map.surface(), np);
  const internal::Monitor monitor = internal::monitor_from(np);
  return monitor.run("trace_motorcycle_graph", [&] {
    return internal::trace_in_parametrization(map, limits.tangent, limits.displacement, monitor);
  });
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_TRACE_MOTORCYCLE_GRAPH_H
