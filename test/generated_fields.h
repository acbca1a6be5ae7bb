// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TEST_GENERATED_FIELDS_H
#define CGAL_QUAD_LAYOUTS_TEST_GENERATED_FIELDS_H

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

// Cross fields that are known or bad.
namespace generated {

inline std::shared_ptr<const CGAL::Quad_layouts::internal::Triangle_surface> surface_of(
    const Mesh& mesh)
{
  using namespace CGAL::Quad_layouts::internal;
  return std::make_shared<const Triangle_surface>(
      separate_fixed_curves(make_triangle_surface(mesh, mesh.points())));
}

// the field with a direction in each face that is given as a function of the face's centre, turned
// by `angle(centre)`
template <class Direction, class Angle>
CGAL::Quad_layouts::Cross_field field_along(const Mesh& mesh, Direction direction, Angle angle)
{
  const auto surface = surface_of(mesh);
  std::vector<Eigen::Vector3d> vectors;
  for (int f = 0; f < surface->number_of_faces(); ++f) {
    Eigen::Vector3d center = Eigen::Vector3d::Zero();
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      center += surface->point(surface->source(h)) / 3;
    const Eigen::Vector3d n = surface->normal(f);
    Eigen::Vector3d u = direction(center);
    u = (u - n * n.dot(u)).normalized();
    vectors.push_back(std::cos(angle(center)) * u + std::sin(angle(center)) * n.cross(u));
  }
  return CGAL::Quad_layouts::internal::given_cross_field(surface, vectors);
}

// a direction at random in each face
inline CGAL::Quad_layouts::Cross_field random_field(const Mesh& mesh, unsigned seed)
{
  const auto surface = surface_of(mesh);
  std::mt19937 random(seed);
  std::vector<Eigen::Vector3d> vectors;
  for (int f = 0; f < surface->number_of_faces(); ++f)
    vectors.push_back(surface->direction(f, 2 * CGAL_PI * random() / double(random.max())));
  return CGAL::Quad_layouts::internal::given_cross_field(surface, vectors);
}

// On a ring with four sharp edges all around, a fixed edge leaves one of these under an acute
// angle. With its indices, the field has no locally injective map.
inline CGAL::Quad_layouts::Cross_field field_without_map()
{
  namespace QL = CGAL::Quad_layouts;
  constexpr int per_side = 4, n = 16;
  Mesh mesh = square_ring(n, per_side);
  const auto is_fixed = mesh.add_property_map<Mesh::Edge_index, bool>("e:fixed", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 60, is_fixed);
  const auto leaving = mesh.halfedge(Mesh::Vertex_index(0), Mesh::Vertex_index(4 * per_side + 1));
  is_fixed[mesh.edge(leaving)] = true;
  return QL::compute_cross_field(
      mesh, QL::parameters::default_values().edge_is_constrained_map(is_fixed));
}

} // namespace generated

#endif // CGAL_QUAD_LAYOUTS_TEST_GENERATED_FIELDS_H
