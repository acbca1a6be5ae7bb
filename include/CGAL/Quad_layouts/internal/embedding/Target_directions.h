// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_TARGET_DIRECTIONS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_TARGET_DIRECTIONS_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/embedding/Surface_charts.h>
#include <CGAL/Quad_layouts/internal/field/matching.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Computes where +x of the chart of each face should point: a cross field for the singularities of
// the layout.
//
// Without merged singularities it is a direction of the given field. The cuts that gather the cones
// of a cluster require the field to turn by whole quarter-turns across them. These turns are spread
// over the surface as evenly as possible: a harmonic correction of the given field.
class Target_directions
{
public:
  Target_directions(const Cross_field& field, const T_mesh& t_mesh, const Layout_charts& charts,
                    const Surface_charts& surface_charts)
    : m_field(field), m_surface(t_mesh.surface()), m_t_mesh(t_mesh), m_charts(charts),
      m_surface_charts(surface_charts)
  {
    comb();
    m_angle.resize(m_surface.number_of_faces());
    for (int f = 0; f < m_surface.number_of_faces(); ++f)
      m_angle[f] = field.angle(f) + m_direction[f] * right_angle;
    spread_cut_turns();
  }

  // per face the angle of +x in its frame
  const std::vector<double>& angles() const { return m_angle; }

private:
  static int turns_without_cuts(const Surface_charts::Change& c)
  {
    return (c.chart.quarter_turns - c.cut_turns) & 3;
  }

  // finds the direction of the field that is +x in each face: by following matchings and changes of
  // chart through each component, up to a constant, which the directions of the arcs at the nodes
  // tell
  void comb()
  {
    m_direction.assign(m_surface.number_of_faces(), -1);
    for (int seed = 0; seed < m_surface.number_of_faces(); ++seed) {
      if (m_direction[seed] >= 0)
        continue;
      const std::vector<int> component = comb_from(seed);
      const int constant = best_constant(component);
      for (const int f : component)
        m_direction[f] = (m_direction[f] + constant) & 3;
    }
  }

  std::vector<int> comb_from(int seed)
  {
    std::vector<int> component{seed};
    m_direction[seed] = 0;
    for (std::size_t i = 0; i < component.size(); ++i)
      for (int h = 3 * component[i]; h < 3 * component[i] + 3; ++h) {
        const int g = Triangle_surface::face(m_surface.opposite(h));
        const int direction = (m_direction[component[i]] + m_field.matching(h) -
                               turns_without_cuts(m_surface_charts.across(h))) &
                              3;
        CGAL_assertion(m_direction[g] < 0 || m_direction[g] == direction);
        if (m_direction[g] < 0) {
          m_direction[g] = direction;
          component.push_back(g);
        }
      }
    return component;
  }

  // An arc leaves a node somewhere inside a corner: take the middle, or rather the right place in a
  // row of arcs a quarter-turn apart about the middle. All arcs vote.
  int best_constant(const std::vector<int>& component) const
  {
    std::array<double, 4> vote{};
    for (const int f : component)
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const std::vector<int>& arcs = m_t_mesh.corner_arcs[h];
        if (arcs.empty())
          continue;
        const double expected = m_surface.halfedge_angle(h) + m_surface.corner_angle(h) / 2 -
                                (double(arcs.size()) - 1) / 2 * right_angle;
        const int in_chart = m_charts.direction(T_mesh::opposite(arcs.front())) + 2 -
                             turns_without_cuts(m_surface_charts.to_begin(h));
        for (int c = 0; c < 4; ++c)
          vote[c] += std::cos(m_field.angle(f) + (m_direction[f] + in_chart + c) * right_angle -
                              expected);
      }
    return int(std::max_element(vote.begin(), vote.end()) - vote.begin());
  }

  bool is_node(int v) const
  {
    bool found = false;
    m_surface.for_each_outgoing(v,
                                [&](int h) { found = found || !m_t_mesh.corner_arcs[h].empty(); });
    return found;
  }

  // Solves for an angle per vertex that is not a node: the correction in the chart of the patch
  // around it.
  void spread_cut_turns()
  {
    const int n = m_surface.number_of_vertices();
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n);
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<char> node(n);
    for (int v = 0; v < n; ++v) {
      node[v] = is_node(v);
      entries.emplace_back(v, v,
                           1e-8); // of all constants that may be added, choose that with mean zero
    }
    bool any = false;
    for (int e = 0; e < m_surface.number_of_edges(); ++e) {
      const int h = m_surface.halfedge_of_edge(e), u = m_surface.source(h), v = m_surface.target(h);
      if (node[u] || node[v])
        continue;
      for (const auto& [i, j, x] : {std::tuple(u, u, 1.), std::tuple(v, v, 1.),
                                    std::tuple(u, v, -1.), std::tuple(v, u, -1.)})
        entries.emplace_back(i, j, x);
      const double turn = m_surface_charts.along(h).cut_turns * right_angle;
      rhs[u] += turn;
      rhs[v] -= turn;
      any = any || turn != 0;
    }
    if (!any)
      return;
    Eigen::SparseMatrix<double> laplacian(n, n);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    const Eigen::VectorXd correction =
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(laplacian).solve(rhs);
    for (int f = 0; f < m_surface.number_of_faces(); ++f)
      m_angle[f] += mean_correction(f, correction, node);
  }

  double mean_correction(int f, const Eigen::VectorXd& correction,
                         const std::vector<char>& node) const
  {
    double sum = 0;
    int count = 0;
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      if (const int v = m_surface.source(h); !node[v]) {
        sum += correction[v] + m_surface_charts.to_begin(h).cut_turns * right_angle;
        ++count;
      }
    return count == 0 ? 0 : sum / count;
  }

  const Cross_field& m_field;
  const Triangle_surface& m_surface;
  const T_mesh& m_t_mesh;
  const Layout_charts& m_charts;
  const Surface_charts& m_surface_charts;
  std::vector<int> m_direction; // per face
  std::vector<double> m_angle;  // per face
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_TARGET_DIRECTIONS_H
