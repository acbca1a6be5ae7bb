// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SPARSE_CHOLESKY_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SPARSE_CHOLESKY_H

#include <Eigen/SparseCore>

#ifdef CGAL_USE_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The direct solver of sparse systems of equations, whose matrices are symmetric and positive
// definite; it reads their lower triangles. Who needs the factor itself takes Eigen's.
#ifdef CGAL_USE_CHOLMOD
template <class Number>
class Sparse_cholesky : public Eigen::CholmodDecomposition<Eigen::SparseMatrix<Number>>
{
public:
  using Matrix = Eigen::SparseMatrix<Number>;
  using Base = Eigen::CholmodDecomposition<Matrix>;

  Sparse_cholesky() { this->cholmod().print = 0; } // who asks for `info()` tells what is wrong
  explicit Sparse_cholesky(const Matrix& matrix) : Sparse_cholesky() { compute(matrix); }

  void compute(const Matrix& matrix)
  {
    this->analyzePattern(matrix);
    factorize(matrix);
  }

  // Matrices that are positive definite up to rounding only have no factors L L', which CHOLMOD
  // takes for large ones, but L D L'.
  void factorize(const Matrix& matrix)
  {
    Base::factorize(matrix);
    if (this->info() == Eigen::Success)
      return;
    this->setMode(Eigen::CholmodLDLt);
    this->analyzePattern(matrix);
    Base::factorize(matrix);
  }
};
#else
template <class Number>
using Sparse_cholesky = Eigen::SimplicialLDLT<Eigen::SparseMatrix<Number>>;
#endif

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SPARSE_CHOLESKY_H
