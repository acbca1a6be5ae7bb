// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_COMPUTE_T_MESH_H
#define CGAL_QUAD_LAYOUTS_COMPUTE_T_MESH_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/running_time_limit.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/parametrize_seamlessly.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>
#include <CGAL/Quad_layouts/visitor.h>

namespace CGAL {
namespace Quad_layouts {

namespace internal {

// Layouts by a parametrization are simpler, but it takes long for a large surface, and hardly any
// map is locally injective that has a thousand cones between feature curves.
inline Layout_route automatic_route(const Cross_field& field)
{
  constexpr int most_faces = 100000, most_singularities = 1000;
  const bool is_fast = field.surface().number_of_faces() <= most_faces &&
                       field.number_of_singularities() <= most_singularities;
  return is_fast ? PARAMETRIZATION : FIELD;
}

template <class NamedParameters>
T_mesh t_mesh_of_parametrization(const Cross_field& field, Freedom freedom,
                                 const Time_budget& budget, const NamedParameters& np)
{
  const double half = budget.left_for("parametrize_seamlessly") / 2;
  const Seamless_parametrization map = parametrize_seamlessly(field, freedom,
                                                              with_time_limit(np, half));
  return trace_motorcycle_graph(map,
                                with_time_limit(np, budget.left_for("trace_motorcycle_graph")));
}

} // namespace internal

/*!
\ingroup PkgQuadLayoutsFunctions

computes the T-mesh of a cross field, in the field itself or by way of a seamless parametrization.

By the route `FIELD` it runs `trace_motorcycle_graph()`. By the route `PARAMETRIZATION` it runs
`parametrize_seamlessly()` first, and traces in the result, where lengths agree everywhere. If no
locally injective parametrization is found, or not in half of the time, it tells the visitor, and
goes on by the route `FIELD`. `T_mesh::route` says which one it was. Layouts by a parametrization
have fewer patches; but it takes long for large surfaces and many singularities, for which the route
`AUTOMATIC` is `FIELD`. So it is where indices would have to move for a locally injective
parametrization, because that would be too distorted for a simple layout.

\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param field the cross field
\param np an optional sequence of the named parameters of `parametrize_seamlessly()` and
          `trace_motorcycle_graph()`, and of the following ones

\cgalNamedParamsBegin
  \cgalParamNBegin{layout_route}
    \cgalParamDescription{what traces run in}
    \cgalParamType{`Layout_route`}
    \cgalParamDefault{`AUTOMATIC`}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{when to give up, in seconds}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{unlimited}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told the progress, and the reason if another route is taken, and can
                          stop the work}
    \cgalParamType{a class like `Default_visitor`}
    \cgalParamDefault{`Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throw Error one of the exceptions of `trace_motorcycle_graph()`.
*/
template <class NamedParameters = parameters::Default_named_parameters>
T_mesh compute_t_mesh(const Cross_field& field,
                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  Layout_route route = choose_parameter(get_parameter(np, internal_np::layout_route), AUTOMATIC);
  // a map that needs other indices than the field has is too distorted for simple layouts
  internal::Freedom freedom = internal::Freedom::COORDINATES_AND_INDICES;
  if (route == AUTOMATIC) {
    route = internal::automatic_route(field);
    freedom = internal::Freedom::COORDINATES;
  }
  const internal::Time_budget budget(internal::running_time_limit(np));
  const internal::Monitor visitor = internal::visitor_of(np);
  if (route == PARAMETRIZATION) {
    try {
      return internal::t_mesh_of_parametrization(field, freedom, budget, np);
    } catch (const Stage_failure& failure) {
      visitor.changed_route(failure.what());
    } catch (const Time_limit_exceeded& failure) {
      visitor.changed_route(failure.what());
    }
  }
  return trace_motorcycle_graph(
      field, internal::with_time_limit(np, budget.left_for("trace_motorcycle_graph")));
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_COMPUTE_T_MESH_H
