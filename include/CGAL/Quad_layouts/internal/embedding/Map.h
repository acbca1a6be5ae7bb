// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MAP_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MAP_H

#include <CGAL/Quad_layouts/internal/embedding/Curve_mesh.h>
#include <CGAL/Quad_layouts/internal/embedding/Layout_squares.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A map of triangles to the plane, by charts: the unknowns are the coordinates of each vertex in a
// chart of its own; `chart` of a corner leads from there to the chart of its face.
//
// Vertices on fixed curves move along one axis of their charts, the line that the curve is mapped
// to.
struct Map
{
  enum Freedom : char { FREE, ALONG_X, ALONG_Y };
  enum Side : char { PLAIN, FIXED, BORDER }; // no face is behind the last ones

  struct Face
  {
    std::array<int, 3> vertex;
    std::array<Chart_change, 3> chart;
    std::array<int, 3>
        curve; // per side, that from corner k to k + 1 first: what it runs along, or -1
    std::array<Side, 3> side;

    int corner_of(int v) const { return vertex[0] == v ? 0 : vertex[1] == v ? 1 : 2; }
    bool has(int v) const { return vertex[0] == v || vertex[1] == v || vertex[2] == v; }
  };

  std::vector<Point> points; // per vertex, on the surface, in units of the edges of the quad mesh
  std::vector<Face> faces;
  std::vector<Point2> coordinates; // per vertex, in its own chart
  std::vector<Freedom> freedom;    // per vertex
  double spacing = 0;              // of the grid of all coordinates, a power of two, if there is one

  Point2 corner(const Face& f, int k) const { return f.chart[k](coordinates[f.vertex[k]]); }

  std::array<Point2, 3> corners(const Face& f) const
  {
    return {corner(f, 0), corner(f, 1), corner(f, 2)};
  }
};

// twice the signed area of the triangle (a, b, p): positive if p is to the left of the line from a to
// b; the sign is exact on a grid that all charts express exactly
inline double side(const Point2& a, const Point2& b, const Point2& p)
{
  return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
}

inline bool is_positive(const std::array<Point2, 3>& corners)
{
  return side(corners[0], corners[1], corners[2]) > 0;
}

// the nearest point whose coordinates are multiples of `spacing`, or the same point if that is zero
inline Point2 on_grid(const Point2& x, double spacing)
{
  return spacing > 0 ? Point2(spacing * (x / spacing).array().round()) : x;
}

// Rounds all coordinates to a grid so coarse that all charts express them exactly, though these may
// become several times larger: they are integers of 48 bits, of 53 that a double has. Then
// differences of corners are exact, too, and a triangle is positive if its determinant, rounded, is.
inline void put_on_grid(Map& map)
{
  double largest = 1;
  for (const Map::Face& f : map.faces)
    for (const Point2& x : map.corners(f))
      largest = (std::max)(largest, x.lpNorm<Eigen::Infinity>());
  map.spacing = std::exp2(std::ceil(std::log2(largest)) - 48);
  for (Point2& x : map.coordinates)
    x = on_grid(x, map.spacing);
}

// lists the faces at each vertex
inline std::vector<std::vector<int>> stars(const Map& map)
{
  std::vector<std::vector<int>> result(map.points.size());
  for (std::size_t f = 0; f < map.faces.size(); ++f)
    for (const int v : map.faces[f].vertex)
      result[v].push_back(int(f));
  return result;
}

// The map of a mesh on which a layout is drawn, without coordinates: the chart of a face is that of
// the layout face in which it lies, so charts change along the curves. The chart of a vertex is
// that of one of its faces; about a cone the vertex is at the origin of its own chart.
inline Map make_map(const Curve_mesh& mesh, const Layout_squares& squares,
                    const std::vector<char>& is_cone, double unit)
{
  Map map;
  map.coordinates.assign(mesh.points.size(), Point2(0, 0));
  map.freedom.assign(mesh.points.size(), Map::FREE);
  for (const Point& p : mesh.points)
    map.points.push_back(p / unit);
  for (const auto& t : mesh.triangles())
    map.faces.push_back({t, {}, {-1, -1, -1}, {Map::PLAIN, Map::PLAIN, Map::PLAIN}});
  const auto is_on_curve = [&](int h) { return mesh.curve[h] >= 0; };
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    map.faces[h / 3].curve[h % 3] = mesh.curve[h];
    map.faces[h / 3].side[h % 3] = mesh.opposite(h) < 0 ? Map::BORDER
                                   : mesh.is_fixed[h]   ? Map::FIXED
                                                        : Map::PLAIN;
  }
  for (int v = 0; v < int(mesh.points.size()); ++v) {
    std::vector<int> around = mesh.outgoing(v);
    if (is_cone[v]) // where curves begin, their squares tell the place
      std::rotate(around.begin(), std::find_if(around.begin(), around.end(), is_on_curve),
                  around.end());
    Chart_change chart;
    for (const int h : around) {
      if (is_cone[v] && is_on_curve(h))
        chart.translation = squares.point(mesh.curve[h], 0);
      map.faces[h / 3].chart[h % 3] = chart;
      if (mesh.is_fixed[h] && !is_cone[v])
        map.freedom[v] = (squares.direction(mesh.curve[h]) - chart.quarter_turns) % 2 == 0
                             ? Map::ALONG_X
                             : Map::ALONG_Y;
      chart = squares.across(mesh.curve[Curve_mesh::prev(h)]).after(chart);
    }
    CGAL_assertion_code(const bool on_border = !around.empty() &&
                                               mesh.opposite(around.front()) < 0);
    CGAL_assertion(is_cone[v] || on_border ||
                   (chart.quarter_turns == 0 && chart.translation.isZero(0)));
  }
  return map;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MAP_H
