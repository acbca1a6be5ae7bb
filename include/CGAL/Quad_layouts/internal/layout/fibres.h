// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_FIBRES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_FIBRES_H

#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/layout/arc_grid.h>
#include <CGAL/Quad_layouts/internal/layout/number_classes.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A line of zero length that joins two integer points: an arc of length 0, or a line straight
// through a patch of zero extent at an integer height.
struct Zero_connection
{
  int from, to; // points
  int arc;      // -1 if it runs through a patch
  int patch;    // -1 if it is an arc
};

// All that the quantization maps to one vertex of the quotient: points, the connections between
// them, and patches of zero width and height. Its Euler characteristic is 1 if and only if it is
// contractible, being a connected proper sub-complex of a surface.
struct Fibre
{
  std::vector<int> points, connections, patches;
  int euler_characteristic() const
  {
    return int(points.size()) - int(connections.size()) + int(patches.size());
  }
};

// The fibres of the vertices of the quotient.
class Fibres
{
public:
  explicit Fibres(const Arc_grid& grid) : m_grid(&grid)
  {
    collect_connections();
    group_points();
  }

  const Arc_grid& grid() const { return *m_grid; }
  int size() const { return int(m_fibres.size()); }
  const Fibre& fibre(int i) const { return m_fibres[i]; }
  // the fibre that a point belongs to
  int fibre_of_point(int point) const { return m_fibre_of_point[point]; }
  bool is_on_border(int fibre) const
  {
    const std::vector<int>& points = m_fibres[fibre].points;
    return std::any_of(points.begin(), points.end(),
                       [&](int p) { return m_grid->is_on_border(p); });
  }
  // whether a connection is part of a fixed curve
  bool is_fixed(int connection) const
  {
    const int a = m_connections[connection].arc;
    return a >= 0 && m_grid->t_mesh().is_fixed(a);
  }
  const Zero_connection& connection(int c) const { return m_connections[c]; }

  // the arcs that must all have length 0 for the connection to have length 0, few ones if there is
  // a choice
  std::vector<int> arcs(int connection) const
  {
    const Zero_connection& c = m_connections[connection];
    return c.arc >= 0 ? std::vector<int>{c.arc} : short_side(c.patch);
  }

  // the arcs of a side of zero length of a patch of zero extent
  std::vector<int> short_side(int patch) const
  {
    const auto sides = m_grid->t_mesh().sides(patch);
    const int k = m_grid->width(patch) == 0 ? 0 : 1;
    std::vector<int> result;
    for (int h : sides[k].size() <= sides[k + 2].size() ? sides[k] : sides[k + 2])
      result.push_back(T_mesh::edge(h));
    return result;
  }

  // the patches of zero width and height beside a connection, -1 for others
  std::pair<int, int> patches_beside(int connection) const
  {
    const int a = m_connections[connection].arc;
    if (a < 0)
      return {-1, -1};
    const T_mesh& t = m_grid->t_mesh();
    const auto point_or_none = [&](int p) { return p >= 0 && m_grid->is_point(p) ? p : -1; };
    return {point_or_none(t.face(2 * a)), point_or_none(t.face(2 * a + 1))};
  }

private:
  void collect_connections()
  {
    const T_mesh& t = m_grid->t_mesh();
    for (int a = 0; a < t.number_of_edges(); ++a)
      if (m_grid->length(a) == 0)
        m_connections.push_back({t.source(2 * a), t.target(2 * a), a, -1});
    for (int p = 0; p < t.number_of_faces(); ++p) {
      if (!m_grid->is_flat(p) || m_grid->is_point(p))
        continue;
      const auto& side = m_grid->side(p, m_grid->width(p) == 0 ? 1 : 0);
      for (std::size_t i = 1; i < side.size(); ++i)
        m_connections.push_back(
            {m_grid->source(side[i]), m_grid->target(m_grid->across(side[i])), -1, p});
    }
  }

  void group_points()
  {
    const int n = m_grid->number_of_points();
    Disjoint_sets sets(n);
    for (const Zero_connection& c : m_connections)
      sets.union_set(c.from, c.to);
    Numbered_classes classes = number_classes(sets, n);
    m_fibre_of_point = std::move(classes.class_of);
    m_fibres.resize(classes.number);
    for (int i = 0; i < n; ++i)
      m_fibres[fibre_of_point(i)].points.push_back(i);
    for (int c = 0; c < int(m_connections.size()); ++c)
      m_fibres[fibre_of_point(m_connections[c].from)].connections.push_back(c);
    const T_mesh& t = m_grid->t_mesh();
    for (int p = 0; p < t.number_of_faces(); ++p)
      if (m_grid->is_point(p))
        m_fibres[fibre_of_point(t.source(t.halfedge_of(p)))].patches.push_back(p);
  }

  const Arc_grid* m_grid;
  std::vector<Zero_connection> m_connections;
  std::vector<Fibre> m_fibres;
  std::vector<int> m_fibre_of_point;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_LAYOUT_FIBRES_H
