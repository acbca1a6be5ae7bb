// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_LINE_TRACER_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_LINE_TRACER_H

#include <CGAL/Quad_layouts/Integer_grid_map.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A place in an integer-grid map and a direction there: 0 is +x, 1 is +y, 2 is -x, 3 is -y.
struct Map_heading
{
  int face = -1; // of the surface; -1 if there is no such place
  Integer_grid_map::Point_2 position = Integer_grid_map::Point_2::Zero(); // in the face's chart
  int direction = 0;

  bool is_valid() const { return face >= 0; }
  Map_heading turned(int quarter_turns) const
  {
    return {face, position, (direction + quarter_turns) & 3};
  }
  bool operator==(const Map_heading& other) const
  {
    return face == other.face && position == other.position && direction == other.direction;
  }
  bool operator!=(const Map_heading& other) const { return !(*this == other); }
};

// Follows axis-parallel lines through an integer-grid map.
//
// All decisions are exact: lines are compared with vertices by a coordinate, points with edges by
// an exact predicate. A vertex exactly on a line counts as lying to the right of it, as if the line
// were moved to the left by an infinitesimal.
class Line_tracer
{
public:
  using Surface = Integer_grid_map::Surface;
  using Point_2 = Integer_grid_map::Point_2;

  explicit Line_tracer(const Integer_grid_map& map) : m_map(map) {}

  // the same heading seen from the face that the line runs into; unique, so that headings from
  // different faces can be compared. At a vertex it is the first one counter-clockwise from the
  // given face; on the border, clockwise if there is none.
  Map_heading entered(const Map_heading& heading) const
  {
    if (!heading.is_valid())
      return {};
    for (int h = 3 * heading.face; h < 3 * heading.face + 3; ++h)
      if (m_map.coordinates(h) == heading.position)
        return entered_at_vertex(heading, h);
    Map_heading result = heading;
    for (int crossings = 0; crossings < 3; ++crossings) {
      int h = exit(result);
      if (h >= 0 && side(h, result.position) != ON_ORIENTED_BOUNDARY)
        return result;
      if (h < 0)
        h = edge_through(result);
      if (h < 0 || m_map.surface().is_border(h))
        break;
      result = crossed(h, result);
    }
    return {};
  }

  // The heading along the border at a place there, the surface on the left.
  Map_heading along_border(const Map_heading& place) const
  {
    const Surface& s = m_map.surface();
    for (int h = 3 * place.face; h < 3 * place.face + 3; ++h)
      if (m_map.coordinates(h) == place.position) {
        const int c = s.is_on_border(s.source(h)) ? s.halfedge(s.source(h)) : -1;
        return c < 0 ? Map_heading()
                     : Map_heading{Surface::face(c), m_map.coordinates(c), along(c)};
      }
    for (int h = 3 * place.face; h < 3 * place.face + 3; ++h)
      if (s.is_border(h) && side(h, place.position) == ON_ORIENTED_BOUNDARY)
        return {place.face, place.position, along(h)};
    return {};
  }

  // the headings at ascending positive distances from a start returned by `entered`; fewer if the
  // line gets lost, which it does not in a valid map. Appends to `curve` where the line crosses
  // edges.
  std::vector<Map_heading> follow(Map_heading line, const std::vector<double>& distances,
                                  std::vector<Eigen::Vector3d>* curve = nullptr) const
  {
    std::vector<Map_heading> result;
    for_each_face(line, distances.back(), [&](int h, const Map_heading& here) {
      append_points_before(h, here, distances, result);
      if (result.size() == distances.size() || m_map.surface().is_border(h))
        return false;
      if (curve)
        curve->push_back(crossing_point(h, here));
      return true;
    });
    return result;
  }

  // Whether a line from a start returned by `entered` runs along fixed edges for a distance. As it
  // has them on its right, it passes the faces on their left.
  bool is_fixed(const Map_heading& line, double distance) const
  {
    double covered = 0;
    for_each_face(line, distance, [&](int h, const Map_heading& here) {
      for (int g = 3 * here.face; g < 3 * here.face + 3; ++g)
        if (m_map.surface().is_fixed(g))
          covered += covered_by(g, here, distance);
      return side(h, ahead(here, distance)) == ON_NEGATIVE_SIDE && !m_map.surface().is_border(h);
    });
    return covered == distance; // coordinates are added without rounding
  }

  // the point of the surface
  Eigen::Vector3d point(const Map_heading& at) const
  {
    const Surface& s = m_map.surface();
    double sum = 0;
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (int h = 3 * at.face; h < 3 * at.face + 3; ++h) {
      const Point_2 a = m_map.coordinates(Surface::next(h)) - at.position;
      const Point_2 b = m_map.coordinates(Surface::prev(h)) - at.position;
      const double weight = a.x() * b.y() - a.y() * b.x();
      result += weight * s.point(s.source(h));
      sum += weight;
    }
    return result / sum;
  }

private:
  // Calls `visit` with the halfedge through which the line leaves a face, and the line in the chart
  // of that face, for one face after the other, until it returns false or the line, which shall be
  // followed for a distance, gets lost.
  template <class Visit>
  void for_each_face(Map_heading line, double distance, const Visit& visit) const
  {
    const double most = (1 + distance) * m_map.surface().number_of_faces();
    for (double steps = 0; steps < most; ++steps) {
      const int h = exit(line);
      if (h < 0 || !visit(h, line))
        return;
      line = crossed(h, line);
    }
  }

