// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TEST_ALL_STAGES_H
#define CGAL_QUAD_LAYOUTS_TEST_ALL_STAGES_H

#include "generated_meshes.h"
#include "invariants.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/compute_t_mesh.h>
#include <CGAL/Quad_layouts/embed_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/extract_smooth_quad_mesh.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_tree.h>
#include <CGAL/Quad_layouts/measure_quad_layout.h>
#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/quantize.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

// Runs a mesh through all stages, and verifies after each one what must always hold.
namespace all_stages {

namespace QL = CGAL::Quad_layouts;
using generated::Mesh;
using invariants::violations;

// what to do with a mesh
struct Task
{
  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;
  std::vector<Eigen::Vector3d> directions; // a field of its own, or empty
  QL::Layout_route route = QL::AUTOMATIC;
  double curvature_alignment = 0.07;
  double sharp_angle = 180; // of the features
  double deviation = 15;
  double displacement = 2;
  double edge_length = 0.05; // of the diagonal
  int minimum_valence = 3;
  int maximum_valence = 8;
  double seconds = 1;     // for what is the better the longer it takes: search and smoothing
  double time_limit = 30; // of each of the other stages

  explicit Task(Mesh m) : mesh(std::move(m))
  {
    is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  }
};

// what becomes of it
struct Results
{
  QL::Cross_field field;
  QL::T_mesh t_mesh;
  QL::Quantization quantization;
  QL::Quad_layout layout;
  QL::Integer_grid_map map;
  Mesh quads;
  Mesh::Property_map<Mesh::Edge_index, bool> on_curve; // of edges of `quads`
};

inline int number_of_borders(const Mesh& mesh)
{
  std::vector<Mesh::Halfedge_index> cycles;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  return int(cycles.size());
}

inline void check_field(const QL::Cross_field& field)
{
  BOOST_TEST(field.index_sum() == 4 * invariants::euler_characteristic(field.surface()));
  const int faces = field.surface().number_of_faces();
  BOOST_TEST(violations(faces, [&](int f) { return std::isfinite(field.angle(f)); }) == 0);
}

inline int number_of_singularities(const QL::T_mesh& t, const QL::Quad_layout::Cluster& cluster)
{
  return int(std::count_if(cluster.nodes.begin(), cluster.nodes.end(),
                           [&](int n) { return t.index(n) != 0; }));
}

// Constraints that no quantization satisfies are given up; those that are kept hold.
inline void check_clusters(const Task& task, const Results& r)
{
  const int nc = int(r.layout.clusters.size());
  const auto is_merged = [&](const QL::Quad_layout::Cluster& c) {
    return number_of_singularities(r.t_mesh, c) > 1;
  };
  if (r.quantization.violated > 0)
    return;
  BOOST_TEST(violations(nc, [&](int i) {
               const QL::Quad_layout::Cluster& c = r.layout.clusters[i];
               if (!is_merged(c))
                 return true;
               int low = 4 - task.maximum_valence, high = 4 - task.minimum_valence;
               for (const int n : c.nodes) {
                 low = (std::min)(low, r.t_mesh.index(n));
                 high = (std::max)(high, r.t_mesh.index(n));
               }
               return task.displacement > 0 && low <= c.index && c.index <= high;
             }) == 0);
}

// the layout is a manifold without T-joints, of the topology of the surface
inline void check_layout(const QL::T_mesh& t, const QL::Quad_layout& layout)
{
  invariants::check_halfedge_complex(layout);
  BOOST_TEST(layout.euler_characteristic() == t.euler_characteristic());
  BOOST_TEST(invariants::number_of_borders(layout) == invariants::number_of_borders(t));
  int index_sum = 0;
  for (int v = 0; v < layout.number_of_vertices(); ++v)
    index_sum += layout.index(v);
  BOOST_TEST(index_sum == 4 * t.euler_characteristic());
  BOOST_TEST(QL::measure_quad_layout(layout).t_junctions == 0);
}

inline double orientation(const QL::Integer_grid_map& map, int f)
{
  const Eigen::Vector2d a = map.coordinates(3 * f + 1) - map.coordinates(3 * f);
  const Eigen::Vector2d b = map.coordinates(3 * f + 2) - map.coordinates(3 * f);
  return a.x() * b.y() - a.y() * b.x();
}

// the sum of the angles around each vertex, in quarter-turns
inline std::vector<double> angle_sums(const QL::Integer_grid_map& map)
{
  using Surface = QL::Integer_grid_map::Surface;
  std::vector<double> sum(map.surface().number_of_vertices(), 0);
  for (int h = 0; h < map.surface().number_of_halfedges(); ++h) {
    const Eigen::Vector2d a = map.coordinates(Surface::next(h)) - map.coordinates(h);
    const Eigen::Vector2d b = map.coordinates(Surface::prev(h)) - map.coordinates(h);
    sum[map.surface().source(h)] += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) /
                                    std::atan2(1, 0);
  }
  return sum;
}

