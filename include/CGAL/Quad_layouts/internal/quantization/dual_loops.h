// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_DUAL_LOOPS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_DUAL_LOOPS_H

#include <CGAL/Quad_layouts/internal/quantization/Loop_search.h>
#include <CGAL/Quad_layouts/internal/tracing/Dual_graph.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// returns the dual loops whose sum is the consistent quantization `q`, each as the arcs that it
// crosses: the i-th unit on a side of a patch, counted along the side, continues as the i-th last
// one on the opposite side
inline std::vector<std::vector<int>> dual_loops(const T_mesh& t_mesh, const std::vector<int>& q)
{
  // where the units of a halfedge begin on its side, and all units of the side in order
  struct Place
  {
    int side, first;
  };
  struct Unit
  {
    int halfedge, number;
  };
  std::vector<Place> place(t_mesh.number_of_halfedges());
  std::vector<std::vector<Unit>> units;
  for (int p = 0; p < t_mesh.number_of_faces(); ++p)
    for (const auto& side : t_mesh.sides(p)) {
      units.emplace_back();
      for (int h : side) {
        place[h] = {int(units.size()) - 1, int(units.back().size())};
        for (int i = 0; i < q[T_mesh::edge(h)]; ++i)
          units.back().push_back({h, i});
      }
    }
  // sides are numbered 4p + k: the opposite one differs in the second bit
  const auto step = [&](const Unit& u) {
    const Place& from = place[u.halfedge];
    const auto& across = units[from.side ^ 2];
    const Unit& end = across[across.size() - 1 - (from.first + u.number)];
    return Unit{T_mesh::opposite(end.halfedge), q[T_mesh::edge(end.halfedge)] - 1 - end.number};
  };

  std::vector<std::vector<char>> visited(q.size());
  for (std::size_t a = 0; a < q.size(); ++a)
    visited[a].assign(q[a], 0);
  // units are numbered along halfedge 2a for either halfedge of arc a
  const auto mark = [&](const Unit& u) -> char& {
    const int a = T_mesh::edge(u.halfedge);
    return visited[a][u.halfedge % 2 == 0 ? u.number : q[a] - 1 - u.number];
  };
  std::vector<std::vector<int>> result;
  for (std::size_t a = 0; a < q.size(); ++a)
    for (int i = 0; i < q[a]; ++i) {
      Unit u{2 * int(a), i};
      if (mark(u))
        continue;
      result.emplace_back();
      for (; !mark(u); u = step(u)) {
        mark(u) = 1;
        result.back().push_back(T_mesh::edge(u.halfedge));
      }
    }
  return result;
}

// returns the length of each arc for the values `x` of its variables
inline std::vector<int> arc_lengths(const T_mesh& t_mesh, const Dual_graph& graph,
                                    const std::vector<int>& x)
{
  std::vector<int> result;
  for (int a = 0; a < t_mesh.number_of_edges(); ++a)
    result.push_back(graph.variable(a) < 0 ? 0 : x[graph.variable(a)]);
  return result;
}

// returns the dual loops whose sum gives each arc the value `x` of its variable. A loop passes all
// arcs of a variable in a row; it counts where it crosses the first of them.
inline std::vector<Loop> dual_loops(const T_mesh& t_mesh, const Dual_graph& graph,
                                    const std::vector<int>& x)
{
  std::vector<int> first_arc(x.size(), -1);
  for (int a = t_mesh.number_of_edges(); a-- > 0;)
    if (const int v = graph.variable(a); v >= 0)
      first_arc[v] = a;
  std::vector<Loop> result;
  for (const auto& arcs : dual_loops(t_mesh, arc_lengths(t_mesh, graph, x))) {
    result.emplace_back();
    for (int a : arcs)
      if (first_arc[graph.variable(a)] == a)
        result.back().push_back(graph.variable(a));
  }
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_DUAL_LOOPS_H
