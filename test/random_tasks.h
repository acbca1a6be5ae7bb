// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TEST_RANDOM_TASKS_H
#define CGAL_QUAD_LAYOUTS_TEST_RANDOM_TASKS_H

#include "all_stages.h"
#include "generated_meshes.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Makes tasks at random: the same seed gives the same one on every machine.
namespace random_tasks {

using all_stages::Task;
using generated::Cell;
using generated::Mesh;
using generated::Point;
using generated::Vector;

// numbers that do not depend on the standard library's distributions
class Dice
{
public:
  explicit Dice(unsigned seed) : m_random(seed) {}

  // in low to high
  int integer(int low, int high) { return low + int(m_random() % unsigned(high - low + 1)); }
  double real(double low, double high)
  {
    return low + (high - low) * (m_random() / double((std::mt19937::max)()));
  }
  bool happens(double probability) { return real(0, 1) < probability; }
  Vector vector(double length)
  {
    return {real(-length, length), real(-length, length), real(-length, length)};
  }

private:
  std::mt19937 m_random;
};

// whether the union of cubes is a manifold around all corners of a cube: there, both the cubes and
// what they leave free are connected through sides
inline bool is_manifold_around(const std::set<Cell>& cells, const Cell& cell)
{
  for (int corner = 0; corner < 8; ++corner) {
    std::array<bool, 8> is_in{};
    for (int k = 0; k < 8; ++k)
      is_in[k] = cells.count({cell[0] + (corner & 1) - (k & 1),
                              cell[1] + (corner >> 1 & 1) - (k >> 1 & 1),
                              cell[2] + (corner >> 2 & 1) - (k >> 2 & 1)}) > 0;
    for (const bool side : {false, true}) {
      const auto first = std::find(is_in.begin(), is_in.end(), side);
      if (first == is_in.end())
        continue;
      std::set<int> reached{int(first - is_in.begin())};
      for (std::size_t size = 0; size != reached.size();) {
        size = reached.size();
        for (const int k : std::set<int>(reached))
          for (const int bit : {1, 2, 4})
            if (is_in[k ^ bit] == side)
              reached.insert(k ^ bit);
      }
      if (int(reached.size()) < std::count(is_in.begin(), is_in.end(), side))
        return false;
    }
  }
  return true;
}

// a union of cubes, with handles and cavities
inline Mesh cubes(Dice& dice)
{
  const int n = dice.integer(2, 3);
  std::set<Cell> cells{{0, 0, 0}};
  for (int i = dice.integer(0, 40); i > 0; --i) {
    const Cell cell = {dice.integer(0, n), dice.integer(0, n), dice.integer(0, n)};
    cells.insert(cell);
    if (!is_manifold_around(cells, cell))
      cells.erase(cell);
  }
  return generated::voxel_surface({cells.begin(), cells.end()}, dice.integer(1, 2));
}

// a plate with holes that do not touch one another
inline Mesh plate(Dice& dice)
{
  const int width = dice.integer(1, 5), height = dice.integer(1, 5);
  std::vector<std::array<int, 2>> holes;
  for (int x = 1; x + 1 < width; x += 2)
    for (int y = 1; y + 1 < height; y += 2)
      if (dice.happens(0.5))
        holes.push_back({x, y});
  return generated::plate_with_holes(width, height, holes, dice.integer(1, 3));
}

inline Mesh basic_mesh(Dice& dice)
{
  switch (dice.integer(0, 9)) {
    case 0: return generated::tetrahedron();
    case 1: return generated::icosphere(dice.integer(0, 3));
    case 2: return generated::torus(dice.integer(3, 24), dice.integer(3, 16), dice.real(1.5, 5));
    case 3: return generated::slab_with_holes(dice.integer(0, 3), dice.integer(1, 3));
    case 4: return plate(dice);
    case 5: return generated::disc(dice.integer(1, 8));
    case 6:
      return generated::annulus(dice.real(0.05, 0.95), 1, dice.integer(1, 6), dice.integer(3, 40));
    case 7:
      return generated::annulus_with_step(dice.real(0.1, 0.8), dice.real(0.1, 0.5),
                                          dice.integer(2, 8), dice.integer(6, 30));
    default: return cubes(dice);
  }
}

// takes away vertices with their faces, none close to another or to the border
inline void perforate(Mesh& mesh, Dice& dice, int holes)
{
  for (; holes > 0; --holes) {
    const Mesh::Vertex_index v(
        Mesh::size_type(dice.integer(0, int(mesh.number_of_vertices()) - 1)));
    std::set<Mesh::Vertex_index> around{v};
    for (int ring = 0; ring < 3; ++ring)
      for (const auto u : std::set<Mesh::Vertex_index>(around))
        for (const auto w : vertices_around_target(mesh.halfedge(u), mesh))
          around.insert(w);
    if (around.size() == mesh.number_of_vertices() ||
        std::any_of(around.begin(), around.end(), [&](auto u) { return mesh.is_border(u); }))
      continue;
    CGAL::Euler::make_hole(CGAL::Euler::remove_center_vertex(mesh.halfedge(v), mesh), mesh);
    mesh.collect_garbage();
  }
}

// divides faces in three, close to a corner, a side or the middle: makes needles and caps, but none
// without area
inline void divide_faces(Mesh& mesh, Dice& dice, int times)
{
  for (; times > 0; --times) {
    const Mesh::Face_index f(Mesh::size_type(dice.integer(0, int(mesh.number_of_faces()) - 1)));
    std::array<double, 3> weight;
    double sum = 0;
    for (double& w : weight)
      sum += w = std::pow(10., -dice.integer(0, 9));
    Point center = CGAL::ORIGIN;
    int k = 0;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      center += weight[k++] / sum * (mesh.point(v) - CGAL::ORIGIN);
    const auto sides = halfedges_around_face(mesh.halfedge(f), mesh);
    if (std::none_of(sides.begin(), sides.end(), [&](auto h) {
          return CGAL::collinear(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), center);
        }))
      mesh.point(mesh.target(CGAL::Euler::add_center_vertex(mesh.halfedge(f), mesh))) = center;
  }
}

