// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_IO_QUANTIZATION_PROGRAM_H
#define CGAL_QUAD_LAYOUTS_IO_QUANTIZATION_PROGRAM_H

#include <CGAL/Quad_layouts/Quantization.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/layout/quotient.h>
#include <CGAL/Quad_layouts/internal/quantization/Quantization_options.h>
#include <CGAL/Quad_layouts/internal/quantization/check_quantization.h>
#include <CGAL/Quad_layouts/internal/quantization/copy_program.h>
#include <CGAL/Quad_layouts/internal/quantization/solve_in_box.h>
#include <CGAL/Quad_layouts/internal/quantization/write_mps.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <cmath>
#include <cstdlib>
#include <istream>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

namespace internal {

// A program that is not to be solved here.
class Unsolved_program : public CGAL::Mixed_integer_program_traits<double>
{
public:
  bool solve() override { return false; }
};

// i for the word x<i>, -1 for others
inline int variable_number(const std::string& word)
{
  const bool is_name = word.size() > 1 && word.size() < 10 && word[0] == 'x' &&
                       word.find_first_not_of("0123456789", 1) == std::string::npos;
  return is_name ? std::atoi(word.c_str() + 1) : -1;
}

inline int length_of(const std::string& name, const std::string& text)
{
  constexpr double tolerance = 1e-5, largest = 1e9; // of solvers; of what makes sense
  char* end;
  const double value = std::strtod(text.c_str(), &end);
  const double rounded = std::round(value);
  if (text.empty() || *end != 0 || !(std::abs(value - rounded) <= tolerance) || rounded < 0 ||
      rounded > largest)
    throw Stage_failure("read_quantization: " + name + " is \"" + text + "\", which is no length");
  return int(rounded);
}

// Takes the values of x0, x1, ... out of the lines of a solution: each name is followed by its
// value, or by an asterisk and its value. What is not mentioned is 0.
inline std::vector<int> read_values(std::istream& in, int variables)
{
  std::vector<int> result(variables, 0);
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string name, value;
    while (words >> name && variable_number(name) < 0)
      ;
    if (!words || variable_number(name) >= variables)
      continue;
    words >> value;
    if (value == "*")
      words >> value;
    result[variable_number(name)] = length_of(name, value);
  }
  return result;
}

// throws if a solution is not what the user wishes
inline void check_wishes(const T_mesh& t_mesh, const Quantization_program& program,
                         const Quantization_check& check, const Quotient_report& report)
{
  if (!check.grants_wishes)
    throw Stage_failure(
        "read_quantization: a demand on connections, merges or symmetry is not met");
  for (const Close_pair& pair : program.separate)
    if (are_merged(report, pair.i, pair.j))
      throw Stage_failure("read_quantization: " + name_of_pair(t_mesh, pair.i, pair.j) +
                          " fall together");
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgQuadLayoutsIO

writes the integer program that `quantize()` solves for a T-mesh, in free MPS format, so that other
solvers can be compared. The variables of the arcs are called x0, x1, ...; `read_quantization()`
takes them back. Arcs that must have equal lengths share a variable.

\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param out the stream
\param t_mesh a T-mesh
\param np those of `quantize()`

\returns whether writing succeeded

\throw Invalid_parameter if a parameter is out of its range.

Cuts that `quantize()` finds while it solves the program are not part of it: in rare cases the
optimum of the program makes no valid layout. The time is linear in the size of the program.
*/
template <class NamedParameters = parameters::Default_named_parameters>
bool write_quantization_program(std::ostream& out, const T_mesh& t_mesh,
                                const NamedParameters& np = parameters::default_values())
{
  using namespace internal;
  const Quantization_options options = quantization_options(t_mesh, np);
  const Quantization_program paper = build_quantization_program(t_mesh, options.demands,
                                                                options.wishes);
  const Reduced_program program = reduce(t_mesh, paper, Dual_graph(t_mesh, paper.zero_arcs()));
  const Box everything(program.number_of_variables());
  constexpr double true_costs = 1; // so that objectives can be compared
  const Box_program<Unsolved_program> whole(program, everything, {}, Domain::INTEGERS, true_costs);
  Program_search plain;
  copy_program(whole.program(), plain);
  write_mps(out, plain);
  return out.good();
}

/*!
\ingroup PkgQuadLayoutsIO

reads a solution of the program that `write_quantization_program()` has written. Any text is
understood in which a line has the name of a variable and then its value, as the solution files of
CBC and GLPK do; what is not mentioned is 0.

\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param in the stream
\param t_mesh the T-mesh
\param np those with which the program was written

\returns the lengths of the arcs, with the objective, as a solution that is not proven to be optimal

\throw Invalid_parameter if a parameter is out of its range.
\throw Stage_failure if a value is not a length, the lengths are not consistent, the layout is not
       valid, or what `np` asks for in particular is not there.
\throw Unsatisfiable_demand as `quantize()` does.
*/
template <class NamedParameters = parameters::Default_named_parameters>
Quantization read_quantization(std::istream& in, const T_mesh& t_mesh,
                               const NamedParameters& np = parameters::default_values())
{
  using namespace internal;
  const Quantization_options options = quantization_options(t_mesh, np);
  const Quantization_program paper = build_quantization_program(t_mesh, options.demands,
                                                                options.wishes);
  const Reduced_program program = reduce(t_mesh, paper, Dual_graph(t_mesh, paper.zero_arcs()));
  Quantization result;
  result.arc_length = program.arc_lengths(read_values(in, program.number_of_variables()));
  const Quantization_check check = check_quantization(t_mesh, paper, result.arc_length);
  if (!check.consistent)
    throw Stage_failure("read_quantization: opposite sides of patches are not equally long");
  const Quotient_report report = examine_quotient(t_mesh, result.arc_length);
  if (!report.valid)
    throw Stage_failure("read_quantization: the layout is not valid: " + report.reason);
  check_wishes(t_mesh, paper, check, report);
  result.status = Quantization::FEASIBLE;
  result.objective = check.objective;
  result.violated = check.violated();
  result.variables = program.number_of_variables();
  result.indicators = int(program.indicators.size());
  return result;
}

} // namespace IO
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_IO_QUANTIZATION_PROGRAM_H
