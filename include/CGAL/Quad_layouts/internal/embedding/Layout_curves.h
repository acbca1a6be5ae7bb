// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_CURVES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_CURVES_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/embedding/Embedded_layout.h>
#include <CGAL/Quad_layouts/internal/embedding/Grid_lines.h>
#include <CGAL/Quad_layouts/internal/embedding/Overlay_reduction.h>
#include <CGAL/Quad_layouts/internal/embedding/Quantized_overlay.h>
#include <CGAL/Quad_layouts/internal/embedding/preimages.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Embeds a layout: chooses a vertex of the mesh for each vertex of the layout and a path of edges
// for each of its edges, such that no two meet elsewhere.
//
// Away from the preimages of the layout vertices, a layout edge follows one of the arcs that are
// mapped to it. The preimage of a layout vertex has a neighbourhood that is a disc: inside, the
// edges go to one vertex in the middle, which is on a fixed curve if there is one in the disc; then
// the edges on fixed curves come first and stay there. That is always possible, because paths to a
// common point never separate a disc into parts that are out of its reach, as long as the mesh has
// room beside them: which splits make where it has not.
class Layout_curves
{
public:
  Layout_curves(const T_mesh& t_mesh, const Quad_layout& layout, const Monitor& monitor)
    : m_t_mesh(t_mesh), m_layout(layout)
  {
    Quantized_overlay overlay(t_mesh, layout);
    Grid_lines(overlay, monitor);
    m_owner = preimages(overlay);
    separate_preimages(overlay);
    choose_vertices(overlay.mesh());
    std::vector<int> curves = chosen_curves(overlay);
    m_mesh = overlay.release_mesh();
    m_mesh.curve = std::move(curves);
    reduce(monitor);
    place_discs();
    make_rims();
    find_exits();
    for (int v = 0; v < layout.number_of_vertices(); ++v) {
      if (v % 256 == 0)
        monitor.check("embed");
      connect(v);
    }
    separate_curves();
  }

  // to be called once
  Embedded_layout result() { return {std::move(m_mesh), std::move(m_vertex)}; }

private:
  // of a vertex of the mesh: in the disc around a preimage, on the boundary of that disc, or on a
  // path in it
  enum Place : char { OUTSIDE, INSIDE, RIM, PATH };

  // A cone must be where the layout vertex is irregular; preferred is one whose index comes closest
  // to the layout vertex's, because there is room for its quads. Those of the layout on fixed
  // curves must be on these, and where curves meet, if there is such a place.
  void choose_vertices(const Curve_mesh& mesh)
  {
    m_vertex.assign(m_layout.number_of_vertices(), -1);
    for (int v = int(m_owner.size()) - 1; v >= 0; --v)
      if (m_owner[v] >= 0 && (!m_layout.is_on_fixed_curve(m_owner[v]) || mesh.is_on_fixed_curve(v)))
        m_vertex[m_owner[v]] = v;
    for (const Quad_layout::Cluster& c : m_layout.clusters) {
      const auto rank = [&](int n) {
        const int fixed = m_t_mesh.number_of_fixed_arcs(n), index = m_t_mesh.index(n);
        const bool is_on_curve = fixed > 0, is_meeting = is_on_curve && fixed != 2;
        return std::make_tuple(is_on_curve, is_meeting, index != 0 || c.index == 0,
                               -std::abs(index - c.index));
      };
      const int node = *std::max_element(c.nodes.begin(), c.nodes.end(),
                                         [&](int m, int n) { return rank(m) < rank(n); });
      if (m_t_mesh.is_on_fixed_curve(node) == m_layout.is_on_fixed_curve(c.vertex))
        m_vertex[c.vertex] = m_t_mesh.surface_vertex(node);
    }
  }

  bool is_fixed(int layout_halfedge) const
  {
    return m_layout.is_fixed(Quad_layout::edge(layout_halfedge));
  }

