// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "generated_fields.h"
#include "generated_meshes.h"
#include "invariants.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/internal/embedding/Layout_curves.h>
#include <CGAL/Quad_layouts/internal/embedding/Overlay_reduction.h>
#include <CGAL/Quad_layouts/internal/embedding/check_embedded_layout.h>
#include <CGAL/Quad_layouts/measure_quad_layout.h>
#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/quad_remesh.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

// Surfaces with borders, on their way through all stages.

BOOST_AUTO_TEST_SUITE(test_borders)

namespace QL = CGAL::Quad_layouts;
namespace parameters = CGAL::Quad_layouts::parameters;
using generated::Mesh;

namespace {

// the sum of the indices of layout vertices, and that of the T-mesh
void check_layout(const QL::T_mesh& t, const QL::Quad_layout& layout)
{
  invariants::check_halfedge_complex(layout);
  BOOST_TEST(layout.euler_characteristic() == t.euler_characteristic());
  BOOST_TEST(invariants::number_of_borders(layout) == invariants::number_of_borders(t));
  int index_sum = 0;
  for (int v = 0; v < layout.number_of_vertices(); ++v) {
    index_sum += layout.index(v);
    BOOST_TEST((!layout.is_on_border(v) || layout.valence(v) >= 2));
  }
  BOOST_TEST(index_sum == 4 * t.euler_characteristic());
  for (int a = 0; a < t.number_of_edges(); ++a)
    for (int h : layout.arc_halfedges[a])
      BOOST_TEST((!t.is_border_edge(a) || layout.is_border_edge(QL::Quad_layout::edge(h))));
  BOOST_TEST(QL::measure_quad_layout(layout).t_junctions == 0);
}

struct Result
{
  QL::T_mesh t_mesh;
  QL::Quantization quantization;
  QL::Quad_layout layout;
};

// The layout is drawn on the surface, and its border on the border.
void check_curves(const Result& r)
{
  QL::Default_visitor visitor;
  const QL::internal::Monitor monitor = QL::internal::monitor_from(
      parameters::visitor(std::ref(visitor)));
  QL::internal::Embedded_layout embedded =
      QL::internal::Layout_curves(r.t_mesh, r.layout, monitor).result();
  QL::internal::reduce(embedded, r.t_mesh.surface().number_of_vertices(), monitor);
  QL::internal::check_embedded_layout(embedded, r.layout); // throws
}

template <class NamedParameters>
Result layout_of(const QL::Cross_field& field, const NamedParameters& np)
{
  Result r;
  r.t_mesh = QL::trace_motorcycle_graph(field, np);
  invariants::check_t_mesh(r.t_mesh);
  r.quantization = QL::quantize(r.t_mesh, np);
  BOOST_TEST_REQUIRE(r.quantization.status != QL::Quantization::INFEASIBLE);
  r.layout = QL::extract_quad_layout(r.t_mesh, r.quantization);
  check_layout(r.t_mesh, r.layout);
  check_curves(r);
  return r;
}

double distance_to_border(const Mesh& mesh, const generated::Point& p)
{
  double least = (std::numeric_limits<double>::max)();
  for (const auto h : halfedges(mesh))
    if (mesh.is_border(h))
      least = (std::min)(least, CGAL::squared_distance(
                                    p, generated::Kernel::Segment_3(mesh.point(source(h, mesh)),
                                                                    mesh.point(target(h, mesh)))));
  return std::sqrt(least);
}

// A quad mesh has the topology of the surface, good quads, and its border on that of the surface.
void check_remeshing(const Mesh& mesh)
{
  Mesh quads;
  QL::quad_remesh(mesh, quads, parameters::target_edge_length(0.1));
  const QL::Quad_mesh_measures in = QL::measure_quad_mesh(mesh), out = QL::measure_quad_mesh(quads);
  BOOST_TEST(out.euler_characteristic == in.euler_characteristic);
  BOOST_TEST(out.components == in.components);
  BOOST_TEST(out.t_junctions == 0);
  BOOST_TEST(out.msj_minimum > 0.3);
  for (const auto h : halfedges(quads))
    if (quads.is_border(h))
      BOOST_TEST(distance_to_border(mesh, quads.point(target(h, quads))) < 1e-9);
}

Result layout_of(const Mesh& mesh)
{
  return layout_of(QL::compute_cross_field(mesh), parameters::default_values());
}

} // namespace

