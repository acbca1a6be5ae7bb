// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_PLACE_SEARCH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_PLACE_SEARCH_H

#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_shape.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Quads_on_surface.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Star.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Searches for better places of single vertices of a quad mesh by trial. This also helps where
// quads are not small compared to features of the surface, so that neither its normals at their
// corners nor derivatives tell the way.
class Place_search
{
public:
  using Vector = Eigen::Vector3d;

  explicit Place_search(Quads_on_surface& quads) : m_quads(quads) {}

  // searches for all vertices of a region
  void improve(const std::vector<int>& region)
  {
    constexpr int rounds = 2;
    for (int i = 0; i < rounds; ++i)
      for (const double fraction : {0.5, 0.25, 0.125, 0.0625})
        for (const int v : region)
          search_around(v, fraction);
  }

private:
  // moves v to the best of the places that it gets to by some steps, to a fraction of each
  void search_around(int v, double fraction)
  {
    const Surface_walk::Place start = m_quads.place(v);
    const double squared_unit = CGAL::square(m_quads.edge_length(v));
    Surface_walk::Place best = start;
    double least = energy(v, start.point, squared_unit, (std::numeric_limits<double>::infinity)());
    for_each_step(v, [&](const Vector& step) {
      const auto place = m_quads.reached(v, start.point + fraction * step);
      if (!m_quads.is_permitted(v, place))
        return;
      const double e = energy(v, place.point, squared_unit, least);
      if (e < least) {
        least = e;
        best = place;
      }
    });
    if (least < (std::numeric_limits<double>::infinity)())
      m_quads.move(v, best);
  }

  // Visits steps as long as an edge, along the surface or into it, which leads around the edges of
  // thin parts; then those to the other corners of the quads of v, and away from them, which fit
  // slim quads.
  template <class Visit>
  void for_each_step(int v, const Visit& visit) const
  {
    const Vector inwards = -m_quads.normal(v);
    const Vector t1 = inwards.unitOrthogonal(), t2 = inwards.cross(t1);
    const double length = m_quads.edge_length(v);
    for (int k = 0; k < 16; ++k) {
      const double angle = k * CGAL_PI / 4;
      const Vector along = std::cos(angle) * t1 + std::sin(angle) * t2;
      const Vector direction = k < 8 ? along : Vector((along + inwards) * std::sqrt(0.5));
      visit(Vector(length * direction));
    }
    const Polygons& mesh = m_quads.mesh();
    const Vector start = mesh.points[v];
    for (const int h : m_quads.corners(v))
      for (const int u : {mesh.target(h), mesh.target(mesh.next(h))}) {
        const Vector step = mesh.points[u] - start;
        visit(step);
        visit(Vector(-step));
      }
  }

  // The energy of the quads around v if v were at x; something above `limit` if it exceeds that.
  // Quads count with the least that their energy can be until the nearest triangles, which take
  // time to find, must be known.
  double energy(int v, const Vector& x, double squared_unit, double limit)
  {
    constexpr double stiffness = 0.05;
    const Polygons& mesh = m_quads.mesh();
    m_candidates.clear();
    double sum = 0;
    for (const int h : m_quads.corners(v)) {
      const int g = mesh.next(h);
      const Quad quad = {x, mesh.points[mesh.source[g]], mesh.points[mesh.target(g)],
                         mesh.points[mesh.source[mesh.prev(h)]]};
      m_candidates.push_back({quad, least_shape_energy(quad)});
      sum += spring_energy((quad[1] - x).squaredNorm() / squared_unit, stiffness) +
             m_candidates.back().least_energy;
    }
    for (const Candidate& c : m_candidates) {
      if (sum > limit)
        break;
      sum += shape_energy(c.quad, m_quads.surface_normal(c.quad, v)) - c.least_energy;
    }
    return sum;
  }

  // a quad at a vertex that might move
  struct Candidate
  {
    Quad quad;
    double least_energy;
  };

  std::vector<Candidate> m_candidates; // of the latest `energy`
  Quads_on_surface& m_quads;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_PLACE_SEARCH_H
