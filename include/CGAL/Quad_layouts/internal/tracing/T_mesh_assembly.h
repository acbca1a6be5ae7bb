// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_T_MESH_ASSEMBLY_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_T_MESH_ASSEMBLY_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/tracing/Motorcycles.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Makes the T-mesh of the traces of motorcycles that have all stopped, and of the fixed curves.
class T_mesh_assembly
{
public:
  using Surface = Triangle_surface;

  T_mesh_assembly(std::shared_ptr<const Surface> surface, const Chords& chords,
                  const Motorcycles& motorcycles)
    : m_chords(chords), m_motorcycles(motorcycles),
      m_node_of_crossing(chords.number_of_crossings(), -1),
      m_node_of_point(chords.order().number_of_points(), -1),
      m_halfedge_of_point(chords.order().number_of_points(), -1)
  {
    m_result.surface_pointer = std::move(surface);
  }

  T_mesh operator()()
  {
    make_start_nodes();
    make_crossing_nodes();
    make_nodes_on_fixed_edges();
    m_result.corner_arcs.resize(surface().number_of_halfedges());
    for (int t = 0; t < int(m_motorcycles.traces().size()); ++t)
      make_arcs(t);
    make_fixed_traces();
    connect();
    number_patches();
    collect_edge_crossings();
    return std::move(m_result);
  }

private:
  // The halfedges that leave a node, counter-clockwise; each comes `quarter_turns` after the one
  // before it, across a patch.
  struct Outgoing
  {
    int halfedge;
    int quarter_turns;
  };

  void make_start_nodes()
  {
    m_node_of_vertex.assign(surface().number_of_vertices(), -1);
    for (int v : m_motorcycles.starts()) {
      m_node_of_vertex[v] = m_result.number_of_vertices();
      make_node(surface().point(v), v, m_chords.labels().index(v));
    }
    for (const auto& t : m_motorcycles.traces())
      m_result.traces.push_back({m_node_of_vertex[t.vertex], {}});
    m_first_inner_node = m_result.number_of_vertices();
  }

  // The visit of the longer trace comes second.
  void make_crossing_nodes()
  {
    for (int x = 0; x < m_chords.number_of_crossings(); ++x)
      if (m_chords.crossing(x).confirmed) {
        m_node_of_crossing[x] = m_result.number_of_vertices();
        make_inner_node(m_chords.point(m_chords.crossing(x)));
      }
  }

  // where traces cross fixed edges, or end there
  void make_nodes_on_fixed_edges()
  {
    for (const auto& t : m_motorcycles.traces()) {
      for (std::size_t i = 1; i < t.chords.size() && t.chords[i - 1] != t.last_chord; ++i)
        if (const Chords::End& from = m_chords.chord(t.chords[i]).from;
            surface().is_fixed(from.halfedge)) {
          m_node_of_point[from.point] = m_result.number_of_vertices();
          make_inner_node(m_chords.point_of_start(t.chords[i]));
        }
      if (t.last_crossing < 0) {
        m_node_of_point[m_chords.chord(t.chords.back()).to.point] = m_result.number_of_vertices();
        make_inner_node(m_chords.point_of_end(t.chords.back()));
      }
    }
  }

  void make_inner_node(const Point& point)
  {
    make_node(point, -1, 0);
    m_result.node_visits.back().assign(2, {-1, -1});
    m_around.push_back({-1, -1, -1, -1});
  }

  void make_node(const Point& point, int surface_vertex, int index)
  {
    m_result.vertex_point.push_back(point);
    m_result.node_surface_vertex.push_back(surface_vertex);
    m_result.node_index.push_back(index);
    m_result.node_visits.emplace_back();
    m_result.vertex_halfedge.push_back(-1);
  }

