// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_OVERLAY_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_OVERLAY_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <CGAL/assertions.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The common refinement of a surface and a T-mesh on it, as a triangle mesh: every arc is a path of
// edges, and every triangle lies in one triangle of the surface and in one patch.
//
// Only the order of crossings along edges and of edges around vertices is used: the pieces are the
// faces of that rotation system, without those outside of the border. Pieces with more than three
// sides get a vertex inside.
class Overlay
{
public:
  // a place on the boundary of a patch: on a halfedge of the T-mesh, seen from its left, behind
  // some of the pieces into which the surface divides that; `halfedge` is -1 inside of patches
  struct Place
  {
    int halfedge = -1;
    int pieces_before = 0, pieces = 1;
  };

  explicit Overlay(const T_mesh& t_mesh) : m_t_mesh(t_mesh), m_surface(t_mesh.surface())
  {
    number_vertices();
    number_halves();
    order_around_crossings();
    order_around_nodes();
    order_around_surface_vertices();
    place_on_arcs_along_edges();
    for (int v = 0; v < int(m_outgoing.size()); ++v)
      for (int i = 0; i < int(m_outgoing[v].size()); ++i) {
        m_half[m_outgoing[v][i]].source = v;
        m_half[m_outgoing[v][i]].slot = i;
      }
    find_pieces();
    spread_patches();
    triangulate();
  }

  std::vector<Point> points; // those of the surface first
  std::vector<std::array<int, 3>> triangles;
  // per halfedge of the triangles
  std::vector<int> arc_halfedge; // of the T-mesh that it runs along, or -1
  std::vector<char> is_original; // whether it is part of an edge of the surface
  std::vector<char> is_fixed;    // whether it is part of a fixed edge
  std::vector<Place> place;      // of the corner at its source
  std::vector<int> patch;        // per triangle

private:
  // a directed piece of an edge or an arc; that in the other direction has the number that differs
  // in the last bit
  struct Half
  {
    int source = -1, slot = -1, arc_halfedge = -1, piece = -1;
    bool is_original = false;
    Place place; // of the corner on its left at its source
  };

  void number_vertices()
  {
    points = m_surface.points();
    for (int e = 0; e < m_surface.number_of_edges(); ++e) {
      const int h = m_surface.halfedge_of_edge(e);
      m_first_crossing.push_back(int(points.size()));
      for (const double t : m_t_mesh.crossing_parameters[e])
        points.push_back((1 - t) * m_surface.point(m_surface.source(h)) +
                         t * m_surface.point(m_surface.target(h)));
    }
    m_node_vertex = m_t_mesh.node_surface_vertex;
    for (int e = 0; e < m_surface.number_of_edges(); ++e)
      for (int i = 0; i < number_of_crossings(e) && !m_t_mesh.edge_arcs[e].empty(); ++i)
        m_node_vertex[m_t_mesh.target(m_t_mesh.edge_arcs[e][i])] = m_first_crossing[e] + i;
    for (int n = 0; n < m_t_mesh.number_of_vertices(); ++n) {
      if (m_node_vertex[n] < 0) {
        m_node_vertex[n] = int(points.size());
        points.push_back(m_t_mesh.point(n));
      }
    }
    m_outgoing.resize(points.size());
  }

  // arcs that cross an edge, or end on it
  int number_of_crossings(int e) const { return int(m_t_mesh.crossing_parameters[e].size()); }
  // of an arc that does not run along edges
  int number_of_pieces(int arc) const { return int(m_t_mesh.arc_crossings[arc].size()) + 1; }
  bool runs_along_edges(int arc) const { return !m_halves_along[arc].empty(); }

  void number_halves()
  {
    int n = 0;
    for (int e = 0; e < m_surface.number_of_edges(); ++e) {
      m_first_of_edge.push_back(n);
      n += 2 * (number_of_crossings(e) + 1);
    }
    const int number_of_originals = n;
    find_halves_along_arcs();
    for (int a = 0; a < m_t_mesh.number_of_edges(); ++a) {
      m_first_of_arc.push_back(n);
      n += runs_along_edges(a) ? 0 : 2 * number_of_pieces(a);
    }
    m_half.resize(n);
    for (int h = 0; h < number_of_originals; ++h)
      m_half[h].is_original = true;
    for (int a = 0; a < m_t_mesh.number_of_edges(); ++a) {
      for (int i = 0; i < 2 * number_of_pieces(a) && !runs_along_edges(a); ++i)
        m_half[m_first_of_arc[a] + i].arc_halfedge = 2 * a + i % 2;
      for (const int h : m_halves_along[a]) {
        m_half[h].arc_halfedge = 2 * a;
        m_half[h ^ 1].arc_halfedge = 2 * a + 1;
      }
    }
  }

