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
#include <CGAL/Quad_layouts/extract_quad_mesh.h>
#include <CGAL/Quad_layouts/graph_traits_Halfedge_complex.h>
#include <CGAL/Quad_layouts/internal/running_time_limit.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/smooth_quad_mesh.h>

#include <CGAL/boost/graph/copy_face_graph.h>

#include <boost/property_map/property_map.hpp>

#include <unordered_map>
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

template <class TriangleMesh, class NamedParameters>
T_mesh t_mesh_of(const TriangleMesh& tm, const Time_budget& budget, const NamedParameters& np)
{
  const Cross_field field = compute_cross_field(
      tm, with_time_limit(np, budget.left_for("compute_cross_field")));
  return compute_t_mesh(field, with_time_limit(np, budget.left_for("trace_motorcycle_graph")));
}

template <class TriangleMesh, class NamedParameters>
Quad_layout simple_layout(const T_mesh& t_mesh, const TriangleMesh& tm, const Time_budget& budget,
                          const NamedParameters& np)
{
  const double seconds = budget.left_for_search(Quantization_options::default_seconds);
  const Quantization quantization = quantize_on_mesh(t_mesh, tm, with_time_limit(np, seconds));
  if (quantization.status == Quantization::INFEASIBLE)
    throw Stage_failure("quantize: no valid layout was found that meets all demands" +
                        (quantization.reason.empty() ? "" : "; " + quantization.reason));
  return extract_quad_layout(t_mesh, quantization);
}

// empties a mesh, whose property maps stay; `CGAL::clear()` takes away those of a `Surface_mesh`
template <class Mesh>
void remove_all(Mesh& mesh)
{
  using Traits = boost::graph_traits<Mesh>;
  const std::vector<typename Traits::face_descriptor> fs(faces(mesh).begin(), faces(mesh).end());
  const std::vector<typename Traits::edge_descriptor> es(edges(mesh).begin(), edges(mesh).end());
  const std::vector<typename Traits::vertex_descriptor> vs(vertices(mesh).begin(),
                                                           vertices(mesh).end());
  for (const auto f : fs)
    remove_face(f, mesh);
  for (const auto e : es)
    remove_edge(e, mesh);
  for (const auto v : vs)
    remove_vertex(v, mesh);
}

// the pack, with a map for the edges on fixed curves if it has none; its values go to `on_curve`,
// as the mesh has no edges yet
template <class Edges, class NamedParameters>
auto with_edge_map(Edges& on_curve, const NamedParameters& np)
{
  if constexpr (parameters::is_default_parameter<NamedParameters,
                                                 internal_np::edge_is_constrained_t>::value)
    return np.edge_is_constrained_map(boost::associative_property_map<Edges>(on_curve));
  else {
    CGAL_USE(on_curve);
    return np;
  }
}

} // namespace internal

/*!
\ingroup PkgQuadLayoutsFunctions

computes a simple quad layout of a triangle mesh: few four-sided patches, without T-joints.

It runs `compute_cross_field()`, `compute_t_mesh()`, `quantize()` and
`extract_quad_layout()`, and passes `np` to each of them. The layout is appended to `out` as a mesh
of quadrilaterals with straight edges. A patch may be several faces long. Coarse layouts can have
loops and several edges between two vertices, which not every function on meshes expects.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam LayoutMesh a model of `MutableFaceGraph`
\tparam NamedParameters a sequence of named parameters
\tparam NamedParametersOut a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the surface
\param out the mesh that the layout is added to
\param np an optional sequence of the named parameters of the stages: `maximum_deviation`,
          `maximum_displacement`, `target_edge_length`, `layout_route`, `minimum_valence`,
          `maximum_valence`, `vertex_point_map`, `visitor`, ...; `maximum_running_time`, which is for all stages together,
          of which the integer program gets 30 seconds at most; and `face_weight_map`, which says how
          dear patches are on a face, see `arc_weights()`
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
  const T_mesh t_mesh = internal::t_mesh_of(tm, budget, np);
  const Quad_layout layout = internal::simple_layout(t_mesh, tm, budget, np);
  copy_face_graph(layout, out, parameters::default_values(), np_out);
}

/*!
\ingroup PkgQuadLayoutsFunctions

remeshes a triangle mesh with quadrilaterals, on a simple quad layout.

It runs all stages, from `compute_cross_field()` to `smooth_quad_mesh()`, and passes `np` to each of
them.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam QuadMesh a model of `MutableFaceGraph`
\tparam NamedParameters a sequence of named parameters
\tparam NamedParametersOut a sequence of \ref bgl_namedparameters "Named Parameters"

\param tm the surface
\param out the mesh that the quadrilaterals are stored in; it must be empty
\param np an optional sequence of the named parameters of the stages: `maximum_deviation`,
          `maximum_displacement`, `target_edge_length`, `layout_route`, `minimum_valence`,
          `maximum_valence`, `vertex_point_map`, `visitor`, ...; `maximum_running_time`, which is for all stages together,
          of which the integer program gets 30 seconds at most; and `face_weight_map`, which says how
          dear patches are on a face, see `arc_weights()`
\param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" for `out`:
              those of `extract_quad_mesh()` and `smooth_quad_mesh()`

\pre `out` is empty.

\throw Error one of the exceptions of the stages. `out` is empty then.
*/
template <class TriangleMesh, class QuadMesh,
          class NamedParameters = parameters::Default_named_parameters,
          class NamedParametersOut = parameters::Default_named_parameters>
void quad_remesh(const TriangleMesh& tm, QuadMesh& out,
                 const NamedParameters& np = parameters::default_values(),
                 const NamedParametersOut& np_out = parameters::default_values())
{
  CGAL_precondition(is_empty(out));
  using internal::with_time_limit;
  const internal::Time_budget budget(internal::running_time_limit(np));
  const T_mesh t_mesh = internal::t_mesh_of(tm, budget, np);
  const Quad_layout layout = internal::simple_layout(t_mesh, tm, budget, np);
  std::unordered_map<typename boost::graph_traits<QuadMesh>::edge_descriptor, bool> on_curve;
  const auto np_quads = internal::with_edge_map(on_curve, np_out);
  const auto np_map = with_time_limit(np, budget.left_for("embed_quad_layout"));
  extract_quad_mesh(embed_quad_layout(t_mesh, layout, np_map), layout, out, np_quads);
  try {
    smooth_quad_mesh(out, tm, np_quads, with_time_limit(np, budget.left_for_improvement()));
  } catch (...) {
    internal::remove_all(out);
    throw;
  }
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_QUAD_REMESH_H
