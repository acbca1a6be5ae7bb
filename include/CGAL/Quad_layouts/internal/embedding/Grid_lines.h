// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_GRID_LINES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_GRID_LINES_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/embedding/Quantized_overlay.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Draws the lines of the unit grids in all patches of a quantized T-mesh, as paths of edges.
//
// One line after the other is a shortest path through the inside of what is left of the patch.
// There always is one: a triangulated disc in which no inner edge joins two points of the boundary
// has inner vertices, and these are connected, and next to every boundary vertex. So it is enough
// to split such edges, which come with every new line.
//
// The middle one of parallel lines comes first, then those in the middle of both halves: a line has
// a vertex more for each edge from its neighbour to elsewhere, so that n lines from one side to the
// other would have up to n^3 vertices. By halves 108 lines had 6 n^2.
//
// In a patch of zero width, the lines from side to side are mapped to points.
class Grid_lines
{
public:
  Grid_lines(Quantized_overlay& overlay, const Monitor& monitor)
    : m_overlay(overlay), m_monitor(monitor), m_is_taken(overlay.mesh().points.size(), 0)
  {
    for (int h = 0; h < mesh().number_of_halfedges(); ++h)
      if (mesh().curve[h] >= 0)
        m_is_taken[mesh().source(h)] = 1;
    detach_boundaries();
    for (int p = 0; p < overlay.t_mesh().number_of_faces(); ++p)
      if (has_lines(p))
        draw_grid(p);
  }

private:
  // a vertex on the boundary of a region, and the next one along the boundary, the region being on
  // the left: vertices keep their numbers when edges are split
  struct Corner
  {
    int vertex, next;
  };

  const Curve_mesh& mesh() const { return m_overlay.mesh(); }
  const Quad_layout::Grid& grid(int p) const { return m_overlay.layout().grids[p]; }
  bool has_lines(int p) const { return p >= 0 && (grid(p).width > 1 || grid(p).height > 1); }

  void detach_boundaries()
  {
    for (int h = 0; h < mesh().number_of_halfedges(); ++h)
      if (has_lines(m_overlay.patch(h / 3)) && is_chord(h))
        split(h, false);
  }

  // whether h joins two points of boundaries without being part of one
  bool is_chord(int h) const
  {
    return mesh().curve[h] < 0 && m_is_taken[mesh().source(h)] && m_is_taken[mesh().target(h)];
  }

  int split(int h, bool is_taken)
  {
    m_is_taken.push_back(is_taken);
    return m_overlay.split(h);
  }

  // what a column of a grid lies between
  struct Column
  {
    std::vector<Corner> left, right;
  };

  void draw_grid(int p)
  {
    const int width = grid(p).width, height = grid(p).height;
    const auto sides = m_overlay.t_mesh().sides(p);
    std::vector<Column> columns((std::max)(width, 1));
    columns.front().left = corners(sides[3], height);
    std::reverse(columns.front().left.begin(), columns.front().left.end());
    columns.back().right = corners(sides[1], height);
    const std::vector<Corner> bottom = corners(sides[0], width), top = corners(sides[2], width);
    for_each_middle_first(1, width, [&](int i) {
      std::vector<int> line = draw_line(bottom[i - 1], top[width - 1 - i]);
      const std::vector<int> stops = divide(line, height);
      label_vertical(p, i, line, stops);
      detach(p, line);
      for (const int k : stops) {
        columns[i - 1].right.push_back({line[k], line[k + 1]});
        columns[i].left.push_back({line[k], line[k - 1]});
      }
    });
    for (std::size_t i = 0; i < columns.size(); ++i)
      draw_horizontals(p, int(i), columns[i].left, columns[i].right);
  }

  // calls `draw` for the numbers from `first` to before `end`
  template <class Draw>
  static void for_each_middle_first(int first, int end, const Draw& draw)
  {
    if (first >= end)
      return;
    const int middle = first + (end - first) / 2;
    draw(middle);
    for_each_middle_first(first, middle, draw);
    for_each_middle_first(middle + 1, end, draw);
  }

  // per integer inside of a side of a patch a corner there; a side may have several points at an
  // integer
  std::vector<Corner> corners(const std::vector<int>& side, int length) const
  {
    std::vector<Corner> result;
    int offset = 0;
    for (const int arc : side) {
      const std::vector<int> vertices = m_overlay.vertices(arc);
      for (std::size_t k = 0; k + 1 < vertices.size(); ++k) {
        const double place = offset + (k == 0 ? 0 : m_overlay.distance(arc, vertices[k]));
        if (place == int(result.size()) + 1 && place < length)
          result.push_back({vertices[k], vertices[k + 1]});
      }
      offset += m_overlay.length(arc);
    }
    return result;
  }