inline double mean_edge_length(const Mesh& mesh)
{
  double sum = 0;
  for (const auto e : edges(mesh))
    sum += std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return sum / mesh.number_of_edges();
}

template <class Change>
void change_points(Mesh& mesh, const Change& change)
{
  for (const auto v : vertices(mesh))
    mesh.point(v) = CGAL::ORIGIN + change(mesh.point(v) - CGAL::ORIGIN);
}

// moves and scales points so that some are no longer where one would like them
inline void distort(Mesh& mesh, Dice& dice)
{
  if (dice.happens(0.3))
    divide_faces(mesh, dice, dice.integer(1, 20));
  if (dice.happens(0.5)) {
    const double noise = mean_edge_length(mesh) * std::pow(10., dice.real(-4, 0));
    change_points(mesh, [&](const Vector& p) { return p + dice.vector(noise); });
  }
  if (dice.happens(0.2)) {
    const double x = std::pow(10., dice.real(-3, 0)), y = std::pow(10., dice.real(-2, 0));
    change_points(mesh, [&](const Vector& p) { return Vector(x * p.x(), y * p.y(), p.z()); });
  }
  if (dice.happens(0.1)) // edge lengths of all sizes
    change_points(mesh, [&](const Vector& p) {
      return Vector(std::pow(p.x(), 3), std::pow(p.y(), 3), p.z());
    });
}

inline Mesh component(Dice& dice)
{
  Mesh mesh = basic_mesh(dice);
  if (dice.happens(0.2))
    perforate(mesh, dice, dice.integer(1, 6));
  distort(mesh, dice);
  return mesh;
}

