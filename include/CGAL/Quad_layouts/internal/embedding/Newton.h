// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_NEWTON_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_NEWTON_H

#include <CGAL/Quad_layouts/internal/Sparse_cholesky.h>
#include <CGAL/Quad_layouts/internal/embedding/Distortion.h>
#include <CGAL/Quad_layouts/internal/embedding/Map.h>
#include <CGAL/Quad_layouts/internal/embedding/Rest_shape.h>
#include <CGAL/Quad_layouts/internal/embedding/first_loss_of_area.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Minimizes the distortion of a map without inverted triangles, over the coordinates of the
// vertices that are free. `Measure` is `Distortion`, or a function of it.
template <class Measure>
class Newton
{
public:
  // vertices without faces are not free
  Newton(Map& map, const std::vector<char>& is_fixed, const Likeness& likeness = {})
    : m_map(map), m_unknown(map.points.size(), -1)
  {
    for (const Map::Face& f : map.faces) {
      m_rest.emplace_back(map.points[f.vertex[0]], map.points[f.vertex[1]], map.points[f.vertex[2]],
                          likeness.aspect);
      for (const int v : f.vertex)
        if (!is_fixed[v] && m_unknown[v] < 0) {
          m_unknown[v] = m_number_of_unknowns++;
          m_is_locked.push_back(map.freedom[v] == Map::ALONG_Y);
          m_is_locked.push_back(map.freedom[v] == Map::ALONG_X);
        }
    }
    even_out(m_rest, likeness.evenness, [](Rest_shape& r) -> Rest_shape& { return r; });
  }

  Eigen::Matrix2d jacobian(std::size_t f) const
  {
    return m_rest[f].jacobian(m_map.corners(m_map.faces[f]));
  }

  // the distortion of all triangles, weighted by area; infinite if one is inverted, which is exact
  // on the grid
  double value() const
  {
    double sum = 0;
    for (std::size_t f = 0; f < m_map.faces.size(); ++f) {
      const std::array<Point2, 3> corners = m_map.corners(m_map.faces[f]);
      if (!is_positive(corners))
        return (std::numeric_limits<double>::infinity)();
      sum += m_rest[f].area * Measure::value(m_rest[f].jacobian(corners));
    }
    return sum;
  }

  // solves for the minimum of the quadratic model and goes there, or less far if the distortion
  // would not fall; returns the distortion that is reached, `before` (the present one) if no step
  // helps
  double step(double before)
  {
    assemble();
    if (!m_is_analyzed)
      m_solver.analyzePattern(m_hessian);
    m_is_analyzed = true;
    m_solver.factorize(m_hessian);
    if (m_solver.info() != Eigen::Success)
      return before;
    const Eigen::VectorXd move = m_solver.solve(-m_gradient);
    const std::vector<Point2> start = m_map.coordinates;
    for (double length = longest_step(move); length > 1e-6; length /= 2) {
      go(start, move, length);
      const double after = value();
      if (after < before)
        return after;
    }
    m_map.coordinates = start;
    return before;
  }

private:
  // Steps end before the first triangle loses its area (Smith and Schaefer 2015): beyond, all could
  // be positive again, but wind about a vertex twice.
  double longest_step(const Eigen::VectorXd& move) const
  {
    double longest = 1;
    for (const Map::Face& face : m_map.faces) {
      const std::array<Point2, 3> x = m_map.corners(face);
      std::array<Point2, 3> d;
      for (int k = 0; k < 3; ++k)
        d[k] = Chart_change::turned(move_of(face.vertex[k], move), face.chart[k].quarter_turns);
      longest = (std::min)(longest, 0.9 * first_loss_of_area(x, d));
    }
    return longest;
  }

