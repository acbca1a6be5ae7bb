// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_FIELD_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_FIELD_H

#include <CGAL/Quad_layouts/internal/tracing/Dipoles.h>
#include <CGAL/Quad_layouts/internal/tracing/Squeezed_singularities.h>
#include <CGAL/Quad_layouts/internal/tracing/T_mesh_assembly.h>
#include <CGAL/Quad_layouts/internal/tracing/check_t_mesh.h>
#include <CGAL/Quad_layouts/internal/tracing/repair_labels.h>
#include <CGAL/Quad_layouts/internal/tracing/starting_vertices.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// returns the rule for stopping. Traces that are many times longer than the surface is wide run
// around a limit cycle or into a spiral; the first goes on forever, the second has finite length
// but no last triangle.
inline Motorcycles::Rule stopping_rule(const Triangle_surface& surface, double tangent,
                                       double displacement)
{
  double area = 0;
  for (int f = 0; f < surface.number_of_faces(); ++f)
    area += surface.area(f);
  const int steps = 1000 + int(100 * std::sqrt(double(surface.number_of_faces())));
  return {true, tangent, displacement, 50 * std::sqrt(area), steps};
}

// returns a vertex of face f, or of the faces around it, at which no trace starts
inline int seed_beside(const Labels& labels, int f)
{
  const Triangle_surface& surface = labels.surface();
  int seed = -1;
  for (int h = 3 * f; h < 3 * f + 3 && seed < 0; ++h)
    surface.for_each_outgoing(surface.source(h), [&](int g) {
      const int v = surface.target(g);
      if (seed < 0 && labels.index(v) == 0 && surface.number_of_fixed_edges(v) == 0)
        seed = v;
    });
  return seed;
}

// Traces the extended motorcycle graph of a field, and does so again where that turns out to be no
// base for a layout.
class Field_tracing
{
public:
  Field_tracing(const Cross_field& field, const Motorcycles::Rule& rule, const Monitor& monitor)
    : m_field(field), m_monitor(monitor), m_rule(rule), m_labels(make_labels(field))
  {
  }

  T_mesh operator()()
  {
    T_mesh result = trace();
    while (Squeezed_singularities(result).release(m_is_hasty))
      result = trace();
    separate_fixed_curves(result);
    return result;
  }

private:
  using Arcs = std::vector<int>;

  // A trace that runs through a region without singularities meets those of a seed there.
  T_mesh trace()
  {
    for (;;) {
      Chords chords(m_field, m_labels);
      Motorcycles motorcycles(chords, m_rule, starting_vertices(m_labels, m_seeds), m_is_hasty);
      const int lonely = motorcycles.run(m_monitor);
      if (lonely < 0) {
        T_mesh result = T_mesh_assembly(m_field.surface_pointer(), chords, motorcycles)();
        check_t_mesh(result);
        return result;
      }
      const int seed = seed_beside(m_labels, lonely);
      if (seed < 0 || std::find(m_seeds.begin(), m_seeds.end(), seed) != m_seeds.end())
        throw Stage_failure("trace_motorcycle_graph: a trace in face " + std::to_string(lonely) +
                            " finds no other to stop at");
      m_seeds.push_back(seed);
      m_is_hasty.clear(); // traces are numbered by their starts
    }
  }

  // Puts singularities between fixed curves that fall together, again and again as long as this
  // separates some. The graph is not extended from then on: longer traces squeeze more.
  void separate_fixed_curves(T_mesh& best)
  {
    constexpr int attempts = 40;
    std::vector<Arcs> strips = Squeezed_singularities(best).arcs_across_strips();
    m_rule.is_extended = false;
    for (int i = 0; i < attempts && !strips.empty(); ++i) {
      const Labels before = m_labels;
      if (!insert_dipoles(best, strips, i))
        return;
      T_mesh other = trace();
      std::vector<Arcs> others = Squeezed_singularities(other).arcs_across_strips();
      if (others.size() < strips.size()) {
        best = std::move(other);
        strips = std::move(others);
      } else
        m_labels = before;
    }
  }

  // The first attempt is made beside the curves, the next ones anywhere on the strips that cross
  // them: multiples of the golden ratio are spread evenly.
  bool insert_dipoles(const T_mesh& t_mesh, const std::vector<Arcs>& strips, int attempt)
  {
    constexpr double golden_ratio = 0.61803398874989485;
    const double place = attempt * golden_ratio - std::floor(attempt * golden_ratio);
    Dipoles dipoles(t_mesh, m_labels);
    bool changed = false;
    for (Arcs arcs : strips) {
      std::rotate(arcs.begin(), arcs.begin() + int(place * double(arcs.size())), arcs.end());
      changed |= dipoles.insert(arcs);
    }
    return changed;
  }

  const Cross_field& m_field;
  const Monitor& m_monitor;
  Motorcycles::Rule m_rule;
  Labels m_labels;
  std::vector<int> m_seeds;
  std::vector<char> m_is_hasty; // per trace
};

// traces the extended motorcycle graph of a field; `tangent` is that of the maximum deviation,
// `displacement` a length
inline T_mesh trace_in_field(const Cross_field& field, double tangent, double displacement,
                             const Monitor& monitor)
{
  return Field_tracing(field, stopping_rule(field.surface(), tangent, displacement), monitor)();
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_FIELD_H
