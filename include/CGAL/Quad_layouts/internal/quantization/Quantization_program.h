// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_PROGRAM_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_PROGRAM_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/quantization/Quantization_wishes.h>
#include <CGAL/Quad_layouts/internal/quantization/Runs.h>
#include <CGAL/Quad_layouts/internal/quantization/alignments.h>
#include <CGAL/Quad_layouts/internal/quantization/close_pairs.h>
#include <CGAL/Quad_layouts/internal/quantization/mirrored_arcs.h>
#include <CGAL/Quad_layouts/internal/quantization/wished_connections.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// What the user asks of a quantization, in the units of the T-mesh.
struct Quantization_demands
{
  double tangent;    // of the largest deviation alpha
  double reach;      // 2r as a length: what two vertices that move towards each other can bridge
  int minimum_index; // of a layout vertex, in quarters
  int maximum_index;
};

// The integer program of [LCK21b], Section 4.5, as plain data over the arcs of a T-mesh, and what
// the user asks for beyond it. Nothing is simplified here: this is what a quantization is checked
// against.
struct Quantization_program
{
  // sum of q over the first side = sum of q over the second side
  struct Equation
  {
    std::vector<int> left, right;
  };
  // rows (2) and (6) of one run: per entry k, the sum of q over the first k arcs must be positive;
  // ascending
  using Prefixes = std::vector<int>;

  std::vector<double> weight;                   // per arc, Equation (1)
  std::vector<Equation> equations;              // two per patch
  std::vector<std::vector<int>> runs;           // the arcs of each
  std::vector<Prefixes> prefixes;               // per run
  std::vector<int> singularities;               // the nodes that have an index row (5)
  std::vector<Close_pair> pairs;                // the indicators (3), one per unordered pair
  std::vector<std::pair<int, int>> index_range; // per node, for its row (5)

  // the wishes of the user, which are never given up
  std::vector<Close_pair> separate; // nodes that do not fall together, so that the path is positive
  std::vector<Wished_connection> connections;
  std::vector<Equation> mirrored;
  std::vector<int> locked; // arcs between aligned singularities, which are 0

  // the arcs that are 0 because the user asks for it
  std::vector<int> zero_arcs() const
  {
    std::vector<int> result = locked;
    for (const Wished_connection& c : connections)
      result.insert(result.end(), c.zero.begin(), c.zero.end());
    return result;
  }

  // the penalty of a violated row, Equation (9)
  double penalty() const { return std::accumulate(weight.begin(), weight.end(), 0.); }
};

