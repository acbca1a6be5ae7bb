// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_SOLVE_IN_BOX_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_SOLVE_IN_BOX_H

#include <CGAL/Quad_layouts/internal/quantization/Reduced_program.h>
#include <CGAL/Quad_layouts/internal/quantization/check_quantization.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Bounds of the variables of a reduced program. A search in a small box is a search in a
// neighbourhood.
struct Box
{
  using Rows = Reduced_program::Rows;

  static constexpr int unbounded = (std::numeric_limits<int>::max)();

  std::vector<int> low, high;
  // Q of Equation (3): how long the paths of indicators may be. 10 does not cut off solutions worth
  // having; a smaller one loses some, but makes the relaxation much stronger.
  int longest_path = 10;
  Rows rows;
  bool covers_are_soft = false; // as in (7)

  // everything is allowed
  explicit Box(int variables, Rows visible = Rows::EXACT)
    : low(variables, 0), high(variables, unbounded), rows(visible)
  {
  }
  // nothing but x is allowed
  explicit Box(const std::vector<int>& x) : low(x), high(x), rows(Rows::ALL) {}

  bool is_fixed(int v) const { return low[v] == high[v]; }
  void free(int v)
  {
    low[v] = 0;
    high[v] = unbounded;
  }

  int number_of_free_variables() const
  {
    int result = 0;
    for (std::size_t v = 0; v < low.size(); ++v)
      result += !is_fixed(int(v));
    return result;
  }
};

// frees all variables of symmetry rows that have a free one
inline void free_mirrored(const Reduced_program& program, Box& box)
{
  for (const auto& equation : program.mirrored)
    if (std::any_of(equation.begin(), equation.end(),
                    [&](const auto& term) { return !box.is_fixed(term.first); }))
      for (const auto& term : equation)
        if (box.is_fixed(term.first))
          box.free(term.first);
}

struct Search_effort
{
  double seconds;
  int nodes;
  double relative_gap;
  std::function<bool()> stop;
};

struct Box_solution
{
  enum Status { OPTIMAL, FEASIBLE, INFEASIBLE, UNKNOWN } status = UNKNOWN;
  // of optimal and feasible ones: values of the variables, and of the indicators, where those that
  // the program does not need are 0
  std::vector<double> x, indicators;
  double bound = -(std::numeric_limits<double>::infinity)(); // of the objective in the box
};

// the kinds of numbers that are looked for
enum class Domain { INTEGERS, REALS };

// A power of two near the mean cost of a variable. In this unit costs do not vanish beside the
// tolerances of solvers, which are absolute, however small the surface is.
inline double unit_of_costs(const Reduced_program& program)
{
  const double sum = std::accumulate(program.cost.begin(), program.cost.end(), 0.);
  return sum > 0 ? std::ldexp(1., std::ilogb(sum / double(program.cost.size()))) : 1.;
}

// Hands the part of a reduced program that a box leaves open to a solver.
template <class Traits>
class Box_program
{
  using Variable = typename Traits::Variable;
  using Constraint = typename Traits::Linear_constraint;

public:
  // Expects the best known solution if there is one, else an empty vector; and the unit of the costs
  // that the solver sees.
  Box_program(const Reduced_program& program, const Box& box, const std::vector<int>& known,
              Domain domain, double unit)
    : m_program(program), m_box(box), m_known(known), m_domain(domain), m_unit(unit),
      m_column(program.number_of_variables(), nullptr), m_indicator(program.indicators.size())
  {
    m_objective = m_traits.create_objective();
    for (int v = 0; v < program.number_of_variables(); ++v)
      if (box.is_fixed(v))
        m_fixed_cost += program.cost[v] * box.low[v];
      else
        add_column(v);
    for (const auto* equations : {&program.equations, &program.mirrored})
      for (const auto& equation : *equations)
        add_equation(equation);
    for (const auto& cover : program.covers)
      add_cover({cover, {}, true}, box.covers_are_soft);
    for (const auto& row : program.index_rows)
      if (!row.is_lazy)
        add_index_row(row);
    for (const auto& cut : program.cuts)
      if (program.is_visible(cut, box.rows))
        add_cover(cut, false);
    if (!box.covers_are_soft)
      for (const auto& row : program.strengthening)
        add_strengthening(row);
    m_objective->set_offset(m_fixed_cost / m_unit);
  }

  // The first columns are the variables of the program, but for those that the box fixes.
  const Traits& program() const { return m_traits; }

