// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_CBC_SEARCH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_CBC_SEARCH_H

#include <CGAL/Quad_layouts/internal/quantization/Program_search.h>

#include <CbcModel.hpp> // first: others of CBC do not compile without it

#include <CbcCutGenerator.hpp>
#include <CbcEventHandler.hpp>
#include <CbcHeuristic.hpp>
#include <CbcHeuristicDiveCoefficient.hpp>
#include <CbcHeuristicFPump.hpp>
#include <CbcHeuristicRINS.hpp>
#include <CglGomory.hpp>
#include <CglKnapsackCover.hpp>
#include <CglProbing.hpp>
#include <CglZeroHalf.hpp>
#include <ClpEventHandler.hpp>
#include <ClpSimplex.hpp>
#include <CoinPackedMatrix.hpp>
#include <OsiClpSolverInterface.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Asks after each iteration of the simplex method if the search is to end, those of heuristics,
// trial branches and programs inside programs included: the limits of CBC itself are looked at too
// rarely to hold. Ends each linear program from then on.
class Cbc_iteration_watch : public ClpEventHandler
{
public:
  explicit Cbc_iteration_watch(const std::function<bool()>& must_end) : m_must_end(&must_end) {}

  int event(Event which) override
  {
    const int go_on = -1, end = 0;
    return which == endOfIteration && (*m_must_end)() ? end : go_on;
  }
  ClpEventHandler* clone() const override { return new Cbc_iteration_watch(*this); }

private:
  const std::function<bool()>* m_must_end; // CBC keeps many copies of this object
};

// How many of them count as one node. Those of trial branches and heuristics are many and cheap.
constexpr int cbc_iterations_per_node = 200;

// Is told of each node and solution of the search tree.
class Cbc_tree_watch : public CbcEventHandler
{
public:
  using Function = std::function<CbcAction(CbcModel&, CbcEvent)>;

  explicit Cbc_tree_watch(const Function& at_event) : m_at_event(&at_event) {}

  CbcAction event(CbcEvent which) override { return (*m_at_event)(*model_, which); }
  CbcEventHandler* clone() const override { return new Cbc_tree_watch(*this); }

private:
  const Function* m_at_event;
};

// One search of CBC. Programs are minimized, with the sign of the objective turned if need be.
class Cbc_search : public Program_search
{
public:
  void run()
  {
    if (begin())
      search();
    limit_bound();
  }

private:
  void search()
  {
    const std::function<bool()> must_end = [this] {
      ++m_iterations;
      return this->must_end();
    };
    OsiClpSolverInterface program;
    silence(program);
    load(program);
    const Cbc_iteration_watch watch(must_end);
    program.getModelPtr()->passInEventHandler(&watch);
    if (solve_relaxation(program))
      branch(program);
  }

  // Most calls only count: what `stop` costs is unknown.
  bool must_end()
  {
    constexpr int interval = 16;
    if (!m_has_ended)
      m_has_ended = m_iterations > iteration_limit(cbc_iterations_per_node) ||
                    m_nodes > limits.nodes ||
                    (m_questions++ % interval == 0 && (is_late() || is_stopped()));
    return m_has_ended;
  }

  double sign() const { return maximize ? -1 : 1; }

  // takes a bound of the program that is minimized
  void improve_bound(double value)
  {
    bound = maximize ? (std::min)(bound, -value) : (std::max)(bound, value);
  }

  static void silence(OsiSolverInterface& program)
  {
    program.messageHandler()->setLogLevel(0);
    program.setHintParam(OsiDoReducePrint, true, OsiHintDo);
  }

