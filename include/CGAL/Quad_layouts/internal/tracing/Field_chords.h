// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_FIELD_CHORDS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_FIELD_CHORDS_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/internal/tracing/Chords.h>
#include <CGAL/Quad_layouts/internal/tracing/Interval_map.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The pieces of traces along the directions of a cross field. The exit of a new chord is proposed by the
// interval map, and then limited by the chords that it must not cross. Lengths are those on the surface.
class Field_chords : public Chords
{
public:
  Field_chords(const Cross_field& field, const Labels& labels)
    : Chords(labels), m_map(field, labels)
  {
  }

  double length(int h) const override { return surface().length(h); }
  double length_before(const End& e) const override { return parameter(e) * length(e.halfedge); }

private:
  // is a limit for the exit of a new chord, at an end of another chord
  struct Limit
  {
    bool exists = false;
    Place place{};
    int point = -1;
  };

  void leave_face(Chord& chord, int) override
  {
    choose_exit(chord, proposed_exit(chord));
    chord.end += (point(chord.to) - point(chord.from)).norm();
  }

  Interval_map::Position proposed_exit(const Chord& c) const
  {
    return c.from.point < 0 ? m_map.leave_from_corner(c.from.halfedge, c.direction)
                            : m_map.leave({c.from.halfedge, parameter(c.from)}, c.direction);
  }

  // is `place` on a side through which the chord can leave, or in the corner between two such
  // sides?
  bool is_on_exit(const Chord& c, const Place& place) const
  {
    const int h = 3 * c.face + place.slot / 2;
    return labels().leaves(h, c.direction) &&
           (place.is_side() || labels().leaves(Labels::Surface::prev(h), c.direction));
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
    Limit first, last; // the exit lies between them, counter-clockwise from the chord's begin
    for (int i : chords_in(c.face)) {
      const Chord& d = chord(i);
      Limit a{true, place_of_start(d), d.from.point}, b{true, place(d.to), d.to.point};
      const bool right = !counter_clockwise(from, a.place, b.place); // c begins on the right of d
      if (may_cross(c, right, d))
        continue;
      if (right)
        std::swap(a, b);
      if (is_on_exit(c, a.place) && (!last.exists || counter_clockwise(from, a.place, last.place)))
        last = a;
      if (is_on_exit(c, b.place) &&
          (!first.exists || counter_clockwise(from, first.place, b.place)))
        first = b;
    }
    CGAL_assertion(!first.exists || !last.exists ||
                   counter_clockwise(from, first.place, last.place));
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
    return is_canonical(h) ? m_order.insert(surface().edge(h), exit.t, after, before)
                           : m_order.insert(surface().edge(h), 1 - exit.t, before, after);
  }

  std::pair<double, double> lengths_at_crossing(int c, int d) const override
  {
    const auto [s, t] = intersection(chord(c), chord(d));
    const auto at = [](const Chord& c, double fraction) {
      return c.begin + fraction * (c.end - c.begin);
    };
    return {at(chord(c), s), at(chord(d), t)};
  }

  // the fractions of two chords at which they meet, one half if rounding leaves no answer
  std::pair<double, double> intersection(const Chord& c, const Chord& d) const
  {
    const Point p = point(c.from), q = point(d.from), u = point(c.to) - p, v = point(d.to) - q;
    const Point n = surface().area_vector(c.face);
    const double determinant = u.cross(v).dot(n);
    const auto fraction = [&](double numerator) {
      const double s = numerator / determinant;
      return std::isfinite(s) ? std::clamp(s, 0., 1.) : 0.5;
    };
    return {fraction((q - p).cross(v).dot(n)), fraction((q - p).cross(u).dot(n))};
  }

  Interval_map m_map;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_FIELD_CHORDS_H