  Box_solution solve(const Search_effort& effort)
  {
    Box_solution result;
    if (m_contradiction) {
      result.status = Box_solution::INFEASIBLE;
      return result;
    }
    m_traits.set_time_limit(effort.seconds);
    m_traits.set_node_limit(effort.nodes);
    m_traits.set_relative_gap(effort.relative_gap);
    m_traits.set_interrupt(effort.stop);
    if (!m_known.empty())
      m_traits.set_start_solution(known_values());
    const bool solved = m_traits.solve();
    result.bound = m_unit * m_traits.best_bound();
    if (solved) {
      for (int v = 0; v < m_program.number_of_variables(); ++v)
        result.x.push_back(m_column[v] ? m_column[v]->solution_value() : m_box.low[v]);
      for (const Indicator& c : m_indicator)
        result.indicators.push_back(c.column ? c.column->solution_value() : c.constant);
    }
    switch (m_traits.status()) {
      case Traits::OPTIMAL: result.status = Box_solution::OPTIMAL; break;
      case Traits::FEASIBLE: result.status = Box_solution::FEASIBLE; break;
      case Traits::INFEASIBLE: result.status = Box_solution::INFEASIBLE; break;
      default: result.status = Box_solution::UNKNOWN; break;
    }
    return result;
  }

private:
  // An indicator of the program in the box: constant, or a column.
  struct Indicator
  {
    bool is_known = false;
    int constant = 0;
    Variable* column = nullptr;
  };

  static constexpr double infinity() { return 1e20; } // of CGAL's traits

  typename Traits::Variable_type type(typename Traits::Variable_type of_integers) const
  {
    return m_domain == Domain::REALS ? Variable::CONTINUOUS : of_integers;
  }

  void add_column(int v)
  {
    const double high = m_box.high[v] == Box::unbounded ? infinity() : m_box.high[v];
    m_column[v] = m_traits.create_variable(type(Variable::INTEGER), m_box.low[v], high);
    m_objective->add_coefficient(m_column[v], m_program.cost[v] / m_unit);
  }

  void add_equation(const std::vector<std::pair<int, int>>& equation)
  {
    long constant = 0;
    bool is_open = false;
    for (const auto& term : equation) {
      if (m_column[term.first])
        is_open = true;
      else
        constant += long(term.second) * m_box.low[term.first];
    }
    if (!is_open) {
      m_contradiction = m_contradiction || constant != 0;
      return;
    }
    Constraint* row = m_traits.create_constraint(double(-constant), double(-constant));
    for (const auto& term : equation)
      if (m_column[term.first])
        row->add_coefficient(m_column[term.first], term.second);
  }

  bool is_positive_in_box(int v) const { return m_box.low[v] > 0; }

  void add_cover(const Reduced_program::Cut& cut, bool is_soft)
  {
    if (std::any_of(cut.variables.begin(), cut.variables.end(),
                    [&](int v) { return is_positive_in_box(v); }))
      return;
    std::vector<Variable*> columns;
    for (int v : cut.variables)
      if (m_column[v])
        columns.push_back(m_column[v]);
    for (int k : cut.indicators) {
      const Indicator& c = indicator(k);
      if (c.column)
        columns.push_back(c.column);
      else if (c.constant == 1)
        return;
    }
    if (columns.empty() && !is_soft) {
      m_contradiction = true;
      return;
    }
    Constraint* row = m_traits.create_constraint(1, infinity());
    for (Variable* column : columns)
      row->add_coefficient(column, 1);
    if (is_soft)
      add_slack(row, 1);
  }

  void add_index_row(const Reduced_program::Index_row& index_row)
  {
    int base = index_row.base, least = 0, most = 0;
    std::vector<std::pair<Variable*, int>> terms;
    for (const auto& term : index_row.terms) {
      const Indicator& c = indicator(term.first);
      if (!c.column) {
        base += c.constant * term.second;
        continue;
      }
      terms.emplace_back(c.column, term.second);
      (term.second < 0 ? least : most) += term.second;
    }
    if (base + least >= index_row.low && base + most <= index_row.high)
      return;
    Constraint* row = m_traits.create_constraint(index_row.low - base, index_row.high - base);
    for (const auto& term : terms)
      row->add_coefficient(term.first, term.second);
    if (m_program.index_rows_are_soft) {
      add_slack(row, -1);
      add_slack(row, 1);
    } else if (terms.empty())
      m_contradiction = true;
  }

