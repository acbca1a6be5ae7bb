// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_READ_WISHES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_READ_WISHES_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/quantization/Quantization_wishes.h>
#include <CGAL/Quad_layouts/internal/require_parameter.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The overloads below that take `Param_not_found` are for parameters that are not given.

inline std::vector<double> read_arc_weights(const T_mesh&, internal_np::Param_not_found)
{
  return {};
}

template <class ArcWeightMap>
std::vector<double> read_arc_weights(const T_mesh& t_mesh, const ArcWeightMap& map)
{
  std::vector<double> result;
  for (int a = 0; a < t_mesh.number_of_edges(); ++a) {
    result.push_back(get(map, a));
    require_positive("arc_weight_map", result.back());
  }
  return result;
}

inline Quantization_wishes::Pairs read_pairs(const char*, const T_mesh&,
                                             internal_np::Param_not_found)
{
  return {};
}

// reads pairs of vertices at which singularities are
template <class Pairs>
Quantization_wishes::Pairs read_pairs(const char* name, const T_mesh& t_mesh, const Pairs& pairs)
{
  std::map<int, int> node_of_vertex;
  for (int n = 0; n < t_mesh.number_of_vertices(); ++n)
    if (t_mesh.is_singularity_or_seed(n))
      node_of_vertex[t_mesh.surface_vertex(n)] = n;
  const auto node = [&](int vertex) {
    const auto found = node_of_vertex.find(vertex);
    require_parameter(found != node_of_vertex.end(), name, vertex, "the vertex of a singularity");
    return found->second;
  };
  Quantization_wishes::Pairs result;
  for (const auto& pair : pairs) {
    result.emplace_back(node(int(pair.first)), node(int(pair.second)));
    require_parameter(pair.first != pair.second, name, int(pair.first), "another vertex");
  }
  return result;
}

inline std::vector<int> read_symmetry(const T_mesh&, internal_np::Param_not_found)
{
  return {};
}

// reads a permutation of the vertices of the user's mesh
template <class Images>
std::vector<int> read_symmetry(const T_mesh& t_mesh, const Images& images)
{
  const int n = t_mesh.surface().original().number_of_vertices();
  std::vector<int> result;
  for (const auto& image : images)
    result.push_back(int(image));
  std::vector<int> sorted = result;
  std::sort(sorted.begin(), sorted.end());
  bool is_permutation = int(sorted.size()) == n;
  for (int v = 0; v < n && is_permutation; ++v)
    is_permutation = sorted[v] == v;
  require_parameter(is_permutation, "vertex_symmetry", int(result.size()),
                    "the size of a permutation of the vertices");
  return result;
}

template <class NamedParameters>
Quantization_wishes quantization_wishes(const T_mesh& t_mesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  return {
      read_arc_weights(t_mesh, get_parameter(np, internal_np::arc_weight_map)),
      read_pairs("forbidden_merges", t_mesh, get_parameter(np, internal_np::forbidden_merges)),
      read_pairs("forced_connections", t_mesh, get_parameter(np, internal_np::forced_connections)),
      read_symmetry(t_mesh, get_parameter(np, internal_np::vertex_symmetry)),
      choose_parameter(get_parameter(np, internal_np::lock_alignments), false)};
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_READ_WISHES_H
