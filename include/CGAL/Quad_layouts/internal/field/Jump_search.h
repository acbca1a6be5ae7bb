// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_JUMP_SEARCH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_JUMP_SEARCH_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/field/Cross_springs.h>
#include <CGAL/Quad_layouts/internal/field/Spring_solver.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Lessens the energy of a cross field by changing period jumps one at a time, which moves a quarter
// of an index along an edge: singularities move to better places, and cancel each other.
//
// When the jump of spring s grows by d in radians, and all angles adapt, the energy changes by
//
//     w d (2 r + d (1 - w R)),
//
// r being the rotation of s, w its weight, and R the effective resistance between its ends: the
// approach of the ends when they are pulled together by a unit of force. As 0 < w R <= 1, a change
// can be worth it long before r exceeds half a right angle. R does not depend on the jumps, and so
// is computed once.
class Jump_search
{
public:
  explicit Jump_search(const Cross_springs& springs)
    : m_springs(springs), m_solver(springs), m_share_bound(springs.number_of_springs(), 0),
      m_is_exact(springs.number_of_springs(), 0)
  {
    std::vector<char> active(springs.number_of_springs());
    for (int s = 0; s < springs.number_of_springs(); ++s)
      active[s] = springs.is_spring(s);
    m_solver.factorize(active);
    // a pull is weak: its share is hardly more than 0, and not worth the time
    for (int s = 0; s < springs.number_of_springs(); ++s)
      if (springs.is_pull(s))
        m_is_exact[s] = 1;
      else if (springs.is_spring(s))
        m_share_bound[s] = share_bound(s);
  }

  // makes the changes that lessen the energy most, as long as there are any; the angles are always
  // the best for the jumps
  void run(std::vector<double>& angles, std::vector<int>& jumps, const Monitor& monitor)
  {
    m_solver.solve(angles, jumps);
    for (;;) {
      monitor.check("compute_cross_field");
      std::vector<Change> changes = changes_apart(angles, jumps);
      if (changes.empty())
        return;
      const double energy = m_springs.energy(angles, jumps);
      make(changes, 1, angles, jumps);
      if (m_springs.energy(angles, jumps) >= energy) {
        // changes far apart influence each other little, but single ones for sure lessen the energy
        make(changes, -1, angles, jumps);
        changes.resize(1);
        make(changes, 1, angles, jumps);
      }
    }
  }

private:
  struct Change
  {
    int spring;
    int step; // of the jump
    double saving;
  };

  void make(const std::vector<Change>& changes, int sign, std::vector<double>& angles,
            std::vector<int>& jumps) const
  {
    for (const Change& c : changes)
      jumps[c.spring] += sign * c.step;
    m_solver.solve(angles, jumps);
  }

  // changes that lessen the energy, the best first, no two of them at a common vertex
  std::vector<Change> changes_apart(const std::vector<double>& angles,
                                    const std::vector<int>& jumps)
  {
    std::vector<Change> changes = good_changes(angles, jumps), result;
    std::sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
      return a.saving != b.saving ? a.saving > b.saving : a.spring < b.spring;
    });
    std::vector<char> is_taken(m_springs.surface().number_of_vertices(), 0);
    for (const Change& c : changes) {
      const std::vector<int> around = vertices_beside(c.spring);
      if (std::any_of(around.begin(), around.end(), [&](int v) { return is_taken[v]; }))
        continue;
      for (const int v : around)
        is_taken[v] = 1;
      result.push_back(c);
    }
    return result;
  }

  // the corners of the faces of s
  std::vector<int> vertices_beside(int s) const
  {
    std::vector<int> result;
    for (const int f : {m_springs.from(s), m_springs.to(s)})
      if (f != Cross_springs::ground)
        for (int h = 3 * f; h < 3 * f + 3; ++h)
          result.push_back(m_springs.surface().source(h));
    return result;
  }

  // the changes each of which would lessen the energy
  std::vector<Change> good_changes(const std::vector<double>& angles, const std::vector<int>& jumps)
  {
    constexpr double smallest_gain = 1e-6; // more than rounding errors
    std::vector<Change> result;
    for (int s = 0; s < m_springs.number_of_springs(); ++s) {
      if (!m_springs.is_spring(s))
        continue;
      const double rotation = m_springs.rotation(angles, jumps, s);
      if (gain(rotation, m_share_bound[s]) < smallest_gain)
        continue;
      const double exact_gain = gain(rotation, share(s));
      if (exact_gain >= smallest_gain)
        result.push_back({s, rotation > 0 ? -1 : 1, m_springs.weight(s) * exact_gain});
    }
    return result;
  }

  // the energy saved by the better change of a jump, divided by the weight and a right angle; the
  // share is the w R above
  static double gain(double rotation, double share)
  {
    return 2 * std::abs(rotation) - right_angle * (1 - share);
  }

  double share(int s)
  {
    if (!m_is_exact[s]) {
      m_share_bound[s] = m_springs.weight(s) * m_solver.resistance(s);
      m_is_exact[s] = 1;
    }
    return m_share_bound[s];
  }

  // An upper bound of the share of s, which is no pull, by Rayleigh's monotonicity law: of all
  // other springs it takes only those around either end of the edge, which are two parallel paths
  // from face to face.
  double share_bound(int s) const
  {
    double conductance = 0;
    const int h = m_springs.surface().halfedge_of_edge(s);
    for (const int out : {h, m_springs.surface().opposite(h)})
      conductance += conductance_around(m_springs.surface().source(out), s);
    return m_springs.weight(s) / (m_springs.weight(s) + conductance);
  }

  // of the path around vertex v from one face of s to the other, 0 if the border is in its way
  double conductance_around(int v, int s) const
  {
    const Triangle_surface& surface = m_springs.surface();
    if (surface.is_on_border(v))
      return 0;
    double resistance = 0;
    surface.for_each_outgoing(v, [&](int h) {
      if (surface.edge(h) != s)
        resistance += 1 / m_springs.weight(surface.edge(h));
    });
    return 1 / resistance;
  }

  const Cross_springs& m_springs;
  Spring_solver m_solver;
  std::vector<double> m_share_bound;
  std::vector<char> m_is_exact; // whether the bound is the share itself
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_JUMP_SEARCH_H
