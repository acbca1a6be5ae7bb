// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_DEVIATION_LIMITS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_DEVIATION_LIMITS_H

#include <CGAL/Quad_layouts/internal/require_parameter.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/number_type_config.h>

#include <cmath>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// takes the named parameter of this name, and checks it
template <class NamedParameters>
double target_edge_length(const Triangle_surface& surface, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const double result = choose_parameter(get_parameter(np, internal_np::target_edge_length),
                                         0.01 * surface.diagonal());
  require_positive("target_edge_length", result);
  return result;
}

// How far layouts may be from the field.
struct Deviation_limits
{
  double tangent;      // of the largest angle between layout edges and traces
  double displacement; // of singularities, as a length
};

// takes them out of named parameters, and checks these
template <class NamedParameters>
Deviation_limits deviation_limits(const Triangle_surface& surface, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  constexpr double degree = CGAL_PI / 180;
  const double alpha = choose_parameter(get_parameter(np, internal_np::maximum_deviation), 15.);
  const double r = choose_parameter(get_parameter(np, internal_np::maximum_displacement), 2.);
  require_parameter(alpha > 0 && alpha < 90, "maximum_deviation", alpha,
                    "between 0 and 90 degrees");
  require_not_negative("maximum_displacement", r);
  return {std::tan(alpha * degree), r * target_edge_length(surface, np)};
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_DEVIATION_LIMITS_H
