// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_EXTRACT_SMOOTH_QUAD_MESH_H
#define CGAL_QUAD_LAYOUTS_EXTRACT_SMOOTH_QUAD_MESH_H

#include <CGAL/Quad_layouts/extract_quad_mesh.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_Smooth_grid.h>
#include <CGAL/Quad_layouts/smooth_quad_mesh.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

namespace internal {

// the grid of a layout, smoothed on the surface
template <class TriangleMesh, class NamedParametersOut, class NamedParametersSurface>
Smooth_grid smooth_grid_on(const TriangleMesh& surface, const Integer_grid_map& map,
                           const Quad_layout& layout, const NamedParametersOut& np_out,
                           const NamedParametersSurface& np_surface)
{
  const int number_of_iterations = number_of_smoothing_iterations(np_out);
  std::vector<int> divisions = number_of_parts(map, layout, np_out);
  const Monitor monitor = monitor_from(np_out, np_surface);
  return monitor.run("smooth_quad_mesh", [&] {
    const Triangle_surface triangles = surface_with_fixed_edges(surface, np_surface);
    return best_smooth_grid(map, layout, std::move(divisions), triangles, number_of_iterations,
                            monitor);
  });
}

} // namespace internal

/*!
\ingroup PkgQuadLayoutsFunctions

extracts the quad mesh that an integer-grid map of a layout defines, and moves its vertices so that
its quads get closer to rectangles.

This is `extract_quad_mesh()` and `smooth_quad_mesh()`, and more than both: where quads are inverted
or oppose the surface all the same, because they are too large for what lies between their corners,
like a small hole, the edges of their chords are divided into more parts, up to twice as many, and
all begins again; so does the progress that a visitor is told. Each time the lines of the map are
followed more closely. The mesh with the fewest such quads is taken.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam QuadMesh a model of `MutableFaceGraph`
\tparam NamedParametersOut a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam NamedParametersSurface a sequence of \ref bgl_namedparameters "Named Parameters"

\param map a valid map of a surface onto `layout`
\param layout the layout
\param surface the surface that the map was made for
\param out the mesh that the quads are added to
\param np_out an optional sequence of the named parameters of `extract_quad_mesh()`, and
       `number_of_iterations`, `maximum_running_time` and `visitor` as for `smooth_quad_mesh()`
\param np_surface an optional sequence of \ref bgl_namedparameters "Named Parameters" for `surface`,
       those of `smooth_quad_mesh()`

\pre `map` maps onto `layout`.

\throw Error one of the exceptions of `extract_quad_mesh()` and `smooth_quad_mesh()`. Nothing has
been added to `out` then.

\return the number of quads that are inverted or oppose the surface all the same

The time is that of these two, up to four times, for at most two and a half times as many vertices.

\sa `measure_quad_mesh()`
*/
template <class TriangleMesh, class QuadMesh,
          class NamedParametersOut = parameters::Default_named_parameters,
          class NamedParametersSurface = parameters::Default_named_parameters>
std::size_t extract_smooth_quad_mesh(
    const Integer_grid_map& map, const Quad_layout& layout, const TriangleMesh& surface,
    QuadMesh& out, const NamedParametersOut& np_out = parameters::default_values(),
    const NamedParametersSurface& np_surface = parameters::default_values())
{
  const internal::Smooth_grid grid = internal::smooth_grid_on(surface, map, layout, np_out,
                                                              np_surface);
  internal::build_mesh(grid.divided, grid.points, out, np_out);
  return grid.number_of_bad_quads;
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_EXTRACT_SMOOTH_QUAD_MESH_H
