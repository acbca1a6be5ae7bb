// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "checked_derivatives.h"
#include "generated_fields.h"
#include "generated_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/internal/field/Jump_field.h>
#include <CGAL/Quad_layouts/parametrize_seamlessly.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_parametrize_seamlessly)

namespace QL = CGAL::Quad_layouts;
namespace params = QL::parameters;

using generated::Mesh;
using generated::Vector;
using QL::Seamless_parametrization;
using QL::internal::inexactness;

namespace {

void check(const Seamless_parametrization& map)
{
  BOOST_TEST(inexactness(map) == "");
  BOOST_TEST(map.inverted == 0);
  BOOST_TEST(map.wrong_winding == 0);
  BOOST_TEST(map.is_locally_injective());
  BOOST_TEST(std::exp2(std::round(std::log2(map.unit))) == map.unit);
}

Seamless_parametrization checked_map(const QL::Cross_field& field, double edge_length)
{
  const Seamless_parametrization map = QL::parametrize_seamlessly(
      field, params::target_edge_length(edge_length));
  check(map);
  return map;
}

// the largest relative error of the length of an edge in the map
double distortion(const Seamless_parametrization& map, double edge_length)
{
  double result = 0;
  for (int h = 0; h < map.surface().number_of_halfedges(); ++h) {
    const double in_map = (map.point(map.surface().next(h)) - map.point(h)).norm();
    result = (std::max)(result, std::abs(in_map * edge_length / map.surface().length(h) - 1));
  }
  return result;
}

// the first vertex that is accepted of those `distance` edges away from another one
template <class Predicate>
int first_in_ring(const Seamless_parametrization::Surface& surface, int center, int distance,
                  const Predicate& accepts)
{
  std::vector<int> reached = {center}, edges(surface.number_of_vertices(), -1);
  edges[center] = 0;
  for (std::size_t i = 0;; ++i) {
    const int v = reached.at(i);
    if (edges[v] == distance && accepts(v))
      return v;
    surface.for_each_outgoing(v, [&](int h) {
      if (edges[surface.target(h)] < 0) {
        edges[surface.target(h)] = edges[v] + 1;
        reached.push_back(surface.target(h));
      }
    });
  }
}

// a property map with a length, or two, for each face
template <class Length>
struct Face_lengths
{
  using key_type = int;
  using value_type = Length;
  using reference = const Length&;
  using category = boost::readable_property_map_tag;

  std::vector<Length> lengths;

  friend reference get(const Face_lengths& map, int f) { return map.lengths[f]; }
};

using Length_pairs = Face_lengths<std::array<double, 2>>;

// length(centroid, direction) for directions 0 and 1 of the field in each face
template <class Length>
Length_pairs lengths_of_faces(const QL::Cross_field& field, const Length& length)
{
  Length_pairs result;
  const auto& surface = field.surface();
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      sum += surface.point(surface.source(3 * f + k));
    result.lengths.push_back(
        {length(sum / 3, field.direction(f, 0)), length(sum / 3, field.direction(f, 1))});
  }
  return result;
}

// the root of the mean square of the logarithms of how much longer edges are in the map than
// lengths along the directions of the field demand
double error_of_lengths(const Seamless_parametrization& map, const QL::Cross_field& field,
                        const Length_pairs& lengths)
{
  const auto& surface = map.surface();
  double sum = 0;
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    const int f = surface.face(h);
    Eigen::Vector2d demanded;
    for (int d = 0; d < 2; ++d)
      demanded[d] = surface.vector(h).dot(field.direction(f, d)) / lengths.lengths[f][d];
    const double in_map = (map.point(surface.next(h)) - map.point(h)).norm();
    sum += std::pow(std::log(in_map / demanded.norm()), 2);
  }
  return std::sqrt(sum / surface.number_of_halfedges());
}

Seamless_parametrization sized_map(const QL::Cross_field& field, const Length_pairs& lengths)
{
  const Seamless_parametrization map = QL::parametrize_seamlessly(
      field, params::target_edge_length(0.1).target_edge_length_map(lengths));
  check(map);
  return map;
}

