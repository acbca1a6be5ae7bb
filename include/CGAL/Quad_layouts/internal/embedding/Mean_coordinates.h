// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MEAN_COORDINATES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MEAN_COORDINATES_H

#include <CGAL/Quad_layouts/internal/Sparse_cholesky.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Places points of the plane such that each is the mean of its neighbours, of which some are given.
class Mean_coordinates
{
public:
  explicit Mean_coordinates(int number_of_points)
    : m_rhs(Eigen::MatrixXd::Zero(number_of_points, 2))
  {
  }

  // makes j a neighbour of i
  void add_neighbour(int i, int j)
  {
    m_entries.emplace_back(i, i, 1.);
    m_entries.emplace_back(i, j, -1.);
  }
  // makes a given point a neighbour of i
  void add_neighbour(int i, const Point2& given)
  {
    m_entries.emplace_back(i, i, 1.);
    m_rhs.row(i) += given.transpose();
  }

  std::vector<Point2> solve() const
  {
    const Eigen::Index n = m_rhs.rows();
    Eigen::SparseMatrix<double> laplacian(n, n);
    laplacian.setFromTriplets(m_entries.begin(), m_entries.end());
    const Eigen::MatrixXd x = Sparse_cholesky<double>(laplacian).solve(m_rhs);
    std::vector<Point2> result;
    for (Eigen::Index i = 0; i < n; ++i)
      result.push_back(x.row(i).transpose());
    return result;
  }

private:
  std::vector<Eigen::Triplet<double>> m_entries;
  Eigen::MatrixXd m_rhs;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_MEAN_COORDINATES_H
