// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_MEASURE_QUAD_MESH_H
#define CGAL_QUAD_LAYOUTS_MEASURE_QUAD_MESH_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_base_complex.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_distance.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/measure_shape.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsClasses

describes a quad mesh: its connectivity, the shape of its faces and, if a surface was given, how
closely it follows it.

The *scaled Jacobian* of a quad is the least sine of its angles, seen along its normal, the
direction of the cross product of its diagonals: 1 for a rectangle, not positive for a quad that is
not convex.
*/
struct Quad_mesh_measures
{
  int vertices = 0; ///< vertices of faces; isolated ones are not counted
  int edges = 0;
  int quads = 0;
  int non_quads = 0; ///< faces without exactly four different corners
  int euler_characteristic = 0;
  int components = 0;
  int border_edges = 0;

  int irregular_vertices = 0;  ///< of a valence other than 4 (3 on the border)
  std::map<int, int> valences; ///< number of interior vertices of each valence that occurs
  int patches = 0; ///< faces of the base complex, which feature curves divide, too; 0 if there are
                   ///< non-quads
  int patches_floor = 0; ///< least number of patches that the irregular vertices allow: each is a
                         ///< corner of as many patches as its valence, and a patch has four corners
  int t_junctions = 0; ///< corners by which faces exceed four; a quad with such a corner on a side
                       ///< has a T-junction

  double msj_minimum = 0; ///< least scaled Jacobian of a quad
  double msj_average = 0; ///< mean of the scaled Jacobians
  int inverted_quads = 0; ///< quads whose scaled Jacobian is not positive

  /// \name Agreement with a surface
  /// Zero unless a surface was given. Distances are measured at vertices and face centroids.
  /// @{
  double maximum_distance_to_surface = 0;
  double mean_distance_to_surface = 0;
  double maximum_distance_from_surface = 0;
  double mean_distance_from_surface = 0;
  int quads_against_surface =
      0; ///< quads whose normal opposes that of the triangle nearest to their centre
  /// @}
};

namespace internal {

inline bool is_quad(const Polygons& mesh, int f)
{
  if (mesh.degree(f) != 4)
    return false;
  std::array<int, 4> v = {mesh.corner(f, 0), mesh.corner(f, 1), mesh.corner(f, 2),
                          mesh.corner(f, 3)};
  std::sort(v.begin(), v.end());
  return std::adjacent_find(v.begin(), v.end()) == v.end();
}

inline void measure_connectivity(const Polygons& mesh, Quad_mesh_measures& result)
{
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    ++(is_quad(mesh, f) ? result.quads : result.non_quads);
    result.t_junctions += (std::max)(mesh.degree(f) - 4, 0);
  }
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    result.border_edges += mesh.is_border(h);
    result.edges += h > mesh.opposite[h];
  }
  const Vertex_valences vertices(mesh);
  int patch_corners = 0;
  for (int v = 0; v < mesh.number_of_vertices(); ++v) {
    if (vertices.valence[v] == 0)
      continue;
    ++result.vertices;
    if (!vertices.on_border[v])
      ++result.valences[vertices.valence[v]];
    if (!vertices.is_regular(v)) {
      ++result.irregular_vertices;
      patch_corners += vertices.valence[v] - (vertices.on_border[v] ? 1 : 0);
    }
  }
  result.patches_floor = (patch_corners + 3) / 4;
  result.euler_characteristic = result.vertices - result.edges + mesh.number_of_faces();
  std::vector<int> component;
  result.components = number_components(mesh, std::vector<char>(mesh.number_of_halfedges(), 0),
                                        component);
  if (result.non_quads == 0)
    result.patches = base_complex(mesh, vertices).number_of_patches;
}

inline void measure_shape(const Polygons& mesh, Quad_mesh_measures& result)
{
  double sum = 0, least = 1;
  for (int f = 0; f < mesh.number_of_faces(); ++f)
    if (is_quad(mesh, f)) {
      const double s = scaled_jacobian(quad_of(mesh, f));
      sum += s;
      least = (std::min)(least, s);
      result.inverted_quads += !(s > 0);
    }
  if (result.quads > 0) {
    result.msj_minimum = least;
    result.msj_average = sum / result.quads;
  }
}

