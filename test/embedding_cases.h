// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TEST_EMBEDDING_CASES_H
#define CGAL_QUAD_LAYOUTS_TEST_EMBEDDING_CASES_H

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <string>
#include <vector>

// A T-mesh on a generated surface, and a layout to embed.
struct Embedding_case
{
  std::string name;
  CGAL::Quad_layouts::T_mesh t_mesh;
  CGAL::Quad_layouts::Quad_layout layout;

  Embedding_case(std::string name_, const generated::Mesh& mesh, double displacement)
    : name(std::move(name_))
  {
    namespace QL = CGAL::Quad_layouts;
    const QL::Cross_field field = QL::compute_cross_field(mesh);
    const auto np = QL::parameters::maximum_displacement(displacement)
                        .target_edge_length(0.04 * field.surface().diagonal());
    t_mesh = QL::trace_motorcycle_graph(field, np);
    layout = QL::extract_quad_layout(t_mesh, QL::quantize(t_mesh, np));
  }
};

// Surfaces of several genera and with several components; noisy ones have merged singularities, and
// patches that the quantization flattens.
inline const std::vector<Embedding_case>& embedding_cases()
{
  static const std::vector<Embedding_case> cases = [] {
    std::vector<Embedding_case> result;
    result.emplace_back("cube", generated::cube(6), 0);
    result.emplace_back("torus", generated::torus(24, 16), 2);
    result.emplace_back("slab", generated::slab_with_holes(2, 4), 1);
    for (const unsigned seed : {7u, 8u})
      for (const double displacement : {0., 2., 4.})
        result.emplace_back("noisy sphere " + std::to_string(seed) + ", displacement " +
                                std::to_string(displacement),
                            generated::noisy(generated::icosphere(3), 0.05, seed), displacement);
    result.emplace_back(
        "two components",
        generated::disjoint_union(generated::cube(3),
                                  generated::translated(generated::torus(20, 12), {20, 0, 0})),
        2);
    return result;
  }();
  return cases;
}

#endif // CGAL_QUAD_LAYOUTS_TEST_EMBEDDING_CASES_H
