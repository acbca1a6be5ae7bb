// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_GLPK_SEARCH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_GLPK_SEARCH_H

#include <CGAL/Quad_layouts/internal/quantization/Program_search.h>

#include <glpk.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <csetjmp>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// calls `work(data)` and says if GLPK got through it. GLPK ends the process on a fatal error unless
// its hook jumps away; the environment must be renewed then. No frame between the jump and its
// target may own anything: this one does not, and neither may `work`.
inline bool run_guarded_from_glpk(void (*work)(void*), void* data)
{
  std::jmp_buf target;
  if (setjmp(target) != 0) {
    glp_free_env();
    return false;
  }
  glp_term_hook([](void*, const char*) { return 1; }, nullptr); // swallows all output
  glp_error_hook([](void* t) { std::longjmp(*static_cast<std::jmp_buf*>(t), 1); }, &target);
  work(data);
  glp_error_hook(nullptr, nullptr);
  glp_term_hook(nullptr, nullptr);
  return true;
}

// how many iterations of the simplex method count as one node
constexpr int glpk_iterations_per_node = 100;

// One search of GLPK. The relaxation is solved first and alone, because `glp_intopt` would not mind
// the time limit there.
class Glpk_search : public Program_search
{
public:
  void run()
  {
    reset();
    flatten();
    const bool is_first_use = glp_init_env() == 0; // in this thread
    if (!run_guarded_from_glpk([](void* self) { static_cast<Glpk_search*>(self)->search(); },
                               this)) {
      outcome = Outcome::ERROR;
      has_solution = false;
      m_message = "GLPK met a fatal error";
    }
    if (is_first_use)
      glp_free_env(); // or it would be lost when the thread ends
    message = m_message;
  }

private:
  // brings the matrix into the coordinate format of GLPK, whose arrays begin at 1
  void flatten()
  {
    m_row.assign(1, 0);
    m_column.assign(1, 0);
    m_value.assign(1, 0.);
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (const auto& term : rows[r].terms) {
        m_row.push_back(int(r) + 1);
        m_column.push_back(term.first + 1);
        m_value.push_back(term.second);
      }
    m_start.assign(1, 0.);
    m_start.insert(m_start.end(), start.begin(), start.end());
  }

  // everything from here on runs under the guard and owns nothing but the GLPK problem
  void search()
  {
    glp_prob* problem = glp_create_prob();
    load(problem);
    if (solve_relaxation(problem))
      branch(problem);
    glp_delete_prob(problem);
  }

  static int bound_type(double low, double high)
  {
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    if (low == -infinity)
      return high == infinity ? GLP_FR : GLP_UP;
    return high == infinity ? GLP_LO : low == high ? GLP_FX : GLP_DB;
  }