inline void measure_agreement(const Polygons& mesh, const Polygons& surface,
                              Quad_mesh_measures& result)
{
  std::vector<int> face;
  const auto surface_triangles = triangulated(surface, face), triangles = triangulated(mesh, face);
  const Triangle_tree surface_tree(surface_triangles), tree(triangles);
  const Deviation there = deviation(triangles, mesh, surface_tree),
                  back = deviation(surface_triangles, surface, tree);
  result.maximum_distance_to_surface = there.maximum;
  result.mean_distance_to_surface = there.mean;
  result.maximum_distance_from_surface = back.maximum;
  result.mean_distance_from_surface = back.mean;
  for (int f = 0; f < mesh.number_of_faces(); ++f)
    if (is_quad(mesh, f)) {
      const Quad quad = quad_of(mesh, f);
      const int nearest = surface_tree.nearest(centre(quad)).triangle;
      result.quads_against_surface += area_vector(quad).dot(
                                          area_vector(surface_triangles[nearest])) < 0;
    }
}

template <class PolygonMesh, class NamedParameters>
Polygons make_polygons_with_parameters(const PolygonMesh& mesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Polygons result = make_polygons(
      mesh, choose_parameter(get_parameter(np, internal_np::vertex_point),
                             get_const_property_map(CGAL::vertex_point, mesh)));
  mark_features(mesh, get_parameter(np, internal_np::edge_is_constrained), result);
  return result;
}

} // namespace internal

/*!
\ingroup PkgQuadLayoutsFunctions

measures a quad mesh.

\tparam QuadMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param quads the mesh; faces that are not quads are counted, but not measured
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges of `quads` on feature curves, which divide patches}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value
                   type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `quads`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and a
three-dimensional point as value type} \cgalParamDefault{`boost::get(CGAL::vertex_point, quads)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the figures; those about a surface are 0

The time is linear in the size of the mesh.
*/
template <class QuadMesh, class CGAL_NP_TEMPLATE_PARAMETERS>
Quad_mesh_measures measure_quad_mesh(const QuadMesh& quads,
                                     const CGAL_NP_CLASS& np = parameters::default_values())
{
  const internal::Polygons mesh = internal::make_polygons_with_parameters(quads, np);
  Quad_mesh_measures result;
  internal::measure_connectivity(mesh, result);
  internal::measure_shape(mesh, result);
  return result;
}

/*!
\ingroup PkgQuadLayoutsFunctions

measures a quad mesh and how closely it follows a surface.

\tparam QuadMesh a model of `FaceListGraph`
\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParametersQuads a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParametersSurface a sequence of \ref bgl_namedparameters "Named Parameters"

\param quads the quad mesh
\param surface the surface that `quads` stands for
\param np_quads, np_surface optional sequences of \ref bgl_namedparameters "Named Parameters" among
those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{the edges of `quads` on feature curves, which divide patches}
    \cgalParamType{a class model of `ReadablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value
                   type}
    \cgalParamDefault{none}
    \cgalParamExtra{for `np_quads` only}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of the mesh}
    \cgalParamType{a class model of `ReadablePropertyMap` with the mesh's vertex descriptor as
                   key type and a three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throw Empty_mesh if one of the meshes has no face

The time is O(n log n) in practice.
*/
template <class QuadMesh, class TriangleMesh,
          class NamedParametersQuads = parameters::Default_named_parameters,
          class NamedParametersSurface = parameters::Default_named_parameters>
Quad_mesh_measures measure_quad_mesh(
    const QuadMesh& quads, const TriangleMesh& surface,
    const NamedParametersQuads& np_quads = parameters::default_values(),
    const NamedParametersSurface& np_surface = parameters::default_values())
{
  const internal::Polygons mesh = internal::make_polygons_with_parameters(quads, np_quads),
                           triangles = internal::make_polygons_with_parameters(surface, np_surface);
  if (mesh.number_of_faces() == 0 || triangles.number_of_faces() == 0)
    throw Empty_mesh("measure_quad_mesh: a mesh without faces has no distance to another one");
  Quad_mesh_measures result;
  internal::measure_connectivity(mesh, result);
  internal::measure_shape(mesh, result);
  internal::measure_agreement(mesh, triangles, result);
  return result;
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_MEASURE_QUAD_MESH_H
