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
#include <CGAL/Quad_layouts/internal/tracing/index_moves.h>
#include <CGAL/Quad_layouts/internal/tracing/repair_labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Traces the extended motorcycle graph of a field, as far as that is a base for a layout.
//
// The graph that is not extended is traced first. It is contained in all others, so what falls
// together there does so in these, too.
class Field_tracing
{
public:
  Field_tracing(const Cross_field& field, const Motorcycles::Rule& rule, const Monitor& monitor)
    : m_labels(make_labels(field)), m_tracing(field.surface_pointer(), field, rule, monitor)
  {
  }

  T_mesh operator()()
  {
    m_tracing.set_extended(false);
    T_mesh result = m_tracing.trace(m_labels);
    std::vector<Chain> chains = Squeezed_singularities(result).chains_to_fixed_curves();
    if (!chains.empty())
      separate(chains, result);
    m_tracing.set_extended(true);
    return extend(Squeezed_singularities(result).number_of_losses());
  }

private:
  using Chain = std::vector<int>; // of arcs
  using Strip = std::vector<int>; // the arcs across it

  // extends traces as far as this lets no more singularities fall together than there are already
  T_mesh extend(int inevitable_losses)
  {
    for (;;) {
      T_mesh result = m_tracing.trace(m_labels);
      const Squeezed_singularities squeezed(result);
      if (squeezed.number_of_losses() <= inevitable_losses ||
          !squeezed.release(m_tracing.is_hasty()))
        return result;
    }
  }

  // separates fixed curves that chains of squeezed arcs join
  void separate(std::vector<Chain>& chains, T_mesh& t_mesh)
  {
    insert_dipoles(chains, t_mesh);
    for (std::size_t hopeless = 0; hopeless < chains.size();)
      if (!move_index_near(hopeless, chains, t_mesh))
        ++hopeless;
  }

  // Puts pairs of singularities on the strips across all chains, again and again as long as that
  // separates some.
  void insert_dipoles(std::vector<Chain>& chains, T_mesh& t_mesh)
  {
    constexpr int attempts = 40;
    std::vector<Strip> strips = Squeezed_singularities(t_mesh).arcs_across_strips();
    for (int i = 0; i < attempts && !chains.empty(); ++i) {
      const Labels before = m_labels;
      if (!insert_dipoles(t_mesh, strips, i))
        return;
      if (trace_better(chains, t_mesh))
        strips = Squeezed_singularities(t_mesh).arcs_across_strips();
      else
        m_labels = before;
    }
  }

  // The first attempt is made beside the curves, the next ones anywhere on the strips that cross
  // them: multiples of the golden ratio are spread evenly.
  bool insert_dipoles(const T_mesh& t_mesh, const std::vector<Strip>& strips, int attempt)
  {
    constexpr double golden_ratio = 0.61803398874989485;
    const double place = attempt * golden_ratio - std::floor(attempt * golden_ratio);
    Dipoles dipoles(t_mesh, m_labels);
    bool changed = false;
    for (Strip arcs : strips) {
      std::rotate(arcs.begin(), arcs.begin() + int(place * double(arcs.size())), arcs.end());
      changed |= dipoles.insert(arcs);
    }
    return changed;
  }

  // traces what the labels are now, and keeps that if there are fewer chains; says if so
  bool trace_better(std::vector<Chain>& chains, T_mesh& t_mesh)
  {
    T_mesh other = m_tracing.trace(m_labels);
    std::vector<Chain> others = Squeezed_singularities(other).chains_to_fixed_curves();
    if (others.size() >= chains.size())
      return false;
    t_mesh = std::move(other);
    chains = std::move(others);
    return true;
  }

  // Looks for a move of index near a chain, which may change singularities and corners that are
  // there, after which there is a chain less; says if there is one.
  bool move_index_near(std::size_t i, std::vector<Chain>& chains, T_mesh& t_mesh)
  {
    for (const Index_move& move : index_moves_near(t_mesh, chains[i], m_labels)) {
      move.apply(m_labels);
      if (trace_better(chains, t_mesh))
        return true;
      move.undo(m_labels);
    }
    return false;
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