  void assemble()
  {
    const int n = 2 * m_number_of_unknowns;
    m_gradient = Eigen::VectorXd::Zero(n);
    m_entries.clear();
    for (int i = 0; i < n; ++i)
      m_entries.emplace_back(i, i, m_is_locked[i] ? 1 : 1e-10);
    for (std::size_t f = 0; f < m_map.faces.size(); ++f)
      add_face(f);
    for (int i = 0; i < n; ++i)
      if (m_is_locked[i])
        m_gradient[i] = 0;
    m_hessian.resize(n, n);
    m_hessian.setFromTriplets(m_entries.begin(), m_entries.end());
  }

  // The derivatives by the Jacobian turn into derivatives by the three corners, each turned into
  // the chart of its vertex: a corner contributes to J its coordinates times a row vector, its
  // weight.
  void add_face(std::size_t f)
  {
    const Map::Face& face = m_map.faces[f];
    Eigen::Vector4d gradient;
    Eigen::Matrix4d hessian;
    Measure::derivatives(jacobian(f), gradient, hessian);
    Distortion::make_positive(hessian);
    const Eigen::Matrix2d& b = m_rest[f].inverse;
    const std::array<Point2, 3> weight{Point2(-b.colwise().sum().transpose()),
                                       Point2(b.row(0).transpose()), Point2(b.row(1).transpose())};
    for (int k = 0; k < 3; ++k) {
      const int row = m_unknown[face.vertex[k]];
      if (row < 0)
        continue;
      const Point2 g = weight[k].x() * gradient.head<2>() + weight[k].y() * gradient.tail<2>();
      m_gradient.segment<2>(2 * row) += m_rest[f].area *
                                        Chart_change::turned(g, 4 - face.chart[k].quarter_turns);
      for (int l = 0; l < 3; ++l)
        if (const int column = m_unknown[face.vertex[l]]; column >= 0 && column <= row)
          add_block(2 * row, 2 * column, m_rest[f].area * block(hessian, weight[k], weight[l]),
                    face.chart[k].quarter_turns, face.chart[l].quarter_turns);
    }
  }

  static Eigen::Matrix2d block(const Eigen::Matrix4d& h, const Point2& v, const Point2& w)
  {
    return v.x() * w.x() * h.topLeftCorner<2, 2>() + v.x() * w.y() * h.topRightCorner<2, 2>() +
           v.y() * w.x() * h.bottomLeftCorner<2, 2>() + v.y() * w.y() * h.bottomRightCorner<2, 2>();
  }

  static Eigen::Matrix2d rotation(int quarter_turns)
  {
    Eigen::Matrix2d r;
    r << Chart_change::turned(Point2(1, 0), quarter_turns),
        Chart_change::turned(Point2(0, 1), quarter_turns);
    return r;
  }

  void add_block(int row, int column, const Eigen::Matrix2d& b, int row_turns, int column_turns)
  {
    const Eigen::Matrix2d turned = rotation(row_turns).transpose() * b * rotation(column_turns);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        if (!m_is_locked[row + i] && !m_is_locked[column + j])
          m_entries.emplace_back(row + i, column + j, turned(i, j));
  }

  Point2 move_of(int v, const Eigen::VectorXd& move) const
  {
    return m_unknown[v] < 0 ? Point2(0, 0) : Point2(move.segment<2>(2 * m_unknown[v]));
  }

  void go(const std::vector<Point2>& start, const Eigen::VectorXd& move, double length)
  {
    for (std::size_t v = 0; v < m_unknown.size(); ++v)
      m_map.coordinates[v] = on_grid(start[v] + length * move_of(int(v), move), m_map.spacing);
  }

  Map& m_map;
  std::vector<int> m_unknown; // per vertex, -1 if fixed
  int m_number_of_unknowns = 0;
  std::vector<char> m_is_locked; // per coordinate of the unknowns: whether it does not change
  std::vector<Rest_shape> m_rest;
  Eigen::VectorXd m_gradient;
  Eigen::SparseMatrix<double> m_hessian; // its lower half
  std::vector<Eigen::Triplet<double>> m_entries;
  Sparse_cholesky<double> m_solver;
  bool m_is_analyzed = false;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_NEWTON_H
