// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_MIXED_INTEGER_PROGRAM_TRAITS_ADAPTOR_H
#define CGAL_QUAD_LAYOUTS_MIXED_INTEGER_PROGRAM_TRAITS_ADAPTOR_H

#include <CGAL/Quad_layouts/internal/quantization/Program_traits_base.h>
#include <CGAL/Quad_layouts/internal/quantization/adapted_search.h>

#include <CGAL/tags.h>

#include <utility>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsSolvers

makes solvers that know neither limits nor start solutions usable for `quantize()`, as
`CGAL::SCIP_mixed_integer_program_traits<double>` and
`CGAL::GLPK_mixed_integer_program_traits<double>`.

Such a solver only says if it succeeded, and that is not always right: %CGAL's GLPK traits report
success for infeasible programs, and for unbounded linear ones. So solutions are checked here,
integers rounded, against all bounds and rows, and the status says what is known then:

- `OPTIMAL` if the solver succeeds, its solution is feasible and no worse than the start solution,
  the bounds of the variables bound the objective, and `OptimalityTag` tells to believe the solver;
  or if the point where each variable is at the better one of its bounds is feasible. `best_bound()`
  is the objective then.
- `FEASIBLE` if there is a feasible solution, which may be the start solution. `best_bound()`
  follows from the bounds of the variables alone, and can be infinite.
- `INFEASIBLE` only of programs without variables: no answer of the solver tells infeasible programs
  from those it has failed at.
- `UNKNOWN` if the time was over or the search stopped before it began, `FAILED` otherwise.

The search itself cannot be limited: `set_node_limit()` and `set_relative_gap()` do nothing, and
time limit and interrupt are only asked before and after the solver runs. Results are the same on
every run if the solver does not depend on the addresses of its variables.

\tparam PlainTraits a model of `MixedIntegerProgramTraits`, derived from
        `CGAL::Mixed_integer_program_traits`
\tparam OptimalityTag `CGAL::Tag_true` if feasible solutions with which the solver succeeds are
        optimal in programs that are not unbounded, else `CGAL::Tag_false`. With the default no
        optimum is proven, and `quantize()` uses all of its search.

\cgalModels{QuadLayoutsMixedIntegerProgramTraits}
*/
template <class PlainTraits, class OptimalityTag = Tag_false>
class Mixed_integer_program_traits_adaptor
#ifdef DOXYGEN_RUNNING
  : public CGAL::Mixed_integer_program_traits<FT>
#else
  : public internal::Program_traits_base<
        decltype(std::declval<const typename PlainTraits::Variable&>().solution_value()),
        internal::Adapted_search<PlainTraits, OptimalityTag::value>>
#endif
{
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_MIXED_INTEGER_PROGRAM_TRAITS_ADAPTOR_H
