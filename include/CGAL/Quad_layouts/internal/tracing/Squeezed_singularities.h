// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_SQUEEZED_SINGULARITIES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_SQUEEZED_SINGULARITIES_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/tracing/Dual_graph.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Finds singularities that fall together in every consistent quantization of a T-mesh.
//
// A strip of lines that cross a T-mesh must run back into itself, and be as wide as it was. Where
// traces wind around a limit cycle of the field, strips get narrower with every turn: what is cut
// off has length 0 in every consistent quantization. If a chain of such arcs joins singularities,
// or fixed curves, some traces have gone on for too long. In a motorcycle graph that is not
// extended, few traces get around a limit cycle.
class Squeezed_singularities
{
public:
  explicit Squeezed_singularities(const T_mesh& t_mesh) : m_t_mesh(t_mesh), m_graph(t_mesh)
  {
    find_chains();
  }

  // per group of singularities that fall together the arcs of a chain from one to another, and an
  // arc of each closed fixed curve that vanishes
  const std::vector<std::vector<int>>& chains() const { return m_chains; }
  // how many singularities fall together with others, and how many closed fixed curves vanish
  int number_of_losses() const { return m_number_of_losses; }

  // Marks traces that should stop earlier, the more the more are marked already. Returns whether
  // there were any: else the singularities cannot be separated.
  bool release(std::vector<char>& is_hasty) const
  {
    is_hasty.resize(m_t_mesh.traces.size(), 0);
    const int least = 1 + int(std::count(is_hasty.begin(), is_hasty.end(), 1)) / 8;
    int marked = 0;
    for (const std::vector<int>& chain : m_chains)
      marked += release(chain, least, is_hasty);
    return marked > 0;
  }

  // those that lead along or to fixed curves: nothing but other singularities can separate them
  std::vector<std::vector<int>> chains_to_fixed_curves() const
  {
    std::vector<std::vector<int>> result;
    std::copy_if(m_chains.begin(), m_chains.end(), std::back_inserter(result),
                 [this](const std::vector<int>& chain) { return touches_fixed_curve(chain); });
    return result;
  }

  // per one of these chains the arcs across the strips that cross it, the nearest first
  std::vector<std::vector<int>> arcs_across_strips() const
  {
    std::vector<std::vector<int>> result;
    for (const std::vector<int>& chain : chains_to_fixed_curves()) {
      result.emplace_back();
      for (const int h : crossed(chain, false))
        result.back().push_back(T_mesh::edge(h));
    }
    return result;
  }

  // says where the first of them is, nothing if there are none
  std::string first_place() const
  {
    if (m_chains.empty())
      return "";
    const Eigen::Vector3d& p = m_t_mesh.point(m_t_mesh.source(2 * m_chains.front().front()));
    std::ostringstream out;
    out << "singularities or feature curves fall together near (" << p.x() << ", " << p.y() << ", "
        << p.z() << ")";
    return out.str();
  }

private:
  // whether a chain leads along or to a fixed curve; along the border corners may merge
  bool touches_fixed_curve(const std::vector<int>& chain) const
  {
    const auto touches = [this](int a) {
      return m_is_on_fixed_curve[m_t_mesh.source(2 * a)] ||
             m_is_on_fixed_curve[m_t_mesh.target(2 * a)];
    };
    return std::any_of(chain.begin(), chain.end(), touches) &&
           !std::all_of(chain.begin(), chain.end(),
                        [this](int a) { return m_t_mesh.is_border_edge(a); });
  }

  bool is_squeezed(int arc) const { return m_graph.variable(arc) < 0; }

  void find_chains()
  {
    const int n = m_t_mesh.number_of_vertices();
    Disjoint_sets groups(n), pieces(n);
    for (int a = 0; a < m_t_mesh.number_of_edges(); ++a)
      if (is_squeezed(a)) {
        groups.union_set(m_t_mesh.source(2 * a), m_t_mesh.target(2 * a));
        if (m_t_mesh.is_fixed(a)) {
          if (pieces.find_set(m_t_mesh.source(2 * a)) == pieces.find_set(m_t_mesh.target(2 * a))) {
            m_chains.push_back({a}); // it closes a fixed curve
            ++m_number_of_losses;
          }
          pieces.union_set(m_t_mesh.source(2 * a), m_t_mesh.target(2 * a));
        }
      }
    for (int v = 0; v < n; ++v) {
      m_piece.push_back(int(pieces.find_set(v)));
      m_is_on_fixed_curve.push_back(m_t_mesh.is_on_fixed_curve(v));
    }
    std::vector<int> first(n, -1); // per group, a node that should be apart from others
    std::vector<char> has_chain(n, 0);
    for (int v = 0; v < n; ++v) {
      if (m_t_mesh.index(v) == 0 && !m_is_on_fixed_curve[v])
        continue;
      const std::size_t group = groups.find_set(v);
      if (first[group] < 0)
        first[group] = v;
      else if (should_be_apart(first[group], v)) {
        ++m_number_of_losses;
        if (!std::exchange(has_chain[group], 1))
          m_chains.push_back(chain_from(first[group]));
      }
    }
  }

