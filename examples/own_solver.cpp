// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Quantizes with a solver of integer programs of one's own: a depth-first search, for which linear
// programs are solved by GLPK.

#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/Mixed_integer_program_traits.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace QL = CGAL::Quad_layouts;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A model of QuadLayoutsMixedIntegerProgramTraits, for programs that are minimized and bounded.
class Depth_first_solver : public CGAL::Mixed_integer_program_traits<double>
{
public:
  enum Status { OPTIMAL, FEASIBLE, INFEASIBLE, UNKNOWN, FAILED };

  void set_time_limit(double seconds) { m_seconds = seconds; }
  void set_node_limit(int nodes) { m_nodes = nodes; }
  void set_relative_gap(double gap) { m_gap = gap; }
  void set_interrupt(std::function<bool()> stop) { m_stop = std::move(stop); }
  void set_start_solution(std::vector<double> values) { result_ = std::move(values); }

  Status status() const { return m_status; }
  double objective_value() const { return m_value; }
  double best_bound() const { return m_bound; }

  bool solve() override
  {
    m_timer.start();
    make_relaxation();
    const bool is_complete = branch(), is_solved = !result_.empty();
    m_status = is_solved ? (is_complete ? OPTIMAL : FEASIBLE) : is_complete ? INFEASIBLE : UNKNOWN;
    if (m_status == OPTIMAL)
      m_bound = least_searched();
    for (std::size_t i = 0; i < result_.size(); ++i)
      variables()[i]->set_solution_value(result_[i]);
    return is_solved;
  }

private:
  // Solutions from here on are near enough to the best one.
  double least_searched() const { return result_.empty() ? infinity : (1 - m_gap) * m_value; }

  // Two programs are alike if each has its variables in the same order.
  void make_relaxation()
  {
    double low, high;
    for (const Variable* v : variables()) {
      v->get_bounds(low, high);
      m_relaxation.create_variable(Variable::CONTINUOUS, low, high);
    }
    for (const Linear_constraint* c : constraints()) {
      c->get_bounds(low, high);
      auto* row = m_relaxation.create_constraint(low, high);
      for (const auto& term : c->coefficients())
        row->add_coefficient(m_relaxation.variables()[term.first->index()], term.second);
    }
    m_value = objective()->offset(); // of the start solution, if there is one
    m_relaxation.create_objective()->set_offset(m_value);
    for (const auto& term : objective()->coefficients()) {
      const int i = term.first->index();
      m_relaxation.objective()->add_coefficient(m_relaxation.variables()[i], term.second);
      m_value += result_.empty() ? 0 : term.second * result_[i];
    }
  }

  // searches where the bounds of the relaxation are now, and says if that came to an end
  bool branch()
  {
    if (m_nodes-- <= 0 || m_timer.time() > m_seconds || (m_stop && m_stop()))
      return false;
    if (!m_relaxation.solve())
      return m_relaxation.status() == m_relaxation.INFEASIBLE;
    const double value = m_relaxation.objective_value();
    if (m_bound == -infinity) // at the root
      m_bound = value;
    if (value >= least_searched())
      return true;
    for (Variable* v : m_relaxation.variables()) {
      const double x = v->solution_value();
      const bool is_free = variables()[v->index()]->variable_type() == Variable::CONTINUOUS;
      if (!is_free && std::abs(x - std::round(x)) > 1e-6)
        return branch_on(v, x);
    }
    m_value = value;
    result_ = m_relaxation.solution();
    for (const Variable* v : variables())
      if (v->variable_type() != Variable::CONTINUOUS)
        result_[v->index()] = std::round(result_[v->index()]);
    return true;
  }

  bool branch_on(Variable* v, double x)
  {
    double low, high;
    v->get_bounds(low, high);
    v->set_bounds(std::ceil(x), high);
    bool is_complete = branch();
    v->set_bounds(low, std::floor(x));
    is_complete = is_complete && branch();
    v->set_bounds(low, high);
    return is_complete;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  QL::GLPK_mixed_integer_program_traits<double> m_relaxation;
  double m_seconds = infinity, m_gap = 0, m_value = infinity, m_bound = -infinity;
  int m_nodes = std::numeric_limits<int>::max();
  std::function<bool()> m_stop;
  Status m_status = UNKNOWN;
  CGAL::Real_timer m_timer;
};

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bear.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "cannot read " << file << '\n';
    return EXIT_FAILURE;
  }
  try {
    const QL::T_mesh t_mesh = QL::trace_motorcycle_graph(QL::compute_cross_field(mesh));
    const QL::Quantization own = QL::quantize<Depth_first_solver>(t_mesh);
    const QL::Quantization other = QL::quantize(t_mesh);
    std::cout << "objective " << own.objective << ", at least " << own.bound << " is proven\n"
              << "with GLPK " << other.objective << ", at least " << other.bound << '\n';
    const double rounding = 1 + 1e-9;
    const bool agree = own.bound <= other.objective * rounding &&
                       other.bound <= own.objective * rounding;
    return agree ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const QL::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
