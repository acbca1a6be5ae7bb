// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_PARAMETRIZE_SEAMLESSLY_H
#define CGAL_QUAD_LAYOUTS_PARAMETRIZE_SEAMLESSLY_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Deviation_limits.h>
#include <CGAL/Quad_layouts/internal/parametrization/Index_repair.h>
#include <CGAL/Quad_layouts/internal/parametrization/Seamless_optimization.h>
#include <CGAL/Quad_layouts/internal/parametrization/Target_lengths.h>
#include <CGAL/Quad_layouts/internal/require_parameter.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/visitor.h>

#include <utility>

namespace CGAL {
namespace Quad_layouts {

namespace internal {

// what the search for a locally injective map may change
enum class Freedom { COORDINATES, COORDINATES_AND_INDICES };

inline Seamless_parametrization seamless_parametrization(const Cross_field& field,
                                                         const Target_lengths& lengths,
                                                         int most_steps, Freedom freedom,
                                                         const Monitor& monitor)
{
  const auto parametrize = [&](const Cross_field& any) {
    Seamless_optimization optimization(any, lengths, most_steps, monitor);
    optimization.align();
    return optimization.repaired_result();
  };
  Seamless_parametrization map = parametrize(field);
  if (map.is_locally_injective() || freedom == Freedom::COORDINATES)
    return map;
  return Index_repair(field, std::move(map), parametrize).run();
}

template <class NamedParameters>
Seamless_parametrization parametrize_seamlessly(const Cross_field& field, Freedom freedom,
                                                const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const double edge_length = target_edge_length(field.surface(), np);
  const int most_steps = choose_parameter(get_parameter(np, internal_np::number_of_iterations),
                                          100);
  require_parameter(most_steps >= 1, "number_of_iterations", most_steps, "at least 1");

  const Target_lengths lengths = read_target_lengths(
      field, edge_length, get_parameter(np, internal_np::target_edge_length_map));
  const Monitor monitor = monitor_from(np);
  return monitor.run("parametrize_seamlessly", [&] {
    return seamless_parametrization(field, lengths, most_steps, freedom, monitor);
  });
}

} // namespace internal

/*!
\ingroup PkgQuadLayoutsFunctions

computes a seamless parametrization that follows a cross field.

The surface is cut open to discs along a graph through all singularities. A map of the discs to the
plane minimises the deviation of its Jacobians from the directions of the field and the target edge
length (Bommes, Zimmer and Kobbelt, <em>Mixed-integer quadrangulation</em>, 2009), such that both
sides of each cut are equal up to quarter-turns and translations. These are real, not rounded to
integers: the parametrization is seamless, but no integer-grid map. Fixed edges of the field's
surface get a constant coordinate. Then inverted triangles are turned back by the regularized
distortion of Garanzha et al., <em>Foldover-free maps in 50 lines of code</em>, 2021, over the free
unknowns of the seamless maps, so that the map stays seamless. Vertices around which triangles cover
the wrong angle get their triangles spread over the right one first, and then the same is done
again. Where up to 100 defects are left, quarters of index are moved to neighbours of the vertices
that miss their angles, and the work begins anew, with its progress, until there are none, or no
move helps: the singularities of the result may differ from those of the field there. At last
coordinates are rounded to integer multiples of a power of two that satisfy all relations exactly
(Mandad and Campen, <em>Exact constraint satisfaction for truly seamless parametrization</em>,
2019), which is verified in integers.

The result counts what is not locally injective. There need not be a locally injective map for every
field and mesh, and not every one that there is will be found.

\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param field the cross field
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
        below

\cgalNamedParamsBegin
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length on the surface that a length of 1 in the map aims at}
    \cgalParamType{double}
    \cgalParamDefault{1 % of the bounding-box diagonal of the surface}
    \cgalParamExtra{It must be positive.}
  \cgalParamNEnd
  \cgalParamNBegin{target_edge_length_map}
    \cgalParamDescription{the same for each face, or two lengths for each: along directions 0 and 1
                          of the field in the face. The map follows them as closely as its seams and
                          fixed edges let it; lengths that change slowly are kept best.}
    \cgalParamType{a class model of `ReadablePropertyMap` with `int`, a face of `field.surface()`,
                   as key type and `double` or an array of two `double` as value type}
    \cgalParamDefault{`target_edge_length` for all faces}
    \cgalParamExtra{Lengths must be positive. `target_edge_length` still is the unit in which
                    `Seamless_parametrization::edge_length` and stages to come measure.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the maximum number of steps of the optimization, which ends earlier when
                          the map is locally injective and hardly changes}
    \cgalParamType{int}
    \cgalParamDefault{`100`}
    \cgalParamExtra{It must be positive.}
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
\throw Stage_failure if the system of equations cannot be solved, or the relations need numbers that
are too large.
\throw Time_limit_exceeded if the work is not done within `maximum_running_time`.
\throw Cancelled if the visitor asks to stop.

The time is dominated by one sparse factorization for each step. Moves of indices are tried with no
more than 100,000 triangles in sum.
*/
template <class NamedParameters = parameters::Default_named_parameters>
Seamless_parametrization parametrize_seamlessly(
    const Cross_field& field, const NamedParameters& np = parameters::default_values())
{
  return internal::parametrize_seamlessly(field, internal::Freedom::COORDINATES_AND_INDICES, np);
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_PARAMETRIZE_SEAMLESSLY_H
