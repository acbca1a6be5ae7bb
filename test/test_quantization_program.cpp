// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/IO/quantization_program.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <boost/test/unit_test.hpp>

#include <glpk.h>

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

BOOST_AUTO_TEST_SUITE(test_quantization_program)

namespace QL = CGAL::Quad_layouts;
namespace parameters = CGAL::Quad_layouts::parameters;

namespace {

QL::T_mesh t_mesh_of(const generated::Mesh& mesh)
{
  return QL::trace_motorcycle_graph(QL::compute_cross_field(mesh));
}

// A program that another reader has read, and its solution.
class Outside_solver
{
public:
  explicit Outside_solver(const std::string& file) : m_problem(glp_create_prob())
  {
    glp_term_out(GLP_OFF);
    BOOST_REQUIRE_EQUAL(glp_read_mps(m_problem, GLP_MPS_FILE, nullptr, file.c_str()), 0);
    glp_iocp options;
    glp_init_iocp(&options);
    options.presolve = GLP_ON;
    BOOST_REQUIRE_EQUAL(glp_intopt(m_problem, &options), 0);
    BOOST_REQUIRE_EQUAL(glp_mip_status(m_problem), GLP_OPT);
  }
  Outside_solver(const Outside_solver&) = delete;
  ~Outside_solver() { glp_delete_prob(m_problem); }

  double objective() const { return glp_mip_obj_val(m_problem); }

  // "  12 x12   3   0.5", as CBC writes it, without what is 0; GLPK puts an asterisk in between
  std::string solution(const char* before_value) const
  {
    std::ostringstream out;
    out << "Optimal - objective value " << objective() << '\n';
    for (int j = 1; j <= glp_get_num_cols(m_problem); ++j)
      if (const double value = glp_mip_col_val(m_problem, j); value != 0)
        out << "  " << j - 1 << ' ' << glp_get_col_name(m_problem, j) << before_value << value
            << "  0.5\n";
    return out.str();
  }

private:
  glp_prob* m_problem;
};

} // namespace

BOOST_AUTO_TEST_CASE(other_solvers_read_it_and_agree)
{
  for (const auto& mesh : {generated::cube(6), generated::slab_with_holes(2, 4),
                           generated::noisy(generated::icosphere(3), 0.05, 7)})
    for (const double r : {0., 2.}) {
      const QL::T_mesh t = t_mesh_of(mesh);
      const auto np = parameters::maximum_displacement(r).relative_gap(0.);
      const QL::Quantization own = QL::quantize(t, np);
      BOOST_REQUIRE((own.status == QL::Quantization::OPTIMAL));
      const std::string file = "program.mps";
      std::ofstream out(file);
      BOOST_TEST(QL::IO::write_quantization_program(out, t, np));
      out.close();
      const Outside_solver solver(file);
      std::remove(file.c_str());
      BOOST_TEST(solver.objective() <= own.objective * (1 + 1e-7));
      for (const char* before_value : {"   ", " * "}) {
        std::istringstream in(solver.solution(before_value));
        const QL::Quantization theirs = QL::IO::read_quantization(in, t, np);
        BOOST_TEST(theirs.objective == own.objective, boost::test_tools::tolerance(1e-7));
        BOOST_TEST((theirs.status == QL::Quantization::FEASIBLE));
        BOOST_TEST(theirs.violated == own.violated);
        BOOST_TEST(theirs.variables == own.variables);
      }
    }
}

BOOST_AUTO_TEST_CASE(the_same_text_again)
{
  const QL::T_mesh t = t_mesh_of(generated::cube(4));
  std::ostringstream a, b;
  QL::IO::write_quantization_program(a, t);
  QL::IO::write_quantization_program(b, t);
  BOOST_TEST(a.str() == b.str());
}

BOOST_AUTO_TEST_CASE(what_is_no_solution_is_refused)
{
  const QL::T_mesh t = t_mesh_of(generated::cube(4));
  const auto read = [&](const std::string& text) {
    std::istringstream in(text);
    return QL::IO::read_quantization(in, t);
  };
  for (const char* text : {"x0 0.5", "x0 nan", "x0 1e300", "x0 -1", "x0 one", "x0 1e", "x0"}) {
    const auto names_it = [](const QL::Stage_failure& error) {
      return std::string(error.what()).find("no length") != std::string::npos;
    };
    BOOST_CHECK_EXCEPTION(read(text), QL::Stage_failure, names_it);
  }
  BOOST_CHECK_THROW(read(""), QL::Stage_failure); // everything would vanish
  std::istringstream in("x0 1");
  BOOST_CHECK_THROW(QL::IO::read_quantization(in, t, parameters::maximum_deviation(-1.)),
                    QL::Invalid_parameter);
}

BOOST_AUTO_TEST_SUITE_END()
