// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_DUAL_GRAPH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_DUAL_GRAPH_H

#include <CGAL/Quad_layouts/T_mesh.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The ways in which a line can cross a T-mesh from side to opposite side of its patches.
//
// Arcs that must be equally long, because they are alone on opposite sides of a patch, share one
// *variable*. A *state* is a variable and one of the two ways to cross it: 2v and 2v + 1.
// `successors(s)` are the states in which a line can cross next. The consistent quantizations are
// the sums of closed walks (*dual loops*), because units on opposite sides of each patch can be
// paired. Lines from border to border count as closed: the last state, `outside()`, follows all
// that leave the surface, and is followed by all that enter it. Hence an arc on no closed walk has
// length 0 in every consistent quantization; such arcs have no variable.
class Dual_graph
{
public:
  using Walk = std::vector<int>; // states in order; the first one follows the last one

  // `zero_arcs`: those whose length is to be 0 in all quantizations considered
  explicit Dual_graph(const T_mesh& t_mesh, const std::vector<int>& zero_arcs = {})
    : m_state(t_mesh.number_of_halfedges(), -1)
  {
    find_opposite_sides(t_mesh);
    int count = 0;
    for (int h = 0; h < t_mesh.number_of_halfedges(); h += 2)
      if (m_state[h] < 0)
        share(h, count++);
    link(t_mesh, 2 * count);
    for (int a : zero_arcs)
      for (int h : {2 * a, 2 * a + 1})
        m_successors[m_state[h]].clear();
    drop_dead_ends();
  }

  int number_of_variables() const { return outside() / 2; }
  int number_of_states() const { return int(m_successors.size()); }
  int outside() const { return number_of_states() - 1; }
  // the state of a line that crosses the arc of `h` into the patch of `h`; -1 if no closed line
  // does
  int state(int h) const { return m_state[h]; }
  // -1 if the arc has length 0 in every consistent quantization
  int variable(int arc) const { return m_state[2 * arc] < 0 ? -1 : m_state[2 * arc] / 2; }
  const std::vector<int>& successors(int state) const { return m_successors[state]; }
  // the halfedges of the side of its patch that h is on, and of the opposite one; none if h has no
  // patch
  const std::vector<int>& side(int h) const { return m_arcs[m_side[h]]; }
  const std::vector<int>& opposite_side(int h) const { return m_arcs[m_side[h] ^ 2]; }

private:
  void find_opposite_sides(const T_mesh& t_mesh)
  {
    m_side.assign(t_mesh.number_of_halfedges(), 4 * t_mesh.number_of_faces());
    for (int p = 0; p < t_mesh.number_of_faces(); ++p) {
      auto sides = t_mesh.sides(p);
      for (int k = 0; k < 4; ++k) {
        for (int h : sides[k])
          m_side[h] = 4 * p + k;
        m_arcs.push_back(std::move(sides[k]));
      }
    }
    m_arcs.resize(m_arcs.size() + 4);
  }

  bool is_simple(int h) const { return side(h).size() == 1 && opposite_side(h).size() == 1; }

  // gives the halfedges of `first` and of all arcs joined to it by simple patches the states 2v and
  // 2v + 1
  void share(int first, int v)
  {
    for (int direction : {0, 1}) {
      int h = first ^ direction;
      m_state[h] = 2 * v + direction;
      m_state[h ^ 1] = 2 * v + 1 - direction;
      while (is_simple(h)) {
        h = T_mesh::opposite(opposite_side(h).front());
        if (m_state[h] >= 0) // the strip is closed
          return;
        m_state[h] = 2 * v + direction;
        m_state[h ^ 1] = 2 * v + 1 - direction;
      }
    }
  }

  // `outside` is the number of the other states
  void link(const T_mesh& t_mesh, int outside)
  {
    m_successors.assign(outside + 1, {});
    for (std::size_t h = 0; h < m_state.size(); ++h)
      if (t_mesh.is_border(int(h))) {
        m_successors[m_state[h]].push_back(outside);
        m_successors[outside].push_back(m_state[h ^ 1]);
      } else if (!is_simple(int(h)))
        for (int g : opposite_side(int(h)))
          m_successors[m_state[h]].push_back(m_state[T_mesh::opposite(g)]);
    for (int s = 0; s < outside; ++s) {
      auto& next = m_successors[s];
      if (next.empty()) // simple patches all the way around
        next.push_back(s);
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
    }
  }

  std::vector<int> strong_components() const
  {
    boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph(m_successors.size());
    for (int s = 0; s < number_of_states(); ++s)
      for (int t : m_successors[s])
        add_edge(s, t, graph);
    std::vector<int> component(m_successors.size());
    boost::strong_components(graph, boost::make_iterator_property_map(
                                        component.begin(), get(boost::vertex_index, graph)));
    return component;
  }

  // keeps the links on closed walks and the states that have one, and numbers the variables anew
  void drop_dead_ends()
  {
    const int states = number_of_states();
    const std::vector<int> component = strong_components();
    for (int s = 0; s < states; ++s) {
      auto& next = m_successors[s];
      next.erase(std::remove_if(next.begin(), next.end(),
                                [&](int t) { return component[s] != component[t]; }),
                 next.end());
    }
    // a state and its reverse live or die together
    std::vector<int> renamed(states, -1);
    std::vector<std::vector<int>> kept;
    for (int s = 0; s < states; ++s)
      if (!m_successors[s].empty() || s == states - 1) {
        renamed[s] = int(kept.size());
        kept.push_back(std::move(m_successors[s]));
      }
    for (auto& next : kept)
      for (int& t : next)
        t = renamed[t];
    m_successors = std::move(kept);
    for (int& s : m_state)
      s = renamed[s];
  }

  std::vector<int> m_state, m_side;
  std::vector<std::vector<int>> m_arcs; // per side of a patch
  std::vector<std::vector<int>> m_successors;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_DUAL_GRAPH_H
