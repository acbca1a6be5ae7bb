// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LAZY_INDEX_ROWS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LAZY_INDEX_ROWS_H

#include <CGAL/Quad_layouts/internal/quantization/Reduced_program.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Where thousands of pairs are close, their indicators make the relaxation a hundred times as slow,
// while few index rows are ever violated. Then all rows are lazy: solvers do not see a row before a
// solution has violated it. Lower bounds hold without them. Small programs are solved faster with
// all rows from the start.
inline void make_index_rows_lazy_if_many(Reduced_program& program)
{
  constexpr std::size_t many_indicators = 1000;
  for (auto& row : program.index_rows)
    row.is_lazy = program.indicators.size() > many_indicators;
}

// says if the real values `x` violate an index row whatever the values of its indicators are, of
// those that `longest_path`, Q of Equation (3), allows
inline bool is_violated(const Reduced_program& program, const Reduced_program::Index_row& row,
                        const std::vector<double>& x, int longest_path)
{
  constexpr double tolerance = 1e-6;
  double least = row.base, most = row.base;
  for (const auto& term : row.terms) {
    double length = 0;
    for (int v : program.indicators[term.first].path)
      length += x[v];
    const double low = (std::max)(0., 1 - length);
    const double high = (std::max)(0., 1 - length / longest_path);
    least += term.second * (term.second > 0 ? low : high);
    most += term.second * (term.second > 0 ? high : low);
  }
  return least > row.high + tolerance || most < row.low - tolerance;
}

// lets solvers see the lazy rows that `x` violates, and says how many there are
inline int demand_index_rows(Reduced_program& program, const std::vector<double>& x,
                             int longest_path)
{
  int count = 0;
  for (auto& row : program.index_rows)
    if (row.is_lazy && is_violated(program, row, x, longest_path)) {
      row.is_lazy = false;
      ++count;
    }
  return count;
}

// the same for integers, where a path of any positive length separates
inline int demand_index_rows(Reduced_program& program, const std::vector<int>& x)
{
  return demand_index_rows(program, std::vector<double>(x.begin(), x.end()), 1);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_LAZY_INDEX_ROWS_H
