// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_LABELS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_LABELS_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/internal/right_angle.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// For every halfedge h the direction of its outward normal in the cross of its face, in eighths of
// a turn. It is odd, 2l+1, if the normal lies between the directions l and l+1: lines of these
// directions leave the face through h, those of the directions l+2 and l+3 enter. On fixed edges,
// to which the field is aligned, it is even: with label 2d, lines of direction d leave through h,
// those of direction d+2 enter, the others run along h and do not cross it.
//
// The increment at a corner is the label of the corner's halfedge minus that of the halfedge before
// it. A face is valid if its increments are at most 4 and sum to 8, that is, if its normals turn
// around once. Then every direction, unless it is that of a fixed edge, enters through one side and
// leaves through two, or the reverse. From here on the labels alone say which way lines run; angles
// only propose where.
class Labels
{
public:
  using Surface = Triangle_surface;

  static constexpr int least_valence = 2; // of vertices of quad meshes

  // reads the labels off the field, with the mean of the crosses on both sides of each edge
  explicit Labels(const Cross_field& field)
    : m_surface(&field.surface()), m_label(field.surface().number_of_halfedges())
  {
    for (int e = 0; e < m_surface->number_of_edges(); ++e) {
      const int h = m_surface->halfedge_of_edge(e), g = m_surface->opposite(h);
      if (m_surface->is_fixed(h))
        m_label[h] = static_cast<signed char>(2 * direction_of_normal(field, h));
      else
        set(h, quadrant_of_normal(field, h));
      if (g >= 0)
        m_label[g] = static_cast<signed char>((m_label[h] + 4 + 2 * field.matching(h)) & 7);
    }
  }

  // reads the labels off a parametrization, whose charts have the directions of the axes. Where
  // edges run along these, directions are those of the axes turned right infinitesimally, as
  // isolines are.
  explicit Labels(const Seamless_parametrization& map)
    : m_surface(&map.surface()), m_label(map.surface().number_of_halfedges())
  {
    for (int h = 0; h < m_surface->number_of_halfedges(); ++h) {
      const auto vector = map.coordinates(Surface::next(h)) - map.coordinates(h);
      set(h, quadrant_of(vector.y(), -vector.x()));
      if (m_surface->is_fixed(h))
        --m_label[h];
    }
  }

  const Surface& surface() const { return *m_surface; }
  // the direction l if the normal of h lies between the directions l and l+1, or has direction l
  int quadrant(int h) const { return m_label[h] >> 1; }
  // h must not be fixed
  void set(int h, int quadrant) { m_label[h] = static_cast<signed char>(2 * (quadrant & 3) + 1); }

  // direction d of the face of h is direction d + turn(h) of the face on the other side
  int turn(int h) const { return ((m_label[m_surface->opposite(h)] - m_label[h] + 4) >> 1) & 3; }

  bool leaves(int h, int direction) const { return ((2 * direction - m_label[h] + 1) & 7) < 3; }
  bool runs_along(int h, int direction) const
  {
    return ((2 * direction - m_label[h]) & 3) == 2 && (m_label[h] & 1) == 0;
  }
  // in eighths
  int increment(int corner) const { return (m_label[corner] - m_label[Surface::prev(corner)]) & 7; }

  bool is_valid(int f) const { return is_valid_with(3 * f, 0); }
  // says if the face of h would be valid if the quadrant of h were greater by `shift`
  bool is_valid_with(int h, int shift) const
  {
    const int a = (increment(h) + 2 * shift) & 7, b = (increment(Surface::next(h)) - 2 * shift) & 7,
              c = increment(Surface::prev(h));
    return a < 5 && b < 5 && c < 5 && a + b + c == 8;
  }

  // the number of directions that enter through both sides of a corner: lines that start at its
  // vertex. At most one side is fixed; lines along that are not counted.
  int number_of_starts(int corner) const
  {
    const int increment = this->increment(corner);
    return increment < 5 ? (4 - increment) / 2 : -1;
  }
  // the i-th of these directions, from right to left as seen from the vertex
  int start(int corner, int i) const { return (quadrant(corner) + 2 + i) & 3; }

  // the number of lines that start at v, fixed edges included
  int valence(int v) const
  {
    int sum = 0;
    m_surface->for_each_outgoing(
        v, [&](int h) { sum += number_of_starts(h) + m_surface->is_fixed(h); });
    return sum + m_surface->is_on_border(v);
  }

  // Four minus the valence, on the border three minus the valence. Over all vertices it sums to
  // four times the Euler characteristic, because the corners of a valid face sum to 2 starts, or to
  // 1 if a side is fixed.
  int index(int v) const { return (m_surface->is_on_border(v) ? 3 : 4) - valence(v); }

  // says if v, on no fixed edge, has two quads: where the surface is flat, one cannot be convex
  bool is_slim(int v) const { return m_surface->number_of_fixed_edges(v) == 0 && valence(v) == 2; }

  // Says if fixed edges, if there are any at v, go straight on there: there are two, each line
  // between them has one neighbour on both sides, and no other line starts at v.
  bool goes_straight_on(int v) const
  {
    const int fixed = m_surface->number_of_fixed_edges(v);
    if (fixed == 0)
      return true;
    int sectors_of_two = 0, starts = 0, first = m_surface->halfedge(v);
    while (!m_surface->is_fixed(first))
      first = m_surface->turn_left(first);
    for (int h = first; h >= 0;) {
      starts += number_of_starts(h);
      h = m_surface->turn_left(h);
      if (h < 0 || m_surface->is_fixed(h)) {
        sectors_of_two += starts == 1;
        starts = 0;
      }
      if (h == first)
        break;
    }
    return fixed == 2 && sectors_of_two == (m_surface->is_on_border(v) ? 1 : 2);
  }

  // The one side of f through which the lines of `direction` all enter or all leave; both others do
  // the opposite. A side along which they run counts as one through which they enter.
  int base(int f, int direction) const
  {
    const bool a = leaves(3 * f, direction), b = leaves(3 * f + 1, direction);
    if (a == b)
      return 3 * f + 2;
    return leaves(3 * f + 2, direction) == a ? 3 * f + 1 : 3 * f;
  }

private:
  static int direction_of_normal(const Cross_field& field, int h)
  {
    const double normal = field.surface().halfedge_angle(h) - right_angle;
    return nearest_quarter_turns(normal - field.angle(Surface::face(h))) & 3;
  }

  // the axes themselves are in the quadrant behind them
  static int quadrant_of(Seamless_parametrization::Integer x, Seamless_parametrization::Integer y)
  {
    if (x > 0 && y >= 0)
      return 0;
    if (x <= 0 && y > 0)
      return 1;
    return x < 0 ? 2 : 3;
  }

  static int quadrant_of_normal(const Cross_field& field, int h)
  {
    const Surface& surface = field.surface();
    const int g = surface.opposite(h);
    const double here = field.angle(Surface::face(h));
    const double there = field.angle(Surface::face(g)) + field.matching(h) * right_angle -
                         surface.transport(h);
    const double mean = here + std::remainder(there - here, 4 * right_angle) / 2;
    const double normal = surface.halfedge_angle(h) - right_angle;
    return int(std::floor((normal - mean) / right_angle)) & 3;
  }

  const Surface* m_surface;
  std::vector<signed char> m_label; // in eighths
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_LABELS_H
