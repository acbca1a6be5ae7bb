// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_DISTANCE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_DISTANCE_H

#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_tree.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// adds the fan of triangles of face f about its corner `apex`
inline void append_fan(const Polygons& mesh, int f, int apex,
                       std::vector<Triangle_tree::Corners>& triangles)
{
  const int n = mesh.degree(f);
  const auto point = [&](int k) -> const Eigen::Vector3d& {
    return mesh.points[mesh.source[mesh.first_halfedge[f] + (apex + k) % n]];
  };
  for (int k = 1; k + 1 < n; ++k)
    triangles.push_back({point(0), point(k), point(k + 1)});
}

// the faces as triangles, quads being split at the shorter diagonal; `owner` gets the face of each
inline std::vector<Triangle_tree::Corners> triangulated(const Polygons& mesh,
                                                        std::vector<int>& owner)
{
  std::vector<Triangle_tree::Corners> result;
  owner.clear();
  for (int f = 0; f < mesh.number_of_faces(); ++f) {
    const bool other_diagonal = mesh.degree(f) == 4 &&
                                (mesh.corner_point(f, 3) - mesh.corner_point(f, 1)).norm() <
                                    (mesh.corner_point(f, 2) - mesh.corner_point(f, 0)).norm();
    append_fan(mesh, f, other_diagonal ? 1 : 0, result);
    owner.resize(result.size(), f);
  }
  return result;
}

inline Eigen::Vector3d area_vector(const Triangle_tree::Corners& t)
{
  return (t[1] - t[0]).cross(t[2] - t[0]);
}

// The distance from one mesh to another.
struct Deviation
{
  double maximum = 0;
  double mean = 0; // over the area
};

// measures at the corners and the centroids of `triangles`
inline Deviation deviation(const std::vector<Triangle_tree::Corners>& triangles,
                           const Polygons& mesh, const Triangle_tree& other)
{
  Deviation result;
  double sum = 0, weight = 0;
  for (const Triangle_tree::Corners& t : triangles) {
    const double area = area_vector(t).norm(), d = other.distance((t[0] + t[1] + t[2]) / 3);
    result.maximum = (std::max)(result.maximum, d);
    sum += area * d;
    weight += area;
  }
  result.mean = weight > 0 ? sum / weight : 0;
  std::vector<char> used(mesh.number_of_vertices(), 0);
  for (const int v : mesh.source)
    if (!std::exchange(used[v], 1))
      result.maximum = (std::max)(result.maximum, other.distance(mesh.points[v]));
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_DISTANCE_H
