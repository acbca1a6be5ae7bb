// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_RUNNING_TIME_LIMIT_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_RUNNING_TIME_LIMIT_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/require_parameter.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <limits>
#include <string>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// returns `maximum_running_time` in `np`, or else `unlimited`; throws unless it is positive
template <class NamedParameters>
double running_time_limit(const NamedParameters& np,
                          double unlimited = (std::numeric_limits<double>::infinity)())
{
  const double seconds = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::maximum_running_time), unlimited);
  require_parameter(seconds > 0, "maximum_running_time", seconds, "a number > 0");
  return seconds;
}

// The time that a chain of stages has all together.
class Time_budget
{
public:
  explicit Time_budget(double seconds) : m_seconds(seconds) { m_timer.start(); }

  // the seconds that are left for `stage` and what follows; throws if there are none
  double left_for(const char* stage) const
  {
    const double left = m_seconds - m_timer.time();
    if (left <= 0)
      throw Time_limit_exceeded(std::string(stage) + ": no time is left for it");
    return left;
  }

  // the seconds that are left, hardly any if there are none: for what may end at any time
  double left_for_improvement() const
  {
    constexpr double hardly_any = 1e-3;
    return (std::max)(hardly_any, m_seconds - m_timer.time());
  }

  // the seconds for the search of a quantization: what comes afterwards may take as long again
  double left_for_quantization() const { return left_for("quantize") / 2; }

private:
  double m_seconds;
  Real_timer m_timer;
};

// returns the pack with another time limit
template <class NamedParameters>
auto with_time_limit(const NamedParameters& np, double seconds)
{
  return append<CGAL::internal_np::maximum_running_time_t>(np, seconds);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_RUNNING_TIME_LIMIT_H
