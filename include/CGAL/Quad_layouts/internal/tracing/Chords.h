// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_CHORDS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_CHORDS_H

#include <CGAL/Quad_layouts/internal/tracing/Edge_order.h>
#include <CGAL/Quad_layouts/internal/tracing/Interval_map.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// All pieces of traces in all triangles, and their crossings.
//
// A *chord* is the piece of a trace in a triangle, between two places of the boundary: points on
// sides, or the corner where the trace starts. Which chords cross, and in which order along a
// chord, follows from the order of their ends around the triangle. The exit of a new chord is
// proposed by the interval map and then limited such that
// - it crosses no chord of its own family, and
// - direction d + 1 crosses direction d from right to left only.
// The second rule keeps two traces from crossing twice in a row: no patch is a digon.
class Chords
{
public:
  // is an end of a chord: a point on `halfedge`, a side of the chord's face, or (point = -1) the
  // source of `halfedge`
  struct End
  {
    int halfedge;
    int point;
  };

  struct Chord
  {
    int trace;
    int step;                    // the position in the sequence of chords of its trace
    int face;
    int direction;               // in the cross of the face
    End from, to;
    double begin, end;           // the length of the trace at both ends
    std::vector<int> crossings;  // in the order of travel
  };

  struct Crossing
  {
    int chord[2];
    double length[2];            // of the trace of either chord from its start
    bool confirmed;              // both traces do get here: the crossing is a node
  };

  Chords(const Cross_field& field, const Labels& labels)
    : m_surface(&field.surface()), m_labels(&labels), m_map(field, labels),
      m_order(field.surface().number_of_edges()), m_in_face(field.surface().number_of_faces())
  {
  }

  int number_of_chords() const { return int(m_chords.size()); }
  int number_of_crossings() const { return int(m_crossings.size()); }
  const Chord& chord(int c) const { return m_chords[c]; }
  const Crossing& crossing(int x) const { return m_crossings[x]; }
  const Edge_order& order() const { return m_order; }
  const Labels& labels() const { return *m_labels; }
  void confirm(int x) { m_crossings[x].confirmed = true; }

  // adds the first chord of a trace, in the i-th direction that starts in a corner
  int start(int trace, int corner, int i)
  {
    const int direction = m_labels->start(corner, i);
    return add({trace, 0, corner / 3, direction, {corner, -1}, {}, 0, 0, {}},
               m_map.leave_from_corner(corner, direction));
  }

  // adds the chord in which the trace of chord c goes on in the next triangle
  int go_on(int c)
  {
    const Chord& last = m_chords[c];
    const int h = m_surface->opposite(last.to.halfedge);
    const int direction = (last.direction + m_labels->turn(last.to.halfedge)) & 3;
    const End from{h, last.to.point};
    return add({last.trace, last.step + 1, h / 3, direction, from, {}, last.end, last.end, {}},
               m_map.leave({h, parameter(from)}, direction));
  }

  bool ends_on_border(int c) const { return m_surface->is_border(m_chords[c].to.halfedge); }
  bool ends_on_fixed_edge(int c) const { return m_surface->is_fixed(m_chords[c].to.halfedge); }
  // the fraction of the halfedge on which chord c ends before its end
  double parameter_of_end(int c) const { return parameter(m_chords[c].to); }

  // the side of crossing x (0 or 1) that belongs to chord c
  int side(int x, int c) const { return m_crossings[x].chord[0] == c ? 0 : 1; }

  // the quarter-turns, 1 (from right to left) or 3 (from left to right), from the direction of
  // chord c to that of the chord that it meets in crossing x
  int quarter_turns(int x, int c) const
  {
    const int other = m_crossings[x].chord[1 - side(x, c)];
    return (m_chords[other].direction - m_chords[c].direction) & 3;
  }

  // says if chord c meets crossing x before crossing y
  bool is_before(int c, int x, int y) const
  {
    const Place from = place_of_start(c);
    return counter_clockwise(from, place_of_right_end(x, c), place_of_right_end(y, c));
  }

