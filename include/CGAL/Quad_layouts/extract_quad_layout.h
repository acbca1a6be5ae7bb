// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_EXTRACT_QUAD_LAYOUT_H
#define CGAL_QUAD_LAYOUTS_EXTRACT_QUAD_LAYOUT_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/Quantization.h>
#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/layout/assemble_layout.h>
#include <CGAL/Quad_layouts/internal/layout/base_complex.h>
#include <CGAL/Quad_layouts/internal/layout/chord_lengths.h>
#include <CGAL/Quad_layouts/internal/layout/layout_points.h>
#include <CGAL/Quad_layouts/internal/layout/quotient.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsFunctions

extracts the conforming quad layout that a quantization makes of a T-mesh (\cgalCite{lck-sqlrs-21},
Section 5).

A patch of positive width and height becomes a grid of unit squares. A patch of zero width
identifies its two long sides at equal heights; arcs of length 0 become points. The quotient is a
complex of squares without T-joints. Singularities that fall onto one point are merged to one layout
vertex, whose index is the sum of theirs.

The quotient need not be the surface: a loop of length 0 around a handle, or a ring of patches of
zero width, changes the topology. It is checked that each component keeps its Euler characteristic,
that no vertex is pinched, and that each vertex has the valence that its index asks for.

The complexity is linear in the number of squares, up to sorting.

\param t_mesh the T-mesh
\param quantization its quantization

\return the layout. Its vertices lie at nodes of the T-mesh where these have become vertices, else
at points interpolated between them: a layout is combinatorial, the points serve to look at it.

\pre `quantization` has a length for each arc of `t_mesh`.

\throw Stage_failure if lengths are negative or differ on opposite sides of a patch, or the quotient
is not the surface.

\sa `quantize()`
\sa `embed_quad_layout()`
*/
inline Quad_layout extract_quad_layout(const T_mesh& t_mesh, const Quantization& quantization)
{
  CGAL_precondition(int(quantization.arc_length.size()) == t_mesh.number_of_edges());
  using namespace internal;
  const Arc_grid grid(t_mesh, quantization.arc_length);
  const Fibres fibres(grid);
  const Quotient_report report = examine_quotient(t_mesh, quantization.arc_length);
  if (!report.valid)
    throw Stage_failure("layout: " + report.reason);

  Quad_layout layout;
  const Glued_squares squares(grid);
  const std::vector<int> vertices = vertex_of_fibres(fibres, squares);
  relate_to_t_mesh(squares, assemble_halfedges(squares, layout), layout);
  place_clusters(fibres, vertices, report.clusters, layout);
  place_vertices(fibres, vertices, layout);
  collect_chords(layout);
  mark_separatrices(layout);
  collect_patches(layout);
  layout.chord_length = fit_chord_lengths(t_mesh, layout);
  return layout;
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_EXTRACT_QUAD_LAYOUT_H