  // the halfedges that leave a corner into the region
  std::vector<int> inner(const Corner& c) const
  {
    std::vector<int> result;
    int h = mesh().halfedge_between(c.vertex, c.next);
    CGAL_assertion(h >= 0);
    for (h = mesh().opposite(Curve_mesh::prev(h)); mesh().curve[h] < 0;
         h = mesh().opposite(Curve_mesh::prev(h)))
      result.push_back(h);
    return result;
  }

  // draws a shortest path through free vertices; returns its vertices
  std::vector<int> draw_line(const Corner& from, const Corner& to)
  {
    m_monitor.check("embed");
    m_reached_from.resize(mesh().points.size(), -1);
    std::vector<int> queue;
    for (const int h : inner(from))
      reach(mesh().target(h), from.vertex, queue);
    std::vector<int> goals;
    for (const int h : inner(to))
      goals.push_back(mesh().target(h));
    const auto is_goal = [&](int v) {
      return std::find(goals.begin(), goals.end(), v) != goals.end();
    };
    std::size_t i = 0;
    while (i < queue.size() && !is_goal(queue[i])) {
      mesh().for_each_outgoing(queue[i], [&](int h) {
        if (!m_is_taken[mesh().target(h)])
          reach(mesh().target(h), queue[i], queue);
      });
      ++i;
    }
    if (i == queue.size())
      throw Stage_failure("embed: no way from vertex " + std::to_string(from.vertex) +
                          " to vertex " + std::to_string(to.vertex) + " of the overlay");
    std::vector<int> line{to.vertex};
    for (int v = queue[i]; v != from.vertex; v = m_reached_from[v])
      line.push_back(v);
    line.push_back(from.vertex);
    std::reverse(line.begin(), line.end());
    for (const int v : queue)
      m_reached_from[v] = -1;
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      m_overlay.set_line(halfedge(line, k), -1);
    for (const int v : line)
      m_is_taken[v] = 1;
    return line;
  }

  void reach(int v, int from, std::vector<int>& queue)
  {
    if (m_reached_from[v] >= 0)
      return;
    m_reached_from[v] = from;
    queue.push_back(v);
  }

  int halfedge(const std::vector<int>& line, std::size_t k) const
  {
    return mesh().halfedge_between(line[k], line[k + 1]);
  }

  // splits the edges of a line until it can be divided into `parts`; returns where the inner ends
  // of the parts are
  std::vector<int> divide(std::vector<int>& line, int parts)
  {
    while (int(line.size()) <= parts) {
      std::vector<int> finer{line.front()};
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        finer.push_back(split(halfedge(line, k), true));
        finer.push_back(line[k + 1]);
      }
      line = std::move(finer);
    }
    std::vector<int> result;
    for (int j = 1; j < parts; ++j)
      result.push_back(j * (int(line.size()) - 1) / parts);
    return result;
  }

  // tells what the i-th vertical line is mapped to, unless the patch has no height
  void label_vertical(int p, int i, const std::vector<int>& line, const std::vector<int>& stops)
  {
    const Quad_layout& layout = m_overlay.layout();
    for (std::size_t k = 0, j = 0; grid(p).height > 0 && k + 1 < line.size(); ++k) {
      if (j < stops.size() && int(k) == stops[j])
        m_overlay.set_layout_vertex(line[k], layout.source(grid(p).square(i, int(++j))));
      m_overlay.set_line(halfedge(line, k), layout.next(grid(p).square(i - 1, int(j))));
    }
  }

  void draw_horizontals(int p, int i, const std::vector<Corner>& left,
                        const std::vector<Corner>& right)
  {
    for_each_middle_first(0, int(left.size()), [&](int j) {
      const std::vector<int> line = draw_line(left[j], right[j]);
      if (grid(p).width > 0)
        for (std::size_t k = 0; k + 1 < line.size(); ++k)
          m_overlay.set_line(halfedge(line, k), grid(p).square(i, j + 1));
      detach(p, line);
    });
  }

  // splits the edges inside of patch p that join a vertex of a new line to a boundary
  void detach(int p, const std::vector<int>& line)
  {
    for (const int v : line)
      for (int h = chord_at(v, p); h >= 0; h = chord_at(v, p))
        split(h, false);
  }

  int chord_at(int v, int p) const
  {
    int result = -1;
    mesh().for_each_outgoing(v, [&](int h) {
      if (m_overlay.patch(h / 3) == p && is_chord(h))
        result = h;
    });
    return result;
  }

  Quantized_overlay& m_overlay;
  const Monitor& m_monitor;
  std::vector<char> m_is_taken;    // per vertex: whether it is on an arc or a line
  std::vector<int> m_reached_from; // per vertex, scratch of `draw_line`
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_GRID_LINES_H
