// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SPRING_SOLVER_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SPRING_SOLVER_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/field/Cross_springs.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Finds the angles that minimise the energy of some of the springs, for given period jumps. The
// jumps are no part of the matrix: it is factorized once for any number of them.
class Spring_solver
{
public:
  explicit Spring_solver(const Cross_springs& springs)
    : m_springs(springs), m_unknown(springs.number_of_faces(), -1)
  {
    for (int f = 0; f < springs.number_of_faces(); ++f)
      if (!springs.is_fixed(f)) {
        m_unknown[f] = int(m_free_faces.size());
        m_free_faces.push_back(f);
      }
  }

  // prepares for the springs that are `active`, which must hold every face
  void factorize(const std::vector<char>& active)
  {
    m_active = active;
    if (m_free_faces.empty())
      return;
    const Matrix matrix = assemble();
    if (!m_is_analyzed)
      m_solver.analyzePattern(matrix);
    m_is_analyzed = true;
    m_solver.factorize(matrix);
    if (m_solver.info() != Eigen::Success)
      throw Stage_failure("compute_cross_field: the matrix of the springs cannot be factorized");
    m_diagonal = m_solver.vectorD();
    m_load.assign(m_free_faces.size(), 0);
    m_is_on_path.assign(m_free_faces.size(), 0);
  }

  // moves the angles to where the energy of the active springs is least
  void solve(std::vector<double>& angles, const std::vector<int>& jumps) const
  {
    if (m_free_faces.empty())
      return;
    Eigen::VectorXd force = Eigen::VectorXd::Zero(m_free_faces.size());
    for (int s = 0; s < m_springs.number_of_springs(); ++s)
      if (m_active[s])
        add_force(force, s, m_springs.rotation(angles, jumps, s));
    const Eigen::VectorXd step = m_solver.solve(force);
    for (int i = 0; i < int(m_free_faces.size()); ++i)
      angles[m_free_faces[i]] += step[i];
  }

  // the effective resistance between the ends of spring s, b^T A^-1 b for the matrix A = L D L^T
  // and a unit of force b at either end. L^-1 b is 0 except on the paths in the elimination tree
  // from the ends to the root: so this takes much less time than a solution.
  double resistance(int s)
  {
    load(m_springs.from(s), 1);
    load(m_springs.to(s), -1);
    std::sort(m_path.begin(), m_path.end());
    double result = 0;
    for (const int row : m_path) {
      const double value = std::exchange(m_load[row], 0);
      result += value * value / m_diagonal[row];
      for (Matrix::InnerIterator entry(factor(), row); entry; ++entry)
        m_load[entry.row()] -= entry.value() * value;
      m_is_on_path[row] = 0;
    }
    m_path.clear();
    return result;
  }

private:
  using Matrix = Eigen::SparseMatrix<double>;
  using Entry = Eigen::Triplet<double>;

  int unknown(int f) const { return f == Cross_springs::ground ? -1 : m_unknown[f]; }

  // the factor L without its diagonal
  const Matrix& factor() const { return m_solver.matrixL().nestedExpression(); }

  // the parent of a row in the elimination tree, -1 for a root
  int parent(int row) const
  {
    const Matrix::InnerIterator first(factor(), row);
    return first ? int(first.row()) : -1;
  }

  // puts a force on face f, and the way from it to the root onto the path
  void load(int f, double force)
  {
    if (unknown(f) < 0)
      return;
    int row = m_solver.permutationP().indices()[unknown(f)];
    m_load[row] = force;
    for (; row >= 0 && !m_is_on_path[row]; row = parent(row)) {
      m_is_on_path[row] = 1;
      m_path.push_back(row);
    }
  }

  void add_force(Eigen::VectorXd& force, int s, double rotation) const
  {
    const int i = unknown(m_springs.from(s)), j = unknown(m_springs.to(s));
    if (i >= 0)
      force[i] += m_springs.weight(s) * rotation;
    if (j >= 0)
      force[j] -= m_springs.weight(s) * rotation;
  }

  // the lower triangle, with the same pattern whichever springs are active
  Matrix assemble() const
  {
    std::vector<Entry> entries;
    for (int s = 0; s < m_springs.number_of_springs(); ++s) {
      if (!m_springs.is_spring(s))
        continue;
      const double weight = m_active[s] ? m_springs.weight(s) : 0;
      const int i = unknown(m_springs.from(s)), j = unknown(m_springs.to(s));
      for (const int k : {i, j})
        if (k >= 0)
          entries.emplace_back(k, k, weight);
      if (i >= 0 && j >= 0)
        entries.emplace_back((std::max)(i, j), (std::min)(i, j), -weight);
    }
    Matrix matrix(m_free_faces.size(), m_free_faces.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  const Cross_springs& m_springs;
  std::vector<char> m_active;
  std::vector<int> m_unknown, m_free_faces;
  bool m_is_analyzed = false;
  Eigen::SimplicialLDLT<Matrix> m_solver;
  Eigen::VectorXd m_diagonal; // the matrix D
  std::vector<double> m_load; // per row of the factor, 0 but within resistance(); so is this:
  std::vector<char> m_is_on_path;
  std::vector<int> m_path; // rows
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SPRING_SOLVER_H
