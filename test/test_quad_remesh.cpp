// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/quad_remesh.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <functional>
#include <limits>

BOOST_AUTO_TEST_SUITE(test_quad_remesh)

namespace QL = CGAL::Quad_layouts;
using Polyhedron = CGAL::Polyhedron_3<generated::Kernel>;

namespace {

// cancels the work when it is asked for the `patience`-th time
struct Impatient_visitor : QL::Default_visitor
{
  int patience = 0, asked = 0;
  bool go_on() { return ++asked <= patience; }
};

} // namespace

BOOST_AUTO_TEST_CASE(slab_with_two_holes)
{
  const auto mesh = generated::slab_with_holes(2, 4);
  generated::Mesh layout, quads;
  QL::quad_layout(mesh, layout);
  QL::quad_remesh(mesh, quads);
  BOOST_TEST(CGAL::is_valid_polygon_mesh(quads));
  const QL::Quad_mesh_measures m = QL::measure_quad_mesh(quads);
  BOOST_TEST(m.inverted_quads == 0);
  BOOST_TEST(m.euler_characteristic == -2);
  BOOST_TEST(m.patches <= int(num_faces(layout)));
  BOOST_TEST(m.msj_average > 0.9);
}

BOOST_AUTO_TEST_CASE(polyhedron_in_and_out)
{
  Polyhedron mesh, quads;
  CGAL::copy_face_graph(generated::cube(6), mesh);
  QL::quad_remesh(mesh, quads, QL::parameters::maximum_deviation(20).maximum_displacement(1));
  BOOST_TEST(CGAL::is_valid_polygon_mesh(quads));
  BOOST_TEST(QL::measure_quad_mesh(quads).patches == 6);
}

BOOST_AUTO_TEST_CASE(weights_of_faces)
{
  auto mesh = generated::cube(4);
  auto weight = mesh.add_property_map<generated::Mesh::Face_index, double>("f:weight", 3.).first;
  const auto np = QL::parameters::face_weight_map(weight);
  generated::Mesh layout, quads;
  QL::quad_layout(mesh, layout, np);
  BOOST_TEST(num_faces(layout) == 6u);
  *weight.begin() = 0;
  BOOST_CHECK_THROW(QL::quad_remesh(mesh, quads, np), QL::Invalid_parameter);
  BOOST_TEST(num_faces(quads) == 0u);
}

// The visitor is asked more often than this: about twenty moments all over the work are tried.
BOOST_AUTO_TEST_CASE(it_can_be_cancelled_at_any_stage)
{
  const auto mesh = generated::cube(4);
  const auto np = QL::parameters::target_edge_length(0.2);
  Impatient_visitor patient;
  patient.patience = (std::numeric_limits<int>::max)();
  generated::Mesh quads;
  QL::quad_remesh(mesh, quads, np.visitor(std::ref(patient)));
  BOOST_TEST(patient.asked > 20);
  for (int i = 0; i <= 20; ++i) {
    Impatient_visitor visitor;
    visitor.patience = i * (patient.asked - 1) / 20;
    generated::Mesh out;
    BOOST_CHECK_THROW(QL::quad_remesh(mesh, out, np.visitor(std::ref(visitor))), QL::Cancelled);
    BOOST_TEST(visitor.asked == visitor.patience + 1);
    BOOST_TEST(CGAL::is_empty(out));
  }
}

BOOST_AUTO_TEST_CASE(time_limit_is_for_all_stages)
{
  const auto mesh = generated::noisy(generated::icosphere(4), 0.05, 1);
  const auto np = QL::parameters::maximum_running_time(0.5);
  generated::Mesh out;
  CGAL::Real_timer timer;
  timer.start();
  BOOST_CHECK_THROW(QL::quad_remesh(mesh, out, np), QL::Time_limit_exceeded);
  BOOST_CHECK_THROW(QL::quad_layout(mesh, out, QL::parameters::maximum_running_time(1e-3)),
                    QL::Time_limit_exceeded);
  BOOST_TEST(timer.time() < 5);
  BOOST_TEST(CGAL::is_empty(out));
}

BOOST_AUTO_TEST_CASE(nothing_is_left_where_it_fails)
{
  const auto mesh = generated::cube(3);
  generated::Mesh quads;
  Impatient_visitor visitor;
  BOOST_CHECK_THROW(QL::quad_remesh(mesh, quads, QL::parameters::visitor(std::ref(visitor))),
                    QL::Cancelled);
  BOOST_CHECK_THROW(QL::quad_remesh(mesh, quads, QL::parameters::maximum_deviation(90)),
                    QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::quad_remesh(generated::Mesh(), quads), QL::Empty_mesh);
  BOOST_TEST(num_faces(quads) == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
