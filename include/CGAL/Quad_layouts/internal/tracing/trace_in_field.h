// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_FIELD_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_FIELD_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/internal/tracing/Field_chords.h>
#include <CGAL/Quad_layouts/internal/tracing/Squeezed_singularities.h>
#include <CGAL/Quad_layouts/internal/tracing/Tracing.h>
#include <CGAL/Quad_layouts/internal/tracing/index_moves.h>
#include <CGAL/Quad_layouts/internal/tracing/repair_labels.h>

#include <cstddef>
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
    T_mesh result = trace_apart();
    std::vector<Chain> chains = Squeezed_singularities(result).chains_to_fixed_curves();
    if (!chains.empty() && separate(chains, result))
      extend_again(chains.size(), result);
    return result;
  }

private:
  using Chain = std::vector<int>; // of arcs

  // extends traces as far as this does not squeeze singularities
  T_mesh trace_apart()
  {
    T_mesh result = m_tracing.trace(m_labels);
    while (Squeezed_singularities(result).release(m_tracing.is_hasty()))
      result = m_tracing.trace(m_labels);
    return result;
  }

  // Separates fixed curves that chains of squeezed arcs join, one chain after another. The graph is
  // not extended meanwhile: longer traces squeeze more. Returns whether there are fewer chains now.
  bool separate(std::vector<Chain>& chains, T_mesh& t_mesh)
  {
    const std::size_t number = chains.size();
    m_tracing.set_extended(false);
    for (std::size_t hopeless = 0; hopeless < chains.size();)
      if (!separate(hopeless, chains, t_mesh))
        ++hopeless;
    return chains.size() < number;
  }

  // looks for a move of index after which there is a chain less
  bool separate(std::size_t i, std::vector<Chain>& chains, T_mesh& t_mesh)
  {
    for (const Index_move& move : index_moves_near(t_mesh, chains[i], m_labels)) {
      move.apply(m_labels);
      T_mesh other = m_tracing.trace(m_labels);
      std::vector<Chain> others = Squeezed_singularities(other).chains_to_fixed_curves();
      if (others.size() < chains.size()) {
        t_mesh = std::move(other);
        chains = std::move(others);
        return true;
      }
      move.undo(m_labels);
    }
    return false;
  }

  // extends the graph if there are no more chains then
  void extend_again(std::size_t number_of_chains, T_mesh& t_mesh)
  {
    m_tracing.set_extended(true);
    T_mesh extended = trace_apart();
    if (Squeezed_singularities(extended).chains_to_fixed_curves().size() <= number_of_chains)
      t_mesh = std::move(extended);
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
