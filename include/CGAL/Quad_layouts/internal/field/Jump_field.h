// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_JUMP_FIELD_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_JUMP_FIELD_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/internal/field/Face_connection.h>
#include <CGAL/Quad_layouts/internal/field/matching.h>
#include <CGAL/Quad_layouts/internal/field/sectors.h>
#include <CGAL/Quad_layouts/internal/right_angle.h>

#include <cmath>
#include <memory>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A cross field with its period jumps: of those that fit its matchings, the ones with which it
// turns least. Changes of jumps move indices along edges.
class Jump_field
{
public:
  explicit Jump_field(const Cross_field& field)
    : m_surface(field.surface_pointer()), m_connection(*m_surface)
  {
    for (int f = 0; f < m_surface->number_of_faces(); ++f)
      m_angles.push_back(field.angle(f));
    for (int h = 0; h < m_surface->number_of_halfedges(); ++h)
      m_jumps.push_back(field.matching(h));
    for (int h = 0; h < m_surface->number_of_halfedges(); ++h)
      if (!m_surface->is_border(h))
        m_jumps[h] -= 4 * int(std::lround(rotation(m_connection, m_angles, m_jumps, h) /
                                          (4 * right_angle)));
    for (int v = 0; v < m_surface->number_of_vertices(); ++v)
      m_index.push_back(field.index(v));
  }

  const Triangle_surface& surface() const { return *m_surface; }
  const Face_connection& connection() const { return m_connection; }
  Cross_field field() const { return {m_surface, m_angles, matchings(m_jumps), m_index}; }

  // the quadrants in the sector of a fixed halfedge
  int number_of_quadrants(int h) const
  {
    return internal::number_of_quadrants(m_connection, m_angles, m_jumps, h);
  }

  // whether a quarter of index may go from the source of h to its target, so that there is another
  // quadrant at the source, and one less at the target
  bool can_move(int h) const
  {
    return !m_surface->is_fixed(h) && !is_strong(m_index[m_surface->source(h)] - 1) &&
           !is_strong(m_index[m_surface->target(h)] + 1) &&
           !is_in_narrow_sector(m_connection, m_angles, m_jumps, m_surface->opposite(h));
  }

  // how much the field then turns at the edge
  double turning_after_move(int h) const
  {
    return std::abs(rotation(m_connection, m_angles, m_jumps, h) + right_angle);
  }

  void move(int h) { change_jump(h, 1); }
  void undo_move(int h) { change_jump(h, -1); }

private:
  void change_jump(int h, int by)
  {
    m_jumps[h] += by;
    m_jumps[m_surface->opposite(h)] -= by;
    m_index[m_surface->source(h)] -= by;
    m_index[m_surface->target(h)] += by;
  }

  std::shared_ptr<const Triangle_surface> m_surface;
  Face_connection m_connection;
  std::vector<double> m_angles;
  std::vector<int> m_jumps, m_index;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_JUMP_FIELD_H
