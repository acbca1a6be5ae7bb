// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TEST_INVARIANTS_H
#define CGAL_QUAD_LAYOUTS_TEST_INVARIANTS_H

#include <CGAL/Quad_layouts/Halfedge_complex.h>
#include <CGAL/Quad_layouts/T_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <utility>
#include <vector>

// What must always hold of the results of the stages, verified without the code that made them.
namespace invariants {

using CGAL::Quad_layouts::Halfedge_complex;
using CGAL::Quad_layouts::T_mesh;

// returns how many of the numbers 0, ..., n-1 do not satisfy a predicate
template <class Predicate>
int violations(int n, Predicate&& holds)
{
  int count = 0;
  for (int i = 0; i < n; ++i)
    count += !holds(i);
  return count;
}

inline int euler_characteristic(const T_mesh::Surface& surface)
{
  const int nv = surface.number_of_vertices();
  const int isolated = violations(nv, [&](int v) { return surface.halfedge(v) >= 0; });
  return nv - isolated - surface.number_of_edges() + surface.number_of_faces();
}

inline int number_of_borders(const Halfedge_complex& c)
{
  std::vector<char> is_known(c.number_of_halfedges(), 0);
  int result = 0;
  for (int h = 0; h < c.number_of_halfedges(); ++h) {
    if (is_known[h] || !c.is_border(h))
      continue;
    ++result;
    for (int g = h; !is_known[g]; g = c.next(g))
      is_known[g] = 1;
  }
  return result;
}

inline void check_halfedge_complex(const Halfedge_complex& c)
{
  const int nh = c.number_of_halfedges(), nv = c.number_of_vertices(), nf = c.number_of_faces();
  BOOST_TEST_REQUIRE(int(c.halfedge_next.size()) == nh);
  BOOST_TEST_REQUIRE(int(c.halfedge_face.size()) == nh);
  BOOST_TEST_REQUIRE(int(c.vertex_point.size()) == nv);
  std::vector<int> arrivals(nh, 0);
  for (int next : c.halfedge_next)
    ++arrivals[next];
  BOOST_TEST(violations(nh, [&](int h) { return arrivals[h] == 1; }) == 0);
  BOOST_TEST(violations(nh, [&](int h) { return c.source(c.next(h)) == c.target(h); }) == 0);
  BOOST_TEST(violations(nh, [&](int h) { return c.face(c.next(h)) == c.face(h); }) == 0);
  BOOST_TEST(violations(nv, [&](int v) { return c.source(c.halfedge_from(v)) == v; }) == 0);
  BOOST_TEST(violations(nf, [&](int f) { return c.face(c.halfedge_of(f)) == f; }) == 0);
  BOOST_TEST(violations(nh, [&](int h) {
               const int v = c.source(h);
               return !c.is_border(Halfedge_complex::opposite(h)) || c.halfedge_from(v) == h;
             }) == 0);
  BOOST_TEST(violations(nh, [&](int h) { return !c.is_border(h) || !c.is_border(h ^ 1); }) == 0);
}

// returns the halfedges that leave v, counter-clockwise, from halfedge_from(v)
inline std::vector<int> outgoing(const Halfedge_complex& c, int v)
{
  std::vector<int> result;
  int h = c.halfedge_from(v);
  do {
    result.push_back(h);
    h = c.turn_right(h);
  } while (h != c.halfedge_from(v));
  std::reverse(result.begin() + 1, result.end());
  return result;
}

// returns the quarter-turns around node n: a patch has one at a corner, two where its side goes
// straight on
inline int quarter_turns(const T_mesh& t, int n)
{
  int sum = 0;
  for (int h : outgoing(t, n))
    if (!t.is_border(Halfedge_complex::opposite(h)))
      sum += t.is_corner(Halfedge_complex::opposite(h)) ? 1 : 2;
  return sum;
}

inline void check_patches(const T_mesh& t)
{
  const int np = t.number_of_faces();
  std::vector<int> corners(np, 0);
  std::vector<char> follows_corner(t.number_of_halfedges(), 0);
  for (int h = 0; h < t.number_of_halfedges(); ++h) {
    if (!t.is_border(h))
      corners[t.face(h)] += t.is_corner(h);
    follows_corner[t.next(h)] = t.is_corner(h);
  }
  BOOST_TEST(violations(np, [&](int p) { return corners[p] == 4; }) == 0);
  BOOST_TEST(violations(np, [&](int p) { return follows_corner[t.halfedge_of(p)] != 0; }) == 0);
  BOOST_TEST(t.euler_characteristic() == invariants::euler_characteristic(t.surface()));
}

inline void check_nodes(const T_mesh& t)
{
  const int nodes = t.number_of_vertices();
  int index_sum = 0;
  for (int n = 0; n < nodes; ++n)
    index_sum += t.index(n);
  BOOST_TEST(index_sum == 4 * invariants::euler_characteristic(t.surface()));
  BOOST_TEST(violations(nodes, [&](int n) {
               return quarter_turns(t, n) == (t.is_on_border(n) ? 2 : 4) - t.index(n);
             }) == 0);
  BOOST_TEST(violations(nodes, [&](int n) {
               return t.node_visits[n].size() == (t.is_singularity_or_seed(n) ? 0u : 2u);
             }) == 0);
}

// returns the halfedge that goes straight on after h
inline int straight_on(const T_mesh& t, int h)
{
  const int left = t.next(h);
  return t.is_corner(h) ? t.turn_right(left) : left;
}

inline void check_trace(const T_mesh& t, int i)
{
  const std::vector<int>& arcs = t.traces[i].arcs;
  BOOST_TEST_REQUIRE(!arcs.empty());
  BOOST_TEST(t.source(2 * arcs.front()) == t.traces[i].start);
  BOOST_TEST(t.is_singularity_or_seed(t.traces[i].start));
  const int last = int(arcs.size()) - 1;
  BOOST_TEST(
      violations(last, [&](int k) { return straight_on(t, 2 * arcs[k]) == 2 * arcs[k + 1]; }) == 0);
  BOOST_TEST(violations(last + 1, [&](int k) { return t.trace(arcs[k]) == i; }) == 0);
  const int end = t.target(2 * arcs.back());
  if (t.is_fixed(arcs.back())) {
    BOOST_TEST(t.is_singularity_or_seed(end));
    BOOST_TEST(violations(last + 1, [&](int k) { return t.is_fixed(arcs[k]); }) == 0);
  } else {
    BOOST_TEST(t.node_visits[end][1].trace == i);
    BOOST_TEST(t.node_visits[end][1].arcs == last + 1);
  }
}

// returns the length of a trace up to a visit
inline double length_until(const T_mesh& t, const T_mesh::Visit& visit)
{
  double sum = 0;
  for (int k = 0; k < visit.arcs; ++k)
    sum += t.length(t.traces[visit.trace].arcs[k]);
  return sum;
}

// Replays the stopping rule on the finished T-mesh: says if trace i ends exactly where it has met
// an acceptable candidate on both sides for the first time.
inline bool ends_by_the_rule(const T_mesh& t, int i, double tangent, double displacement)
{
  bool left = false, right = false;
  double own = 0;
  for (int a : t.traces[i].arcs) {
    own += t.length(a);
    const int n = t.target(2 * a);
    const T_mesh::Visit& first = t.node_visits[n][0];
    const T_mesh::Visit& second = t.node_visits[n][1];
    if (t.traces[second.trace].arcs[second.arcs - 1] != a)
      continue;
    if (left && right)
      return false;
    const double other = length_until(t, first);
    if (other - 2 * displacement <= tangent * (own + 2 * displacement))
      (t.next(2 * a) % 2 == 0 ? right : left) = true;
  }
  return left && right;
}

inline void check_stopping_rule(const T_mesh& t, double tangent, double displacement)
{
  BOOST_TEST(violations(int(t.traces.size()),
                        [&](int i) { return ends_by_the_rule(t, i, tangent, displacement); }) == 0);
}

// what rounding may make of coordinates and lengths
inline double tolerance_of(const T_mesh& t)
{
  double extent = 0;
  for (const Eigen::Vector3d& p : t.surface().points())
    extent = (std::max)(extent, p.norm());
  return 1e-9 * extent;
}

inline void check_visits(const T_mesh& t)
{
  const double tolerance = tolerance_of(t);
  BOOST_TEST(violations(t.number_of_vertices(), [&](int n) {
               for (const T_mesh::Visit& v : t.node_visits[n])
                 if (t.target(2 * t.traces[v.trace].arcs[v.arcs - 1]) != n)
                   return false;
               return t.node_visits[n].empty() || t.is_on_fixed_curve(n) ||
                      length_until(t, t.node_visits[n][0]) <=
                          length_until(t, t.node_visits[n][1]) + tolerance;
             }) == 0);
}

inline void check_lengths(const T_mesh& t)
{
  BOOST_TEST(violations(t.number_of_edges(), [&](int a) { return t.length(a) >= 0; }) == 0);
}

// In a parametrization opposite sides of patches are equal, to the last bit.
inline void check_opposite_sides(const T_mesh& t)
{
  const auto length = [&](const std::vector<int>& side) {
    double sum = 0;
    for (int h : side)
      sum += t.length(Halfedge_complex::edge(h));
    return sum;
  };
  BOOST_TEST(violations(t.number_of_faces(), [&](int p) {
               const auto sides = t.sides(p);
               return length(sides[0]) == length(sides[2]) && length(sides[1]) == length(sides[3]);
             }) == 0);
}

// No arc is shorter than the straight line. In needles, where rounding decides where chords cross,
// this need not hold.
inline void check_distances(const T_mesh& t)
{
  const double tolerance = tolerance_of(t);
  BOOST_TEST(violations(t.number_of_edges(), [&](int a) {
               return (t.point(t.target(2 * a)) - t.point(t.source(2 * a))).norm() <=
                      t.length(a) + tolerance;
             }) == 0);
}

// appends the patches left and entered on the way along the surface's halfedge h
inline void follow_edge(const T_mesh& t, int h, std::vector<std::pair<int, int>>& steps)
{
  const auto& surface = t.surface();
  const int e = surface.edge(h);
  const auto& crossings = t.edge_crossings[e];
  auto along = t.edge_arcs[e];
  if (surface.halfedge_of_edge(e) != h) {
    std::reverse(along.begin(), along.end());
    for (int& a : along)
      a = Halfedge_complex::opposite(a);
  }
  for (std::size_t i = 0; i < along.size(); ++i)
    steps.emplace_back(t.face(along[i == 0 ? 0 : i - 1]), t.face(along[i]));
  if (surface.halfedge_of_edge(e) == h)
    for (auto c = crossings.begin(); c != crossings.end(); ++c)
      steps.emplace_back(t.face(*c), t.face(*c ^ 1));
  else
    for (auto c = crossings.rbegin(); c != crossings.rend(); ++c)
      steps.emplace_back(t.face(*c ^ 1), t.face(*c));
}

// says if the patches on the way around face f follow each other without a gap
inline bool is_closed_walk(const T_mesh& t, int f)
{
  std::vector<std::pair<int, int>> steps;
  for (int h = 3 * f; h < 3 * f + 3; ++h) {
    const auto& arcs = t.corner_arcs[h];
    for (auto a = arcs.rbegin(); a != arcs.rend(); ++a)
      steps.emplace_back(t.face(*a), t.face(*a ^ 1));
    follow_edge(t, h, steps);
  }
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (steps[i].second != steps[(i + 1) % steps.size()].first)
      return false;
  return true;
}

// says if the arcs in the corners around node n are those that leave it, in the same cyclic order
inline bool leaves_through_corners(const T_mesh& t, int n)
{
  std::vector<int> in_corners, around = outgoing(t, n);
  t.surface().for_each_outgoing(t.surface_vertex(n), [&](int h) {
    in_corners.insert(in_corners.end(), t.corner_arcs[h].begin(), t.corner_arcs[h].end());
  });
  around.erase(std::remove_if(around.begin(), around.end(),
                              [&](int h) { return t.is_fixed(Halfedge_complex::edge(h)); }),
               around.end());
  if (in_corners.empty())
    return around.empty();
  const auto first = std::find(around.begin(), around.end(), in_corners.front());
  std::rotate(around.begin(), first, around.end());
  return in_corners == around;
}

inline void check_position_on_surface(const T_mesh& t)
{
  const int faces = t.surface().number_of_faces();
  BOOST_TEST_REQUIRE(int(t.edge_crossings.size()) == t.surface().number_of_edges());
  BOOST_TEST_REQUIRE(int(t.corner_arcs.size()) == t.surface().number_of_halfedges());
  BOOST_TEST(violations(faces, [&](int f) { return is_closed_walk(t, f); }) == 0);
  BOOST_TEST(violations(t.number_of_vertices(), [&](int n) {
               return !t.is_singularity_or_seed(n) || leaves_through_corners(t, n);
             }) == 0);
}

// every crossing of an arc and an edge is listed by both
inline void check_crossings(const T_mesh& t)
{
  int of_arcs = 0, of_edges = 0, wrong = 0;
  for (int a = 0; a < t.number_of_edges(); ++a)
    for (const T_mesh::Crossing& c : t.arc_crossings[a]) {
      ++of_arcs;
      wrong += T_mesh::edge(t.edge_crossings[t.surface().edge(c.halfedge)][c.position]) != a;
    }
  for (int e = 0; e < t.surface().number_of_edges(); ++e) {
    const std::vector<double>& parameters = t.crossing_parameters[e];
    of_edges += int(t.edge_crossings[e].size());
    const std::size_t nodes = t.edge_arcs[e].empty() ? 0 : t.edge_arcs[e].size() - 1;
    wrong += parameters.size() != t.edge_crossings[e].size() + nodes;
    wrong += !std::is_sorted(parameters.begin(), parameters.end());
  }
  BOOST_TEST(wrong == 0);
  BOOST_TEST(of_arcs == of_edges);
}

// checks that a traced T-mesh partitions its surface into four-cornered patches
inline void check_t_mesh(const T_mesh& t)
{
  check_crossings(t);
  check_halfedge_complex(t);
  check_patches(t);
  check_nodes(t);
  for (int i = 0; i < int(t.traces.size()); ++i)
    check_trace(t, i);
  check_visits(t);
  check_lengths(t);
  check_position_on_surface(t);
}

} // namespace invariants

#endif // CGAL_QUAD_LAYOUTS_TEST_INVARIANTS_H
