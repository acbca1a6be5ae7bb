// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_EXAMPLES_INPUT_H
#define QUAD_LAYOUTS_EXAMPLES_INPUT_H

#include <CGAL/Quad_layouts/IO/cross_field.h>
#include <CGAL/Quad_layouts/exceptions.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polygon = std::vector<std::size_t>;

// says why a file is refused
struct Input_error : CGAL::Quad_layouts::Error
{
  using Error::Error;
};

inline std::string extension_of(const std::string& file)
{
  std::string result = std::filesystem::path(file).extension().string();
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

inline std::string edge_name(const std::pair<std::size_t, std::size_t>& edge)
{
  return "the edge from vertex " + std::to_string(edge.first) + " to vertex " +
         std::to_string(edge.second);
}

// throws if two faces use an edge in the same direction: they are not oriented alike, or the edge
// has more than two faces. No halfedge structure can hold such faces.
inline void check_directed_edges(const std::vector<Polygon>& polygons)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> face_of;
  for (std::size_t f = 0; f < polygons.size(); ++f)
    for (std::size_t k = 0; k < polygons[f].size(); ++k) {
      const std::pair<std::size_t, std::size_t> edge(polygons[f][k],
                                                     polygons[f][(k + 1) % polygons[f].size()]);
      const auto inserted = face_of.emplace(edge, f);
      if (!inserted.second)
        throw Input_error(
            "the faces " + std::to_string(inserted.first->second) + " and " + std::to_string(f) +
            " run along " + edge_name(edge) +
            " in the same direction: they are duplicates, not oriented alike, or the edge is "
            "not manifold; "
            "CGAL::Polygon_mesh_processing::merge_duplicate_polygons_in_polygon_soup() and "
            "orient_polygon_soup() may repair it");
    }
}

// reads a mesh without changing it, except that equal points of an STL file are merged, which knows
// no vertices
inline Mesh read_mesh(const std::string& file)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const std::string extension = extension_of(file);
  if (extension != ".off" && extension != ".obj" && extension != ".ply" && extension != ".stl")
    throw Input_error(file + ": unknown format \"" + extension +
                      "\", known are .off .obj .ply .stl");
  if (!std::filesystem::exists(file))
    throw Input_error(file + ": no such file");

  std::vector<Kernel::Point_3> points;
  std::vector<Polygon> polygons;
  if (!CGAL::IO::read_polygon_soup(file, points, polygons))
    throw Input_error(file + ": cannot be read as a mesh");
  if (extension == ".stl")
    PMP::merge_duplicate_points_in_polygon_soup(points, polygons);
  for (std::size_t f = 0; f < polygons.size(); ++f)
    for (const std::size_t v : polygons[f])
      if (v >= points.size())
        throw Input_error(file + ": face " + std::to_string(f) + " has vertex " +
                          std::to_string(v) + ", but there are " + std::to_string(points.size()));
  check_directed_edges(polygons);
  if (!PMP::is_polygon_soup_a_polygon_mesh(polygons))
    throw Input_error(
        file + ": several fans of faces meet in one vertex; "
               "CGAL::Polygon_mesh_processing::orient_polygon_soup() duplicates such vertices");
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  return mesh;
}

using Directions = Mesh::Property_map<Mesh::Face_index, Kernel::Vector_3>;

// the format of a file of a cross field, by its extension; none if it is a plain list of vectors
inline std::optional<CGAL::Quad_layouts::Cross_field_format> field_format(const std::string& file)
{
  const std::string extension = extension_of(file);
  if (extension == ".rosy")
    return CGAL::Quad_layouts::ROSY;
  if (extension == ".rawfield")
    return CGAL::Quad_layouts::RAWFIELD;
  if (extension == ".ffield")
    return CGAL::Quad_layouts::FFIELD_MPZ14;
  return {};
}

// reads a line "x y z" for each face of the mesh
inline void read_vectors(const std::string& file, std::istream& in, Directions& directions,
                         const Mesh& mesh)
{
  std::size_t number_of_lines = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#')
      continue;
    std::istringstream words(line);
    double x, y, z;
    if (!(words >> x >> y >> z))
      throw Input_error(file + ": \"" + line + "\" is not a vector \"x y z\"");
    if (number_of_lines < mesh.number_of_faces())
      directions[Mesh::Face_index(Mesh::size_type(number_of_lines))] = Kernel::Vector_3(x, y, z);
    ++number_of_lines;
  }
  if (number_of_lines != mesh.number_of_faces())
    throw Input_error(file + ": has " + std::to_string(number_of_lines) + " vectors for " +
                      std::to_string(mesh.number_of_faces()) + " faces");
}

// reads a direction for each face of the mesh
inline Directions read_field(const std::string& file, Mesh& mesh)
{
  std::ifstream in(file);
  if (!in)
    throw Input_error(file + ": no such file");
  Directions result = mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:direction").first;
  if (const auto format = field_format(file))
    CGAL::Quad_layouts::IO::read_cross_field(in, *format, mesh, result);
  else
    read_vectors(file, in, result, mesh);
  return result;
}

// names the function of CGAL that may repair what a mesh is refused for
inline std::string repair_hint(const CGAL::Quad_layouts::Error& error)
{
  namespace QL = CGAL::Quad_layouts;
  const std::string pmp = "CGAL::Polygon_mesh_processing::";
  if (dynamic_cast<const QL::Non_triangle_face*>(&error))
    return pmp + "triangulate_faces()";
  if (dynamic_cast<const QL::Degenerate_face*>(&error))
    return pmp + "remove_degenerate_faces()";
  if (dynamic_cast<const QL::Duplicate_face*>(&error))
    return pmp + "merge_duplicate_polygons_in_polygon_soup()";
  if (dynamic_cast<const QL::Non_manifold_vertex*>(&error))
    return pmp + "duplicate_non_manifold_vertices()";
  return "";
}

#endif // QUAD_LAYOUTS_EXAMPLES_INPUT_H
