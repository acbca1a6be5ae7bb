// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_REDUCED_NEWTON_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_REDUCED_NEWTON_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/Sparse_cholesky.h>
#include <CGAL/Quad_layouts/internal/parametrization/Aligned_energy.h>
#include <CGAL/Quad_layouts/internal/parametrization/Seam_constraints.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Minimizes an energy of the wedges over the free unknowns y on which all depend by x = N y:
// whatever it does, the map stays seamless.
class Reduced_newton
{
public:
  Reduced_newton(const Seam_constraints& seams, Aligned_energy& energy)
    : m_energy(energy), m_x(Eigen::VectorXd::Zero(seams.number_of_unknowns()))
  {
    const Linear_relations& relations = seams.relations();
    std::vector<int> column(seams.number_of_unknowns(), -1);
    for (int i = 0; i < seams.number_of_unknowns(); ++i)
      if (relations.is_free(i)) {
        column[i] = int(m_free.size());
        m_free.push_back(i);
      }
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < seams.number_of_unknowns(); ++i)
      if (relations.is_free(i))
        entries.emplace_back(i, column[i], 1);
      else
        for (const auto& term : relations.combination(i))
          entries.emplace_back(i, column[term.first], boost::rational_cast<double>(term.second));
    m_basis.resize(seams.number_of_unknowns(), m_free.size());
    m_basis.setFromTriplets(entries.begin(), entries.end());
  }

  const Eigen::VectorXd& coordinates() const { return m_x; }

  // finds the map of least energy without a barrier, by a linear system
  void align()
  {
    m_energy.set_barrier(0, 0);
    const Eigen::VectorXd move = direction();
    if (m_solver.info() != Eigen::Success || !move.allFinite())
      throw Stage_failure("parametrize_seamlessly: the system of equations cannot be solved");
    m_x += move;
  }

  // Turns inverted triangles back, as far as it can, and then improves the map, all triangles of
  // which stay positive. With the regularization going down as the worst triangle does, the energy
  // of that one becomes decisive (Garanzha et al. 2021). What stays inverted while the energy
  // hardly falls is folded such that no small move unfolds it.
  void untangle(double barrier, int most_steps, const Monitor& monitor)
  {
    constexpr double converged = 1e-4, stuck = 1e-3; // relative decreases
    constexpr int patience = 10;
    for (int i = 0, idle = 0; i < most_steps && idle < patience; ++i) {
      const double least = m_energy.least_determinant(m_x);
      m_energy.set_barrier(barrier, least > 0 ? 0 : std::hypot(1e-6, 0.2 * least));
      monitor.report("parametrize_seamlessly", double(i) / most_steps);
      const double decrease = step(least > 0);
      if (m_solver.info() != Eigen::Success || (least > 0 && decrease < converged))
        return;
      idle = least <= 0 && decrease < stuck ? idle + 1 : 0;
    }
  }

private:
  // the step to the minimum of the quadratic model, unless the solver says that it finds none
  Eigen::VectorXd direction()
  {
    Eigen::VectorXd gradient;
    Eigen::SparseMatrix<double> hessian;
    m_energy.derivatives(m_x, gradient, hessian);
    const Eigen::SparseMatrix<double> reduced = m_basis.transpose() * (hessian * m_basis);
    if (!m_is_analyzed)
      m_solver.analyzePattern(reduced);
    m_is_analyzed = true;
    m_solver.factorize(reduced);
    if (m_solver.info() != Eigen::Success)
      return Eigen::VectorXd::Zero(m_x.size());
    return m_basis * m_solver.solve(-(m_basis.transpose() * gradient));
  }

  // Goes along the direction as far as the energy falls, and, if the triangles are positive, not to
  // where the first loses its area; returns by which part the energy fell. There is no direction
  // where triangles are so flat that numbers of the solver are too far apart.
  double step(bool is_positive)
  {
    const Eigen::VectorXd move = direction(), start = m_x;
    const double before = m_energy.value(start);
    double length = is_positive ? (std::min)(1., 0.9 * m_energy.longest_step(start, move)) : 1;
    for (; length > 1e-9; length /= 2) {
      m_x = start + length * move;
      const double after = m_energy.value(m_x);
      if (after < before)
        return (before - after) / before;
    }
    m_x = start;
    return 0;
  }

  Aligned_energy& m_energy;
  std::vector<int> m_free;             // the free unknowns
  Eigen::SparseMatrix<double> m_basis; // N
  Eigen::VectorXd m_x;
  Sparse_cholesky<double> m_solver;
  bool m_is_analyzed = false;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_REDUCED_NEWTON_H
