// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_ROSETTES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_ROSETTES_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/internal/field/Face_connection.h>
#include <CGAL/Quad_layouts/internal/field/Jump_field.h>
#include <CGAL/Quad_layouts/internal/field/sectors.h>
#include <CGAL/Quad_layouts/internal/parametrization/Aligned_energy.h>
#include <CGAL/Quad_layouts/internal/parametrization/Cut_graph.h>
#include <CGAL/Quad_layouts/internal/right_angle.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Shapes for the triangles around vertices: they are spread over the angle that the index demands,
// in proportion to their own angles, and turned as the field is in the mean. Between fixed edges
// they are spread over the quadrants that the field has there, and fixed edges lie along axes.
//
// Where the field turns fast, the map nearest to it may fold the triangles around a vertex of
// valence 5 or more into the angle that is left by a full turn, and wind twice around others
// instead. As all triangles may be positive there, nothing drives them back. But once all such
// vertices have their angles, so have all vertices: the angles of positive triangles sum to what
// the Euler characteristic demands, and a vertex of a smaller valence cannot lose a full turn.
// Where triangles around a vertex are inverted and stay so, they are folded as well.
class Rosettes
{
public:
  Rosettes(const Cross_field& field, const Cut_graph& cut, double edge_length)
    : m_field(field), m_surface(field.surface()), m_cut(cut), m_edge_length(edge_length),
      m_jump_field(field)
  {
  }

  // makes the triangles around v strive for their shapes
  void demand(int v, Aligned_energy& energy) const
  {
    const std::vector<Petal> petals = petals_at(v);
    const double phase = phase_of(petals);
    for (const Petal& p : petals) {
      std::array<Point2, 3> corners;
      const int h = p.halfedge, next = Triangle_surface::next(h), prev = Triangle_surface::prev(h);
      corners[h % 3] = Point2::Zero();
      corners[next % 3] = arm(h, p.begin + phase);
      corners[prev % 3] = arm(prev, p.end + phase);
      energy.demand(m_surface.face(h), corners);
    }
  }

private:
  // a triangle at the source of its halfedge, with the directions of its two sides there in its
  // chart
  struct Petal
  {
    int halfedge;
    double begin, end;
  };

  std::vector<Petal> petals_at(int v) const
  {
    double direction = 0;
    std::vector<Petal> result;
    m_surface.for_each_outgoing(v, [&](int h) {
      const double end = direction + connection().corner_angle(h) * widening(h);
      const int leaving = Triangle_surface::prev(h);
      result.push_back({h, direction, end});
      if (!m_surface.is_border(leaving))
        direction = end + m_cut.quarter_turns(leaving) * right_angle;
    });
    return result;
  }

  const Face_connection& connection() const { return m_jump_field.connection(); }

  // how much wider the corner of h has to be in the map than on the surface
  double widening(int h) const
  {
    const int sector = sector_of(m_surface, h), v = m_surface.source(h);
    if (sector >= 0)
      return m_jump_field.number_of_quadrants(sector) * right_angle /
             sector_angle(connection(), sector);
    double sum = 0;
    m_surface.for_each_outgoing(v, [&](int g) { sum += connection().corner_angle(g); });
    return (4 - m_field.index(v)) * right_angle / sum;
  }

  // the angle from the petals to where they would lie in a map along the field, in the mean
  double phase_of(const std::vector<Petal>& petals) const
  {
    std::complex<double> sum = 0;
    for (const Petal& p : petals) {
      const int h = p.halfedge;
      const double along_field = m_surface.halfedge_angle(h) - m_cut.x_angle(m_surface.face(h));
      if (m_surface.is_fixed(h))
        return std::round(along_field / right_angle) * right_angle - p.begin;
      const double middle = along_field + m_surface.corner_angle(h) / 2;
      sum += m_surface.corner_angle(h) * std::polar(1., middle - (p.begin + p.end) / 2);
    }
    return std::arg(sum);
  }

  Point2 arm(int h, double direction) const
  {
    return m_surface.length(h) / m_edge_length * Point2(std::cos(direction), std::sin(direction));
  }

  const Cross_field& m_field;
  const Triangle_surface& m_surface;
  const Cut_graph& m_cut;
  double m_edge_length;
  Jump_field m_jump_field;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_ROSETTES_H
