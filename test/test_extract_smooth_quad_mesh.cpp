// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/embed_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/extract_smooth_quad_mesh.h>
#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/smooth_quad_mesh.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include "generated_meshes.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_extract_smooth_quad_mesh)

namespace QL = CGAL::Quad_layouts;
namespace parameters = CGAL::Quad_layouts::parameters;
using generated::Mesh;

namespace {

struct Result
{
  QL::Quad_layout layout;
  QL::Integer_grid_map map;
};

Result embedded_layout(const Mesh& mesh, double target_edge_length)
{
  const auto np = parameters::target_edge_length(target_edge_length).maximum_deviation(30.);
  const QL::T_mesh t_mesh = QL::trace_motorcycle_graph(QL::compute_cross_field(mesh), np);
  QL::Quad_layout layout = QL::extract_quad_layout(t_mesh, QL::quantize(t_mesh, np));
  QL::Integer_grid_map map = QL::embed_quad_layout(t_mesh, layout, np);
  return {std::move(layout), std::move(map)};
}

} // namespace

// All corners of a hole may fall together. Quads as large as the hole then reach across it.
BOOST_AUTO_TEST_CASE(quads_around_holes)
{
  using Holes = std::vector<std::array<int, 2>>;
  int refined = 0, the_same = 0;
  for (const double h : {0.5, 1., 2.75}) // the widest reach across holes of several cells
    for (const Holes& holes :
         {Holes{{4, 4}}, Holes{{3, 3}, {4, 4}, {3, 4}}, Holes{{3, 3}, {5, 5}}}) {
      const Mesh mesh = generated::plate_with_holes(9, 9, holes, 1);
      const Result r = embedded_layout(mesh, h);
      Mesh plain, quads;
      const auto patch = quads.add_property_map<Mesh::Face_index, int>("f:patch", -1).first;
      QL::extract_quad_mesh(r.map, r.layout, plain);
      QL::smooth_quad_mesh(plain, mesh);
      QL::extract_smooth_quad_mesh(r.map, r.layout, mesh, quads, parameters::face_patch_map(patch));
      const QL::Quad_mesh_measures before = QL::measure_quad_mesh(plain),
                                   after = QL::measure_quad_mesh(quads);
      BOOST_TEST(after.inverted_quads == 0);
      BOOST_TEST(after.patches == before.patches);
      for (const auto f : faces(quads))
        BOOST_TEST((patch[f] >= 0 && patch[f] < r.layout.number_of_patches));
      if (before.inverted_quads > 0) {
        ++refined;
        BOOST_TEST(after.quads > before.quads);
      } else {
        ++the_same;
        BOOST_TEST(std::equal(plain.points().begin(), plain.points().end(), quads.points().begin(),
                              quads.points().end()));
      }
    }
  BOOST_TEST(refined > 0);
  BOOST_TEST(the_same > 0);
}

// The edges of a cube have three chords, of which each runs through four of its six faces.
BOOST_AUTO_TEST_CASE(chords_are_divided_as_far_as_there_is_room)
{
  const QL::Quad_layout layout = embedded_layout(generated::cube(4), 1).layout;
  BOOST_TEST_REQUIRE(layout.number_of_chords == 3);
  const auto divided = [&](double most_vertices) { // from 98 vertices
    std::vector<int> divisions(3, 4);
    const bool any = QL::internal::divide_chords({0, 1, 2}, layout, most_vertices, divisions);
    BOOST_TEST(any == (divisions != std::vector<int>(3, 4)));
    return divisions;
  };
  BOOST_TEST(divided(386) == (std::vector<int>{8, 8, 8}), boost::test_tools::per_element());
  BOOST_TEST(divided(170) == (std::vector<int>{8, 4, 4}), boost::test_tools::per_element());
  BOOST_TEST(divided(140) == (std::vector<int>{6, 4, 4}), boost::test_tools::per_element());
  BOOST_TEST(divided(113) == (std::vector<int>{4, 4, 4}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(what_is_refused_changes_nothing)
{
  const Mesh mesh = generated::cube(4);
  const Result r = embedded_layout(mesh, 0.2);
  struct Impatient : QL::Default_visitor
  {
    bool go_on() { return false; }
  };
  Mesh quads;
  const auto extract = [&](const auto& np_out, const auto& np_surface) {
    QL::extract_smooth_quad_mesh(r.map, r.layout, mesh, quads, np_out, np_surface);
  };
  const auto none = parameters::default_values();
  BOOST_CHECK_THROW(extract(parameters::number_of_iterations(-1), none), QL::Invalid_parameter);
  BOOST_CHECK_THROW(extract(parameters::target_edge_length(0.), none), QL::Invalid_parameter);
  BOOST_CHECK_THROW(extract(parameters::maximum_running_time(-1.), none), QL::Invalid_parameter);
  BOOST_CHECK_THROW(extract(parameters::visitor(Impatient()), none), QL::Cancelled);
  BOOST_CHECK_THROW(extract(none, parameters::visitor(Impatient())), QL::Cancelled);
  BOOST_TEST(is_empty(quads));
  BOOST_CHECK_THROW(QL::extract_smooth_quad_mesh(r.map, r.layout, Mesh(), quads), QL::Empty_mesh);
  BOOST_TEST(is_empty(quads));
  extract(parameters::number_of_iterations(0).target_edge_length(0.5), none);
  Mesh plain;
  QL::extract_quad_mesh(r.map, r.layout, plain, parameters::target_edge_length(0.5));
  BOOST_TEST(quads.number_of_faces() == plain.number_of_faces());
}

BOOST_AUTO_TEST_SUITE_END()