  // the length by which a line, up to a distance, is covered by g, a halfedge in its face
  double covered_by(int g, const Map_heading& line, double distance) const
  {
    const int turns = 4 - line.direction;
    const Point_2 from = Integer_grid_map::Transition::turned(m_map.coordinates(g) - line.position,
                                                              turns),
                  to = Integer_grid_map::Transition::turned(
                      m_map.coordinates(Surface::next(g)) - line.position, turns);
    if (from.y() != 0 || to.y() != 0)
      return 0;
    return (std::max)((std::min)(to.x(), distance) - (std::max)(from.x(), 0.), 0.);
  }

  static Point_2 ahead(const Map_heading& line, double distance)
  {
    const Point_2 forward(distance, 0);
    return line.position + Integer_grid_map::Transition::turned(forward, line.direction);
  }

  // appends what of the line lies in its present face, which it leaves through h
  void append_points_before(int h, const Map_heading& line, const std::vector<double>& distances,
                            std::vector<Map_heading>& result) const
  {
    while (result.size() < distances.size()) {
      const Point_2 p = ahead(line, distances[result.size()]);
      if (side(h, p) == ON_NEGATIVE_SIDE)
        return;
      result.push_back({line.face, p, line.direction});
    }
  }

  // the direction of h, which is parallel to an axis
  int along(int h) const
  {
    const Point_2 d = m_map.coordinates(Surface::next(h)) - m_map.coordinates(h);
    return std::abs(d.x()) > std::abs(d.y()) ? (d.x() > 0 ? 0 : 2) : (d.y() > 0 ? 1 : 3);
  }

  static bool is_left(const Point_2& p, const Map_heading& line)
  {
    switch (line.direction) {
      case 0: return p.y() > line.position.y();
      case 1: return p.x() < line.position.x();
      case 2: return p.y() < line.position.y();
      default: return p.x() > line.position.x();
    }
  }

  // the halfedge through which a line leaves a face, -1 if it misses the face
  int exit(const Map_heading& line) const
  {
    for (int h = 3 * line.face; h < 3 * line.face + 3; ++h)
      if (!is_left(m_map.coordinates(h), line) &&
          is_left(m_map.coordinates(Surface::next(h)), line))
        return h;
    return -1;
  }

  // the side of a halfedge on which a point lies: positive is to the left, inside the face
  Oriented_side side(int h, const Point_2& p) const
  {
    using Kernel = Exact_predicates_inexact_constructions_kernel;
    const Point_2& a = m_map.coordinates(h);
    const Point_2& b = m_map.coordinates(Surface::next(h));
    return orientation(Kernel::Point_2(a.x(), a.y()), Kernel::Point_2(b.x(), b.y()),
                       Kernel::Point_2(p.x(), p.y()));
  }

  int edge_through(const Map_heading& at) const
  {
    for (int h = 3 * at.face; h < 3 * at.face + 3; ++h)
      if (side(h, at.position) == ON_ORIENTED_BOUNDARY)
        return h;
    return -1;
  }

  // the same line in the chart of the face across h
  Map_heading crossed(int h, const Map_heading& line) const
  {
    const Integer_grid_map::Transition& t = m_map.transition(h);
    return {Surface::face(m_map.surface().opposite(h)), t(line.position),
            (line.direction + t.quarter_turns) & 3};
  }

  // turns counter-clockwise from the corner h until the line leaves through the edge opposite the
  // vertex. A vertex of valence 1 has all four directions within four rounds, and a part of a
  // fifth.
  Map_heading entered_at_vertex(Map_heading heading, int h) const
  {
    const int first = h;
    const Map_heading start = heading;
    int rounds = 0;
    while (exit(heading) != Surface::next(h)) {
      if (rounds == 5)
        return {};
      if (m_map.surface().turn_left(h) < 0)
        return entered_clockwise(start, first);
      heading = crossed(Surface::prev(h), heading);
      h = m_map.surface().turn_left(h);
      rounds += h == first;
    }
    return heading;
  }

  // the same clockwise, at a vertex on the border
  Map_heading entered_clockwise(Map_heading heading, int h) const
  {
    while (exit(heading) != Surface::next(h)) {
      if (m_map.surface().is_border(h))
        return {};
      heading = crossed(h, heading);
      h = m_map.surface().turn_right(h);
    }
    return heading;
  }

  Eigen::Vector3d crossing_point(int h, const Map_heading& line) const
  {
    const Surface& s = m_map.surface();
    const int across = 1 - line.direction % 2; // the coordinate that is constant on the line
    const double a = m_map.coordinates(h)[across], b = m_map.coordinates(Surface::next(h))[across];
    const double t = (line.position[across] - a) / (b - a);
    return (1 - t) * s.point(s.source(h)) + t * s.point(s.target(h));
  }

  const Integer_grid_map& m_map;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_LINE_TRACER_H
