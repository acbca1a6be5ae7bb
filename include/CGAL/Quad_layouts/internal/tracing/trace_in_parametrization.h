// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_PARAMETRIZATION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_PARAMETRIZATION_H

#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/tracing/Isoline_chords.h>
#include <CGAL/Quad_layouts/internal/tracing/Tracing.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// throws unless lines can be traced in a parametrization
inline void check_charts(const Seamless_parametrization& map, const Labels& labels)
{
  const auto fail = [](const std::string& what) {
    throw Stage_failure("trace_motorcycle_graph: " + what + " in the parametrization");
  };
  for (int f = 0; f < map.surface().number_of_faces(); ++f)
    if (!labels.is_valid(f))
      fail("face " + std::to_string(f) + " is inverted");
  for (int v = 0; v < map.surface().number_of_vertices(); ++v)
    if (map.surface().halfedge(v) >= 0 && labels.index(v) != map.vertex_index[v])
      fail("vertex " + std::to_string(v) + " has index " + std::to_string(labels.index(v)) +
           " instead of " + std::to_string(map.vertex_index[v]));
    else if (map.surface().halfedge(v) >= 0 && labels.valence(v) < 2)
      fail("only one line starts at vertex " + std::to_string(v));
}

// Throws unless opposite sides of all patches have the same length. Lengths are numbers of units that are
// powers of two, which are summed up without an error.
inline void check_opposite_sides(const T_mesh& t_mesh)
{
  for (int p = 0; p < t_mesh.number_of_faces(); ++p) {
    std::array<double, 4> length{};
    const auto sides = t_mesh.sides(p);
    for (int k = 0; k < 4; ++k)
      for (const int h : sides[k])
        length[k] += t_mesh.length(T_mesh::edge(h));
    if (length[0] != length[2] || length[1] != length[3])
      throw Stage_failure("trace_motorcycle_graph: opposite sides of " + named_patch(t_mesh, p) +
                          " have different lengths");
  }
}

// traces the extended motorcycle graph of a parametrization; `tangent` is that of the maximum deviation,
// `displacement` a length
inline T_mesh trace_in_parametrization(const Seamless_parametrization& map, double tangent,
                                       double displacement, const Monitor& monitor)
{
  const Labels labels(map);
  check_charts(map, labels);
  Tracing<Isoline_chords, Seamless_parametrization> tracing(
      map.surface_pointer, map, stopping_rule(map.surface(), tangent, displacement), monitor);
  T_mesh result = tracing.trace(labels);
  check_opposite_sides(result);
  result.route = PARAMETRIZATION;
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_PARAMETRIZATION_H
