// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_HIGHS_MIXED_INTEGER_PROGRAM_TRAITS_H
#define CGAL_QUAD_LAYOUTS_HIGHS_MIXED_INTEGER_PROGRAM_TRAITS_H

#include <CGAL/Quad_layouts/internal/quantization/Program_traits_base.h>
#include <CGAL/Quad_layouts/internal/quantization/highs_search.h>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsSolvers

solves mixed integer programs by branch and cut with HiGHS (1.10 or later).

The node limit bounds the nodes of the search tree, where 200 iterations of the simplex method count
as much as a node. HiGHS runs in one thread, unless the program has started more of its threads
before, and writes nothing to the terminal. A feasible start solution is returned if the search
finds no better one before it ends.

\cgalModels{QuadLayoutsMixedIntegerProgramTraits}
*/
template <class FT>
class HiGHS_mixed_integer_program_traits
#ifdef DOXYGEN_RUNNING
  : public CGAL::Mixed_integer_program_traits<FT>
#else
  : public internal::Program_traits_base<FT, internal::Highs_search>
#endif
{
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_HIGHS_MIXED_INTEGER_PROGRAM_TRAITS_H