  Point point_of_start(int c) const { return point(m_chords[c].from); }
  Point point_of_end(int c) const { return point(m_chords[c].to); }
  Point point(const Crossing& x) const
  {
    const Chord& c = m_chords[x.chord[0]];
    const double extent = c.end - c.begin;
    const double s = extent > 0 ? (x.length[0] - c.begin) / extent : 0.5;
    return (1 - s) * point(c.from) + s * point(c.to);
  }

private:
  // is a place on the boundary of a triangle; the sequence corner 0, side 0, corner 1, ... is
  // counter-clockwise
  struct Place
  {
    int slot;                    // 2k: corner k, 2k + 1: side k
    Edge_order::Rank rank;       // the position within the slot

    bool is_side() const { return (slot & 1) != 0; }
    friend bool operator<(const Place& a, const Place& b)
    {
      return std::tie(a.slot, a.rank) < std::tie(b.slot, b.rank);
    }
  };

  // is a limit for the exit of a new chord, at an end of another chord
  struct Limit
  {
    bool exists = false;
    Place place{};
    int point = -1;
  };

  // going counter-clockwise from `from`, does a come before b?
  static bool counter_clockwise(const Place& from, const Place& a, const Place& b)
  {
    const bool a_wraps = a < from, b_wraps = b < from;
    return a_wraps != b_wraps ? b_wraps : a < b;
  }

  bool is_canonical(int h) const { return m_surface->halfedge_of_edge(m_surface->edge(h)) == h; }
  double parameter(const End& e) const
  {
    return is_canonical(e.halfedge) ? m_order.t(e.point) : 1 - m_order.t(e.point);
  }
  Point point(const End& e) const
  {
    const Point& p = m_surface->point(m_surface->source(e.halfedge));
    return e.point < 0 ? p : Point(p + parameter(e) * m_surface->vector(e.halfedge));
  }

  Place place(const End& e) const
  {
    const Edge_order::Rank rank = m_order.rank(e.point);
    return {2 * (e.halfedge % 3) + 1, is_canonical(e.halfedge) ? rank : ~rank};
  }
  // Two chords that start in one corner do not cross if the left one comes first.
  Place place_of_start(const Chord& c) const
  {
    if (c.from.point >= 0)
      return place(c.from);
    const int corner = c.from.halfedge;
    return {2 * (corner % 3), c.direction == m_labels->start(corner, 0) ? 1u : 0u};
  }
  Place place_of_start(int c) const { return place_of_start(m_chords[c]); }
  // the end of the other chord that lies to the right of chord c, for a crossing x on chord c
  Place place_of_right_end(int x, int c) const
  {
    const int other = m_crossings[x].chord[1 - side(x, c)];
    return quarter_turns(x, c) == 1 ? place_of_start(other) : place(m_chords[other].to);
  }

  // adds a chord whose exit is still open
  int add(Chord chord, Interval_map::Position proposal)
  {
    choose_exit(chord, proposal);
    chord.end += (point(chord.to) - point(chord.from)).norm();
    const int c = number_of_chords();
    m_chords.push_back(std::move(chord));
    find_crossings(c);
    m_in_face[m_chords[c].face].push_back(c);
    return c;
  }

  // is `place` on a side through which the chord can leave, or in the corner between two such
  // sides?
  bool is_on_exit(const Chord& c, const Place& place) const
  {
    const int h = 3 * c.face + place.slot / 2;
    return m_labels->leaves(h, c.direction)
        && (place.is_side() || m_labels->leaves(Labels::Surface::prev(h), c.direction));
  }

  // says if chord c may cross chord d, given where c begins
  bool may_cross(const Chord& c, bool c_begins_right_of_d, const Chord& d) const
  {
    const int turns = (c.direction - d.direction) & 3;
    return turns == (c_begins_right_of_d ? 1 : 3);
  }

  void choose_exit(Chord& c, Interval_map::Position proposal)
  {
    const Place from = place_of_start(c);
    Limit first, last;    // the exit lies between them, counter-clockwise from the chord's begin
    for (int i : m_in_face[c.face]) {
      const Chord& d = m_chords[i];
      Limit a{true, place_of_start(d), d.from.point}, b{true, place(d.to), d.to.point};
      const bool right = !counter_clockwise(from, a.place, b.place);   // c begins on the right of d
      if (may_cross(c, right, d))
        continue;
      if (right)
        std::swap(a, b);
      if (is_on_exit(c, a.place)
          && (!last.exists || counter_clockwise(from, a.place, last.place)))
        last = a;
      if (is_on_exit(c, b.place)
          && (!first.exists || counter_clockwise(from, first.place, b.place)))
        first = b;
    }
    CGAL_assertion(!first.exists || !last.exists
                   || counter_clockwise(from, first.place, last.place));
    apply_limits(from, first, last, proposal);
    c.to = {proposal.halfedge, insert(proposal, first, last)};
  }

