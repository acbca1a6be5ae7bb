// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_MESH_NUMBERING_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_MESH_NUMBERING_H

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <iterator>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Vertices and faces of the user's mesh are numbered by their position in `vertices(mesh)` and
// `faces(mesh)`. The indices of the mesh itself cannot be used: after removals they have gaps.

// returns the descriptors of a range, so that number i belongs to entry i
template <class Range>
auto descriptors(const Range& range)
{
  using Descriptor = typename std::iterator_traits<decltype(range.begin())>::value_type;
  return std::vector<Descriptor>(range.begin(), range.end());
}

// returns `map`, filled with the positions of its keys in `range`
template <class Map, class Range>
Map with_positions(Map map, const Range& range)
{
  int position = 0;
  for (const auto& descriptor : range)
    put(map, descriptor, position++);
  return map;
}

// returns a property map from vertices to their numbers
template <class FaceGraph>
auto vertex_numbers(const FaceGraph& mesh)
{
  return with_positions(get(dynamic_vertex_property_t<int>(), mesh), vertices(mesh));
}

// returns a property map from faces to their numbers
template <class FaceGraph>
auto face_numbers(const FaceGraph& mesh)
{
  return with_positions(get(dynamic_face_property_t<int>(), mesh), faces(mesh));
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_MESH_NUMBERING_H
