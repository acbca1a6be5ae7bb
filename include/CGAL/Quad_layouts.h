// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_H
#define CGAL_QUAD_LAYOUTS_H

/// \file Quad_layouts.h
/// Includes all functions and classes of the package.

#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>
#include <CGAL/Quad_layouts/Mixed_integer_program_traits_adaptor.h>
#include <CGAL/Quad_layouts/arc_weights.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/compute_t_mesh.h>
#include <CGAL/Quad_layouts/embed_quad_layout.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_mesh.h>
#include <CGAL/Quad_layouts/extract_smooth_quad_mesh.h>
#include <CGAL/Quad_layouts/graph_traits_Halfedge_complex.h>
#include <CGAL/Quad_layouts/measure_quad_layout.h>
#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/parametrize_seamlessly.h>
#include <CGAL/Quad_layouts/quad_remesh.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/smooth_quad_mesh.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>
#include <CGAL/Quad_layouts/try_layout_routes.h>
#include <CGAL/Quad_layouts/visitor.h>

#endif // CGAL_QUAD_LAYOUTS_H
