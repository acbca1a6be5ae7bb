// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_REDUCED_PROGRAM_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_REDUCED_PROGRAM_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/quantization/Integer_row.h>
#include <CGAL/Quad_layouts/internal/quantization/Quantization_program.h>
#include <CGAL/Quad_layouts/internal/quantization/minimal_sets.h>
#include <CGAL/Quad_layouts/internal/tracing/Dual_graph.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// An equivalent of `Quantization_program` in fewer variables and rows.
//
// - Arcs that share a variable of the dual graph have the same value; arcs without one are 0.
// - Rows (2) and (6) of a run ask for positive prefixes: the shortest one implies the others.
//   Prefixes of length 0 in every consistent quantization are given up and counted. The others can
//   be satisfied all at once, by the sum of dual loops through them, so they need no slack: paying
//   the penalty is no gain while the whole rest of the objective is below it. Where it is not,
//   slacks serve to prove this.
// - Each row is a set: a variable that occurs twice in it counts once, which tightens the
//   relaxation.
// - Rows that contain another row are implied by it.
// - Arcs that the user wishes to be 0 have no variable.
struct Reduced_program
{
  // Which rows solvers get to see: all that are known, or those that exclude no valid layout, as
  // bounds need it.
  enum class Rows { ALL, EXACT };

  using Set = std::vector<int>; // of variables, sorted

  // c = 1 if and only if the variables of the path are all 0
  struct Indicator
  {
    int i, j; // nodes
    Set path;
  };
  // low <= base + sum of the terms' coefficients over the indicators that are 1 <= high
  struct Index_row
  {
    int base, low, high;
    std::vector<std::pair<int, int>> terms; // indicator, coefficient
    bool is_lazy = false;                   // left to the check of solutions until one violates it
  };
  // some variable of the set is positive or some of the indicators is 1
  struct Cut
  {
    Set variables;
    std::vector<int> indicators;
    bool is_exact; // it excludes no valid layout
  };

  std::vector<int> variable;                               // per arc, -1: always 0
  std::vector<double> cost;                                // per variable
  std::vector<std::vector<std::pair<int, int>>> equations; // variable, coefficient; the sum is 0
  std::vector<std::vector<std::pair<int, int>>> mirrored;  // in the same form
  std::vector<Set> covers;                                 // some variable is positive
  std::vector<Indicator> indicators;
  std::vector<Index_row> index_rows;
  std::vector<Cut> cuts; // wishes of the user, and then those found while solving
  int wished_cuts = 0;
  // implied by the other hard rows, but not in the relaxation; columns are the variables, then the
  // indicators
  std::vector<Integer_row> strengthening;
  int violated_rows = 0; // of (2) and (6), in every quantization
  bool index_rows_are_soft =
      false; // as in (8): keeping all apart that can be kept apart violates some
  double penalty = 0;

  int number_of_variables() const { return int(cost.size()); }

  // grows when solvers get to see rows that they did not see before
  int number_of_visible_rows(Rows rows) const
  {
    return int(std::count_if(cuts.begin(), cuts.end(),
                             [=](const Cut& cut) { return is_visible(cut, rows); }) +
               std::count_if(index_rows.begin(), index_rows.end(),
                             [](const Index_row& row) { return !row.is_lazy; }));
  }

  bool is_visible(const Cut& cut, Rows rows) const { return cut.is_exact || rows == Rows::ALL; }

  std::vector<int> arc_lengths(const std::vector<int>& x) const
  {
    std::vector<int> q;
    for (int v : variable)
      q.push_back(v < 0 ? 0 : x[v]);
    return q;
  }

