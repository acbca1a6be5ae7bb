// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_BUILD_MESH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_BUILD_MESH_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/layout/divided_layout.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <Eigen/Core>

#include <array>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Stands for an output map that the user did not ask for.
struct No_map
{
  template <class Key, class Value>
  friend void put(const No_map&, const Key&, const Value&)
  {
  }
};

// Says which vertices of the layout are corners of patches: those where not just one separatrix
// passes.
inline std::vector<char> layout_nodes(const Quad_layout& layout)
{
  std::vector<int> separatrices(layout.number_of_vertices(), 0);
  for (int h = 0; h < layout.number_of_halfedges(); ++h)
    separatrices[layout.source(h)] += layout.is_on_separatrix(Quad_layout::edge(h));
  std::vector<char> result;
  for (int n : separatrices)
    result.push_back(n != 0 && n != 2);
  for (int v = 0; v < layout.number_of_vertices(); ++v)
    if (!layout.goes_straight_on(v))
      result[v] = 1;
  return result;
}

// Marks the edges of the mesh that are parts of the layout edges which `is_marked` tells.
template <class QuadMesh, class VertexDescriptor, class EdgeMap, class Predicate>
void mark_edges(const Divided_layout& divided, const std::vector<VertexDescriptor>& vertices,
                const QuadMesh& mesh, EdgeMap map, const Predicate& is_marked)
{
  if constexpr (!std::is_same_v<EdgeMap, No_map>) {
    for (const auto e : edges(mesh))
      put(map, e, false);
    for (int e = 0; e < divided.layout().number_of_edges(); ++e)
      for (int k = 0; is_marked(e) && k < divided.parts(2 * e); ++k) {
        const VertexDescriptor source = vertices[divided.vertex_on(2 * e, k)];
        const VertexDescriptor target = vertices[divided.vertex_on(2 * e, k + 1)];
        put(map, edge(source, target, mesh).first, true);
      }
  }
}

// Adds the quads of a divided layout to a mesh, and fills the user's property maps.
template <class QuadMesh, class NamedParameters>
void build_mesh(const Divided_layout& divided, const std::vector<Eigen::Vector3d>& points,
                QuadMesh& mesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Vertex = typename boost::graph_traits<QuadMesh>::vertex_descriptor;
  const auto point_map = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                          get_property_map(CGAL::vertex_point, mesh));
  using Point_3 = typename boost::property_traits<decltype(point_map)>::value_type;
  const auto patch_map = choose_parameter(get_parameter(np, internal_np::face_patch), No_map());
  const auto node_map = choose_parameter(get_parameter(np, internal_np::vertex_is_layout_node_map),
                                         No_map());
  const auto edge_map = choose_parameter(get_parameter(np, internal_np::edge_is_layout_edge_map),
                                         No_map());
  const auto fixed_map = choose_parameter(get_parameter(np, internal_np::edge_is_constrained),
                                          No_map());

  const Quad_layout& layout = divided.layout();
  const std::vector<char> is_node = layout_nodes(layout);
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    vertices.push_back(add_vertex(mesh));
    put(point_map, vertices.back(), Point_3(points[i].x(), points[i].y(), points[i].z()));
    put(node_map, vertices.back(), i < is_node.size() && is_node[i]);
  }
  divided.for_each_quad([&](int f, const std::array<int, 4>& quad) {
    const std::array<Vertex, 4> corners = {vertices[quad[0]], vertices[quad[1]], vertices[quad[2]],
                                           vertices[quad[3]]};
    const auto face = Euler::add_face(corners, mesh);
    CGAL_assertion(face != boost::graph_traits<QuadMesh>::null_face());
    put(patch_map, face, layout.patch(f));
  });
  mark_edges(divided, vertices, mesh, edge_map, [&](int e) { return layout.is_on_separatrix(e); });
  mark_edges(divided, vertices, mesh, fixed_map, [&](int e) { return layout.is_fixed(e); });
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_EXTRACT_BUILD_MESH_H
