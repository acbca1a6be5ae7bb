// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_FIELD_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_FIELD_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/internal/tracing/Dipoles.h>
#include <CGAL/Quad_layouts/internal/tracing/Field_chords.h>
#include <CGAL/Quad_layouts/internal/tracing/Squeezed_singularities.h>
#include <CGAL/Quad_layouts/internal/tracing/Tracing.h>
#include <CGAL/Quad_layouts/internal/tracing/repair_labels.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Traces the extended motorcycle graph of a field, and does so again where that turns out to be no
// base for a layout.
class Field_tracing
{
public:
  Field_tracing(const Cross_field& field, const Motorcycles::Rule& rule, const Monitor& monitor)
    : m_labels(make_labels(field)), m_tracing(field.surface_pointer(), field, rule, monitor)
  {
  }

  T_mesh operator()()
  {
    T_mesh result = m_tracing.trace(m_labels);
    while (Squeezed_singularities(result).release(m_tracing.is_hasty()))
      result = m_tracing.trace(m_labels);
    separate_fixed_curves(result);
    return result;
  }

private:
  using Arcs = std::vector<int>;

  // Puts singularities between fixed curves that fall together, again and again as long as this
  // separates some. The graph is not extended from then on: longer traces squeeze more.
  void separate_fixed_curves(T_mesh& best)
  {
    constexpr int attempts = 40;
    std::vector<Arcs> strips = Squeezed_singularities(best).arcs_across_strips();
    m_tracing.stop_extending();
    for (int i = 0; i < attempts && !strips.empty(); ++i) {
      const Labels before = m_labels;
      if (!insert_dipoles(best, strips, i))
        return;
      T_mesh other = m_tracing.trace(m_labels);
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

  Labels m_labels;
  Tracing<Field_chords, Cross_field> m_tracing;
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
