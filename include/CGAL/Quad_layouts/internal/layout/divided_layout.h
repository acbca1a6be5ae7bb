// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_DIVIDED_LAYOUT_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_DIVIDED_LAYOUT_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/exceptions.h>

#include <CGAL/assertions.h>

#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A layout whose faces are divided into grids of quads: numbers for the vertices and the quads of
// the grids.
//
// Vertex v of the layout keeps its number; those inside edges follow, then those inside faces. In a
// face, x runs along `halfedge_of(f)` from 0 to `width(f)`, y to the left of it.
class Divided_layout
{
public:
  // expects a number of parts, at least 1, per chord
  Divided_layout(const Quad_layout& layout, std::vector<int> divisions)
    : m_layout(&layout), m_divisions(std::move(divisions))
  {
    CGAL_precondition(int(m_divisions.size()) == layout.number_of_chords);
    long long n = layout.number_of_vertices();
    for (int e = 0; e < layout.number_of_edges(); ++e) {
      m_first_on_edge.push_back(int(n));
      n = checked(n + parts(2 * e) - 1);
    }
    for (int f = 0; f < layout.number_of_faces(); ++f) {
      m_first_in_face.push_back(int(n));
      n = checked(n + (width(f) - 1ll) * (height(f) - 1));
    }
    m_number_of_vertices = int(n);
  }

  const Quad_layout& layout() const { return *m_layout; }
  int number_of_vertices() const { return m_number_of_vertices; }
  int parts(int halfedge) const
  {
    return m_divisions[m_layout->chord(Quad_layout::edge(halfedge))];
  }
  int width(int f) const { return parts(m_layout->halfedge_of(f)); }
  int height(int f) const { return parts(m_layout->next(m_layout->halfedge_of(f))); }

  // the vertex after the first k parts of a halfedge
  int vertex_on(int h, int k) const
  {
    const int n = parts(h);
    if (k == 0)
      return m_layout->source(h);
    if (k == n)
      return m_layout->target(h);
    return m_first_on_edge[Quad_layout::edge(h)] + (h % 2 == 0 ? k : n - k) - 1;
  }

  // the vertex (i, j) of the grid of a face
  int vertex_in(int f, int i, int j) const
  {
    const int w = width(f), h = height(f), bottom = m_layout->halfedge_of(f);
    const int right = m_layout->next(bottom), top = m_layout->next(right);
    if (j == 0)
      return vertex_on(bottom, i);
    if (i == w)
      return vertex_on(right, j);
    if (j == h)
      return vertex_on(top, w - i);
    if (i == 0)
      return vertex_on(m_layout->next(top), h - j);
    return m_first_in_face[f] + (j - 1) * (w - 1) + i - 1;
  }

  // calls visit(f, {a, b, c, d}) for each quad, row by row in each face; ab runs along x
  template <class Visit>
  void for_each_quad(Visit&& visit) const
  {
    for (int f = 0; f < m_layout->number_of_faces(); ++f)
      for (int j = 0; j < height(f); ++j)
        for (int i = 0; i < width(f); ++i)
          visit(f, std::array<int, 4>{vertex_in(f, i, j), vertex_in(f, i + 1, j),
                                      vertex_in(f, i + 1, j + 1), vertex_in(f, i, j + 1)});
  }

private:
  static long long checked(long long n)
  {
    if (n > (std::numeric_limits<int>::max)() / 8)
      throw Stage_failure("quad mesh: too many vertices for the target edge length");
    return n;
  }

  const Quad_layout* m_layout;
  std::vector<int> m_divisions;                      // per chord
  std::vector<int> m_first_on_edge, m_first_in_face; // number of the first vertex inside
  int m_number_of_vertices;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_DIVIDED_LAYOUT_H
