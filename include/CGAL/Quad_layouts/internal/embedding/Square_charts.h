// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SQUARE_CHARTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SQUARE_CHARTS_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/embedding/Embedded_layout.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// One chart per face of a layout: its first side begins at the origin and runs along +x.
class Layout_squares
{
public:
  Layout_squares(const Quad_layout& layout, const std::vector<int>& chord_length)
    : m_layout(layout), m_chord_length(chord_length), m_start(layout.number_of_halfedges()),
      m_direction(layout.number_of_halfedges())
  {
    for (int f = 0; f < layout.number_of_faces(); ++f) {
      int h = layout.halfedge_of(f);
      Point2 position(0, 0);
      for (int k = 0; k < 4; ++k, h = layout.next(h)) {
        m_start[h] = position;
        m_direction[h] = k;
        position = point(h, 1);
      }
    }
  }

  // the point at a fraction of h, in the chart of its face
  Point2 point(int h, double fraction) const
  {
    const double length = m_chord_length[m_layout.chord(Quad_layout::edge(h))];
    return m_start[h] + Chart_change::turned(Point2(fraction * length, 0), m_direction[h]);
  }

  // the change from the chart of the face of h to that on the other side
  Chart_change across(int h) const
  {
    const int twin = Quad_layout::opposite(h), turns = (m_direction[twin] + 2 - m_direction[h]) & 3;
    return {turns, point(twin, 1) - Chart_change::turned(m_start[h], turns)};
  }

private:
  const Quad_layout& m_layout;
  const std::vector<int>& m_chord_length;
  std::vector<Point2> m_start;  // per halfedge, in the chart of its face
  std::vector<int> m_direction; // per halfedge, in quarter-turns from +x
};

// Gives the faces of a mesh on which a layout is drawn the charts of the layout faces in which they
// lie: charts change along the curves. The places of the layout vertices in them are set, too.
class Square_charts
{
public:
  Square_charts(Embedded_layout& embedded, const Quad_layout& layout, const Layout_squares& squares)
    : m_mesh(embedded.mesh), m_layout(layout)
  {
    check_regions();
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.curve[h] >= 0)
        m_mesh.transition[h] = squares.across(m_mesh.curve[h]);
    for (int l = 0; l < layout.number_of_halfedges(); ++l)
      place_corners(along(embedded.vertices[layout.source(l)], l), squares.point(l, 0));
  }

private:
  // every region between curves must be one face of the layout
  void check_regions() const
  {
    std::vector<int> face(m_mesh.number_of_faces(), -1), regions(m_layout.number_of_faces(), 0);
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.curve[h] >= 0 && face[h / 3] < 0) {
        const int f = m_layout.face(m_mesh.curve[h]);
        ++regions[f];
        spread(h / 3, f, face);
      }
    for (int f = 0; f < m_layout.number_of_faces(); ++f)
      if (regions[f] != 1)
        throw Stage_failure("embed: layout face " + std::to_string(f) + " has " +
                            std::to_string(regions[f]) + " regions on the surface");
  }

  void spread(int first, int f, std::vector<int>& face) const
  {
    std::vector<int> stack{first};
    face[first] = f;
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        if (m_mesh.curve[h] >= 0 && m_layout.face(m_mesh.curve[h]) != f)
          throw Stage_failure("embed: the curves around layout face " + std::to_string(f) +
                              " are in disorder");
        const int g = m_mesh.opposite(h) / 3;
        if (m_mesh.curve[h] < 0 && face[g] < 0) {
          face[g] = f;
          stack.push_back(g);
        }
      }
    }
  }

  // the halfedge that leaves v along layout halfedge l
  int along(int v, int l) const
  {
    for (const int h : m_mesh.outgoing(v))
      if (m_mesh.curve[h] == l)
        return h;
    throw Stage_failure("embed: layout edge " + std::to_string(l / 2) + " does not reach its end");
  }

  // gives a place to all corners at the source of h on its left, up to the next curve
  void place_corners(int h, const Point2& place)
  {
    do {
      m_mesh.position[h] = place;
      h = m_mesh.opposite(Charted_mesh::prev(h));
    } while (m_mesh.curve[h] < 0);
  }

  Charted_mesh& m_mesh;
  const Quad_layout& m_layout;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SQUARE_CHARTS_H
