// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_CURVE_DEVIATION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_CURVE_DEVIATION_H

#include <CGAL/Quad_layouts/internal/quad_mesh/curve_distance.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Surface_walk.h>
#include <CGAL/Quad_layouts/internal/surface/Fixed_curves.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// How far fixed curves of a surface are from edges that join two places on them: where a curve
// bends in between, an edge cuts the corner.
class Curve_deviation
{
public:
  using Place = Surface_walk::Place;
  using Position = Fixed_curves::Position;

  explicit Curve_deviation(const Triangle_surface& surface)
    : m_surface(surface), m_curves(surface), m_tolerance(curve_tolerance(surface))
  {
  }

  // what is small enough
  double tolerance() const { return m_tolerance; }

  // the greatest distance of the curve between two places, both on the same one, from the edge that
  // joins them
  double of_edge(const Place& p, const Place& q) const
  {
    double result = 0;
    for_each_place_between(p, q, [&](const Place& place) {
      result = (std::max)(result, distance_to_segment(place.point, p.point, q.point));
    });
    return result;
  }

  // calls visit(place) for the vertices of the surface on the curve between two places
  template <class Visit>
  void for_each_place_between(const Place& p, const Place& q, const Visit& visit) const
  {
    const Position at_p = m_curves.position(p.fixed_halfedge, p.point);
    double begin = at_p.distance, end = distance_of(q, at_p);
    const double length = m_curves.length(at_p.curve);
    if (begin > end)
      std::swap(begin, end);
    if (m_curves.is_closed(at_p.curve) && end - begin > length / 2) // the other way is shorter
      begin = std::exchange(end, begin + length);
    m_curves.for_each_vertex_between(at_p.curve, begin, end, [&](int v, int h, double) {
      visit(Place{m_surface.point(v), m_surface.face(h), h});
    });
  }

private:
  // The distance along a curve of a place that may also be an end of it, where other curves begin:
  // the one that is nearest to another position, as a curve may end where it begins.
  double distance_of(const Place& place, const Position& other) const
  {
    const int curve = other.curve;
    double result = other.distance, least = (std::numeric_limits<double>::infinity)();
    const auto consider = [&](double distance) {
      if (std::abs(distance - other.distance) < least) {
        least = std::abs(distance - other.distance);
        result = distance;
      }
    };
    const auto is_near = [&](int v) {
      return (m_surface.point(v) - place.point).norm() < m_tolerance;
    };
    if (place.fixed_halfedge >= 0) {
      const Position own = m_curves.position(place.fixed_halfedge, place.point);
      if (own.curve == curve)
        consider(own.distance);
    }
    if (!m_curves.is_closed(curve) && is_near(m_curves.first_vertex(curve)))
      consider(0);
    if (!m_curves.is_closed(curve) && is_near(m_curves.last_vertex(curve)))
      consider(m_curves.length(curve));
    return result;
  }

  const Triangle_surface& m_surface;
  const Fixed_curves m_curves;
  const double m_tolerance;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_CURVE_DEVIATION_H
