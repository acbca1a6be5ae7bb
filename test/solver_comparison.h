// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_TEST_SOLVER_COMPARISON_H
#define QUAD_LAYOUTS_TEST_SOLVER_COMPARISON_H

#include "caught_output.h"
#include "generated_meshes.h"
#include "solver_cases.h"

#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <boost/test/unit_test.hpp>

#include <random>

// Whether other solvers find the same as GLPK.
namespace solver_comparison {

namespace QL = CGAL::Quad_layouts;
namespace parameters = CGAL::Quad_layouts::parameters;

using Glpk_traits = QL::GLPK_mixed_integer_program_traits<double>;

// writes the program of `from` into `to`, which is empty
template <class From, class To>
void copy_program(const From& from, To& to)
{
  double low, high;
  for (const auto* v : from.variables()) {
    v->get_bounds(low, high);
    to.create_variable(v->variable_type(), low, high);
  }
  for (const auto* c : from.constraints()) {
    c->get_bounds(low, high);
    auto* row = to.create_constraint(low, high);
    for (const auto& term : c->coefficients())
      row->add_coefficient(to.variables()[term.first->index()], term.second);
  }
  auto* objective = to.create_objective(from.objective()->sense());
  objective->set_offset(from.objective()->offset());
  for (const auto& term : from.objective()->coefficients())
    objective->add_coefficient(to.variables()[term.first->index()], term.second);
}

// Solves each program to its optimum, if there is time, with GLPK as well, and compares.
template <class Traits>
class Compared_traits : public Traits
{
public:
  static int compared;

  void set_relative_gap(double) {}
  void set_node_limit(int) {}

  bool solve() override
  {
    Glpk_traits other;
    copy_program(*this, other);
    other.set_time_limit(2);
    const bool found_there = other.solve(), found = Traits::solve();
    if (found && found_there) {
      BOOST_TEST(this->best_bound() <= other.objective_value() + tolerance);
      BOOST_TEST(other.best_bound() <= this->objective_value() + tolerance);
    }
    if (this->status() == Traits::INFEASIBLE)
      BOOST_TEST(!found_there);
    if (other.status() == Glpk_traits::INFEASIBLE)
      BOOST_TEST(!found);
    if (this->status() == Traits::OPTIMAL && other.status() == Glpk_traits::OPTIMAL) {
      BOOST_TEST(this->objective_value() == other.objective_value(),
                 boost::test_tools::tolerance(tolerance));
      ++compared;
    }
    return found;
  }

private:
  static constexpr double tolerance = 1e-6;
};

template <class Traits>
int Compared_traits<Traits>::compared = 0;

inline QL::T_mesh traced(const generated::Mesh& mesh)
{
  return QL::trace_motorcycle_graph(QL::compute_cross_field(mesh));
}

template <class Traits>
void agrees_with_glpk()
{
  for (const generated::Mesh& mesh :
       {generated::cube(4), generated::torus(24, 12), generated::slab_with_holes(2, 3),
        generated::noisy(generated::icosphere(2), 0.05, 1),
        generated::noisy(generated::icosphere(3), 0.02, 2),
        generated::noisy(generated::torus(24, 12), 0.05, 3)}) {
    const QL::T_mesh t_mesh = traced(mesh);
    for (const double displacement : {0., 2., 6.}) {
      const auto np = parameters::maximum_displacement(displacement).maximum_running_time(4);
      const QL::Quantization both = QL::quantize<Compared_traits<Traits>>(t_mesh, np);
      const QL::Quantization by_this = QL::quantize<Traits>(t_mesh, np);
      const QL::Quantization by_glpk = QL::quantize<Glpk_traits>(t_mesh, np);
      BOOST_TEST(by_this.bound <= by_glpk.objective * (1 + 1e-9));
      BOOST_TEST(by_glpk.bound <= by_this.objective * (1 + 1e-9));
      BOOST_TEST(both.bound <= by_glpk.objective * (1 + 1e-9));
    }
  }
  BOOST_TEST(Compared_traits<Traits>::compared > 20);
}

// A small program with integers of all signs, feasible or not. Solvers get through it at once.
template <class Traits>
void make_random(Traits& traits, unsigned seed)
{
  std::mt19937 random(seed);
  const auto in = [&](int low, int high) { return low + int(random() % unsigned(high - low + 1)); };
  using Objective = typename Traits::Linear_objective;
  const auto sense = seed % 3 == 0 ? Objective::MAXIMIZE : Objective::MINIMIZE;
  auto* objective = traits.create_objective(sense);
  objective->set_offset(in(-5, 5));
  const int variables = in(2, 11), rows = in(1, 8);
  for (int i = 0; i < variables; ++i) {
    const auto type = i % 4 == 3 && seed % 4 == 0 ? Traits::Variable::CONTINUOUS
                                                  : Traits::Variable::INTEGER;
    auto* v = traits.create_variable(type, in(-3, 0), in(1, 10));
    objective->add_coefficient(v, in(-9, 30) / (seed % 2 == 0 ? 10. : 7.));
  }
  for (int r = 0; r < rows; ++r) {
    const double side = in(0, 12);
    auto* row = traits.create_constraint(r % 3 == 0 ? -solver_cases::infinity : -side,
                                         r % 3 == 1 ? solver_cases::infinity : side);
    for (auto* v : traits.variables())
      if (in(0, 1) == 1)
        row->add_coefficient(v, in(-4, 6));
  }
}

template <class Traits>
void agrees_with_glpk_on_random_programs()
{
  for (unsigned seed = 0; seed < 1500; ++seed) {
    Traits traits;
    make_random(traits, seed);
    Glpk_traits other;
    copy_program(traits, other);
    BOOST_TEST(traits.solve() == other.solve(), "seed " << seed);
    BOOST_TEST(traits.objective_value() == other.objective_value(),
               boost::test_tools::tolerance(1e-6));
  }
}

template <class Traits>
void prints_nothing()
{
  const QL::T_mesh t_mesh = traced(generated::noisy(generated::icosphere(3), 0.05, 1));
  Caught_output output;
  QL::quantize<Traits>(t_mesh, parameters::maximum_running_time(2));
  solver_cases::bears_programs_without_rows_or_columns<Traits>();
  const long written = output.restore();
  BOOST_TEST(written == 0);
}

} // namespace solver_comparison

#endif // QUAD_LAYOUTS_TEST_SOLVER_COMPARISON_H
