// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SINGULARITY_SPLITTER_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SINGULARITY_SPLITTER_H

#include <CGAL/Quad_layouts/internal/field/matching.h>
#include <CGAL/Quad_layouts/internal/field/sectors.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Spreads strong singularities over adjacent vertices. A vertex of index +2 has valence 2, one of
// +4 has no line at all; smooth fields have them at sharp tips, where a coarse mesh offers a
// single vertex for several singularities, and quads there would be slim or impossible.
//
// A period jump that grows by one moves a quarter of index from one end of its edge to the other.
// Only moves that lessen the sum of the squared indices are made: so the work ends, and all
// indices keep their sum.
class Singularity_splitter
{
public:
  // takes the angles and period jumps to change, and the faces whose angles must stay
  Singularity_splitter(const Face_connection& connection, std::vector<double>& angles,
                       std::vector<int>& jumps, const std::vector<char>& is_fixed)
    : m_connection(connection), m_surface(connection.surface()), m_angle(angles), m_jump(jumps),
      m_is_fixed(is_fixed), m_index(indices(connection, angles, jumps))
  {
  }

  // splits until no move helps, then lets the field around the moves relax, and around vertices
  // where jumps have been `changed` before
  void split(std::vector<int> changed)
  {
    for (bool moved = true; moved;) {
      moved = false;
      for (int v = 0; v < m_surface.number_of_vertices(); ++v)
        while (is_strong(m_index[v]) && move_a_quarter(v)) {
          changed.push_back(v);
          moved = true;
        }
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (int v : changed)
      relax(faces_around(v));
  }

private:
  // moves a quarter of the index of v to the neighbour where this helps most, and, of equals,
  // turns the field least; returns false if it helps nowhere
  bool move_a_quarter(int v)
  {
    const int quarter = m_index[v] > 0 ? 1 : -1;
    int best = -1, best_gain = 0;
    double best_rotation = 0;
    m_surface.for_each_outgoing(v, [&](int h) {
      if (m_surface.is_border(h) || is_between_fixed_crosses(h) ||
          is_in_narrow_sector(m_connection, m_angle, m_jump,
                              quarter > 0 ? m_surface.opposite(h) : h))
        return;
      const int gain = quarter * (m_index[v] - m_index[m_surface.target(h)]) - 1;
      const double turned = rotation(m_connection, m_angle, m_jump, h) + quarter * right_angle;
      if (gain > best_gain || (gain > 0 && gain == best_gain && std::abs(turned) < best_rotation)) {
        best = h;
        best_gain = gain;
        best_rotation = std::abs(turned);
      }
    });
    if (best < 0)
      return false;
    m_jump[best] += quarter;
    m_jump[m_surface.opposite(best)] -= quarter;
    m_index[v] -= quarter;
    m_index[m_surface.target(best)] += quarter;
    return true;
  }

  // whether the directions on both sides of h are prescribed, by more than the fixed edges there:
  // across those a field may turn by any angle, and has to where the border is acute
  bool is_between_fixed_crosses(int h) const
  {
    const int f = m_surface.face(h), g = m_surface.face(m_surface.opposite(h));
    return m_is_fixed[f] && m_is_fixed[g] &&
           !(m_surface.fixed_halfedge(f) >= 0 && m_surface.fixed_halfedge(g) >= 0);
  }

  // the free faces within four rings about v, in the order of a breadth-first search
  std::vector<int> faces_around(int v) const
  {
    constexpr int number_of_rings = 4;
    std::vector<int> result, ring{v}, next_ring;
    std::vector<int> seen_vertices{v};
    for (int i = 0; i < number_of_rings; ++i, ring.swap(next_ring), next_ring.clear())
      for (int u : ring)
        m_surface.for_each_outgoing(u, [&](int h) {
          add_once(m_surface.face(h), result);
          if (add_once(m_surface.target(h), seen_vertices))
            next_ring.push_back(m_surface.target(h));
        });
    result.erase(std::remove_if(result.begin(), result.end(), [&](int f) { return m_is_fixed[f]; }),
                 result.end());
    return result;
  }

  // appends `element` unless `elements`, a short list, has it already; returns whether it did
  static bool add_once(int element, std::vector<int>& elements)
  {
    if (std::find(elements.begin(), elements.end(), element) != elements.end())
      return false;
    elements.push_back(element);
    return true;
  }

  // lessens the weighted squares of the rotations, jumps unchanged, by Gauss-Seidel steps; that
  // energy is convex, so every step lessens it
  void relax(const std::vector<int>& faces)
  {
    constexpr int number_of_sweeps = 100;
    for (int i = 0; i < number_of_sweeps; ++i)
      for (int f : faces) {
        double turn = 0, weights = 0;
        for (int h = 3 * f; h < 3 * f + 3; ++h) {
          if (m_surface.is_border(h))
            continue;
          const double weight = m_connection.weight(m_surface.edge(h));
          turn += weight * rotation(m_connection, m_angle, m_jump, h);
          weights += weight;
        }
        m_angle[f] += turn / weights;
      }
  }

  const Face_connection& m_connection;
  const Triangle_surface& m_surface;
  std::vector<double>& m_angle;
  std::vector<int>& m_jump;
  const std::vector<char>& m_is_fixed;
  std::vector<int> m_index;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SINGULARITY_SPLITTER_H
