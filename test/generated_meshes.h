// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TEST_GENERATED_MESHES_H
#define CGAL_QUAD_LAYOUTS_TEST_GENERATED_MESHES_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

// Triangle meshes made by code: closed ones, outward oriented, and flat ones with borders.
namespace generated {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangle = std::array<int, 3>;
using Cell = std::array<int, 3>;

inline Mesh mesh_of(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Point& p : points)
    vertices.push_back(mesh.add_vertex(p));
  for (const Triangle& t : triangles) {
    const auto face = mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    CGAL_assertion(face != Mesh::null_face());
    CGAL_USE(face);
  }
  return mesh;
}

inline Mesh tetrahedron()
{
  return mesh_of({Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)},
                 {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

// The surface of a union of unit cubes, each of whose squares is split into n x n squares of two
// triangles. Cubes that meet in an edge or vertex only must be joined by others around it.
inline Mesh voxel_surface(const std::vector<Cell>& cells, int n)
{
  std::map<Cell, int> number_of_corner;
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  const auto corner = [&](const Cell& x) {
    const auto [position, is_new] = number_of_corner.try_emplace(x, int(points.size()));
    if (is_new)
      points.emplace_back(x[0] / double(n), x[1] / double(n), x[2] / double(n));
    return position->second;
  };
  const auto add_square = [&](const Cell& cell, int axis, int side) {
    // u and v are the other axes, so that u x v points out of the cube
    const int u = (axis + (side ? 1 : 2)) % 3, v = (axis + (side ? 2 : 1)) % 3;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const auto at = [&](int di, int dj) {
          Cell x = {n * cell[0], n * cell[1], n * cell[2]};
          x[axis] += n * side;
          x[u] += i + di;
          x[v] += j + dj;
          return corner(x);
        };
        triangles.push_back({at(0, 0), at(1, 0), at(1, 1)});
        triangles.push_back({at(0, 0), at(1, 1), at(0, 1)});
      }
  };
  for (const Cell& cell : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        Cell neighbor = cell;
        neighbor[axis] += 2 * side - 1;
        if (std::find(cells.begin(), cells.end(), neighbor) == cells.end())
          add_square(cell, axis, side);
      }
  return mesh_of(points, triangles);
}

// the unit cube, with 2 n^2 triangles on each side
inline Mesh cube(int n)
{
  return voxel_surface({{0, 0, 0}}, n);
}

// a slab with `genus` holes in a row, made of cubes
inline Mesh slab_with_holes(int genus, int n)
{
  std::vector<Cell> cells;
  for (int x = 0; x < 2 * genus + 1; ++x)
    for (int y = 0; y < 3; ++y)
      if (y != 1 || x % 2 == 0)
        cells.push_back({x, y, 0});
  return voxel_surface(cells, n);
}

// the unit sphere, with 20 * 4^level triangles
inline Mesh icosphere(int level)
{
  const double g = (1 + std::sqrt(5.)) / 2;
  std::vector<Vector> points = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                                {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                                {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
  std::vector<Triangle> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (; level > 0; --level) {
    std::map<std::pair<int, int>, int> number_of_midpoint;
    const auto midpoint = [&](int a, int b) {
      const auto [position, is_new] = number_of_midpoint.try_emplace(std::minmax(a, b),
                                                                     int(points.size()));
      if (is_new)
        points.push_back(points[a] + points[b]);
      return position->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : triangles) {
      const int ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        finer.push_back(t);
    }
    triangles = finer;
    for (Vector& x : points)
      x /= std::sqrt(x.squared_length());
  }
  std::vector<Point> on_sphere;
  for (const Vector& x : points)
    on_sphere.push_back(CGAL::ORIGIN + x / std::sqrt(x.squared_length()));
  return mesh_of(on_sphere, triangles);
}

// a torus with `nu` rings of `nv` vertices
inline Mesh torus(int nu, int nv, double major_radius = 2, double minor_radius = 1)
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  const auto vertex = [&](int i, int j) { return (i % nu) * nv + j % nv; };
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const double u = 2 * CGAL_PI * i / nu, v = 2 * CGAL_PI * j / nv;
      const double r = major_radius + minor_radius * std::cos(v);
      points.emplace_back(r * std::cos(u), r * std::sin(u), minor_radius * std::sin(v));
      triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return mesh_of(points, triangles);
}

// A ring of n prisms, the section of which is a square with its corners outside, inside, above and
// below.
inline Mesh square_ring(int n, int per_side)
{
  const int m = 4 * per_side;
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  const auto vertex = [&](int i, int j) { return (i % n) * m + j % m; };
  const auto wave = [&](int j) { return std::abs((j % m) / double(per_side) - 2) - 1; }; // 1 at 0
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double u = 2 * CGAL_PI * i / n, r = 2 + wave(j);
      points.emplace_back(r * std::cos(u), r * std::sin(u), wave(j + 3 * per_side));
      triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return mesh_of(points, triangles);
}

inline Mesh translated(Mesh mesh, const Vector& by)
{
  for (const auto v : vertices(mesh))
    mesh.point(v) = mesh.point(v) + by;
  return mesh;
}

inline Mesh disjoint_union(Mesh a, const Mesh& b)
{
  CGAL::copy_face_graph(b, a);
  return a;
}

// The cells of a plate: unit squares, each split into n x n squares of two triangles.
inline Mesh plate(const std::vector<std::array<int, 2>>& cells, int n)
{
  std::map<std::array<int, 2>, int> number_of_corner;
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  const auto corner = [&](int x, int y) {
    const auto [position, is_new] = number_of_corner.try_emplace({x, y}, int(points.size()));
    if (is_new)
      points.emplace_back(x / double(n), y / double(n), 0);
    return position->second;
  };
  for (const auto& [x, y] : cells)
    for (int i = n * x; i < n * (x + 1); ++i)
      for (int j = n * y; j < n * (y + 1); ++j) {
        triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
        triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
      }
  return mesh_of(points, triangles);
}

// a rectangular plate of width by height cells, without the `holes`
inline Mesh plate_with_holes(int width, int height, const std::vector<std::array<int, 2>>& holes,
                             int n)
{
  std::vector<std::array<int, 2>> cells;
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < height; ++y)
      if (std::find(holes.begin(), holes.end(), std::array<int, 2>{x, y}) == holes.end())
        cells.push_back({x, y});
  return plate(cells, n);
}

// the ring between two circles about the origin, with `rings` rings of 2 n triangles
inline Mesh annulus(double inner_radius, double outer_radius, int rings, int n)
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  const auto vertex = [&](int i, int j) { return i * n + j % n; };
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < n; ++j) {
      const double r = inner_radius + (outer_radius - inner_radius) * i / rings;
      points.emplace_back(r * std::cos(2 * CGAL_PI * j / n), r * std::sin(2 * CGAL_PI * j / n), 0);
      if (i < rings) {
        triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
        triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
    }
  return mesh_of(points, triangles);
}