  void find_halves_along_arcs()
  {
    m_halves_along.resize(m_t_mesh.number_of_edges());
    for (int a = 0; a < int(m_t_mesh.arc_pieces.size()); ++a)
      for (const T_mesh::Crossing& piece : m_t_mesh.arc_pieces[a]) {
        const int e = m_surface.edge(piece.halfedge);
        const bool is_canonical = m_surface.halfedge_of_edge(e) == piece.halfedge;
        m_halves_along[a].push_back(m_first_of_edge[e] + 2 * piece.position + !is_canonical);
      }
  }

  // the first piece of a halfedge of the surface
  int first_half(int h) const
  {
    const int e = m_surface.edge(h);
    return m_surface.halfedge_of_edge(e) == h ? m_first_of_edge[e]
                                              : m_first_of_edge[e] + 2 * number_of_crossings(e) + 1;
  }
  // the first piece of a halfedge of the T-mesh
  int first_half_of_arc(int h) const
  {
    if (runs_along_edges(h / 2))
      return h % 2 == 0 ? m_halves_along[h / 2].front() : m_halves_along[h / 2].back() ^ 1;
    return h % 2 == 0 ? m_first_of_arc[h / 2]
                      : m_first_of_arc[h / 2] + 2 * number_of_pieces(h / 2) - 1;
  }

  void order_around_crossings()
  {
    for (int a = 0; a < m_t_mesh.number_of_edges(); ++a)
      for (int i = 0; i + 1 < number_of_pieces(a); ++i)
        order_around_crossing(a, i);
  }

  void order_around_crossing(int a, int i)
  {
    const T_mesh::Crossing& c = m_t_mesh.arc_crossings[a][i];
    const int e = m_surface.edge(c.halfedge), along = m_first_of_edge[e] + 2 * c.position;
    const int forward = m_first_of_arc[a] + 2 * (i + 1), backward = m_first_of_arc[a] + 2 * i + 1;
    const bool enters_left = m_surface.halfedge_of_edge(e) == c.halfedge;
    const int left = enters_left ? forward : backward, right = enters_left ? backward : forward;
    m_outgoing[m_first_crossing[e] + c.position] = {along + 2, left, along + 1, right};
    const int n = number_of_pieces(a);
    const Place ahead{2 * a, i + 1, n}, behind{2 * a + 1, n - i - 1, n};
    const Place left_of_left = enters_left ? ahead : behind;
    const Place right_of_left = enters_left ? behind : ahead;
    CGAL_assertion(left_of_left.halfedge == m_t_mesh.edge_crossings[e][c.position]);
    m_half[along + 2].place = m_half[right].place = right_of_left;
    m_half[left].place = m_half[along + 1].place = left_of_left;
  }

  void order_around_nodes()
  {
    for (int n = 0; n < m_t_mesh.number_of_vertices(); ++n) {
      if (m_t_mesh.surface_vertex(n) >= 0)
        continue;
      const int first = m_t_mesh.halfedge_from(n);
      int h = first;
      do {
        leave_along_arc(m_node_vertex[n], h);
        h = m_t_mesh.turn_left(h);
      } while (h != first);
    }
  }

  void leave_along_arc(int v, int h)
  {
    m_outgoing[v].push_back(first_half_of_arc(h));
    m_half[first_half_of_arc(h)].place = {h};
  }

  void order_around_surface_vertices()
  {
    for (int v = 0; v < m_surface.number_of_vertices(); ++v) {
      int last_arc = -1;
      m_surface.for_each_outgoing(v, [&](int h) {
        if (arc_from(h) >= 0)
          last_arc = arc_from(h);
        if (!m_t_mesh.corner_arcs[h].empty())
          last_arc = m_t_mesh.corner_arcs[h].back();
      });
      m_surface.for_each_outgoing(v, [&](int h) {
        if (arc_from(h) >= 0)
          last_arc = arc_from(h);
        m_outgoing[v].push_back(first_half(h));
        m_half[first_half(h)].place = {last_arc};
        for (const int arc : m_t_mesh.corner_arcs[h]) {
          leave_along_arc(v, arc);
          last_arc = arc;
        }
      });
      if (m_surface.is_on_border(v)) {
        const int e = m_surface.edge(m_surface.border_halfedge_to(v));
        m_outgoing[v].push_back(m_first_of_edge[e] + 2 * number_of_crossings(e) + 1);
      }
    }
  }

