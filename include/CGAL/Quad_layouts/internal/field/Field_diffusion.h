// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_FIELD_DIFFUSION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_FIELD_DIFFUSION_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Sparse_cholesky.h>
#include <CGAL/Quad_layouts/internal/field/Face_connection.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

using Complex = std::complex<double>;

// Smooths a cross field by the diffusion of Merriman, Bence and Osher, as Viertel and Osting use
// it (2019).
//
// A cross with the angle theta is the number u = e^(4 i theta). The field minimises
//
//     sum over edges  w |u_g - e^(4 i transport) u_f|^2
//   + sum over faces  |q_f| |u_f - q_f / |q_f||^2
//
// for unit u, with pulls q towards a direction; it alternates an implicit Euler step of the
// gradient flow of this quadratic energy, (m + L + Q) u' = m u + q, and the projection of each u'
// to the unit circle.
//
// All faces have the same mass: a step diffuses over as many triangles everywhere, so that
// neither the scale of the mesh nor that of another component matters, and no needle spoils the
// condition. Faces with a fixed direction are no unknowns. The matrix stays the same, so it is
// factorized once.
class Field_diffusion
{
public:
  // takes the pull on each face and, where it is not 0, its fixed value; a step takes as long as
  // diffusion over `time` squared edge lengths of an equilateral mesh
  Field_diffusion(const Face_connection& connection, std::vector<Complex> pulls,
                  std::vector<Complex> fixed, double time)
    : m_connection(&connection), m_pull(std::move(pulls)), m_value(std::move(fixed)),
      m_mass(std::sqrt(3.) / (4 * time))
  {
    number_unknowns();
    factorize();
  }

  // takes the values that the free faces start with; 0 says that nothing is known there
  void start(const std::vector<Complex>& values)
  {
    for (int f : m_free_faces)
      m_value[f] = values[f];
  }

  // makes a step, and returns how far it moves the values, as the root of the mean square
  double step()
  {
    if (m_free_faces.empty())
      return 0;
    const Eigen::VectorXcd next = m_solver.solve(right_hand_side());
    double change = 0;
    for (int i = 0; i < int(m_free_faces.size()); ++i) {
      Complex& value = m_value[m_free_faces[i]];
      // a component without any direction yet takes that of the frames
      const Complex u = next[i] != Complex(0) ? next[i] : Complex(1);
      const Complex projected = u / std::abs(u);
      change += std::norm(projected - value);
      value = projected;
    }
    return std::sqrt(change / double(m_free_faces.size()));
  }

  const std::vector<Complex>& values() const { return m_value; }

private:
  using Matrix = Eigen::SparseMatrix<Complex>;
  using Entry = Eigen::Triplet<Complex>;

  void number_unknowns()
  {
    m_unknown.assign(m_value.size(), -1);
    for (int f = 0; f < int(m_value.size()); ++f)
      if (m_value[f] == Complex(0)) {
        m_unknown[f] = int(m_free_faces.size());
        m_free_faces.push_back(f);
      }
    m_constant = Eigen::VectorXcd::Zero(m_free_faces.size());
  }

  // e^(4 i transport) times the weight of the edge of h
  Complex coupling(int h) const
  {
    const int e = m_connection->surface().edge(h);
    return std::polar(m_connection->weight(e), 4 * m_connection->transport(h));
  }

  void factorize()
  {
    const Triangle_surface& surface = m_connection->surface();
    std::vector<Entry> entries;
    entries.reserve(3 * m_free_faces.size());
    for (int f : m_free_faces) {
      const int i = m_unknown[f];
      double diagonal = m_mass + std::abs(m_pull[f]);
      m_constant[i] = m_pull[f];
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        if (surface.is_border(h))
          continue;
        const int g = surface.opposite(h), j = m_unknown[surface.face(g)];
        diagonal += m_connection->weight(surface.edge(h));
        if (j < 0)
          m_constant[i] += coupling(g) * m_value[surface.face(g)];
        else if (j < i) // the solver reads the lower triangle
          entries.emplace_back(i, j, -coupling(g));
      }
      entries.emplace_back(i, i, diagonal);
    }
    Matrix matrix(m_free_faces.size(), m_free_faces.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    m_solver.compute(matrix);
    if (m_solver.info() != Eigen::Success)
      throw Stage_failure("compute_cross_field: the diffusion matrix cannot be factorized");
  }

  Eigen::VectorXcd right_hand_side() const
  {
    Eigen::VectorXcd result = m_constant;
    for (int i = 0; i < int(m_free_faces.size()); ++i)
      result[i] += m_mass * m_value[m_free_faces[i]];
    return result;
  }

  const Face_connection* m_connection;
  std::vector<Complex> m_pull, m_value;
  double m_mass;
  std::vector<int> m_unknown, m_free_faces;
  Eigen::VectorXcd m_constant;
  Sparse_cholesky<Complex> m_solver;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_FIELD_DIFFUSION_H
