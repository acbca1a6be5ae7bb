// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_FIXED_LINES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_FIXED_LINES_H

#include <CGAL/Quad_layouts/internal/tracing/Chords.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The lines that fixed edges form inside of a surface, from one start of traces to the next.
class Fixed_lines
{
public:
  Fixed_lines(const Chords& chords, const std::vector<int>& starts)
    : m_chords(&chords), m_length_ahead(chords.surface().number_of_halfedges(), 0)
  {
    const Triangle_surface& surface = chords.surface();
    std::vector<char> is_start(surface.number_of_vertices(), 0);
    for (int v : starts)
      is_start[v] = 1;
    for (int v : starts)
      surface.for_each_outgoing(v, [&](int h) {
        if (surface.is_fixed(h) && !surface.is_border(h))
          measure(surface.opposite(h), is_start);
      });
  }

  // the length of the line ahead of the fixed halfedge h, that of h included
  double length_ahead(int h) const { return m_length_ahead[h]; }

private:
  // h is the last halfedge of a line
  void measure(int h, const std::vector<char>& is_start)
  {
    double length = 0;
    for (;; h = previous(h)) {
      length += m_chords->length(h);
      m_length_ahead[h] = length;
      if (is_start[m_chords->surface().source(h)])
        return;
    }
  }

  // the fixed halfedge that leads straight to h
  int previous(int h) const
  {
    int result = -1;
    m_chords->surface().for_each_outgoing(m_chords->surface().source(h), [&](int g) {
      if (m_chords->surface().is_fixed(g) && g != h)
        result = m_chords->surface().opposite(g);
    });
    return result;
  }

  const Chords* m_chords;
  std::vector<double> m_length_ahead; // per halfedge
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_FIXED_LINES_H
