// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_INDEX_MOVES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_INDEX_MOVES_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/tracing/Labels.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A label that changes on one side of its edge moves a quarter of index from one end to the other.
// Lines that pass between the two then turn by a quarter, and leave a strip that winds around a
// limit cycle, from which there is no other way out. Between regular vertices, the move makes a
// pair of singularities of valence 3 and 5, such as Myles, Pietroni and Zorin insert for zero sides
// of patches (Robust field-aligned global parametrization, 2014).
struct Index_move
{
  int halfedge;
  int shift; // of its quadrant: 1 or 3

  void apply(Labels& labels) const { labels.set(halfedge, labels.quadrant(halfedge) + shift); }
  void undo(Labels& labels) const { labels.set(halfedge, labels.quadrant(halfedge) - shift); }
};

// whether a move leaves its face valid, and makes no vertex slim, or of a valence that quad meshes
// do not have
inline bool is_legal(const Index_move& move, Labels& labels)
{
  const Triangle_surface& surface = labels.surface();
  if (surface.is_fixed(move.halfedge) || !labels.is_valid_with(move.halfedge, move.shift))
    return false;
  const auto is_good = [&](int v) {
    return labels.valence(v) >= Labels::least_valence && !labels.is_slim(v);
  };
  move.apply(labels);
  const bool result = is_good(surface.source(move.halfedge)) &&
                      is_good(surface.target(move.halfedge));
  move.undo(labels);
  return result;
}

// An arc that stays within a face does not say in which. Its trace does: returns the arc by which
// that got there, or the first one, which starts at a vertex.
inline int last_arc_with_place(const T_mesh& t_mesh, int arc)
{
  const std::vector<int>& arcs = t_mesh.traces[t_mesh.trace(arc)].arcs;
  auto a = std::find(arcs.begin(), arcs.end(), arc);
  while (a != arcs.begin() && t_mesh.arc_crossings[*a].empty() && t_mesh.arc_pieces[*a].empty())
    --a;
  return *a;
}

// returns the faces that a chain of arcs runs through or ends at, and those around them, the
// nearest first, up to a number of faces
inline std::vector<int> faces_near(const T_mesh& t_mesh, const std::vector<int>& chain,
                                   std::size_t number)
{
  const Triangle_surface& surface = t_mesh.surface();
  std::vector<char> is_reached(surface.number_of_faces(), 0);
  std::vector<int> result;
  const auto reach = [&](int h) {
    if (h >= 0 && !std::exchange(is_reached[Triangle_surface::face(h)], 1))
      result.push_back(Triangle_surface::face(h));
  };
  const auto reach_sides = [&](const std::vector<T_mesh::Crossing>& crossings) {
    for (const T_mesh::Crossing& c : crossings) {
      reach(c.halfedge);
      reach(surface.opposite(c.halfedge));
    }
  };
  for (const int arc : chain) {
    const int a = last_arc_with_place(t_mesh, arc);
    reach_sides(t_mesh.arc_crossings[a]);
    reach_sides(t_mesh.arc_pieces[a]);
    for (const int n : {t_mesh.source(2 * a), t_mesh.target(2 * a)})
      if (const int v = t_mesh.surface_vertex(n); v >= 0)
        surface.for_each_outgoing(v, reach);
  }
  for (std::size_t i = 0; i < result.size() && result.size() < number; ++i)
    for (int h = 3 * result[i]; h < 3 * result[i] + 3; ++h)
      reach(surface.opposite(h));
  return result;
}

// returns the legal moves near a chain of arcs, the nearest first; `t_mesh` was traced from
// `labels`
inline std::vector<Index_move> index_moves_near(const T_mesh& t_mesh, const std::vector<int>& chain,
                                                Labels& labels)
{
  constexpr std::size_t number_of_faces = 100;
  std::vector<Index_move> result;
  for (const int f : faces_near(t_mesh, chain, number_of_faces))
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      for (const int shift : {1, 3})
        if (const Index_move move{h, shift}; is_legal(move, labels))
          result.push_back(move);
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_INDEX_MOVES_H
