// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_CROSS_SPRINGS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_CROSS_SPRINGS_H

#include <CGAL/Quad_layouts/internal/field/curvature.h>
#include <CGAL/Quad_layouts/internal/field/matching.h>

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The energy of a cross field in angles and period jumps (Bommes, Zimmer and Kobbelt 2009), as a
// network of springs between the angles of the faces:
//
//     sum over springs  w (theta_to - theta_from - rest + p pi/2)^2
//
// with an integer p for each. There is a spring across each edge inside, whose rest is the
// transport, and one that pulls a face towards its principal curvature, whose other end is held at
// the angle 0. The parenthesis is called the *rotation*. It is what `rotation()` of a halfedge is
// for the first kind; for small rotations the energy is, up to a factor, the one that diffusion
// minimises.
//
// Springs are numbered: those of the edges first, then those of the faces. Some numbers have no
// spring: the edges of the border and the faces without a pull.
class Cross_springs
{
public:
  static constexpr int ground = -1; // the end of a spring that is not a face

  // takes the pulls on the faces, and which of them have an angle that must stay. A part of the
  // network that nothing holds gets one more such face.
  Cross_springs(const Face_connection& connection, const std::vector<Complex>& pulls,
                std::vector<char> is_fixed)
    : m_surface(&connection.surface()), m_is_fixed(std::move(is_fixed))
  {
    add_edges(connection);
    add_pulls(pulls);
    hold_loose_parts();
  }

  const Triangle_surface& surface() const { return *m_surface; }
  int number_of_springs() const { return int(m_weight.size()); }
  int number_of_faces() const { return m_surface->number_of_faces(); }
  int spring_of_face(int f) const { return m_surface->number_of_edges() + f; }

  bool is_spring(int s) const { return m_weight[s] > 0; }
  // says if s pulls a face towards its principal curvature
  bool is_pull(int s) const { return s >= m_surface->number_of_edges(); }
  double weight(int s) const { return m_weight[s]; }
  int from(int s) const
  {
    const int ne = m_surface->number_of_edges();
    return s < ne ? m_surface->face(m_surface->halfedge_of_edge(s)) : s - ne;
  }
  int to(int s) const
  {
    return is_pull(s) ? ground
                      : m_surface->face(m_surface->opposite(m_surface->halfedge_of_edge(s)));
  }
  int other_end(int s, int f) const { return f == from(s) ? to(s) : from(s); }
  // says if the angle of f, which may be `ground`, is no unknown
  bool is_fixed(int f) const { return f == ground || m_is_fixed[f]; }

  // calls f(s) for the springs of face i
  template <class F>
  void for_each_spring(int i, F&& f) const
  {
    for (int h = 3 * i; h < 3 * i + 3; ++h)
      if (is_spring(m_surface->edge(h)))
        f(m_surface->edge(h));
    if (is_spring(spring_of_face(i)))
      f(spring_of_face(i));
  }

  // what the rotation of s would be with p = 0
  double turn(const std::vector<double>& angles, int s) const
  {
    const int end = to(s);
    return (end == ground ? 0 : angles[end]) - angles[from(s)] - m_rest[s];
  }
  // the jump for which the rotation of s is least
  int nearest_jump(const std::vector<double>& angles, int s) const
  {
    return -nearest_quarter_turns(turn(angles, s));
  }
  double rotation(const std::vector<double>& angles, const std::vector<int>& jumps, int s) const
  {
    return turn(angles, s) + jumps[s] * right_angle;
  }

  double energy(const std::vector<double>& angles, const std::vector<int>& jumps) const
  {
    double sum = 0;
    for (int s = 0; s < number_of_springs(); ++s)
      if (is_spring(s)) {
        const double r = rotation(angles, jumps, s);
        sum += m_weight[s] * r * r;
      }
    return sum;
  }

private:
  void add_edges(const Face_connection& connection)
  {
    for (int e = 0; e < m_surface->number_of_edges(); ++e) {
      const int h = m_surface->halfedge_of_edge(e);
      m_weight.push_back(connection.weight(e));
      m_rest.push_back(m_surface->is_border(h) ? 0 : connection.transport(h));
    }
  }

  void add_pulls(const std::vector<Complex>& pulls)
  {
    // what is weaker comes from rounding errors of coordinates, and spoils systems of equations
    constexpr double weakest = 1e-10;
    for (int f = 0; f < number_of_faces(); ++f) {
      const double strength = std::abs(pulls[f]);
      m_weight.push_back(m_is_fixed[f] || strength < weakest ? 0 : strength);
      m_rest.push_back(-std::arg(pulls[f]) / 4);
    }
  }

  void hold_loose_parts()
  {
    std::vector<char> is_reached(number_of_faces(), 0);
    std::vector<int> part;
    for (int f = 0; f < number_of_faces(); ++f) {
      if (is_reached[f])
        continue;
      part.assign(1, f);
      is_reached[f] = 1;
      bool is_held = false;
      for (std::size_t i = 0; i < part.size(); ++i) {
        is_held = is_held || m_is_fixed[part[i]];
        for_each_spring(part[i], [&](int s) {
          const int g = other_end(s, part[i]);
          is_held = is_held || g == ground;
          if (g == ground || is_reached[g])
            return;
          is_reached[g] = 1;
          part.push_back(g);
        });
      }
      if (!is_held)
        m_is_fixed[f] = 1;
    }
  }

  const Triangle_surface* m_surface;
  std::vector<char> m_is_fixed;
  std::vector<double> m_weight, m_rest;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_CROSS_SPRINGS_H
