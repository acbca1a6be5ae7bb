// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_EDGE_ORDER_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_EDGE_ORDER_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The points at which traces cross the edges of the surface, in one ordered list per edge.
//
// Their order is combinatorial: a point is inserted between two others, and keeps its place.
// Parameters t along the edge only propose a place. They never decrease along the list, but
// coincide where lines converge beyond the resolution of numbers.
class Edge_order
{
public:
  using Rank = std::uint64_t;

  explicit Edge_order(int number_of_edges) : m_points(number_of_edges) {}

  // adds a point to the list of `edge`, behind the point `after` and ahead of the point `before`
  // (-1: none), between these by its parameter
  int insert(int edge, double t, int after, int before)
  {
    auto& list = m_points[edge];
    const auto first = after < 0 ? list.begin() : locate(after) + 1;
    const auto last = before < 0 ? list.end() : locate(before);
    CGAL_assertion(first <= last);
    return insert_at(std::upper_bound(first, last, t, [&](double u, int p) { return u < m_t[p]; }),
                     edge, t);
  }

  // adds a point to the list of `edge`, behind those that come before it
  template <class ComesBefore>
  int insert(int edge, double t, ComesBefore&& comes_before)
  {
    auto& list = m_points[edge];
    return insert_at(std::partition_point(list.begin(), list.end(), comes_before), edge, t);
  }

  int number_of_points() const { return int(m_t.size()); }
  int edge(int point) const { return m_edge[point]; }
  // the parameter along the canonical halfedge of the edge
  double t(int point) const { return m_t[point]; }
  // a number that grows strictly along the list; an insertion may change the ranks, not their order
  Rank rank(int point) const { return m_rank[point]; }
  const std::vector<int>& points(int edge) const { return m_points[edge]; }

private:
  int insert_at(std::vector<int>::iterator place, int edge, double t)
  {
    auto& list = m_points[edge];
    const double low = place == list.begin() ? 0 : m_t[*(place - 1)];
    const double high = place == list.end() ? 1 : m_t[*place];
    const int point = int(m_t.size());
    const std::ptrdiff_t position = place - list.begin();
    list.insert(place, point);
    m_t.push_back(strictly_between(low, t, high));
    m_edge.push_back(edge);
    m_rank.push_back(0);
    rank_between_neighbours(list, position);
    return point;
  }

  // moves t into the open interval from low to high, as far as numbers allow; chords that share an
  // end have no clear crossing
  static double strictly_between(double low, double t, double high)
  {
    constexpr double margin = 1. / 1024;
    if (t <= low)
      return low + margin * (high - low);
    return t < high ? t : high - margin * (high - low);
  }

  std::vector<int>::iterator locate(int point)
  {
    auto& list = m_points[m_edge[point]];
    return std::lower_bound(list.begin(), list.end(), m_rank[point],
                            [&](int p, Rank rank) { return m_rank[p] < rank; });
  }

  // gives the middle rank between its neighbours to a new point; if there is none, new ranks to all
  void rank_between_neighbours(const std::vector<int>& list, std::ptrdiff_t position)
  {
    const std::ptrdiff_t size = std::ptrdiff_t(list.size());
    const Rank low = position == 0 ? 0 : m_rank[list[position - 1]];
    const Rank high = position + 1 == size ? ~Rank(0) : m_rank[list[position + 1]];
    if (high - low >= 2) {
      m_rank[list[position]] = low + (high - low) / 2;
      return;
    }
    const Rank step = ~Rank(0) / Rank(size + 1);
    for (std::ptrdiff_t i = 0; i < size; ++i)
      m_rank[list[i]] = Rank(i + 1) * step;
  }

  std::vector<std::vector<int>> m_points;
  std::vector<double> m_t;
  std::vector<int> m_edge;
  std::vector<Rank> m_rank;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_EDGE_ORDER_H