  // moves a proposed exit to the side of the triangle on which the limits allow one
  static void apply_limits(const Place& from, const Limit& first, const Limit& last,
                           Interval_map::Position& exit)
  {
    const int face = Labels::Surface::face(exit.halfedge);
    const auto turned = [&](int slot) { return (slot - from.slot + 6) % 6; };
    const auto slot = [&] { return turned(2 * (exit.halfedge % 3) + 1); };
    // a limit in a corner is followed by the side that begins there, and follows the side that ends
    // there
    if (first.exists && turned(first.place.slot) > slot())
      exit = {3 * face + first.place.slot / 2, 0};
    if (last.exists && turned(last.place.slot) < slot())
      exit = {3 * face + (last.place.slot + 5) % 6 / 2, 1};
  }

  int insert(const Interval_map::Position& exit, const Limit& first, const Limit& last)
  {
    const int h = exit.halfedge, slot = 2 * (h % 3) + 1;
    const int after = first.exists && first.place.slot == slot ? first.point : -1;
    const int before = last.exists && last.place.slot == slot ? last.point : -1;
    return is_canonical(h) ? m_order.insert(m_surface->edge(h), exit.t, after, before)
                           : m_order.insert(m_surface->edge(h), 1 - exit.t, before, after);
  }

  // adds the crossings of the new chord c with the others in its face
  void find_crossings(int c)
  {
    const Place from = place_of_start(c), to = place(m_chords[c].to);
    for (int d : m_in_face[m_chords[c].face]) {
      if (((m_chords[c].direction - m_chords[d].direction) & 1) == 0)
        continue;
      const bool a = counter_clockwise(from, place_of_start(d), to);
      const bool b = counter_clockwise(from, place(m_chords[d].to), to);
      if (a != b)
        add_crossing(c, d);
    }
  }

  void add_crossing(int c, int d)
  {
    const int x = number_of_crossings();
    const auto [s, t] = intersection(m_chords[c], m_chords[d]);
    m_crossings.push_back({{c, d}, {0, 0}, false});
    m_crossings[x].length[0] = insert_crossing(x, c, s);
    m_crossings[x].length[1] = insert_crossing(x, d, t);
  }

  // puts crossing x into the list of chord c; returns its length there, proposed by a fraction of
  // the chord and limited by the neighbours in the list
  double insert_crossing(int x, int c, double fraction)
  {
    Chord& chord = m_chords[c];
    auto& list = chord.crossings;
    const auto place = std::upper_bound(list.begin(), list.end(), x,
                                        [&](int y, int z) { return is_before(c, y, z); });
    const auto length = [&](int y) { return m_crossings[y].length[side(y, c)]; };
    const double low = place == list.begin() ? chord.begin : length(*(place - 1));
    const double high = place == list.end() ? chord.end : length(*place);
    list.insert(place, x);
    return std::clamp(chord.begin + fraction * (chord.end - chord.begin), low, high);
  }

  // the fractions of two chords at which they meet, one half if rounding leaves no answer
  std::pair<double, double> intersection(const Chord& c, const Chord& d) const
  {
    const Point p = point(c.from), q = point(d.from), u = point(c.to) - p, v = point(d.to) - q;
    const Point n = m_surface->area_vector(c.face);
    const double determinant = u.cross(v).dot(n);
    const auto fraction = [&](double numerator) {
      const double s = numerator / determinant;
      return std::isfinite(s) ? std::clamp(s, 0., 1.) : 0.5;
    };
    return {fraction((q - p).cross(v).dot(n)), fraction((q - p).cross(u).dot(n))};
  }

  const Triangle_surface* m_surface;
  const Labels* m_labels;
  Interval_map m_map;
  Edge_order m_order;
  std::vector<Chord> m_chords;
  std::vector<Crossing> m_crossings;
  std::vector<std::vector<int>> m_in_face;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_CHORDS_H
