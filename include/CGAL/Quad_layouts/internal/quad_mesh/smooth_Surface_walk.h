// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_SURFACE_WALK_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_SURFACE_WALK_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_tree.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Points that slide on a surface.
//
// A point knows its triangle, and follows a target in space by walking from triangle to triangle as
// long as that brings it closer. Unlike a search for the nearest point of the whole surface this is
// fast, and can never jump to the other sheet of a thin part. Points on fixed edges of the surface,
// like those of its border, go from fixed edge to fixed edge in the same way; other points do not
// cross these.
class Surface_walk
{
public:
  using Vector = Eigen::Vector3d;

  struct Place
  {
    Vector point;
    int face;
    int fixed_halfedge = -1; // that of the face on which the point has to stay
  };

  explicit Surface_walk(const Triangle_surface& surface)
    : m_surface(surface), m_tree(corners(surface)),
      m_corner_normals(surface.number_of_halfedges(), Vector::Zero()), m_twin(twins(surface))
  {
    for (int h = 0; h < surface.number_of_halfedges(); ++h)
      for_each_corner_on_this_side(
          h, [&](int g) { m_corner_normals[h] += surface.area_vector(surface.face(g)); });
    for (Vector& n : m_corner_normals)
      n.stableNormalize();
  }

  // the place nearest to p. A triangle whose normal opposes `normal` is taken only if all others
  // are several times as far away: it may belong to the other sheet of a thin part.
  Place locate(const Vector& p, const Vector& normal) const
  {
    constexpr double several = 4;
    const auto nearest = m_tree.nearest(p);
    if (agrees(nearest.triangle, normal))
      return {nearest.point, nearest.triangle};
    const auto agreeing = m_tree.nearest_if(p, [&](int t) { return agrees(t, normal); });
    const auto& chosen = agreeing.distance <= several * nearest.distance ? agreeing : nearest;
    return {chosen.point, chosen.triangle};
  }

  // the place on fixed edges of the faces around `place` that is nearest to its point, or `place`
  // itself if there are none
  Place nearest_on_fixed_edges(const Place& place) const
  {
    Place best = place;
    double least = (std::numeric_limits<double>::infinity)();
    for (int corner = 3 * place.face; corner < 3 * place.face + 3; ++corner)
      m_surface.for_each_outgoing(m_surface.source(corner), [&](int g) {
        const int first = 3 * m_surface.face(g);
        for (int h = first; h < first + 3; ++h) {
          if (!m_surface.is_fixed(h))
            continue;
          const Vector p = nearest_on_edge(h, place.point).point;
          if ((p - place.point).squaredNorm() < least) {
            least = (p - place.point).squaredNorm();
            best = {p, m_surface.face(h), h};
          }
        }
      });
    return best;
  }

  // the direction of the fixed edge of a place that has to stay there
  Vector tangent(const Place& place) const
  {
    return m_surface.vector(place.fixed_halfedge).stableNormalized();
  }

  // Returns the unit normal of the triangle nearest to p. If that is no single one, as they share
  // an edge or vertex, or touch each other there, or p is in the middle of a part, the normal is
  // the one that agrees least with `direction`. The search is short if p is near to a face.
  Vector nearest_normal(const Vector& p, const Vector& direction, int face) const
  {
    const Projection near = walk(face, p);
    const auto agrees_less = [&](int face, int other) {
      return m_surface.normal(face).dot(direction) < m_surface.normal(other).dot(direction);
    };
    int result =
        m_tree.nearest(p, {near.point, near.face, std::sqrt(near.squared_distance)}, agrees_less)
            .triangle;
    for_each_face_beyond(project(result, p), [&](int beyond) {
      if (agrees_less(beyond, result))
        result = beyond;
    });
    return m_surface.normal(result);
  }

  // the place to which a point that follows `target` gets from `start`
  Place slide(const Place& start, const Vector& target) const
  {
    if (start.fixed_halfedge >= 0)
      return slide_on_fixed_edges(start, target);
    const Projection reached = walk(start.face, target);
    return {reached.point, reached.face};
  }

