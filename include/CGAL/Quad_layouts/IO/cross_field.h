// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_IO_CROSS_FIELD_H
#define CGAL_QUAD_LAYOUTS_IO_CROSS_FIELD_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/IO/read_field.h>
#include <CGAL/Quad_layouts/internal/IO/write_field.h>
#include <CGAL/Quad_layouts/internal/surface/make_triangle_surface.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <istream>
#include <limits>
#include <ostream>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsIO

names the formats in which cross fields are exchanged.
*/
enum Cross_field_format {
  /// `.rosy`: the number of faces, the degree 4, and a direction for each face (Palacios and Zhang,
  /// <em>Interactive visualization of rotational symmetry fields on surfaces</em>, 2011)
  ROSY,
  /// `.rawfield` of the library Directional: the degree 4, the number of faces, and four directions
  /// for each face
  RAWFIELD,
  /// `.ffield` as VCGLib writes it: two sizes and two directions for each face
  FFIELD,
  /// `.ffield` of the test data of Myles, Pietroni and Zorin, <em>Robust field-aligned global
  /// parametrization</em>, 2014: frames as in the other dialect, angles of the cross field,
  /// matchings and sharp edges
  FFIELD_MPZ14
};

namespace internal {

inline Field_in_file read_field(std::istream& in, Cross_field_format format,
                                const Triangle_surface& surface)
{
  switch (format) {
    case ROSY: return read_rosy(in, surface);
    case RAWFIELD: return read_raw_field(in, surface);
    default: return read_ffield(in, surface);
  }
}

// puts what the file says of sharp edges into `is_sharp`
template <class TriangleMesh, class EdgeMap>
void put_sharp_edges(const Field_in_file& field, const TriangleMesh& tm, EdgeMap is_sharp)
{
  for (const auto e : edges(tm))
    put(is_sharp, e, false);
  std::size_t h = 0; // the halfedges of each face are numbered in order
  for (const auto f : faces(tm))
    for (const auto side : CGAL::halfedges_around_face(halfedge(f, tm), tm)) {
      if (h < field.sharp.size() && field.sharp[h])
        put(is_sharp, edge(side, tm), true);
      ++h;
    }
}

// does nothing, if there is no map
template <class TriangleMesh>
void put_sharp_edges(const Field_in_file&, const TriangleMesh&, const internal_np::Param_not_found&)
{
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgQuadLayoutsIO

reads a cross field on a triangle mesh, as directions that the named parameter `face_direction_map`
of `compute_cross_field()` takes. Both dialects of `.ffield` are told apart by what the file
contains: if it has angles of a cross field, they count, and else the first direction of each frame.
Matchings are not taken over.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam FaceDirectionMap a model of `WritablePropertyMap` with the face descriptor of `TriangleMesh`
        as key type and a `Vector_3` of any %CGAL kernel as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param in the stream
\param format the format of the file
\param tm the mesh, whose vertices and faces have the order of the file
\param directions gets a direction for each face; it is not changed if the file cannot be read
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
        below

\cgalNamedParamsBegin
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{gets the sharp edges, if the file knows any}
    \cgalParamType{a class model of `WritablePropertyMap` with the edge descriptor of `TriangleMesh`
                   as key type and `bool` as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `tm`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of
                   `TriangleMesh` as key type and `%Point_3` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throw Invalid_file if the text is not of this format, or not for this mesh.
\throw Invalid_mesh if the mesh cannot be used.

The time is linear in the size of the file.
*/
template <class TriangleMesh, class FaceDirectionMap,
          class NamedParameters = parameters::Default_named_parameters>
void read_cross_field(std::istream& in, Cross_field_format format, const TriangleMesh& tm,
                      FaceDirectionMap directions,
                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Vector = typename boost::property_traits<FaceDirectionMap>::value_type;

  const auto points = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, tm));
  const internal::Field_in_file field = internal::read_field(
      in, format, internal::make_triangle_surface(tm, points));
  auto direction = field.directions.begin();
  for (const auto f : faces(tm)) {
    put(directions, f, Vector(direction->x(), direction->y(), direction->z()));
    ++direction;
  }
  internal::put_sharp_edges(field, tm, get_parameter(np, internal_np::edge_is_constrained));
}

/*!
\ingroup PkgQuadLayoutsIO

writes a cross field. Vertices and faces are numbered as in the user's mesh; of a face that is
divided on the surface of the field, the part that begins its first halfedge is written, so
singularities inside are not. In the format `FFIELD_MPZ14` fixed edges, but for those on the border,
are sharp.

\returns whether writing succeeded
*/
inline bool write_cross_field(std::ostream& out, const Cross_field& field,
                              Cross_field_format format)
{
  using namespace internal;
  out.precision((std::numeric_limits<double>::max_digits10));
  switch (format) {
    case ROSY:
      out << field.surface().original().number_of_faces() << "\n4\n";
      write_directions(out, field, 1);
      break;
    case RAWFIELD:
      out << "4 " << field.surface().original().number_of_faces() << '\n';
      write_directions(out, field, 4);
      break;
    case FFIELD:
      out << "# cross field\ntarget frame\n";
      write_frames(out, field);
      break;
    case FFIELD_MPZ14:
      out << "# version 2\ntarget_frame\n";
      write_frames(out, field);
      out << "crossfield_angles\n";
      write_angles(out, field);
      out << "fixed\n0\nfixed_vertices\n0\nMI_matchings_and_sharp\n";
      write_matchings(out, field);
      break;
  }
  return out.good();
}

} // namespace IO
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_IO_CROSS_FIELD_H
