// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TRY_LAYOUT_ROUTES_H
#define CGAL_QUAD_LAYOUTS_TRY_LAYOUT_ROUTES_H

#include <CGAL/Quad_layouts/Layout_route.h>
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

makes something by a layout route, and by another one if it is not good.

It returns `attempt(route)` with the route in `np`. But if that is `AUTOMATIC`, and the attempt
fails, or takes a parametrization and leaves quads that are inverted or oppose the surface, it tells
the visitor and makes another attempt by the route `FIELD`: the two T-meshes differ enough for one
to be good where the other is not. Then it returns the result with fewer such quads, of two alike
the first.

\tparam Attempt a function object that takes a `Layout_route`, which it passes to
        `compute_t_mesh()`, and returns a movable object with two members: `route`, the
        `Layout_route` of the T-mesh, and `number_of_bad_quads`, what `extract_smooth_quad_mesh()`
        returns
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param attempt runs the stages from `compute_t_mesh()` on
\param np an optional sequence of the named parameters `layout_route` and `visitor` of
          `compute_t_mesh()`

\throw Error what the attempt throws; that of the second one, if both end in a `Stage_failure`.
*/
template <class Attempt, class NamedParameters = parameters::Default_named_parameters>
auto try_layout_routes(const Attempt& attempt,
                       const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const Layout_route asked = choose_parameter(get_parameter(np, internal_np::layout_route),
                                              AUTOMATIC);
  if (asked != AUTOMATIC)
    return attempt(asked);

  const internal::Monitor visitor = internal::visitor_of(np);
  std::optional<decltype(attempt(asked))> first;
  try {
    first.emplace(attempt(AUTOMATIC));
    if (first->number_of_bad_quads == 0 || first->route == FIELD)
      return std::move(*first);
    const std::string reason = std::to_string(first->number_of_bad_quads) + " bad quads";
    visitor.changed_route(reason.c_str());
  } catch (const Stage_failure& failure) {
    visitor.changed_route(failure.what());
  }
  if (!first)
    return attempt(FIELD);
  try {
    auto second = attempt(FIELD);
    return std::move(second.number_of_bad_quads < first->number_of_bad_quads ? second : *first);
  } catch (const Stage_failure&) { // the first attempt is still there
  } catch (const Time_limit_exceeded&) {
  }
  return std::move(*first);
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_TRY_LAYOUT_ROUTES_H