BOOST_AUTO_TEST_CASE(layout_of_a_square)
{
  const Result r = layout_of(generated::plate({{0, 0}}, 4));
  BOOST_TEST(r.quantization.objective == 2, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(r.layout.number_of_faces() == 1);
  BOOST_TEST(r.layout.number_of_irregular_vertices() == 4);
}

BOOST_AUTO_TEST_CASE(layout_of_a_plate_with_a_hole)
{
  const Result r = layout_of(generated::plate_with_holes(3, 3, {{1, 1}}, 4));
  BOOST_TEST(r.layout.number_of_patches == 8);
  BOOST_TEST(r.quantization.violated == 0);
}

BOOST_AUTO_TEST_CASE(layout_of_an_annulus)
{
  const Result r = layout_of(generated::annulus(0.5, 1, 6, 40));
  BOOST_TEST(r.layout.number_of_irregular_vertices() == 0);
  BOOST_TEST(r.layout.number_of_patches == 1);
}

BOOST_AUTO_TEST_CASE(layout_of_a_disc)
{
  const Result r = layout_of(generated::disc(12));
  BOOST_TEST(r.layout.number_of_irregular_vertices() == 4);
  BOOST_TEST(r.layout.number_of_patches == 5);
}

// Lines along the border wind outwards and meet the step: it can only have length 0 (Figure 5 of
// Lyon, Campen and Kobbelt 2021).
BOOST_AUTO_TEST_CASE(a_step_that_cannot_be_kept)
{
  const Mesh mesh = generated::annulus_with_step(0.5, 0.4, 10, 60);
  const QL::Cross_field field = QL::compute_cross_field(mesh);
  BOOST_TEST(field.number_of_singularities() == 2);
  const Result r = layout_of(field, parameters::target_edge_length(0.02));
  BOOST_TEST(r.quantization.violated > 0);
  BOOST_TEST(r.layout.number_of_irregular_vertices() == 0);
  BOOST_TEST(r.layout.number_of_patches == 1);
}

BOOST_AUTO_TEST_CASE(quad_meshes_with_borders)
{
  check_remeshing(generated::plate({{0, 0}}, 4));
  check_remeshing(generated::plate_with_holes(5, 3, {{1, 1}, {3, 1}}, 4));
  check_remeshing(generated::disc(12));
  check_remeshing(generated::annulus(0.5, 1, 6, 40));
  check_remeshing(generated::annulus_with_step(0.5, 0.4, 10, 60));
  check_remeshing(
      generated::noisy(generated::plate_with_holes(4, 4, {{2, 2}, {0, 0}}, 4), 0.03, 2));
  check_remeshing(generated::mesh_of(
      {generated::Point(0, 0, 0), generated::Point(3, 0, 0), generated::Point(0, 1, 1)},
      {{0, 1, 2}}));
}

BOOST_AUTO_TEST_CASE(layouts_of_random_fields)
{
  const std::vector<Mesh> meshes = generated::meshes_with_borders(2);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    const double alpha = 1 + random() % 60, r = random() % 5;
    BOOST_TEST_CONTEXT("seed " << seed << ", deviation " << alpha << ", displacement " << r)
    layout_of(generated::random_field(meshes[seed % meshes.size()], seed),
              parameters::maximum_deviation(alpha).maximum_displacement(r).maximum_running_time(1));
  }
}

BOOST_AUTO_TEST_SUITE_END()
