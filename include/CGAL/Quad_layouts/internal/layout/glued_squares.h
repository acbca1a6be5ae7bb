// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_GLUED_SQUARES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_GLUED_SQUARES_H

#include <CGAL/Quad_layouts/internal/layout/arc_grid.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The unit squares of all patches, glued along their sides: in patches along the inner grid lines,
// between patches along segments of arcs, straight across flat patches. The result is always an
// oriented manifold; it is the quotient of the surface if and only if each fibre has one
// vertex.
//
// Square s has the sides 4s (bottom), 4s+1 (right), 4s+2 (top), 4s+3 (left), counter-clockwise;
// square (i, j) of a patch of width w is number `first_square(patch) + j w + i`. A side also stands
// for the corner where it begins.
class Glued_squares
{
public:
  explicit Glued_squares(const Arc_grid& grid) : m_grid(&grid)
  {
    number_squares();
    glue_inside_patches();
    glue_along_arcs();
    number_vertices();
  }

  const Arc_grid& grid() const { return *m_grid; }
  int number_of_squares() const { return int(m_patch.size()); }
  int number_of_sides() const { return 4 * number_of_squares(); }
  int number_of_vertices() const { return int(m_squares_at.size()); }

  static int next(int side) { return side % 4 == 3 ? side - 3 : side + 1; }
  static int prev(int side) { return side % 4 == 0 ? side + 3 : side - 1; }
  // -1 on the border
  int opposite(int side) const { return m_opposite[side]; }
  int vertex(int side) const { return m_vertex[side]; }
  int number_of_squares_at(int vertex) const { return m_squares_at[vertex]; }
  bool is_on_border(int vertex) const { return m_is_on_border[vertex] != 0; }

  int first_square(int patch) const { return m_first_square[patch]; }
  int patch(int square) const { return m_patch[square]; }
  // the half-segment that a side lies on, -1 for sides inside a patch
  int half_segment(int side) const { return m_half_segment[side]; }
  // the side of a square that a half-segment falls onto, also across flat patches; -1 if that is
  // the outside of the border. No half-segment may be in a flat ring.
  int side_on(int half_segment) const { return m_side[m_grid->facing(half_segment ^ 1)]; }

private:
  void number_squares()
  {
    const int n = m_grid->t_mesh().number_of_faces();
    for (int p = 0; p < n; ++p) {
      m_first_square.push_back(number_of_squares());
      m_patch.insert(m_patch.end(), std::size_t(m_grid->width(p)) * m_grid->height(p), p);
    }
    m_opposite.assign(number_of_sides(), -1);
    m_half_segment.assign(number_of_sides(), -1);
  }

  int side(int patch, int i, int j, int k) const
  {
    return 4 * (m_first_square[patch] + j * m_grid->width(patch) + i) + k;
  }

  void glue(int a, int b)
  {
    m_opposite[a] = b;
    m_opposite[b] = a;
  }

  void glue_inside_patches()
  {
    for (int p = 0; p < int(m_first_square.size()); ++p) {
      const int w = m_grid->width(p), h = m_grid->height(p);
      for (int j = 0; j < h; ++j)
        for (int i = 0; i < w; ++i) {
          if (i + 1 < w)
            glue(side(p, i, j, 1), side(p, i + 1, j, 3));
          if (j + 1 < h)
            glue(side(p, i, j, 2), side(p, i, j + 1, 0));
        }
    }
  }

  void glue_along_arcs()
  {
    m_side.assign(m_grid->number_of_half_segments(), -1);
    for (int p = 0; p < int(m_first_square.size()); ++p) {
      const int w = m_grid->width(p), h = m_grid->height(p);
      if (m_grid->is_flat(p))
        continue;
      for (int i = 0; i < w; ++i) {
        m_side[m_grid->side(p, 0)[i]] = side(p, i, 0, 0);
        m_side[m_grid->side(p, 2)[i]] = side(p, w - 1 - i, h - 1, 2);
      }
      for (int j = 0; j < h; ++j) {
        m_side[m_grid->side(p, 1)[j]] = side(p, w - 1, j, 1);
        m_side[m_grid->side(p, 3)[j]] = side(p, 0, h - 1 - j, 3);
      }
    }
    for (int s = 0; s < int(m_side.size()); ++s)
      if (m_side[s] >= 0) {
        m_half_segment[m_side[s]] = s;
        m_opposite[m_side[s]] = m_side[m_grid->facing(s)];
      }
  }

  void number_vertices()
  {
    m_vertex.assign(number_of_sides(), -1);
    for (int first = 0; first < number_of_sides(); ++first) {
      if (m_vertex[first] >= 0)
        continue;
      m_squares_at.push_back(0);
      m_is_on_border.push_back(0);
      const auto visit = [&](int s) {
        if (s < 0)
          m_is_on_border.back() = 1;
        if (s < 0 || m_vertex[s] >= 0)
          return false;
        m_vertex[s] = number_of_vertices() - 1;
        ++m_squares_at.back();
        return true;
      };
      for (int s = first; visit(s);)
        s = opposite(s) < 0 ? -1 : next(opposite(s));
      for (int s = opposite(prev(first)); visit(s);)
        s = opposite(prev(s));
    }
  }

  const Arc_grid* m_grid;
  std::vector<int> m_first_square;                       // per patch
  std::vector<int> m_patch;                              // per square
  std::vector<int> m_opposite, m_vertex, m_half_segment; // per side
  std::vector<int> m_side;                               // per half-segment, -1 in flat patches
  std::vector<int> m_squares_at;                         // per vertex
  std::vector<char> m_is_on_border;                      // per vertex
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_GLUED_SQUARES_H