  // cuts trace t into arcs at its nodes
  void make_arcs(int t)
  {
    const auto& trace = m_motorcycles.traces()[t];
    m_result.corner_arcs[trace.corner].push_back(m_result.number_of_halfedges());
    begin_arc(t, m_result.traces[t].start);
    double length = 0;
    for (int c : trace.chords) {
      const auto& chord = m_chords.chord(c);
      if (chord.from.point >= 0 && m_node_of_point[chord.from.point] >= 0) {
        cross_fixed_edge(t, chord.from, chord.begin - length);
        length = chord.begin;
      } else if (chord.from.point >= 0) {
        m_halfedge_of_point[chord.from.point] = halfedge_towards_source(chord.from);
        m_result.arc_crossings.back().push_back({chord.from.halfedge, chord.from.point});
      }
      for (int x : chord.crossings) {
        if (!m_chords.crossing(x).confirmed)
          continue;
        const double here = m_chords.crossing(x).length[m_chords.side(x, c)];
        end_arc_in_crossing(t, x, c, here - length);
        if (c == trace.last_chord && x == trace.last_crossing)
          return;
        begin_arc(t, m_node_of_crossing[x]);
        around(m_node_of_crossing[x])[quarter_turns(x, c)] = m_result.number_of_halfedges() - 2;
        length = here;
      }
    }
    const auto& last = m_chords.chord(trace.chords.back());
    const int node = m_node_of_point[last.to.point];
    CGAL_assertion_msg(node >= 0, "a trace has not stopped");
    end_arc(t, node, 1, last.end - length);
    const int h = last.to.halfedge;
    around(node)[surface().halfedge_of_edge(surface().edge(h)) == h ? 1 : 3] =
        m_result.number_of_halfedges() - 1;
  }

  // goes on in a new arc behind a fixed edge
  void cross_fixed_edge(int t, const Chords::End& entry, double length)
  {
    const int node = m_node_of_point[entry.point];
    const int ahead = surface().halfedge_of_edge(surface().edge(entry.halfedge)) == entry.halfedge
                          ? 1
                          : 3;
    end_arc(t, node, 1, length);
    around(node)[4 - ahead] = m_result.number_of_halfedges() - 1;
    begin_arc(t, node);
    around(node)[ahead] = m_result.number_of_halfedges() - 2;
  }

  // the halfedge of the current arc whose left side is that of the source of the crossed edge,
  // where the trace enters a face through `entry`
  int halfedge_towards_source(const Chords::End& entry) const
  {
    const int e = m_chords.order().edge(entry.point), forward = m_result.number_of_halfedges() - 2;
    // a trace that comes from the left of the edge has its source on the right
    return surface().halfedge_of_edge(e) == entry.halfedge ? forward : forward + 1;
  }

  void begin_arc(int t, int node)
  {
    m_result.traces[t].arcs.push_back(m_result.number_of_edges());
    m_result.arc_trace.push_back(t);
    m_result.arc_crossings.emplace_back();
    m_result.arc_pieces.emplace_back();
    m_result.halfedge_target.insert(m_result.halfedge_target.end(), {-1, node});
  }

  void end_arc_in_crossing(int t, int x, int c, double length)
  {
    const bool is_later = m_motorcycles.later_side(x) == m_chords.side(x, c);
    end_arc(t, m_node_of_crossing[x], is_later ? 1 : 0, length);
    around(m_node_of_crossing[x])[(quarter_turns(x, c) + 2) & 3] = m_result.number_of_halfedges() -
                                                                   1;
  }

  // `visit`: which one of the node it is
  void end_arc(int t, int node, int visit, double length)
  {
    m_result.halfedge_target[m_result.number_of_halfedges() - 2] = node;
    m_result.arc_length.push_back(length);
    if (!m_result.node_visits[node].empty())
      m_result.node_visits[node][visit] = {t, int(m_result.traces[t].arcs.size())};
  }

  // Traces run along fixed edges from start to start; those on the border have the surface on their
  // left.
  void make_fixed_traces()
  {
    m_result.edge_arcs.resize(surface().number_of_edges());
    for (int v : m_motorcycles.starts())
      surface().for_each_outgoing(v, [&](int h) {
        if (surface().is_fixed(h) && m_result.edge_arcs[surface().edge(h)].empty()) {
          m_result.traces.push_back({m_node_of_vertex[v], {}});
          make_fixed_arcs(int(m_result.traces.size()) - 1, h);
        }
      });
  }

