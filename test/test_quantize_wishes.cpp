// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include "exhaustive_search.h"
#include "hand_made_t_meshes.h"

#include <CGAL/Quad_layouts/IO/quantization_program.h>
#include <CGAL/Quad_layouts/arc_weights.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/property_map.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_quantize_wishes)

using namespace exhaustive_search;

namespace {

using Pairs = std::vector<std::pair<int, int>>; // of vertices

QL::T_mesh with_surface(QL::T_mesh t_mesh)
{
  t_mesh.surface_pointer = std::make_shared<const internal::Triangle_surface>();
  return t_mesh;
}

auto parameters_of(const Case& c)
{
  return parameters::maximum_deviation(40.)
      .maximum_displacement(c.displacement)
      .target_edge_length(c.edge_length)
      .relative_gap(0.)
      .maximum_running_time(2.);
}

constexpr int enough = 5000; // of those to enumerate

// how many singularities have fallen onto others
int merges(const QL::T_mesh& t_mesh, const Verdict& verdict)
{
  int result = 0;
  for (const auto& cluster : verdict.report.clusters) {
    const auto singularities = std::count_if(cluster.nodes.begin(), cluster.nodes.end(),
                                             [&](int n) { return t_mesh.index(n) != 0; });
    result += (std::max)(0, int(singularities) - 1);
  }
  return result;
}

bool is_granted(const internal::Quantization_program& program, const Lengths& lengths,
                const Verdict& verdict)
{
  return internal::grants_wishes(program, lengths) &&
         std::none_of(program.separate.begin(), program.separate.end(), [&](const auto& pair) {
           return internal::are_merged(verdict.report, pair.i, pair.j);
         });
}

template <class NamedParameters>
internal::Quantization_program program_of(const Case& c, const NamedParameters& np)
{
  const auto options = internal::quantization_options(c.t_mesh, np);
  return internal::build_quantization_program(c.t_mesh, options.demands, options.wishes);
}

// says that no quantization was found that has what was wished for
template <class NamedParameters>
bool is_infeasible(const Case& c, const NamedParameters& np)
{
  const auto program = program_of(c, np);
  const Judge judge(c);
  bool result = true;
  Enumeration(c.t_mesh, largest_length).run(enough, [&](const Lengths& lengths) {
    const Verdict v = judge(lengths);
    result = result && !(v.is_valid && v.is_legal && is_granted(program, lengths, v));
  });
  return result;
}

// Checks that a quantization has what was wished for, and that no quantization that has is below
// its bound. Returns whether it is proven and confirmed to be the best. What is not legal is only
// put up with where it cannot be helped.
template <class NamedParameters>
bool check(const Case& c, const QL::Quantization& q, const NamedParameters& np)
{
  const auto program = program_of(c, np);
  const Judge judge(c);
  const auto objective_of = [&](const Lengths& lengths) {
    return internal::check_quantization(c.t_mesh, program, lengths).objective;
  };
  const Verdict own = judge(q.arc_length);
  BOOST_TEST(own.is_valid);
  BOOST_TEST(is_granted(program, q.arc_length, own));
  BOOST_TEST(q.objective == objective_of(q.arc_length), boost::test_tools::tolerance(1e-9));
  double best = (std::numeric_limits<double>::max)();
  Enumeration(c.t_mesh, largest_length).run(enough, [&](const Lengths& lengths) {
    const double objective = objective_of(lengths);
    if (objective >= best)
      return;
    const Verdict verdict = judge(lengths);
    const bool is_comparable = verdict.is_legal || (!own.is_legal && merges(c.t_mesh, verdict) <=
                                                                         merges(c.t_mesh, own));
    if (verdict.is_valid && is_comparable && is_granted(program, lengths, verdict))
      best = objective;
  });
  BOOST_TEST(q.bound <= best * (1 + 1e-9));
  if (q.status != QL::Quantization::OPTIMAL)
    return false;
  BOOST_TEST(best >= q.objective * (1 - 1e-9));
  return best <= q.objective * (1 + 1e-9);
}

// some of them
Pairs pairs_of_singularities(const QL::T_mesh& t_mesh)
{
  std::vector<int> vertices;
  for (int n = 0; n < t_mesh.number_of_vertices(); ++n)
    if (t_mesh.index(n) != 0)
      vertices.push_back(t_mesh.surface_vertex(n));
  Pairs result;
  for (std::size_t i = 1; i < vertices.size() && i < 3; ++i)
    result.emplace_back(vertices[i], vertices[i / 2]);
  return result;
}

} // namespace

