// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUADS_ON_SURFACE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUADS_ON_SURFACE_H

#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_shape.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Curve_vertices.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Star.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Surface_walk.h>

#include <Eigen/Core>

#include <algorithm>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A quad mesh whose vertices have places on a surface; those on its border and feature curves,
// places on those of the surface.
class Quads_on_surface
{
public:
  using Vector = Eigen::Vector3d;
  using Place = Surface_walk::Place;

  // Takes a mesh of quads and puts its vertices on the surface, except those on fixed curves where
  // these do not go straight on.
  Quads_on_surface(Polygons& mesh, const Surface_walk& walk)
    : m_mesh(mesh), m_walk(walk), m_curve_vertices(mesh, walk.surface()),
      m_corners(mesh.number_of_vertices()), m_normals(mesh.number_of_vertices()),
      m_on_curve(mesh.number_of_vertices())
  {
    for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
      m_corners[mesh.source[h]].push_back(h);
      if (mesh.is_border(h))
        m_on_curve[mesh.target(h)].push_back(mesh.source[h]);
      if (mesh.is_fixed(h))
        m_on_curve[mesh.source[h]].push_back(mesh.target(h));
    }
    place_vertices();
    std::vector<int> sliding;
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      if (!m_corners[v].empty() && (!is_on_curve(v) || slides_on_curve(v))) {
        m_movable.push_back(v);
        m_mesh.points[v] = m_places[v].point;
        if (is_on_curve(v))
          sliding.push_back(v);
      }
    m_curve_vertices.add(sliding, m_places, m_on_curve);
  }

  const Polygons& mesh() const { return m_mesh; }
  const Surface_walk& walk() const { return m_walk; }
  bool is_on_curve(int v) const { return !m_on_curve[v].empty(); }
  // the mean of the neighbours of v on its curve
  Vector middle_on_curve(int v) const
  {
    Vector sum = Vector::Zero();
    for (const int u : m_on_curve[v])
      sum += m_mesh.points[u];
    return sum / double(m_on_curve[v].size());
  }
  // the movable vertices on curves, what they may do there, and how far their edges are from it
  const Curve_vertices& curve_vertices() const { return m_curve_vertices; }
  // the vertices that may move, ascending
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
  Quad_on_surface quad_on_surface(int f) const { return quad_from(m_mesh.first_halfedge[f]); }

  // the normal of the triangle nearest to the centre of a quad, one of whose corners is v
  Vector surface_normal(const Quad& quad, int v) const
  {
    return m_walk.nearest_normal(centre(quad), area_vector(quad), m_places[v].face);
  }

  // the scaled Jacobian, or minus one if the quad opposes the surface
  double score(int f) const
  {
    const Quad quad = this->quad(f);
    return area_vector(quad).dot(surface_normal(quad, m_mesh.corner(f, 0))) < 0
               ? -1
               : scaled_jacobian(quad);
  }
  // the quads that are inverted or oppose the surface, ascending
  std::vector<int> bad_quads() const
  {
    std::vector<int> result;
    for (int f = 0; f < m_mesh.number_of_faces(); ++f)
      if (!(score(f) > 0))
        result.push_back(f);
    return result;
  }

  // says if the curve on which a movable vertex is, if there is one, permits it to move to a place
  // that it slides to
  bool is_permitted(int v, const Place& place) const
  {
    return !is_on_curve(v) || m_curve_vertices.permits(v, m_places[v], place);
  }

  void move(int v, const Place& place)
  {
    m_places[v] = place;
    if (is_on_curve(v))
      m_curve_vertices.move(v, place);
    m_mesh.points[v] = place.point;
    m_normals[v] = m_walk.normal(place);
  }

  // the place that v gets to from its own by following `target`
  Place reached(int v, const Vector& target) const { return m_walk.slide(m_places[v], target); }
  // moves v there, if it may
  void slide(int v, const Vector& target)
  {
    if (const Place place = reached(v, target); is_permitted(v, place))
      move(v, place);
  }

  void gather_star(int v, Star& star) const
  {
    star.clear();
    for (const int h : m_corners[v])
      star.add(quad_from(h));
    for (const int h : m_corners[v])
      if (const int last = m_mesh.prev(h); m_mesh.is_border(last))
        star.add_edge(m_mesh.points[m_mesh.source[last]], m_normals[m_mesh.source[last]]);
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
      m_places.push_back(m_walk.locate(m_mesh.points[v], normal));
      if (is_on_border(v))
        m_places[v] = place_from_inside(v, normal);
      if (is_on_curve(v))
        m_places[v] = m_walk.nearest_on_fixed_edges(m_places[v]);
      m_normals[v] = m_walk.normal(m_places[v]);
    }
  }

  // The place of a vertex on the border to which a way on the surface leads from its quads, if it
  // is at the same point as the place that it has, up to rounding: so are the two sides of a slit.
  Place place_from_inside(int v, const Vector& normal) const
  {
    Vector centre = Vector::Zero();
    for (const int h : m_corners[v])
      for (const Vector& corner : quad(m_mesh.face[h]))
        centre += corner / (4 * double(m_corners[v].size()));
    const Place result = m_walk.slide(m_walk.locate(centre, normal), m_mesh.points[v]);
    const double rounding = 1e-6 * edge_length(v);
    return (result.point - m_places[v].point).norm() <= rounding ? result : m_places[v];
  }

  bool is_on_border(int v) const
  {
    return std::any_of(m_corners[v].begin(), m_corners[v].end(),
                       [this](int h) { return m_mesh.is_border(h); });
  }

  bool slides_on_curve(int v) const
  {
    return m_places[v].fixed_halfedge >= 0 && goes_straight_on(v);
  }

  // whether v is regular, and the only curve there goes straight on
  bool goes_straight_on(int v) const
  {
    const std::vector<int>& curve = m_on_curve[v];
    const auto on_curve = [&](int u) {
      return std::find(curve.begin(), curve.end(), u) != curve.end();
    };
    const bool has_corner = std::any_of(m_corners[v].begin(), m_corners[v].end(), [&](int h) {
      return on_curve(m_mesh.target(h)) && on_curve(m_mesh.source[m_mesh.prev(h)]);
    });
    return curve.size() == 2 && m_corners[v].size() == (is_on_border(v) ? 2 : 4) && !has_corner;
  }

  // Corners on curves get the mean of the normals at the others: the surface may be sharply bent
  // there, and only the side of the quad matters. A quad with all corners on curves gets its own
  // normal: their order along the curves keeps it from turning over.
  Quad_on_surface quad_from(int h) const
  {
    Quad_on_surface result;
    std::array<bool, 4> is_on_curve;
    Vector beside = Vector::Zero();
    for (int k = 0; k < 4; ++k, h = m_mesh.next(h)) {
      const int v = m_mesh.source[h];
      result.quad[k] = m_mesh.points[v];
      result.normals[k] = m_normals[v];
      is_on_curve[k] = this->is_on_curve(v);
      if (!is_on_curve[k])
        beside += m_normals[v];
    }
    if (beside == Vector::Zero())
      beside = area_vector(result.quad);
    beside.stableNormalize();
    for (int k = 0; k < 4; ++k)
      if (is_on_curve[k])
        result.normals[k] = beside;
    return result;
  }

  Polygons& m_mesh;
  const Surface_walk& m_walk;
  Curve_vertices m_curve_vertices;
  std::vector<std::vector<int>> m_corners;
  std::vector<int> m_movable;
  std::vector<Place> m_places;
  std::vector<Vector> m_normals;
  std::vector<std::vector<int>> m_on_curve; // per vertex its neighbours on fixed curves
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUADS_ON_SURFACE_H
