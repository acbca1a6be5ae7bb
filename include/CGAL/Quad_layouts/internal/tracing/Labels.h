// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_LABELS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_LABELS_H

#include <CGAL/Quad_layouts/Cross_field.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// For every halfedge h the quadrant of its outward normal in the cross of its face: with label l,
// lines of the directions l and l+1 leave the face through h, lines of the directions l+2 and l+3
// enter.
//
// The increment at a corner is the label of the corner's halfedge minus that of the halfedge before
// it. A face is valid if its increments are in {0, 1, 2} and sum to 4, that is, if its normals turn
// around once. Then every direction enters through one side and leaves through two, or the reverse.
// From here on the labels alone say which way lines run; angles only propose where.
class Labels
{
public:
  using Surface = Triangle_surface;

  // reads the labels off the field, with the mean of the crosses on both sides of each edge
  explicit Labels(const Cross_field& field)
    : m_surface(&field.surface()), m_label(field.surface().number_of_halfedges())
  {
    for (int e = 0; e < m_surface->number_of_edges(); ++e) {
      const int h = m_surface->halfedge_of_edge(e);
      m_label[h] = quadrant_of_normal(field, h);
      m_label[m_surface->opposite(h)] = (m_label[h] + 2 + field.matching(h)) & 3;
    }
  }

  const Surface& surface() const { return *m_surface; }
  int operator[](int h) const { return m_label[h]; }
  void set(int h, int label) { m_label[h] = static_cast<signed char>(label & 3); }

  // direction d of the face of h is direction d + turn(h) of the face on the other side
  int turn(int h) const { return (m_label[m_surface->opposite(h)] - m_label[h] + 2) & 3; }

  bool leaves(int h, int direction) const { return ((direction - m_label[h]) & 3) < 2; }
  int increment(int corner) const { return (m_label[corner] - m_label[Surface::prev(corner)]) & 3; }

  bool is_valid(int f) const
  {
    const int a = increment(3 * f), b = increment(3 * f + 1), c = increment(3 * f + 2);
    return a < 3 && b < 3 && c < 3 && a + b + c == 4;
  }

  // the number of directions that enter through both sides of a corner: lines that start at its
  // vertex
  int number_of_starts(int corner) const { return 2 - increment(corner); }
  // the i-th of these directions, from right to left as seen from the vertex
  int start(int corner, int i) const { return (m_label[corner] + 2 + i) & 3; }

  // the number of lines that start at v. Over all vertices of a closed surface, 4 - valence sums
  // to four times the Euler characteristic, because the corners of a valid face sum to 2
  int valence(int v) const
  {
    int sum = 0;
    m_surface->for_each_outgoing(v, [&](int h) { sum += number_of_starts(h); });
    return sum;
  }

  // the one side of f through which the lines of `direction` all enter or all leave; both others
  // do the opposite
  int base(int f, int direction) const
  {
    const bool a = leaves(3 * f, direction), b = leaves(3 * f + 1, direction);
    if (a == b)
      return 3 * f + 2;
    return leaves(3 * f + 2, direction) == a ? 3 * f + 1 : 3 * f;
  }

private:
  static signed char quadrant_of_normal(const Cross_field& field, int h)
  {
    constexpr double right_angle = 1.57079632679489661923;
    const Surface& surface = field.surface();
    const int g = surface.opposite(h);
    const double here = field.angle(Surface::face(h));
    const double there = field.angle(Surface::face(g)) + field.matching(h) * right_angle
                       - surface.transport(h);
    const double mean = here + std::remainder(there - here, 4 * right_angle) / 2;
    const double normal = surface.halfedge_angle(h) - right_angle;
    const int quadrant = int(std::floor((normal - mean) / right_angle));
    return static_cast<signed char>(quadrant & 3);
  }

  const Surface* m_surface;
  std::vector<signed char> m_label;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_LABELS_H
