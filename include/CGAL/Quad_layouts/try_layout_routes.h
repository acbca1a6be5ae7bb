// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TRY_LAYOUT_ROUTES_H
#define CGAL_QUAD_LAYOUTS_TRY_LAYOUT_ROUTES_H

#include <CGAL/Quad_layouts/Layout_route.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/visitor.h>

#include <optional>
#include <string>
#include <utility>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsFunctions

makes something of a T-mesh by a layout route, and again by another one if it is not good.

It returns `remesh(trace(route))` with the route in `np`. But if that is `AUTOMATIC`, and the T-mesh
is that of a parametrization, and what is made of it fails, or has quads that are inverted or oppose
the surface, it tells the visitor and returns `remesh(trace(FIELD))` if that has fewer such quads:
the two T-meshes differ enough for one to be good where the other is not.

\tparam Trace a function object that takes a `Layout_route` and returns the `T_mesh` that
        `compute_t_mesh()` gives for it
\tparam Remesh a function object that takes a `T_mesh` and returns a movable object with a member
        `number_of_bad_quads`, what `extract_smooth_quad_mesh()` returns
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param trace runs `compute_t_mesh()`
\param remesh runs the stages that follow
\param np an optional sequence of the named parameters `layout_route` and `visitor` of
          `compute_t_mesh()`

\throw Error what these functions throw. A `Stage_failure` or `Time_limit_exceeded` of the second
attempt is not an error if the first one has made something.
*/
template <class Trace, class Remesh, class NamedParameters = parameters::Default_named_parameters>
auto try_layout_routes(const Trace& trace, const Remesh& remesh,
                       const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const Layout_route asked = choose_parameter(get_parameter(np, internal_np::layout_route),
                                              AUTOMATIC);
  T_mesh t_mesh = trace(asked);
  if (asked != AUTOMATIC || t_mesh.route == FIELD)
    return remesh(std::move(t_mesh));

  const internal::Monitor visitor = internal::visitor_of(np);
  std::optional<decltype(remesh(std::move(t_mesh)))> first;
  try {
    first.emplace(remesh(std::move(t_mesh)));
    if (first->number_of_bad_quads == 0)
      return std::move(*first);
    const std::string reason = std::to_string(first->number_of_bad_quads) + " bad quads";
    visitor.changed_route(reason.c_str());
  } catch (const Stage_failure& failure) {
    visitor.changed_route(failure.what());
  }
  if (!first)
    return remesh(trace(FIELD));
  try {
    auto second = remesh(trace(FIELD));
    return std::move(second.number_of_bad_quads < first->number_of_bad_quads ? second : *first);
  } catch (const Stage_failure&) { // what the first attempt has made is still there
  } catch (const Time_limit_exceeded&) {
  }
  return std::move(*first);
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_TRY_LAYOUT_ROUTES_H