  // whether two nodes are singularities, or ends of fixed lines, or at different places of fixed
  // lines
  bool should_be_apart(int u, int v) const
  {
    const auto is_end = [&](int n) {
      return m_t_mesh.index(n) != 0 ||
             (m_t_mesh.is_singularity_or_seed(n) && m_is_on_fixed_curve[n]);
    };
    const auto is_marked = [&](int n) { return m_t_mesh.index(n) != 0 || m_is_on_fixed_curve[n]; };
    return (is_end(u) && is_end(v)) || (is_marked(u) && is_marked(v) && m_piece[u] != m_piece[v]);
  }

  // a shortest one to a node that should be apart
  std::vector<int> chain_from(int start) const
  {
    std::vector<int> reached_by(m_t_mesh.number_of_vertices(), -1), queue{start}, result;
    for (std::size_t i = 0; i < queue.size() && result.empty(); ++i) {
      int h = m_t_mesh.halfedge_from(queue[i]);
      do {
        const int v = m_t_mesh.target(h);
        if (is_squeezed(T_mesh::edge(h)) && v != start && reached_by[v] < 0) {
          reached_by[v] = h;
          queue.push_back(v);
        }
        h = m_t_mesh.turn_right(h);
      } while (h != m_t_mesh.halfedge_from(queue[i]));
      if (queue[i] != start && should_be_apart(start, queue[i]))
        for (int v = queue[i]; v != start; v = m_t_mesh.source(reached_by[v]))
          result.push_back(T_mesh::edge(reached_by[v]));
    }
    CGAL_postcondition(!result.empty());
    return result;
  }

  // Follows the strips across a chain, both ways. They end where a side of a patch is squeezed in
  // part only: the traces that end on that side are the first to blame. If these are hasty already,
  // it is those around the nearest patches. Marks these, `least` or more if there are so many;
  // returns how many it marked.
  int release(const std::vector<int>& chain, int least, std::vector<char>& is_hasty) const
  {
    int marked = 0;
    const auto mark = [&](int trace) { marked += !std::exchange(is_hasty[trace], 1); };
    for (const int h : crossed(chain, true))
      for_each_trace_that_squeezes(m_graph.side(h), mark);
    if (marked > 0)
      return marked;
    for (const int h : crossed(chain, false)) {
      int g = h;
      do {
        mark(m_t_mesh.trace(T_mesh::edge(g)));
        g = m_t_mesh.next(g);
      } while (g != h);
      if (marked >= least)
        break;
    }
    return marked;
  }

  // The halfedges by which lines that cross a chain of arcs enter patches, the nearest first; as
  // long as they cross squeezed arcs, or on and on.
  std::vector<int> crossed(const std::vector<int>& chain, bool squeezed_only) const
  {
    std::vector<char> is_reached(m_t_mesh.number_of_halfedges(), 0);
    std::vector<int> result;
    const auto reach = [&](int h) {
      if (!std::exchange(is_reached[h], 1))
        result.push_back(h);
    };
    for (const int a : chain) {
      reach(2 * a);
      reach(2 * a + 1);
    }
    for (std::size_t i = 0; i < result.size(); ++i)
      for (const int h : m_graph.opposite_side(result[i]))
        if (!squeezed_only || is_squeezed(T_mesh::edge(h)))
          reach(T_mesh::opposite(h));
    return result;
  }

  // those that end on a side of which other parts are not squeezed
  template <class Action>
  void for_each_trace_that_squeezes(const std::vector<int>& side, Action&& action) const
  {
    if (std::all_of(side.begin(), side.end(), [&](int h) { return is_squeezed(T_mesh::edge(h)); }))
      return;
    for (std::size_t i = 0; i + 1 < side.size(); ++i)
      for (const T_mesh::Visit& v : m_t_mesh.node_visits[m_t_mesh.target(side[i])])
        if (v.arcs == int(m_t_mesh.traces[v.trace].arcs.size()))
          action(v.trace);
  }

  const T_mesh& m_t_mesh;
  const Dual_graph m_graph;
  // per node
  std::vector<int> m_piece; // of the fixed curves as far as they are squeezed
  std::vector<char> m_is_on_fixed_curve;
  std::vector<std::vector<int>> m_chains;
  int m_number_of_losses = 0;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_SQUEEZED_SINGULARITIES_H