// A drum with fans as top and bottom. The side between its first two corners spans `degrees` of the
// circle; all others are equal.
Mesh drum(int corners, double degrees)
{
  constexpr double degree = 2 * QL::internal::right_angle / 180;
  Mesh mesh;
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({0, 0, 1});
  std::vector<Mesh::Vertex_index> low, high;
  for (int i = 0; i < corners; ++i) {
    const double angle = i == 0 ? 0 : degrees + (i - 1) * (360 - degrees) / (corners - 1);
    const double x = std::cos(angle * degree), y = std::sin(angle * degree);
    low.push_back(mesh.add_vertex({x, y, 0}));
    high.push_back(mesh.add_vertex({x, y, 1}));
  }
  for (int i = 0; i < corners; ++i) {
    const int j = (i + 1) % corners;
    mesh.add_face(a, low[j], low[i]);
    mesh.add_face(b, high[i], high[j]);
    mesh.add_face(low[i], low[j], high[j]);
    mesh.add_face(low[i], high[j], high[i]);
  }
  return mesh;
}

// the defects of the map of a field that keeps its indices
int defects_without_moves(const QL::Cross_field& field, double edge_length)
{
  return QL::internal::number_of_defects(QL::internal::parametrize_seamlessly(
      field, QL::internal::Freedom::COORDINATES, params::target_edge_length(edge_length)));
}

QL::Cross_field field_along_features(Mesh& mesh)
{
  const auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 40, is_sharp);
  return QL::compute_cross_field(mesh, params::default_values().edge_is_constrained_map(is_sharp));
}

} // namespace

BOOST_AUTO_TEST_CASE(relations_by_hand)
{
  using QL::internal::Linear_relations;
  Linear_relations relations(4);
  relations.add({{0, 1}, {1, -1}, {2, -1}}); // x0 = x1 + x2
  relations.add({{0, 1}, {1, 1}, {3, -2}});  // x0 + x1 = 2 x3
  relations.add({{0, 2}, {2, -1}, {3, -2}}); // follows from the others
  relations.finish();
  int number_of_free = 0;
  for (int i = 0; i < 4; ++i)
    number_of_free += relations.is_free(i);
  BOOST_TEST(number_of_free == 2);

  // whatever the free unknowns are, if they are multiples of the denominator, all are integers
  const std::int64_t d = relations.common_denominator();
  std::vector<std::int64_t> x(4);
  for (int i = 0; i < 4; ++i)
    if (relations.is_free(i))
      x[i] = d * (5 * i + 3);
  for (int i = 0; i < 4; ++i)
    if (!relations.is_free(i)) {
      Linear_relations::Number sum = 0;
      for (const auto& term : relations.combination(i)) {
        BOOST_TEST(relations.is_free(term.first));
        sum += term.second * x[term.first];
      }
      BOOST_TEST(sum.denominator() == 1);
      x[i] = sum.numerator();
    }
  BOOST_TEST(x[0] == x[1] + x[2]);
  BOOST_TEST(x[0] + x[1] == 2 * x[3]);
}

BOOST_AUTO_TEST_CASE(relations_of_large_numbers)
{
  QL::internal::Linear_relations relations(40);
  const auto demand_all = [&] {
    for (int i = 0; i + 1 < 40; ++i)
      relations.add({{i, 3}, {i + 1, -7}});
    relations.finish();
  };
  BOOST_CHECK_THROW(demand_all(), QL::Stage_failure);
}

BOOST_AUTO_TEST_CASE(derivatives_of_the_regularized_distortion)
{
  using QL::internal::Regularized_distortion;
  const Eigen::Vector4d positive(1, 0.2, -0.3, 0.8), inverted(0.7, 0.1, 0.4, -0.5);
  check_derivatives(Regularized_distortion(0), positive);
  check_derivatives(Regularized_distortion(0.3), positive);
  check_derivatives(Regularized_distortion(0.3), inverted);
}

BOOST_AUTO_TEST_CASE(flat_plates_are_kept)
{
  // with a hole, around which no transition turns
  const Mesh mesh = generated::plate_with_holes(3, 3, {{1, 1}}, 4);
  const Seamless_parametrization map = checked_map(QL::compute_cross_field(mesh), 0.1);
  BOOST_TEST(distortion(map, 0.1) < 1e-9);
}

