// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MINIMAL_SETS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MINIMAL_SETS_H

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Answers which sets of a family contain no given set, or are contained in one. Sets are sorted
// vectors of numbers from 0 to n - 1; a set is filed under its first element.
class Subset_query
{
public:
  explicit Subset_query(int n) : m_by_first(n) {}
  Subset_query(const std::vector<std::vector<int>>& family, int n) : m_by_first(n)
  {
    for (const auto& set : family)
      add(set);
  }

  // expects a set that is not empty
  void add(const std::vector<int>& set) { m_by_first[set.front()].push_back(set); }

  // says if the family has a set all of whose elements are in `set`
  bool has_subset_of(const std::vector<int>& set) const
  {
    return std::any_of(set.begin(), set.end(), [&](int first) {
      return std::any_of(m_by_first[first].begin(), m_by_first[first].end(), [&](const auto& s) {
        return std::includes(set.begin(), set.end(), s.begin(), s.end());
      });
    });
  }

private:
  std::vector<std::vector<std::vector<int>>> m_by_first;
};

// returns the sets of `sets` that contain no other one, each once; sets must be sorted and not
// empty
inline std::vector<std::vector<int>> minimal_sets(std::vector<std::vector<int>> sets)
{
  std::sort(sets.begin(), sets.end(), [](const auto& s, const auto& t) {
    return s.size() != t.size() ? s.size() < t.size() : s < t;
  });
  int n = 0;
  for (const auto& set : sets)
    n = (std::max)(n, set.back() + 1);
  Subset_query kept(n);
  std::vector<std::vector<int>> result;
  for (auto& set : sets)
    if (!kept.has_subset_of(set)) {
      kept.add(set);
      result.push_back(std::move(set));
    }
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MINIMAL_SETS_H