  void load(OsiClpSolverInterface& program) const
  {
    const double infinity = program.getInfinity();
    const auto finite = [=](double x) { return (std::max)(-infinity, (std::min)(infinity, x)); };
    std::vector<double> low, high, cost(columns.size(), 0.), row_low, row_high;
    for (const Column& c : columns) {
      low.push_back(finite(c.low));
      high.push_back(finite(c.high));
    }
    for (const auto& term : objective)
      cost[term.first] = sign() * term.second;
    CoinPackedMatrix matrix(false, 0, 0);
    matrix.setDimensions(0, int(columns.size()));
    for (const Row& row : rows) {
      std::vector<int> index;
      std::vector<double> value;
      for (const auto& term : row.terms) {
        index.push_back(term.first);
        value.push_back(term.second);
      }
      matrix.appendRow(int(index.size()), index.data(), value.data());
      row_low.push_back(finite(row.low));
      row_high.push_back(finite(row.high));
    }
    program.loadProblem(matrix, low.data(), high.data(), cost.data(), row_low.data(),
                        row_high.data());
    program.setDblParam(OsiObjOffset, -sign() * objective_offset);
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i].is_integer)
        program.setInteger(int(i));
  }

  // says if there is a reason to branch
  bool solve_relaxation(OsiClpSolverInterface& program)
  {
    program.initialSolve();
    if (m_has_ended) {
      end_at_limit();
      return false;
    }
    if (program.isProvenPrimalInfeasible()) {
      outcome = Outcome::COMPLETE;
      return false;
    }
    if (!program.isProvenOptimal()) {
      message = "the relaxation could not be solved";
      return false;
    }
    improve_bound(program.getObjValue());
    if (program.getNumIntegers() > 0)
      return true;
    outcome = Outcome::COMPLETE;
    take_solution(solution_of(program));
    return false;
  }

  static std::vector<double> solution_of(const OsiSolverInterface& program)
  {
    return std::vector<double>(program.getColSolution(),
                               program.getColSolution() + program.getNumCols());
  }

  void branch(const OsiClpSolverInterface& program)
  {
    CbcModel model(program);
    configure(model);
    const Cbc_tree_watch::Function at_event = [&](CbcModel& m, CbcEventHandler::CbcEvent which) {
      return note_event(m, which, &m == &model);
    };
    const Cbc_tree_watch watch(at_event);
    model.passInEventHandler(&watch);
    if (has_solution) {
      model.setBestSolution(values.data(), int(values.size()), sign() * objective_value);
      model.setSolutionCount(1);
    }
    model.branchAndBound();
    take_result(model);
  }

  void configure(CbcModel& model) const
  {
    model.setLogLevel(0);
    model.messageHandler()->setLogLevel(0);
    model.setUseElapsedTime(true);
    if (has_time_limit())
      model.setMaximumSeconds(seconds_left());
    model.setMaximumNodes(limits.nodes);
    model.setAllowableFractionGap(limits.relative_gap);
    model.setRandomSeed(1);
    add_cuts(model);
    add_heuristics(model);
  }

  // Those kinds of cuts that pay on programs of quantizations. All kinds of probing together cut
  // off optima where integers are not binary (in CBC 2.10.8, and its issue 293 tells of it); one
  // kind does not. For the same reason programs are not preprocessed.
  static void add_cuts(CbcModel& model)
  {
    const int if_useful = -1;
    CglProbing probing;
    probing.setUsingObjective(1);
    probing.setMaxPass(1);
    probing.setMaxPassRoot(1);
    probing.setMaxProbeRoot(100);
    probing.setMaxLook(10);
    probing.setMaxLookRoot(50);
    const int only_disaggregation = 1;
    probing.setRowCuts(only_disaggregation);
    CglGomory gomory;
    gomory.setLimitAtRoot(1000);
    CglKnapsackCover knapsack;
    CglZeroHalf zero_half;
    model.addCutGenerator(&probing, if_useful, "probing");
    model.addCutGenerator(&gomory, if_useful, "gomory");
    model.addCutGenerator(&knapsack, if_useful, "knapsack");
    model.addCutGenerator(&zero_half, if_useful, "zero half");
  }

  // The pump is for a first solution, and slow.
  void add_heuristics(CbcModel& model) const
  {
    CbcRounding rounding(model);
    CbcHeuristicFPump pump(model);
    CbcHeuristicDiveCoefficient dive(model);
    CbcHeuristicRINS neighbourhood(model);
    model.addHeuristic(&rounding, "rounding");
    if (!has_solution)
      model.addHeuristic(&pump, "pump");
    model.addHeuristic(&dive, "dive");
    model.addHeuristic(&neighbourhood, "neighbourhood");
  }

  CbcEventHandler::CbcAction note_event(CbcModel& model, CbcEventHandler::CbcEvent which,
                                        bool is_whole_program)
  {
    // an interrupted linear program proves nothing
    if (is_whole_program && !m_has_ended) {
      if (which == CbcEventHandler::node) {
        ++m_nodes;
        improve_bound(model.getBestPossibleObjValue());
      } else if (which == CbcEventHandler::generatedCuts && model.getNodeCount() == 0 &&
                 model.solver()->isProvenOptimal())
        improve_bound(model.solver()->getObjValue());
    }
    return must_end() ? CbcEventHandler::stop : CbcEventHandler::noAction;
  }

  void take_result(const CbcModel& model)
  {
    if (model.bestSolution())
      take_solution(
          std::vector<double>(model.bestSolution(), model.bestSolution() + columns.size()));
    if (model.status() == 0 && !m_has_ended) {
      outcome = Outcome::COMPLETE;
      if (has_solution)
        improve_bound(model.getBestPossibleObjValue());
    } else {
      outcome = model.status() == 2 ? Outcome::ERROR : Outcome::LIMIT;
      message = outcome == Outcome::LIMIT ? "limit" : "the search failed";
    }
  }

  int m_iterations = 0, m_nodes = 0, m_questions = 0;
  bool m_has_ended = false;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_CBC_SEARCH_H
