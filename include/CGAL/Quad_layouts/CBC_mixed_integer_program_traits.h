// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_CBC_MIXED_INTEGER_PROGRAM_TRAITS_H
#define CGAL_QUAD_LAYOUTS_CBC_MIXED_INTEGER_PROGRAM_TRAITS_H

#include <CGAL/Quad_layouts/internal/quantization/Program_traits_base.h>
#include <CGAL/Quad_layouts/internal/quantization/cbc_search.h>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsSolvers

solves mixed integer programs by branch and cut with CBC (2.10 or later), which proves better bounds
than GLPK on large programs.

The node limit bounds the nodes of the search tree, where 200 iterations of the simplex method,
those of heuristics and trial branches included, count as much as a node. CBC runs in one thread and
writes nothing to the terminal. A feasible start solution is returned if the search finds no better
one before it ends.

\cgalModels{QuadLayoutsMixedIntegerProgramTraits}
*/
template <class FT>
class CBC_mixed_integer_program_traits
#ifdef DOXYGEN_RUNNING
  : public CGAL::Mixed_integer_program_traits<FT>
#else
  : public internal::Program_traits_base<FT, internal::Cbc_search>
#endif
{
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_CBC_MIXED_INTEGER_PROGRAM_TRAITS_H