BOOST_AUTO_TEST_CASE(cubes_are_unfolded)
{
  for (const bool has_features : {false, true}) {
    Mesh mesh = generated::cube(4);
    const QL::Cross_field field = has_features ? field_along_features(mesh)
                                               : QL::compute_cross_field(mesh);
    const Seamless_parametrization map = checked_map(field, 0.1);
    BOOST_TEST(distortion(map, 0.1) < 1e-2);
    int cones = 0;
    for (const int index : map.vertex_index)
      cones += index != 0;
    BOOST_TEST(cones == 8);
  }
}

BOOST_AUTO_TEST_CASE(curved_surfaces)
{
  for (const Mesh& mesh :
       {generated::icosphere(3), generated::torus(24, 12), generated::slab_with_holes(2, 3),
        generated::noisy(generated::icosphere(3), 0.05, 3), generated::tetrahedron(),
        generated::disjoint_union(generated::icosphere(2),
                                  generated::translated(generated::cube(3), Vector(9, 0, 0)))})
    checked_map(QL::compute_cross_field(mesh), 0.1);
}

BOOST_AUTO_TEST_CASE(surfaces_with_borders)
{
  for (const Mesh& mesh : {generated::disc(8), generated::annulus(0.5, 1, 6, 40),
                           generated::plate_with_holes(4, 3, {{1, 1}, {2, 1}}, 2)})
    checked_map(QL::compute_cross_field(mesh), 0.1);
}

// The diagonals of the sides of a cube join vertices of its edges, which are all fixed: were they
// not divided, the faces beside them could lose their area.
BOOST_AUTO_TEST_CASE(faces_between_features)
{
  Mesh mesh = generated::cube(1);
  const Seamless_parametrization map = checked_map(field_along_features(mesh), 0.1);
  BOOST_TEST(distortion(map, 0.1) < 1e-6);
}

BOOST_AUTO_TEST_CASE(features_inside)
{
  Mesh slab = generated::slab_with_holes(1, 3);
  checked_map(field_along_features(slab), 0.1);
}

// The middle of a drum's top has fixed edges all around: were its spokes not divided, all of the
// top's index would be there, and the edges would have no length.
BOOST_AUTO_TEST_CASE(fans_in_fixed_edges)
{
  Mesh mesh = drum(16, 25);
  checked_map(field_along_features(mesh), 0.1);
}

BOOST_AUTO_TEST_CASE(moves_of_index)
{
  Mesh mesh = generated::disjoint_union(drum(16, 25),
                                        generated::plate_with_holes(4, 3, {{1, 1}}, 2));
  const QL::Cross_field field = field_along_features(mesh);
  const auto& surface = field.surface();
  QL::internal::Jump_field jumps(field);
  int moves = 0;
  for (int h = 0; h < surface.number_of_halfedges(); ++h) {
    if (!jumps.can_move(h))
      continue;
    ++moves;
    jumps.move(h);
    const QL::Cross_field moved = jumps.field();
    for (int v = 0; v < surface.number_of_vertices(); ++v)
      BOOST_TEST(moved.index(v) ==
                 field.index(v) - (v == surface.source(h)) + (v == surface.target(h)));
    for (int g = 0; g < surface.number_of_halfedges(); ++g) {
      BOOST_TEST((moved.matching(g) == field.matching(g)) == (g != h && g != surface.opposite(h)));
      BOOST_TEST((!surface.is_fixed(g) || jumps.number_of_quadrants(g) >= 1));
    }
    jumps.undo_move(h);
    BOOST_TEST(jumps.field().matching(h) == field.matching(h));
  }
  BOOST_TEST(moves > 0);
}

BOOST_AUTO_TEST_CASE(indices_are_moved_where_there_is_no_map)
{
  const QL::Cross_field field = generated::field_without_map();
  BOOST_TEST(defects_without_moves(field, 0.1) > 0);

  const Seamless_parametrization map = checked_map(field, 0.1);
  int moved = 0;
  for (int v = 0; v < field.surface().number_of_vertices(); ++v)
    moved += map.vertex_index[v] != field.index(v);
  BOOST_TEST(moved > 0);
}

