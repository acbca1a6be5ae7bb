// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_QUANTIZED_OVERLAY_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_QUANTIZED_OVERLAY_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/embedding/Curve_mesh.h>
#include <CGAL/Quad_layouts/internal/embedding/Overlay.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The overlay of a surface and a T-mesh, with all arcs divided into the unit lengths that they have
// in the quantization, and room for lines inside of patches.
//
// The curves of its mesh are the halfedges of the T-mesh, and lines inside of patches that are
// mapped to halfedges of the layout or to points.
class Quantized_overlay
{
public:
  Quantized_overlay(const T_mesh& t_mesh, const Quad_layout& layout)
    : m_t_mesh(t_mesh), m_layout(layout)
  {
    Overlay overlay(t_mesh);
    m_mesh = Curve_mesh(Triangle_surface(overlay.points, overlay.triangles));
    std::copy(overlay.arc_halfedge.begin(), overlay.arc_halfedge.end(), m_mesh.curve.begin());
    std::copy(overlay.is_original.begin(), overlay.is_original.end(), m_mesh.is_original.begin());
    std::copy(overlay.is_fixed.begin(), overlay.is_fixed.end(), m_mesh.is_fixed.begin());
    m_patch = std::move(overlay.patch);
    mark_outside();
    m_layout_vertex.assign(m_mesh.points.size(), -1);
    m_along.assign(m_mesh.points.size(), 0);
    m_is_node.assign(m_mesh.points.size(), 0);
    place_on_arcs(overlay.place);
    split_arcs();
  }

  const T_mesh& t_mesh() const { return m_t_mesh; }
  const Quad_layout& layout() const { return m_layout; }
  const Curve_mesh& mesh() const { return m_mesh; }
  Curve_mesh release_mesh() { return std::move(m_mesh); }

  // the patch of the T-mesh in which a triangle is, -1 beyond the border
  int patch(int face) const { return m_patch[face]; }
  const Quad_layout::Grid& grid(int face) const { return m_layout.grids[m_patch[face]]; }

  // the layout vertex to which v is mapped, as far as it is known; or -1
  int layout_vertex(int v) const { return m_layout_vertex[v]; }
  void set_layout_vertex(int v, int layout_vertex) { m_layout_vertex[v] = layout_vertex; }

  bool is_arc(int h) const
  {
    return m_mesh.curve[h] >= 0 && m_mesh.curve[h] < m_t_mesh.number_of_halfedges();
  }

  // whether the edge of h is mapped to a point
  bool is_contracted(int h) const
  {
    if (is_arc(h))
      return length(m_mesh.curve[h]) == 0;
    if (m_mesh.curve[h] >= 0)
      return m_mesh.curve[h] == contracted();
    if (m_patch[h / 3] < 0)
      return false;
    return grid(h / 3).width == 0 && grid(h / 3).height == 0;
  }

  // the halfedge of the layout to which h is mapped, -1 if there is none
  int layout_halfedge(int h) const
  {
    if (m_mesh.curve[h] < 0 || is_contracted(h))
      return -1;
    if (!is_arc(h))
      return m_mesh.curve[h] - m_t_mesh.number_of_halfedges();
    const auto [arc, i] = unit(h);
    return m_layout.arc_halfedges[arc][i] ^ m_mesh.curve[h] % 2;
  }

  // the arc along which h runs, and which unit of it
  std::pair<int, int> unit(int h) const
  {
    return {m_mesh.curve[h] / 2, int((along(h) + along(m_mesh.opposite(h))) / 2)};
  }

  // the vertices along a halfedge of the T-mesh
  std::vector<int> vertices(int arc) const
  {
    std::vector<int> result{m_start[arc]};
    do
      m_mesh.for_each_outgoing(result.back(), [&](int h) {
        if (m_mesh.curve[h] == arc)
          result.push_back(m_mesh.target(h));
      });
    while (!m_is_node[result.back()]);
    return result;
  }

  // how many units from the start of a halfedge of the T-mesh a vertex inside of it lies
  double distance(int arc, int v) const
  {
    return arc % 2 == 0 ? m_along[v] : length(arc) - m_along[v];
  }

