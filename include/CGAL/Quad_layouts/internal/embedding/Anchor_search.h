// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_ANCHOR_SEARCH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_ANCHOR_SEARCH_H

#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_Line_tracer.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_starts.h>

#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Finds which layout edge begins in which direction at the cones of a map.
//
// At the first cone of a component any of the valence many assignments might be right. One that is
// leads along every layout edge to the place where the layout says it ends, and so finds the
// assignments at all other cones; a wrong one soon ends somewhere else. Where the layout is
// symmetric it might not: then it leaves the fixed edges, along which those of the layout must run.
// So what is found is also proven: the layout is embedded.
class Anchor_search
{
public:
  // a surface vertex and the layout vertex that it is
  struct Cone_place
  {
    int surface_vertex, layout_vertex;
  };

  Anchor_search(const Integer_grid_map& map, const Quad_layout& layout,
                const std::vector<Cone_place>& cones)
    : m_map(map), m_layout(layout), m_lines(map), m_cone_at(layout.number_of_vertices(), -1),
      m_start(layout.number_of_halfedges())
  {
    for (const Cone_place& c : cones)
      m_cone_at[c.layout_vertex] = c.surface_vertex;
    for (const Cone_place& c : cones)
      if (!m_start[layout.halfedge_from(c.layout_vertex)].is_valid() && !anchor_component(c))
        return;
    for (const Cone_place& c : cones)
      add_anchors(c);
  }

  // one per layout halfedge that begins at a cone; none if there is a component in which no
  // assignment is consistent
  const std::vector<Integer_grid_map::Anchor>& anchors() const { return m_anchors; }

private:
  bool anchor_component(const Cone_place& cone)
  {
    const int corner = m_map.surface().halfedge(cone.surface_vertex);
    if (m_layout.is_on_border(cone.layout_vertex))
      return is_consistent(cone.layout_vertex,
                           {Triangle_surface::face(corner), m_map.coordinates(corner), 0});
    Map_heading heading = some_heading(corner);
    for (int k = 0; k < m_layout.valence(cone.layout_vertex); ++k) {
      if (heading.is_valid() && is_consistent(cone.layout_vertex, heading))
        return true;
      heading = m_lines.entered(heading.turned(1));
    }
    return false;
  }

  // a direction that leaves through a face at the source of `corner`; less than four quarter-turns
  // may be all there are
  Map_heading some_heading(int corner) const
  {
    Map_heading heading;
    for (int d = 0; d < 4 && !heading.is_valid(); ++d)
      heading = m_lines.entered({Triangle_surface::face(corner), m_map.coordinates(corner), d});
    return heading;
  }

  // tries `heading` for the first halfedge of v, or, on the border, whatever is there; undoes
  // everything if some edge does not arrive where it should
  bool is_consistent(int v, const Map_heading& heading)
  {
    std::vector<int> reached;
    std::queue<int> queue;
    bool good = set_starts(m_layout.halfedge_from(v), heading, reached, queue);
    while (good && !queue.empty()) {
      const int h = queue.front();
      queue.pop();
      good = follow(h, reached, queue);
    }
    if (!good)
      for (const int h : reached)
        m_start[h] = {};
    return good;
  }

  // sets the starts of all halfedges around the source of h, `heading` being that of h, or a place
  // on the border
  bool set_starts(int h, const Map_heading& heading, std::vector<int>& reached,
                  std::queue<int>& queue)
  {
    const auto note = [&](int g) {
      reached.push_back(g);
      queue.push(g);
    };
    const int v = m_layout.source(h);
    return m_layout.is_on_border(v)
               ? set_starts_on_border(m_lines, m_layout, v, heading, m_start, note)
               : set_starts_inside(m_lines, m_layout, h, heading, m_start, note);
  }

  bool follow(int h, std::vector<int>& reached, std::queue<int>& queue)
  {
    const double length = m_map.chord_length[m_layout.chord(Quad_layout::edge(h))];
    const std::vector<Map_heading> stops = m_lines.follow(m_start[h], {length});
    if (stops.empty() || !is_at(stops.back(), m_layout.target(h)) ||
        (m_layout.is_fixed(Quad_layout::edge(h)) && !m_lines.is_fixed(m_start[h], length)))
      return false;
    const int twin = Quad_layout::opposite(h);
    if (m_layout.is_on_border(m_layout.target(h)))
      return arrives_on_border(twin, stops.back(), reached, queue);
    const Map_heading back = m_lines.entered(stops.back().turned(2));
    return m_start[twin].is_valid() ? back == m_start[twin]
                                    : set_starts(twin, back, reached, queue);
  }

  bool arrives_on_border(int twin, const Map_heading& end, std::vector<int>& reached,
                         std::queue<int>& queue)
  {
    const int first = m_layout.halfedge_from(m_layout.source(twin));
    if (!m_start[first].is_valid() && !set_starts(first, end, reached, queue))
      return false;
    return m_lines.along_border(end) == m_start[first] &&
           (m_layout.is_border(twin) || m_lines.entered(end.turned(2)) == m_start[twin]);
  }

  // whether a cone, if that is what layout vertex v is, lies where a line has arrived
  bool is_at(const Map_heading& place, int v) const
  {
    if (m_cone_at[v] < 0)
      return true;
    for (int h = 3 * place.face; h < 3 * place.face + 3; ++h)
      if (m_map.surface().source(h) == m_cone_at[v] && m_map.coordinates(h) == place.position)
        return true;
    return false;
  }

  void add_anchors(const Cone_place& cone)
  {
    const int first = m_layout.halfedge_from(cone.layout_vertex);
    int h = first;
    do {
      if (m_layout.is_border(h))
        break;
      int corner = 3 * m_start[h].face;
      while (m_map.surface().source(corner) != cone.surface_vertex)
        ++corner;
      m_anchors.push_back({corner, m_start[h].direction, h});
      h = m_layout.turn_left(h);
    } while (h != first);
  }

  const Integer_grid_map& m_map;
  const Quad_layout& m_layout;
  Line_tracer m_lines;
  std::vector<int> m_cone_at;       // per layout vertex its surface vertex, -1 if it is not a cone
  std::vector<Map_heading> m_start; // per layout halfedge
  std::vector<Integer_grid_map::Anchor> m_anchors;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_ANCHOR_SEARCH_H