// Some wrong indices make many defects: the sharp edges of this mesh meet in acute corners.
BOOST_AUTO_TEST_CASE(few_moves_mend_many_defects)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(CGAL::data_file_path("meshes/mpi.off"), mesh)) {
    BOOST_TEST_MESSAGE("skipped");
    return;
  }
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  const QL::Cross_field field = field_along_features(mesh);
  const Seamless_parametrization map = QL::parametrize_seamlessly(field);
  check(map);
  constexpr int many = 20;
  BOOST_TEST(defects_without_moves(field, map.edge_length) > many);
}

// An acute corner between fixed edges has a quadrant, and not a part of it in proportion.
BOOST_AUTO_TEST_CASE(rosettes_keep_sectors)
{
  using QL::internal::Triangle_surface;
  Mesh mesh = drum(3, 3);
  const QL::Cross_field field = field_along_features(mesh);
  const auto& surface = field.surface();
  const QL::internal::Cut_graph cut(field);
  const QL::internal::Seam_constraints seams(surface, cut);
  QL::internal::Aligned_energy energy(surface, cut, seams, 0.1);
  QL::internal::Reduced_newton newton(seams, energy);
  const QL::internal::Rosettes rosettes(field, cut, 0.1);
  for (int v = 0; v < surface.number_of_vertices(); ++v) {
    if (surface.number_of_fixed_edges(v) < 3)
      continue;
    rosettes.demand(v, energy);
    newton.align();
    energy.release();
    const Seamless_parametrization map = QL::internal::exact_parametrization(
        field, cut, seams, newton.coordinates(), 0.1);
    surface.for_each_outgoing(v, [&](int h) {
      const Eigen::Vector2d a = map.point(Triangle_surface::next(h)) - map.point(h),
                            b = map.point(Triangle_surface::prev(h)) - map.point(h);
      BOOST_TEST(a.x() * b.y() - a.y() * b.x() > 0);
    });
  }
}

// Each edge that is cut is in one seam, and one motion holds along a seam.
BOOST_AUTO_TEST_CASE(seams_cover_the_cut)
{
  for (const Mesh& mesh : {generated::noisy(generated::icosphere(3), 0.15, 3),
                           generated::torus(24, 12), generated::annulus(0.5, 1, 6, 40)}) {
    const QL::Cross_field field = QL::compute_cross_field(mesh);
    const auto& surface = field.surface();
    const QL::internal::Cut_graph cut(field);
    std::vector<int> seams_with(surface.number_of_edges(), 0);
    for (const std::vector<int>& seam : QL::internal::find_seams(surface, cut))
      for (const int h : seam) {
        ++seams_with[surface.edge(h)];
        BOOST_TEST(cut.quarter_turns(h) == cut.quarter_turns(seam.front()));
      }
    for (int e = 0; e < surface.number_of_edges(); ++e) {
      const int h = surface.halfedge_of_edge(e);
      BOOST_TEST(seams_with[e] == (cut.is_cut(h) && !surface.is_border(h)));
    }
  }
}

// However many cones there are, unknowns depend on few others, for which the system of equations
// stays sparse.
BOOST_AUTO_TEST_CASE(relations_are_short)
{
  const QL::Cross_field field = QL::compute_cross_field(
      generated::noisy(generated::icosphere(4), 0.15, 3));
  BOOST_TEST(field.number_of_singularities() > 100);
  const QL::internal::Cut_graph cut(field);
  const QL::internal::Seam_constraints seams(field.surface(), cut);
  std::size_t dependent = 0, terms = 0;
  for (int i = 0; i < seams.number_of_unknowns(); ++i)
    if (!seams.relations().is_free(i)) {
      ++dependent;
      terms += seams.relations().combination(i).size();
    }
  BOOST_TEST(terms < 10 * dependent);
  BOOST_TEST(seams.relations().common_denominator() <= 16);
}

// fields with many singularities need inverted triangles to be turned back
BOOST_AUTO_TEST_CASE(inverted_triangles_are_turned_back)
{
  const QL::Cross_field field = QL::compute_cross_field(
      generated::noisy(generated::icosphere(3), 0.15, 3));
  const QL::internal::Cut_graph cut(field);
  const QL::internal::Seam_constraints seams(field.surface(), cut);
  QL::internal::Aligned_energy energy(field.surface(), cut, seams, 0.05);
  QL::internal::Reduced_newton newton(seams, energy);
  newton.align();
  BOOST_TEST(energy.least_determinant(newton.coordinates()) < 0);
  checked_map(field, 0.05);
}