  // splits the edge of h in the middle
  int split(int h)
  {
    const double middle = is_arc(h) ? (along(h) + along(m_mesh.opposite(h))) / 2 : 0;
    add_vertex(h);
    m_along.back() = middle;
    return m_mesh.split(h);
  }

  // lets h run along a halfedge of the layout, or to a point if that is -1
  void set_line(int h, int layout_halfedge)
  {
    const int twin = m_mesh.opposite(h), first = m_t_mesh.number_of_halfedges();
    m_mesh.curve[h] = layout_halfedge < 0 ? contracted() : first + layout_halfedge;
    m_mesh.curve[twin] = layout_halfedge < 0 ? contracted()
                                             : first + Quad_layout::opposite(layout_halfedge);
  }

  // of a halfedge of the T-mesh, in units
  int length(int h) const { return int(m_layout.arc_halfedges[h / 2].size()); }

private:
  int contracted() const { return m_t_mesh.number_of_halfedges() + m_layout.number_of_halfedges(); }

  // how far along its arc, from the arc's start, the source of a piece h of an arc lies
  double along(int h) const
  {
    const int arc = m_mesh.curve[h], v = m_mesh.source(h);
    if (m_is_node[v])
      return arc % 2 == 0 ? 0 : length(arc);
    return m_along[v];
  }

  // tells the outer sides of the border what they are
  void mark_outside()
  {
    m_patch.resize(m_mesh.number_of_faces(), -1);
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.is_outer(h) && m_mesh.is_border_edge(h)) {
        m_mesh.curve[h] = T_mesh::opposite(m_mesh.curve[m_mesh.opposite(h)]);
        m_mesh.is_original[h] = m_mesh.is_fixed[h] = 1;
      }
  }

  void place_on_arcs(const std::vector<Overlay::Place>& place)
  {
    m_start.resize(m_t_mesh.number_of_halfedges());
    for (int h = 0; h < int(place.size()); ++h) {
      const auto [halfedge, pieces_before, pieces] = place[h];
      if (halfedge >= 0 && pieces_before == 0) {
        m_start[halfedge] = m_mesh.source(h);
        m_is_node[m_mesh.source(h)] = 1;
        m_layout_vertex[m_mesh.source(h)] = m_layout.node_vertex[m_t_mesh.source(halfedge)];
      } else if (halfedge >= 0 && halfedge % 2 == 0)
        // a quotient of integers: it is an integer if and only if one divides the other
        place_on_arc(m_mesh.source(h), halfedge / 2,
                     double(pieces_before) * length(halfedge) / pieces);
    }
  }

  void place_on_arc(int v, int arc, double along)
  {
    const std::vector<int>& path = m_layout.arc_halfedges[arc];
    m_along[v] = along;
    if (path.empty())
      m_layout_vertex[v] = m_layout.node_vertex[m_t_mesh.source(2 * arc)];
    else if (along == std::floor(along))
      m_layout_vertex[v] = m_layout.source(path[int(along)]);
  }

  void add_vertex(int h)
  {
    m_patch.push_back(m_patch[h / 3]);
    m_patch.push_back(m_patch[m_mesh.opposite(h) / 3]);
    m_layout_vertex.push_back(-1);
    m_along.push_back(0);
    m_is_node.push_back(0);
  }

  // splits the arcs at all integers
  void split_arcs()
  {
    for (int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if (m_mesh.curve[h] >= 0 && m_mesh.curve[h] % 2 == 0)
        for (double next = std::floor(along(h)) + 1; next < along(m_mesh.opposite(h));
             next = std::floor(along(h)) + 1) {
          const double t = (next - along(h)) / (along(m_mesh.opposite(h)) - along(h));
          add_vertex(h);
          place_on_arc(m_mesh.split(h, t), m_mesh.curve[h] / 2, next);
        }
  }

  const T_mesh& m_t_mesh;
  const Quad_layout& m_layout;
  Curve_mesh m_mesh{Triangle_surface()};
  std::vector<int> m_patch;         // per triangle
  std::vector<int> m_layout_vertex; // per vertex
  std::vector<double> m_along;      // per vertex inside of an arc: how far from the arc's start
  std::vector<char> m_is_node;      // per vertex
  std::vector<int> m_start;         // per halfedge of the T-mesh: the vertex where it begins
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_QUANTIZED_OVERLAY_H
