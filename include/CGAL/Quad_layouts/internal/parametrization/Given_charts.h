// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_GIVEN_CHARTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_GIVEN_CHARTS_H

#include <CGAL/Quad_layouts/Chart_transition.h>
#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/right_angle.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A parametrization as it comes from elsewhere: each triangle has a chart, in which its corners have
// coordinates. If it is seamless, then the two sides of an edge are the same vector up to
// quarter-turns and rounding.
class Given_charts
{
public:
  using Surface = Triangle_surface;
  using Transition = Chart_transition<double>;

  // takes coordinates for the corner at the source of each halfedge
  Given_charts(std::shared_ptr<const Surface> surface, std::vector<Point2> corners)
    : m_surface_pointer(std::move(surface)), m_surface(*m_surface_pointer),
      m_corner(std::move(corners))
  {
  }

  const Surface& surface() const { return m_surface; }
  const Point2& corner(int h) const { return m_corner[h]; }
  Point2 vector(int h) const { return m_corner[Surface::next(h)] - m_corner[h]; }

  // twice the area of face f in its chart
  double area(int f) const { return cross(vector(3 * f), -vector(3 * f + 2)); }

  // by how many quarter-turns, 0 to 3, the chart of the face behind h turns what it takes over; 0
  // on the border
  int quarter_turns(int h) const
  {
    const int g = m_surface.opposite(h);
    if (g < 0)
      return 0;
    // rounded once for both sides, of which one then turns back
    return h < g ? quarters(vector(h), -vector(g)) & 3 : -quarters(vector(g), -vector(h)) & 3;
  }

  // the change from the chart of the face of h to that of the face behind
  Transition transition(int h) const
  {
    const int turns = quarter_turns(h), same = Surface::next(m_surface.opposite(h));
    return {turns, corner(same) - Transition::turned(corner(h), turns)};
  }

  // throws if a coordinate is not finite, the sides of an edge differ, or a fixed edge runs along no
  // axis
  void check() const
  {
    check_corners();
    check_edges();
  }

  // the field of the directions of the axes
  Cross_field field() const
  {
    std::vector<double> angles;
    for (int f = 0; f < m_surface.number_of_faces(); ++f)
      angles.push_back(axis_angle(f));
    std::vector<signed char> matchings;
    for (int h = 0; h < m_surface.number_of_halfedges(); ++h)
      matchings.push_back(static_cast<signed char>(quarter_turns(h)));
    std::vector<int> indices;
    for (int v = 0; v < m_surface.number_of_vertices(); ++v)
      indices.push_back(index(v));
    return Cross_field(m_surface_pointer, std::move(angles), std::move(matchings),
                       std::move(indices));
  }

private:
  void check_corners() const
  {
    for (int h = 0; h < m_surface.number_of_halfedges(); ++h)
      if (!corner(h).allFinite())
        throw Invalid_parametrization("a corner at vertex " + std::to_string(m_surface.source(h)) +
                                      " has a coordinate that is not a finite number");
  }

  // names the worst edge
  void check_edges() const
  {
    // files have coordinates of some six digits
    constexpr double most = 1e-3;
    int worst = 0;
    for (int h = 0; h < m_surface.number_of_halfedges(); ++h)
      if (error(h) > error(worst))
        worst = h;
    if (error(worst) <= most * mean_length())
      return;
    const std::string edge = "the edge from vertex " + std::to_string(m_surface.source(worst)) +
                             " to vertex " + std::to_string(m_surface.target(worst));
    if (error(worst) > difference_of_sides(worst))
      throw Invalid_parametrization("no line of constant coordinates: " + edge +
                                    " is fixed or on the border, and leaves its line by " +
                                    std::to_string(error(worst)));
    throw Invalid_parametrization("not seamless: the sides of " + edge + " differ by " +
                                  std::to_string(error(worst)));
  }

  static double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

  // the number of quarter-turns that is nearest to the angle from a to b
  static int quarters(const Point2& a, const Point2& b)
  {
    return int(std::lround(std::atan2(cross(a, b), a.dot(b)) / right_angle));
  }

  double mean_length() const
  {
    double sum = 0;
    for (int h = 0; h < m_surface.number_of_halfedges(); ++h)
      sum += vector(h).norm();
    return sum / m_surface.number_of_halfedges();
  }

  double difference_of_sides(int h) const
  {
    if (m_surface.is_border(h))
      return 0;
    return (Transition::turned(vector(h), quarter_turns(h)) + vector(m_surface.opposite(h))).norm();
  }

  double error(int h) const
  {
    const double sides = difference_of_sides(h);
    return m_surface.is_fixed(h) ? (std::max)(sides, vector(h).cwiseAbs().minCoeff()) : sides;
  }

  // The angle of the x-axis in the frame of face f. A fixed edge runs along an axis; the axes of
  // other faces are turned as if the map was the rotation that is nearest to it.
  double axis_angle(int f) const
  {
    const int fixed = m_surface.fixed_halfedge(f);
    if (fixed >= 0)
      return m_surface.halfedge_angle(fixed) -
             quarters(Point2::UnitX(), vector(fixed)) * right_angle;
    const auto p = m_surface.planar_corners(f);
    Eigen::Matrix2d there, here;
    there << vector(3 * f), -vector(3 * f + 2);
    here << p[1] - p[0], p[2] - p[0];
    const Eigen::Matrix2d map = there * here.inverse();
    return -std::atan2(map(1, 0) - map(0, 1), map(0, 0) + map(1, 1));
  }

  // The angles around a vertex, signed, sum to quarter-turns: those of the transitions inside, and
  // from axis to axis on the border.
  int index(int v) const
  {
    if (m_surface.halfedge(v) < 0)
      return 0;
    double sum = 0;
    m_surface.for_each_outgoing(v, [&](int h) {
      const Point2 a = vector(h), b = -vector(Surface::prev(h));
      sum += std::atan2(cross(a, b), a.dot(b));
    });
    return (m_surface.is_on_border(v) ? 2 : 4) - int(std::lround(sum / right_angle));
  }

  std::shared_ptr<const Surface> m_surface_pointer;
  const Surface& m_surface;
  std::vector<Point2> m_corner;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_GIVEN_CHARTS_H