  void load(glp_prob* problem) const
  {
    glp_set_obj_dir(problem, maximize ? GLP_MAX : GLP_MIN);
    if (!columns.empty())
      glp_add_cols(problem, int(columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Column& c = columns[i];
      glp_set_col_kind(problem, int(i) + 1, c.is_integer ? GLP_IV : GLP_CV);
      glp_set_col_bnds(problem, int(i) + 1, bound_type(c.low, c.high), c.low, c.high);
    }
    if (!rows.empty())
      glp_add_rows(problem, int(rows.size()));
    for (std::size_t r = 0; r < rows.size(); ++r)
      glp_set_row_bnds(problem, int(r) + 1, bound_type(rows[r].low, rows[r].high), rows[r].low,
                       rows[r].high);
    glp_load_matrix(problem, int(m_value.size()) - 1, m_row.data(), m_column.data(),
                    m_value.data());
    glp_set_obj_coef(problem, 0, objective_offset);
    for (const auto& term : objective)
      glp_set_obj_coef(problem, term.first + 1, term.second);
  }

  int milliseconds_left() const
  {
    return int((std::max)(1., (std::min)(1000 * seconds_left(), double(INT_MAX))));
  }

  // says if there is a reason to branch
  bool solve_relaxation(glp_prob* problem)
  {
    glp_smcp parameters;
    glp_init_smcp(&parameters);
    parameters.msg_lev = GLP_MSG_OFF;
    parameters.presolve = GLP_ON;
    parameters.tm_lim = milliseconds_left();
    parameters.it_lim = iteration_limit(glpk_iterations_per_node);
    const int code = glp_simplex(problem, &parameters);
    if (code == GLP_ENOPFS || (code == 0 && glp_get_status(problem) == GLP_NOFEAS)) {
      outcome = Outcome::COMPLETE;
      return false;
    }
    if (code == 0 && glp_get_status(problem) == GLP_OPT) {
      bound = glp_get_obj_val(problem);
      return true;
    }
    outcome = code == GLP_ETMLIM || code == GLP_EITLIM ? Outcome::LIMIT : Outcome::ERROR;
    m_message = outcome == Outcome::LIMIT ? "limit" : "the relaxation could not be solved";
    return false;
  }

  // GLPK's own cuts take longer than they save where relaxations are as strong as ours
  void branch(glp_prob* problem)
  {
    glp_iocp parameters;
    glp_init_iocp(&parameters);
    parameters.msg_lev = GLP_MSG_OFF;
    parameters.br_tech = GLP_BR_DTH;
    parameters.bt_tech = GLP_BT_BLB;
    parameters.mip_gap = limits.relative_gap;
    parameters.tm_lim = milliseconds_left();
    parameters.cb_func = [](glp_tree* tree, void* self) {
      static_cast<Glpk_search*>(self)->at_node(tree);
    };
    parameters.cb_info = this;
    const int code = glp_intopt(problem, &parameters);
    const int status = glp_mip_status(problem);
    has_solution = status == GLP_OPT || status == GLP_FEAS;
    if (has_solution) {
      objective_value = glp_mip_obj_val(problem);
      for (std::size_t i = 0; i < columns.size(); ++i)
        values[i] = glp_mip_col_val(problem, int(i) + 1);
    }
    switch (code) {
      case 0:
      case GLP_EMIPGAP: outcome = Outcome::COMPLETE; break;
      case GLP_ETMLIM:
        m_message = "time limit";
        outcome = Outcome::LIMIT;
        break;
      case GLP_ESTOP:
        m_message = "stopped";
        outcome = Outcome::LIMIT;
        break;
      default:
        m_message = "the search failed";
        outcome = Outcome::ERROR;
        break;
    }
    if (code == 0 && has_solution)
      bound = objective_value;
  }

  // The rule of Driebeck and Tomlin makes the smallest trees, but looks at the tableau row of each
  // fractional column. Where there are many, a search that has to end before its tree does gets to
  // good solutions sooner by the most fractional one.
  static void branch_if_many_are_fractional(glp_tree* tree)
  {
    constexpr int many = 200;
    glp_prob* problem = glp_ios_get_prob(tree);
    int count = 0, column = 0;
    double least = 1; // distance from the middle between two integers
    for (int j = 1; j <= glp_get_num_cols(problem); ++j)
      if (glp_ios_can_branch(tree, j)) {
        ++count;
        if (const double d = std::abs(fraction(problem, j) - 0.5); d < least) {
          least = d;
          column = j;
        }
      }
    if (count > many)
      glp_ios_branch_upon(tree, column,
                          fraction(problem, column) < 0.5 ? GLP_DN_BRNCH : GLP_UP_BRNCH);
  }

  static double fraction(glp_prob* problem, int column)
  {
    const double x = glp_get_col_prim(problem, column);
    return x - std::floor(x);
  }

  void at_node(glp_tree* tree)
  {
    const int best = glp_ios_best_node(tree);
    if (best != 0)
      bound = maximize ? (std::min)(bound, glp_ios_node_bound(tree, best))
                       : (std::max)(bound, glp_ios_node_bound(tree, best));
    if (glp_ios_reason(tree) == GLP_IHEUR && m_start.size() == columns.size() + 1) {
      glp_ios_heur_sol(tree, m_start.data());
      m_start.clear();
    }
    if (glp_ios_reason(tree) == GLP_IBRANCH)
      branch_if_many_are_fractional(tree);
    int total = 0;
    glp_ios_tree_size(tree, nullptr, nullptr, &total);
    const int iterations = glp_get_it_cnt(glp_ios_get_prob(tree));
    if (total > limits.nodes || iterations > iteration_limit(glpk_iterations_per_node) ||
        is_late() || is_stopped())
      glp_ios_terminate(tree);
  }

  std::vector<int> m_row, m_column;
  std::vector<double> m_value, m_start;
  const char* m_message = "";
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_GLPK_SEARCH_H
