// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_ROSETTES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_ROSETTES_H

#include <CGAL/Quad_layouts/internal/embedding/Map.h>
#include <CGAL/Quad_layouts/internal/embedding/refine_around_cones.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// the angle in the frame of a face (x along its first edge) of the direction in which +x of its
// chart should point
inline double target_angle(const Map& map, const Map::Face& f)
{
  const Point &p = map.points[f.vertex[0]], &q = map.points[f.vertex[1]],
              &r = map.points[f.vertex[2]];
  const Point normal = (q - p).cross(r - p).normalized(), x = (q - p).normalized();
  Point sum(0, 0, 0);
  for (int k = 0; k < 3; ++k)
    sum += Eigen::AngleAxisd(-f.chart[k].quarter_turns * right_angle, normal) *
           map.direction[f.vertex[k]];
  return std::atan2(normal.cross(x).dot(sum), x.dot(sum));
}

// The faces around a cone in counter-clockwise order, with the angle that each spans, on the
// surface and in the map, and how its chart is turned against that of the first one.
class Fan
{
public:
  struct Sector
  {
    int face, corner; // the cone is corner `corner` of `face`
    double
        begin; // angle in the map at which the sector begins, from the beginning of the first one
    int turns; // of the chart against the first one, in quarter-turns
  };

  Fan(const Map& map, const std::vector<int>& star, const Cone& cone)
  {
    std::vector<double> angle;
    double total = 0;
    int face = star.front(), turns = 0;
    for (std::size_t i = 0; i < star.size(); ++i) {
      const int corner = map.faces[face].corner_of(cone.vertex);
      m_sectors.push_back({face, corner, 0., turns});
      angle.push_back(corner_angle(map, map.faces[face], corner));
      total += angle.back();
      const int spoke = map.faces[face].vertex[(corner + 2) % 3];
      const int following = face_with_first_spoke(map, star, cone.vertex, spoke);
      turns += chart_turns(map.faces[following], spoke) - chart_turns(map.faces[face], spoke);
      face = following;
    }
    // half by the angles on the surface, half uniformly, so that no sector gets too narrow
    const double span = (4 - cone.index) * right_angle;
    double begin = 0;
    for (std::size_t i = 0; i < m_sectors.size(); ++i) {
      m_sectors[i].begin = begin;
      begin += span / 2 * (angle[i] / total + 1. / double(m_sectors.size()));
    }
  }

  const std::vector<Sector>& sectors() const { return m_sectors; }

private:
  static double corner_angle(const Map& map, const Map::Face& f, int k)
  {
    const Point a = map.points[f.vertex[(k + 1) % 3]] - map.points[f.vertex[k]];
    const Point b = map.points[f.vertex[(k + 2) % 3]] - map.points[f.vertex[k]];
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  static int chart_turns(const Map::Face& f, int v)
  {
    return f.chart[f.corner_of(v)].quarter_turns;
  }

  static int face_with_first_spoke(const Map& map, const std::vector<int>& star, int center,
                                   int spoke)
  {
    return *std::find_if(star.begin(), star.end(), [&](int f) {
      return map.faces[f].vertex[(map.faces[f].corner_of(center) + 1) % 3] == spoke;
    });
  }

  std::vector<Sector> m_sectors;
};

// Puts the neighbours of a cone on a circle around it, evenly, in the phase that agrees best with
// the target directions.
//
// With the ring held there, triangles of positive area everywhere else force the right angle sum at
// every vertex (Gauss-Bonnet); with the cone alone held, its branch point could move off to a
// neighbour.
inline void place_ring(Map& map, const std::vector<int>& star, const Cone& cone, double radius)
{
  const Fan fan(map, star, cone);
  std::complex<double> phase = 0;
  for (const Fan::Sector& s : fan.sectors()) {
    const Map::Face& f = map.faces[s.face];
    const Point a = map.points[f.vertex[(s.corner + 1) % 3]] - map.points[f.vertex[s.corner]];
    const Point x = (map.points[f.vertex[1]] - map.points[f.vertex[0]]).normalized();
    const Point y = (map.points[f.vertex[1]] - map.points[f.vertex[0]])
                        .cross(map.points[f.vertex[2]] - map.points[f.vertex[0]])
                        .normalized()
                        .cross(x);
    const double in_chart = std::atan2(a.dot(y), a.dot(x)) - target_angle(map, f);
    phase += std::polar(1., in_chart - s.begin - s.turns * right_angle);
  }
  for (const Fan::Sector& s : fan.sectors()) {
    const Map::Face& f = map.faces[s.face];
    const int k = (s.corner + 1) % 3;
    const std::complex<double> spoke = std::polar(radius, std::arg(phase) + s.begin +
                                                              s.turns * right_angle);
    map.coordinates[f.vertex[k]] = f.chart[k].inverse()(map.corner(f, s.corner) +
                                                        Point2(spoke.real(), spoke.imag()));
  }
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_ROSETTES_H
