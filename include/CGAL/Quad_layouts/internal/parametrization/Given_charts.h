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
#include <CGAL/Quad_layouts/internal/quarter_turns.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A parametrization as it comes from elsewhere: each triangle has a chart, in which its corners
// have coordinates. If it is seamless, then the two sides of an edge are the same vector up to
// quarter-turns and rounding.
class Given_charts
{
public:
  using Surface = Triangle_surface;
  using Transition = Chart_transition<double>;

  // takes coordinates for the corner at the source of each halfedge
  Given_charts(std::shared_ptr<const Surface> surface, std::vector<Point2> corners)
    : m_surface_pointer(std::move(surface)), m_corner(std::move(corners))
  {
  }

  const Surface& surface() const { return *m_surface_pointer; }
  const Point2& corner(int h) const { return m_corner[h]; }
  Point2 vector(int h) const { return m_corner[Surface::next(h)] - m_corner[h]; }

  // twice the area of face f in its chart
  double area(int f) const { return sides(f).determinant(); }

  // by how many quarter-turns, 0 to 3, the chart of the face behind h turns what it takes over; 0
  // on the border
  int quarter_turns(int h) const
  {
    const int g = surface().opposite(h);
    if (g < 0)
      return 0;
    // rounded once for both sides, of which one then turns back
    const int first = (std::min)(h, g), second = (std::max)(h, g);
    const int turns = nearest_quarter_turns(signed_angle(vector(first), -vector(second)));
    return (h == first ? turns : -turns) & 3;
  }

  // the change from the chart of the face of h to that of the face behind
  Transition transition(int h) const
  {
    const int turns = quarter_turns(h), same = Surface::next(surface().opposite(h));
    return {turns, corner(same) - Transition::turned(corner(h), turns)};
  }

  // throws if a coordinate is not finite, the sides of an edge differ, or a fixed edge runs along
  // no axis
  void check() const
  {
    check_corners();
    check_edges();
  }

  // the field of the directions of the axes
  Cross_field field() const
  {
    std::vector<double> angles;
    for (int f = 0; f < surface().number_of_faces(); ++f)
      angles.push_back(axis_angle(f));
    std::vector<signed char> matchings;
    for (int h = 0; h < surface().number_of_halfedges(); ++h)
      matchings.push_back(static_cast<signed char>(quarter_turns(h)));
    std::vector<int> indices;
    for (int v = 0; v < surface().number_of_vertices(); ++v)
      indices.push_back(index(v));
    return Cross_field(m_surface_pointer, std::move(angles), std::move(matchings),
                       std::move(indices));
  }

private:
  void check_corners() const
  {
    for (int h = 0; h < surface().number_of_halfedges(); ++h)
      if (!corner(h).allFinite())
        throw Invalid_parametrization("a corner at vertex " + std::to_string(surface().source(h)) +
                                      " has a coordinate that is not a finite number");
  }

  // names the worst edge
  void check_edges() const
  {
    // files have coordinates of some six digits
    constexpr double most = 1e-3;
    int worst = 0;
    double error = 0;
    for (int h = 0; h < surface().number_of_halfedges(); ++h)
      if (const double e = (std::max)(difference_of_sides(h), distance_from_axis(h)); e > error) {
        worst = h;
        error = e;
      }
    if (error <= most * mean_length())
      return;
    const std::string edge = "the edge from vertex " + std::to_string(surface().source(worst)) +
                             " to vertex " + std::to_string(surface().target(worst));
    if (error > difference_of_sides(worst))
      throw Invalid_parametrization("no line of constant coordinates: " + edge +
                                    " is fixed or on the border, and leaves its line by " +
                                    std::to_string(error));
    throw Invalid_parametrization("not seamless: the sides of " + edge + " differ by " +
                                  std::to_string(error));
  }

  double mean_length() const
  {
    double sum = 0;
    for (int h = 0; h < surface().number_of_halfedges(); ++h)
      sum += vector(h).norm();
    return sum / surface().number_of_halfedges();
  }

  double difference_of_sides(int h) const
  {
    if (surface().is_border(h))
      return 0;
    return (Transition::turned(vector(h), quarter_turns(h)) + vector(surface().opposite(h))).norm();
  }

  // how far a fixed edge is from running along an axis
  double distance_from_axis(int h) const
  {
    return surface().is_fixed(h) ? vector(h).cwiseAbs().minCoeff() : 0;
  }

  // the matrix of two sides of face f in its chart
  Eigen::Matrix2d sides(int f) const
  {
    Eigen::Matrix2d result;
    result << vector(3 * f), -vector(3 * f + 2);
    return result;
  }

  // The angle of the x-axis in the frame of face f. A fixed edge runs along an axis; the axes of
  // other faces are turned as if the map was the rotation that is nearest to it.
  double axis_angle(int f) const
  {
    const int fixed = surface().fixed_halfedge(f);
    if (fixed >= 0)
      return surface().halfedge_angle(fixed) -
             nearest_quarter_turns(signed_angle(Point2::UnitX(), vector(fixed))) * right_angle;
    const auto p = surface().planar_corners(f);
    Eigen::Matrix2d on_surface;
    on_surface << p[1] - p[0], p[2] - p[0];
    const Eigen::Matrix2d map = sides(f) * on_surface.inverse();
    return -std::atan2(map(1, 0) - map(0, 1), map(0, 0) + map(1, 1));
  }

  // what the triangles around v say of it
  int index(int v) const
  {
    if (surface().halfedge(v) < 0)
      return 0;
    return (surface().is_on_border(v) ? 2 : 4) -
           quarter_turns_around(surface(), v, [this](int h) { return corner(h); });
  }

  std::shared_ptr<const Surface> m_surface_pointer;
  std::vector<Point2> m_corner;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_GIVEN_CHARTS_H
