// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TEST_GENERATED_QUAD_MESHES_H
#define CGAL_QUAD_LAYOUTS_TEST_GENERATED_QUAD_MESHES_H

#include "generated_meshes.h"

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

// Quad meshes made by code, outward oriented.
namespace generated {

inline Mesh mesh_of_polygons(const std::vector<Point>& points,
                             const std::vector<std::vector<int>>& polygons)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Point& p : points)
    vertices.push_back(mesh.add_vertex(p));
  for (const auto& polygon : polygons) {
    std::vector<Mesh::Vertex_index> corners;
    for (const int v : polygon)
      corners.push_back(vertices[v]);
    const auto face = mesh.add_face(corners);
    CGAL_assertion(face != Mesh::null_face());
    CGAL_USE(face);
  }
  return mesh;
}

// the box from (-x, -y, -z) to (x, y, z), with n[0] x n[1] x n[2] layers of quads
inline Mesh quad_box(const std::array<int, 3>& n, double x = 1, double y = 1, double z = 1)
{
  const std::array<double, 3> size = {x, y, z};
  std::map<Cell, int> number_of_corner;
  std::vector<Point> points;
  std::vector<std::vector<int>> quads;
  const auto corner = [&](const Cell& c) {
    const auto [position, is_new] = number_of_corner.try_emplace(c, int(points.size()));
    if (is_new)
      points.emplace_back(size[0] * (2. * c[0] / n[0] - 1), size[1] * (2. * c[1] / n[1] - 1),
                          size[2] * (2. * c[2] / n[2] - 1));
    return position->second;
  };
  for (int a = 0; a < 3; ++a)
    for (const int side : {0, n[a]})
      for (int i = 0; i < n[(a + 1) % 3]; ++i)
        for (int j = 0; j < n[(a + 2) % 3]; ++j) {
          std::vector<int> quad;
          for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
            Cell c;
            c[a] = side;
            c[(a + 1) % 3] = i + di;
            c[(a + 2) % 3] = j + dj;
            quad.push_back(corner(c));
          }
          if (side == 0)
            std::swap(quad[1], quad[3]);
          quads.push_back(quad);
        }
  return mesh_of_polygons(points, quads);
}

// the cube of n x n x n layers, with its points moved from the centre to the unit sphere
inline Mesh quad_sphere(int n)
{
  Mesh mesh = quad_box({n, n, n});
  for (const auto v : vertices(mesh)) {
    const Vector x = mesh.point(v) - CGAL::ORIGIN;
    mesh.point(v) = CGAL::ORIGIN + x / std::sqrt(x.squared_length());
  }
  return mesh;
}

// a torus with `nu` rings of `nv` vertices, closed or, as a tube, cut along a ring
inline Mesh quad_torus(int nu, int nv, bool closed = true)
{
  std::vector<Point> points;
  std::vector<std::vector<int>> quads;
  const int rings = closed ? nu : nu + 1;
  const auto vertex = [&](int i, int j) { return (i % rings) * nv + j % nv; };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < nv; ++j) {
      const double u = (closed ? 2 : 1) * CGAL_PI * i / nu, v = 2 * CGAL_PI * j / nv,
                   r = 3 + std::cos(v);
      points.emplace_back(r * std::cos(u), r * std::sin(u), std::sin(v));
    }
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j)
      quads.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
  return mesh_of_polygons(points, quads);
}

inline Mesh triangulated(Mesh mesh)
{
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

} // namespace generated

#endif // CGAL_QUAD_LAYOUTS_TEST_GENERATED_QUAD_MESHES_H
