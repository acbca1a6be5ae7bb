// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_EXAMPLES_INPUT_H
#define QUAD_LAYOUTS_EXAMPLES_INPUT_H

#include "file_header.h"
#include "polygon_soup.h"

#include <CGAL/Quad_layouts/IO/cross_field.h>
#include <CGAL/Quad_layouts/exceptions.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

inline std::string extension_of(const std::string& file)
{
  std::string result = std::filesystem::path(file).extension().string();
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

// lets CGAL read a file, which gets memory for as many corners as a face announces
inline bool read_elements(const std::string& file, Polygon_soup& soup)
{
  try {
    return CGAL::IO::read_polygon_soup(file, soup.points, soup.polygons);
  } catch (const std::length_error&) {
  } catch (const std::bad_alloc&) {
  }
  throw Input_error("takes more memory than there is; a face may announce too many corners");
}

// reads what a file contains, except that equal points of an STL file are merged, which knows no
// vertices
inline Polygon_soup read_soup(const std::string& file)
{
  const std::string extension = extension_of(file);
  if (extension != ".off" && extension != ".obj" && extension != ".ply" && extension != ".stl")
    throw Input_error("unknown format \"" + extension + "\", known are .off .obj .ply .stl");
  if (!std::filesystem::is_regular_file(file))
    throw Input_error("no such file");
  if (extension == ".off")
    File_header(file).check_off();
  if (extension == ".ply")
    File_header(file).check_ply();
  Polygon_soup soup;
  if (!read_elements(file, soup))
    throw Input_error("cannot be read as a mesh");
  check_elements(soup);
  if (extension == ".stl")
    CGAL::Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(soup.points,
                                                                          soup.polygons);
  return soup;
}

// reads a mesh, as it is or repaired
inline Mesh read_mesh(const std::string& file, bool repair)
{
  try {
    const Polygon_soup soup = read_soup(file);
    return repair ? repaired_mesh(soup) : unchanged_mesh(soup);
  } catch (const Input_error& error) {
    throw Input_error(file + ": " + error.what());
  }
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
  Directions result =
      mesh.add_property_map<Mesh::Face_index, Kernel::Vector_3>("f:direction").first;
  if (const auto format = field_format(file))
    CGAL::Quad_layouts::IO::read_cross_field(in, *format, mesh, result);
  else
    read_vectors(file, in, result, mesh);
  return result;
}

// the end of a message: how to repair what the library refuses a mesh for
inline std::string repair_hint(const CGAL::Quad_layouts::Error& error)
{
  namespace QL = CGAL::Quad_layouts;
  if (dynamic_cast<const QL::Non_triangle_face*>(&error))
    return repaired_by("triangulate_faces");
  if (dynamic_cast<const QL::Degenerate_face*>(&error))
    return repaired_by("remove_degenerate_faces");
  return "";
}

#endif // QUAD_LAYOUTS_EXAMPLES_INPUT_H
