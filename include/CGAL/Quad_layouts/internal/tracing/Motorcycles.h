// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_MOTORCYCLES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_MOTORCYCLES_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/tracing/Chords.h>
#include <CGAL/Quad_layouts/internal/tracing/Fixed_lines.h>

#include <cmath>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// says if the leg of length `a` that trace `i` contributes to a crossing counts as longer than the
// leg of length `b` of trace `j`: equal lengths, which symmetric shapes have by the dozen, are
// ordered by the traces' numbers
inline bool is_longer(double a, int i, double b, int j)
{
  return std::tie(a, i) > std::tie(b, j);
}

// The motorcycles of an extended motorcycle graph (Lyon, Campen, Kobbelt: Simpler quad layouts
// using relaxed singularities, 2021, Section 3.1): they start at given vertices in all directions
// and advance together, by length.
//
// A motorcycle i stops once it has met on its left and on its right a trace j whose candidate
// separatrix, from the start of i to the start of j, is acceptable by the rule of Section 4.3,
// (l_ji - 2r) / (l_ij + 2r) <= tan alpha with l_ij > l_ji, because singularities further out on
// that side lie behind the trace j. The later trace stops on the earlier one. All stop on the
// border. Other fixed lines are like traces that start at both their ends: motorcycles can stop on
// them, too.
class Motorcycles
{
public:
  struct Rule
  {
    bool is_extended;    // else each stops at the first one that it meets
    double tangent;      // of the maximum deviation alpha
    double displacement; // the maximum displacement r, as a length
    double patience;     // a trace longer than this or
    int maximum_steps;   // with more chords than this stops wherever it can
  };

  struct Trace
  {
    int vertex;
    int corner; // the halfedge from the vertex into whose face it starts
    std::vector<int> chords;
    int last_chord = -1;        // where it stops: in crossing `last_crossing` on this chord
    int last_crossing = -1;     // still -1 if it stops on a fixed edge
    int farthest_crossing = -1; // the last node on it so far, on chord `farthest_chord`
    int farthest_chord = -1;
    bool met_on_left = false, met_on_right = false;
  };

  // `is_hasty`: of traces that are to stop at the first one that they meet, as in a motorcycle
  // graph that is not extended; of those beyond its end, none is
  Motorcycles(Chords& chords, const Rule& rule, const std::vector<int>& vertices,
              const std::vector<char>& is_hasty)
    : m_chords(&chords), m_rule(rule), m_starts(vertices), m_is_hasty(is_hasty),
      m_fixed_lines(chords, vertices), m_queue(Comes_later{&chords})
  {
    for (int v : vertices)
      chords.surface().for_each_outgoing(v, [&](int h) { start(v, h); });
  }

  const std::vector<Trace>& traces() const { return m_traces; }
  // the vertices where motorcycles start, or could if they were not in a corner of the border
  const std::vector<int>& starts() const { return m_starts; }

  // runs until all have stopped. Returns -1, or the face in which a motorcycle is that met nobody
  // for too long
  int run(const Monitor& monitor)
  {
    for (std::size_t n = 1; !m_queue.empty(); ++n) {
      const Event event = m_queue.top();
      m_queue.pop();
      if (event.crossing >= 0)
        meet(event.crossing);
      else if (!go_on(event.trace))
        return m_chords->chord(m_traces[event.trace].chords.back()).face;
      if (n % 4096 == 0)
        monitor.check("trace_motorcycle_graph");
    }
    return -1;
  }

  // the side, 0 or 1, of the trace that comes later to crossing x: the longer one
  int later_side(int x) const
  {
    const Chords::Crossing& crossing = m_chords->crossing(x);
    const auto& a = m_chords->chord(crossing.chord[0]);
    const auto& b = m_chords->chord(crossing.chord[1]);
    if (a.trace == b.trace)
      return a.step > b.step ? 0 : 1;
    return is_longer(crossing.length[0], a.trace, crossing.length[1], b.trace) ? 0 : 1;
  }

private:
  // is the arrival of the later of two traces at a crossing, or of a trace at the end of a chord
  // (crossing = -1)
  struct Event
  {
    double length;
    int trace;
    int chord;
    int crossing;
  };

  // The order of events is total. At equal lengths it is that of the traces, and along each of
  // them.
  struct Comes_later
  {
    const Chords* chords;

    bool operator()(const Event& a, const Event& b) const // the queue has the last on top
    {
      if (std::tie(a.length, a.trace) != std::tie(b.length, b.trace))
        return std::tie(a.length, a.trace) > std::tie(b.length, b.trace);
      if (a.chord != b.chord)
        return chords->chord(a.chord).step > chords->chord(b.chord).step;
      if (a.crossing < 0 || b.crossing < 0)
        return a.crossing < 0 && b.crossing >= 0;
      return chords->is_before(a.chord, b.crossing, a.crossing);
    }
  };

  void start(int vertex, int corner)
  {
    for (int i = 0; i < m_chords->labels().number_of_starts(corner); ++i) {
      const int trace = int(m_traces.size()), known = m_chords->number_of_crossings();
      m_traces.push_back({vertex, corner, {}});
      append(trace, m_chords->start(trace, corner, i), known);
    }
  }

