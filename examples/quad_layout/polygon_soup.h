// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_EXAMPLES_POLYGON_SOUP_H
#define QUAD_LAYOUTS_EXAMPLES_POLYGON_SOUP_H

#include <CGAL/Quad_layouts/exceptions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Union_find.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polygon = std::vector<std::size_t>;

// says why a file is refused
struct Input_error : CGAL::Quad_layouts::Error
{
  using Error::Error;
};

// what a file contains: polygons that need not form a surface
struct Polygon_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<Polygon> polygons;
};

// the function of CGAL that may repair something, as the end of a message
inline std::string repaired_by(const std::string& function)
{
  return "; --repair or CGAL::Polygon_mesh_processing::" + function + "() may repair it";
}

// throws if a polygon has vertices that there are not, or a vertex has a coordinate that is no number
inline void check_elements(const Polygon_soup& soup)
{
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(soup.points[v][k]))
        throw Input_error("vertex " + std::to_string(v) +
                          " has a coordinate that is not a finite number");
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    for (const std::size_t v : soup.polygons[f])
      if (v >= soup.points.size())
        throw Input_error("face " + std::to_string(f) + " has vertex " + std::to_string(v) +
                          ", but there are " + std::to_string(soup.points.size()));
}

// Finds out whether polygons form an oriented manifold, which is what a halfedge structure can hold.
class Manifold_check
{
public:
  explicit Manifold_check(const std::vector<Polygon>& polygons) : m_polygons(polygons) {}

  // throws if not, naming what is wrong
  void operator()()
  {
    check_faces();
    for (std::size_t f = 0; f < m_polygons.size(); ++f)
      for (std::size_t k = 0; k < m_polygons[f].size(); ++k)
        m_sides[std::minmax(vertex(f, k), vertex(f, k + 1))].push_back({f, k});
    for (const auto& [edge, sides] : m_sides)
      check_edge(edge, sides);
    check_vertices();
  }

private:
  struct Side
  {
    std::size_t face, number;
  };
  using Edge = std::pair<std::size_t, std::size_t>;

  std::size_t vertex(std::size_t f, std::size_t k) const
  {
    return m_polygons[f][k % m_polygons[f].size()];
  }

  static std::string name(std::size_t f) { return std::to_string(f); }
  static std::string name(const Edge& edge)
  {
    return "the edge from vertex " + name(edge.first) + " to vertex " + name(edge.second);
  }

  void check_faces() const
  {
    std::map<Polygon, std::size_t> face_of;
    for (std::size_t f = 0; f < m_polygons.size(); ++f) {
      Polygon corners = m_polygons[f];
      std::sort(corners.begin(), corners.end());
      check_corners(f, corners);
      const std::size_t g = face_of.emplace(std::move(corners), f).first->second;
      if (g != f)
        throw Input_error("the faces " + name(g) + " and " + name(f) + " have the same vertices" +
                          repaired_by("merge_duplicate_polygons_in_polygon_soup"));
    }
  }

  // takes the corners of face f in ascending order
  void check_corners(std::size_t f, const Polygon& corners) const
  {
    const auto twice = std::adjacent_find(corners.begin(), corners.end());
    if (corners.size() < 3)
      throw Input_error("face " + name(f) + " has " + name(corners.size()) + " sides" +
                        repaired_by("repair_polygon_soup"));
    if (twice != corners.end())
      throw Input_error("face " + name(f) + " has vertex " + name(*twice) + " twice" +
                        repaired_by("repair_polygon_soup"));
  }

  void check_edge(const Edge& edge, const std::vector<Side>& sides) const
  {
    if (sides.size() == 1)
      return;
    const std::size_t f = sides[0].face, g = sides[1].face;
    const std::string faces = "the faces " + name(f) + " and " + name(g);
    if (sides.size() > 2)
      throw Input_error(faces + " and " + name(sides.size() - 2) + " more meet in " + name(edge) +
                        ", which is not manifold" + repaired_by("orient_polygon_soup"));
    if (vertex(f, sides[0].number) == vertex(g, sides[1].number))
      throw Input_error(faces + " run along " + name(edge) +
                        " in the same direction: they are not oriented alike" +
                        repaired_by("orient_polygon_soup"));
  }

  // The corners at a vertex must be one fan: joined through the edges between them.
  void check_vertices() const
  {
    using Fans = CGAL::Union_find<std::size_t>;
    Fans fans;
    std::vector<std::vector<Fans::handle>> corners(m_polygons.size());
    for (std::size_t f = 0; f < m_polygons.size(); ++f)
      for (const std::size_t v : m_polygons[f])
        corners[f].push_back(fans.make_set(v));
    const auto corner = [&](const Side& side, std::size_t v) {
      const bool is_source = vertex(side.face, side.number) == v;
      return corners[side.face][(side.number + (is_source ? 0 : 1)) % corners[side.face].size()];
    };
    for (const auto& [edge, sides] : m_sides)
      for (const std::size_t v : {edge.first, edge.second})
        fans.unify_sets(corner(sides.front(), v), corner(sides.back(), v));
    std::map<std::size_t, Fans::handle> fan_of; // per vertex
    for (std::size_t f = 0; f < m_polygons.size(); ++f)
      for (std::size_t k = 0; k < m_polygons[f].size(); ++k)
        if (!fans.same_set(fan_of.emplace(vertex(f, k), corners[f][k]).first->second, corners[f][k]))
          throw Input_error("several fans of faces meet in vertex " + name(vertex(f, k)) +
                            ", one of them with face " + name(f) +
                            repaired_by("orient_polygon_soup"));
  }

  const std::vector<Polygon>& m_polygons;
  std::map<Edge, std::vector<Side>> m_sides;
};

// makes oriented manifold triangles of polygons: merges what is twice, duplicates vertices where the
// surface is not manifold, and takes away what has no area
inline Mesh repaired_mesh(Polygon_soup soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  PMP::repair_polygon_soup(soup.points, soup.polygons);
  PMP::orient_polygon_soup(soup.points, soup.polygons);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  if (!PMP::triangulate_faces(mesh))
    throw Input_error("--repair cannot divide all faces into triangles");
  if (!PMP::remove_degenerate_faces(mesh))
    throw Input_error("--repair cannot remove all triangles without area");
  mesh.collect_garbage();
  return mesh;
}

// makes a mesh of polygons as they are; throws if this is impossible
inline Mesh unchanged_mesh(const Polygon_soup& soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Manifold_check(soup.polygons)();
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  return mesh;
}

#endif // QUAD_LAYOUTS_EXAMPLES_POLYGON_SOUP_H