// A vertex of valence 5 that has lost a full turn, which a regular one has in excess: the map has
// no inverted triangle then, and yet must be repaired.
BOOST_AUTO_TEST_CASE(wrong_windings_are_repaired)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::slab_with_holes(2, 4));
  const auto& surface = field.surface();
  std::vector<double> angles;
  std::vector<signed char> matchings;
  std::vector<int> indices;
  for (int f = 0; f < surface.number_of_faces(); ++f)
    angles.push_back(field.angle(f));
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    matchings.push_back(static_cast<signed char>(field.matching(h)));
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    indices.push_back(field.index(v));
  const int five = int(std::find(indices.begin(), indices.end(), -1) - indices.begin());
  BOOST_TEST_REQUIRE(five < surface.number_of_vertices());
  const int regular = first_in_ring(surface, five, 3, [&](int v) { return indices[v] == 0; });
  indices[five] += 4;
  indices[regular] -= 4;
  const QL::Cross_field wrong(field.surface_pointer(), angles, matchings, indices);

  const QL::internal::Monitor monitor;
  QL::internal::Seamless_optimization optimization(field, 0.1, 100, monitor);
  optimization.align_with_rosettes(wrong, {five, regular});
  const Seamless_parametrization map = optimization.result();
  BOOST_TEST(map.inverted == 0);
  BOOST_TEST(map.wrong_winding == 2);
  check(optimization.repaired_result());
}

BOOST_AUTO_TEST_CASE(lengths_scale)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::icosphere(3));
  const Seamless_parametrization a = checked_map(field, 0.1), b = checked_map(field, 0.2);
  for (int h = 0; h < field.surface().number_of_halfedges(); ++h)
    BOOST_TEST((a.point(h) - 2 * b.point(h)).norm() < 1e-3 * (1 + a.point(h).norm()));
}

// lengths that grow along a plate, in one direction, can be kept
BOOST_AUTO_TEST_CASE(lengths_grow_along_a_plate)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::plate_with_holes(2, 1, {}, 24));
  const auto lengths = lengths_of_faces(field, [](const Eigen::Vector3d& p, const auto& direction) {
    return std::abs(direction.x()) > 0.5 ? 0.05 + 0.05 * p.x() : 0.1;
  });
  BOOST_TEST(error_of_lengths(sized_map(field, lengths), field, lengths) < 0.02);
}

// the field has its own idea of lengths here, so that no map can have both
BOOST_AUTO_TEST_CASE(lengths_grow_over_a_sphere)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::icosphere(4));
  const auto lengths = lengths_of_faces(
      field, [](const Eigen::Vector3d& p, const auto&) { return 0.1 * std::exp(0.7 * p.z()); });
  const Seamless_parametrization sized = sized_map(field, lengths);
  const Seamless_parametrization uniform = checked_map(field, 0.1);
  BOOST_TEST(error_of_lengths(sized, field, lengths) <
             0.75 * error_of_lengths(uniform, field, lengths));
  const auto mean_length = [&](const Seamless_parametrization& map, double sign) {
    double on_surface = 0, in_map = 0;
    for (int h = 0; h < map.surface().number_of_halfedges(); ++h)
      if (sign * map.surface().point(map.surface().source(h)).z() > 0.7) {
        on_surface += map.surface().length(h);
        in_map += (map.point(map.surface().next(h)) - map.point(h)).norm();
      }
    return on_surface / in_map;
  };
  BOOST_TEST(mean_length(sized, 1) / mean_length(sized, -1) > 1.4);
  BOOST_TEST(mean_length(uniform, 1) / mean_length(uniform, -1) < 1.2);
}

BOOST_AUTO_TEST_CASE(lengths_differ_by_direction)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::torus(48, 24, 4, 1));
  const auto lengths = lengths_of_faces(field, [](const Eigen::Vector3d& p, const auto& direction) {
    const Eigen::Vector3d around = Eigen::Vector3d(-p.y(), p.x(), 0).normalized();
    return std::abs(around.dot(direction)) > 0.7 ? 0.3 : 0.1;
  });
  BOOST_TEST(error_of_lengths(sized_map(field, lengths), field, lengths) < 0.15);
  BOOST_TEST(error_of_lengths(checked_map(field, 0.2), field, lengths) > 0.4);
}

