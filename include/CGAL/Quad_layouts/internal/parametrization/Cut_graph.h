// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_CUT_GRAPH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_CUT_GRAPH_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/internal/right_angle.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A graph of edges along which a surface is cut open to discs, and a chart for each face: a
// coordinate system whose x-axis is one of the directions of the field. Charts of adjacent faces
// turn into each other without any quarter-turn, unless their edge is cut (Bommes, Zimmer and
// Kobbelt 2009). All cones, which are the singularities, lie on the graph, and its other ends are
// on the border.
class Cut_graph
{
public:
  explicit Cut_graph(const Cross_field& field)
    : m_field(field), m_surface(field.surface()), m_turn(m_surface.number_of_faces(), 0),
      m_is_cut(m_surface.number_of_edges(), 1)
  {
    grow_discs();
    remove_dead_ends();
  }

  // says of a halfedge if its edge is cut; those on the border are
  bool is_cut(int h) const { return m_is_cut[m_surface.edge(h)] != 0; }

  // the number of the direction of the field that is the x-axis in the chart of face f
  int x_axis(int f) const { return m_turn[f]; }
  // the angle of the x-axis in the frame of face f
  double x_angle(int f) const { return m_field.angle(f) + m_turn[f] * right_angle; }

  // by how many quarter-turns, 0 to 3, the chart of the face behind h turns what it takes over from
  // the chart of the face of h
  int quarter_turns(int h) const
  {
    const int f = m_surface.face(h), g = m_surface.face(m_surface.opposite(h));
    return (m_field.matching(h) + m_turn[f] - m_turn[g]) & 3;
  }

  // the first faces of the components of the surface
  const std::vector<int>& first_faces() const { return m_first_faces; }

private:
  // unfolds the faces along a spanning forest of the dual graph
  void grow_discs()
  {
    std::vector<char> is_reached(m_surface.number_of_faces(), 0);
    std::vector<int> reached;
    for (int first = 0; first < m_surface.number_of_faces(); ++first) {
      if (is_reached[first])
        continue;
      m_first_faces.push_back(first);
      is_reached[first] = 1;
      reached.assign(1, first);
      for (std::size_t i = 0; i < reached.size(); ++i)
        for (int h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h) {
          if (m_surface.is_border(h))
            continue;
          const int g = m_surface.face(m_surface.opposite(h));
          if (is_reached[g])
            continue;
          m_turn[g] = (m_field.matching(h) + m_turn[reached[i]]) & 3;
          m_is_cut[m_surface.edge(h)] = 0;
          is_reached[g] = 1;
          reached.push_back(g);
        }
    }
  }

  // Sews up what ends in a regular vertex inside: the quarter-turns of all edges around such a
  // vertex cancel, so that the last one has none.
  void remove_dead_ends()
  {
    std::vector<int> degree(m_surface.number_of_vertices(), 0), ends;
    for (int h = 0; h < m_surface.number_of_halfedges(); ++h)
      if (is_cut(h) && (m_surface.is_border(h) || h < m_surface.opposite(h))) {
        ++degree[m_surface.source(h)];
        ++degree[m_surface.target(h)];
      }
    for (int v = 0; v < m_surface.number_of_vertices(); ++v)
      if (is_dead_end(v, degree))
        ends.push_back(v);
    while (!ends.empty()) {
      const int v = ends.back();
      ends.pop_back();
      if (!is_dead_end(v, degree))
        continue;
      m_surface.for_each_outgoing(v, [&](int h) {
        if (!is_cut(h))
          return;
        m_is_cut[m_surface.edge(h)] = 0;
        --degree[v];
        if (--degree[m_surface.target(h)] == 1)
          ends.push_back(m_surface.target(h));
      });
    }
  }

  bool is_dead_end(int v, const std::vector<int>& degree) const
  {
    return degree[v] == 1 && !m_surface.is_on_border(v) && m_field.index(v) % 4 == 0;
  }

  const Cross_field& m_field;
  const Triangle_surface& m_surface;
  std::vector<int> m_turn, m_first_faces;
  std::vector<char> m_is_cut;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_CUT_GRAPH_H
