// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_HIGHS_SEARCH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_HIGHS_SEARCH_H

#include <CGAL/Quad_layouts/internal/quantization/Program_search.h>

#include <Highs.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// how many iterations of the simplex method count as one node
constexpr int highs_iterations_per_node = 200;

// One search of HiGHS.
class Highs_search : public Program_search
{
public:
  void run()
  {
    if (!begin())
      return;
    if (must_end())
      end_at_limit();
    else
      search();
  }

private:
  bool must_end() const { return is_late() || is_stopped(); }

  bool is_mixed_integer() const
  {
    return std::any_of(columns.begin(), columns.end(),
                       [](const Column& c) { return c.is_integer; });
  }

  void search()
  {
    Highs solver;
    configure(solver);
    watch(solver);
    if (solver.passModel(program()) == HighsStatus::kError) {
      message = "HiGHS does not take the program";
      return;
    }
    if (has_solution && is_mixed_integer()) {
      HighsSolution known;
      known.col_value = values;
      solver.setSolution(known);
    }
    if (solver.run() == HighsStatus::kError) {
      // the threads belong to the process: maybe others have started more
      solver.setOptionValue("threads", 0);
      solver.run();
    }
    take_result(solver);
  }

  void configure(Highs& solver) const
  {
    solver.setOptionValue("output_flag", false);
    solver.setOptionValue("threads", 1);
    if (has_time_limit())
      solver.setOptionValue("time_limit", (std::max)(seconds_left(), 0.));
    solver.setOptionValue("mip_rel_gap", limits.relative_gap);
    solver.setOptionValue("mip_abs_gap", 0.);
    solver.setOptionValue("mip_max_nodes", limits.nodes);
    solver.setOptionValue("simplex_iteration_limit", iteration_limit(highs_iterations_per_node));
  }

  // Of mixed integer programs HiGHS bounds only the nodes by itself.
  void watch(Highs& solver)
  {
    const auto ask = [this](int, const std::string&, const auto* state, auto* answer, void*) {
      m_has_ended = m_has_ended || must_end() ||
                    state->mip_total_lp_iterations > iteration_limit(highs_iterations_per_node);
      answer->user_interrupt = m_has_ended;
    };
    solver.setCallback(ask);
    solver.startCallback(kCallbackSimplexInterrupt);
    solver.startCallback(kCallbackMipInterrupt);
  }

  HighsLp program() const
  {
    HighsLp lp;
    lp.num_col_ = HighsInt(columns.size());
    lp.num_row_ = HighsInt(rows.size());
    lp.sense_ = maximize ? ObjSense::kMaximize : ObjSense::kMinimize;
    lp.offset_ = objective_offset;
    lp.col_cost_.assign(columns.size(), 0.);
    for (const auto& term : objective)
      lp.col_cost_[term.first] = term.second;
    for (const Column& c : columns) {
      lp.col_lower_.push_back(c.low);
      lp.col_upper_.push_back(c.high);
      lp.integrality_.push_back(c.is_integer ? HighsVarType::kInteger : HighsVarType::kContinuous);
    }
    lp.a_matrix_.format_ = MatrixFormat::kRowwise;
    lp.a_matrix_.start_.assign(1, 0);
    for (const Row& row : rows) {
      lp.row_lower_.push_back(row.low);
      lp.row_upper_.push_back(row.high);
      for (const auto& term : row.terms) {
        lp.a_matrix_.index_.push_back(term.first);
        lp.a_matrix_.value_.push_back(term.second);
      }
      lp.a_matrix_.start_.push_back(HighsInt(lp.a_matrix_.index_.size()));
    }
    return lp;
  }

  void take_result(const Highs& solver)
  {
    const HighsInfo& info = solver.getInfo();
    const bool found = info.primal_solution_status == kSolutionStatusFeasible &&
                       take_solution(solver.getSolution().col_value);
    switch (solver.getModelStatus()) {
      case HighsModelStatus::kOptimal:
        outcome = found ? Outcome::COMPLETE : Outcome::ERROR;
        message = found ? "" : "the solution is not feasible";
        break;
      case HighsModelStatus::kInfeasible: outcome = Outcome::COMPLETE; break;
      case HighsModelStatus::kTimeLimit:
      case HighsModelStatus::kIterationLimit:
      case HighsModelStatus::kSolutionLimit: // the nodes
      case HighsModelStatus::kInterrupt: end_at_limit(); break;
      default: message = "the search failed"; break;
    }
    take_bound(info);
  }

  void take_bound(const HighsInfo& info)
  {
    if (is_mixed_integer() && info.valid)
      bound = info.mip_dual_bound;
    else if (outcome == Outcome::COMPLETE && has_solution)
      bound = objective_value;
    limit_bound();
  }

  bool m_has_ended = false;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_HIGHS_SEARCH_H
