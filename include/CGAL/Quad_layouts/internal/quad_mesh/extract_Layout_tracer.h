// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_LAYOUT_TRACER_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_LAYOUT_TRACER_H

#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_Line_tracer.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_starts.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Returns the distances, in an edge of integer length, of the ends of its parts from where it
// begins: equal parts, up to rounding to what the map's coordinates can express, and the same from
// either end.
inline std::vector<double> distances_of_parts(int length, int parts)
{
  constexpr double unit = 1 << 24;
  std::vector<double> result;
  for (int k = 1; k <= parts; ++k)
    result.push_back(std::round(double(length) * k / parts * unit) / unit);
  return result;
}

// Finds the edges of a layout in an integer-grid map.
//
// Lines are followed from the anchors on, breadth first over the edges of the layout. A vertex of
// the layout that is reached again must be reached at the same place from the same side, exactly.
// Edges on the border are followed with the surface on their left.
// So where this succeeds the layout is in the map.
class Layout_tracer
{
public:
  // expects the number of parts that the edges of each chord are divided into
  Layout_tracer(const Integer_grid_map& map, const Quad_layout& layout,
                const std::vector<int>& divisions)
    : m_lines(map), m_map(map), m_layout(layout), m_start(layout.number_of_halfedges()),
      m_stops(layout.number_of_edges()), m_curves(layout.number_of_edges())
  {
    for (int c = 0; c < layout.number_of_chords; ++c)
      m_distances.push_back(distances_of_parts(map.chord_length[c], divisions[c]));
    start_at_anchors();
    while (!m_queue.empty()) {
      const int h = m_queue.front();
      m_queue.pop();
      if (m_stops[Quad_layout::edge(h)].empty())
        arrive(h, follow_edge(h));
    }
    for (int e = 0; e < layout.number_of_edges(); ++e)
      if (m_stops[e].empty())
        fail("no anchor leads to", 2 * e);
  }

  const Line_tracer& lines() const { return m_lines; }
  const Quad_layout& layout() const { return m_layout; }
  const std::vector<double>& distances(int halfedge) const
  {
    return m_distances[m_layout.chord(Quad_layout::edge(halfedge))];
  }

  // where a halfedge begins
  const Map_heading& start(int halfedge) const { return m_start[halfedge]; }
  // the heading along a halfedge after its first k parts, k positive and less than the number of
  // parts
  Map_heading stop(int halfedge, int k) const
  {
    const auto& stops = m_stops[Quad_layout::edge(halfedge)];
    return halfedge % 2 == 0 ? stops[k - 1] : stops[stops.size() - 1 - k].turned(2);
  }
  // per edge of the layout the polyline on the surface that it is
  const std::vector<std::vector<Eigen::Vector3d>>& curves() const { return m_curves; }

private:
  void start_at_anchors()
  {
    for (const Integer_grid_map::Anchor& a : m_map.anchors) {
      m_start[a.layout_halfedge] = {Integer_grid_map::Surface::face(a.corner),
                                    m_map.coordinates(a.corner), a.direction};
      m_queue.push(a.layout_halfedge);
    }
    for (const Integer_grid_map::Anchor& a : m_map.anchors) {
      const int h = a.layout_halfedge;
      if (m_layout.is_border(m_layout.turn_left(h)))
        continue;
      if (m_start[h] != m_lines.entered(m_start[h]) ||
          m_start[m_layout.turn_left(h)] != m_lines.entered(m_start[h].turned(1)))
        fail("directions at the anchor do not fit the map at the start of", h);
    }
  }

  // finds the points along an edge; returns the heading at its end
  Map_heading follow_edge(int h)
  {
    auto& curve = m_curves[Quad_layout::edge(h)];
    auto& stops = m_stops[Quad_layout::edge(h)];
    curve = {m_lines.point(m_start[h])};
    stops = m_lines.follow(m_start[h], distances(h), &curve);
    if (stops.size() < distances(h).size())
      fail("the map does not contain", h);
    const Map_heading end = stops.back();
    curve.push_back(m_lines.point(end));
    if (h % 2 == 1)
      reverse(stops, curve);
    return end;
  }

  // turns what was found against an edge's direction into that direction; the end has no
  // counterpart, so the last stop is a filler that makes positions equal
  static void reverse(std::vector<Map_heading>& stops, std::vector<Eigen::Vector3d>& curve)
  {
    std::reverse(stops.begin(), stops.end() - 1);
    for (Map_heading& s : stops)
      s = s.turned(2);
    std::reverse(curve.begin(), curve.end());
  }

  // compares the end of an edge with what is known of the vertex, or goes on from there
  void arrive(int h, const Map_heading& end)
  {
    const int v = m_layout.target(h);
    if (m_layout.is_on_border(v))
      return arrive_on_border(h, end);
    const Map_heading back = m_lines.entered(end.turned(2));
    const int first = Quad_layout::opposite(h);
    if (m_start[first].is_valid()) {
      if (back != m_start[first])
        fail("the map has another end for", h);
      return;
    }
    if (!m_layout.is_regular(v))
      fail("there is no anchor at the irregular end of", h);
    if (!set_starts_inside(m_lines, m_layout, first, back, m_start,
                           [this](int g) { m_queue.push(g); }))
      fail("the map folds at the end of", h);
  }

  void arrive_on_border(int h, const Map_heading& end)
  {
    const int v = m_layout.target(h), first = m_layout.halfedge_from(v);
    if (!m_start[first].is_valid()) {
      if (!m_layout.is_regular(v))
        fail("there is no anchor at the irregular end of", h);
      if (!set_starts_on_border(m_lines, m_layout, v, end, m_start,
                                [this](int g) { m_queue.push(g); }))
        fail("the map folds at the end of", h);
    }
    const int twin = Quad_layout::opposite(h);
    if (m_lines.along_border(end) != m_start[first] ||
        (!m_layout.is_border(twin) && m_lines.entered(end.turned(2)) != m_start[twin]))
      fail("the map has another end for", h);
  }

  [[noreturn]] void fail(const std::string& what, int h) const
  {
    throw Stage_failure("quad mesh: " + what + " layout edge " +
                        std::to_string(Quad_layout::edge(h)) + " (from vertex " +
                        std::to_string(m_layout.source(h)) + " to " +
                        std::to_string(m_layout.target(h)) + ")");
  }

  Line_tracer m_lines;
  const Integer_grid_map& m_map;
  const Quad_layout& m_layout;
  std::vector<std::vector<double>> m_distances;  // per chord
  std::vector<Map_heading> m_start;              // per halfedge of the layout
  std::vector<std::vector<Map_heading>> m_stops; // per edge, along its first halfedge
  std::vector<std::vector<Eigen::Vector3d>> m_curves;
  std::queue<int> m_queue; // halfedges whose start is known
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_LAYOUT_TRACER_H
