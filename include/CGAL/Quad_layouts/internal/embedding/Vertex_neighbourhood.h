// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_VERTEX_NEIGHBOURHOOD_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_VERTEX_NEIGHBOURHOOD_H

#include <CGAL/Quad_layouts/internal/embedding/Distortion.h>
#include <CGAL/Quad_layouts/internal/embedding/Map.h>
#include <CGAL/Quad_layouts/internal/embedding/Rest_shape.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// One vertex of a map and the triangles around it, all in the chart of the vertex. `Measure` is as
// for `Newton`.
template <class Measure>
class Vertex_neighbourhood
{
public:
  Vertex_neighbourhood(const Map& map, int v, const std::vector<int>& star,
                       const Likeness& likeness = {})
    : m_freedom(map.freedom[v]), m_spacing(map.spacing)
  {
    for (const int f : star) {
      const Map::Face& face = map.faces[f];
      const int k = face.corner_of(v), a = (k + 1) % 3, b = (k + 2) % 3;
      const Chart_change to_vertex = face.chart[k].inverse();
      if (face.side[k] != Map::PLAIN)
        m_on_curve.push_back(to_vertex(map.corner(face, a)));
      if (face.side[b] == Map::BORDER)
        m_on_curve.push_back(to_vertex(map.corner(face, b)));
      m_triangles.push_back({to_vertex(map.corner(face, a)), to_vertex(map.corner(face, b)),
                             Rest_shape(map.points[v], map.points[face.vertex[a]],
                                        map.points[face.vertex[b]], likeness.aspect)});
    }
    even_out(m_triangles, likeness.evenness, [](Triangle& t) -> Rest_shape& { return t.rest; });
  }

  // Finds a point from which all opposite edges are seen from their left: the centroid of the
  // kernel of the polygon that they form. Returns false if the kernel is empty. On a fixed
  // curve it is the middle of what the kernel has of the curve.
  bool find_center(Point2& center) const
  {
    if (m_freedom != Map::FREE)
      return find_center_on_curve(center);
    std::vector<Point2> kernel = bounding_box();
    for (const Triangle& t : m_triangles)
      kernel = left_part(kernel, t.a, t.b);
    if (kernel.size() < 3)
      return false;
    center = on_grid(centroid(kernel), m_spacing);
    return value(center) < (std::numeric_limits<double>::infinity)();
  }

  // Moves `x` downhill by one Newton step of the measure, which is convex in a single vertex. Returns
  // to which part of it the measure fell.
  double improve(Point2& x) const
  {
    Point2 gradient(0, 0);
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
    for (const Triangle& t : m_triangles)
      add_derivatives(t, x, gradient, hessian);
    const Point2 move = m_freedom == Map::FREE      ? Point2(-hessian.inverse() * gradient)
                        : m_freedom == Map::ALONG_X ? Point2(-gradient.x() / hessian(0, 0), 0)
                                                    : Point2(0, -gradient.y() / hessian(1, 1));
    const double before = value(x);
    for (double length = 1; length > 1e-3; length /= 2) {
      const Point2 y = on_grid(x + length * move, m_spacing);
      const double after = value(y);
      if (after < before) {
        x = y;
        return after / before;
      }
    }
    return 1;
  }

private:
  struct Triangle
  {
    Point2 a, b; // the corners opposite the vertex
    Rest_shape rest;
    Eigen::Matrix2d jacobian(const Point2& x) const { return rest.jacobian({x, a, b}); }
  };

  bool find_center_on_curve(Point2& center) const
  {
    CGAL_assertion(m_on_curve.size() == 2);
    const Point2 &p = m_on_curve[0], &q = m_on_curve[1];
    double low = 0, high = 1;
    for (const Triangle& t : m_triangles) {
      const double at_p = side(t.a, t.b, p), at_q = side(t.a, t.b, q);
      if (at_p < 0 && at_q <= 0)
        return false;
      if (at_p < 0)
        low = (std::max)(low, at_p / (at_p - at_q));
      if (at_q < 0)
        high = (std::min)(high, at_p / (at_p - at_q));
    }
    center = on_grid(p + (low + high) / 2 * (q - p), m_spacing);
    const int locked = m_freedom == Map::ALONG_X ? 1 : 0;
    center[locked] = p[locked];
    return low < high && value(center) < (std::numeric_limits<double>::infinity)();
  }

  // the measure if the vertex is at x, infinite if a triangle is inverted; that is exact on the
  // grid
  double value(const Point2& x) const
  {
    double sum = 0;
    for (const Triangle& t : m_triangles)
      sum += side(t.a, t.b, x) > 0 ? t.rest.area * Measure::value(t.jacobian(x))
                                   : (std::numeric_limits<double>::infinity)();
    return sum;
  }

  static void add_derivatives(const Triangle& t, const Point2& x, Point2& gradient,
                              Eigen::Matrix2d& hessian)
  {
    Eigen::Vector4d g;
    Eigen::Matrix4d h;
    Measure::derivatives(t.jacobian(x), g, h);
    Eigen::Matrix<double, 4, 2> by_vertex;
    const Eigen::RowVector2d weight = -t.rest.inverse.colwise().sum();
    by_vertex << weight.x() * Eigen::Matrix2d::Identity(), weight.y() * Eigen::Matrix2d::Identity();
    gradient += t.rest.area * by_vertex.transpose() * g;
    hessian += t.rest.area * by_vertex.transpose() * h * by_vertex;
  }

  std::vector<Point2> bounding_box() const
  {
    Point2 low = m_triangles.front().a, high = low;
    for (const Triangle& t : m_triangles) {
      low = low.cwiseMin(t.a);
      high = high.cwiseMax(t.a);
    }
    return {low, Point2(high.x(), low.y()), high, Point2(low.x(), high.y())};
  }

  // clips a convex polygon to the left of the line from a to b
  static std::vector<Point2> left_part(const std::vector<Point2>& polygon, const Point2& a,
                                       const Point2& b)
  {
    std::vector<Point2> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double sp = side(a, b, p), sq = side(a, b, q);
      if (sp >= 0)
        result.push_back(p);
      if ((sp > 0 && sq < 0) || (sp < 0 && sq > 0))
        result.push_back(p + sp / (sp - sq) * (q - p));
    }
    return result;
  }

  static Point2 centroid(const std::vector<Point2>& polygon)
  {
    Point2 sum(0, 0), mean(0, 0);
    double area = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      const double a = side(polygon[0], polygon[i], polygon[i + 1]);
      area += a;
      sum += a / 3 * (polygon[0] + polygon[i] + polygon[i + 1]);
    }
    for (const Point2& p : polygon)
      mean += p / double(polygon.size());
    return area > 0 ? Point2(sum / area) : mean;
  }

  std::vector<Triangle> m_triangles;
  Map::Freedom m_freedom;
  double m_spacing;
  std::vector<Point2> m_on_curve; // the neighbours on the fixed curve
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_VERTEX_NEIGHBOURHOOD_H
