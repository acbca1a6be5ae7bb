// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_SEAMLESS_OPTIMIZATION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_SEAMLESS_OPTIMIZATION_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/parametrization/Aligned_energy.h>
#include <CGAL/Quad_layouts/internal/parametrization/Cut_graph.h>
#include <CGAL/Quad_layouts/internal/parametrization/Reduced_newton.h>
#include <CGAL/Quad_layouts/internal/parametrization/Rosettes.h>
#include <CGAL/Quad_layouts/internal/parametrization/Seam_constraints.h>
#include <CGAL/Quad_layouts/internal/parametrization/Target_lengths.h>
#include <CGAL/Quad_layouts/internal/parametrization/check_parametrization.h>
#include <CGAL/Quad_layouts/internal/parametrization/exact_parametrization.h>

#include <cstddef>
#include <set>
#include <utility>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The search for a seamless parametrization of a cross field that is locally injective.
class Seamless_optimization
{
public:
  // `field` must outlive this, and so must `monitor`
  Seamless_optimization(const Cross_field& field, const Target_lengths& lengths, int most_steps,
                        const Monitor& monitor)
    : m_field(field), m_edge_length(lengths.uniform()), m_most_steps(most_steps),
      m_monitor(monitor), m_cut(field), m_seams(field.surface(), m_cut),
      m_energy(field.surface(), m_cut, m_seams, lengths), m_newton(m_seams, m_energy)
  {
  }

  // finds the map that fits the field best, and turns its inverted triangles back
  void align()
  {
    m_newton.align();
    untangle();
  }

  // does the same with the triangles around some vertices spread like the rosettes of another
  // field, which differs in its indices at most, and then lets them go
  void align_with_rosettes(const Cross_field& field, const std::set<int>& vertices)
  {
    const Rosettes rosettes(field, m_cut, m_edge_length);
    for (const int v : vertices)
      rosettes.demand(v, m_energy);
    align();
    m_energy.release();
    untangle();
  }

  // The map after the triangles around vertices that have a wrong sum of angles were spread, as far
  // as that helps: around those of valence 5 and more, or all of them if triangles are inverted.
  Seamless_parametrization repaired_result()
  {
    constexpr int most_rounds = 3;
    std::set<int> vertices;
    Seamless_parametrization best = result();
    for (int round = 0; round < most_rounds && best.wrong_winding > 0; ++round) {
      const std::size_t known = vertices.size();
      for (const int v : wrong_windings(best))
        if (m_field.index(v) < 0 || best.inverted > 0)
          vertices.insert(v);
      if (vertices.size() == known)
        break;
      align_with_rosettes(m_field, vertices);
      Seamless_parametrization map = result();
      if (number_of_defects(map) >= number_of_defects(best))
        break;
      best = std::move(map);
    }
    return best;
  }

  Seamless_parametrization result() const
  {
    return exact_parametrization(m_field, m_cut, m_seams, m_newton.coordinates(), m_edge_length);
  }

private:
  void untangle()
  {
    constexpr double barrier = 0.1;
    m_newton.untangle(barrier, m_most_steps, m_monitor);
  }

  const Cross_field& m_field;
  double m_edge_length;
  int m_most_steps;
  const Monitor& m_monitor;
  Cut_graph m_cut;
  Seam_constraints m_seams;
  Aligned_energy m_energy;
  Reduced_newton m_newton;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_SEAMLESS_OPTIMIZATION_H