  // the unit normal of the surface at a place, interpolated between the corners of its face; it
  // bends across fixed edges
  Vector normal(const Place& place) const
  {
    Vector sum = Vector::Zero();
    for (int h = 3 * place.face; h < 3 * place.face + 3; ++h) {
      const Vector& a = m_surface.point(m_surface.target(h));
      const Vector& b = m_surface.point(m_surface.target(m_surface.next(h)));
      const double weight = (a - place.point).cross(b - place.point).norm();
      sum += weight * m_corner_normals[h];
    }
    const Vector flat = m_surface.normal(place.face);
    return sum.dot(flat) > 0 ? Vector(sum.stableNormalized()) : flat;
  }

  const Triangle_surface& surface() const { return m_surface; }

private:
  // The point of a face that is nearest to a target. It lies inside the face, on the edge of one of
  // its halfedges, or at the source of one of them.
  struct Projection
  {
    enum Where { INSIDE, ON_EDGE, AT_VERTEX };

    Vector point;
    int face;
    Where where = INSIDE;
    int halfedge = -1;
    double squared_distance = 0;
  };

  static std::vector<Triangle_tree::Corners> corners(const Triangle_surface& surface)
  {
    std::vector<Triangle_tree::Corners> result;
    for (int f = 0; f < surface.number_of_faces(); ++f)
      result.push_back({surface.point(surface.source(3 * f)), surface.point(surface.target(3 * f)),
                        surface.point(surface.source(3 * f + 2))});
    return result;
  }

  bool agrees(int face, const Vector& normal) const
  {
    return m_surface.area_vector(face).dot(normal) > 0;
  }

