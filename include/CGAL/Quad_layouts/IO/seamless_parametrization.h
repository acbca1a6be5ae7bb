// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_IO_SEAMLESS_PARAMETRIZATION_H
#define CGAL_QUAD_LAYOUTS_IO_SEAMLESS_PARAMETRIZATION_H

#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/IO/read_texture.h>
#include <CGAL/Quad_layouts/make_seamless_parametrization.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <istream>
#include <limits>
#include <ostream>

namespace CGAL {
namespace Quad_layouts {
namespace IO {

/*!
\ingroup PkgQuadLayoutsIO

reads a seamless parametrization from the texture coordinates in an OBJ file, as
`make_seamless_parametrization()` takes them: a triangle `f v/vt v/vt v/vt` has the chart in which
its corners have these coordinates `vt`.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param in the stream
\param tm the mesh, whose vertices and faces have the order of the file, as if read from it
\param np an optional sequence of the named parameters of `make_seamless_parametrization()`

\throw Invalid_file if the text is no OBJ file of this mesh with texture coordinates for all
       corners.
\throw Error one of the exceptions of `make_seamless_parametrization()`.

The time is that of `make_seamless_parametrization()`.
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Seamless_parametrization read_seamless_parametrization(
    std::istream& in, const TriangleMesh& tm,
    const NamedParameters& np = parameters::default_values())
{
  const internal::Triangle_surface whole = internal::surface_with_fixed_edges(tm, np);
  return internal::make_seamless_parametrization(whole, internal::read_texture(in, whole), np);
}

/*!
\ingroup PkgQuadLayoutsIO

writes a seamless parametrization as an OBJ file with texture coordinates for each corner, in target
edge lengths. It contains the surface of the parametrization: where faces of the user's mesh are
divided, their parts.

\returns whether writing succeeded
*/
inline bool write_seamless_parametrization(std::ostream& out, const Seamless_parametrization& map)
{
  const auto& surface = map.surface();
  out.precision((std::numeric_limits<double>::max_digits10));
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    out << "v " << surface.point(v).transpose() << '\n';
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    out << "vt " << map.point(h).transpose() << '\n';
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    out << (h % 3 == 0 ? "f " : " ") << surface.source(h) + 1 << '/' << h + 1
        << (h % 3 == 2 ? "\n" : "");
  return out.good();
}

} // namespace IO
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_IO_SEAMLESS_PARAMETRIZATION_H
