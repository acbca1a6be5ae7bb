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
#include <CGAL/Quad_layouts/embed_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_mesh.h>
#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/quad_remesh.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

// Feature curves, on their way through all stages.

BOOST_AUTO_TEST_SUITE(test_features)

namespace QL = CGAL::Quad_layouts;
namespace parameters = CGAL::Quad_layouts::parameters;
using generated::Mesh;

namespace {

using Edge_map = Mesh::Property_map<Mesh::Edge_index, bool>;

struct Result
{
  QL::Cross_field field;
  QL::T_mesh t_mesh;
  QL::Quad_layout layout;
  QL::Integer_grid_map map;
};

// marks the edges for which `is_feature` holds at both ends
template <class Predicate>
Edge_map features(Mesh& mesh, Predicate is_feature)
{
  Edge_map result = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  for (const auto e : edges(mesh))
    result[e] = is_feature(mesh.point(source(e, mesh)), mesh.point(target(e, mesh)));
  return result;
}

Edge_map sharp_edges(Mesh& mesh)
{
  Edge_map result = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 40, result);
  return result;
}

// reads a model of CGAL's; returns false, and says so, where it is not installed
bool read_model(const std::string& name, Mesh& mesh)
{
  const bool is_there = CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/" + name + ".off"),
                                                    mesh);
  if (!is_there)
    BOOST_TEST_MESSAGE(name + ".off: skipped");
  return is_there;
}

generated::Kernel::Segment_3 segment(Mesh::Edge_index e, const Mesh& mesh)
{
  return {mesh.point(source(e, mesh)), mesh.point(target(e, mesh))};
}

// says if layout edges that are fixed are as long as the feature curves: each unit of a fixed arc
// has its own
void check_fixed_edges(const QL::T_mesh& t, const QL::Quad_layout& layout)
{
  std::vector<int> uses(layout.number_of_edges(), 0);
  for (int a = 0; a < t.number_of_edges(); ++a)
    if (t.is_fixed(a))
      for (int h : layout.arc_halfedges[a])
        ++uses[QL::Quad_layout::edge(h)];
  for (int e = 0; e < layout.number_of_edges(); ++e)
    BOOST_TEST(uses[e] == int(layout.is_fixed(e)));
}

Result run(const QL::Cross_field& field)
{
  Result r;
  r.field = field;
  const auto np = parameters::target_edge_length(0.1);
  r.t_mesh = QL::trace_motorcycle_graph(r.field, np);
  invariants::check_t_mesh(r.t_mesh);
  const QL::Quantization q = QL::quantize(r.t_mesh, np);
  BOOST_TEST_REQUIRE(q.status != QL::Quantization::INFEASIBLE);
  r.layout = QL::extract_quad_layout(r.t_mesh, q);
  invariants::check_halfedge_complex(r.layout);
  check_fixed_edges(r.t_mesh, r.layout);
  r.map = QL::embed_quad_layout(r.t_mesh, r.layout, np);
  return r;
}

Result run(const Mesh& mesh, const Edge_map& is_feature)
{
  return run(QL::compute_cross_field(
      mesh, parameters::default_values().edge_is_constrained_map(is_feature)));
}

} // namespace

BOOST_AUTO_TEST_CASE(edges_of_a_cube)
{
  Mesh mesh = generated::cube(4);
  const Result r = run(mesh, sharp_edges(mesh));
  BOOST_TEST(r.t_mesh.number_of_faces() == 6);
  BOOST_TEST(r.layout.number_of_patches == 6);
}

// A pair of valence 3 and 5 on one side of a cube whose edges are fixed: it can only merge (Figure
// 5 of Lyon, Campen and Kobbelt 2021).
BOOST_AUTO_TEST_CASE(a_pair_between_fixed_edges_merges)
{
  Mesh mesh = generated::cube(10);
  const auto is_feature = sharp_edges(mesh);
  const auto direction =
      mesh.add_property_map<Mesh::Face_index, generated::Vector>("f:v", {0, 0, 0}).first;
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const auto c = CGAL::centroid(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                                  mesh.point(target(next(h, mesh), mesh)));
    const double angle =
        (std::atan2(c.y() - 0.5, c.x() - 0.25) - std::atan2(c.y() - 0.5, c.x() - 0.75)) / 4;
    direction[f] = c.z() > 1 - 1e-9 ? generated::Vector(std::cos(angle), std::sin(angle), 0)
                   : c.z() < 1e-9   ? generated::Vector(1, 0, 0)
                                    : generated::Vector(0, 0, 1);
  }
  const QL::Cross_field field = QL::compute_cross_field(
      mesh, parameters::face_direction_map(direction).edge_is_constrained_map(is_feature));
  BOOST_TEST(field.number_of_singularities() == 10);
  const QL::T_mesh t = QL::trace_motorcycle_graph(field);
  invariants::check_t_mesh(t);
  const QL::Quantization q = QL::quantize(t);
  BOOST_TEST_REQUIRE(q.status != QL::Quantization::INFEASIBLE);
  const QL::Quad_layout layout = QL::extract_quad_layout(t, q);
  BOOST_TEST(layout.number_of_irregular_vertices() == 8);
  BOOST_TEST(layout.number_of_patches == 6);
}

