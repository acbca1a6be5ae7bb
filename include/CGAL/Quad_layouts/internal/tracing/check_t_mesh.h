// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_CHECK_T_MESH_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_CHECK_T_MESH_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/tracing/starting_vertices.h>

#include <algorithm>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// returns "patch p (beside a trace that starts at vertex v)"
inline std::string named_patch(const T_mesh& t_mesh, int p)
{
  const int trace = t_mesh.trace(Halfedge_complex::edge(t_mesh.halfedge_of(p)));
  const int vertex = t_mesh.surface_vertex(t_mesh.traces[trace].start);
  return "patch " + std::to_string(p) + " (beside a trace that starts at vertex " +
         std::to_string(vertex) + ")";
}

// throws unless every patch has four corners
inline void check_corners(const T_mesh& t_mesh)
{
  std::vector<int> corners(t_mesh.number_of_faces(), 0);
  for (int h = 0; h < t_mesh.number_of_halfedges(); ++h)
    if (!t_mesh.is_border(h))
      corners[t_mesh.face(h)] += t_mesh.is_corner(h);
  for (int p = 0; p < t_mesh.number_of_faces(); ++p)
    if (corners[p] != 4)
      throw Stage_failure("trace_motorcycle_graph: " + named_patch(t_mesh, p) + " has " +
                          std::to_string(corners[p]) + " corners");
}

// throws unless the T-mesh has the Euler characteristic of the surface in each of its components.
// If one of its patches had a handle or a second border there, it would have a larger one: so every
// patch is a disc.
inline void check_euler_characteristics(const T_mesh& t_mesh)
{
  const Triangle_surface& surface = t_mesh.surface();
  const std::vector<int> component = components(surface);
  std::vector<int> difference(surface.number_of_vertices(), 0);
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    difference[component[v]] += surface.halfedge(v) >= 0;
  for (int e = 0; e < surface.number_of_edges(); ++e)
    --difference[component[surface.source(surface.halfedge_of_edge(e))]];
  for (int f = 0; f < surface.number_of_faces(); ++f)
    ++difference[component[surface.source(3 * f)]];

  const auto of_trace = [&](int t) {
    return component[t_mesh.surface_vertex(t_mesh.traces[t].start)];
  };
  for (int n = 0; n < t_mesh.number_of_vertices(); ++n)
    --difference[of_trace(t_mesh.trace(Halfedge_complex::edge(t_mesh.halfedge_from(n))))];
  for (int a = 0; a < t_mesh.number_of_edges(); ++a)
    ++difference[of_trace(t_mesh.trace(a))];
  for (int p = 0; p < t_mesh.number_of_faces(); ++p)
    --difference[of_trace(t_mesh.trace(Halfedge_complex::edge(t_mesh.halfedge_of(p))))];

  for (int v = 0; v < surface.number_of_vertices(); ++v)
    if (difference[v] != 0)
      throw Stage_failure("trace_motorcycle_graph: in the component of vertex " +
                          std::to_string(v) + " not all patches are discs");
}

// Checks that walks around the corners of all triangles cross arcs from patch to patch without a
// gap, and that arcs along edges have the patches beside these. Then every piece of an edge lies in
// one patch, and so does every vertex that is no node.
class Crossing_check
{
public:
  using Surface = Triangle_surface;

  explicit Crossing_check(const T_mesh& t_mesh)
    : m_t_mesh(t_mesh), m_surface(t_mesh.surface()),
      m_patch(t_mesh.surface().number_of_halfedges(), -1)
  {
  }

  void operator()()
  {
    for (int e = 0; e < m_surface.number_of_edges(); ++e)
      if (m_t_mesh.edge_arcs[e].empty())
        check_edge(e);
      else
        check_arcs_along(e);
    for (int h = 0; h < m_surface.number_of_halfedges(); ++h)
      if (!m_t_mesh.corner_arcs[h].empty())
        check_corner(h);
    spread();
  }

private:
  int left(int h) const { return m_t_mesh.face(h); }
  int right(int h) const { return m_t_mesh.face(Halfedge_complex::opposite(h)); }

