// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/parameters.h>
#ifdef CGAL_USE_CBC
#include <CGAL/Quad_layouts/CBC_mixed_integer_program_traits.h>
#endif
#ifdef CGAL_USE_HIGHS
#include <CGAL/Quad_layouts/HiGHS_mixed_integer_program_traits.h>
#endif
#ifdef CGAL_USE_CHOLMOD
#include <CGAL/Quad_layouts/internal/Sparse_cholesky.h>
#endif

namespace QL = CGAL::Quad_layouts;

template <class Traits>
[[maybe_unused]] bool solves()
{
  Traits program;
  program.create_variable(CGAL::Variable<double>::INTEGER, 0, 1);
  program.create_objective();
  return program.solve();
}

#ifdef CGAL_USE_CHOLMOD
bool solves_equations()
{
  Eigen::SparseMatrix<double> matrix(2, 2);
  matrix.insert(0, 0) = 2;
  matrix.insert(1, 0) = 1; // the lower triangle is enough
  matrix.insert(1, 1) = 2;
  const Eigen::VectorXd x = QL::internal::Sparse_cholesky<double>(matrix).solve(
      Eigen::Vector2d(4, 5));
  return (x - Eigen::Vector2d(1, 2)).norm() < 1e-12;
}

// one that has a negative eigenvalue, as positive ones can get by rounding
bool solves_indefinite_equations()
{
  Eigen::SparseMatrix<double> matrix(2, 2);
  matrix.insert(0, 0) = 1;
  matrix.insert(1, 1) = -1;
  QL::internal::Sparse_cholesky<double> solver;
  solver.setMode(Eigen::CholmodSupernodalLLt);
  solver.compute(matrix);
  const Eigen::VectorXd x = solver.solve(Eigen::Vector2d(1, 2));
  return (x - Eigen::Vector2d(1, -2)).norm() < 1e-12;
}
#endif

int main()
{
#ifdef CGAL_USE_CBC
  if (!solves<QL::CBC_mixed_integer_program_traits<double>>())
    return 1;
#endif
#ifdef CGAL_USE_HIGHS
  if (!solves<QL::HiGHS_mixed_integer_program_traits<double>>())
    return 1;
#endif
#ifdef CGAL_USE_CHOLMOD
  if (!solves_equations() || !solves_indefinite_equations())
    return 1;
#endif
  const QL::Quad_layout layout;
  return layout.number_of_irregular_vertices();
}
