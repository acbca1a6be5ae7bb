// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_TEST_NOISY_PROGRAM_H
#define QUAD_LAYOUTS_TEST_NOISY_PROGRAM_H

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/internal/quantization/Loop_search.h>
#include <CGAL/Quad_layouts/internal/quantization/Reduced_program.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <vector>

// the program of a noisy sphere, in which many pairs can merge
struct Noisy_program
{
  CGAL::Quad_layouts::T_mesh t_mesh = CGAL::Quad_layouts::trace_motorcycle_graph(
      CGAL::Quad_layouts::compute_cross_field(generated::noisy(generated::icosphere(3), 0.08, 3)));
  CGAL::Quad_layouts::internal::Dual_graph graph{t_mesh};
  CGAL::Quad_layouts::internal::Reduced_program program = CGAL::Quad_layouts::internal::reduce(
      t_mesh,
      CGAL::Quad_layouts::internal::build_quantization_program(
          t_mesh, {0.27, 0.04 * t_mesh.surface().diagonal(), -4, 1}),
      graph);

  // covers everything
  std::vector<CGAL::Quad_layouts::internal::Loop> loops() const
  {
    CGAL::Quad_layouts::internal::Loop_search search(graph);
    std::vector<CGAL::Quad_layouts::internal::Loop> result;
    for (int v = 0; v < program.number_of_variables(); ++v)
      result.push_back(search.cheapest_loop({v}, program.cost));
    return result;
  }

  std::vector<int> sum_of(const std::vector<CGAL::Quad_layouts::internal::Loop>& loops) const
  {
    std::vector<int> result(program.number_of_variables(), 0);
    for (const auto& loop : loops)
      for (int v : loop)
        ++result[v];
    return result;
  }
};

#endif // QUAD_LAYOUTS_TEST_NOISY_PROGRAM_H