  void make_fixed_arcs(int t, int h)
  {
    begin_arc(t, m_result.traces[t].start);
    double length = 0;
    for (;; h = next_fixed(h)) {
      run_along(t, h, length);
      if (const int node = m_node_of_vertex[surface().target(h)]; node >= 0)
        return end_arc(t, node, 0, length);
    }
  }

  // the fixed halfedge that goes on straight behind h
  int next_fixed(int h) const
  {
    int result = surface().halfedge(surface().target(h));
    if (!surface().is_border(h))
      surface().for_each_outgoing(surface().target(h), [&](int g) {
        if (surface().is_fixed(g) && g != surface().opposite(h))
          result = g;
      });
    return result;
  }

  // takes trace t along h; `length` is that of its last arc so far
  void run_along(int t, int h, double& length)
  {
    const int e = surface().edge(h);
    const bool is_canonical = surface().halfedge_of_edge(e) == h;
    std::vector<int> points = nodes_on(e), arcs;
    if (!is_canonical)
      std::reverse(points.begin(), points.end());
    const int pieces = int(points.size()) + 1;
    const auto add_piece = [&] {
      const int i = int(arcs.size());
      m_result.arc_pieces.back().push_back({h, is_canonical ? i : pieces - 1 - i});
      arcs.push_back(m_result.number_of_halfedges() - 2);
    };
    double passed = 0; // of the edge
    for (int p : points) {
      const double here = m_chords.length_before({h, p});
      length += here - passed;
      passed = here;
      add_piece();
      const int node = m_node_of_point[p], ahead = is_canonical ? 0 : 2;
      end_arc(t, node, 0, std::exchange(length, 0));
      around(node)[2 - ahead] = m_result.number_of_halfedges() - 1;
      begin_arc(t, node);
      around(node)[ahead] = m_result.number_of_halfedges() - 2;
    }
    length += m_chords.length(h) - passed;
    add_piece();
    if (!is_canonical) {
      std::reverse(arcs.begin(), arcs.end());
      for (int& a : arcs)
        a = Halfedge_complex::opposite(a);
    }
    m_result.edge_arcs[e] = std::move(arcs);
  }

  // the points on edge e that are nodes
  std::vector<int> nodes_on(int e) const
  {
    std::vector<int> result;
    for (int p : m_chords.order().points(e))
      if (m_node_of_point[p] >= 0)
        result.push_back(p);
    return result;
  }

  // The halfedges that leave an inner node: of a crossing, by quarter-turns from the direction of
  // its first chord; on a fixed edge, from the direction of its canonical halfedge.
  std::array<int, 4>& around(int node) { return m_around[node - m_first_inner_node]; }
  int quarter_turns(int x, int c) const
  {
    const int first = m_chords.crossing(x).chord[0];
    return c == first ? 0 : m_chords.quarter_turns(x, first);
  }

  void connect()
  {
    m_result.halfedge_next.assign(m_result.number_of_halfedges(), -1);
    m_result.halfedge_is_corner.assign(m_result.number_of_halfedges(), 0);
    for (int n = 0; n < m_first_inner_node; ++n)
      connect_around(n, outgoing_from_vertex(m_result.surface_vertex(n)));
    for (int i = 0; i < int(m_around.size()); ++i)
      connect_around(m_first_inner_node + i, outgoing(m_around[i]));
  }

  // On the border the first one has the border on its right, the last one on its left.
  std::vector<Outgoing> outgoing_from_vertex(int v) const
  {
    std::vector<Outgoing> result;
    surface().for_each_outgoing(v, [&](int h) {
      if (surface().is_fixed(h))
        result.push_back({first_arc_along(h), surface().is_border(h) ? 0 : 1});
      for (int arc : m_result.corner_arcs[h])
        result.push_back({arc, 1});
    });
    if (surface().is_on_border(v)) {
      const int e = surface().edge(surface().border_halfedge_to(v));
      result.push_back({Halfedge_complex::opposite(m_result.edge_arcs[e].back()), 1});
    }
    return result;
  }

