// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_CHORD_LENGTHS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_CHORD_LENGTHS_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/Sparse_cholesky.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Returns the length that the layout edges of each arc have to cover together: that of the arc, and
// of the arcs of length 0 in the quantization before and after it on its trace, half of these if
// they lie between two longer ones.
inline std::vector<double> lengths_to_cover(const T_mesh& t, const Quad_layout& layout)
{
  std::vector<double> result(t.number_of_edges(), 0);
  for (const T_mesh::Trace& trace : t.traces) {
    int last = -1;        // the last arc that has edges
    double collapsed = 0; // length since then
    for (int a : trace.arcs) {
      if (layout.arc_halfedges[a].empty()) {
        collapsed += t.length(a);
        continue;
      }
      result[a] += t.length(a) + (last < 0 ? collapsed : collapsed / 2);
      if (last >= 0)
        result[last] += collapsed / 2;
      last = a;
      collapsed = 0;
    }
    if (last >= 0)
      result[last] += collapsed;
  }
  return result;
}

// Scales lengths of chords such that the faces of the layout, as rectangles, have the area of the
// surface.
inline void scale_to_area(const Triangle_surface& surface, const Quad_layout& layout,
                          std::vector<double>& length)
{
  double wanted = 0, present = 0;
  for (int f = 0; f < surface.number_of_faces(); ++f)
    wanted += surface.area(f);
  for (int f = 0; f < layout.number_of_faces(); ++f) {
    const int h = layout.halfedge_of(f);
    present += length[layout.chord(Quad_layout::edge(h))] *
               length[layout.chord(Quad_layout::edge(layout.next(h)))];
  }
  for (double& l : length)
    l *= std::sqrt(wanted / present);
}

// Fits a length to each chord, such that the edges of each arc together have the arc's length:
// linear least squares, weakly drawn to equal lengths of the edges of one arc. Lengths that came
// out below a quarter of what the chord's arcs have on average are raised to that. Finally all are
// scaled such that the faces of the layout together have the area of the surface.
inline std::vector<double> fit_chord_lengths(const T_mesh& t, const Quad_layout& layout)
{
  constexpr double pull = 0.01, least = 0.25;
  const int n = layout.number_of_chords;
  const std::vector<double> to_cover = lengths_to_cover(t, layout);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n), sum = right, count = right;
  for (int a = 0; a < t.number_of_edges(); ++a) {
    const auto& edges = layout.arc_halfedges[a];
    for (int g : edges) {
      const int c = layout.chord(Quad_layout::edge(g));
      const double share = to_cover[a] / double(edges.size());
      for (int h : edges)
        entries.emplace_back(c, layout.chord(Quad_layout::edge(h)), 1);
      entries.emplace_back(c, c, pull);
      right[c] += to_cover[a] + pull * share;
      sum[c] += share;
      count[c] += 1;
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Sparse_cholesky<double> solver(matrix);
  const Eigen::VectorXd length = solver.solve(right);
  std::vector<double> result;
  for (int c = 0; c < n; ++c)
    result.push_back((std::max)(length[c], least * sum[c] / count[c]));
  if (t.surface_pointer) // a T-mesh made by hand may have none
    scale_to_area(t.surface(), layout, result);
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_CHORD_LENGTHS_H
