// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_NEIGHBOURHOODS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_NEIGHBOURHOODS_H

#include <CGAL/Quad_layouts/internal/quantization/Loop_search.h>
#include <CGAL/Quad_layouts/internal/quantization/close_pairs.h>
#include <CGAL/Quad_layouts/internal/quantization/dual_loops.h>
#include <CGAL/Quad_layouts/internal/quantization/solve_in_box.h>
#include <CGAL/Quad_layouts/internal/tracing/Dual_graph.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Makes the boxes of a large-neighbourhood search.
class Neighbourhoods
{
public:
  Neighbourhoods(const T_mesh& t_mesh, const Dual_graph& graph)
    : m_t_mesh(t_mesh), m_graph(graph), m_distances(t_mesh)
  {
  }

  // returns the box about `x` that is free around the `count` singularities nearest to `nodes`
  Box near(const std::vector<int>& nodes, int count, const std::vector<int>& x)
  {
    Box box(x);
    for (int v : variables_near(nodes, count))
      box.free(v);
    return box;
  }

  // lets the dual loops of `x` that pass free variables shrink and grow along their whole length
  void free_loops_through(Box& box, const std::vector<int>& x) const
  {
    std::vector<char> is_passed(x.size(), 0);
    for (const Loop& loop : dual_loops(m_t_mesh, m_graph, x))
      if (std::any_of(loop.begin(), loop.end(), [&](int v) { return !box.is_fixed(v); }))
        for (int v : loop)
          is_passed[v] = 1;
    for (std::size_t v = 0; v < x.size(); ++v)
      if (is_passed[v] && box.is_fixed(int(v))) {
        box.low[v] = 0;
        box.high[v] = x[v] + 1;
      }
  }

  // returns the ends of the arcs that one of the dual loops of `x` crosses, none if there is no
  // loop; the choice is left to `choose(count)`. A box around them lets the loop move along its
  // whole length.
  template <class Choose>
  std::vector<int> along_a_loop(const std::vector<int>& x, const Choose& choose) const
  {
    const auto loops = dual_loops(m_t_mesh, arc_lengths(m_t_mesh, m_graph, x));
    std::vector<int> result;
    if (loops.empty())
      return result;
    for (int a : loops[choose(loops.size())]) {
      result.push_back(m_t_mesh.source(2 * a));
      result.push_back(m_t_mesh.target(2 * a));
    }
    return result;
  }

private:
  std::vector<int> variables_near(const std::vector<int>& nodes, int count)
  {
    m_distances.search(nodes, (std::numeric_limits<double>::max)());
    std::vector<double> distances;
    for (int n : m_distances.reached())
      if (m_t_mesh.is_singularity_or_seed(n))
        distances.push_back(m_distances.distance(n));
    std::sort(distances.begin(), distances.end());
    const double radius = distances[(std::min)(distances.size(), std::size_t(count)) - 1];
    std::vector<int> result;
    for (int n : m_distances.reached())
      if (m_distances.distance(n) <= radius) {
        const int first = m_t_mesh.halfedge_from(n);
        int h = first;
        do {
          const int v = m_graph.variable(T_mesh::edge(h));
          if (v >= 0)
            result.push_back(v);
          h = m_t_mesh.turn_right(h);
        } while (h != first);
      }
    return result;
  }

  const T_mesh& m_t_mesh;
  const Dual_graph& m_graph;
  Arc_distances m_distances;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_NEIGHBOURHOODS_H