  Projection project(int face, const Vector& target) const
  {
    const Vector n = m_surface.area_vector(face);
    Projection best;
    best.face = face;
    bool inside = true;
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      const Vector side = m_surface.vector(h),
                   to_target = target - m_surface.point(m_surface.source(h));
      if (n.cross(side).dot(to_target) >= 0)
        continue;
      const Projection p = project_to_edge(h, side, to_target, target);
      if (inside || p.squared_distance < best.squared_distance)
        best = p;
      inside = false;
    }
    if (inside) {
      best.point = target - n * (n.dot(target - m_surface.point(m_surface.source(3 * face))) /
                                 n.squaredNorm());
      best.squared_distance = (best.point - target).squaredNorm();
    }
    return best;
  }

  // walks from a face as long as that leads closer to a target
  Projection walk(int face, const Vector& target) const
  {
    Projection here = project(face, target);
    while (step_closer(target, here)) {}
    return here;
  }

  Projection nearest_on_edge(int h, const Vector& p) const
  {
    return project_to_edge(h, m_surface.vector(h), p - m_surface.point(m_surface.source(h)), p);
  }

  Place slide_on_fixed_edges(const Place& start, const Vector& target) const
  {
    int h = start.fixed_halfedge;
    Projection here = nearest_on_edge(h, target);
    while (here.where == Projection::AT_VERTEX) {
      const int g = m_surface.other_fixed_halfedge(h, m_surface.source(here.halfedge));
      if (g < 0)
        break;
      const Projection there = nearest_on_edge(g, target);
      if (!(there.squared_distance < here.squared_distance))
        break;
      here = there;
      h = g;
    }
    return {here.point, m_surface.face(h), h};
  }

  Projection project_to_edge(int h, const Vector& side, const Vector& to_target,
                             const Vector& target) const
  {
    const double t = side.dot(to_target) / side.squaredNorm();
    Projection result;
    result.face = m_surface.face(h);
    result.where = t > 0 && t < 1 ? Projection::ON_EDGE : Projection::AT_VERTEX;
    result.halfedge = t < 1 ? h : m_surface.next(h);
    result.point = result.where == Projection::ON_EDGE
                       ? Vector(m_surface.point(m_surface.source(h)) + t * side)
                       : m_surface.point(m_surface.source(result.halfedge));
    result.squared_distance = (result.point - target).squaredNorm();
    return result;
  }

  // per vertex the next one at the same point, in cycles
  static std::vector<int> twins(const Triangle_surface& surface)
  {
    std::vector<int> sorted(surface.number_of_vertices()), result(sorted.size());
    std::iota(sorted.begin(), sorted.end(), 0);
    const auto coordinates = [&](int v) {
      const Vector& p = surface.point(v);
      return std::make_tuple(p.x(), p.y(), p.z());
    };
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](int u, int v) { return coordinates(u) < coordinates(v); });
    for (std::size_t first = 0, i = 0; i < sorted.size(); ++i) {
      const bool is_last = i + 1 == sorted.size() ||
                           coordinates(sorted[i]) < coordinates(sorted[i + 1]);
      result[sorted[i]] = sorted[is_last ? first : i + 1];
      if (is_last)
        first = i + 1;
    }
    return result;
  }

  template <class Visit>
  void for_each_twin(int v, const Visit& visit) const
  {
    int u = v;
    do {
      visit(u);
      u = m_twin[u];
    } while (u != v);
  }

  // visits the faces that meet in the edge or vertex at which `here` lies, also those that only
  // touch there because the surface does not connect them
  template <class Visit>
  void for_each_face_beyond(const Projection& here, const Visit& visit) const
  {
    const auto visit_face = [&](int h) { visit(m_surface.face(h)); };
    if (here.where == Projection::AT_VERTEX)
      for_each_twin(m_surface.source(here.halfedge),
                    [&](int v) { m_surface.for_each_outgoing(v, visit_face); });
    else if (here.where == Projection::ON_EDGE)
      for_each_halfedge_along(here.halfedge, visit_face);
  }

  // visits the opposite of h, or all halfedges between twins of its ends if both have some
  template <class Visit>
  void for_each_halfedge_along(int h, const Visit& visit) const
  {
    const int a = m_surface.source(h), b = m_surface.target(h);
    const auto visit_between = [&](int from, int to) {
      for_each_twin(from, [&](int v) {
        m_surface.for_each_outgoing(v, [&](int g) {
          if (m_surface.point(m_surface.target(g)) == m_surface.point(to))
            visit(g);
        });
      });
    };
    if (m_twin[a] != a && m_twin[b] != b) {
      visit_between(a, b);
      visit_between(b, a);
    } else if (m_surface.opposite(h) >= 0)
      visit(m_surface.opposite(h));
  }

  // visits those of these faces that are on the same side of fixed edges
  template <class Visit>
  void for_each_face_on_this_side(const Projection& here, const Visit& visit) const
  {
    if (here.where == Projection::ON_EDGE && !m_surface.is_fixed(here.halfedge))
      visit(m_surface.face(m_surface.opposite(here.halfedge)));
    else if (here.where == Projection::AT_VERTEX)
      for_each_corner_on_this_side(here.halfedge, [&](int h) { visit(m_surface.face(h)); });
  }

  // visits the halfedges whose corners are reached from that of `first` around its source without
  // crossing fixed edges, and this itself
  template <class Visit>
  void for_each_corner_on_this_side(int first, const Visit& visit) const
  {
    visit(first);
    for (int h = first; !m_surface.is_fixed(m_surface.prev(h));) {
      h = m_surface.turn_left(h);
      if (h == first)
        return;
      visit(h);
    }
    for (int h = first; !m_surface.is_fixed(h);) {
      h = m_surface.turn_right(h);
      visit(h);
    }
  }

  // moves to the best of the faces that share the edge or vertex at which `here` lies, but not
  // across fixed edges
  bool step_closer(const Vector& target, Projection& here) const
  {
    const double reached = here.squared_distance;
    for_each_face_on_this_side(Projection(here), [&](int face) {
      const Projection p = project(face, target);
      if (p.squared_distance < here.squared_distance)
        here = p;
    });
    return here.squared_distance < reached;
  }

  const Triangle_surface& m_surface;
  const Triangle_tree m_tree;
  std::vector<Vector> m_corner_normals; // per halfedge, at its source, of this side of fixed edges
  std::vector<int> m_twin;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_SURFACE_WALK_H
