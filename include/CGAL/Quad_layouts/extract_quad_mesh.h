// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_EXTRACT_QUAD_MESH_H
#define CGAL_QUAD_LAYOUTS_EXTRACT_QUAD_MESH_H

#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/layout/chord_divisions.h>
#include <CGAL/Quad_layouts/internal/layout/divided_layout.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_Layout_tracer.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_build_mesh.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_curve_divisions.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_grid_points.h>
#include <CGAL/Quad_layouts/internal/require_parameter.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

inline void check_map(const Integer_grid_map& map, const Quad_layout& layout)
{
  CGAL_precondition(int(map.chord_length.size()) == layout.number_of_chords);
  if (map.inverted > 0 || map.wrong_winding > 0)
    throw Stage_failure("quad mesh: the map has " + std::to_string(map.inverted) +
                        " inverted triangles and " + std::to_string(map.wrong_winding) +
                        " vertices of a wrong angle sum");
  CGAL_USE(layout);
}

// returns the edges of the layout as polylines
inline std::vector<std::vector<Point>> traced_edges(const Integer_grid_map& map,
                                                    const Quad_layout& layout)
{
  const std::vector<int> undivided(layout.number_of_chords, 1);
  return Layout_tracer(map, layout, undivided).curves();
}

// returns whether the layout has edges on fixed curves, like the border
inline bool has_fixed_edges(const Quad_layout& layout)
{
  for (int e = 0; e < layout.number_of_edges(); ++e)
    if (layout.is_fixed(e))
      return true;
  return false;
}

// returns the number of parts of the edges of each chord, which are their lengths in the map unless
// there is a target; checks the map and the target
template <class NamedParameters>
std::vector<int> number_of_parts(const Integer_grid_map& map, const Quad_layout& layout,
                                 const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  constexpr bool has_target =
      !parameters::is_default_parameter<NamedParameters, internal_np::target_edge_length_t>::value;
  const double target = choose_parameter(get_parameter(np, internal_np::target_edge_length), 0.);
  if (has_target)
    require_positive("target_edge_length", target);
  check_map(map, layout);
  std::vector<int> result = has_target ? chord_divisions(layout, target) : map.chord_length;
  if (has_fixed_edges(layout)) {
    raise_for_fixed_curves(layout, traced_edges(map, layout), curve_tolerance(map.surface()),
                           result);
    raise_between_corners(layout, result);
  }
  raise_to_simple(layout, result);
  return result;
}

} // namespace internal

/*!
\ingroup PkgQuadLayoutsFunctions

extracts the quad mesh that an integer-grid map of a layout defines.

Each edge of the layout is divided into equal parts, each face into a grid of quads. Grid points are
found by following straight lines through the triangles of the map (Ebke, Bommes, Campen, Kobbelt
2013), from the anchors on and with exact predicates. Since the connectivity is known from the
layout, nothing needs to be repaired; wherever two lines must meet, they are checked to meet
exactly.

All edges of a chord have the same number of parts: their length in the map, or what comes closest
to `target_edge_length`. It is raised where the mesh would have loops or several edges between two
vertices, where fixed curves bend so much that fewer edges could not follow them, within a
thousandth of the diagonal of the surface's bounding box, and where an edge would join two corners
of fixed curves, which stay where they are, and might leave the quads beside it no room.

\tparam QuadMesh a model of `MutableFaceGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param map a valid map of a surface onto `layout`
\param layout the layout
\param out the mesh that the quads are added to
\param np_out an optional sequence of \ref bgl_namedparameters "Named Parameters" among those listed
below

\cgalNamedParamsBegin
  \cgalParamNBegin{target_edge_length}
    \cgalParamDescription{the length that edges of the quad mesh should have}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{that of the unit edges of the map}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `out`}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and a
                   three-dimensional point as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, out)`}
  \cgalParamNEnd
  \cgalParamNBegin{face_patch_map}
    \cgalParamDescription{a property map filled with the number of the patch of the layout that each
                          quad belongs to}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%face_descriptor` as key type and `int` as value
                   type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_layout_node_map}
    \cgalParamDescription{a property map that tells which vertices are corners of patches: where
                          separatrices begin, end or cross}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%vertex_descriptor` as key type and `bool` as
                   value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{a property map that tells which edges lie on fixed curves: features and
                          the border}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value
                   type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_layout_edge_map}
    \cgalParamDescription{a property map that tells which edges lie on separatrices}
    \cgalParamType{a class model of `WritablePropertyMap` with
                   `boost::graph_traits<QuadMesh>::%edge_descriptor` as key type and `bool` as value
                   type}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

The time is linear in the number of quads and of triangles that their lines pass.

\pre `map` maps onto `layout`.

\throw Invalid_parameter if `target_edge_length` is not positive and finite.
\throw Stage_failure if the map is not valid or does not contain the layout, if a vertex has valence
1, or if there would be too many quads. Nothing has been added to `out` then.

\sa `embed_quad_layout()`
\sa `smooth_quad_mesh()`
*/
template <class QuadMesh, class CGAL_NP_TEMPLATE_PARAMETERS>
void extract_quad_mesh(const Integer_grid_map& map, const Quad_layout& layout, QuadMesh& out,
                       const CGAL_NP_CLASS& np_out = parameters::default_values())
{
  const std::vector<int> divisions = internal::number_of_parts(map, layout, np_out);
  const internal::Divided_layout divided(layout, divisions);
  const internal::Layout_tracer tracer(map, layout, divisions);
  internal::build_mesh(divided, internal::grid_points(tracer, divided), out, np_out);
}

/*!
\ingroup PkgQuadLayoutsFunctions

returns the edges of a layout as curves on the surface: per edge of the layout a polyline from the
source of its first halfedge to the target, with a vertex wherever the edge crosses one of the
surface.

\throw Stage_failure if the map is not valid or does not contain the layout.
*/
inline std::vector<std::vector<Quad_layout::Point>> layout_curves(const Integer_grid_map& map,
                                                                  const Quad_layout& layout)
{
  internal::check_map(map, layout);
  return internal::traced_edges(map, layout);
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_EXTRACT_QUAD_MESH_H
