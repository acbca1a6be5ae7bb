// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_CURVE_VERTICES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_CURVE_VERTICES_H

#include <CGAL/Quad_layouts/internal/quad_mesh/curve_distance.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Surface_walk.h>
#include <CGAL/Quad_layouts/internal/surface/Fixed_curves.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The vertices of a quad mesh that slide along fixed curves of a surface, each between its two
// neighbours on the curve: their order along it never changes, and no two of them meet.
//
// Where a curve bends between two vertices, the edge that joins them cuts the corner. How far the
// curve is from its edges is its deviation.
class Curve_vertices
{
public:
  using Place = Surface_walk::Place;
  using Position = Fixed_curves::Position;

  Curve_vertices(const Polygons& mesh, const Triangle_surface& surface)
    : m_mesh(mesh), m_surface(surface), m_curves(surface), m_tolerance(curve_tolerance(surface)),
      m_sliders(mesh.number_of_vertices())
  {
  }

  // Takes the vertices that slide, with the places of all vertices, and per vertex its neighbours
  // on fixed curves: two for those that slide.
  void add(const std::vector<int>& sliding, const std::vector<Place>& places,
           const std::vector<std::vector<int>>& neighbours)
  {
    for (const int v : sliding)
      move(v, places[v]);
    for (const int v : sliding) {
      const int u = neighbours[v][0], w = neighbours[v][1];
      Slider& slider = m_sliders[v];
      slider.before = {u, distance_beside(v, u, w, places, neighbours)};
      slider.after = {w, distance_beside(v, w, u, places, neighbours)};
      const Position first{slider.position.curve, slider.before.distance};
      if (!(way(first, slider.position.distance) < way(first, slider.after.distance)))
        std::swap(slider.before, slider.after);
    }
  }

  // the deviation that is small enough
  double tolerance() const { return m_tolerance; }

  // the deviation of the curve beside v if this were at a place
  double deviation(int v, const Place& place) const
  {
    const Slider& slider = m_sliders[v];
    const Position at = position(place), before{at.curve, distance(v, slider.before)};
    double result = 0;
    const auto compare = [&](const Position& begin, double end, const Point& p, const Point& q) {
      for_each_place_between(begin, end, [&](const Place& bend) {
        result = (std::max)(result, distance_to_segment(bend.point, p, q));
      });
    };
    compare(before, at.distance, m_mesh.points[slider.before.vertex], place.point);
    compare(at, distance(v, slider.after), place.point, m_mesh.points[slider.after.vertex]);
    return result;
  }

  // says if a place is between the neighbours of v
  bool is_between_neighbours(int v, const Place& place) const
  {
    const Position before{m_sliders[v].position.curve, distance(v, m_sliders[v].before)};
    const double there = way(before, position(place).distance);
    return 0 < there && there < way(before, distance(v, m_sliders[v].after));
  }

  // calls visit(place) for the vertices of the surface between the neighbours of v
  template <class Visit>
  void for_each_place_beside(int v, const Visit& visit) const
  {
    const Position before{m_sliders[v].position.curve, distance(v, m_sliders[v].before)};
    for_each_place_between(before, distance(v, m_sliders[v].after), visit);
  }

  // moves v to another place on its curve
  void move(int v, const Place& place) { m_sliders[v].position = position(place); }

private:
  struct Neighbour
  {
    int vertex = -1;
    double distance = 0; // along the curve, unless it slides there, too
  };

  struct Slider
  {
    Position position; // on no curve if the vertex does not slide
    Neighbour before, after;
  };

  Position position(const Place& place) const
  {
    return m_curves.position(place.fixed_halfedge, place.point);
  }

  // the distance along the curve of v of one of its neighbours
  double distance(int v, const Neighbour& neighbour) const
  {
    const Position& there = m_sliders[neighbour.vertex].position;
    return there.curve == m_sliders[v].position.curve ? there.distance : neighbour.distance;
  }

  // The same for the neighbour u on one side, w on the other. If other curves meet that of v at u,
  // or it does not go on there, this is one of its ends.
  double distance_beside(int v, int u, int w, const std::vector<Place>& places,
                         const std::vector<std::vector<int>>& neighbours) const
  {
    const Position& here = m_sliders[v].position;
    const auto lies_inside = [&](int x) {
      return neighbours[x].size() == 2 && places[x].fixed_halfedge >= 0 &&
             position(places[x]).curve == here.curve;
    };
    if (lies_inside(u))
      return position(places[u]).distance;
    if (m_curves.is_closed(here.curve))
      return here.distance; // u is not on it: let v stay
    const int first = m_curves.first_vertex(here.curve), last = m_curves.last_vertex(here.curve);
    const auto distance_to = [&](int end) {
      return (m_surface.point(end) - m_mesh.points[u]).squaredNorm();
    };
    const bool is_first = first == last
                              ? lies_inside(w) && position(places[w]).distance > here.distance
                              : distance_to(first) < distance_to(last);
    return is_first ? 0 : m_curves.length(here.curve);
  }

  // the length of the way along a curve from a position to another one; beyond its end a closed
  // curve begins anew
  double way(const Position& begin, double end) const
  {
    const double length = end - begin.distance;
    return length < 0 && m_curves.is_closed(begin.curve) ? length + m_curves.length(begin.curve)
                                                         : length;
  }

  template <class Visit>
  void for_each_place_between(const Position& begin, double end, const Visit& visit) const
  {
    m_curves.for_each_vertex_between(begin.curve, begin.distance, begin.distance + way(begin, end),
                                     [&](int v, int h, double) {
                                       visit(Place{m_surface.point(v), m_surface.face(h), h});
                                     });
  }

  const Polygons& m_mesh;
  const Triangle_surface& m_surface;
  const Fixed_curves m_curves;
  const double m_tolerance;
  std::vector<Slider> m_sliders; // per vertex of the mesh
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_CURVE_VERTICES_H
