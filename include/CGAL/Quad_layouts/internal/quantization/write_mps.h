// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WRITE_MPS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WRITE_MPS_H

#include <CGAL/Quad_layouts/internal/quantization/Program_search.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

namespace mps {

using Row = Program_search::Row;

inline bool is_equation(const Row& row)
{
  return row.low == row.high;
}
inline char type(const Row& row)
{
  return is_equation(row) ? 'E' : std::isfinite(row.low) ? 'G' : 'L';
}
inline double right_side(const Row& row)
{
  return std::isfinite(row.low) ? row.low : row.high;
}

inline void write_rows(std::ostream& out, const Program_search& program)
{
  out << "ROWS\n N cost\n";
  for (std::size_t i = 0; i < program.rows.size(); ++i)
    out << ' ' << type(program.rows[i]) << " r" << i << '\n';
}

inline void write_columns(std::ostream& out, const Program_search& program)
{
  std::vector<double> cost(program.columns.size(), 0);
  for (const auto& [column, coefficient] : program.objective)
    cost[column] = coefficient;
  std::vector<Program_search::Terms> entries(program.columns.size()); // row, coefficient
  for (std::size_t i = 0; i < program.rows.size(); ++i)
    for (const auto& [column, coefficient] : program.rows[i].terms)
      entries[column].emplace_back(int(i), coefficient);

  out << "COLUMNS\n";
  bool is_integer = false;
  for (std::size_t j = 0; j < program.columns.size(); ++j) {
    if (is_integer != program.columns[j].is_integer) {
      is_integer = !is_integer;
      out << " marker 'MARKER' " << (is_integer ? "'INTORG'\n" : "'INTEND'\n");
    }
    out << " x" << j << " cost " << cost[j] << '\n';
    for (const auto& [row, coefficient] : entries[j])
      out << " x" << j << " r" << row << ' ' << coefficient << '\n';
  }
  if (is_integer)
    out << " marker 'MARKER' 'INTEND'\n";
}

inline void write_right_sides(std::ostream& out, const Program_search& program)
{
  out << "RHS\n rhs cost " << -program.objective_offset << '\n';
  for (std::size_t i = 0; i < program.rows.size(); ++i)
    out << " rhs r" << i << ' ' << right_side(program.rows[i]) << '\n';
  out << "RANGES\n";
  for (std::size_t i = 0; i < program.rows.size(); ++i) {
    const Row& row = program.rows[i];
    if (!is_equation(row) && std::isfinite(row.low) && std::isfinite(row.high))
      out << " range r" << i << ' ' << row.high - row.low << '\n';
  }
}

// all are written: some readers take integers without bounds for binary
inline void write_bounds(std::ostream& out, const Program_search& program)
{
  const auto write = [&](const char* finite, const char* infinite, std::size_t j, double bound) {
    if (std::isfinite(bound))
      out << ' ' << finite << " bound x" << j << ' ' << bound << '\n';
    else
      out << ' ' << infinite << " bound x" << j << '\n';
  };
  out << "BOUNDS\n";
  for (std::size_t j = 0; j < program.columns.size(); ++j) {
    write("LO", "MI", j, program.columns[j].low);
    write("UP", "PL", j, program.columns[j].high);
  }
}

} // namespace mps

// Writes a program that is to be minimized in free MPS format. Column i is called x<i>, row i is
// called r<i>.
inline void write_mps(std::ostream& out, const Program_search& program)
{
  CGAL_precondition(!program.maximize);
  out.precision((std::numeric_limits<double>::max_digits10));
  out << "NAME quantization FREE\n"; // some readers have to be told that columns are not fixed
  mps::write_rows(out, program);
  mps::write_columns(out, program);
  mps::write_right_sides(out, program);
  mps::write_bounds(out, program);
  out << "ENDATA\n";
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WRITE_MPS_H
