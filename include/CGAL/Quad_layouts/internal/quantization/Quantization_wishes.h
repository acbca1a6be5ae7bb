// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_WISHES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_WISHES_H

#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// What the user asks of a single quantization beyond the general demands. All of it can be empty.
struct Quantization_wishes
{
  using Pairs = std::vector<std::pair<int, int>>; // of nodes

  std::vector<double> arc_weight; // factors of the objective
  Pairs separate;                 // singularities that must not merge
  Pairs connected;                // singularities that a layout edge must join
  std::vector<int> vertex_image;  // per vertex of the surface, under a symmetry
  bool locks_alignments = false;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_QUANTIZATION_WISHES_H
