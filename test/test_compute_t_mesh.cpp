// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "generated_fields.h"
#include "generated_meshes.h"
#include "invariants.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/compute_t_mesh.h>
#include <CGAL/Quad_layouts/embed_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_mesh.h>
#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/quantize.h>

#include <boost/test/unit_test.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_compute_t_mesh)

namespace QL = CGAL::Quad_layouts;
namespace parameters = CGAL::Quad_layouts::parameters;

using Mesh = generated::Mesh;

namespace {

// writes down which stages ran, and why the route was changed
struct Diary : QL::Default_visitor
{
  std::string stages, reason;

  void before_stage(const char* name) { stages += std::string(name) + ' '; }
  void changed_route(const char* why) { reason = why; }
};

} // namespace

BOOST_AUTO_TEST_CASE(both_routes)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::icosphere(3));
  Diary diary;
  const auto np = parameters::visitor(std::ref(diary));
  BOOST_TEST(QL::compute_t_mesh(field, np.layout_route(QL::FIELD)).route == QL::FIELD);
  BOOST_TEST(diary.stages == "trace_motorcycle_graph ");
  diary.stages.clear();
  const QL::T_mesh t = QL::compute_t_mesh(field, np.layout_route(QL::PARAMETRIZATION));
  BOOST_TEST(t.route == QL::PARAMETRIZATION);
  BOOST_TEST(diary.stages == "parametrize_seamlessly trace_motorcycle_graph ");
  BOOST_TEST(diary.reason == "");
  invariants::check_t_mesh(t);
  invariants::check_opposite_sides(t);
}

// A map that needs other indices is made only for those who ask for a parametrization.
BOOST_AUTO_TEST_CASE(fields_without_map)
{
  const QL::Cross_field field = generated::field_without_map();
  Diary diary;
  const auto np = parameters::visitor(std::ref(diary));
  const QL::T_mesh t = QL::compute_t_mesh(field, np.layout_route(QL::PARAMETRIZATION));
  BOOST_TEST(t.route == QL::PARAMETRIZATION);
  BOOST_TEST(diary.reason == "");
  invariants::check_t_mesh(t);
  invariants::check_opposite_sides(t);
  BOOST_TEST(QL::compute_t_mesh(field, np).route == QL::FIELD);
  BOOST_TEST(diary.reason != "");
}

BOOST_AUTO_TEST_CASE(the_route_is_automatic)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::icosphere(2));
  BOOST_TEST(QL::compute_t_mesh(field).route == QL::PARAMETRIZATION);
  const auto route_for = [](int nu, int nv) {
    const Mesh mesh = generated::torus(nu, nv);
    const auto surface = std::make_shared<const QL::Cross_field::Surface>(
        QL::internal::make_triangle_surface(mesh, mesh.points()));
    return QL::internal::automatic_route(QL::Cross_field(surface, {}, {}, {}));
  };
  BOOST_TEST(route_for(500, 100) == QL::PARAMETRIZATION);
  BOOST_TEST(route_for(500, 101) == QL::FIELD);
  const QL::Cross_field noise = generated::random_field(generated::icosphere(4), 1);
  BOOST_TEST(noise.number_of_singularities() > 300);
  BOOST_TEST((QL::internal::automatic_route(noise) == QL::FIELD));
}

// Around a vertex of index 3 there would be an angle of 90 degrees, at which one line starts;
// around one of index 4 none.
BOOST_AUTO_TEST_CASE(fields_without_a_parametrization_fall_back)
{
  const auto has_steep_vertex = [](const QL::Cross_field& field) {
    for (int v = 0; v < field.surface().number_of_vertices(); ++v)
      if (field.index(v) >= 3)
        return true;
    return false;
  };
  unsigned seed = 1;
  while (!has_steep_vertex(generated::random_field(generated::tetrahedron(), seed)))
    ++seed;
  const QL::Cross_field field = generated::random_field(generated::tetrahedron(), seed);
  Diary diary;
  const QL::T_mesh t = QL::compute_t_mesh(
      field, parameters::visitor(std::ref(diary)).layout_route(QL::PARAMETRIZATION));
  BOOST_TEST(t.route == QL::FIELD);
  BOOST_TEST(diary.reason.find("trace_motorcycle_graph: ") == 0u, diary.reason);
  invariants::check_t_mesh(t);
}

BOOST_AUTO_TEST_CASE(too_little_time_for_a_parametrization)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::icosphere(4));
  Diary diary;
  const auto np = parameters::visitor(std::ref(diary))
                      .layout_route(QL::PARAMETRIZATION)
                      .maximum_running_time(0.1);
  try {
    BOOST_TEST(QL::compute_t_mesh(field, np).route == QL::FIELD);
  } catch (const QL::Time_limit_exceeded&) {
  }
  BOOST_TEST(diary.reason.find("not done within the time limit") != std::string::npos,
             diary.reason);
}

// what comes afterwards needs to know nothing about routes
BOOST_AUTO_TEST_CASE(quad_meshes_by_a_parametrization)
{
  for (const Mesh& mesh : {generated::cube(4), generated::icosphere(3),
                           generated::slab_with_holes(1, 3), generated::disc(6)}) {
    const auto np = parameters::target_edge_length(0.2).layout_route(QL::PARAMETRIZATION);
    const QL::T_mesh t = QL::compute_t_mesh(QL::compute_cross_field(mesh), np);
    BOOST_TEST(t.route == QL::PARAMETRIZATION);
    const QL::Quantization q = QL::quantize(t, np);
    BOOST_TEST_REQUIRE(q.status == QL::Quantization::OPTIMAL);
    const QL::Quad_layout layout = QL::extract_quad_layout(t, q);
    const QL::Integer_grid_map map = QL::embed_quad_layout(t, layout, np);
    BOOST_TEST(map.inverted == 0);
    BOOST_TEST(map.wrong_winding == 0);
    Mesh quads;
    QL::extract_quad_mesh(map, layout, quads);
    const QL::Quad_mesh_measures measures = QL::measure_quad_mesh(quads);
    BOOST_TEST(measures.euler_characteristic == invariants::euler_characteristic(t.surface()));
    BOOST_TEST(measures.t_junctions == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
