// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_JUMP_ROUNDING_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_JUMP_ROUNDING_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/field/Cross_springs.h>
#include <CGAL/Quad_layouts/internal/field/Spring_solver.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Chooses the period jumps of springs by greedy rounding (Bommes, Zimmer and Kobbelt 2009).
//
// A jump that may be any real number makes the rotation of its spring 0: such a spring does
// nothing. So the relaxed problem has the active springs only, those whose jump has been chosen, in
// the angles alone. At the beginning they form a forest, whose jumps are no choice: turning a face
// by a right angle moves them. The relaxed angles are parallel along it. Then the spring whose real
// jump is nearest to an integer becomes active with this jump, and the angles relax, by
// Gauss-Seidel steps where they move; now and then all are solved for, lest the errors of local
// updates add up.
class Jump_rounding
{
public:
  Jump_rounding(const Cross_springs& springs, std::vector<double>& angles, std::vector<int>& jumps)
    : m_springs(springs), m_angle(angles), m_jump(jumps), m_solver(springs),
      m_is_active(springs.number_of_springs(), 0), m_deviation(springs.number_of_springs(), 0),
      m_is_waiting(springs.number_of_faces(), 0)
  {
  }

  void run(const Monitor& monitor)
  {
    grow_forest();
    rank_all();
    const double total = double(m_ranking.size());
    for (std::size_t next_solution = m_ranking.size() / 4; !m_ranking.empty();) {
      activate(m_ranking.begin()->second);
      relax();
      if (m_ranking.size() <= next_solution) {
        monitor.report("compute_cross_field", 1 - double(m_ranking.size()) / total);
        solve_all();
        next_solution = m_ranking.size() / 4;
      }
    }
    solve_all();
  }

private:
  // Makes the angles parallel along a forest whose roots are the fixed faces and those that are
  // strongly pulled. With too few roots the field ignores the shape as a whole, with too many it
  // keeps its noise.
  void grow_forest()
  {
    std::vector<int> reached;
    std::vector<char> is_reached(m_springs.number_of_faces(), 0);
    for (int f = 0; f < m_springs.number_of_faces(); ++f)
      if (m_springs.is_fixed(f) || is_strong(m_springs.spring_of_face(f))) {
        make_root(f);
        is_reached[f] = 1;
        reached.push_back(f);
      }
    grow(reached, is_reached);
    for (const int f : by_pull())
      if (!is_reached[f]) { // a part of the surface without such faces
        make_root(f);
        is_reached[f] = 1;
        reached.assign(1, f);
        grow(reached, is_reached);
      }
  }

  // the faces, the most strongly pulled first
  std::vector<int> by_pull() const
  {
    std::vector<int> result(m_springs.number_of_faces());
    std::iota(result.begin(), result.end(), 0);
    std::stable_sort(result.begin(), result.end(), [&](int f, int g) {
      return m_springs.weight(m_springs.spring_of_face(f)) >
             m_springs.weight(m_springs.spring_of_face(g));
    });
    return result;
  }

  bool is_strong(int s) const
  {
    constexpr double strong_pull = 0.005;
    return m_springs.is_spring(s) && m_springs.weight(s) >= strong_pull;
  }

  // turns face f to its pull, if it has one
  void make_root(int f)
  {
    const int pull = m_springs.spring_of_face(f);
    if (!m_springs.is_spring(pull))
      return;
    m_angle[f] += m_springs.turn(m_angle, pull);
    m_is_active[pull] = 1;
  }

  // appends the faces that are not reached yet, breadth first
  void grow(std::vector<int>& reached, std::vector<char>& is_reached)
  {
    for (std::size_t i = 0; i < reached.size(); ++i) {
      const int f = reached[i];
      m_springs.for_each_spring(f, [&](int s) {
        if (m_springs.is_pull(s))
          return;
        const int g = m_springs.other_end(s, f);
        if (is_reached[g])
          return;
        const double turn = m_springs.turn(m_angle, s);
        m_angle[g] += g == m_springs.to(s) ? -turn : turn;
        m_is_active[s] = 1;
        is_reached[g] = 1;
        reached.push_back(g);
      });
    }
  }

  void rank_all()
  {
    m_ranking.clear();
    for (int s = 0; s < m_springs.number_of_springs(); ++s)
      if (m_springs.is_spring(s) && !m_is_active[s]) {
        m_deviation[s] = deviation(s);
        m_ranking.emplace(m_deviation[s], s);
      }
  }

  // how far the real jump of s is from an integer, in radians
  double deviation(int s) const
  {
    return std::abs(std::remainder(m_springs.turn(m_angle, s), right_angle));
  }

  // fixes the jump of spring s
  void activate(int s)
  {
    m_ranking.erase({m_deviation[s], s});
    m_is_active[s] = 1;
    m_jump[s] = m_springs.nearest_jump(m_angle, s);
    wait(m_springs.from(s));
    wait(m_springs.to(s));
  }

  // makes face f, which may be `ground`, one whose angle may have to move
  void wait(int f)
  {
    if (m_springs.is_fixed(f) || m_is_waiting[f])
      return;
    m_is_waiting[f] = 1;
    m_waiting.push(f);
  }

  // lets the angles move to where the forces are small, beginning with the waiting faces
  void relax()
  {
    constexpr double smallest_step = 1e-3; // radians
    constexpr int most_steps = 10000;      // long loops wait for the next solution
    for (int steps = 0; !m_waiting.empty(); ++steps) {
      const int f = m_waiting.front();
      m_waiting.pop();
      m_is_waiting[f] = 0;
      const double step = steps < most_steps ? gauss_seidel_step(f) : 0;
      if (std::abs(step) < smallest_step)
        continue;
      m_angle[f] += step;
      m_springs.for_each_spring(f, [&](int s) {
        if (m_is_active[s])
          wait(m_springs.other_end(s, f));
        else
          m_moved.push_back(s);
      });
    }
    rank_moved();
  }

  // how far face f moves to where the forces of its active springs cancel
  double gauss_seidel_step(int f) const
  {
    double force = 0, weights = 0;
    m_springs.for_each_spring(f, [&](int s) {
      if (!m_is_active[s])
        return;
      const double r = m_springs.rotation(m_angle, m_jump, s);
      force += m_springs.weight(s) * (f == m_springs.from(s) ? r : -r);
      weights += m_springs.weight(s);
    });
    return force / weights;
  }

  // ranks the springs anew whose ends have moved
  void rank_moved()
  {
    std::sort(m_moved.begin(), m_moved.end());
    m_moved.erase(std::unique(m_moved.begin(), m_moved.end()), m_moved.end());
    for (const int s : m_moved) {
      m_ranking.erase({m_deviation[s], s});
      m_deviation[s] = deviation(s);
      m_ranking.emplace(m_deviation[s], s);
    }
    m_moved.clear();
  }

  void solve_all()
  {
    m_solver.factorize(m_is_active);
    m_solver.solve(m_angle, m_jump);
    rank_all();
  }

  const Cross_springs& m_springs;
  std::vector<double>& m_angle;
  std::vector<int>& m_jump;
  Spring_solver m_solver;
  std::vector<char> m_is_active;
  std::vector<double> m_deviation;            // with which springs are in the ranking
  std::set<std::pair<double, int>> m_ranking; // of the springs that are not active
  std::queue<int> m_waiting;                  // faces whose angles may have to move
  std::vector<char> m_is_waiting;
  std::vector<int> m_moved; // springs that are not active
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_JUMP_ROUNDING_H
