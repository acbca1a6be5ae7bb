// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_GLPK_MIXED_INTEGER_PROGRAM_TRAITS_H
#define CGAL_QUAD_LAYOUTS_GLPK_MIXED_INTEGER_PROGRAM_TRAITS_H

#include <CGAL/Quad_layouts/internal/quantization/Program_traits_base.h>
#include <CGAL/Quad_layouts/internal/quantization/glpk_search.h>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsSolvers

solves mixed integer programs by branch and cut with GLPK (5.0 or later).

Unlike `CGAL::GLPK_mixed_integer_program_traits` it tells infeasible programs from solved ones, has
limits, takes a start solution, and hands the rows over in an order that is the same on every run.
The node limit bounds the nodes of the search tree, where 100 iterations of the simplex method count
as much as a node. GLPK writes nothing to the terminal, and its fatal errors end in the status
`FAILED` instead of ending the process. After such an error the GLPK environment of the thread is
renewed: other GLPK objects of the caller in this thread are lost.

\cgalModels{QuadLayoutsMixedIntegerProgramTraits}
*/
template <class FT>
class GLPK_mixed_integer_program_traits
#ifdef DOXYGEN_RUNNING
  : public CGAL::Mixed_integer_program_traits<FT>
#else
  : public internal::Program_traits_base<FT, internal::Glpk_search>
#endif
{
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_GLPK_MIXED_INTEGER_PROGRAM_TRAITS_H
