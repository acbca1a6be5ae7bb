// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_QUAD_REMESH_H
#define CGAL_QUAD_LAYOUTS_QUAD_REMESH_H

#include <CGAL/Quad_layouts/arc_weights.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/compute_t_mesh.h>
#include <CGAL/Quad_layouts/embed_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/extract_smooth_quad_mesh.h>
#include <CGAL/Quad_layouts/graph_traits_Halfedge_complex.h>
#include <CGAL/Quad_layouts/internal/running_time_limit.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/try_layout_routes.h>

#include <CGAL/boost/graph/copy_face_graph.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

namespace internal {

// quantizes with weights of faces, if there are any
template <class TriangleMesh, class NamedParameters>
Quantization quantize_on_mesh(const T_mesh& t_mesh, const TriangleMesh& tm,
                              const NamedParameters& np)
{
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  if constexpr (is_default_parameter<NamedParameters, internal_np::face_weight_map_t>::value)
    return quantize(t_mesh, np);
  else {
    const std::vector<double> weights = arc_weights(
        t_mesh, tm, get_parameter(np, internal_np::face_weight_map));
    return quantize(t_mesh, append<internal_np::arc_weight_map_t>(np, make_property_map(weights)));
  }
}

// computes the field and T-meshes of a mesh, and what `remesh` makes of the best of these
template <class TriangleMesh, class NamedParameters, class Remesh>
auto remesh_by_routes(const TriangleMesh& tm, const Time_budget& budget, const NamedParameters& np,
                      const Remesh& remesh)
{
  const Cross_field field = compute_cross_field(
      tm, with_time_limit(np, budget.left_for("compute_cross_field")));
  const auto trace = [&](Layout_route route) {
    return compute_t_mesh(field, with_time_limit(append<internal_np::layout_route_t>(np, route),
                                                 budget.left_for("trace_motorcycle_graph")));
  };
  return try_layout_routes(trace, remesh, np);
}

template <class TriangleMesh, class NamedParameters>
Quad_layout simple_layout(const T_mesh& t_mesh, const TriangleMesh& tm, const Time_budget& budget,
                          const NamedParameters& np)
{
  const double seconds = budget.left_for_quantization();
  const Quantization quantization = quantize_on_mesh(t_mesh, tm, with_time_limit(np, seconds));
  if (quantization.status == Quantization::INFEASIBLE)
    throw Stage_failure("quantize: no valid layout was found that meets all demands" +
                        (quantization.reason.empty() ? "" : "; " + quantization.reason));
  return extract_quad_layout(t_mesh, quantization);
}

// what is made of a T-mesh: a layout, or the grid of a quad mesh
struct Layout_of_t_mesh
{
  Quad_layout layout;
  std::size_t number_of_bad_quads = 0;
};
struct Grid_of_t_mesh : Smooth_grid
{
  std::unique_ptr<const Quad_layout> layout; // which the grid refers to
};

} // namespace internal

/*!
\ingroup PkgQuadLayoutsFunctions

computes a simple quad layout of a triangle mesh: few four-sided patches, without T-joints.

It runs `compute_cross_field()`, `compute_t_mesh()`, `quantize()` and
`extract_quad_layout()`, and passes `np` to each of them; those from `compute_t_mesh()` on by
`try_layout_routes()`. The layout is appended to `out` as a mesh of quadrilaterals with straight
edges. A patch may be several faces long. Coarse layouts can have loops and several edges between
two vertices, which not every function on meshes expects.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam LayoutMesh a model of `MutableFaceGraph`
\tparam NamedParameters a sequence of named parameters
\tparam NamedParametersOut a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the surface
\param out the mesh that the layout is added to
\param np an optional sequence of the named parameters of the stages: `maximum_deviation`,
          `maximum_displacement`, `target_edge_length`, `layout_route`, `minimum_valence`,
          `maximum_valence`, `maximum_search_time`, `vertex_point_map`, `visitor`, ...;
          `maximum_running_time`, which is for all stages together; and `face_weight_map`, which
          says how dear patches are on a face, see `arc_weights()`
\param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" for `out`:
              `vertex_point_map`

\throw Error one of the exceptions of the stages, among them `Stage_failure` if there is no valid
       layout. Nothing has been added to `out` then.
*/
template <class TriangleMesh, class LayoutMesh,
          class NamedParameters = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters>
void quad_layout(const TriangleMesh& tm, LayoutMesh& out,
                 const NamedParameters& np = parameters::default_values(),
                 const NamedParametersOut& np_out = parameters::default_values())
{
  const internal::Time_budget budget(internal::running_time_limit(np));
  const auto remesh = [&](const T_mesh& t_mesh) -> internal::Layout_of_t_mesh {
    return {internal::simple_layout(t_mesh, tm, budget, np)};
  };
  copy_face_graph(internal::remesh_by_routes(tm, budget, np, remesh).layout, out,
                  parameters::default_values(), np_out);
}

/*!
\ingroup PkgQuadLayoutsFunctions

remeshes a triangle mesh with quadrilaterals, on a simple quad layout.

It runs all stages, from `compute_cross_field()` to `extract_smooth_quad_mesh()`, and passes `np` to
each of them; those from `compute_t_mesh()` on by `try_layout_routes()`.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam QuadMesh a model of `MutableFaceGraph`
\tparam NamedParameters a sequence of named parameters
\tparam NamedParametersOut a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the surface
\param out the mesh that the quadrilaterals are stored in; it must be empty
\param np an optional sequence of the named parameters of the stages: `maximum_deviation`,
          `maximum_displacement`, `target_edge_length`, `layout_route`, `minimum_valence`,
          `maximum_valence`, `maximum_search_time`, `vertex_point_map`, `visitor`, ...;
          `maximum_running_time`, which is for all stages together; and `face_weight_map`, which
          says how dear patches are on a face, see `arc_weights()`
\param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" for `out`:
              those of `extract_smooth_quad_mesh()`

\pre `out` is empty.

\return the number of quads that are inverted or oppose the surface; 0 for almost all surfaces

\throw Error one of the exceptions of the stages. `out` is empty then.
*/
template <class TriangleMesh, class QuadMesh,
          class NamedParameters = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters>
std::size_t quad_remesh(const TriangleMesh& tm, QuadMesh& out,
                        const NamedParameters& np = parameters::default_values(),
                        const NamedParametersOut& np_out = parameters::default_values())
{
  CGAL_precondition(is_empty(out));
  using internal::with_time_limit;
  const internal::Time_budget budget(internal::running_time_limit(np));
  const auto remesh = [&](const T_mesh& t_mesh) -> internal::Grid_of_t_mesh {
    auto layout = std::make_unique<const Quad_layout>(
        internal::simple_layout(t_mesh, tm, budget, np));
    const Integer_grid_map map = embed_quad_layout(
        t_mesh, *layout, with_time_limit(np, budget.left_for("embed_quad_layout")));
    internal::Smooth_grid grid = internal::smooth_grid_on(
        tm, map, *layout, np_out, with_time_limit(np, budget.left_for_improvement()));
    return {std::move(grid), std::move(layout)};
  };
  const internal::Grid_of_t_mesh best = internal::remesh_by_routes(tm, budget, np, remesh);
  internal::build_mesh(best.divided, best.points, out, np_out);
  return best.number_of_bad_quads;
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_QUAD_REMESH_H
