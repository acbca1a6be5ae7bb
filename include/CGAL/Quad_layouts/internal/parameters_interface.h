// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// The named parameters of this package. Like CGAL's own list this file has no guard: `parameters.h`
// reads it once for the tags, once for the members and once for the free functions.

// of the cross field
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(cross_field_method)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(curvature_alignment)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(diffusion_time)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(face_direction_map)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(face_constraint_map)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(layout_route)

// of the parametrization
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(target_edge_length_map)

// of tracing, quantization and everything that measures in target edge lengths
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(maximum_deviation)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(maximum_displacement)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(target_edge_length)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(minimum_valence)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(maximum_valence)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(relative_gap)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(maximum_search_time)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(concurrent_searches)

// of single quantizations
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(arc_weight_map)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(face_weight_map)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(forbidden_merges)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(forced_connections)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(vertex_symmetry)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(lock_alignments)

// of the quad mesh
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(vertex_is_layout_node_map)
CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(edge_is_layout_edge_map)