// the map is injective near each point, but for irregular vertices, and continuous across edges
inline void check_map(const QL::Integer_grid_map& map, const QL::Quad_layout& layout)
{
  using Surface = QL::Integer_grid_map::Surface;
  const Surface& surface = map.surface();
  BOOST_TEST(map.inverted == 0);
  BOOST_TEST(map.wrong_winding == 0);
  BOOST_TEST(
      violations(surface.number_of_faces(), [&](int f) { return orientation(map, f) > 0; }) == 0);
  BOOST_TEST(
      violations(surface.number_of_halfedges(), [&](int h) {
        const int twin = surface.opposite(h);
        return twin < 0 ||
               (map.transition(h)(map.coordinates(h)) == map.coordinates(Surface::next(twin)) &&
                map.transition(h)(map.coordinates(Surface::next(h))) == map.coordinates(twin));
      }) == 0);
  std::map<int, int> index; // of the anchored vertices
  for (const QL::Integer_grid_map::Anchor& a : map.anchors)
    index[surface.source(a.corner)] = layout.index(layout.source(a.layout_halfedge));
  const std::vector<double> sums = angle_sums(map);
  BOOST_TEST(violations(surface.number_of_vertices(), [&](int v) {
               const int h = surface.halfedge(v);
               const auto anchored = index.find(v);
               return h < 0 || std::abs(sums[v] - (surface.is_border(h) ? 2 : 4) +
                                        (anchored == index.end() ? 0 : anchored->second)) < 1e-4;
             }) == 0);
}

// the quad mesh has the topology of the surface and the patches of the layout, and lies on the
// surface
inline void check_quads(const Task& task, const Results& r)
{
  BOOST_TEST_REQUIRE(CGAL::is_valid_polygon_mesh(r.quads));
  const QL::Quad_mesh_measures in = QL::measure_quad_mesh(task.mesh);
  const QL::Quad_mesh_measures out = QL::measure_quad_mesh(
      r.quads, QL::parameters::default_values().edge_is_constrained_map(r.on_curve));
  BOOST_TEST(out.non_quads == 0);
  BOOST_TEST(out.euler_characteristic == in.euler_characteristic);
  BOOST_TEST(out.components == in.components);
  BOOST_TEST(number_of_borders(r.quads) == number_of_borders(task.mesh));
  BOOST_TEST(out.t_junctions == 0);
  BOOST_TEST(out.patches == r.layout.number_of_patches);
  BOOST_TEST(out.irregular_vertices == r.layout.number_of_irregular_vertices());

  const auto& surface = r.field.surface();
  std::vector<QL::internal::Triangle_tree::Corners> triangles;
  for (int h = 0; h < surface.number_of_halfedges(); h += 3)
    triangles.push_back({surface.point(surface.source(h)), surface.point(surface.source(h + 1)),
                         surface.point(surface.source(h + 2))});
  const QL::internal::Triangle_tree tree(triangles);
  double extent = 0;
  for (const auto& p : surface.points())
    extent = (std::max)(extent, p.norm());
  int far = 0;
  for (const auto v : vertices(r.quads)) {
    const auto& p = r.quads.point(v);
    far += !(tree.distance({p.x(), p.y(), p.z()}) < 1e-9 * extent);
  }
  BOOST_TEST(far == 0);
}

template <class NamedParameters>
QL::Cross_field field_of(Task& task, const NamedParameters& np)
{
  if (task.directions.empty())
    return QL::compute_cross_field(task.mesh, np);
  auto map = task.mesh.add_property_map<Mesh::Face_index, generated::Vector>("f:direction").first;
  for (const auto f : faces(task.mesh)) {
    const Eigen::Vector3d& d = task.directions[f];
    map[f] = generated::Vector(d.x(), d.y(), d.z());
  }
  return QL::compute_cross_field(task.mesh, np.face_direction_map(map));
}

inline double diagonal(const Mesh& mesh)
{
  return QL::internal::make_triangle_surface(mesh, mesh.points()).diagonal();
}

// Runs all stages. Says if there is a layout: there is none where no quantization is valid.
inline bool run(Task& task, Results& r)
{
  const auto np = QL::parameters::maximum_deviation(task.deviation)
                      .maximum_displacement(task.displacement)
                      .target_edge_length(task.edge_length * diagonal(task.mesh))
                      .minimum_valence(task.minimum_valence)
                      .maximum_valence(task.maximum_valence)
                      .layout_route(task.route)
                      .maximum_running_time(task.time_limit);
  r.field = field_of(
      task,
      np.edge_is_constrained_map(task.is_feature).curvature_alignment(task.curvature_alignment));
  check_field(r.field);
  r.t_mesh = QL::compute_t_mesh(r.field, np);
  invariants::check_t_mesh(r.t_mesh);
  r.quantization = QL::quantize(r.t_mesh, np.maximum_running_time(task.seconds));
  if (r.quantization.status == QL::Quantization::INFEASIBLE)
    return false;
  BOOST_TEST(r.quantization.bound <= r.quantization.objective * (1 + 1e-9));
  r.layout = QL::extract_quad_layout(r.t_mesh, r.quantization);
  check_layout(r.t_mesh, r.layout);
  check_clusters(task, r);
  r.map = QL::embed_quad_layout(r.t_mesh, r.layout, np);
  check_map(r.map, r.layout);
  r.on_curve = r.quads.add_property_map<Mesh::Edge_index, bool>("e:on_curve").first;
  QL::extract_smooth_quad_mesh(
      r.map, r.layout, task.mesh, r.quads,
      QL::parameters::edge_is_constrained_map(r.on_curve).maximum_running_time(task.seconds),
      QL::parameters::edge_is_constrained_map(task.is_feature));
  check_quads(task, r);
  return true;
}

} // namespace all_stages

#endif // CGAL_QUAD_LAYOUTS_TEST_ALL_STAGES_H
