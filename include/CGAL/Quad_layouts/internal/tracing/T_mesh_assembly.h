// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_T_MESH_ASSEMBLY_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_T_MESH_ASSEMBLY_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/tracing/Motorcycles.h>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Makes the T-mesh of the traces of motorcycles that have all stopped.
class T_mesh_assembly
{
public:
  using Surface = Triangle_surface;

  T_mesh_assembly(std::shared_ptr<const Surface> surface, const Chords& chords,
                  const Motorcycles& motorcycles)
    : m_chords(chords), m_motorcycles(motorcycles),
      m_node_of_crossing(chords.number_of_crossings(), -1),
      m_halfedge_of_point(chords.order().number_of_points(), -1)
  {
    m_result.surface_pointer = std::move(surface);
  }

  T_mesh operator()()
  {
    make_start_nodes();
    make_crossing_nodes();
    m_result.corner_arcs.resize(surface().number_of_halfedges());
    for (int t = 0; t < int(m_motorcycles.traces().size()); ++t)
      make_arcs(t);
    connect();
    number_patches();
    collect_edge_crossings();
    return std::move(m_result);
  }

private:
  // The halfedges that leave a node, counter-clockwise; each comes `quarter_turns` after the one
  // before it.
  struct Outgoing
  {
    int halfedge;
    int quarter_turns;
  };

  void make_start_nodes()
  {
    const auto& traces = m_motorcycles.traces();
    for (const auto& t : traces) {
      if (m_result.node_surface_vertex.empty() || m_result.node_surface_vertex.back() != t.vertex)
        make_node(surface().point(t.vertex), t.vertex, 4);
      m_result.node_index.back() -= 1;
      m_result.traces.push_back({m_result.number_of_vertices() - 1, {}});
    }
  }

  // The visit of the longer trace comes second.
  void make_crossing_nodes()
  {
    for (int x = 0; x < m_chords.number_of_crossings(); ++x)
      if (m_chords.crossing(x).confirmed) {
        m_node_of_crossing[x] = m_result.number_of_vertices();
        make_node(m_chords.point(m_chords.crossing(x)), -1, 0);
        m_result.node_visits.back().assign(2, {-1, -1});
        m_around.push_back({-1, -1, -1, -1});
      }
    m_first_crossing_node = m_result.number_of_vertices() - int(m_around.size());
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
    m_result.corner_arcs[trace.corner].push_back(2 * m_result.number_of_edges());
    begin_arc(t, m_result.traces[t].start);
    double length = 0;
    for (int c : trace.chords) {
      const auto& chord = m_chords.chord(c);
      if (chord.from.point >= 0) {
        m_halfedge_of_point[chord.from.point] = halfedge_towards_source(chord.from);
        m_result.arc_crossings.back().push_back({chord.from.halfedge, chord.from.point});
      }
      for (int x : chord.crossings) {
        if (!m_chords.crossing(x).confirmed)
          continue;
        const double here = m_chords.crossing(x).length[m_chords.side(x, c)];
        end_arc(t, x, c, here - length);
        if (c == trace.last_chord && x == trace.last_crossing)
          return;
        begin_arc(t, m_node_of_crossing[x]);
        around(x)[quarter_turns(x, c)] = m_result.number_of_halfedges() - 2;
        length = here;
      }
    }
    CGAL_assertion_msg(false, "a trace has not stopped");
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
    m_result.halfedge_target.insert(m_result.halfedge_target.end(), {-1, node});
  }

  void end_arc(int t, int x, int c, double length)
  {
    const int node = m_node_of_crossing[x], forward = m_result.number_of_halfedges() - 2;
    m_result.halfedge_target[forward] = node;
    m_result.arc_length.push_back(length);
    around(x)[(quarter_turns(x, c) + 2) & 3] = forward + 1;
    const bool is_later = m_motorcycles.later_side(x) == m_chords.side(x, c);
    m_result.node_visits[node][is_later ? 1 : 0] = {t, int(m_result.traces[t].arcs.size())};
  }

  // the halfedges that leave the node of crossing x, by quarter-turns from the direction of its
  // first chord
  std::array<int, 4>& around(int x)
  {
    return m_around[m_node_of_crossing[x] - m_first_crossing_node];
  }
  int quarter_turns(int x, int c) const
  {
    const int first = m_chords.crossing(x).chord[0];
    return c == first ? 0 : m_chords.quarter_turns(x, first);
  }

  void connect()
  {
    m_result.halfedge_next.assign(m_result.number_of_halfedges(), -1);
    m_result.halfedge_is_corner.assign(m_result.number_of_halfedges(), 0);
    std::vector<std::vector<Outgoing>> leaving(m_first_crossing_node);
    for (const T_mesh::Trace& t : m_result.traces)
      leaving[t.start].push_back({2 * t.arcs.front(), 1});
    for (int n = 0; n < m_first_crossing_node; ++n)
      connect_around(n, leaving[n]);
    for (int i = 0; i < int(m_around.size()); ++i)
      connect_around(m_first_crossing_node + i, outgoing(m_around[i]));
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
      if (m_result.halfedge_face[h] >= 0)
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
        }
    for (auto& crossings : m_result.arc_crossings)
      for (T_mesh::Crossing& c : crossings)
        c.position = position_of_point[c.position];
  }

  const Surface& surface() const { return *m_result.surface_pointer; }

  const Chords& m_chords;
  const Motorcycles& m_motorcycles;
  std::vector<int> m_node_of_crossing;
  std::vector<int> m_halfedge_of_point;
  std::vector<std::array<int, 4>> m_around;   // per crossing node
  int m_first_crossing_node = 0;
  T_mesh m_result;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_T_MESH_ASSEMBLY_H