BOOST_AUTO_TEST_CASE(equal_lengths_are_like_one)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::icosphere(3));
  const Face_lengths<double> lengths{std::vector<double>(field.surface().number_of_faces(), 0.2)};
  const Seamless_parametrization one = checked_map(field, 0.2),
                                 many = QL::parametrize_seamlessly(
                                     field, params::target_edge_length(0.1).target_edge_length_map(
                                                lengths));
  check(many);
  BOOST_TEST(many.edge_length == 0.1);
  for (int h = 0; h < field.surface().number_of_halfedges(); ++h)
    BOOST_TEST((one.point(h) - many.point(h)).norm() < 1e-3 * (1 + one.point(h).norm()));
}

BOOST_AUTO_TEST_CASE(errors_are_found)
{
  const Seamless_parametrization good = checked_map(QL::compute_cross_field(generated::cube(3)),
                                                    0.1);
  const auto expect = [&](const std::function<void(Seamless_parametrization&)>& spoil,
                          const std::string& words) {
    Seamless_parametrization bad = good;
    spoil(bad);
    BOOST_TEST(inexactness(bad).find(words) != std::string::npos, inexactness(bad));
  };
  expect([](auto& map) { map.corner_coordinates[7].x() += 1; }, "transition does not fit");
  expect([](auto& map) { map.halfedge_transition[5].translation.y() += 1; },
         "transition does not fit");
  expect([](auto& map) { map.vertex_index[0] += 1; }, "around vertex 0");

  Seamless_parametrization inverted = good;
  inverted.corner_coordinates[1] = inverted.corner_coordinates[0];
  BOOST_TEST(QL::internal::number_of_inverted_faces(inverted) == 1);
  Seamless_parametrization wound = good;
  wound.vertex_index[3] += 4;
  BOOST_TEST(inexactness(wound) == "");
  BOOST_TEST((QL::internal::wrong_windings(wound) == std::vector<int>{3}));
}

BOOST_AUTO_TEST_CASE(same_answer_twice)
{
  const QL::Cross_field field = QL::compute_cross_field(
      generated::noisy(generated::icosphere(2), 0.05, 5));
  const Seamless_parametrization a = checked_map(field, 0.1), b = checked_map(field, 0.1);
  BOOST_TEST((a.corner_coordinates == b.corner_coordinates));
}

BOOST_AUTO_TEST_CASE(parameters_out_of_range_are_refused)
{
  const QL::Cross_field field = QL::compute_cross_field(generated::tetrahedron());
  BOOST_CHECK_THROW(QL::parametrize_seamlessly(field, params::target_edge_length(0)),
                    QL::Invalid_parameter);
  BOOST_CHECK_THROW(QL::parametrize_seamlessly(field, params::number_of_iterations(0)),
                    QL::Invalid_parameter);
  const Face_lengths<double> lengths{{1, 1, -1, 1}};
  BOOST_CHECK_THROW(QL::parametrize_seamlessly(field, params::target_edge_length_map(lengths)),
                    QL::Invalid_parameter);
}

BOOST_AUTO_TEST_CASE(visitor_can_stop)
{
  struct Visitor : QL::Default_visitor
  {
    bool go_on() { return false; }
  } visitor;
  const QL::Cross_field field = QL::compute_cross_field(generated::icosphere(2));
  BOOST_CHECK_THROW(QL::parametrize_seamlessly(field, params::visitor(std::ref(visitor))),
                    QL::Cancelled);
}

BOOST_AUTO_TEST_CASE(real_meshes)
{
  for (const char* name : {"elk", "hand", "knot1", "rotor"}) {
    std::ifstream in(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
    Mesh mesh;
    if (!(in >> mesh)) {
      BOOST_TEST_MESSAGE(name << " skipped");
      continue;
    }
    check(QL::parametrize_seamlessly(QL::compute_cross_field(mesh)));
  }
}

BOOST_AUTO_TEST_SUITE_END()
