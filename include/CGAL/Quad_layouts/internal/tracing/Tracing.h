// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACING_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACING_H

#include <CGAL/Quad_layouts/internal/tracing/T_mesh_assembly.h>
#include <CGAL/Quad_layouts/internal/tracing/check_t_mesh.h>
#include <CGAL/Quad_layouts/internal/tracing/starting_vertices.h>

#include <algorithm>
#include <cmath>
#include <memory>
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

// Traces motorcycle graphs of what `RouteChords` run in: a cross field, or a parametrization of the
// surface.
template <class RouteChords, class Route>
class Tracing
{
public:
  Tracing(std::shared_ptr<const Triangle_surface> surface, const Route& route,
          const Motorcycles::Rule& rule, const Monitor& monitor)
    : m_surface(std::move(surface)), m_route(route), m_monitor(monitor), m_rule(rule)
  {
  }

  // A trace that runs through a region without singularities meets those of a seed there.
  T_mesh trace(const Labels& labels)
  {
    for (;;) {
      RouteChords chords(m_route, labels);
      Motorcycles motorcycles(chords, m_rule, starting_vertices(labels, m_seeds), m_is_hasty);
      const int lonely = motorcycles.run(m_monitor);
      if (lonely < 0) {
        T_mesh result = T_mesh_assembly(m_surface, chords, motorcycles)();
        check_t_mesh(result);
        return result;
      }
      const int seed = seed_beside(labels, lonely);
      if (seed < 0 || std::find(m_seeds.begin(), m_seeds.end(), seed) != m_seeds.end())
        throw Stage_failure("trace_motorcycle_graph: a trace in face " + std::to_string(lonely) +
                            " finds no other to stop at");
      m_seeds.push_back(seed);
      m_is_hasty.clear(); // traces are numbered by their starts
    }
  }

  // the traces that are to stop at the first one that they meet
  std::vector<char>& is_hasty() { return m_is_hasty; }
  // if not, all do so
  void set_extended(bool is_extended) { m_rule.is_extended = is_extended; }

private:
  std::shared_ptr<const Triangle_surface> m_surface;
  const Route& m_route;
  const Monitor& m_monitor;
  Motorcycles::Rule m_rule;
  std::vector<int> m_seeds;
  std::vector<char> m_is_hasty; // per trace
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACING_H
