// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WRITE_MPS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WRITE_MPS_H

#include <CGAL/Mixed_integer_program_traits.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Writes a mixed integer program that is to be minimized in free MPS format. Column i is called x<i>,
// row i is called r<i>, the objective `cost`.
class Mps_writer
{
public:
  using Program = CGAL::Mixed_integer_program_traits<double>;

  Mps_writer(std::ostream& out, const Program& program)
    : m_out(out), m_program(program), m_entries(program.number_of_variables())
  {
    transpose();
    m_out.precision((std::numeric_limits<double>::max_digits10));
    m_out << "NAME quantization\n";
    write_rows();
    write_columns();
    write_right_sides();
    write_bounds();
    m_out << "ENDATA\n";
  }

private:
  using Variable = Program::Variable;

  static bool is_finite(double x) { return -Variable::infinity() < x && x < Variable::infinity(); }

  struct Range
  {
    double low, high;
    bool is_equation() const { return low == high; }
    char type() const { return is_equation() ? 'E' : is_finite(low) ? 'G' : 'L'; }
    double right_side() const { return is_finite(low) ? low : high; }
  };

  Range range(std::size_t row) const
  {
    const Program::Linear_constraint& constraint = *m_program.constraints()[row];
    Range result;
    constraint.get_bounds(result.low, result.high);
    result.low -= constraint.offset();
    result.high -= constraint.offset();
    return result;
  }

  // coefficients are stored by address; their order must not depend on it
  void transpose()
  {
    for (std::size_t i = 0; i < m_program.number_of_constraints(); ++i)
      for (const auto& [variable, coefficient] : m_program.constraints()[i]->coefficients())
        m_entries[variable->index()].emplace_back(int(i), coefficient);
    for (auto& entries : m_entries)
      std::sort(entries.begin(), entries.end());
  }

  void write_rows()
  {
    m_out << "ROWS\n N cost\n";
    for (std::size_t i = 0; i < m_program.number_of_constraints(); ++i)
      m_out << ' ' << range(i).type() << " r" << i << '\n';
  }

  void write_columns()
  {
    m_out << "COLUMNS\n";
    bool is_integer = false;
    for (const Variable* v : m_program.variables()) {
      if (is_integer != (v->variable_type() != Variable::CONTINUOUS)) {
        is_integer = !is_integer;
        m_out << " marker 'MARKER' " << (is_integer ? "'INTORG'\n" : "'INTEND'\n");
      }
      m_out << " x" << v->index() << " cost " << cost(v) << '\n';
      for (const auto& [row, coefficient] : m_entries[v->index()])
        m_out << " x" << v->index() << " r" << row << ' ' << coefficient << '\n';
    }
    if (is_integer)
      m_out << " marker 'MARKER' 'INTEND'\n";
  }

  double cost(const Variable* v) const
  {
    const auto& coefficients = m_program.objective()->coefficients();
    const auto found = coefficients.find(v);
    return found == coefficients.end() ? 0 : found->second;
  }

  void write_right_sides()
  {
    m_out << "RHS\n rhs cost " << -m_program.objective()->offset() << '\n';
    for (std::size_t i = 0; i < m_program.number_of_constraints(); ++i)
      if (const double b = range(i).right_side(); b != 0)
        m_out << " rhs r" << i << ' ' << b << '\n';
    m_out << "RANGES\n";
    for (std::size_t i = 0; i < m_program.number_of_constraints(); ++i)
      if (const Range r = range(i); !r.is_equation() && is_finite(r.low) && is_finite(r.high))
        m_out << " range r" << i << ' ' << r.high - r.low << '\n';
  }

  // all are written: some readers take integers without bounds for binary
  void write_bounds()
  {
    m_out << "BOUNDS\n";
    for (const Variable* v : m_program.variables()) {
      double low, high;
      v->get_bounds(low, high);
      if (v->variable_type() == Variable::BINARY) {
        low = 0;
        high = 1;
      }
      write_bound(is_finite(low) ? " LO" : " MI", v, low);
      write_bound(is_finite(high) ? " UP" : " PL", v, high);
    }
  }

  void write_bound(const char* type, const Variable* v, double value)
  {
    m_out << type << " bound x" << v->index();
    if (is_finite(value))
      m_out << ' ' << value;
    m_out << '\n';
  }

  std::ostream& m_out;
  const Program& m_program;
  std::vector<std::vector<std::pair<int, double>>> m_entries; // per column: row, coefficient
};

inline void write_mps(std::ostream& out, const Mps_writer::Program& program)
{
  Mps_writer(out, program);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WRITE_MPS_H
