// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_ISOLINE_CHORDS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_ISOLINE_CHORDS_H

#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/internal/tracing/Chords.h>
#include <CGAL/Quad_layouts/internal/tracing/Isoline.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The pieces of traces along the lines of constant coordinates of a seamless parametrization, which must be
// locally injective. Integers alone decide where they run. Lengths are those in the map, and exact: integer
// multiples of its unit, which is a power of two. At sides of triangles, where they need not be integers,
// they are rounded down, which keeps their order.
class Isoline_chords : public Chords
{
public:
  Isoline_chords(const Seamless_parametrization& map, const Labels& labels)
    : Chords(labels), m_map(&map)
  {
  }

  // of a fixed halfedge, which has a constant coordinate
  double length(int h) const override
  {
    return in_map((m_map->coordinates(Triangle_surface::next(h)) - m_map->coordinates(h))
                      .cwiseAbs()
                      .maxCoeff());
  }
  double length_before(const End& e) const override
  {
    const double length_of_edge_before = in_map(m_cut[e.point].distance_from_source());
    return is_canonical(e.halfedge) ? length_of_edge_before
                                    : length(e.halfedge) - length_of_edge_before;
  }

private:
  using Integer = Isoline::Integer;

  double in_map(Integer length) const { return m_map->unit * double(length); }

  void leave_face(Chord& chord, int previous) override
  {
    const int h = chord.from.halfedge;
    m_line.push_back(previous < 0
                         ? Isoline{m_map->coordinates(h), chord.direction}
                         : m_line[previous].continued(m_map->transition(surface().opposite(h))));
    const int exit = exit_of(chord);
    chord.to = {exit, insert(exit)};
    chord.end = in_map(m_cut.back().length());
  }

  // the side through which the last line leaves the face of its chord
  int exit_of(const Chord& chord) const
  {
    const int h = chord.from.halfedge;
    if (chord.from.point < 0)
      return Triangle_surface::next(h);
    const int apex = Triangle_surface::prev(h);
    return m_line.back().has_on_left(m_map->coordinates(apex)) ? Triangle_surface::next(h) : apex;
  }

  // adds the point in which the last line cuts halfedge h
  int insert(int h)
  {
    const int canonical = surface().halfedge_of_edge(surface().edge(h));
    const auto &source = m_map->coordinates(h),
               &target = m_map->coordinates(Triangle_surface::next(h));
    m_cut.push_back(h == canonical ? Isoline_cut(m_line.back(), source, target)
                                   : Isoline_cut(m_line.back(), target, source));
    return m_order.insert(surface().edge(h), m_cut.back().fraction(),
                          [&](int p) { return m_cut[p] < m_cut.back(); });
  }

  std::pair<double, double> lengths_at_crossing(int c, int d) const override
  {
    return {in_map(m_line[c].length_before(m_line[d])), in_map(m_line[d].length_before(m_line[c]))};
  }

  const Seamless_parametrization* m_map;
  std::vector<Isoline> m_line;    // per chord, in the chart of its face
  std::vector<Isoline_cut> m_cut; // per point, of the canonical halfedge of its edge
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_ISOLINE_CHORDS_H