BOOST_AUTO_TEST_CASE(quad_vertices_stay_on_the_edges_of_a_cube)
{
  Mesh mesh = generated::voxel_surface({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 4);
  const auto is_feature = sharp_edges(mesh);
  Mesh quads;
  const auto on_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  QL::quad_remesh(mesh, quads,
                  parameters::target_edge_length(0.1).edge_is_constrained_map(is_feature),
                  parameters::default_values().edge_is_constrained_map(on_feature));
  double length = 0, expected = 0;
  for (const auto e : edges(mesh))
    if (is_feature[e])
      expected += std::sqrt(
          CGAL::squared_distance(mesh.point(source(e, mesh)), mesh.point(target(e, mesh))));
  for (const auto e : edges(quads))
    if (on_feature[e])
      length += std::sqrt(
          CGAL::squared_distance(quads.point(source(e, quads)), quads.point(target(e, quads))));
  BOOST_TEST(length == expected, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(QL::measure_quad_mesh(quads).msj_minimum > 0.9);
}

// A plate is divided by a curve from border to border, and by one that ends inside.
BOOST_AUTO_TEST_CASE(curves_on_a_plate)
{
  Mesh mesh = generated::plate_with_holes(2, 2, {}, 4);
  const auto on_line = [](const generated::Point& p) { return p.y() == 1; };
  const Result r = run(
      mesh, features(mesh, [&](const auto& p, const auto& q) { return on_line(p) && on_line(q); }));
  BOOST_TEST(r.layout.number_of_patches == 2);
  Mesh other = generated::plate_with_holes(2, 2, {}, 4);
  const Result s = run(other, features(other, [&](const auto& p, const auto& q) {
                         return on_line(p) && on_line(q) && p.x() <= 1 && q.x() <= 1;
                       }));
  BOOST_TEST(s.layout.number_of_patches == 4);
}

BOOST_AUTO_TEST_CASE(circle_on_a_plate)
{
  Mesh mesh = generated::disc(12);
  const Result r = run(mesh, features(mesh, [&](const auto& p, const auto& q) {
                         const auto is_on = [](const generated::Point& x) {
                           return std::abs(std::hypot(x.x(), x.y()) - 0.5) < 1e-9;
                         };
                         return is_on(p) && is_on(q);
                       }));
  BOOST_TEST(r.layout.number_of_irregular_vertices() == 4);
}

// Circles on a torus have no irregular vertices that would tell one from the other, nor its sides.
BOOST_AUTO_TEST_CASE(parallel_circles)
{
  constexpr int nu = 24, nv = 12;
  for (const bool around_hole : {false, true})
    for (const std::set<int>& circles : {std::set<int>{0, 3}, {0, 9}, {1, 3, 8}, {0, 1, 3, 6}}) {
      Mesh mesh = generated::torus(nu, nv);
      const auto circle = [&](Mesh::Vertex_index v) { return around_hole ? v % nv : v / nv; };
      Edge_map is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
      std::vector<generated::Kernel::Segment_3> segments;
      for (const auto e : edges(mesh))
        if (circle(source(e, mesh)) == circle(target(e, mesh)) &&
            circles.count(circle(source(e, mesh)))) {
          is_feature[e] = true;
          segments.push_back(segment(e, mesh));
        }
      const Result r = run(mesh, is_feature);
      const auto curves = QL::layout_curves(r.map, r.layout);
      const auto is_on_circle = [&](const auto& x) {
        const generated::Point p(x.x(), x.y(), x.z());
        return std::any_of(segments.begin(), segments.end(),
                           [&](const auto& s) { return CGAL::squared_distance(p, s) < 1e-12; });
      };
      BOOST_TEST(invariants::violations(int(curves.size()), [&](int e) {
                   return !r.layout.is_fixed(e) ||
                          std::all_of(curves[e].begin(), curves[e].end(), is_on_circle);
                 }) == 0);
    }
}

// The field of this mesh winds around a limit cycle between sharp edges, also where traces stop at
// the first one that they meet: only more singularities keep the edges apart.
BOOST_AUTO_TEST_CASE(edges_along_a_limit_cycle)
{
  Mesh mesh;
  if (!read_model("mpi_triang", mesh))
    return;
  const QL::Cross_field field = QL::compute_cross_field(
      mesh, parameters::default_values().edge_is_constrained_map(sharp_edges(mesh)));
  const QL::T_mesh t = QL::trace_motorcycle_graph(field);
  invariants::check_t_mesh(t);
  int singularities = 0;
  for (int n = 0; n < t.number_of_vertices(); ++n)
    singularities += t.index(n) != 0;
  BOOST_TEST(singularities > field.number_of_singularities());
  BOOST_TEST((QL::internal::Squeezed_singularities(t).chains_to_fixed_curves().empty()));
  BOOST_TEST((QL::quantize(t).status != QL::Quantization::INFEASIBLE));
}

// Sharp edges of this mesh end here and there, so that some pieces of them cannot have any length:
// besides new singularities, it takes other valences of their own ends and corners.
BOOST_AUTO_TEST_CASE(edges_that_could_have_no_length)
{
  Mesh mesh;
  if (!read_model("femur", mesh))
    return;
  const QL::T_mesh t = QL::trace_motorcycle_graph(QL::compute_cross_field(
      mesh, parameters::default_values().edge_is_constrained_map(sharp_edges(mesh))));
  invariants::check_t_mesh(t);
  BOOST_TEST((QL::internal::Squeezed_singularities(t).chains_to_fixed_curves().empty()));
}

// Triangles all of whose sides are fixed, with angles that the field would make no quarter-turn in.
BOOST_AUTO_TEST_CASE(acute_corners)
{
  const double s = std::sqrt(0.75);
  const Mesh tip = generated::mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, s, 0}, {0.5, s / 3, 0.2}},
                                      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  Mesh mesh = tip;
  const Result r = run(mesh, sharp_edges(mesh));
  BOOST_TEST(r.t_mesh.number_of_faces() >= 9);
}

