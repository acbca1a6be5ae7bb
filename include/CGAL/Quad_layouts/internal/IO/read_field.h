// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_IO_READ_FIELD_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_IO_READ_FIELD_H

#include <CGAL/Quad_layouts/internal/IO/Line_reader.h>
#include <CGAL/Quad_layouts/internal/IO/first_halfedge.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <istream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// what a file of a field says of a surface
struct Field_in_file
{
  std::vector<Point> directions; // per face
  std::vector<char> sharp;       // per halfedge; empty if the file does not tell
};

inline void expect_number_of_faces(Line_reader& reader, const Triangle_surface& surface)
{
  const int faces = reader.number<int>();
  if (faces != surface.number_of_faces())
    reader.fail("the field has " + std::to_string(faces) + " faces, the mesh has " +
                std::to_string(surface.number_of_faces()));
}

inline void expect_degree_four(Line_reader& reader)
{
  const int degree = reader.number<int>();
  if (degree != 4)
    reader.fail("a field of degree " + std::to_string(degree) + " is no cross field");
}

inline Field_in_file read_rosy(std::istream& in, const Triangle_surface& surface)
{
  Line_reader reader(in, "read_rosy");
  expect_number_of_faces(reader, surface);
  expect_degree_four(reader);
  Field_in_file result;
  for (int f = 0; f < surface.number_of_faces(); ++f)
    result.directions.push_back(reader.vector());
  return result;
}

inline Field_in_file read_raw_field(std::istream& in, const Triangle_surface& surface)
{
  Line_reader reader(in, "read_rawfield");
  expect_degree_four(reader);
  expect_number_of_faces(reader, surface);
  Field_in_file result;
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    result.directions.push_back(reader.vector());
    for (int others = 0; others < 3; ++others)
      reader.vector();
  }
  return result;
}

// the frames of both dialects of .ffield: two sizes and two vectors for each face
inline void read_frames(Line_reader& reader, Field_in_file& field)
{
  for (Point& direction : field.directions) {
    for (int size = 0; size < 2; ++size)
      reader.number<double>();
    direction = reader.vector();
    reader.vector();
  }
}

// The halfedges that the angles of faces are measured from. Each line of the matchings begins with
// the vertices of a face, and the first halfedge ends in the first of them. Without matchings the
// order is that of the mesh.
inline std::vector<int> read_matchings(Line_reader& reader, const Triangle_surface& surface,
                                       bool has_sharp, Field_in_file& field)
{
  std::vector<int> result;
  if (has_sharp)
    field.sharp.assign(surface.number_of_halfedges(), 0);
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    const int a = reader.number<int>(), b = reader.number<int>(), c = reader.number<int>();
    const int first = Triangle_surface::prev(first_halfedge(reader, surface, f, {a, b, c}));
    result.push_back(first);
    for (int matching = 0; matching < 3; ++matching)
      reader.number<double>();
    for (int side = 0; has_sharp && side < 3; ++side)
      field.sharp[3 * f + (first + side) % 3] = reader.number<int>() != 0;
  }
  return result;
}

// reads what follows the frames in the dialect of Myles, Pietroni and Zorin, in which angles, if
// there are any, take the place of the frames
inline void read_sections(Line_reader& reader, const Triangle_surface& surface,
                          Field_in_file& field)
{
  std::vector<double> angles;
  std::vector<int> references;
  for (std::string title = reader.line(); !title.empty(); title = reader.line()) {
    reader.line();
    if (title == "crossfield_angles") {
      for (int f = 0; f < surface.number_of_faces(); ++f)
        angles.push_back(reader.number<double>());
    } else if (title == "fixed" || title == "fixed_vertices") {
      const int elements = reader.number<int>();
      for (int i = 0; i < elements; ++i)
        reader.number<int>();
    } else if (title == "matchings" || title == "MI_matchings")
      references = read_matchings(reader, surface, false, field);
    else if (title == "matchings_and_sharp" || title == "MI_matchings_and_sharp")
      references = read_matchings(reader, surface, true, field);
    else
      reader.fail("\"" + title + "\" is no section of an .ffield file");
  }
  for (int f = 0; f < int(angles.size()); ++f) {
    const int reference = references.empty() ? 3 * f : references[f];
    field.directions[f] = surface.direction(f, surface.halfedge_angle(reference) + angles[f]);
  }
}

inline Field_in_file read_ffield(std::istream& in, const Triangle_surface& surface)
{
  Line_reader reader(in, "read_ffield");
  const std::string kind = reader.line();
  if (kind != "target_frame" && kind != "target frame" && kind != "shape_operator")
    reader.fail("\"" + kind + "\" is neither a target frame nor a shape operator");
  reader.line();
  expect_number_of_faces(reader, surface);
  reader.line(); // the names of the columns
  reader.line();
  Field_in_file result;
  result.directions.resize(surface.number_of_faces());
  read_frames(reader, result);
  read_sections(reader, surface, result);
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_IO_READ_FIELD_H
