// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_REQUIRE_PARAMETER_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_REQUIRE_PARAMETER_H

#include <CGAL/Quad_layouts/exceptions.h>

#include <cmath>
#include <string>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// throws unless what is demanded of a parameter holds
template <class Number>
void require_parameter(bool holds, const char* name, Number value, const char* demand)
{
  if (!holds)
    throw Invalid_parameter(std::string(name) + ": " + std::to_string(value) + " is not " + demand);
}

inline void require_positive(const char* name, double value)
{
  require_parameter(value > 0 && std::isfinite(value), name, value, "a finite number > 0");
}

inline void require_not_negative(const char* name, double value)
{
  require_parameter(value >= 0 && std::isfinite(value), name, value, "a finite number >= 0");
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_REQUIRE_PARAMETER_H
