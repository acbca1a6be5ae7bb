// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_EMBEDDING_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_EMBEDDING_H

#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/embedding/Anchor_search.h>
#include <CGAL/Quad_layouts/internal/embedding/Layout_curves.h>
#include <CGAL/Quad_layouts/internal/embedding/Overlay_reduction.h>
#include <CGAL/Quad_layouts/internal/embedding/Square_map.h>
#include <CGAL/Quad_layouts/internal/embedding/check_embedded_layout.h>
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

// The layout vertices that are held at integer points: all irregular ones and corners of fixed
// curves, and one of each component that has none. `place` tells, per layout vertex, where on the
// mesh it is.
inline std::vector<Cone> choose_cones(const Quad_layout& layout, const std::vector<int>& place)
{
  const int n = layout.number_of_vertices();
  Disjoint_sets component(n);
  for (int e = 0; e < layout.number_of_edges(); ++e)
    component.union_set(layout.source(2 * e), layout.target(2 * e));
  std::vector<char> has_cone(n, 0);
  std::vector<Cone> cones;
  const auto hold = [&](int v) {
    has_cone[component.find_set(v)] = 1;
    cones.push_back({place[v], layout.index(v), v});
  };
  for (int v = 0; v < n; ++v)
    if (!layout.goes_straight_on(v))
      hold(v);
  for (int v = 0; v < n; ++v)
    if (!has_cone[component.find_set(v)])
      hold(v);
  return cones;
}

// tells what coordinates the corners have in the charts of their faces
inline Integer_grid_map to_integer_grid_map(const Curve_mesh& mesh, const Layout_squares& squares,
                                            const Map& map, std::vector<int> chord_length)
{
  Integer_grid_map result;
  Triangle_surface surface(mesh.points, mesh.triangles());
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    if (mesh.is_fixed[h])
      surface.fix(h);
  result.surface_pointer = std::make_shared<const Triangle_surface>(std::move(surface));
  for (const int l : mesh.curve)
    result.halfedge_transition.push_back(squares.across(l));
  result.chord_length = std::move(chord_length);
  for (const Map::Face& f : map.faces)
    for (const Point2& x : map.corners(f))
      result.corner_coordinates.push_back(x);
  return result;
}

// Maps the surface onto the layout.
class Layout_embedding
{
public:
  Layout_embedding(const T_mesh& t_mesh, const Quad_layout& layout, double target_edge_length,
                   const Monitor& monitor)
    : m_t_mesh(t_mesh), m_layout(layout), m_unit(target_edge_length), m_monitor(monitor),
      m_chord_length(chord_divisions(layout, target_edge_length)), m_squares(layout, m_chord_length)
  {
  }

  Integer_grid_map map() const
  {
    Embedded_layout embedded = Layout_curves(m_t_mesh, m_layout, m_monitor).result();
    m_monitor.report("embed", 0.2);
    reduce(embedded, m_t_mesh.surface().number_of_vertices(), m_monitor);
    check_embedded_layout(embedded, m_layout);
    m_monitor.report("embed", 0.3);
    const std::vector<Cone> cones = choose_cones(m_layout, embedded.vertices);
    Integer_grid_map result = to_integer_grid_map(embedded.mesh, m_squares, solve(embedded, cones),
                                                  m_chord_length);
    verify(result, cones);
    return result;
  }

private:
  // Begins with as few triangles as there can be, where Tutte's method leaves all of them room;
  // brings back vertices up to a coarse mesh, whose map is relaxed as a whole, and then the others.
  Map solve(const Embedded_layout& embedded, const std::vector<Cone>& cones) const
  {
    std::vector<char> is_cone(embedded.mesh.points.size(), 0);
    for (const Cone& c : cones)
      is_cone[c.vertex] = 1;
    Map map = make_map(embedded.mesh, m_squares, is_cone, m_unit);
    Vertex_removal levels(map, embedded.vertices, is_cone);
    levels.simplify(4000 + 6 * m_layout.number_of_faces(), m_monitor);
    const int removals_of_coarse_mesh = levels.number_of_removals();
    levels.simplify(0, m_monitor);
    m_monitor.report("embed", 0.4);
    Map coarsest = levels.coarse_map();
    Square_map(coarsest, embedded.vertices, m_layout, m_squares);
    map.coordinates = std::move(coarsest.coordinates);
    constexpr Likeness alike{1, 0.5}; // what is narrow on the surface may first be wide in the map
    restore<Distortion>(map, levels, removals_of_coarse_mesh, is_cone, m_monitor, alike);
    m_monitor.report("embed", 0.5);
    relax_coarse_map(map, levels, is_cone, m_monitor);
    m_monitor.report("embed", 0.7);
    restore<Squared_distortion>(map, levels, 0, is_cone, m_monitor);
    m_monitor.report("embed", 0.9);
    sweep<Squared_distortion>(map, levels, is_cone, m_monitor);
    return map;
  }

  void verify(Integer_grid_map& map, const std::vector<Cone>& cones) const
  {
    check(map, cones);
    if (map.inverted > 0 || map.wrong_winding > 0)
      throw Stage_failure("embed: " + std::to_string(map.inverted) + " inverted triangles and " +
                          std::to_string(map.wrong_winding) + " wrong angle sums remain");
    std::vector<Anchor_search::Cone_place> places;
    for (const Cone& c : cones)
      places.push_back({c.vertex, c.layout_vertex});
    map.anchors = Anchor_search(map, m_layout, places).anchors();
    if (map.anchors.empty())
      throw Stage_failure("embed: the map does not lead along the edges of the layout");
  }

  const T_mesh& m_t_mesh;
  const Quad_layout& m_layout;
  double m_unit;
  const Monitor& m_monitor;
  std::vector<int> m_chord_length;
  Layout_squares m_squares;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_LAYOUT_EMBEDDING_H
