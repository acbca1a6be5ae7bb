// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_INTEGER_ROW_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_INTEGER_ROW_H

#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The sum of coefficient * x[column] over the terms is at most `bound`. The terms are sorted.
struct Integer_row
{
  std::vector<std::pair<int, int>> terms; // column, coefficient
  int bound;

  double slack(const std::vector<double>& x) const
  {
    double result = bound;
    for (const auto& term : terms)
      result -= term.second * x[term.first];
    return result;
  }

  friend bool operator<(const Integer_row& a, const Integer_row& b)
  {
    return std::tie(a.terms, a.bound) < std::tie(b.terms, b.bound);
  }
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_INTEGER_ROW_H
