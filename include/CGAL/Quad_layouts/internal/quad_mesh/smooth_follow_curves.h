// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_FOLLOW_CURVES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_FOLLOW_CURVES_H

#include <CGAL/Quad_layouts/internal/quad_mesh/curve_distance.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Curve_vertices.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Quads_on_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Puts the vertices of a chain on a fixed curve to where its edges follow the bends.
class Curve_following
{
public:
  using Chain = Curve_vertices::Chain;

  Curve_following(Quads_on_surface& quads, const Chain& chain)
    : m_quads(quads), m_curves(quads.curve_vertices()), m_chain(chain)
  {
    const auto point = [&](int v) { return quads.mesh().points[v]; };
    m_bends = {point(chain.vertices.front())};
    m_distances = {chain.distances.front()};
    m_curves.for_each_bend(chain, [&](int v, double distance) {
      m_bends.push_back(quads.walk().surface().point(v));
      m_distances.push_back(distance);
    });
    m_bends.push_back(point(chain.vertices.back()));
    m_distances.push_back(chain.distances.back());
  }

  // moves vertices if one of them is at edges that are too far from the curve
  void operator()()
  {
    if (!is_followed())
      place_at(knots());
  }

private:
  std::size_t number_of_edges() const { return m_chain.vertices.size() - 1; }

  bool is_followed() const
  {
    return std::all_of(m_chain.vertices.begin() + 1, m_chain.vertices.end() - 1, [&](int v) {
      return m_curves.deviation(v, m_quads.place(v)) <= m_curves.tolerance();
    });
  }

  // the distances along the curve of as many bends as there are edges for in between, with both
  // ends; those that come nearest to the curve
  std::vector<double> knots() const
  {
    std::vector<std::size_t> indices;
    double tolerance = m_curves.tolerance();
    do {
      indices = knots_of(m_bends, tolerance);
      tolerance *= 1.25;
    } while (indices.size() - 1 > number_of_edges());
    std::vector<double> result;
    for (const std::size_t i : indices)
      result.push_back(m_distances[i]);
    return result;
  }

  // Moves to each knot the vertex nearest to it, such that enough of them remain for the others,
  // and spreads those in between as they are now.
  void place_at(const std::vector<double>& knots)
  {
    const std::vector<double>& old = m_chain.distances;
    std::size_t begin = 0;
    for (std::size_t j = 1; j < knots.size(); ++j) {
      const std::size_t last = number_of_edges() - (knots.size() - 1 - j);
      std::size_t end = j + 1 < knots.size() ? begin + 1 : last;
      while (end < last && std::abs(old[end + 1] - knots[j]) < std::abs(old[end] - knots[j]))
        ++end;
      for (std::size_t i = begin + 1; i <= end && i < number_of_edges(); ++i) {
        const double fraction = (old[i] - old[begin]) / (old[end] - old[begin]);
        const double there = i < end ? knots[j - 1] + fraction * (knots[j] - knots[j - 1])
                                     : knots[j];
        m_quads.move(m_chain.vertices[i], m_curves.place(m_chain.curve, there));
      }
      begin = end;
    }
  }

  Quads_on_surface& m_quads;
  const Curve_vertices& m_curves;
  const Chain& m_chain;
  std::vector<Point> m_bends; // with both ends
  std::vector<double> m_distances;
};

// puts vertices on fixed curves to where their edges do not cut off much of these
inline void follow_curves(Quads_on_surface& quads)
{
  for (const Curve_vertices::Chain& chain : quads.curve_vertices().chains())
    Curve_following(quads, chain)();
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_FOLLOW_CURVES_H
