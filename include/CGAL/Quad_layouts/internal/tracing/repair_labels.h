// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_REPAIR_LABELS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_REPAIR_LABELS_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/tracing/Labels.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Makes all faces valid and all valences at least 2, by a min-conflicts search that starts from
// labels that are valid nearly everywhere: again and again, the cheapest change of a label near a
// bad face or vertex. Then the same search is tried from each vertex that this has made slim.
//
// A label that changes on both sides of its edge keeps the matching. As long as faces are valid, it
// then keeps the valences, too. A label that changes on one side moves a quarter of index from one
// end of the edge to the other; this is how vertices of valence 1, which quad meshes do not have,
// and of valence 0 and less, around which lines can only spiral, share their index with neighbours.
class Label_repair
{
public:
  using Surface = Triangle_surface;

  Label_repair(Labels& labels, const Cross_field& field)
    : m_labels(labels), m_original(labels), m_field(field), m_surface(labels.surface())
  {
  }

  void operator()()
  {
    make_valid();
    m_bears_slim_vertices = false;
    for (int v = 0; v < m_surface.number_of_vertices(); ++v)
      if (m_surface.halfedge(v) >= 0 && is_bad_vertex(v))
        widen(v);
  }

private:
  struct Change
  {
    int halfedge;
    int shift;       // is added to the label of the halfedge
    bool both_sides; // and to that of the opposite halfedge
  };

  void make_valid()
  {
    for (int f = 0; f < m_surface.number_of_faces(); ++f)
      suspect(3 * f);
    if (!search(1000 * m_suspects.size() + 1000))
      fail(m_suspects.front());
  }

  // tries to share the index of v with its neighbours
  void widen(int v)
  {
    constexpr std::size_t number_of_steps = 100;
    m_changes.clear();
    m_suspects.assign(1, m_surface.halfedge(v));
    if (!search(number_of_steps))
      undo();
  }

  // changes labels until no suspect is bad; returns false if that takes more than `limit` steps
  bool search(std::size_t limit)
  {
    m_patience = 20 * m_suspects.size() + 20;
    for (std::size_t step = 0; !m_suspects.empty(); ++step) {
      const std::size_t i = m_random() % m_suspects.size();
      const int h = std::exchange(m_suspects[i], m_suspects.back());
      m_suspects.pop_back();
      if (!is_bad(h))
        continue;
      if (step >= limit) {
        m_suspects.assign(1, h);
        return false;
      }
      apply(best_change(h, step));
      suspect(h);
    }
    return true;
  }

  void undo()
  {
    for (auto c = m_changes.rbegin(); c != m_changes.rend(); ++c)
      shift_labels(*c, 4 - c->shift);
    m_suspects.clear();
  }

  bool is_bad_vertex(int v) const
  {
    return m_labels.valence(v) < Labels::least_valence || is_too_slim(v);
  }
  // whether v is slim, and not so by the field, once that matters
  bool is_too_slim(int v) const
  {
    return !m_bears_slim_vertices && m_labels.is_slim(v) && m_field.index(v) < 2;
  }
  // a suspect is a corner: its face or its vertex may be bad
  bool is_bad(int h) const
  {
    return !m_labels.is_valid(Surface::face(h)) || is_bad_vertex(m_surface.source(h));
  }

  void suspect(int h)
  {
    for (int i = 0; i < 3; ++i, h = Surface::next(h))
      if (is_bad(h))
        m_suspects.push_back(h);
  }

  Change best_change(int h, std::size_t step)
  {
    m_best_cost = (std::numeric_limits<double>::max)();
    m_at_random = step > m_patience && m_random() % 16 == 0;
    if (!m_labels.is_valid(Surface::face(h)))
      for (int i = 0; i < 3; ++i, h = Surface::next(h))
        consider_changes(h, step > m_patience);
    else
      m_surface.for_each_outgoing(m_surface.source(h), [&](int g) {
        consider_changes(g, true);
        consider_changes(Surface::next(g), true);
      });
    return m_best;
  }

  // fixed edges keep their labels
  void consider_changes(int h, bool on_one_side_too)
  {
    if (m_surface.is_fixed(h))
      return;
    for (int shift = 1; shift < 4; ++shift) {
      consider({h, shift, true});
      if (on_one_side_too) {
        consider({h, shift, false});
        consider({m_surface.opposite(h), shift, false});
      }
    }
  }

  // The random part of the cost breaks ties, and lets the search leave local minima; deep ones, by
  // changes now and then for which nothing else counts.
  void consider(const Change& change)
  {
    double rise = double(m_random() % 1024) / 1024;
    if (!m_at_random) {
      rise -= cost(change.halfedge);
      shift_labels(change, change.shift);
      rise += cost(change.halfedge);
      shift_labels(change, 4 - change.shift);
    }
    if (rise < m_best_cost) {
      m_best_cost = rise;
      m_best = change;
    }
  }

  void shift_labels(const Change& change, int shift)
  {
    const int h = change.halfedge, g = m_surface.opposite(h);
    m_labels.set(h, m_labels.quadrant(h) + shift);
    if (change.both_sides)
      m_labels.set(g, m_labels.quadrant(g) + shift);
  }

  void apply(const Change& change)
  {
    shift_labels(change, change.shift);
    m_changes.push_back(change);
    suspect(change.halfedge);
    suspect(m_surface.opposite(change.halfedge));
  }

  // what is wrong at the edge of h: in its two faces, at their four vertices, and in its labels
  double cost(int h) const
  {
    const int g = m_surface.opposite(h);
    return face_cost(Surface::face(h)) + face_cost(Surface::face(g)) +
           vertex_cost(m_surface.source(h)) + vertex_cost(m_surface.source(g)) + label_cost(h) +
           label_cost(g);
  }
  double face_cost(int f) const { return 8 * number_of_wrong_labels(f); }
  // how many labels must change for a face to be valid; two always suffice, as at most one is fixed
  int number_of_wrong_labels(int f) const
  {
    if (m_labels.is_valid(f))
      return 0;
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      for (int shift = 1; shift < 4 && !m_surface.is_fixed(h); ++shift)
        if (m_labels.is_valid_with(h, shift))
          return 1;
    return 2;
  }
  double vertex_cost(int v) const
  {
    const int valence = m_labels.valence(v);
    const int moved = m_labels.index(v) != m_field.index(v) ? 2 : 0;
    const int slim = is_too_slim(v) ? 4 : 0;
    return 8 * (std::max)(Labels::least_valence - valence, 0) + slim + moved;
  }
  double label_cost(int h) const
  {
    constexpr double distance[] = {0, 1, 2, 1};
    return distance[(m_labels.quadrant(h) - m_original.quadrant(h)) & 3] / 2;
  }

  [[noreturn]] void fail(int h) const
  {
    throw Stage_failure(
        "trace_motorcycle_graph: cannot say which way the field runs through face " +
        std::to_string(Surface::face(h)) + ", or around vertex " +
        std::to_string(m_surface.source(h)));
  }

  Labels& m_labels;
  const Labels m_original;
  const Cross_field& m_field;
  const Surface& m_surface;
  std::vector<int> m_suspects;
  std::vector<Change> m_changes; // of the present search
  std::size_t m_patience = 0;
  bool m_bears_slim_vertices = true;
  std::mt19937 m_random{5489u};
  Change m_best{};
  double m_best_cost = 0;
  bool m_at_random = false; // whether costs do not count for the next change
};

// returns the labels of the field, repaired where need be
inline Labels make_labels(const Cross_field& field)
{
  Labels labels(field);
  Label_repair repair(labels, field);
  repair();
  return labels;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_REPAIR_LABELS_H
