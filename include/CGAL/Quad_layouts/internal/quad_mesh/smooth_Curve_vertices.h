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
#include <cmath>
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

  // Says if v may slide to a place: between its neighbours, and such that the deviation beside v is
  // small enough, or at least no greater than it is now.
  bool permits(int v, const Place& now, const Place& next) const
  {
    if (!is_between_neighbours(v, next))
      return false;
    const double after = deviation(v, next);
    return after <= m_tolerance || after <= deviation(v, now);
  }

  // the deviation of the curve beside v if this were at a place
  double deviation(int v, const Place& place) const
  {
    const Slider& slider = m_sliders[v];
    const Position at = position(place), before{at.curve, distance(v, slider.before)};
    double result = 0;
    const auto compare = [&](const Position& begin, double end, const Point& p, const Point& q) {
      for_each_vertex_between(begin, end, [&](int bend, double) {
        result = (std::max)(result, distance_to_segment(m_surface.point(bend), p, q));
      });
    };
    compare(before, at.distance, m_mesh.points[slider.before.vertex], place.point);
    compare(at, distance(v, slider.after), place.point, m_mesh.points[slider.after.vertex]);
    return result;
  }

  // Vertices one after the other along a curve, all of which slide but for the first and the last;
  // on a closed curve where all slide, these are the same one.
  struct Chain
  {
    int curve;
    std::vector<int> vertices;
    std::vector<double> distances; // beyond the end a closed curve begins anew
  };

  std::vector<Chain> chains() const
  {
    std::vector<Chain> result;
    std::vector<char> is_known(m_sliders.size(), 0);
    for (int v = 0; v < int(m_sliders.size()); ++v)
      if (m_sliders[v].position.curve >= 0 && !is_known[v]) {
        Chain chain = chain_of(v);
        for (const int u : chain.vertices)
          is_known[u] = 1;
        if (is_in_order(chain))
          result.push_back(std::move(chain));
      }
    return result;
  }

  // the place at a distance along a curve
  Place place(int curve, double distance) const
  {
    const Fixed_curves::Location found = m_curves.location(curve, distance);
    return {found.point, m_surface.face(found.halfedge), found.halfedge};
  }

  // the vertices of the surface between the ends of a chain, calls visit(vertex, distance)
  template <class Visit>
  void for_each_bend(const Chain& chain, const Visit& visit) const
  {
    for_each_vertex_between({chain.curve, chain.distances.front()}, chain.distances.back(), visit);
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

  // says if a place is between the neighbours of v
  bool is_between_neighbours(int v, const Place& place) const
  {
    const Position before{m_sliders[v].position.curve, distance(v, m_sliders[v].before)};
    const double there = way(before, position(place).distance);
    return 0 < there && there < way(before, distance(v, m_sliders[v].after));
  }

  // says if a neighbour of v slides, too, on the same curve
  bool slides_with(int v, const Neighbour& neighbour) const
  {
    return m_sliders[neighbour.vertex].position.curve == m_sliders[v].position.curve;
  }

  // the neighbour of v that is not u
  const Neighbour& beyond(int v, int u) const
  {
    const Slider& slider = m_sliders[v];
    return slider.before.vertex == u ? slider.after : slider.before;
  }

  // the chain of a vertex that slides; on a closed curve where all do, it begins there
  Chain chain_of(int v) const
  {
    int first = v, second = m_sliders[v].after.vertex;
    while (slides_with(first, beyond(first, second))) {
      const int before = beyond(first, second).vertex;
      if (before == v)
        return closed_chain(v);
      second = first;
      first = before;
    }
    return open_chain(first, beyond(first, second));
  }

  Chain closed_chain(int v) const
  {
    Chain result{m_sliders[v].position.curve, {v}, {m_sliders[v].position.distance}};
    for (int before = v, u = m_sliders[v].after.vertex; u != v;) {
      append(result, u, m_sliders[u].position.distance);
      const int next = beyond(u, before).vertex;
      before = u;
      u = next;
    }
    append(result, v, m_sliders[v].position.distance);
    return result;
  }

  // begins with a neighbour of `first` that does not slide
  Chain open_chain(int first, const Neighbour& end) const
  {
    Chain result{m_sliders[first].position.curve, {end.vertex}, {end.distance}};
    for (int before = end.vertex, u = first;;) {
      append(result, u, m_sliders[u].position.distance);
      const Neighbour& next = beyond(u, before);
      if (!slides_with(u, next)) {
        append(result, next.vertex, next.distance);
        return result;
      }
      before = u;
      u = next.vertex;
    }
  }

  void append(Chain& chain, int v, double distance) const
  {
    const Position last{chain.curve, chain.distances.back()};
    chain.vertices.push_back(v);
    chain.distances.push_back(last.distance + way(last, distance));
  }

  // says if the vertices of a chain come one after the other on its curve, and not more than once
  // around a closed one; very short edges may not
  bool is_in_order(const Chain& chain) const
  {
    if (!std::is_sorted(chain.distances.begin(), chain.distances.end()))
      return false;
    if (!m_curves.is_closed(chain.curve))
      return true;
    const double first = chain.distances.front(), last = chain.distances.back(),
                 length = m_curves.length(chain.curve);
    const double direct = way({chain.curve, first}, std::fmod(last, length));
    const bool is_loop = chain.vertices.front() == chain.vertices.back();
    return std::lround((last - first - direct) / length) <= (is_loop ? 1 : 0);
  }

  // the distance along the curve of v of one of its neighbours
  double distance(int v, const Neighbour& neighbour) const
  {
    return slides_with(v, neighbour) ? m_sliders[neighbour.vertex].position.distance
                                     : neighbour.distance;
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

  // calls visit(vertex, distance) for the vertices of the surface on a part of a curve
  template <class Visit>
  void for_each_vertex_between(const Position& begin, double end, const Visit& visit) const
  {
    m_curves.for_each_vertex_between(begin.curve, begin.distance, begin.distance + way(begin, end),
                                     visit);
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
