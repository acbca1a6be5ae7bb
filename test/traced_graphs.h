// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_TEST_TRACED_GRAPHS_H
#define QUAD_LAYOUTS_TEST_TRACED_GRAPHS_H

#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <boost/test/unit_test.hpp>

#include <vector>

// Motorcycle graphs that the public function does not make.
namespace traced_graphs {

namespace QL = CGAL::Quad_layouts;
namespace internal = CGAL::Quad_layouts::internal;

// the motorcycle graph of a field, extended for a small deviation, but for traces that are hasty
inline QL::T_mesh motorcycle_graph(const QL::Cross_field& field, const std::vector<char>& is_hasty)
{
  const internal::Labels labels = internal::make_labels(field);
  internal::Field_chords chords(field, labels);
  const internal::Motorcycles::Rule rule = internal::stopping_rule(field.surface(), 0.1, 0);
  internal::Motorcycles motorcycles(chords, rule, internal::starting_vertices(labels, {}),
                                    is_hasty);
  BOOST_REQUIRE_EQUAL(motorcycles.run(internal::Monitor()), -1);
  return internal::T_mesh_assembly(field.surface_pointer(), chords, motorcycles)();
}

} // namespace traced_graphs

#endif // QUAD_LAYOUTS_TEST_TRACED_GRAPHS_H