  // Rows without open terms hold: they follow from the others.
  void add_strengthening(const Integer_row& row)
  {
    int bound = row.bound;
    std::vector<std::pair<Variable*, int>> terms;
    for (const auto& [column, coefficient] : row.terms) {
      const int k = column - m_program.number_of_variables();
      Variable* open = k < 0 ? m_column[column] : indicator(k).column;
      if (open)
        terms.emplace_back(open, coefficient);
      else
        bound -= coefficient * (k < 0 ? m_box.low[column] : indicator(k).constant);
    }
    if (terms.empty())
      return;
    Constraint* constraint = m_traits.create_constraint(-infinity(), bound);
    for (const auto& term : terms)
      constraint->add_coefficient(term.first, term.second);
  }

  // Equations (7) and (8): a slack raises (sign 1) or lowers (sign -1) the left side of a row
  void add_slack(Constraint* row, int sign)
  {
    Variable* slack = m_traits.create_variable(type(Variable::INTEGER), 0, infinity());
    m_slacks.push_back({row, slack, sign});
    row->add_coefficient(slack, sign);
    m_objective->add_coefficient(slack, m_program.penalty / m_unit);
  }

  const Indicator& indicator(int k)
  {
    Indicator& c = m_indicator[k];
    if (!c.is_known) {
      c = make_indicator(m_program.indicators[k].path);
      c.is_known = true;
    }
    return c;
  }

  // Equation (3), with a Q that does not cut off the known solution
  Indicator make_indicator(const Reduced_program::Set& path)
  {
    Indicator c;
    if (std::any_of(path.begin(), path.end(), [&](int v) { return is_positive_in_box(v); }))
      return c;
    double largest = 0;
    for (int v : path)
      largest += m_box.high[v];
    if (largest == 0) {
      c.constant = 1;
      return c;
    }
    const long known = m_known.empty() ? 0 : sum_over(path, m_known);
    const double q = (std::min)(largest, double((std::max)(long(m_box.longest_path), known)));
    c.column = m_traits.create_variable(type(Variable::BINARY), 0, 1);
    Constraint* merged = m_traits.create_constraint(1, infinity());
    Constraint* separate = m_traits.create_constraint(-infinity(), q);
    merged->add_coefficient(c.column, 1);
    separate->add_coefficient(c.column, q);
    for (int v : path)
      if (m_column[v]) {
        merged->add_coefficient(m_column[v], 1);
        separate->add_coefficient(m_column[v], 1);
      }
    m_indicator_columns.push_back({c.column, &path});
    return c;
  }

  std::vector<double> known_values() const
  {
    std::vector<double> values(m_traits.number_of_variables(), 0.);
    for (int v = 0; v < m_program.number_of_variables(); ++v)
      if (m_column[v])
        values[m_column[v]->index()] = m_known[v];
    for (const auto& c : m_indicator_columns)
      values[c.first->index()] = sum_over(*c.second, m_known) == 0;
    for (const auto& s : m_slacks) {
      double excess = 0;
      for (const auto& term : s.row->coefficients())
        excess += term.second * values[term.first->index()];
      excess = s.sign < 0 ? excess - s.row->upper_bound() : s.row->lower_bound() - excess;
      values[s.column->index()] = (std::max)(0., excess);
    }
    return values;
  }

  struct Slack
  {
    Constraint* row;
    Variable* column;
    int sign;
  };

  const Reduced_program& m_program;
  const Box& m_box;
  const std::vector<int>& m_known;
  Domain m_domain;
  double m_unit;
  Traits m_traits;
  typename Traits::Linear_objective* m_objective;
  std::vector<Variable*> m_column; // per variable, null if fixed
  std::vector<Indicator> m_indicator;
  std::vector<std::pair<Variable*, const Reduced_program::Set*>> m_indicator_columns;
  std::vector<Slack> m_slacks;
  double m_fixed_cost = 0;
  bool m_contradiction = false;
};

// looks for the best solution of `program` in `box`; `known` is one in the box, or empty
template <class Traits>
Box_solution solve_in_box(const Reduced_program& program, const Box& box,
                          const std::vector<int>& known, const Search_effort& effort,
                          Domain domain = Domain::INTEGERS)
{
  return Box_program<Traits>(program, box, known, domain, unit_of_costs(program)).solve(effort);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_SOLVE_IN_BOX_H