// Fixed curves that single faces and edges join: each side of the box is two triangles.
BOOST_AUTO_TEST_CASE(room_between_fixed_curves)
{
  Mesh mesh = generated::cube(1);
  const QL::Cross_field field = QL::compute_cross_field(
      mesh, parameters::default_values().edge_is_constrained_map(sharp_edges(mesh)));
  const auto& surface = field.surface();
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    BOOST_TEST(field.index(v) == int(v < 8));
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    int fixed = 0;
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      fixed += surface.is_fixed(h);
    BOOST_TEST(fixed <= 1);
  }
  BOOST_TEST(run(field).layout.number_of_patches == 6);
}

BOOST_AUTO_TEST_CASE(feature_curves_divide_patches)
{
  Mesh mesh = generated::cube(4);
  const auto is_feature = features(mesh, [](const auto& p, const auto& q) {
    return p.z() == 1 && q.z() == 1 && p.x() == 0.5 && q.x() == 0.5;
  });
  Mesh quads;
  const auto on_feature = quads.add_property_map<Mesh::Edge_index, bool>("e:feature", false).first;
  const auto patch = quads.add_property_map<Mesh::Face_index, int>("f:patch", -1).first;
  QL::quad_remesh(mesh, quads,
                  parameters::target_edge_length(0.1).edge_is_constrained_map(is_feature),
                  parameters::edge_is_constrained_map(on_feature).face_patch_map(patch));
  int patches = 0;
  for (const auto f : faces(quads))
    patches = (std::max)(patches, patch[f] + 1);
  BOOST_TEST(patches > 6);
  BOOST_TEST(QL::measure_quad_mesh(quads).patches == 6);
  const auto np = parameters::default_values().edge_is_constrained_map(on_feature);
  BOOST_TEST(QL::measure_quad_mesh(quads, np).patches == patches);
}

