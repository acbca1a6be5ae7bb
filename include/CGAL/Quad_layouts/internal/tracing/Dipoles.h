// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_DIPOLES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_DIPOLES_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/tracing/index_moves.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Puts pairs of singularities of valence 3 and 5 where fixed curves would fall together otherwise,
// away from others and from the curves.
class Dipoles
{
public:
  // changes `labels`, from which `t_mesh` was traced
  Dipoles(const T_mesh& t_mesh, Labels& labels)
    : m_t_mesh(t_mesh), m_surface(t_mesh.surface()), m_labels(labels)
  {
  }

  // Puts a pair beside the first of some arcs, which lie across a strip, where there is room: away
  // from other singularities and fixed curves if possible. Returns whether there is any.
  bool insert(const std::vector<int>& arcs)
  {
    for (int distance : {1, 0})
      for (int a : arcs)
        if (insert_beside(a, distance))
          return true;
    return false;
  }

private:
  // begins in the middle of the arc
  bool insert_beside(int arc, int distance)
  {
    const std::vector<T_mesh::Crossing>& crossings = m_t_mesh.arc_crossings[arc];
    const int n = int(crossings.size()) - 1; // faces that are entered and left again
    for (int i = 0; i < n; ++i) {
      const int k = i % 2 == 0 ? (n + i) / 2 : (n - i - 1) / 2;
      if (insert_at(side_beside(crossings[k].halfedge, crossings[k + 1].halfedge), distance))
        return true;
    }
    return false;
  }

  // The side of a face that an arc passes by: the arc enters the face through one halfedge, and
  // then the next face through another. Lines across the arc are more likely to cross this side
  // than others.
  int side_beside(int entry, int next_entry) const
  {
    const int exit = m_surface.opposite(next_entry);
    const int after = Triangle_surface::next(entry);
    return after == exit ? Triangle_surface::next(after) : after;
  }

  bool insert_at(int h, int distance)
  {
    if (!has_room(m_surface.source(h), distance) || !has_room(m_surface.target(h), distance))
      return false;
    for (const int shift : {1, 3})
      if (const Index_move move{h, shift}; is_legal(move, m_labels)) {
        move.apply(m_labels);
        return true;
      }
    return false;
  }

  // whether no vertex at most so many edges from v is singular or on a fixed curve
  bool has_room(int v, int distance) const
  {
    bool result = m_labels.index(v) == 0 && m_surface.number_of_fixed_edges(v) == 0;
    if (distance > 0)
      m_surface.for_each_outgoing(
          v, [&](int h) { result = result && has_room(m_surface.target(h), distance - 1); });
    return result;
  }

  const T_mesh& m_t_mesh;
  const Triangle_surface& m_surface;
  Labels& m_labels;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_DIPOLES_H
