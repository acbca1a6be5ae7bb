// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_TEST_SYNTHETIC_MAPS_H
#define CGAL_QUAD_LAYOUTS_TEST_SYNTHETIC_MAPS_H

#include <CGAL/Quad_layouts/Integer_grid_map.h>
#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/internal/layout/divided_layout.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/extract_Line_tracer.h>

#include <CGAL/assertions.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

// Integer-grid maps made from a layout: the inverse of extraction. Each face of the layout is a
// rectangle of triangles, whose vertices are then moved at random.
namespace synthetic {

using CGAL::Quad_layouts::Integer_grid_map;
using CGAL::Quad_layouts::Quad_layout;
using CGAL::Quad_layouts::internal::Divided_layout;
using CGAL::Quad_layouts::internal::Map_heading;
using Surface = Integer_grid_map::Surface;
using Transition = Integer_grid_map::Transition;
using Point_2 = Integer_grid_map::Point_2;

// Returns a multiple of 2^-24 of at most the given magnitude.
inline double random_fixed(std::mt19937& random, double most)
{
  const double unit = 1 << 24;
  return std::round(std::uniform_real_distribution<double>(-most, most)(random) * unit) / unit;
}

// Finds the transitions that given coordinates imply.
inline void connect_charts(Integer_grid_map& map)
{
  const Surface& s = map.surface();
  map.halfedge_transition.resize(s.number_of_halfedges());
  for (int h = 0; h < s.number_of_halfedges(); ++h) {
    const int o = s.opposite(h);
    const Point_2 here = map.coordinates(Surface::next(h)) - map.coordinates(h);
    const Point_2 there = map.coordinates(o) - map.coordinates(Surface::next(o));
    Transition t;
    while (Transition::turned(here, t.quarter_turns) != there) {
      CGAL_assertion(t.quarter_turns < 3);
      ++t.quarter_turns;
    }
    t.translation = map.coordinates(o) - t(map.coordinates(Surface::next(h)));
    map.halfedge_transition[h] = t;
  }
}

// Moves a vertex in all charts around it.
inline void move_vertex(Integer_grid_map& map, int vertex, Point_2 by)
{
  const Surface& s = map.surface();
  s.for_each_outgoing(vertex, [&](int h) {
    map.corner_coordinates[h] += by;
    by = Transition::turned(by, map.transition(Surface::prev(h)).quarter_turns);
  });
}

// Turns and moves each chart by a random integer transformation.
inline void scramble_charts(Integer_grid_map& map, std::mt19937& random)
{
  std::uniform_int_distribution<int> turns(0, 3), distance(-9, 9);
  for (int f = 0; f < map.surface().number_of_faces(); ++f) {
    const Transition t{turns(random), Point_2(distance(random), distance(random))};
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      map.corner_coordinates[h] = t(map.corner_coordinates[h]);
    for (auto& anchor : map.anchors)
      if (Surface::face(anchor.corner) == f)
        anchor.direction = (anchor.direction + t.quarter_turns) & 3;
  }
  connect_charts(map);
}

struct Options
{
  int refinement = 4;  // triangle edges per unit of length
  double jitter = 0.2; // of a triangle edge
  bool scramble = true;
  unsigned seed = 0;
};

inline Eigen::Vector3d point_in_face(const Quad_layout& layout, int f, double x, double y)
{
  const int h = layout.halfedge_of(f), g = layout.next(layout.next(h));
  return (1 - y) * ((1 - x) * layout.point(layout.source(h)) + x * layout.point(layout.target(h))) +
         y * ((1 - x) * layout.point(layout.target(g)) + x * layout.point(layout.source(g)));
}

inline bool is_anchored(const Quad_layout& layout, int v)
{
  return layout.valence(v) != 4 || (v == 0 && layout.number_of_irregular_vertices() == 0);
}

// Cuts the squares of the grids of all faces at random diagonals. The chart of face f is that of
// its grid.
inline void add_triangles(Integer_grid_map& map, const Divided_layout& divided, int refinement,
                          std::mt19937& random)
{
  const Quad_layout& layout = divided.layout();
  std::vector<Eigen::Vector3d> points(divided.number_of_vertices());
  std::vector<std::array<int, 3>> triangles;
  for (int f = 0; f < layout.number_of_faces(); ++f) {
    const auto add_triangle = [&](const std::array<std::pair<int, int>, 3>& corners) {
      triangles.emplace_back();
      for (int k = 0; k < 3; ++k) {
        const auto [i, j] = corners[k];
        const int v = triangles.back()[k] = divided.vertex_in(f, i, j);
        points[v] = point_in_face(layout, f, double(i) / divided.width(f),
                                  double(j) / divided.height(f));
        map.corner_coordinates.emplace_back(double(i) / refinement, double(j) / refinement);
      }
    };
    for (int j = 0; j < divided.height(f); ++j)
      for (int i = 0; i < divided.width(f); ++i)
        if (random() % 2) {
          add_triangle({{{i, j}, {i + 1, j}, {i + 1, j + 1}}});
          add_triangle({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
        } else {
          add_triangle({{{i, j}, {i + 1, j}, {i, j + 1}}});
          add_triangle({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
        }
  }
  map.surface_pointer = std::make_shared<const Surface>(points, triangles);
  connect_charts(map);
}

// Anchors the source of each side of a face: side k runs in direction k, along an edge of the
// surface.
inline void add_anchors(Integer_grid_map& map, const Divided_layout& divided)
{
  const Quad_layout& layout = divided.layout();
  int first_triangle = 0;
  for (int f = 0; f < layout.number_of_faces(); ++f) {
    const int end = first_triangle + 2 * divided.width(f) * divided.height(f);
    int side = layout.halfedge_of(f);
    for (int k = 0; k < 4; ++k, side = layout.next(side))
      for (int c = 3 * first_triangle; c < 3 * end && is_anchored(layout, layout.source(side)); ++c)
        if (map.surface().source(c) == layout.source(side) &&
            map.surface().target(c) == divided.vertex_on(side, 1))
          map.anchors.push_back({c, k, side});
    first_triangle = end;
  }
}

// Finds the corners through which the anchors' lines leave after their neighbours have moved a
// little.
inline void correct_anchors(Integer_grid_map& map)
{
  const CGAL::Quad_layouts::internal::Line_tracer lines(map);
  for (auto& anchor : map.anchors) {
    const Transition& t = map.transition(anchor.corner);
    const Map_heading clockwise_neighbour{Surface::face(map.surface().opposite(anchor.corner)),
                                          t(map.coordinates(anchor.corner)),
                                          (anchor.direction + t.quarter_turns) & 3};
    const Map_heading entered = lines.entered(clockwise_neighbour);
    anchor.corner = 3 * entered.face;
    while (map.coordinates(anchor.corner) != entered.position)
      ++anchor.corner;
    anchor.direction = entered.direction;
  }
}

// Makes a map onto `layout`, anchored at the irregular vertices, or at vertex 0 if there are none.
inline Integer_grid_map make_map(const Quad_layout& layout, std::vector<int> chord_length,
                                 const Options& options = Options())
{
  std::mt19937 random(options.seed);
  std::vector<int> divisions = chord_length;
  for (int& n : divisions)
    n *= options.refinement;
  const Divided_layout divided(layout, divisions);

  Integer_grid_map map;
  map.chord_length = std::move(chord_length);
  add_triangles(map, divided, options.refinement, random);
  add_anchors(map, divided);
  const double most = options.jitter / options.refinement;
  for (int v = 0; v < divided.number_of_vertices(); ++v)
    if (v >= layout.number_of_vertices() || !is_anchored(layout, v))
      move_vertex(map, v, Point_2(random_fixed(random, most), random_fixed(random, most)));
  correct_anchors(map);
  if (options.scramble)
    scramble_charts(map, random);
  return map;
}

} // namespace synthetic

#endif // CGAL_QUAD_LAYOUTS_TEST_SYNTHETIC_MAPS_H
