// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_OPTIONS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_OPTIONS_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/Deviation_limits.h>
#include <CGAL/Quad_layouts/internal/quantization/Quantization_program.h>
#include <CGAL/Quad_layouts/internal/quantization/read_wishes.h>
#include <CGAL/Quad_layouts/internal/require_parameter.h>
#include <CGAL/Quad_layouts/internal/running_time_limit.h>
#include <CGAL/Quad_layouts/parameters.h>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// What is wanted of a quantization, and how long it may take.
struct Quantization_options
{
  Quantization_demands demands;
  Quantization_wishes wishes;
  double seconds;        // for everything
  double search_seconds; // after the first solution
  double relative_gap;
  int concurrent_searches;
};

// takes the options out of named parameters, and checks them
template <class NamedParameters>
Quantization_options quantization_options(const T_mesh& t_mesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const Deviation_limits limits = deviation_limits(t_mesh.surface(), np);
  const int least = choose_parameter(get_parameter(np, internal_np::minimum_valence), 3);
  const int most = choose_parameter(get_parameter(np, internal_np::maximum_valence), 8);
  const double search = choose_parameter(get_parameter(np, internal_np::maximum_search_time), 30.);
  const double gap = choose_parameter(get_parameter(np, internal_np::relative_gap), 0.01);
  const int searches = choose_parameter(get_parameter(np, internal_np::concurrent_searches), 1);

  require_parameter(least >= 2 && least <= 4, "minimum_valence", least, "in 2 to 4");
  require_parameter(most >= 4, "maximum_valence", most, "at least 4");
  require_parameter(search > 0, "maximum_search_time", search, "a number > 0");
  require_parameter(gap >= 0 && gap <= 1, "relative_gap", gap, "in 0 to 1");
  require_parameter(searches >= 1, "concurrent_searches", searches, "at least 1");
  return {{limits.tangent, 2 * limits.displacement, 4 - most, 4 - least},
          quantization_wishes(t_mesh, np),
          running_time_limit(np),
          search,
          gap,
          searches};
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_OPTIONS_H
