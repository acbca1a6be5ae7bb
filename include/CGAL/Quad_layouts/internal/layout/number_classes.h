// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_NUMBER_CLASSES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_NUMBER_CLASSES_H

#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Disjoint sets of the numbers 0 to n-1, numbered in the order of their least members.
struct Numbered_classes
{
  int number = 0;
  std::vector<int> class_of;
};

inline Numbered_classes number_classes(Disjoint_sets& sets, int n)
{
  Numbered_classes result;
  std::vector<int> class_of_root(n, -1);
  for (int i = 0; i < n; ++i) {
    int& c = class_of_root[sets.find_set(i)];
    if (c < 0)
      c = result.number++;
    result.class_of.push_back(c);
  }
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_NUMBER_CLASSES_H