  void check_edge(int e)
  {
    const auto& crossings = m_t_mesh.edge_crossings[e];
    if (crossings.empty())
      return;
    const int h = m_surface.halfedge_of_edge(e);
    for (std::size_t i = 1; i < crossings.size(); ++i)
      if (right(crossings[i - 1]) != left(crossings[i]))
        fail(h);
    note(h, left(crossings.front()));
    note(m_surface.opposite(h), right(crossings.back()));
  }

  void check_arcs_along(int e)
  {
    std::vector<int> arcs = m_t_mesh.edge_arcs[e];
    const int h = m_surface.halfedge_of_edge(e);
    if (arcs.size() != m_t_mesh.crossing_parameters[e].size() + 1)
      fail(h);
    check_side(h, arcs);
    if (m_surface.is_border(h))
      return;
    std::reverse(arcs.begin(), arcs.end());
    for (int& a : arcs)
      a = Halfedge_complex::opposite(a);
    check_side(m_surface.opposite(h), arcs);
  }

  // of a fixed halfedge, along which `arcs` run: the last patch must be that in which its end is
  void check_side(int h, const std::vector<int>& arcs)
  {
    const int end = Surface::next(h);
    note(h, left(arcs.front()));
    if (!m_t_mesh.corner_arcs[end].empty()) {
      if (left(m_t_mesh.corner_arcs[end].back()) != left(arcs.back()))
        fail(end);
    } else if (!m_surface.is_fixed(end))
      note(end, left(arcs.back()));
  }

  void check_corner(int h)
  {
    const auto& arcs = m_t_mesh.corner_arcs[h];
    for (std::size_t i = 1; i < arcs.size(); ++i)
      if (left(arcs[i - 1]) != right(arcs[i]))
        fail(h);
    note(h, right(arcs.front()));
    if (!m_surface.is_fixed(Surface::prev(h)))
      note(m_surface.turn_left(h), left(arcs.back()));
  }

  // notes that halfedge h begins in `patch`
  void note(int h, int patch)
  {
    if (m_patch[h] == patch)
      return;
    if (m_patch[h] >= 0)
      fail(h);
    m_patch[h] = patch;
    m_stack.push_back(h);
  }

  // carries patches on, around vertices and along edges, wherever no arc is crossed
  void spread()
  {
    while (!m_stack.empty()) {
      const int h = m_stack.back(), patch = m_patch[h];
      m_stack.pop_back();
      if (m_t_mesh.corner_arcs[h].empty() && !m_surface.is_fixed(Surface::prev(h)))
        note(m_surface.turn_left(h), patch);
      if (m_surface.is_fixed(h))
        continue;
      const int right = m_surface.turn_right(h);
      if (m_t_mesh.corner_arcs[right].empty())
        note(right, patch);
      if (m_t_mesh.edge_crossings[m_surface.edge(h)].empty())
        note(m_surface.opposite(h), patch);
    }
    for (int h = 0; h < m_surface.number_of_halfedges(); ++h)
      if (m_patch[h] < 0)
        fail(h);
  }

  [[noreturn]] void fail(int h) const
  {
    throw Stage_failure("trace_motorcycle_graph: the arcs that cross face " +
                        std::to_string(Surface::face(h)) + " near vertex " +
                        std::to_string(m_surface.source(h)) + " do not match their patches");
  }

  const T_mesh& m_t_mesh;
  const Surface& m_surface;
  std::vector<int> m_patch; // per halfedge the patch in which it begins
  std::vector<int> m_stack;
};

// throws unless the T-mesh partitions its surface into discs with four corners
inline void check_t_mesh(const T_mesh& t_mesh)
{
  check_corners(t_mesh);
  check_euler_characteristics(t_mesh);
  Crossing_check check_crossings(t_mesh);
  check_crossings();
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_CHECK_T_MESH_H