  // the halfedge of the arc that begins with halfedge h of the surface, -1 if there is none
  int arc_from(int h) const
  {
    const int half = first_half(h), arc = m_half[half].arc_halfedge;
    return arc >= 0 && first_half_of_arc(arc) == half ? arc : -1;
  }

  // of the vertices of the surface that lie inside of arcs
  void place_on_arcs_along_edges()
  {
    for (int a = 0; a < m_t_mesh.number_of_edges(); ++a) {
      const int n = int(m_halves_along[a].size());
      for (int i = 1; i < n; ++i)
        m_half[m_halves_along[a][i]].place = {2 * a, i, n};
    }
  }

  // pieces lie on the left: what arrives goes on along the next one clockwise
  int next(int half) const
  {
    const Half& twin = m_half[half ^ 1];
    const std::vector<int>& around = m_outgoing[twin.source];
    return around[(twin.slot + around.size() - 1) % around.size()];
  }

  void find_pieces()
  {
    for (int first = 0; first < int(m_half.size()); ++first) {
      if (m_half[first].piece >= 0)
        continue;
      for (int h = first; m_half[h].piece < 0; h = next(h))
        m_half[h].piece = int(m_first_half.size());
      m_first_half.push_back(first);
    }
  }

  template <class Action>
  void for_each_half(int piece, Action&& action) const
  {
    int h = m_first_half[piece];
    do {
      action(h);
      h = next(h);
    } while (h != m_first_half[piece]);
  }

  // Pieces beside an arc know their patch; the others have that of their neighbours.
  void spread_patches()
  {
    m_patch.assign(m_first_half.size(), -1);
    std::vector<int> stack;
    const auto set_patch = [&](int piece, int patch) {
      CGAL_assertion(m_patch[piece] < 0 || m_patch[piece] == patch);
      if (m_patch[piece] < 0)
        stack.push_back(piece);
      m_patch[piece] = patch;
    };
    for (const Half& h : m_half)
      if (h.place.halfedge >= 0)
        set_patch(h.piece, m_t_mesh.face(h.place.halfedge));
    while (!stack.empty()) {
      const int piece = stack.back();
      stack.pop_back();
      for_each_half(piece, [&](int h) {
        if (m_half[h].arc_halfedge < 0)
          set_patch(m_half[h ^ 1].piece, m_patch[piece]);
      });
    }
  }

  void triangulate()
  {
    std::vector<char> is_outside(m_first_half.size(), 0);
    for (int e = 0; e < m_surface.number_of_edges(); ++e)
      if (m_surface.is_border(m_surface.halfedge_of_edge(e)))
        is_outside[m_half[m_first_of_edge[e] + 1].piece] = 1;
    for (int p = 0; p < int(m_first_half.size()); ++p) {
      if (is_outside[p])
        continue;
      std::vector<int> halves;
      for_each_half(p, [&](int h) { halves.push_back(h); });
      if (halves.size() == 3)
        add_triangle(halves);
      else
        add_star(halves);
      patch.resize(triangles.size(), m_patch[p]);
    }
  }

  void add_corner(const Half& half)
  {
    triangles.back()[arc_halfedge.size() % 3] = half.source;
    arc_halfedge.push_back(half.arc_halfedge);
    is_original.push_back(half.is_original);
    is_fixed.push_back(half.is_original && half.arc_halfedge >= 0);
    place.push_back(half.place);
  }

  void add_triangle(const std::vector<int>& halves)
  {
    triangles.emplace_back();
    for (const int h : halves)
      add_corner(m_half[h]);
  }

  void add_star(const std::vector<int>& halves)
  {
    Half center;
    center.source = int(points.size());
    Point sum(0, 0, 0);
    for (const int h : halves)
      sum += points[m_half[h].source];
    points.push_back(sum / double(halves.size()));
    for (const int h : halves) {
      Half spoke = m_half[next(h)];
      spoke.arc_halfedge = -1;
      spoke.is_original = false;
      triangles.emplace_back();
      add_corner(m_half[h]);
      add_corner(spoke);
      add_corner(center);
    }
  }

  const T_mesh& m_t_mesh;
  const Triangle_surface& m_surface;
  std::vector<int> m_first_crossing, m_node_vertex, m_first_of_edge, m_first_of_arc;
  std::vector<std::vector<int>> m_halves_along; // per arc that runs along edges, in its direction
  std::vector<std::vector<int>> m_outgoing;     // per vertex, counter-clockwise
  std::vector<Half> m_half;
  std::vector<int> m_first_half, m_patch; // per piece
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_OVERLAY_H
