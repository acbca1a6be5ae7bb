// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_ARC_GRID_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_ARC_GRID_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>

#include <CGAL/assertions.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The integer points and unit segments of the arcs of a quantized T-mesh.
//
// An arc of length q carries the points 0 to q, of which the first and the last are its nodes, and
// q segments. Point n is node n for all nodes of the T-mesh, inner points of arcs follow. Segments
// are numbered along arcs; segment s has two *half-segments*, 2s along the arc's first halfedge and
// 2s+1 against it, each of which belongs to the patch on its left.
class Arc_grid
{
public:
  // throws `Stage_failure` unless lengths are non-negative and equal on opposite sides of patches
  Arc_grid(const T_mesh& t_mesh, const std::vector<int>& arc_length)
    : m_t_mesh(&t_mesh), m_length(arc_length)
  {
    CGAL_precondition(int(arc_length.size()) == t_mesh.number_of_edges());
    number_points_and_segments();
    collect_sides();
  }

  const T_mesh& t_mesh() const { return *m_t_mesh; }
  int number_of_points() const { return m_number_of_points; }
  int number_of_half_segments() const { return int(m_source.size()); }

  int length(int arc) const { return m_length[arc]; }
  int width(int patch) const { return int(m_sides[patch][0].size()); }
  int height(int patch) const { return int(m_sides[patch][1].size()); }
  bool is_on_border(int point) const { return m_place[point] == ON_BORDER; }
  // or on another fixed curve
  bool is_on_fixed_curve(int point) const { return m_place[point] != INSIDE; }
  // has no squares: one or both of its extents are 0
  bool is_flat(int patch) const { return width(patch) == 0 || height(patch) == 0; }
  bool is_point(int patch) const { return width(patch) == 0 && height(patch) == 0; }

  // half-segments of side k of a patch, counter-clockwise about the patch
  const std::vector<int>& side(int patch, int k) const { return m_sides[patch][k]; }

  int source(int half_segment) const { return m_source[half_segment]; }
  int target(int half_segment) const { return m_source[half_segment ^ 1]; }
  int arc(int half_segment) const { return m_arc[half_segment / 2]; }
  // -1 if the half-segment is on the outside of the border
  int patch(int half_segment) const
  {
    return m_t_mesh->face(2 * arc(half_segment) + half_segment % 2);
  }

  // the half-segment on the other side of a flat patch that falls onto this one, -1 in other
  // patches
  int across(int half_segment) const { return m_across[half_segment]; }
  // the half-segment of a patch that is not flat, or on the outside of the border, which this one,
  // also of such a patch, is glued to
  int facing(int half_segment) const
  {
    int s = half_segment ^ 1;
    while (across(s) >= 0)
      s = across(s) ^ 1;
    return s;
  }

private:
  enum Place : char { INSIDE, ON_FIXED_CURVE, ON_BORDER };

  void number_points_and_segments()
  {
    const T_mesh& t = *m_t_mesh;
    m_number_of_points = t.number_of_vertices();
    for (int n = 0; n < t.number_of_vertices(); ++n)
      m_place.push_back(t.is_on_border(n)        ? ON_BORDER
                        : t.is_on_fixed_curve(n) ? ON_FIXED_CURVE
                                                 : INSIDE);
    m_first_segment.reserve(m_length.size());
    for (int a = 0; a < t.number_of_edges(); ++a) {
      if (m_length[a] < 0)
        throw Stage_failure("layout: the length of arc " + std::to_string(a) + " is negative");
      m_first_segment.push_back(int(m_arc.size()));
      const Place place = t.is_border_edge(a) ? ON_BORDER : t.is_fixed(a) ? ON_FIXED_CURVE : INSIDE;
      for (int i = 0; i < m_length[a]; ++i) {
        m_arc.push_back(a);
        m_source.push_back(i == 0 ? t.source(2 * a) : m_number_of_points++);
        m_source.push_back(i == m_length[a] - 1 ? t.target(2 * a) : m_number_of_points);
      }
      m_place.resize(m_number_of_points, place);
    }
  }

  void collect_sides()
  {
    const T_mesh& t = *m_t_mesh;
    m_sides.resize(t.number_of_faces());
    m_across.assign(m_source.size(), -1);
    for (int p = 0; p < t.number_of_faces(); ++p) {
      const auto sides = t.sides(p);
      for (int k = 0; k < 4; ++k)
        for (int h : sides[k])
          append_half_segments(h, m_sides[p][k]);
      for (int k = 0; k < 2; ++k)
        match_sides(p, k);
    }
  }

  void append_half_segments(int h, std::vector<int>& side) const
  {
    const int a = T_mesh::edge(h), q = m_length[a];
    for (int i = 0; i < q; ++i)
      side.push_back(2 * (m_first_segment[a] + (h % 2 == 0 ? i : q - 1 - i)) + h % 2);
  }

  // compares sides k and k + 2 of a patch, and joins them if the patch has no extent between them
  void match_sides(int patch, int k)
  {
    const auto& side = m_sides[patch][k];
    const auto& other = m_sides[patch][k + 2];
    if (side.size() != other.size())
      throw Stage_failure("layout: opposite sides of patch " + std::to_string(patch) +
                          " have lengths " + std::to_string(side.size()) + " and " +
                          std::to_string(other.size()));
    if (!m_sides[patch][1 - k].empty())
      return;
    for (std::size_t i = 0; i < side.size(); ++i) {
      m_across[side[i]] = other[side.size() - 1 - i];
      m_across[other[side.size() - 1 - i]] = side[i];
    }
  }

  const T_mesh* m_t_mesh;
  std::vector<int> m_length;
  int m_number_of_points = 0;
  std::vector<Place> m_place;          // per point
  std::vector<int> m_first_segment;    // per arc
  std::vector<int> m_arc;              // per segment
  std::vector<int> m_source, m_across; // per half-segment
  std::vector<std::array<std::vector<int>, 4>> m_sides;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_ARC_GRID_H
