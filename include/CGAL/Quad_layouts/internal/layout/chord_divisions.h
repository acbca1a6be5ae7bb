// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_CHORD_DIVISIONS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_CHORD_DIVISIONS_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/layout/divided_layout.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Returns the chords that are divided too little for a mesh structure without loops and multiple
// edges, where an edge is known by its ends.
inline std::vector<int> chords_in_conflict(const Divided_layout& divided)
{
  const Quad_layout& layout = divided.layout();
  std::vector<std::tuple<int, int, int>> edges; // ends, chord that the edge is a part of
  divided.for_each_quad([&](int f, const std::array<int, 4>& quad) {
    // each edge is seen from both sides, once in the direction of x or y, once against it
    const int h = layout.halfedge_of(f);
    const int along_x = layout.chord(Quad_layout::edge(h));
    const int along_y = layout.chord(Quad_layout::edge(layout.next(h)));
    for (int k = 0; k < 4; ++k)
      edges.emplace_back(quad[k], quad[(k + 1) % 4], k % 2 == 0 ? along_x : along_y);
  });
  for (int h = 0; h < layout.number_of_halfedges(); ++h)
    for (int k = 0; layout.is_border(h) && k < divided.parts(h); ++k)
      edges.emplace_back(divided.vertex_on(h, k), divided.vertex_on(h, k + 1),
                         layout.chord(Quad_layout::edge(h)));
  std::sort(edges.begin(), edges.end());
  std::vector<int> result;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [source, target, chord] = edges[i];
    const bool repeats = i > 0 && std::get<0>(edges[i - 1]) == source &&
                         std::get<1>(edges[i - 1]) == target;
    if (repeats)
      result.push_back(std::get<2>(edges[i - 1]));
    if (repeats || source == target)
      result.push_back(chord);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

// Raises divisions until all quads have four different vertices and no two edges have the same
// ends. Three parts per chord suffice, unless a vertex has valence 1: the quad beside it always has
// two equal corners.
inline void raise_to_simple(const Quad_layout& layout, std::vector<int>& divisions)
{
  for (int v = 0; v < layout.number_of_vertices(); ++v)
    if (layout.valence(v) < 2)
      throw Stage_failure("quad mesh: layout vertex " + std::to_string(v) + " has valence 1");
  for (;;) {
    const std::vector<int> conflicts = chords_in_conflict(Divided_layout(layout, divisions));
    if (conflicts.empty())
      return;
    for (int c : conflicts)
      ++divisions[c];
  }
}

// Raises the divisions of edges that are loops. They go around tunnels, or tubes, with a single
// corner: with few parts they would be sharply bent there.
inline void raise_loops(const Quad_layout& layout, std::vector<int>& divisions)
{
  constexpr int least = 6;
  for (int e = 0; e < layout.number_of_edges(); ++e)
    if (layout.source(2 * e) == layout.target(2 * e))
      divisions[layout.chord(e)] = (std::max)(divisions[layout.chord(e)], least);
}

// Returns the number of parts that the edges of each chord are divided into for a quad mesh whose
// edges have about the given length.
inline std::vector<int> chord_divisions(const Quad_layout& layout, double target_edge_length)
{
  constexpr double most = 1 << 24; // Divided_layout refuses such numbers
  std::vector<int> result;
  for (double length : layout.chord_length)
    result.push_back(int(std::clamp(std::round(length / target_edge_length), 1., most)));
  raise_loops(layout, result);
  raise_to_simple(layout, result);
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_CHORD_DIVISIONS_H
