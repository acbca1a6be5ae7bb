// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MAP_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MAP_H

#include <CGAL/Quad_layouts/internal/embedding/Charted_mesh.h>
#include <CGAL/Quad_layouts/internal/field/matching.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A map of triangles to the plane, by charts: the unknowns are the coordinates of each vertex in a
// chart of its own; `chart` of a corner leads from there to the chart of its face.
struct Map
{
  struct Face
  {
    std::array<int, 3> vertex;
    std::array<Chart_change, 3> chart;

    int corner_of(int v) const { return vertex[0] == v ? 0 : vertex[1] == v ? 1 : 2; }
    bool has(int v) const { return vertex[0] == v || vertex[1] == v || vertex[2] == v; }
  };

  std::vector<Point> points; // per vertex, on the surface, in units of the edges of the quad mesh
  std::vector<Face> faces;
  std::vector<Point2> coordinates; // per vertex, in its own chart
  std::vector<Point> direction;    // per vertex, where +x of its chart should point

  Point2 corner(const Face& f, int k) const { return f.chart[k](coordinates[f.vertex[k]]); }

  std::array<Point2, 3> corners(const Face& f) const
  {
    return {corner(f, 0), corner(f, 1), corner(f, 2)};
  }
};

// The shape of a triangle on the surface, as needed to measure how a map distorts it.
struct Rest_shape
{
  Eigen::Matrix2d
      inverse; // of the matrix of its edges from corner 0, in a frame with x along its first edge
  double area;

  Rest_shape(const Point& p, const Point& q, const Point& r)
  {
    const Point a = q - p, b = r - p;
    const double length = a.norm(), height = a.cross(b).norm() / length;
    Eigen::Matrix2d edges;
    edges << length, a.dot(b) / length, 0, height;
    inverse = edges.inverse();
    area = length * height / 2;
  }

  Eigen::Matrix2d jacobian(const std::array<Point2, 3>& corners) const
  {
    Eigen::Matrix2d image;
    image << corners[1] - corners[0], corners[2] - corners[0];
    return image * inverse;
  }
};

inline Rest_shape rest_shape(const Map& map, const Map::Face& f)
{
  return Rest_shape(map.points[f.vertex[0]], map.points[f.vertex[1]], map.points[f.vertex[2]]);
}

// Lists the charts of the corners of a charted mesh: the chart of a vertex is that of one of its
// faces; about a cone the vertex is at the origin of its own chart.
inline Map make_map(const Charted_mesh& mesh, const std::vector<char>& is_cone, double unit)
{
  Map map;
  map.coordinates.assign(mesh.points.size(), Point2(0, 0));
  map.direction.assign(mesh.points.size(), Point(0, 0, 0));
  for (const Point& p : mesh.points)
    map.points.push_back(p / unit);
  for (const auto& t : mesh.triangles())
    map.faces.push_back({t, {}});
  for (int v = 0; v < int(mesh.points.size()); ++v) {
    Chart_change chart;
    for (const int h : mesh.outgoing(v)) {
      if (is_cone[v])
        chart.translation = mesh.cone_position[h];
      map.faces[h / 3].chart[h % 3] = chart;
      map.direction[v] += Eigen::AngleAxisd(chart.quarter_turns * right_angle, mesh.normal(h / 3)) *
                          mesh.direction[h / 3];
      chart = mesh.transition[Charted_mesh::prev(h)].after(chart);
    }
    CGAL_assertion(is_cone[v] || (chart.quarter_turns == 0 && chart.translation.isZero(0)));
  }
  return map;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MAP_H
