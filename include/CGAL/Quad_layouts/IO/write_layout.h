// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_IO_WRITE_LAYOUT_H
#define CGAL_QUAD_LAYOUTS_IO_WRITE_LAYOUT_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <limits>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace IO {

/*!
\ingroup PkgQuadLayoutsIO

writes the faces of a layout, with straight edges, in OBJ format: a group `patch_<i>` for each
patch.

\returns whether writing succeeded
*/
inline bool write_layout(std::ostream& out, const Quad_layout& layout)
{
  out.precision((std::numeric_limits<double>::max_digits10));
  for (int v = 0; v < layout.number_of_vertices(); ++v) {
    const auto& p = layout.point(v);
    out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  std::vector<std::vector<int>> patches(layout.number_of_patches);
  for (int f = 0; f < layout.number_of_faces(); ++f)
    patches[layout.patch(f)].push_back(f);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    out << "g patch_" << i << '\n';
    for (const int f : patches[i]) {
      out << 'f';
      int h = layout.halfedge_of(f);
      do {
        out << ' ' << layout.source(h) + 1;
        h = layout.next(h);
      } while (h != layout.halfedge_of(f));
      out << '\n';
    }
  }
  return out.good();
}

/*!
\ingroup PkgQuadLayoutsIO

writes the edges of a layout as polylines on the surface, in OBJ format. They are the chains of
edges of a quad mesh with this layout that lead from node to node.

\tparam QuadMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam NodeMap a model of `ReadablePropertyMap` from vertices to `bool`
\tparam LayoutEdgeMap a model of `ReadablePropertyMap` from edges to `bool`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param out the stream
\param quads the quad mesh
\param is_node tells where separatrices begin, end or cross, as the map `vertex_is_layout_node_map`
               of `extract_quad_mesh()`
\param is_layout_edge tells which edges lie on separatrices, as the map `edge_is_layout_edge_map`
                      of `extract_quad_mesh()`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`

\returns whether writing succeeded
*/
template <class QuadMesh, class NodeMap, class LayoutEdgeMap,
          class NamedParameters = parameters::Default_named_parameters>
bool write_layout_curves(std::ostream& out, const QuadMesh& quads, const NodeMap is_node,
                         const LayoutEdgeMap is_layout_edge,
                         const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Halfedge = typename boost::graph_traits<QuadMesh>::halfedge_descriptor;
  const auto points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, quads));
  const auto written = get(CGAL::dynamic_edge_property_t<bool>(), quads);
  for (const auto e : edges(quads))
    put(written, e, !get(is_layout_edge, e));

  out.precision((std::numeric_limits<double>::max_digits10));
  int number_of_points = 0;
  const auto write_point = [&](const auto v) {
    const auto& p = get(points, v);
    out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    ++number_of_points;
  };
  const auto write_curve = [&](Halfedge h) {
    const int first = number_of_points + 1;
    write_point(source(h, quads));
    for (;;) {
      put(written, edge(h, quads), true);
      write_point(target(h, quads));
      const Halfedge right = next(h, quads);
      const Halfedge ahead = is_border(h, quads) ? right : next(opposite(right, quads), quads);
      if (get(is_node, target(h, quads)) || get(written, edge(ahead, quads)))
        break;
      h = ahead;
    }
    out << 'l';
    for (int i = first; i <= number_of_points; ++i)
      out << ' ' << i;
    out << '\n';
  };
  for (const Halfedge h : halfedges(quads))
    if (get(is_node, source(h, quads)) && !get(written, edge(h, quads)))
      write_curve(h);
  for (const Halfedge h : halfedges(quads)) // closed curves without a node
    if (!get(written, edge(h, quads)))
      write_curve(h);
  return out.good();
}

} // namespace IO
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_IO_WRITE_LAYOUT_H