  // Per halfedge of the mesh the layout halfedge whose curve it is to be part of, or -1. Of all
  // arcs that are mapped to a layout edge, the longest is chosen, or the fixed one.
  std::vector<int> chosen_curves(const Quantized_overlay& overlay) const
  {
    using Unit = std::pair<int, int>; // arc, number along the arc
    std::vector<std::pair<double, Unit>> longest(m_layout.number_of_edges(), {-1, {-1, -1}});
    for (int a = 0; a < m_t_mesh.number_of_edges(); ++a) {
      const std::vector<int>& path = m_layout.arc_halfedges[a];
      for (int i = 0; i < int(path.size()); ++i) {
        auto& unit = longest[path[i] / 2];
        const double length = m_t_mesh.is_fixed(a) ? (std::numeric_limits<double>::infinity)()
                                                   : m_t_mesh.length(a) / double(path.size());
        unit = (std::max)(unit, {length, {a, i}});
      }
    }
    std::vector<int> result(overlay.mesh().number_of_halfedges(), -1);
    for (int h = 0; h < int(result.size()); ++h)
      if (const int l = overlay.layout_halfedge(h);
          l >= 0 && (!overlay.is_arc(h) || overlay.unit(h) == longest[l / 2].second))
        result[h] = l;
    return result;
  }

  int split(int h, Place place, int owner)
  {
    m_owner.push_back(owner);
    m_place.push_back(place);
    return m_mesh.split(h);
  }

  // Splits the edges between vertices of preimages that are no parts of preimages themselves. What
  // comes from a split is not split again.
  void separate_preimages(Quantized_overlay& overlay)
  {
    const Curve_mesh& mesh = overlay.mesh();
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
      if (m_owner[mesh.source(h)] >= 0 && m_owner[mesh.target(h)] >= 0 &&
          !overlay.is_contracted(h) && !overlay.is_contracted(mesh.opposite(h))) {
        overlay.split(h);
        m_owner.push_back(-1);
      }
  }

  // takes away what the curves do not need, before they get more company; preimages stay apart
  void reduce(const Monitor& monitor)
  {
    reduce_overlay(m_mesh, m_t_mesh.surface().number_of_vertices(), m_vertex, m_owner, monitor);
    const std::vector<int> number = m_mesh.compact();
    for (int v = 0; v < int(number.size()); ++v)
      if (number[v] >= 0)
        m_owner[number[v]] = m_owner[v];
    m_owner.resize(m_mesh.points.size());
    for (int& v : m_vertex)
      v = number[v];
  }

  void place_discs()
  {
    for (const int owner : m_owner)
      m_place.push_back(owner >= 0 ? INSIDE : OUTSIDE);
  }

  bool is_inside(int v) const { return m_place[v] == INSIDE; }

  // splits the edges that leave preimages
  void make_rims()
  {
    const int n = int(m_place.size());
    for (int v = 0; v < n; ++v)
      if (is_inside(v))
        for (int h = leaving(v); h >= 0; h = leaving(v))
          split(h, RIM, m_owner[v]);
  }

  int leaving(int v) const
  {
    for (const int h : m_mesh.outgoing(v))
      if (m_owner[m_mesh.target(h)] != m_owner[v])
        return h;
    return -1;
  }

