// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SURFACE_CHARTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SURFACE_CHARTS_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/embedding/Layout_charts.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The flat structure of a layout, carried over from the patches of the T-mesh to the triangles of
// the surface.
//
// The chart of a face is that of the T-mesh patch in which its first halfedge begins. (At a node,
// that is the patch into which the halfedge leaves it.) Walking along the boundary of the face
// changes the patch at every crossing with an arc, and in a corner at every arc that leaves the
// node there.
class Surface_charts
{
public:
  // a change of chart, and how many of its quarter-turns are due to the cuts between merged cones
  struct Change
  {
    Chart_change chart;
    int cut_turns = 0;

    Change after(const Change& first) const
    {
      return {chart.after(first.chart), cut_turns + first.cut_turns};
    }
    Change inverse() const { return {chart.inverse(), -cut_turns}; }
  };

  Surface_charts(const T_mesh& t_mesh, const Layout_charts& charts)
    : m_t_mesh(t_mesh), m_charts(charts), m_to_begin(t_mesh.surface().number_of_halfedges())
  {
    for (int f = 0; f < t_mesh.surface().number_of_faces(); ++f)
      walk_around(f);
  }

  // from the chart of the face of h to that of the patch in which h begins
  const Change& to_begin(int h) const { return m_to_begin[h]; }

  // from the chart of the patch in which h begins to that of the patch in which it ends
  Change along(int h) const { return along(h, {}); }

  // from the chart of the face of h to the one on the other side of h
  Change across(int h) const
  {
    const int twin = m_t_mesh.surface().opposite(h);
    return along(twin, m_to_begin[twin]).inverse().after(m_to_begin[h]);
  }

  // where the node at the source of h is in the chart of the face of h
  Point2 node_position(int h) const
  {
    const Triangle_surface& surface = m_t_mesh.surface();
    int g = h;
    do
      g = surface.turn_right(g);
    while (m_t_mesh.corner_arcs[g].empty() && g != h);
    CGAL_assertion(!m_t_mesh.corner_arcs[g].empty());
    return m_to_begin[h].chart.inverse()(m_charts.source_position(m_t_mesh.corner_arcs[g].back()));
  }

private:
  Change across_arc(int h) const { return {m_charts.across(h), m_charts.cut_turns(h)}; }

  // `change` leads to the patch where h begins; returns the change to the patch where it ends
  Change along(int h, Change change) const
  {
    const Triangle_surface& surface = m_t_mesh.surface();
    const int e = surface.edge(h);
    const std::vector<int>& crossings = m_t_mesh.edge_crossings[e];
    if (surface.halfedge_of_edge(e) == h)
      for (auto it = crossings.begin(); it != crossings.end(); ++it)
        change = across_arc(*it).after(change);
    else
      for (auto it = crossings.rbegin(); it != crossings.rend(); ++it)
        change = across_arc(T_mesh::opposite(*it)).after(change);
    return change;
  }

  void walk_around(int f)
  {
    Change change;
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      m_to_begin[h] = change;
      change = along(h, change);
      const std::vector<int>& leaving = m_t_mesh.corner_arcs[Triangle_surface::next(h)];
      for (auto it = leaving.rbegin(); it != leaving.rend(); ++it)
        change = across_arc(*it).after(change);
    }
    CGAL_assertion(change.chart.quarter_turns == 0 && change.chart.translation.isZero(0));
    CGAL_assertion(change.cut_turns == 0);
  }

  const T_mesh& m_t_mesh;
  const Layout_charts& m_charts;
  std::vector<Change> m_to_begin; // per halfedge
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SURFACE_CHARTS_H
