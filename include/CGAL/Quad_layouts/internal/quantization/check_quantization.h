// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_CHECK_QUANTIZATION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_CHECK_QUANTIZATION_H

#include <CGAL/Quad_layouts/internal/quantization/Quantization_program.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// How arc lengths fare in the program of the paper. Counts are exact: they are made in integers.
struct Quantization_check
{
  bool consistent = false; // no negative length, and opposite sides of all patches are equally long
  int violated_rows = 0;   // of (2) and (6)
  int index_excess = 0;    // sum of h_i in (8)
  double objective = 0;    // (9)
  bool grants_wishes = false; // of the user, as far as arcs tell

  int violated() const { return violated_rows + index_excess; }
};

inline long sum_over(const std::vector<int>& arcs, const std::vector<int>& q)
{
  long result = 0;
  for (int a : arcs)
    result += q[a];
  return result;
}

// counts the prefixes of run `r` that should be positive and are not
inline int violated_prefixes(const Quantization_program& program, int r, const std::vector<int>& q)
{
  const auto& arcs = program.runs[r];
  const auto zero = std::find_if(arcs.begin(), arcs.end(), [&](int a) { return q[a] != 0; }) -
                    arcs.begin();
  const auto& p = program.prefixes[r];
  return int(std::upper_bound(p.begin(), p.end(), int(zero)) - p.begin());
}

// returns per node the index after merging as the paper estimates it, Equation (4)
inline std::vector<int> estimated_indices(const T_mesh& t_mesh, const Quantization_program& program,
                                          const std::vector<int>& q)
{
  std::vector<int> result = t_mesh.node_index;
  for (const Close_pair& pair : program.pairs)
    if (sum_over(pair.path, q) == 0) {
      result[pair.i] += t_mesh.index(pair.j);
      result[pair.j] += t_mesh.index(pair.i);
    }
  return result;
}

inline bool are_equal(const std::vector<Quantization_program::Equation>& equations,
                      const std::vector<int>& q)
{
  return std::all_of(equations.begin(), equations.end(),
                     [&](const auto& e) { return sum_over(e.left, q) == sum_over(e.right, q); });
}

inline bool grants_wishes(const Quantization_program& program, const std::vector<int>& q)
{
  return are_equal(program.mirrored, q) && sum_over(program.locked, q) == 0 &&
         std::all_of(program.connections.begin(), program.connections.end(),
                     [&](const Wished_connection& c) {
                       return sum_over(c.zero, q) == 0 && sum_over(c.positive, q) > 0;
                     }) &&
         std::all_of(program.separate.begin(), program.separate.end(), [&](const Close_pair& p) {
           return p.path.empty() || sum_over(p.path, q) > 0;
         });
}

// evaluates every constraint of the paper's program, with no knowledge of how `q` was found
inline Quantization_check check_quantization(const T_mesh& t_mesh,
                                             const Quantization_program& program,
                                             const std::vector<int>& q)
{
  Quantization_check result;
  if (q.size() != program.weight.size())
    return result;
  result.consistent = std::all_of(q.begin(), q.end(), [](int x) { return x >= 0; }) &&
                      are_equal(program.equations, q);
  result.grants_wishes = grants_wishes(program, q);
  for (std::size_t r = 0; r < program.runs.size(); ++r)
    result.violated_rows += violated_prefixes(program, int(r), q);
  const std::vector<int> index = estimated_indices(t_mesh, program, q);
  for (int n : program.singularities) {
    const auto range = program.index_range[n];
    result.index_excess += (std::max)({0, range.first - index[n], index[n] - range.second});
  }
  for (std::size_t a = 0; a < q.size(); ++a)
    result.objective += program.weight[a] * q[a];
  result.objective += program.penalty() * result.violated();
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_CHECK_QUANTIZATION_H