BOOST_AUTO_TEST_SUITE(merges)

// Each edge of the cube is an arc; opposite corners could merge if valences below 3 were permitted.
BOOST_AUTO_TEST_CASE(forbidden_on_the_cube)
{
  const QL::T_mesh t = with_surface(hand_made::cube());
  const auto np = parameters::maximum_displacement(0.5).target_edge_length(1).minimum_valence(2);
  BOOST_TEST(QL::quantize(t, np).objective == 8);
  const QL::Quantization q = QL::quantize(t, np.forbidden_merges(Pairs{{0, 1}, {0, 2}, {0, 4}}));
  BOOST_TEST(q.objective == 12);
  BOOST_TEST((q.status == QL::Quantization::OPTIMAL));
}

// What merges, and is then forbidden to, does not; and the result is the best without it.
BOOST_AUTO_TEST_CASE(forbidden_ones_do_not_happen)
{
  int forbidden = 0, confirmed = 0, inseparable = 0;
  for (const Case& c : cases())
    BOOST_TEST_CONTEXT(c.name)
    {
      const QL::Quantization free = QL::quantize(c.t_mesh, parameters_of(c));
      const auto report = internal::examine_quotient(c.t_mesh, free.arc_length);
      Pairs pairs;
      for (const auto& cluster : report.clusters)
        if (cluster.nodes.size() > 1)
          pairs.emplace_back(c.t_mesh.surface_vertex(cluster.nodes[0]),
                             c.t_mesh.surface_vertex(cluster.nodes[1]));
      if (pairs.empty())
        continue;
      const auto np = parameters_of(c).forbidden_merges(pairs);
      try {
        const QL::Quantization q = QL::quantize(c.t_mesh, np);
        ++forbidden;
        BOOST_TEST(q.objective >= free.objective * (1 - 1e-9));
        confirmed += check(c, q, np);
      } catch (const QL::Unsatisfiable_demand& error) {
        ++inseparable;
        BOOST_TEST_MESSAGE(c.name << ": " << error.what());
      }
    }
  BOOST_TEST_MESSAGE(forbidden << " forbidden, " << confirmed << " confirmed, " << inseparable);
  BOOST_TEST(forbidden > 5);
  BOOST_TEST(confirmed > 3);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(connections)

BOOST_AUTO_TEST_CASE(forced_on_the_cube)
{
  const QL::T_mesh t = with_surface(hand_made::cube());
  const auto np = parameters::maximum_displacement(0.5).target_edge_length(1).minimum_valence(2);
  const QL::Quantization q = QL::quantize(t, np.forced_connections(Pairs{{6, 7}}));
  BOOST_TEST(q.arc_length[3] > 0);
  // no trace of one corner meets one of the opposite corner
  BOOST_CHECK_THROW(QL::quantize(t, np.forced_connections(Pairs{{0, 7}})),
                    QL::Unsatisfiable_demand);
}

BOOST_AUTO_TEST_CASE(forced_ones_are_made)
{
  int forced = 0, confirmed = 0, impossible = 0;
  for (const Case& c : cases())
    for (const auto& pair : c.displacement == 1 ? Pairs() : pairs_of_singularities(c.t_mesh))
      BOOST_TEST_CONTEXT(c.name << ", vertices " << pair.first << " and " << pair.second)
      {
        const auto np = parameters_of(c).forced_connections(Pairs{pair});
        try {
          const QL::Quantization q = QL::quantize(c.t_mesh, np);
          if (q.status == QL::Quantization::INFEASIBLE) {
            BOOST_TEST(is_infeasible(c, np));
            ++impossible;
            continue;
          }
          ++forced;
          confirmed += check(c, q, np);
        } catch (const QL::Unsatisfiable_demand& error) {
          const std::string message = error.what();
          BOOST_TEST(message.find(std::to_string(pair.first)) != std::string::npos);
          BOOST_TEST(message.find(std::to_string(pair.second)) != std::string::npos);
          ++impossible;
        }
      }
  BOOST_TEST_MESSAGE(forced << " forced, " << confirmed << " confirmed, " << impossible);
  BOOST_TEST(forced > 5);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(weights)

// The same factor everywhere is one of the objective; one of the directions of the cube is dearer.
BOOST_AUTO_TEST_CASE(are_factors_of_the_objective)
{
  const QL::T_mesh t = with_surface(hand_made::cube());
  const auto np = parameters::maximum_displacement(0).target_edge_length(1);
  std::vector<double> weights(12, 3.);
  BOOST_TEST(QL::quantize(t, np.arc_weight_map(CGAL::make_property_map(weights))).objective == 36);
  weights.assign(12, 1.);
  weights[0] = weights[1] = 5;
  BOOST_TEST(QL::quantize(t, np.arc_weight_map(CGAL::make_property_map(weights))).objective == 20);
}

BOOST_AUTO_TEST_CASE(of_faces_are_means_beside_arcs)
{
  generated::Mesh mesh = generated::slab_with_holes(1, 3);
  const QL::T_mesh t = QL::trace_motorcycle_graph(QL::compute_cross_field(mesh));
  using Face = generated::Mesh::Face_index;
  auto weight = mesh.add_property_map<Face, double>("f:weight", 4.).first;
  for (const double w : QL::arc_weights(t, mesh, weight))
    BOOST_TEST(w == 4, boost::test_tools::tolerance(1e-9));

  const auto is_far = [&](const QL::T_mesh::Point& p) { return p.x() > 1.5; };
  for (const Face f : faces(mesh))
    weight[f] = is_far(t.surface().point(t.surface().source(3 * int(f)))) ? 1 : 9;
  const std::vector<double> weights = QL::arc_weights(t, mesh, weight);
  BOOST_TEST(*std::min_element(weights.begin(), weights.end()) >= 1 - 1e-9);
  BOOST_TEST(*std::max_element(weights.begin(), weights.end()) <= 9 + 1e-9);
  int mixed = 0;
  for (const double w : weights)
    mixed += w > 1.001 && w < 8.999;
  BOOST_TEST(mixed > 0);
  BOOST_TEST(mixed < int(weights.size()));
}

// Along the border and feature curves as well; faces with several fixed edges are split.
BOOST_AUTO_TEST_CASE(of_faces_beside_fixed_edges)
{
  using Face = generated::Mesh::Face_index;
  generated::Mesh plate = generated::plate_with_holes(3, 3, {{1, 1}}, 2), cube = generated::cube(1);
  for (generated::Mesh* mesh : {&plate, &cube}) {
    const auto is_feature =
        mesh->add_property_map<generated::Mesh::Edge_index, bool>("e:feature", true).first;
    auto field_parameters = parameters::edge_is_constrained_map(is_feature);
    const QL::T_mesh t = QL::trace_motorcycle_graph(
        QL::compute_cross_field(*mesh, field_parameters));
    BOOST_TEST(t.surface().number_of_faces() > int(num_faces(*mesh)));
    auto weight = mesh->add_property_map<Face, double>("f:weight", 4.).first;
    for (const double w : QL::arc_weights(t, *mesh, weight))
      BOOST_TEST(w == 4, boost::test_tools::tolerance(1e-9));

    std::vector<double> face_weight;
    for (const Face f : faces(*mesh))
      face_weight.push_back(1 + int(f));
    const auto lengths = internal::Weights_along_arcs(t, face_weight).lengths();
    double sum = 0, expected = 0;
    for (int a = 0; a < t.number_of_edges(); ++a)
      sum += t.is_fixed(a) ? lengths[a] : 0;
    const QL::T_mesh::Surface& surface = t.surface();
    for (int h = 0; h < surface.number_of_halfedges(); ++h)
      if (surface.is_fixed(h))
        expected += surface.length(h) * face_weight[surface.origin(h / 3)] /
                    (surface.is_border(h) ? 1 : 2);
    BOOST_TEST(sum == expected, boost::test_tools::tolerance(1e-9));
  }
}

// The objective with weights is the least of all with weights.
BOOST_AUTO_TEST_CASE(make_what_is_dear_rare)
{
  int changed = 0;
  for (const Case& c : cases()) {
    const QL::Quantization plain = QL::quantize(c.t_mesh, parameters_of(c));
    std::vector<double> weights(c.t_mesh.number_of_edges(), 1.);
    for (std::size_t a = 0; a < weights.size(); ++a)
      weights[a] = plain.arc_length[a] > 0 ? 9 : 1;
    const QL::Quantization other = QL::quantize(
        c.t_mesh, parameters_of(c).arc_weight_map(CGAL::make_property_map(weights)));
    if (plain.status != QL::Quantization::OPTIMAL || plain.violated + other.violated > 0)
      continue;
    BOOST_TEST(other.objective <= 9 * plain.objective * (1 + 1e-9));
    changed += other.objective < 9 * plain.objective * (1 - 1e-9);
  }
  BOOST_TEST(changed > 0);
}

BOOST_AUTO_TEST_CASE(must_be_positive)
{
  const QL::T_mesh t = with_surface(hand_made::cube());
  const std::vector<double> weights(12, 0.);
  BOOST_CHECK_THROW(QL::quantize(t, parameters::target_edge_length(1).arc_weight_map(
                                        CGAL::make_property_map(weights))),
                    QL::Invalid_parameter);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(symmetry)

namespace {

// the vertex at the place that `image` gives for that of each vertex
template <class Image>
std::vector<int> images(const QL::T_mesh::Surface& surface, Image&& image)
{
  std::vector<int> result;
  const int n = surface.original().number_of_vertices();
  for (int v = 0; v < n; ++v)
    for (int w = 0; w < n; ++w)
      if ((surface.point(w) - image(surface.point(v))).norm() < 1e-9)
        result.push_back(w);
  return result;
}

using Point = QL::T_mesh::Point;

// symmetries of the unit cube and its triangles
Point inverted(const Point& p)
{
  return Point(1, 1, 1) - p;
}
Point swapped(const Point& p)
{
  return {p.y(), p.x(), p.z()};
}
Point rotated(const Point& p)
{
  return {p.y(), p.z(), p.x()};
}

// a field on the cube at random, but symmetric under inversion
QL::Cross_field symmetric_field(int n, unsigned seed)
{
  const auto surface = generated::surface_of(generated::cube(n));
  const internal::Surface_symmetry symmetry(*surface, images(*surface, inverted));
  std::mt19937 random(seed);
  const auto coordinate = [&] { return double(random() % 1000) - 499.5; };
  std::vector<Eigen::Vector3d> vectors(surface->number_of_faces());
  for (int f = 0; f < surface->number_of_faces(); ++f) {
    const int g = symmetry.corner_image(3 * f) / 3;
    const double x = coordinate(), y = coordinate(), z = coordinate();
    vectors[f] = g < f ? Eigen::Vector3d(-vectors[g]) : Eigen::Vector3d(x, y, z);
  }
  return internal::given_cross_field(surface, vectors);
}

} // namespace

BOOST_AUTO_TEST_CASE(of_a_surface)
{
  const auto surface = generated::surface_of(generated::cube(2));
  const auto turned_over = [&](const std::vector<int>& vertex_image) {
    const internal::Surface_symmetry symmetry(*surface, vertex_image);
    int result = 0;
    for (int h = 0; h < surface->number_of_halfedges(); ++h) {
      const int g = symmetry.corner_image(h);
      BOOST_TEST(surface->source(g) == vertex_image[surface->source(h)]);
      result += symmetry.turns_over(h / 3);
    }
    return result;
  };
  BOOST_TEST(turned_over(images(*surface, inverted)) == surface->number_of_halfedges());
  BOOST_TEST(turned_over(images(*surface, swapped)) == surface->number_of_halfedges());
  BOOST_TEST(turned_over(images(*surface, rotated)) == 0);
}

BOOST_AUTO_TEST_CASE(must_map_faces_to_faces)
{
  const QL::T_mesh t = QL::trace_motorcycle_graph(QL::compute_cross_field(generated::cube(2)));
  std::vector<int> no_permutation(t.surface().number_of_vertices(), 0);
  BOOST_CHECK_THROW(QL::quantize(t, parameters::vertex_symmetry(no_permutation)),
                    QL::Invalid_parameter);
  // its diagonals are not
  const auto mirror = images(t.surface(),
                             [](const Point& p) { return Point(1 - p.x(), p.y(), p.z()); });
  BOOST_CHECK_THROW(QL::quantize(t, parameters::vertex_symmetry(mirror)), QL::Invalid_parameter);
}

// Where field and surface are symmetric, so are most traces. Weights at random make the best
// quantization asymmetric; with the symmetry asked for it is the best of the symmetric ones.
BOOST_AUTO_TEST_CASE(of_quantizations)
{
  int asymmetric = 0, confirmed = 0, arcs = 0, mirrored = 0;
  for (unsigned seed = 1; seed <= 16; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const QL::Cross_field field = symmetric_field(1, seed);
      const double h = 0.1 * field.surface().diagonal(), r = 3;
      const auto tracing =
          parameters::maximum_deviation(40.).maximum_displacement(r).target_edge_length(h);
      const Case c{"", QL::trace_motorcycle_graph(field, tracing), r, h};
      std::mt19937 random(seed);
      std::vector<double> weights;
      for (int a = 0; a < c.t_mesh.number_of_edges(); ++a)
        weights.push_back(1 + random() % 50);
      const auto weighted = parameters_of(c).arc_weight_map(CGAL::make_property_map(weights));
      const auto np = weighted.vertex_symmetry(images(field.surface(), inverted));
      const auto program = program_of(c, np);
      for (const auto& e : program.mirrored)
        mirrored += int(e.left.size() + e.right.size());
      arcs += c.t_mesh.number_of_edges();
      const QL::Quantization q = QL::quantize(c.t_mesh, np);
      const QL::Quantization free = QL::quantize(c.t_mesh, weighted);
      if (q.status == QL::Quantization::INFEASIBLE) {
        BOOST_TEST(is_infeasible(c, np));
        continue;
      }
      BOOST_TEST(q.objective >= free.bound * (1 - 1e-9));
      asymmetric += !internal::grants_wishes(program, free.arc_length);
      confirmed += check(c, q, np);
    }
  BOOST_TEST_MESSAGE(asymmetric << " asymmetric, " << confirmed << " confirmed");
  BOOST_TEST(asymmetric > 0);
  BOOST_TEST(mirrored > 0.8 * arcs);
  BOOST_TEST(confirmed > 3);
}

// At the border, and with vertices added where faces are divided.
BOOST_AUTO_TEST_CASE(of_surfaces_with_fixed_edges)
{
  using Edge = generated::Mesh::Edge_index;
  generated::Mesh plate = generated::plate_with_holes(3, 3, {{1, 1}}, 2), cube = generated::cube(1);
  const auto check_symmetry = [](const QL::Cross_field& field, const auto& image) {
    const QL::T_mesh t = QL::trace_motorcycle_graph(field);
    const auto np = parameters::vertex_symmetry(images(t.surface(), image));
    const Case c{"", t, 2, 0.01 * t.surface().diagonal()};
    const auto program = program_of(c, np);
    BOOST_TEST(program.mirrored.size() > 0);
    const QL::Quantization q = QL::quantize(t, np);
    BOOST_REQUIRE((q.status != QL::Quantization::INFEASIBLE));
    BOOST_TEST(internal::grants_wishes(program, q.arc_length));
  };
  const QL::Cross_field on_plate = QL::compute_cross_field(plate);
  check_symmetry(on_plate, [](const Point& p) -> Point { return Point(3, 3, 0) - p; });
  check_symmetry(on_plate, [](const Point& p) { return Point(p.y(), p.x(), 0); });

  auto is_feature = cube.add_property_map<Edge, bool>("e:feature", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(cube, 40, is_feature);
  const QL::Cross_field on_cube = QL::compute_cross_field(
      cube, parameters::edge_is_constrained_map(is_feature));
  BOOST_TEST(on_cube.surface().number_of_vertices() == 8 + 6 + 24);
  check_symmetry(on_cube, inverted);
  check_symmetry(on_cube, rotated);
  const auto moves_diagonals = [](const Point& p) { return Point(1 - p.x(), p.y(), p.z()); };
  BOOST_CHECK_THROW(check_symmetry(on_cube, moves_diagonals), QL::Invalid_parameter);
}

// In each side of a tetrahedron with fixed edges a singularity lies on a vertex that was added. The
// sides of the cube are divided in several ways that are equally good, and so not all alike.
BOOST_AUTO_TEST_CASE(of_divided_faces)
{
  generated::Mesh tetrahedron = generated::tetrahedron(), cube = generated::cube(1);
  for (generated::Mesh* mesh : {&tetrahedron, &cube}) {
    const auto is_feature =
        mesh->add_property_map<generated::Mesh::Edge_index, bool>("e:feature", true).first;
    const QL::T_mesh t = QL::trace_motorcycle_graph(QL::compute_cross_field(
        *mesh, parameters::default_values().edge_is_constrained_map(is_feature)));
    const QL::T_mesh::Surface& surface = t.surface();
    const int n = int(num_vertices(*mesh));
    const std::vector<int> vertex_image = mesh == &cube ? images(surface, rotated)
                                                        : std::vector<int>{0, 2, 3, 1};
    const internal::Surface_symmetry symmetry(surface, vertex_image);
    int added = 0;
    for (int node = 0; node < t.number_of_vertices(); ++node)
      if (const int v = t.surface_vertex(node); v >= n) {
        ++added;
        BOOST_TEST_REQUIRE(symmetry.vertex_image(v) >= n);
      }
    BOOST_TEST(added > 0);
    const Case c{"", t, 2, 0.01 * surface.diagonal()};
    std::set<int> mirrored;
    for (const auto& e : program_of(c, parameters::vertex_symmetry(vertex_image)).mirrored) {
      mirrored.insert(e.left.begin(), e.left.end());
      mirrored.insert(e.right.begin(), e.right.end());
    }
    BOOST_TEST(int(mirrored.size()) > 0.75 * t.number_of_edges());
  }
}

// The program for other solvers has the wishes, and solutions that do not are refused.
BOOST_AUTO_TEST_CASE(of_what_is_written_and_read)
{
  const QL::T_mesh t = with_surface(hand_made::cube());
  const auto np = parameters::maximum_displacement(0.5).target_edge_length(1).minimum_valence(2);
  const auto wished = np.forbidden_merges(Pairs{{0, 1}});
  std::ostringstream plain, program;
  QL::IO::write_quantization_program(plain, t, np);
  QL::IO::write_quantization_program(program, t, wished);
  BOOST_TEST(program.str().size() > plain.str().size());
  std::istringstream merged("x1 1\nx2 1\n"), separate("x0 1\nx1 1\n"), again("x1 1\nx2 1\n");
  BOOST_TEST(QL::IO::read_quantization(merged, t, np).objective == 8);
  BOOST_TEST(QL::IO::read_quantization(separate, t, wished).objective == 8);
  BOOST_CHECK_THROW(QL::IO::read_quantization(again, t, wished), QL::Stage_failure);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
