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
  Sparse_cholesky() { this->cholmod().print = 0; } // who asks for `info()` tells what is wrong
  explicit Sparse_cholesky(const Eigen::SparseMatrix<Number>& matrix) : Sparse_cholesky()
  {
    this->compute(matrix);
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