  // takes the curves out of the discs, and notes where on the rims they begin
  void find_exits()
  {
    m_exit.assign(m_layout.number_of_halfedges(), -1);
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.curve[h] >= 0 && is_inside(m_mesh.source(h))) {
        m_exit[m_mesh.curve[h]] = m_mesh.target(h);
        m_mesh.curve[m_mesh.opposite(h)] = m_mesh.curve[h] = -1;
      }
  }

  // leads all layout edges at layout vertex v from the rim to the middle
  void connect(int v)
  {
    m_place[m_vertex[v]] = PATH;
    m_without_room = {m_vertex[v]};
    const int first = m_layout.halfedge_from(v);
    const auto for_each_edge = [&](const auto& action) {
      int l = first;
      do {
        action(l);
        l = m_layout.turn_left(l);
      } while (l != first);
    };
    for (const bool fixed : {true, false})
      for_each_edge([&](int l) {
        if (is_fixed(l) == fixed)
          connect(v, l);
      });
  }

  // leads layout halfedge l, which begins at v, from the rim to the middle
  void connect(int v, int l)
  {
    std::vector<int> path = path_to(v, l);
    if (path.empty()) {
      make_room();
      path = path_to(v, l);
    }
    if (path.empty())
      throw Stage_failure("embed: layout vertex " + std::to_string(v) + " cannot be connected");
    for (const int h : path) {
      m_mesh.curve[h] = l;
      m_mesh.curve[m_mesh.opposite(h)] = l ^ 1;
      m_without_room.push_back(m_mesh.target(h));
      m_place[m_mesh.target(h)] = PATH;
    }
  }

  // the halfedges of a shortest path from the middle to where l begins on the rim, through free
  // vertices of the disc; along fixed edges if l is fixed. Empty if there is none.
  std::vector<int> path_to(int v, int l)
  {
    const int from = m_vertex[v], to = m_exit[l];
    if (to < 0)
      return {};
    m_reached_by.resize(m_place.size(), -1);
    std::vector<int> queue{from}, path;
    for (std::size_t i = 0; i < queue.size() && m_reached_by[to] < 0; ++i)
      for (const int h : m_mesh.outgoing(queue[i]))
        if (const int w = m_mesh.target(h); m_reached_by[w] < 0 &&
                                            (w == to || (is_inside(w) && m_owner[w] == v)) &&
                                            (!is_fixed(l) || m_mesh.is_fixed[h])) {
          m_reached_by[w] = h;
          queue.push_back(w);
        }
    if (m_reached_by[to] >= 0)
      for (int w = to; w != from; w = m_mesh.source(path.back()))
        path.push_back(m_reached_by[w]);
    std::reverse(path.begin(), path.end());
    for (const int w : queue)
      m_reached_by[w] = -1;
    return path;
  }

  // splits all edges of the disc that end on paths which have no room yet: then there is a way
  // along both their sides
  void make_room()
  {
    for (const int v : std::exchange(m_without_room, {}))
      for (const int h : m_mesh.outgoing(v)) {
        const int w = m_mesh.target(h);
        const bool is_in_disc = m_owner[w] == m_owner[v] && !(is_on_rim(v) && is_on_rim(w));
        if (m_mesh.curve[h] < 0 && is_in_disc)
          split(h, INSIDE, m_owner[v]);
      }
  }

  bool is_on_rim(int v) const
  {
    if (m_place[v] == RIM)
      return true;
    for (const int h : m_mesh.outgoing(v))
      if (m_owner[m_mesh.target(h)] != m_owner[v])
        return true;
    return false;
  }

  // splits edges that join two points of curves: no triangle shall have only such corners
  void separate_curves()
  {
    std::vector<char> on_curve(m_mesh.points.size(), 0);
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.curve[h] >= 0)
        on_curve[m_mesh.source(h)] = 1;
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.curve[h] < 0 && on_curve[m_mesh.source(h)] && on_curve[m_mesh.target(h)]) {
        split(h, OUTSIDE, -1);
        on_curve.push_back(0);
      }
  }

  const T_mesh& m_t_mesh;
  const Quad_layout& m_layout;
  Curve_mesh m_mesh{Triangle_surface()};
  std::vector<int> m_owner;        // per vertex of the mesh the layout vertex in whose disc it is
  std::vector<Place> m_place;      // per vertex of the mesh
  std::vector<int> m_vertex;       // per layout vertex
  std::vector<int> m_exit;         // per layout halfedge
  std::vector<int> m_without_room; // vertices on paths in the present disc
  std::vector<int> m_reached_by;   // scratch of `path_to`
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_CURVES_H
