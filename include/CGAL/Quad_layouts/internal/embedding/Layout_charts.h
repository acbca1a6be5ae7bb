// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_CHARTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_CHARTS_H

#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/embedding/Merge_trees.h>

#include <numeric>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

using Chart_change = Integer_grid_map::Transition;

// returns the rotation about `center` by `quarter_turns`
inline Chart_change rotation_about(const Point2& center, int quarter_turns)
{
  return {quarter_turns & 3, center - Chart_change::turned(center, quarter_turns)};
}

// The flat structure that a layout gives to the T-mesh: one chart per patch, in which side 0 begins
// at the origin and runs along +x, and an integer change of chart across every arc.
//
// At first every singularity is a cone of its own. The cones of a merged cluster are then gathered
// in its anchor, along the tree by which the members are connected: a cut along the connection from
// a child to its parent, with a rotation about the layout vertex O by the summed index of the
// child's subtree, takes the index away from the child and gives it to the parent. A connection is
// either an arc of length zero or runs straight through a patch of zero width. In the latter case
// the cut is pushed to the boundary of that patch, so that it runs along whole arcs, too; the arcs
// and nodes that it separates from the patch are then seen through the rotation ("attached" to the
// chart by it).
class Layout_charts
{
public:
  Layout_charts(const T_mesh& t_mesh, const Quad_layout& layout,
                const std::vector<int>& chord_length, const std::vector<Index_transfer>& transfers)
    : m_t_mesh(t_mesh), m_layout(layout), m_chord_length(chord_length)
  {
    lay_out_patches();
    for (const Index_transfer& transfer : transfers)
      hand_on(transfer);
  }

  // the change from the chart of the patch of h to that of the patch on the other side
  Chart_change across(int h) const
  {
    return m_attachment[h ^ 1].after(m_original_change[h]).after(m_attachment[h].inverse());
  }

  // the quarter-turns in `across(h)` that are due to cuts, as a signed number (modulo 4 would lose
  // it)
  int cut_turns(int h) const { return m_cut_turns[h]; }

  // where the source of h is in the chart of the patch of h
  Point2 source_position(int h) const { return m_attachment[h](m_source_position[h]); }

  // Whether going around node n, clockwise, changes the chart by a rotation about n that takes back
  // `index` quarter-turns.
  bool has_index(int n, int index) const
  {
    Chart_change loop;
    const int first = m_t_mesh.halfedge_from(n);
    int h = first;
    do {
      loop = across(h).after(loop);
      h = m_t_mesh.turn_right(h);
    } while (h != first);
    const Point2 position = source_position(first);
    return loop.quarter_turns == (-index & 3) && loop(position) == position;
  }

  // the direction of h in the chart of its patch before any cut, in quarter-turns from +x
  int direction(int h) const { return m_direction[h]; }

private:
  // the length of the first `units` units of h in the charts
  int length(int h, int units) const
  {
    const std::vector<int>& path = m_layout.arc_halfedges[h / 2];
    const auto chord_length = [&](int sum, int g) {
      return sum + m_chord_length[m_layout.chord(Quad_layout::edge(g))];
    };
    return h % 2 == 0 ? std::accumulate(path.begin(), path.begin() + units, 0, chord_length)
                      : std::accumulate(path.end() - units, path.end(), 0, chord_length);
  }
  int length(int h) const { return length(h, int(m_layout.arc_halfedges[h / 2].size())); }

  // the point at a distance from the source of h, before any cut
  Point2 position_along(int h, int distance) const
  {
    return m_source_position[h] + Chart_change::turned(Point2(distance, 0), m_direction[h]);
  }

  void lay_out_patches()
  {
    const int nh = m_t_mesh.number_of_halfedges();
    m_source_position.resize(nh);
    m_direction.resize(nh);
    for (int p = 0; p < m_t_mesh.number_of_faces(); ++p) {
      Point2 position(0, 0);
      const auto sides = m_t_mesh.sides(p);
      for (int k = 0; k < 4; ++k)
        for (const int h : sides[k]) {
          m_source_position[h] = position;
          m_direction[h] = k;
          position = position_along(h, length(h));
        }
      CGAL_assertion(position == Point2(0, 0));
    }
    m_original_change.resize(nh);
    for (int h = 0; h < nh; ++h) {
      const int turns = (m_direction[h ^ 1] + 2 - m_direction[h]) & 3;
      m_original_change[h] = {turns, position_along(h ^ 1, length(h)) -
                                         Chart_change::turned(m_source_position[h], turns)};
    }
    m_attachment.resize(nh);
    m_cut_turns.assign(nh, 0);
  }

  // The layout vertex is where the fibre or the arc is before any cut: cuts along arcs through it
  // leave it in place, and the cuts of fibres above do not touch it.
  void hand_on(const Index_transfer& transfer)
  {
    const Chart_change turn = rotation_about(
        position_along(transfer.halfedge, length(transfer.halfedge, transfer.units)),
        -transfer.index);
    for (const int h : transfer.path) {
      m_attachment[h] = turn.after(m_attachment[h]);
      m_cut_turns[h] += transfer.index;
      m_cut_turns[h ^ 1] -= transfer.index;
    }
  }

  const T_mesh& m_t_mesh;
  const Quad_layout& m_layout;
  const std::vector<int>& m_chord_length;
  std::vector<Point2> m_source_position; // per halfedge, in the chart of its patch, before any cut
  std::vector<int> m_direction;          // per halfedge, in quarter-turns from +x
  std::vector<Chart_change> m_original_change; // per halfedge, before any cut
  std::vector<Chart_change>
      m_attachment;             // per halfedge, from the original chart to the one after all cuts
  std::vector<int> m_cut_turns; // per halfedge
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_CHARTS_H
