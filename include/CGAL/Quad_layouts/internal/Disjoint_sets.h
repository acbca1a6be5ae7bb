// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_DISJOINT_SETS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_DISJOINT_SETS_H

#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A partition of 0, 1, ..., n - 1 into sets that can be united.
//
// It stands in for boost::disjoint_sets_with_storage, whose header (Boost 1.74) does not compile
// after boost/graph/adjacency_list.hpp, which users may well include before ours.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(int n) : m_parent(n) { std::iota(m_parent.begin(), m_parent.end(), 0); }

  // the representative of the set of x
  int find_set(int x)
  {
    while (m_parent[x] != x)
      x = m_parent[x] = m_parent[m_parent[x]];
    return x;
  }

  void union_set(int x, int y) { m_parent[find_set(x)] = find_set(y); }

private:
  std::vector<int> m_parent;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_DISJOINT_SETS_H
