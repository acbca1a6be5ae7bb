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
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <unordered_map>
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

// throws if a polygon has vertices that there are not, or a vertex has a coordinate that is no
// number
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

// Finds out whether polygons form an oriented manifold, which is what a halfedge structure can
// hold.
class Manifold_check
{
public:
  explicit Manifold_check(const std::vector<Polygon>& polygons) : m_polygons(polygons) {}

  // throws if not, naming what is wrong
  void operator()()
  {
    for (std::size_t f = 0; f < m_polygons.size(); ++f) {
      check_corners(f);
      for (std::size_t k = 0; k < m_polygons[f].size(); ++k)
        m_sides.push_back({std::minmax(vertex(f, k), vertex(f, k + 1)), f, k});
    }
    std::sort(m_sides.begin(), m_sides.end());
    for_each_edge([this](Side_iterator first, Side_iterator last) { check_edge(first, last); });
    check_vertices();
  }

private:
  using Edge = std::pair<std::size_t, std::size_t>;
  struct Side
  {
    Edge edge;
    std::size_t face, number;
    friend bool operator<(const Side& a, const Side& b)
    {
      return std::tie(a.edge, a.face, a.number) < std::tie(b.edge, b.face, b.number);
    }
  };
  using Side_iterator = std::vector<Side>::const_iterator;

  std::size_t vertex(std::size_t f, std::size_t k) const
  {
    return m_polygons[f][k % m_polygons[f].size()];
  }
  bool begins_at(const Side& side, std::size_t v) const
  {
    return vertex(side.face, side.number) == v;
  }

  static std::string name(std::size_t f) { return std::to_string(f); }
  static std::string name(const Edge& edge)
  {
    return "the edge from vertex " + name(edge.first) + " to vertex " + name(edge.second);
  }

  void check_corners(std::size_t f) const
  {
    Polygon corners = m_polygons[f];
    std::sort(corners.begin(), corners.end());
    const auto twice = std::adjacent_find(corners.begin(), corners.end());
    if (corners.size() < 3)
      throw Input_error("face " + name(f) + " has " + name(corners.size()) + " sides" +
                        repaired_by("repair_polygon_soup"));
    if (twice != corners.end())
      throw Input_error("face " + name(f) + " has vertex " + name(*twice) + " twice" +
                        repaired_by("repair_polygon_soup"));
  }

  // calls `visit` for the first side of each edge and the one behind its last
  template <class Visit>
  void for_each_edge(const Visit& visit) const
  {
    for (Side_iterator first = m_sides.begin(), last; first != m_sides.end(); first = last) {
      last = std::find_if(first, m_sides.end(),
                          [&](const Side& side) { return side.edge != first->edge; });
      visit(first, last);
    }
  }

  void check_edge(Side_iterator first, Side_iterator last) const
  {
    const std::size_t f = first->face;
    for (Side_iterator other = first + 1; other != last; ++other)
      if (is_same_face(f, other->face))
        throw Input_error("the faces " + name(f) + " and " + name(other->face) +
                          " have the same vertices" +
                          repaired_by("merge_duplicate_polygons_in_polygon_soup"));
    if (last - first == 1)
      return;
    const std::string faces = "the faces " + name(f) + " and " + name((first + 1)->face);
    if (last - first > 2)
      throw Input_error(faces + " and " + name(std::size_t(last - first - 2)) + " more meet in " +
                        name(first->edge) + ", which is not manifold" +
                        repaired_by("orient_polygon_soup"));
    if (begins_at(*first, first->edge.first) == begins_at(*(first + 1), first->edge.first))
      throw Input_error(faces + " run along " + name(first->edge) +
                        " in the same direction: they are not oriented alike" +
                        repaired_by("orient_polygon_soup"));
  }

  bool is_same_face(std::size_t f, std::size_t g) const
  {
    return std::is_permutation(m_polygons[f].begin(), m_polygons[f].end(), m_polygons[g].begin(),
                               m_polygons[g].end());
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
      const std::size_t k = side.number + (begins_at(side, v) ? 0 : 1);
      return corners[side.face][k % corners[side.face].size()];
    };
    for_each_edge([&](Side_iterator first, Side_iterator last) {
      for (const std::size_t v : {first->edge.first, first->edge.second})
        fans.unify_sets(corner(*first, v), corner(*(last - 1), v));
    });
    std::unordered_map<std::size_t, Fans::handle> fan_of; // per vertex
    for (std::size_t f = 0; f < m_polygons.size(); ++f)
      for (const Fans::handle& c : corners[f])
        if (!fans.same_set(fan_of.emplace(*c, c).first->second, c))
          throw Input_error("several fans of faces meet in vertex " + name(*c) +
                            ", one of them with face " + name(f) +
                            repaired_by("orient_polygon_soup"));
  }

  const std::vector<Polygon>& m_polygons;
  std::vector<Side> m_sides; // sorted by edge
};

// takes away the triangles without area; returns false if some remain, or if CGAL leaves no mesh,
// which it tells by an assertion if these are checked
inline bool remove_degenerate_faces(Mesh& mesh)
{
  try {
    return CGAL::Polygon_mesh_processing::remove_degenerate_faces(mesh) &&
           CGAL::is_valid_polygon_mesh(mesh);
  } catch (const CGAL::Failure_exception&) {
    return false;
  }
}

// makes oriented manifold triangles of polygons: merges what is twice, duplicates vertices where
// the surface is not manifold, and takes away what has no area
inline Mesh repaired_mesh(Polygon_soup soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  PMP::repair_polygon_soup(soup.points, soup.polygons);
  PMP::orient_polygon_soup(soup.points, soup.polygons);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  if (!PMP::triangulate_faces(mesh))
    throw Input_error("--repair cannot divide all faces into triangles");
  if (!remove_degenerate_faces(mesh))
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