  // the variables of some arcs
  Set set_of(const std::vector<int>& arcs) const
  {
    Set result;
    for (int a : arcs)
      if (variable[a] >= 0)
        result.push_back(variable[a]);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
};

namespace reduction {

// returns the equations that are not satisfied by all values, each once
inline std::vector<std::vector<std::pair<int, int>>> reduced(
    const std::vector<Quantization_program::Equation>& equations, const std::vector<int>& variable)
{
  std::vector<std::vector<std::pair<int, int>>> result;
  for (const auto& equation : equations) {
    std::map<int, int> coefficients;
    for (int a : equation.left)
      if (variable[a] >= 0)
        ++coefficients[variable[a]];
    for (int a : equation.right)
      if (variable[a] >= 0)
        --coefficients[variable[a]];
    std::vector<std::pair<int, int>> terms;
    for (const auto& c : coefficients)
      if (c.second != 0)
        terms.push_back(c);
    if (!terms.empty())
      result.push_back(std::move(terms));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// adds the shortest required prefix of each run that can be positive at all
inline void add_covers(const Quantization_program& program, Reduced_program& result)
{
  std::vector<Reduced_program::Set> sets;
  for (std::size_t r = 0; r < program.prefixes.size(); ++r) {
    const auto& arcs = program.runs[r];
    for (int k : program.prefixes[r]) {
      const auto set = result.set_of({arcs.begin(), arcs.begin() + k});
      if (!set.empty()) {
        sets.push_back(set);
        break;
      }
      ++result.violated_rows;
    }
  }
  result.covers = minimal_sets(std::move(sets));
}

// adds the indicators that are not constant, and the index rows that they can violate
inline void add_index_rows(const T_mesh& t_mesh, const Quantization_program& program,
                           const Monitor& monitor, Reduced_program& result)
{
  std::vector<Reduced_program::Index_row> row(t_mesh.number_of_vertices());
  for (int n : program.singularities)
    row[n] = {
        t_mesh.index(n), program.index_range[n].first, program.index_range[n].second, {}, false};
  const Subset_query covers(result.covers, result.number_of_variables());
  for (const Close_pair& pair : program.pairs) {
    monitor.check("quantize");
    const auto path = result.set_of(pair.path);
    if (covers.has_subset_of(path)) // the two never merge
      continue;
    if (path.empty()) { // they always do
      row[pair.i].base += t_mesh.index(pair.j);
      row[pair.j].base += t_mesh.index(pair.i);
      continue;
    }
    row[pair.i].terms.emplace_back(int(result.indicators.size()), t_mesh.index(pair.j));
    row[pair.j].terms.emplace_back(int(result.indicators.size()), t_mesh.index(pair.i));
    result.indicators.push_back({pair.i, pair.j, path});
  }
  for (int n : program.singularities) {
    int low = row[n].base, high = row[n].base;
    for (const auto& term : row[n].terms)
      (term.second < 0 ? low : high) += term.second;
    if (low < row[n].low || high > row[n].high)
      result.index_rows.push_back(row[n]);
    if (row[n].base < row[n].low || row[n].base > row[n].high)
      result.index_rows_are_soft = true;
  }
}

// adds the rows of the user's wishes as cuts, which are never given up
inline void add_wishes(const T_mesh& t_mesh, const Quantization_program& program,
                       Reduced_program& result)
{
  const auto require_positive = [&](const std::vector<int>& arcs, int i, int j) {
    auto set = result.set_of(arcs);
    if (set.empty())
      throw inseparable(t_mesh, i, j);
    result.cuts.push_back({std::move(set), {}, true});
  };
  for (const Wished_connection& c : program.connections)
    require_positive(c.positive, c.i, c.j);
  for (const Close_pair& pair : program.separate)
    if (!pair.path.empty()) // else they are on different components
      require_positive(pair.path, pair.i, pair.j);
  result.wished_cuts = int(result.cuts.size());
}

} // namespace reduction

// `graph` must know the zero arcs of `program`; `monitor` ends what takes long
inline Reduced_program reduce(const T_mesh& t_mesh, const Quantization_program& program,
                              const Dual_graph& graph, const Monitor& monitor = {})
{
  Reduced_program result;
  result.penalty = program.penalty();
  result.cost.assign(graph.number_of_variables(), 0.);
  for (int a = 0; a < t_mesh.number_of_edges(); ++a) {
    result.variable.push_back(graph.variable(a));
    if (graph.variable(a) >= 0)
      result.cost[graph.variable(a)] += program.weight[a];
  }
  result.equations = reduction::reduced(program.equations, result.variable);
  result.mirrored = reduction::reduced(program.mirrored, result.variable);
  reduction::add_covers(program, result);
  reduction::add_index_rows(t_mesh, program, monitor, result);
  reduction::add_wishes(t_mesh, program, result);
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_REDUCED_PROGRAM_H
