// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#define BOOST_TEST_MODULE CBC_mixed_integer_program_traits
#include "generated_meshes.h"
#include "solver_cases.h"

#include <CGAL/Quad_layouts/CBC_mixed_integer_program_traits.h>
#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>
#include <CGAL/Quad_layouts/IO/quantization_program.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <unistd.h>

namespace QL = CGAL::Quad_layouts;
namespace parameters = CGAL::Quad_layouts::parameters;

using Traits = QL::CBC_mixed_integer_program_traits<double>;
using Glpk_traits = QL::GLPK_mixed_integer_program_traits<double>;

namespace {

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

// Solves each program to its optimum, if there is time, with both solvers, and compares.
class Both_traits : public Traits
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
    if (this->status() == INFEASIBLE)
      BOOST_TEST(!found_there);
    if (other.status() == Glpk_traits::INFEASIBLE)
      BOOST_TEST(!found);
    if (this->status() == OPTIMAL && other.status() == Glpk_traits::OPTIMAL) {
      BOOST_TEST(this->objective_value() == other.objective_value(),
                 boost::test_tools::tolerance(tolerance));
      ++compared;
    }
    return found;
  }

private:
  static constexpr double tolerance = 1e-6;
};

int Both_traits::compared = 0;

QL::T_mesh traced(const generated::Mesh& mesh)
{
  return QL::trace_motorcycle_graph(QL::compute_cross_field(mesh));
}

// Moves the standard output and error streams into a file while it lives.
class Caught_output
{
public:
  Caught_output()
  {
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
      std::fflush(nullptr);
      m_saved.push_back(dup(stream));
      dup2(fileno(m_file), stream);
    }
  }
  ~Caught_output()
  {
    restore();
    std::fclose(m_file);
  }

  // ends it and returns how much was written
  long restore()
  {
    std::fflush(nullptr);
    for (std::size_t i = 0; i < m_saved.size(); ++i) {
      dup2(m_saved[i], int(i) + STDOUT_FILENO);
      close(m_saved[i]);
    }
    m_saved.clear();
    std::fseek(m_file, 0, SEEK_END);
    return std::ftell(m_file);
  }

private:
  std::FILE* m_file = std::tmpfile();
  std::vector<int> m_saved;
};

// A small program with integers of all signs, feasible or not. Both solvers get through it at once.
void make_random(Traits& traits, unsigned seed)
{
  std::mt19937 random(seed);
  const auto in = [&](int low, int high) { return low + int(random() % unsigned(high - low + 1)); };
  const auto sense = seed % 3 == 0 ? Traits::Linear_objective::MAXIMIZE
                                   : Traits::Linear_objective::MINIMIZE;
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

} // namespace

BOOST_AUTO_TEST_CASE(holds_what_holds_for_all_solvers)
{
  solver_cases::check_all<Traits>();
}

BOOST_AUTO_TEST_CASE(agrees_with_glpk)
{
  for (const generated::Mesh& mesh :
       {generated::cube(4), generated::torus(24, 12), generated::slab_with_holes(2, 3),
        generated::noisy(generated::icosphere(2), 0.05, 1),
        generated::noisy(generated::icosphere(3), 0.02, 2),
        generated::noisy(generated::torus(24, 12), 0.05, 3)}) {
    const QL::T_mesh t_mesh = traced(mesh);
    for (const double displacement : {0., 2., 6.}) {
      const auto np = parameters::maximum_displacement(displacement).maximum_running_time(4);
      const QL::Quantization both = QL::quantize<Both_traits>(t_mesh, np);
      const QL::Quantization by_cbc = QL::quantize<Traits>(t_mesh, np);
      const QL::Quantization by_glpk = QL::quantize<Glpk_traits>(t_mesh, np);
      BOOST_TEST(by_cbc.bound <= by_glpk.objective * (1 + 1e-9));
      BOOST_TEST(by_glpk.bound <= by_cbc.objective * (1 + 1e-9));
      BOOST_TEST(both.bound <= by_glpk.objective * (1 + 1e-9));
    }
  }
  BOOST_TEST(Both_traits::compared > 20);
}

BOOST_AUTO_TEST_CASE(agrees_with_glpk_on_random_programs)
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

// Whenever the search ends: the start solution remains unless there is a better one.
BOOST_AUTO_TEST_CASE(keeps_the_start_solution)
{
  for (int questions = 0; questions < 400; questions = 1 + questions * 5 / 4) {
    Traits traits;
    traits.set_start_solution(solver_cases::make_hard_but_feasible(traits));
    int asked = 0;
    traits.set_interrupt([&] { return ++asked > questions; });
    BOOST_TEST(traits.solve());
    BOOST_TEST(traits.status() == Traits::FEASIBLE);
    BOOST_TEST(traits.best_bound() <= traits.objective_value());
    for (const auto* row : traits.constraints()) {
      double value = 0;
      for (const auto& term : row->coefficients())
        value += term.second * term.first->solution_value();
      BOOST_TEST(value == row->lower_bound());
    }
  }
}

BOOST_AUTO_TEST_CASE(does_not_trust_an_infeasible_start_solution)
{
  Traits traits;
  auto* x = traits.create_variable(Traits::Variable::INTEGER, 0, 10);
  traits.create_constraint(3, solver_cases::infinity)->add_coefficient(x, 1);
  traits.create_objective()->add_coefficient(x, 1);
  traits.set_start_solution({1});
  BOOST_TEST(traits.solve());
  BOOST_TEST(x->solution_value() == 3);
}

BOOST_AUTO_TEST_CASE(its_reader_takes_written_programs)
{
  const QL::T_mesh t_mesh = traced(generated::cube(6));
  const std::string file = "cbc_program.mps";
  std::ofstream out(file);
  BOOST_TEST(QL::IO::write_quantization_program(out, t_mesh, parameters::relative_gap(0.)));
  out.close();
  OsiClpSolverInterface solver;
  solver.messageHandler()->setLogLevel(0);
  BOOST_TEST(solver.readMps(file.c_str()) == 0);
  std::remove(file.c_str());
  CbcModel model(solver);
  model.setLogLevel(0);
  model.branchAndBound();
  BOOST_TEST(model.getObjValue() == QL::quantize<Traits>(t_mesh).objective,
             boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(prints_nothing)
{
  const QL::T_mesh t_mesh = traced(generated::noisy(generated::icosphere(3), 0.05, 1));
  Caught_output output;
  QL::quantize<Traits>(t_mesh, parameters::maximum_running_time(2));
  solver_cases::bears_programs_without_rows_or_columns<Traits>();
  const long written = output.restore();
  BOOST_TEST(written == 0);
}