inline Mesh random_mesh(Dice& dice)
{
  Mesh mesh = component(dice);
  for (int i = dice.happens(0.2) ? dice.integer(1, 3) : 0; i > 0; --i) {
    Mesh other = component(dice);
    const double scale = std::pow(10., dice.integer(-3, 2));
    const Vector shift = dice.vector(5); // components may intersect
    change_points(other, [&](const Vector& p) { return scale * p + shift; });
    mesh = generated::disjoint_union(std::move(mesh), other);
  }
  if (dice.happens(0.2)) {
    const double scale = std::pow(10., dice.integer(-6, 6));
    change_points(mesh, [&](const Vector& p) { return scale * p; });
  }
  if (dice.happens(0.2)) {
    const Vector shift = dice.vector(std::pow(10., dice.integer(1, 6)));
    change_points(mesh, [&](const Vector& p) { return p + shift; });
  }
  return mesh;
}

// directions at random; or around an axis, turning on the way along it, so that lines wind towards
// limit cycles; with more or less noise
inline std::vector<Eigen::Vector3d> random_directions(const Mesh& mesh, Dice& dice)
{
  const bool is_noise = dice.happens(0.5);
  const double noise = dice.happens(0.5) ? dice.real(0, 1) : 0, turn = dice.real(-2, 2);
  std::vector<Eigen::Vector3d> result;
  for (const auto f : faces(mesh)) {
    const auto h = mesh.halfedge(f);
    const Point &a = mesh.point(mesh.source(h)), &b = mesh.point(mesh.target(h));
    const Point& c = mesh.point(mesh.target(mesh.next(h)));
    const Eigen::Vector3d ab(b.x() - a.x(), b.y() - a.y(), b.z() - a.z());
    const Eigen::Vector3d ac(c.x() - a.x(), c.y() - a.y(), c.z() - a.z());
    const Eigen::Vector3d normal = ab.cross(ac).normalized(), u = ab.normalized(),
                          v = normal.cross(u);
    const Eigen::Vector3d around(-a.y(), a.x(), 0);
    const double angle = is_noise ? dice.real(0, 7)
                                  : std::atan2(around.dot(v), around.dot(u)) + turn * a.z() +
                                        dice.real(-noise, noise);
    result.push_back(std::cos(angle) * u + std::sin(angle) * v);
  }
  return result;
}

inline Task random_task(unsigned seed)
{
  Dice dice(seed);
  Task task(random_mesh(dice));
  if (dice.happens(0.3))
    task.directions = random_directions(task.mesh, dice);
  else
    task.curvature_alignment = dice.happens(0.5) ? 0.07 : dice.real(0, 1);
  if (dice.happens(0.15)) {
    task.sharp_angle = dice.real(20, 90);
    CGAL::Polygon_mesh_processing::detect_sharp_edges(task.mesh, task.sharp_angle, task.is_feature);
  }
  task.deviation = dice.real(1, 60);
  task.displacement = dice.happens(0.2) ? 0 : dice.real(0, 8);
  task.edge_length = std::pow(10., dice.real(-1.5, -0.5));
  if (dice.happens(0.3)) {
    task.minimum_valence = dice.integer(2, 4);
    task.maximum_valence = dice.integer(4, 12);
  }
  task.route = dice.happens(0.5) ? CGAL::Quad_layouts::FIELD : CGAL::Quad_layouts::PARAMETRIZATION;
  return task;
}

inline std::string description(const Task& task)
{
  std::ostringstream result;
  result << task.mesh.number_of_faces() << " faces, "
         << (task.directions.empty() ? "smooth field" : "given field") << ", features from "
         << task.sharp_angle << " degrees, deviation " << task.deviation << ", displacement "
         << task.displacement << ", edge length " << task.edge_length << ", valence "
         << task.minimum_valence << " to " << task.maximum_valence << ", by the "
         << (task.route == CGAL::Quad_layouts::FIELD ? "field" : "parametrization");
  return result.str();
}

} // namespace random_tasks

#endif // CGAL_QUAD_LAYOUTS_TEST_RANDOM_TASKS_H
