// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_SMOOTH_QUAD_MESH_H
#define CGAL_QUAD_LAYOUTS_SMOOTH_QUAD_MESH_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Quad_smoother.h>
#include <CGAL/Quad_layouts/internal/require_parameter.h>
#include <CGAL/Quad_layouts/internal/surface/fix_constrained_edges.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/visitor.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Quad_layouts {

namespace internal {

inline void check_quads(const Polygons& mesh)
{
  for (int f = 0; f < mesh.number_of_faces(); ++f)
    if (mesh.degree(f) != 4)
      throw Stage_failure("smooth_quad_mesh: face " + std::to_string(f) + " has " +
                          std::to_string(mesh.degree(f)) + " sides instead of four");
}

// the points of a working mesh go back to the mesh it was made from
template <class PolygonMesh, class VertexPointMap>
void put_points(const Polygons& from, PolygonMesh& mesh, const VertexPointMap vpm)
{
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  std::size_t i = 0;
  for (const auto v : vertices(mesh)) {
    const Eigen::Vector3d& p = from.points[i++];
    put(vpm, v, Point_3(p.x(), p.y(), p.z()));
  }
}

// the visitor and the time limit of the first pack, or else those of the second
template <class NamedParameters, class OtherParameters>
Monitor monitor_from(const NamedParameters& np, const OtherParameters& other)
{
  const double seconds = running_time_limit(np, running_time_limit(other));
  using Found = decltype(parameters::get_parameter(np, internal_np::visitor));
  if constexpr (std::is_same_v<std::decay_t<Found>, internal_np::Param_not_found>)
    return visitor_of(other).limited_to(seconds);
  else
    return visitor_of(np).limited_to(seconds);
}

// the named parameter, which is checked
template <class NamedParameters>
int number_of_smoothing_iterations(const NamedParameters& np)
{
  const int result = parameters::choose_parameter(
      parameters::get_parameter(np, internal_np::number_of_iterations), 30);
  require_parameter(result >= 0, "number_of_iterations", result, "at least 0");
  return result;
}

} // namespace internal

/*!
\ingroup PkgQuadLayoutsFunctions

moves the vertices of a quad mesh on a surface, so that its quads get closer to rectangles.

All vertices move, irregular ones too: this is the step that carries the singularities of a layout
to better places (\cgalCite{lck-sqlrs-21}, Section 5). Only irregular vertices on the border and on
features, and corners of these, stay where they are; others slide along them, and no farther than
lets their edges follow the bends of the curve: within a thousandth of the diagonal of the bounding
box of the surface, where there are vertices enough for that. Other vertices do not cross the border
and features. First the vertices are put on the surface, and folded quads are turned back, each
group of them with as much of its surroundings as it takes, by the regularized distortion of
Garanzha et al., <em>Foldover-free maps in 50 lines of code</em>, 2021. Then vertices are moved to
weighted means of their neighbours, where edges count more the longer they are and the more the
surface bends along them. At last the quads' angles are optimized, by Newton steps for one vertex at
a time, with springs along the edges that resist short ones, so that quads keep some width. A move
that would turn a quad inside out, or over by more than 60 degrees against the surface, is not made.
Quads that are inverted all the same, or oppose the triangles nearest to their centres, are
untangled at the end, if need be from random places (always the same); so are quads of a low scaled
Jacobian. Vertices follow the surface continuously, from triangle to triangle, and so
never jump between the two sides of a thin part.

\tparam QuadMesh a model of `FaceListGraph`
\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParametersQuads a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParametersSurface a sequence of \ref bgl_namedparameters "Named Parameters"

\param quads the quad mesh
\param surface the surface, which `quads` should already lie close to
\param np_quads an optional sequence of \ref bgl_namedparameters "Named Parameters" among those
        listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `quads`}
    \cgalParamType{a class model of `ReadWritePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, quads)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges of `quads` on feature curves. Their vertices stay on constrained
                          edges of the surface.}
    \cgalParamType{a class model of `ReadablePropertyMap` with the edge descriptor of `QuadMesh` as
                   key type and `bool` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the number of sweeps over all vertices that optimize angles; there are
                          twice as many that take means of neighbours}
    \cgalParamType{`int`}
    \cgalParamDefault{30}
    \cgalParamExtra{With 0 the vertices are only put on the surface, and inverted quads untangled.}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_running_time}
    \cgalParamDescription{when to end, in seconds, with the shapes that have been reached}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{that of `np_surface`, or else unlimited}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{an object that follows the work and may stop it}
    \cgalParamType{a model of `QuadLayoutsVisitor`}
    \cgalParamDefault{that of `np_surface`, or else `Default_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\param np_surface an optional sequence of \ref bgl_namedparameters "Named Parameters" among those
        listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `surface`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a
three-dimensional point as value type} \cgalParamDefault{`boost::get(CGAL::vertex_point, surface)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges of feature curves of the surface}
    \cgalParamType{a class model of `ReadablePropertyMap` with the edge descriptor of `TriangleMesh`
                   as key type and `bool` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throw Invalid_mesh if `surface` cannot be used; the exception is of the class that says why.
\throw Invalid_parameter if `number_of_iterations` is negative, or `maximum_running_time` is not
positive.
\throw Stage_failure if a face of `quads` is not a quad.
\throw Cancelled if the visitor stops the work. `quads` has not been changed then.

\return the number of quads that are inverted or oppose the surface all the same

The time is linear in the number of vertices and iterations.

\sa `measure_quad_mesh()`
*/
template <class QuadMesh, class TriangleMesh,
          class NamedParametersQuads = parameters::Default_named_parameters,
          class NamedParametersSurface = parameters::Default_named_parameters>
std::size_t smooth_quad_mesh(
    QuadMesh& quads, const TriangleMesh& surface,
    const NamedParametersQuads& np_quads = parameters::default_values(),
    const NamedParametersSurface& np_surface = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const int number_of_iterations = internal::number_of_smoothing_iterations(np_quads);
  const auto quad_points = choose_parameter(get_parameter(np_quads, internal_np::vertex_point),
                                            get_property_map(vertex_point, quads));

  const internal::Monitor monitor = internal::monitor_from(np_quads, np_surface);
  return monitor.run("smooth_quad_mesh", [&] {
    const internal::Triangle_surface triangles = internal::surface_with_fixed_edges(surface,
                                                                                    np_surface);
    internal::Polygons mesh = internal::make_polygons(quads, quad_points);
    internal::check_quads(mesh);
    internal::mark_features(quads, get_parameter(np_quads, internal_np::edge_is_constrained), mesh);
    const internal::Surface_walk walk(triangles);
    internal::Quad_smoother smoother(mesh, walk);
    smoother.run(number_of_iterations, monitor);
    internal::put_points(mesh, quads, quad_points);
    return smoother.bad_quads().size();
  });
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_SMOOTH_QUAD_MESH_H