  // takes the trace through the next triangle, unless it has stopped; returns false if it should
  // have by far
  bool go_on(int trace)
  {
    const Trace& t = m_traces[trace];
    if (t.last_crossing >= 0 || stops_on_fixed_edge(trace))
      return true;
    if (t.chords.size() > std::size_t(m_rule.maximum_steps) * 10)
      return false;
    const int known = m_chords->number_of_crossings();
    append(trace, m_chords->go_on(t.chords.back()), known);
    return true;
  }

  bool stops_on_fixed_edge(int trace)
  {
    Trace& t = m_traces[trace];
    const int c = t.chords.back();
    if (!m_chords->ends_on_fixed_edge(c))
      return false;
    if (!m_chords->ends_on_border(c))
      note_ends_of_fixed_line(t, c);
    return m_chords->ends_on_border(c) || may_stop(trace);
  }

  // notes on which sides the end of the fixed line to which chord c leads is an acceptable
  // candidate
  void note_ends_of_fixed_line(Trace& t, int c)
  {
    const int h = m_chords->chord(c).to.halfedge, // it leads to the left
        opposite = m_chords->surface().opposite(h);
    const double r = m_rule.displacement, own = m_chords->chord(c).end,
                 passed = m_chords->length_before(m_chords->chord(c).to),
                 left = m_fixed_lines.length_ahead(h) - passed,
                 right = m_fixed_lines.length_ahead(opposite) - m_chords->length(h) + passed;
    t.met_on_left |= left - 2 * r <= m_rule.tangent * (own + 2 * r);
    t.met_on_right |= right - 2 * r <= m_rule.tangent * (own + 2 * r);
  }

  // appends a chord to a trace, and the events on it; crossings from number `known` on are the
  // chord's
  void append(int trace, int chord, int known)
  {
    m_traces[trace].chords.push_back(chord);
    for (int x = known; x < m_chords->number_of_crossings(); ++x) {
      const Chords::Crossing& crossing = m_chords->crossing(x);
      const int s = later_side(x), c = crossing.chord[s];
      m_queue.push({crossing.length[s], m_chords->chord(c).trace, c, x});
    }
    m_queue.push({m_chords->chord(chord).end, trace, chord, -1});
  }

  void meet(int x)
  {
    const Chords::Crossing& crossing = m_chords->crossing(x);
    if (!is_reached(x, crossing.chord[0]) || !is_reached(x, crossing.chord[1]))
      return;
    m_chords->confirm(x);
    const int s = later_side(x);
    advance(x, crossing.chord[1 - s]);
    advance(x, crossing.chord[s]);
    note(x, s);
    try_to_stop(x, crossing.chord[s]);
  }

  // says if the trace of chord c, which may have stopped, comes to crossing x on c
  bool is_reached(int x, int c) const
  {
    const Trace& t = trace_of(c);
    return t.last_crossing < 0 || is_before(c, x, t.last_chord, t.last_crossing);
  }

  // says if a trace meets crossing x on its chord c before crossing y on its chord d
  bool is_before(int c, int x, int d, int y) const
  {
    return c == d ? m_chords->is_before(c, x, y)
                  : m_chords->chord(c).step < m_chords->chord(d).step;
  }

  void advance(int x, int c)
  {
    Trace& t = trace_of(c);
    if (t.farthest_crossing >= 0 && is_before(c, x, t.farthest_chord, t.farthest_crossing))
      return;
    t.farthest_crossing = x;
    t.farthest_chord = c;
  }

  // notes on which side the trace on side s of crossing x meets an acceptable candidate
  void note(int x, int s)
  {
    const Chords::Crossing& crossing = m_chords->crossing(x);
    const double own = crossing.length[s], other = crossing.length[1 - s], r = m_rule.displacement;
    if (other - 2 * r > m_rule.tangent * (own + 2 * r))
      return;
    Trace& t = trace_of(crossing.chord[s]);
    (m_chords->quarter_turns(x, crossing.chord[s]) == 1 ? t.met_on_right : t.met_on_left) = true;
  }

  // Rounding may let events come in another order than the crossings along the trace: no trace
  // stops short of a node that it has.
  void try_to_stop(int x, int c)
  {
    Trace& t = trace_of(c);
    if (t.farthest_crossing != x || t.farthest_chord != c)
      return;
    if (may_stop(m_chords->chord(c).trace)) {
      t.last_crossing = x;
      t.last_chord = c;
    }
  }

  bool may_stop(int trace) const
  {
    const Trace& t = m_traces[trace];
    return (t.met_on_left && t.met_on_right) || !m_rule.is_extended || is_hasty(trace) ||
           is_out_of_patience(t);
  }

  bool is_hasty(int trace) const { return trace < int(m_is_hasty.size()) && m_is_hasty[trace]; }

  bool is_out_of_patience(const Trace& t) const
  {
    return t.chords.size() > std::size_t(m_rule.maximum_steps) ||
           m_chords->chord(t.chords.back()).end > m_rule.patience;
  }

  Trace& trace_of(int c) { return m_traces[m_chords->chord(c).trace]; }
  const Trace& trace_of(int c) const { return m_traces[m_chords->chord(c).trace]; }

  Chords* m_chords;
  Rule m_rule;
  std::vector<int> m_starts;
  const std::vector<char>& m_is_hasty;
  Fixed_lines m_fixed_lines;
  std::vector<Trace> m_traces;
  std::priority_queue<Event, std::vector<Event>, Comes_later> m_queue;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_MOTORCYCLES_H
