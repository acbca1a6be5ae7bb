// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_QUANTIZE_H
#define CGAL_QUAD_LAYOUTS_QUANTIZE_H

#include <CGAL/Quad_layouts/Quantization.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/quantization/Quantization_options.h>
#include <CGAL/Quad_layouts/internal/quantization/Quantization_search.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/visitor.h>
#if __has_include(<glpk.h>)
#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>
#endif

namespace CGAL {
namespace Quad_layouts {

template <class FT>
class GLPK_mixed_integer_program_traits;

/*!
\ingroup PkgQuadLayoutsFunctions

gives each arc of a T-mesh a non-negative integer length, so that the T-mesh becomes a conforming
quad layout that is as simple as the limits on deviation and displacement allow.

Arcs of length 0 are collapsed in the layout; singularities joined by them merge. The lengths
minimise the total length of all dual loops of the layout, subject to the relaxed integer program of
\cgalCite{lck-sqlrs-21}, Section 4: opposite sides of all patches are equally long; singularities
that are out of reach of each other stay separate; those that merge have indices that add up to an
index in the permitted range; and separatrices that would deviate too much do not form. Conditions
that no quantization of the T-mesh can satisfy are given up and counted (Equations (7) to (9)).
Beyond the program of the paper every result is a valid layout of the same surface: collapsing arcs
changes neither topology nor orientation, and no merged vertex has an index out of range unnoticed.

Programs with up to about a hundred singularities are mostly solved to the relative gap in less than
a second. Where thousands of pairs of singularities are close, the solver sees only the index rows
that some solution has violated; the bound holds without the others, and each solution is checked
against all. Cuts that turn invalid layouts away may, in rare cases, exclude a valid one as well;
the bound does not rest on these. The parts of the search end by limits of work, so that the result
does not depend on the speed of the machine, unless a part reaches its share of the time of
the search or the whole search its end, which is usual above about one hundred singularities.

@tparam MixedIntegerProgramTraits a model of `QuadLayoutsMixedIntegerProgramTraits`, by default
        `GLPK_mixed_integer_program_traits<double>`; `CBC_mixed_integer_program_traits<double>` and
        `HiGHS_mixed_integer_program_traits<double>` prove better bounds
@tparam NamedParameters a sequence of named parameters

@param t_mesh a T-mesh
@param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{maximum_deviation}
    \cgalParamDescription{the angle, in degrees, by which layout edges may deviate from the traces.
                          It should be the one that the T-mesh was traced with.}
    \cgalParamType{double}
    \cgalParamDefault{`15`}
    \cgalParamExtra{It must be greater than 0 and less than 90.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_displacement}
    \cgalParamDescription{how far singularities may move, in units of the target edge length. With 0
                          none merge that can stay separate.}
    \cgalParamType{double}
    \cgalParamDefault{`2`}
    \cgalParamExtra{It must not be negative.}
  \cgalParamNEnd
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length of the edges of the quad mesh to come}
    \cgalParamType{double}
    \cgalParamDefault{one percent of the diagonal of the bounding box of the surface}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_valence}
    \cgalParamDescription{the least number of edges at a layout vertex; singularities of lower
                          valence remain if they do not merge}
    \cgalParamType{int}
    \cgalParamDefault{`3`}
    \cgalParamExtra{It must be in 2 to 4.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_valence}
    \cgalParamDescription{the greatest number of edges at a layout vertex; singularities of higher
                          valence remain if they do not merge}
    \cgalParamType{int}
    \cgalParamDefault{`8`}
    \cgalParamExtra{It must be at least 4.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{when to end, in seconds; the best solution found is returned}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_search_time}
    \cgalParamDescription{for how long to search solutions better than the first one, in seconds; the
                          best one found is returned}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{`30`}
  \cgalParamNEnd
  \cgalParamNBegin{relative_gap}
    \cgalParamDescription{how far, relatively, the objective may be above the proven bound for the
                          search to end; within it a solution counts as optimal}
    \cgalParamType{double}
    \cgalParamDefault{`0.01`}
    \cgalParamExtra{It must be in 0 to 1.}
  \cgalParamNEnd
  \cgalParamNBegin{concurrent_searches}
    \cgalParamDescription{in how many neighbourhoods of a solution better ones are looked for at the
                          same time, each in a thread of its own. The result depends on this
                          number, but not on how many processors there are.}
    \cgalParamType{int}
    \cgalParamDefault{`1`}
    \cgalParamExtra{It must be at least 1. If it is greater, several objects of the traits solve
                    programs at the same time; the visitor is called by one thread only.}
  \cgalParamNEnd
  \cgalParamNBegin{arc_weight_map}
    \cgalParamDescription{how dear arcs are: the term of each arc in the objective is multiplied by
                          its weight. `arc_weights()` makes such weights of weights of faces.}
    \cgalParamType{a class model of `ReadablePropertyMap` with `int`, an arc of `t_mesh`, as key
                   type and `double` as value type}
    \cgalParamDefault{a weight of 1 for each arc}
    \cgalParamExtra{Weights must be positive.}
  \cgalParamNEnd
  \cgalParamNBegin{forbidden_merges}
    \cgalParamDescription{pairs of singularities that must not fall together}
    \cgalParamType{a range of pairs of `int`, which are vertices of the surface}
    \cgalParamDefault{none}
    \cgalParamExtra{At each vertex must be a singularity of `t_mesh`.}
  \cgalParamNEnd
  \cgalParamNBegin{forced_connections}
    \cgalParamDescription{pairs of singularities that a layout edge must join: the shortest one
                          within the limits on deviation. It is divided where other singularities
                          come to lie on it.}
    \cgalParamType{a range of pairs of `int`, which are vertices of the surface}
    \cgalParamDefault{none}
    \cgalParamExtra{At each vertex must be a singularity of `t_mesh`.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_symmetry}
    \cgalParamDescription{a symmetry of the surface, which the quantization is to have wherever the
                          T-mesh has it: for each vertex its image}
    \cgalParamType{a range of `int`, as many as the user's mesh has vertices}
    \cgalParamDefault{none}
    \cgalParamExtra{Images of faces must be faces. With a symmetry the first solution is left to the
                    solver, which should be a good one if there are hundreds of singularities.}
  \cgalParamNEnd
  \cgalParamNBegin{lock_alignments}
    \cgalParamDescription{whether singularities that lie on a common line of the field, one next to
                          the other, stay on one, as on mechanical parts. Otherwise they are as free
                          as any others, and each may be offset if that is simpler.}
    \cgalParamType{bool}
    \cgalParamDefault{`false`}
    \cgalParamExtra{A line may miss a singularity by a slope of 0.025. Alignments that would make
                    singularities fall together are given up.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told the progress, and can stop the work}
    \cgalParamType{a class like `Default_visitor`}
    \cgalParamDefault{`Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

@return the lengths, with the proof of their quality. The status is `INFEASIBLE` if there is no
        valid layout, which happens only if arcs around a handle have length 0 in every
        quantization, or if none was found that has the forbidden merges, forced connections and
        symmetry that were asked for. These are never given up.

\throw Invalid_parameter if a parameter is out of its range.
\throw Unsatisfiable_demand if no quantization keeps a pair of `forbidden_merges` separate, or makes
       the layout edge of one of `forced_connections`; the message names its vertices. Or if no
       trace has an image under `vertex_symmetry`.
\throw Time_limit_exceeded if there is not even a first solution within `maximum_running_time`.
\throw Cancelled if the visitor asks to stop.

The first solution takes time about quadratic in the number of traces. The program is NP-hard: its
optimum takes exponential time in the worst case.

The parts of the search end after a number of nodes of the search tree, and at the latest after a
share of the time. The same input has the same output on every run, as long as no part takes the
whole of its share, which is 3 % of `maximum_search_time` for the shortest ones. Where results must
be the same on slow and fast machines, give more time, and end the search by `relative_gap`.
*/
template <class MixedIntegerProgramTraits = GLPK_mixed_integer_program_traits<double>,
          class NamedParameters = parameters::Default_named_parameters>
Quantization quantize(const T_mesh& t_mesh,
                      const NamedParameters& np = parameters::default_values())
{
  const internal::Quantization_options options = internal::quantization_options(t_mesh, np);
  const internal::Monitor monitor = internal::visitor_of(np);
  return monitor.run("quantize", [&] {
    return internal::Quantization_search<MixedIntegerProgramTraits>(t_mesh, options, monitor).run();
  });
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_QUANTIZE_H
