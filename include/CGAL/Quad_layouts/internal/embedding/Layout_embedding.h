// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_EMBEDDING_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_EMBEDDING_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/embedding/Anchor_search.h>
#include <CGAL/Quad_layouts/internal/embedding/Layout_charts.h>
#include <CGAL/Quad_layouts/internal/embedding/Merge_trees.h>
#include <CGAL/Quad_layouts/internal/embedding/Surface_charts.h>
#include <CGAL/Quad_layouts/internal/embedding/Target_directions.h>
#include <CGAL/Quad_layouts/internal/embedding/check_map.h>
#include <CGAL/Quad_layouts/internal/embedding/coarse_to_fine.h>
#include <CGAL/Quad_layouts/internal/layout/chord_divisions.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The roots of the clusters that must be held: those with an index, and one per component that has
// none with an index.
inline std::vector<Cone> choose_cones(const T_mesh& t_mesh, const Quad_layout& layout,
                                      const std::vector<Cluster_root>& roots)
{
  const int n = t_mesh.number_of_vertices();
  Disjoint_sets component(n);
  for (int a = 0; a < t_mesh.number_of_edges(); ++a)
    component.union_set(t_mesh.source(2 * a), t_mesh.target(2 * a));
  std::vector<char> has_cone(n, 0);
  std::vector<Cone> cones;
  const auto hold = [&](const Cluster_root& r) {
    has_cone[component.find_set(r.node)] = 1;
    cones.push_back({t_mesh.surface_vertex(r.node), layout.clusters[r.cluster].index, r.cluster});
  };
  for (const Cluster_root& r : roots)
    if (layout.clusters[r.cluster].index != 0)
      hold(r);
  for (const Cluster_root& r : roots)
    if (!has_cone[component.find_set(r.node)])
      hold(r);
  return cones;
}

// Puts the flat structure of the layout on the triangles of the surface.
inline Charted_mesh chart_surface(const Cross_field& field, const T_mesh& t_mesh,
                                  const Layout_charts& charts, const std::vector<Cone>& cones)
{
  const Triangle_surface& surface = t_mesh.surface();
  const Surface_charts surface_charts(t_mesh, charts);
  Charted_mesh mesh(surface);
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    mesh.transition[h] = surface_charts.across(h).chart;
  for (const Cone& c : cones)
    surface.for_each_outgoing(
        c.vertex, [&](int h) { mesh.cone_position[h] = surface_charts.node_position(h); });
  const Target_directions target(field, t_mesh, charts, surface_charts);
  for (int f = 0; f < surface.number_of_faces(); ++f)
    mesh.direction[f] = surface.direction(f, target.angles()[f]);
  return mesh;
}

// Rounds coordinates to what transitions keep exactly, and tells what the corners have in the
// charts of their faces.
inline Integer_grid_map to_integer_grid_map(const Charted_mesh& mesh, const Map& map,
                                            std::vector<int> chord_length)
{
  Integer_grid_map result;
  result.surface_pointer = std::make_shared<const Triangle_surface>(mesh.points, mesh.triangles());
  result.halfedge_transition = mesh.transition;
  result.chord_length = std::move(chord_length);
  constexpr double unit = 1 << 24;
  for (const Map::Face& f : map.faces)
    for (int k = 0; k < 3; ++k) {
      const Point2& x = map.coordinates[f.vertex[k]];
      result.corner_coordinates.push_back(
          f.chart[k](Point2(std::round(x.x() * unit), std::round(x.y() * unit)) / unit));
    }
  return result;
}

// Maps the surface onto the layout.
class Layout_embedding
{
public:
  Layout_embedding(const Cross_field& field, const T_mesh& t_mesh, const Quad_layout& layout,
                   double target_edge_length, const Monitor& monitor)
    : m_layout(layout), m_unit(target_edge_length), m_monitor(monitor),
      m_chord_length(chord_divisions(layout, target_edge_length)),
      m_mesh(charted_mesh(field, t_mesh))
  {
  }

  // Tries meshes of several sizes: what sticks on one is usually solved on another.
  Integer_grid_map map()
  {
    std::vector<char> is_cone(m_mesh.points.size(), 0);
    for (const Cone& c : m_cones)
      is_cone[c.vertex] = 1;
    const Map start = make_map(m_mesh, is_cone, m_unit);
    std::string reasons;
    constexpr Solution_attempt attempts[] = {
        {4000, 0.5, false}, {4000, 0.5, true},  {7000, 0.3, false}, {7000, 0.3, true},
        {3000, 0.2, false}, {12000, 0.2, true}, {12000, 0.2, false}};
    for (Solution_attempt attempt : attempts) {
      attempt.coarse_faces += 40 * int(m_cones.size());
      const std::string place = "; on " + std::to_string(attempt.coarse_faces) + " triangles: ";
      Map map = start;
      if (!solve_coarse_to_fine(map, m_cones, attempt, m_monitor)) {
        reasons += place + "inverted ones remain";
        continue;
      }
      Integer_grid_map result = to_integer_grid_map(m_mesh, map, m_chord_length);
      check(result, m_cones);
      if (result.inverted == 0 && result.wrong_winding == 0)
        result.anchors = Anchor_search(result, m_layout, cone_places()).anchors();
      if (!result.anchors.empty())
        return result;
      reasons += place + std::to_string(result.inverted) + " inverted, " +
                 std::to_string(result.wrong_winding) +
                 " wrong angle sums, or misplaced layout edges";
    }
    throw Stage_failure("embed: no valid map onto the layout was found" + reasons);
  }

private:
  Charted_mesh charted_mesh(const Cross_field& field, const T_mesh& t_mesh)
  {
    const Merge_trees trees(t_mesh, m_layout);
    m_cones = choose_cones(t_mesh, m_layout, trees.roots());
    const Layout_charts charts(t_mesh, m_layout, m_chord_length, trees.transfers());
    check_indices(t_mesh, trees, charts);
    Charted_mesh mesh = chart_surface(field, t_mesh, charts, m_cones);
    refine_around_cones(mesh, m_cones);
    return mesh;
  }

  // The roots of the clusters must have the whole index of their clusters, all other nodes none.
  void check_indices(const T_mesh& t_mesh, const Merge_trees& trees,
                     const Layout_charts& charts) const
  {
    std::vector<int> index(t_mesh.number_of_vertices(), 0);
    for (const Cluster_root& r : trees.roots())
      index[r.node] = m_layout.clusters[r.cluster].index;
    for (int n = 0; n < t_mesh.number_of_vertices(); ++n)
      if (!charts.has_index(n, index[n]))
        throw Stage_failure("embed: the index of T-mesh node " + std::to_string(n) +
                            " could not be gathered");
  }

  std::vector<Anchor_search::Cone_place> cone_places() const
  {
    std::vector<Anchor_search::Cone_place> result;
    for (const Cone& c : m_cones)
      result.push_back({c.vertex, m_layout.clusters[c.cluster].vertex});
    return result;
  }

  const Quad_layout& m_layout;
  double m_unit;
  const Monitor& m_monitor;
  std::vector<int> m_chord_length;
  std::vector<Cone> m_cones;
  Charted_mesh m_mesh;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_EMBEDDING_H
