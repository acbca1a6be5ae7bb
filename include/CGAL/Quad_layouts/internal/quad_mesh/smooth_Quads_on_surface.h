// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUADS_ON_SURFACE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUADS_ON_SURFACE_H

#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_shape.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Star.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Surface_walk.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A quad mesh whose vertices have places on a surface; those on its border, places on that of the
// surface.
class Quads_on_surface
{
public:
  using Vector = Eigen::Vector3d;
  using Place = Surface_walk::Place;

  // Takes a mesh of quads and puts its vertices on the surface, except irregular ones on its border.
  Quads_on_surface(Polygons& mesh, const Surface_walk& walk)
    : m_mesh(mesh), m_walk(walk), m_corners(mesh.number_of_vertices()),
      m_normals(mesh.number_of_vertices()),
      m_border(mesh.number_of_vertices(), std::make_pair(-1, -1))
  {
    for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
      m_corners[mesh.source[h]].push_back(h);
      if (mesh.is_border(h)) {
        m_border[mesh.source[h]].second = mesh.target(h);
        m_border[mesh.target(h)].first = mesh.source[h];
      }
    }
    place_vertices();
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      if (!m_corners[v].empty() && (!is_on_border(v) || m_places[v].fixed_halfedge >= 0)) {
        m_movable.push_back(v);
        m_mesh.points[v] = m_places[v].point;
      }
  }

  const Polygons& mesh() const { return m_mesh; }
  const Surface_walk& walk() const { return m_walk; }
  bool is_on_border(int v) const { return m_border[v].first >= 0; }
  // the points before and behind v on the border
  std::pair<Vector, Vector> border_neighbours(int v) const
  {
    return {m_mesh.points[m_border[v].first], m_mesh.points[m_border[v].second]};
  }
  // the vertices that are not irregular ones on the border, ascending
  const std::vector<int>& movable() const { return m_movable; }
  // the halfedges from a vertex
  const std::vector<int>& corners(int v) const { return m_corners[v]; }
  const Place& place(int v) const { return m_places[v]; }
  std::vector<Place> places(const std::vector<int>& vertices) const
  {
    std::vector<Place> result;
    for (const int v : vertices)
      result.push_back(m_places[v]);
    return result;
  }
  // the unit normal of the surface at a vertex's place
  const Vector& normal(int v) const { return m_normals[v]; }
  // the mean length of the edges at a vertex
  double edge_length(int v) const
  {
    double sum = 0;
    for (const int h : m_corners[v])
      sum += (m_mesh.points[m_mesh.target(h)] - m_mesh.points[v]).norm();
    return sum / (std::max)(double(m_corners[v].size()), 1.);
  }
  Quad quad(int f) const { return quad_of(m_mesh, f); }

  void move(int v, const Place& place)
  {
    m_places[v] = place;
    m_mesh.points[v] = place.point;
    m_normals[v] = m_walk.normal(place);
  }

  // moves v to where it gets from its place by following `target`
  void slide(int v, const Vector& target) { move(v, m_walk.slide(m_places[v], target)); }

  void gather_star(int v, Star& star) const
  {
    star.clear();
    for (const int h : m_corners[v])
      star.add(quad_from(h));
    if (is_on_border(v))
      star.add_edge(m_mesh.points[m_border[v].first], m_normals[m_border[v].first]);
    star.weigh_edges();
  }

  // the movable vertices up to `rings` quads away from the given ones, ascending
  std::vector<int> surroundings(const std::vector<int>& quads, int rings) const
  {
    std::vector<char> inside(m_mesh.number_of_vertices(), 0);
    const auto add = [&](int f, std::vector<int>& added) {
      for (int k = 0; k < 4; ++k)
        if (!inside[m_mesh.corner(f, k)]) {
          inside[m_mesh.corner(f, k)] = 1;
          added.push_back(m_mesh.corner(f, k));
        }
    };
    std::vector<int> front, next;
    for (const int f : quads)
      add(f, front);
    for (; rings > 0; --rings, front.swap(next)) {
      next.clear();
      for (const int v : front)
        for (const int h : m_corners[v])
          add(m_mesh.face[h], next);
    }
    std::vector<int> result;
    std::copy_if(m_movable.begin(), m_movable.end(), std::back_inserter(result),
                 [&](int v) { return inside[v]; });
    return result;
  }

private:
  void place_vertices()
  {
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v) {
      Vector normal = Vector::Zero();
      for (const int h : m_corners[v])
        normal += area_vector(quad(m_mesh.face[h]));
      m_places.push_back(m_walk.locate(m_mesh.points[v], normal, 0.25 * edge_length(v)));
      constexpr std::size_t of_regular_vertex = 2;
      if (is_on_border(v) && m_corners[v].size() == of_regular_vertex)
        m_places[v] = m_walk.nearest_on_fixed_edges(m_places[v]);
      m_normals[v] = m_walk.normal(m_places[v]);
    }
  }

  Quad_on_surface quad_from(int h) const
  {
    Quad_on_surface result;
    for (int k = 0; k < 4; ++k, h = m_mesh.next(h)) {
      result.quad[k] = m_mesh.points[m_mesh.source[h]];
      result.normals[k] = m_normals[m_mesh.source[h]];
    }
    return result;
  }

  Polygons& m_mesh;
  const Surface_walk& m_walk;
  std::vector<std::vector<int>> m_corners;
  std::vector<int> m_movable;
  std::vector<Place> m_places;
  std::vector<Vector> m_normals;
  std::vector<std::pair<int, int>> m_border; // per vertex those before and behind it on the border
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUADS_ON_SURFACE_H