namespace quantization_program {

// returns the two consistency equations of each patch
inline std::vector<Quantization_program::Equation> equations(const T_mesh& t_mesh)
{
  std::vector<Quantization_program::Equation> result;
  const auto arcs = [](const std::vector<int>& side) {
    std::vector<int> edges;
    for (int h : side)
      edges.push_back(T_mesh::edge(h));
    return edges;
  };
  for (int p = 0; p < t_mesh.number_of_faces(); ++p) {
    const auto sides = t_mesh.sides(p);
    for (int k : {0, 1})
      result.push_back({arcs(sides[k]), arcs(sides[k + 2])});
  }
  return result;
}

// returns per arc half the length of the patches beside it, across it: the length of a dual loop is
// then the sum of the weights of the arcs that it crosses
inline std::vector<double> weights(const T_mesh& t_mesh, const std::vector<double>& arc_length)
{
  std::vector<double> result(t_mesh.number_of_edges(), 0.);
  for (int p = 0; p < t_mesh.number_of_faces(); ++p) {
    const auto sides = t_mesh.sides(p);
    std::array<double, 4> length{};
    for (int k = 0; k < 4; ++k)
      for (int h : sides[k])
        length[k] += arc_length[T_mesh::edge(h)];
    for (int k = 0; k < 4; ++k)
      for (int h : sides[k])
        result[T_mesh::edge(h)] += (length[(k + 1) % 4] + length[(k + 3) % 4]) / 4;
  }
  return result;
}

// says if the trace that runs `own` until it meets one that has run `other` needs a positive prefix
// there. The longer leg separates the two singularities, Equation (2), the shorter one keeps a
// separatrix that deviates too much from forming, Equation (6).
inline bool must_be_positive(double own, double other, bool own_is_longer,
                             const Quantization_demands& demands)
{
  return own_is_longer ? own > demands.reach
                       : own - demands.reach > demands.tangent * (other + demands.reach);
}

// says if `run` leads from one singularity or seed to another one
inline bool leads_to_singularity(const T_mesh& t_mesh, const Run& run)
{
  if (run.arcs.empty())
    return false;
  const int a = run.arcs.back();
  return t_mesh.is_fixed(a) || t_mesh.is_singularity_or_seed(t_mesh.target(2 * a));
}

// Says if both ends of a fixed run have to be kept: where fixed curves inside of the surface have
// corners, end or meet. Corners of the border may merge.
inline bool is_kept(const T_mesh& t_mesh, const Run& run)
{
  const int a = run.arcs.back();
  const auto is_on_border_only = [&](int n) { return t_mesh.number_of_fixed_arcs(n) == 2; };
  return t_mesh.is_fixed(a) &&
         !(t_mesh.is_border_edge(a) && is_on_border_only(t_mesh.source(2 * a)) &&
           is_on_border_only(t_mesh.target(2 * a)) && is_on_border_only(run.start));
}

// says if visit k of a meeting is that of the longer run. In the interior it is the one that was it
// in tracing, as the T-mesh has noted: also if they are equally long, or sums of lengths are
// rounded in another way.
inline bool is_longer(const Run_meeting& meeting, int k, const Runs& runs)
{
  const auto key = [&](const Run_visit& v) {
    return std::make_tuple(runs.length(v), v.run, v.arcs);
  };
  return meeting.on_fixed_curve ? key(meeting.visits[k]) > key(meeting.visits[1 - k]) : k == 1;
}

// returns per run the prefixes that rows (2) and (6) ask to be positive. Nothing is to fall onto a
// fixed curve, where it would turn a smooth curve into a corner.
inline std::vector<Quantization_program::Prefixes> prefixes(const T_mesh& t_mesh, const Runs& runs,
                                                            const Quantization_demands& demands)
{
  std::vector<Quantization_program::Prefixes> result(runs.size());
  for (const Run_meeting& meeting : runs.meetings())
    for (int k : {0, 1}) {
      const Run_visit& visit = meeting.visits[k];
      if ((meeting.on_fixed_curve && k == 1) ||
          must_be_positive(runs.length(visit), runs.length(meeting.visits[1 - k]),
                           is_longer(meeting, k, runs), demands))
        result[visit.run].push_back(visit.arcs);
    }
  // a run that leads to a singularity meets it at distance 0 on the other leg
  for (int r = 0; r < runs.size(); ++r)
    if (leads_to_singularity(t_mesh, runs[r]) &&
        (runs[r].lengths.back() > demands.reach || is_kept(t_mesh, runs[r])))
      result[r].push_back(int(runs[r].arcs.size()));
  for (auto& p : result)
    std::sort(p.begin(), p.end());
  return result;
}

// returns equations that make a quantization as symmetric as the T-mesh is
inline std::vector<Quantization_program::Equation> mirrored(const T_mesh& t_mesh, const Runs& runs,
                                                            const std::vector<int>& vertex_image)
{
  std::vector<Quantization_program::Equation> result;
  if (vertex_image.empty())
    return result;
  const Surface_symmetry symmetry(t_mesh.surface(), vertex_image);
  const Mirrored_runs mirrored_runs(t_mesh, runs, symmetry);
  if (mirrored_runs.is_empty())
    throw Unsatisfiable_demand("vertex_symmetry: no trace of the T-mesh has an image");
  for (const auto& [arcs, image] : mirrored_runs.segments())
    result.push_back({arcs, image});
  return result;
}

// adds the rows of the user's wishes; the others must be there
inline void add_wishes(const T_mesh& t_mesh, const Runs& runs, const Quantization_wishes& wishes,
                       Quantization_program& program)
{
  for (std::size_t a = 0; a < wishes.arc_weight.size(); ++a)
    program.weight[a] *= wishes.arc_weight[a];
  const auto separate = [&](int i, int j) {
    program.separate.push_back({(std::min)(i, j), (std::max)(i, j), shortest_path(t_mesh, i, j)});
  };
  const Connection_search search(t_mesh, runs, program.prefixes);
  for (const auto& [i, j] : wishes.connected) {
    program.connections.push_back(search.between(i, j));
    separate(i, j);
  }
  for (const auto& [i, j] : wishes.separate)
    separate(i, j);
  program.mirrored = mirrored(t_mesh, runs, wishes.vertex_image);
  if (wishes.locks_alignments)
    program.locked = Alignments(t_mesh, runs, program.prefixes).lock(program.zero_arcs());
}

} // namespace quantization_program

// returns the program of [LCK21b] for `t_mesh`, with the wishes of the user; `monitor` ends what
// takes long
inline Quantization_program build_quantization_program(const T_mesh& t_mesh,
                                                       const Quantization_demands& demands,
                                                       const Quantization_wishes& wishes = {},
                                                       const Monitor& monitor = {})
{
  const Runs runs(t_mesh);
  Quantization_program result;
  result.weight = quantization_program::weights(t_mesh, t_mesh.arc_length);
  result.equations = quantization_program::equations(t_mesh);
  for (int r = 0; r < runs.size(); ++r)
    result.runs.push_back(runs[r].arcs);
  result.prefixes = quantization_program::prefixes(t_mesh, runs, demands);
  result.pairs = close_pairs(t_mesh, runs, demands.reach, monitor);
  result.index_range.assign(t_mesh.number_of_vertices(),
                            {demands.minimum_index, demands.maximum_index});
  for (int n = 0; n < t_mesh.number_of_vertices(); ++n)
    if (t_mesh.is_singularity_or_seed(n)) {
      result.singularities.push_back(n);
      // a singularity that is out of the range by itself is not to blame for it
      auto& range = result.index_range[n];
      if (t_mesh.is_on_border(n)) // where two quadrants less would leave none
        range.second = (std::min)(range.second, 1);
      range.first = (std::min)(range.first, t_mesh.index(n));
      range.second = (std::max)(range.second, t_mesh.index(n));
    }
  quantization_program::add_wishes(t_mesh, runs, wishes, result);
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_PROGRAM_H