  // the halfedge of the arc that begins with the fixed halfedge h
  int first_arc_along(int h) const
  {
    const auto& arcs = m_result.edge_arcs[surface().edge(h)];
    return surface().halfedge_of_edge(surface().edge(h)) == h
               ? arcs.front()
               : Halfedge_complex::opposite(arcs.back());
  }

  static std::vector<Outgoing> outgoing(const std::array<int, 4>& around)
  {
    std::vector<Outgoing> result;
    for (int q = 0; q < 4; ++q)
      if (around[q] >= 0)
        result.push_back({around[q], around[(q + 3) & 3] >= 0 ? 1 : 2});
    return result;
  }

  // A patch lies on the left of its halfedges: what arrives goes on along the next one clockwise.
  void connect_around(int node, const std::vector<Outgoing>& leaving)
  {
    m_result.vertex_halfedge[node] = leaving.front().halfedge;
    int right = leaving.back().halfedge;
    for (const Outgoing& o : leaving) {
      const int arriving = Halfedge_complex::opposite(o.halfedge);
      m_result.halfedge_next[arriving] = right;
      m_result.halfedge_is_corner[arriving] = o.quarter_turns == 1;
      right = o.halfedge;
    }
  }

  // The first halfedge of a patch follows a corner, if there is one.
  void number_patches()
  {
    m_result.halfedge_face.assign(m_result.number_of_halfedges(), -1);
    for (int h = 0; h < m_result.number_of_halfedges(); ++h) {
      if (m_result.halfedge_face[h] >= 0 || is_outside(h))
        continue;
      const int patch = m_result.number_of_faces();
      int first = h, g = h;
      do {
        m_result.halfedge_face[g] = patch;
        if (m_result.is_corner(g) && first == h)
          first = m_result.next(g);
        g = m_result.next(g);
      } while (g != h);
      m_result.face_halfedge.push_back(first);
    }
  }

  bool is_outside(int h) const
  {
    const auto& pieces = m_result.arc_pieces[Halfedge_complex::edge(h)];
    return h % 2 == 1 && !pieces.empty() && surface().is_border(pieces.front().halfedge);
  }

  // Points behind the end of a trace have no arc. The arcs know their crossings by points so far.
  void collect_edge_crossings()
  {
    m_result.edge_crossings.resize(surface().number_of_edges());
    m_result.crossing_parameters.resize(surface().number_of_edges());
    std::vector<int> position_of_point(m_halfedge_of_point.size(), -1);
    for (int e = 0; e < surface().number_of_edges(); ++e)
      for (int p : m_chords.order().points(e))
        if (m_halfedge_of_point[p] >= 0) {
          position_of_point[p] = int(m_result.edge_crossings[e].size());
          m_result.edge_crossings[e].push_back(m_halfedge_of_point[p]);
          m_result.crossing_parameters[e].push_back(m_chords.order().t(p));
        } else if (m_node_of_point[p] >= 0)
          m_result.crossing_parameters[e].push_back(m_chords.order().t(p));
    for (auto& crossings : m_result.arc_crossings)
      for (T_mesh::Crossing& c : crossings)
        c.position = position_of_point[c.position];
  }

  const Surface& surface() const { return *m_result.surface_pointer; }

  const Chords& m_chords;
  const Motorcycles& m_motorcycles;
  std::vector<int> m_node_of_vertex, m_node_of_crossing, m_node_of_point; // -1: no node
  std::vector<int> m_halfedge_of_point;
  std::vector<std::array<int, 4>> m_around; // per inner node
  int m_first_inner_node = 0;               // behind those at vertices of the surface
  T_mesh m_result;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_T_MESH_ASSEMBLY_H
