// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_IO_WRITE_QUAD_MESH_H
#define CGAL_QUAD_LAYOUTS_IO_WRITE_QUAD_MESH_H

#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <limits>
#include <map>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

namespace internal {

// writes the points, `prefix` before each, and numbers the vertices from `first` on
template <class Mesh, class VertexPointMap, class VertexIndexMap>
void write_points(std::ostream& out, const Mesh& mesh, const VertexPointMap points,
                  const VertexIndexMap index, const char* prefix, int first)
{
  for (const auto v : vertices(mesh)) {
    const auto& p = get(points, v);
    out << prefix << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    put(index, v, first++);
  }
}

// writes the vertices of a face, a blank before each
template <class Mesh, class VertexIndexMap>
void write_corners(std::ostream& out, typename boost::graph_traits<Mesh>::face_descriptor f,
                   const Mesh& mesh, const VertexIndexMap index)
{
  for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
    out << ' ' << get(index, v);
  out << '\n';
}

// writes an array of VTK's XML format, a value per line
template <class Range, class Value>
void write_array(std::ostream& out, const char* name, const Range& range, const Value& value)
{
  out << "<DataArray type=\"Int32\" Name=\"" << name << "\" format=\"ascii\">\n";
  for (const auto x : range)
    out << value(x) << '\n';
  out << "</DataArray>\n";
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgQuadLayoutsIO

writes a quad mesh in OBJ format: a group `patch_<i>` for each patch.

\tparam QuadMesh a model of `FaceListGraph`
\tparam FacePatchMap a model of `ReadablePropertyMap` from faces to `int`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param out the stream
\param quads the mesh
\param patches the patch of each face, as the map `face_patch_map` of `extract_quad_mesh()`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`

\returns whether writing succeeded
*/
template <class QuadMesh, class FacePatchMap,
          class NamedParameters = parameters::Default_named_parameters>
bool write_quad_mesh_obj(std::ostream& out, const QuadMesh& quads, const FacePatchMap patches,
                         const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Face = typename boost::graph_traits<QuadMesh>::face_descriptor;
  const auto points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, quads));
  const auto index = get(CGAL::dynamic_vertex_property_t<int>(), quads);
  out.precision((std::numeric_limits<double>::max_digits10));
  internal::write_points(out, quads, points, index, "v ", 1);
  std::map<int, std::vector<Face>> faces_of;
  for (const Face f : faces(quads))
    faces_of[get(patches, f)].push_back(f);
  for (const auto& patch : faces_of) {
    out << "g patch_" << patch.first << '\n';
    for (const Face f : patch.second) {
      out << 'f';
      internal::write_corners(out, f, quads, index);
    }
  }
  return out.good();
}

/*!
\ingroup PkgQuadLayoutsIO

writes a quad mesh in the XML format of VTK, with the array `patch` on cells and the arrays
`valence` and `irregular` (0 or 1) on points.

\tparam QuadMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam FacePatchMap a model of `ReadablePropertyMap` from faces to `int`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param out the stream
\param quads the mesh
\param patches the patch of each face, as the map `face_patch_map` of `extract_quad_mesh()`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`

\returns whether writing succeeded
*/
template <class QuadMesh, class FacePatchMap,
          class NamedParameters = parameters::Default_named_parameters>
bool write_quad_mesh_vtp(std::ostream& out, const QuadMesh& quads, const FacePatchMap patches,
                         const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Vertex = typename boost::graph_traits<QuadMesh>::vertex_descriptor;
  using Face = typename boost::graph_traits<QuadMesh>::face_descriptor;
  const auto points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, quads));
  const auto index = get(CGAL::dynamic_vertex_property_t<int>(), quads);
  const auto valence = [&](const Vertex v) { return int(degree(v, quads)); };
  const auto is_irregular = [&](const Vertex v) {
    const bool border = bool(is_border(v, quads));
    return valence(v) == 0 || valence(v) == (border ? 3 : 4) ? 0 : 1;
  };

  out.precision((std::numeric_limits<double>::max_digits10));
  out << "<?xml version=\"1.0\"?>\n"
      << "<VTKFile type=\"PolyData\" version=\"0.1\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << vertices(quads).size() << "\" NumberOfPolys=\""
      << faces(quads).size() << "\">\n"
      << "<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  internal::write_points(out, quads, points, index, "", 0);
  out << "</DataArray>\n</Points>\n<PointData>\n";
  internal::write_array(out, "valence", vertices(quads), valence);
  internal::write_array(out, "irregular", vertices(quads), is_irregular);
  out << "</PointData>\n<CellData>\n";
  internal::write_array(out, "patch", faces(quads), [&](const Face f) { return get(patches, f); });
  out << "</CellData>\n<Polys>\n<DataArray type=\"Int32\" Name=\"connectivity\" "
         "format=\"ascii\">\n";
  for (const Face f : faces(quads))
    internal::write_corners(out, f, quads, index);
  out << "</DataArray>\n";
  int end = 0;
  internal::write_array(out, "offsets", faces(quads),
                        [&](const Face f) { return end += int(degree(f, quads)); });
  out << "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return out.good();
}

} // namespace IO
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_IO_WRITE_QUAD_MESH_H