// A ring whose outer border winds outwards once around the origin, and gets back by a step: there
// it has a convex and a concave corner.
inline Mesh annulus_with_step(double inner_radius, double step, int rings, int n)
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  const auto add_point = [&](double r, int j) {
    points.emplace_back(r * std::cos(2 * CGAL_PI * j / n), r * std::sin(2 * CGAL_PI * j / n), 0);
  };
  const auto add_square = [&](int a, int b, int c, int d) {
    for (const Triangle& t : {Triangle{a, b, c}, {a, c, d}})
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        triangles.push_back(t);
  };
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < n; ++j)
      add_point(inner_radius + (1 - inner_radius) * i / rings, j);
  const auto vertex = [&](int i, int j) { return i * n + j % n; };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < n; ++j)
      add_square(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  const int rows = (std::max)(1, int(step * rings)), first = int(points.size());
  for (int k = 1; k <= rows; ++k)
    for (int j = 1; j <= n; ++j)
      add_point(1 + step * k / rows * j / n, j);
  const auto outer = [&](int k, int j) {
    return k == 0 || j == 0 ? vertex(rings, j) : first + (k - 1) * n + j - 1;
  };
  for (int k = 0; k < rows; ++k)
    for (int j = 0; j < n; ++j)
      add_square(outer(k, j), outer(k + 1, j), outer(k + 1, j + 1), outer(k, j + 1));
  return mesh_of(points, triangles);
}

// the unit disc, with `rings` rings around its centre, the k-th of 6 k vertices
inline Mesh disc(int rings)
{
  std::vector<Point> points{Point(0, 0, 0)};
  std::vector<Triangle> triangles;
  const auto first = [](int k) { return k == 0 ? 0 : 1 + 3 * k * (k - 1); };
  const auto vertex = [&](int k, int j) { return k == 0 ? 0 : first(k) + j % (6 * k); };
  for (int k = 1; k <= rings; ++k)
    for (int j = 0; j < 6 * k; ++j) {
      const double r = double(k) / rings, angle = 2 * CGAL_PI * j / (6 * k);
      points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
      const int sector = j / k, inner = j - sector;
      triangles.push_back({vertex(k, j), vertex(k, j + 1), vertex(k - 1, inner)});
      if (j % k != k - 1)
        triangles.push_back({vertex(k - 1, inner), vertex(k, j + 1), vertex(k - 1, inner + 1)});
    }
  return mesh_of(points, triangles);
}

// moves every coordinate by up to `amplitude`; the same seed gives the same mesh on every machine
inline Mesh noisy(Mesh mesh, double amplitude, unsigned seed)
{
  std::mt19937 random(seed);
  const auto noise = [&] { return amplitude * (2. * random() / double(random.max()) - 1); };
  for (const auto v : vertices(mesh)) {
    const double x = noise(), y = noise(), z = noise();
    mesh.point(v) = mesh.point(v) + Vector(x, y, z);
  }
  return mesh;
}

// meshes with borders of various kinds, small for small `n`
inline std::vector<Mesh> meshes_with_borders(int n)
{
  return {plate({{0, 0}}, n + 2), plate_with_holes(5, 3, {{1, 1}, {3, 1}}, n), disc(2 * n + 1),
          annulus(0.3, 1, n + 2, 6 * n),
          noisy(plate_with_holes(4, 4, {{2, 2}, {0, 0}}, n), 0.05, 2)};
}

} // namespace generated

#endif // CGAL_QUAD_LAYOUTS_TEST_GENERATED_MESHES_H
