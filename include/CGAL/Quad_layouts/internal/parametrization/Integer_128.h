// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_INTEGER_128_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_INTEGER_128_H

#include <boost/multiprecision/cpp_int.hpp>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// holds sums of products of two coordinates or lengths of a parametrization
using Integer_128 = boost::multiprecision::int128_t;

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_INTEGER_128_H