// Where a curve turns by a few degrees, it goes straight on for the layout; the edges of quads do
// not cut it off all the same.
BOOST_AUTO_TEST_CASE(bends_are_followed)
{
  const Mesh mesh = generated::annulus(0.4, 1, 4, 20);
  Mesh quads;
  QL::quad_remesh(mesh, quads, parameters::target_edge_length(0.1));
  BOOST_TEST(QL::measure_quad_mesh(quads).inverted_quads == 0);
  double farthest = 0;
  for (const auto v : vertices(mesh))
    if (mesh.is_border(v)) {
      double nearest = 1;
      for (const auto e : edges(quads))
        if (quads.is_border(e))
          nearest = (std::min)(nearest, CGAL::squared_distance(mesh.point(v), segment(e, quads)));
      farthest = (std::max)(farthest, std::sqrt(nearest));
    }
  BOOST_TEST(farthest < 1e-3 * std::sqrt(8.));
}

// Corners of two holes face each other. The edges between them have room to bend, however long
// edges are to be.
BOOST_AUTO_TEST_CASE(edges_between_corners_are_divided)
{
  Mesh mesh = generated::plate_with_holes(5, 3, {{1, 1}, {3, 1}}, 2);
  const Result r = run(mesh, features(mesh, [](const auto&, const auto&) { return false; }));
  const auto is_corner_of_layout = [&](int v) {
    return r.layout.is_on_fixed_curve(v) && !r.layout.goes_straight_on(v);
  };
  int edges_between_corners = 0;
  for (int h = 0; h < r.layout.number_of_halfedges(); h += 2)
    edges_between_corners += !r.layout.is_fixed(QL::Quad_layout::edge(h)) &&
                             is_corner_of_layout(r.layout.source(h)) &&
                             is_corner_of_layout(r.layout.target(h));
  BOOST_TEST(edges_between_corners == 2);
  Mesh quads;
  QL::extract_quad_mesh(r.map, r.layout, quads, parameters::target_edge_length(2.));
  const auto is_corner = [&](Mesh::Vertex_index v) {
    return quads.is_border(v) && degree(v, quads) != 3;
  };
  for (const auto e : edges(quads))
    if (!quads.is_border(e))
      BOOST_TEST((!is_corner(source(e, quads)) || !is_corner(target(e, quads))));
}

// Labels of this model need repair beside its sharp edges.
BOOST_AUTO_TEST_CASE(no_vertices_of_two_quads_beside_features)
{
  Mesh mesh;
  if (!read_model("diplodocus", mesh))
    return;
  const QL::Cross_field field = QL::compute_cross_field(
      mesh, parameters::default_values().edge_is_constrained_map(sharp_edges(mesh)));
  const QL::internal::Labels labels = QL::internal::make_labels(field);
  int slim_vertices = 0;
  for (int v = 0; v < field.surface().number_of_vertices(); ++v)
    slim_vertices += labels.is_slim(v) && field.index(v) < 2;
  BOOST_TEST(slim_vertices == 0);
}

// Two curves that end on a third one, from its two sides. If their ends fell together, the layout
// would have a vertex where four curves meet, but no place for it on all of them.
BOOST_AUTO_TEST_CASE(junctions_stay_apart)
{
  Mesh mesh = generated::plate_with_holes(3, 3, {}, 4);
  const auto is_feature = features(mesh, [](const auto& p, const auto& q) {
    return (p.y() == 1 && q.y() == 1) || (p.x() == 1 && q.x() == 1 && p.y() <= 1 && q.y() <= 1) ||
           (p.x() == 2 && q.x() == 2 && p.y() >= 1 && q.y() >= 1);
  });
  const QL::T_mesh t = QL::trace_motorcycle_graph(QL::compute_cross_field(
      mesh, parameters::default_values().edge_is_constrained_map(is_feature)));
  std::vector<int> length = QL::quantize(t).arc_length;
  BOOST_TEST(QL::internal::examine_quotient(t, length).valid);
  for (int a = 0; a < t.number_of_edges(); ++a) {
    const auto p = t.point(t.source(2 * a)), q = t.point(t.target(2 * a));
    if ((std::min)(p.x(), q.x()) > 1 - 1e-6 && (std::max)(p.x(), q.x()) < 2 + 1e-6 &&
        std::abs(p.y() - q.y()) < 1e-6)
      length[a] = 0;
  }
  const auto report = QL::internal::examine_quotient(t, length);
  BOOST_TEST(report.reason.find("junctions") == 0);
}

BOOST_AUTO_TEST_SUITE_END()
