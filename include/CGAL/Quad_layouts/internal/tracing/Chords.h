// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_CHORDS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_CHORDS_H

#include <CGAL/Quad_layouts/internal/tracing/Edge_order.h>
#include <CGAL/Quad_layouts/internal/tracing/Labels.h>

#include <algorithm>
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
// chord, follows from the order of their ends around the triangle. Where chords leave triangles,
// and how long they are, is up to derived classes, which know the map or the field that traces
// follow. Their exits must be such that
// - a chord crosses none of its own family, and
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
    int step; // the position in the sequence of chords of its trace
    int face;
    int direction; // in the cross of the face
    End from, to;
    double begin, end;          // the length of the trace at both ends
    std::vector<int> crossings; // in the order of travel
  };

  struct Crossing
  {
    int chord[2];
    double length[2]; // of the trace of either chord from its start
    bool confirmed;   // both traces do get here: the crossing is a node
  };

  virtual ~Chords() = default;

  int number_of_chords() const { return int(m_chords.size()); }
  int number_of_crossings() const { return int(m_crossings.size()); }
  const Chord& chord(int c) const { return m_chords[c]; }
  const Crossing& crossing(int x) const { return m_crossings[x]; }
  const Edge_order& order() const { return m_order; }
  const Labels& labels() const { return *m_labels; }
  const Triangle_surface& surface() const { return *m_surface; }
  void confirm(int x) { m_crossings[x].confirmed = true; }

  // adds the first chord of a trace, in the i-th direction that starts in a corner
  int start(int trace, int corner, int i)
  {
    return add({trace, 0, corner / 3, m_labels->start(corner, i), {corner, -1}, {}, 0, 0, {}}, -1);
  }

  // adds the chord in which the trace of chord c goes on in the next triangle
  int go_on(int c)
  {
    const Chord& last = m_chords[c];
    const int h = m_surface->opposite(last.to.halfedge);
    const int direction = (last.direction + m_labels->turn(last.to.halfedge)) & 3;
    const End from{h, last.to.point};
    return add({last.trace, last.step + 1, h / 3, direction, from, {}, last.end, last.end, {}}, c);
  }

  bool ends_on_border(int c) const { return m_surface->is_border(m_chords[c].to.halfedge); }
  bool ends_on_fixed_edge(int c) const { return m_surface->is_fixed(m_chords[c].to.halfedge); }

  // the length of halfedge h, and that of its part before a point on it
  virtual double length(int h) const = 0;
  virtual double length_before(const End& e) const = 0;

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
    const Place from = place_of_start(m_chords[c]);
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

protected:
  // is a place on the boundary of a triangle; the sequence corner 0, side 0, corner 1, ... is
  // counter-clockwise
  struct Place
  {
    int slot;              // 2k: corner k, 2k + 1: side k
    Edge_order::Rank rank; // the position within the slot

    bool is_side() const { return (slot & 1) != 0; }
    friend bool operator<(const Place& a, const Place& b)
    {
      return std::tie(a.slot, a.rank) < std::tie(b.slot, b.rank);
    }
  };

  explicit Chords(const Labels& labels)
    : m_order(labels.surface().number_of_edges()), m_surface(&labels.surface()), m_labels(&labels),
      m_in_face(labels.surface().number_of_faces())
  {
  }

  // sets the end of a new chord, and the length there; `previous` is the chord that it continues,
  // or -1
  virtual void leave_face(Chord& chord, int previous) = 0;
  // the lengths of the traces of two crossing chords where they meet, as proposals
  virtual std::pair<double, double> lengths_at_crossing(int c, int d) const = 0;

  // going counter-clockwise from `from`, does a come before b?
  static bool counter_clockwise(const Place& from, const Place& a, const Place& b)
  {
    const bool a_wraps = a < from, b_wraps = b < from;
    return a_wraps != b_wraps ? b_wraps : a < b;
  }

  bool is_canonical(int h) const { return m_surface->halfedge_of_edge(m_surface->edge(h)) == h; }
  // the fraction of its halfedge before an end that is a point
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

  const std::vector<int>& chords_in(int face) const { return m_in_face[face]; }

  Edge_order m_order;

private:
  // adds a chord whose exit is still open
  int add(Chord chord, int previous)
  {
    leave_face(chord, previous);
    const int c = number_of_chords();
    m_chords.push_back(std::move(chord));
    find_crossings(c);
    m_in_face[m_chords[c].face].push_back(c);
    return c;
  }

  // the end of the other chord that lies to the right of chord c, for a crossing x on chord c
  Place place_of_right_end(int x, int c) const
  {
    const Chord& other = m_chords[m_crossings[x].chord[1 - side(x, c)]];
    return quarter_turns(x, c) == 1 ? place_of_start(other) : place(other.to);
  }

  // adds the crossings of the new chord c with the others in its face
  void find_crossings(int c)
  {
    const Place from = place_of_start(m_chords[c]), to = place(m_chords[c].to);
    for (int d : m_in_face[m_chords[c].face]) {
      if (((m_chords[c].direction - m_chords[d].direction) & 1) == 0)
        continue;
      const bool a = counter_clockwise(from, place_of_start(m_chords[d]), to);
      const bool b = counter_clockwise(from, place(m_chords[d].to), to);
      if (a != b)
        add_crossing(c, d);
    }
  }

  void add_crossing(int c, int d)
  {
    const int x = number_of_crossings();
    const auto [of_c, of_d] = lengths_at_crossing(c, d);
    m_crossings.push_back({{c, d}, {0, 0}, false});
    m_crossings[x].length[0] = insert_crossing(x, c, of_c);
    m_crossings[x].length[1] = insert_crossing(x, d, of_d);
  }

  // puts crossing x into the list of chord c; returns its length there, which is limited by the
  // neighbours in the list
  double insert_crossing(int x, int c, double proposal)
  {
    Chord& chord = m_chords[c];
    auto& list = chord.crossings;
    const auto place = std::upper_bound(list.begin(), list.end(), x,
                                        [&](int y, int z) { return is_before(c, y, z); });
    const auto length = [&](int y) { return m_crossings[y].length[side(y, c)]; };
    const double low = place == list.begin() ? chord.begin : length(*(place - 1));
    const double high = place == list.end() ? chord.end : length(*place);
    list.insert(place, x);
    return std::clamp(proposal, low, high);
  }

  const Triangle_surface* m_surface;
  const Labels* m_labels;
  std::vector<Chord> m_chords;
  std::vector<Crossing> m_crossings;
  std::vector<std::vector<int>> m_in_face;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_CHORDS_H
