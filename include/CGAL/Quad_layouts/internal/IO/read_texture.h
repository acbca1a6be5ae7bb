// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_IO_READ_TEXTURE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_IO_READ_TEXTURE_H

#include <CGAL/Quad_layouts/internal/IO/Line_reader.h>
#include <CGAL/Quad_layouts/internal/IO/first_halfedge.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <array>
#include <istream>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Reads the texture coordinates of an OBJ file for the corners of a surface, whose faces are those
// of the file.
class Texture_reader
{
public:
  Texture_reader(std::istream& in, const Triangle_surface& surface)
    : m_reader(in, "read_seamless_parametrization"), m_surface(surface),
      m_result(surface.number_of_halfedges())
  {
  }

  // the coordinates of the corner at the source of each halfedge
  std::vector<Point2> read()
  {
    while (!m_reader.line().empty()) {
      const std::string keyword = m_reader.word();
      if (keyword == "v")
        ++m_number_of_vertices;
      else if (keyword == "vt")
        read_coordinates();
      else if (keyword == "f")
        read_face();
    }
    if (m_number_of_faces < m_surface.number_of_faces())
      m_reader.fail("the mesh has more faces");
    return m_result;
  }

private:
  struct Corner
  {
    int vertex, texture; // from 0
  };

  void read_coordinates()
  {
    const double u = m_reader.number<double>(), v = m_reader.number<double>();
    m_texture.emplace_back(u, v);
  }

  void read_face()
  {
    if (m_number_of_faces == m_surface.number_of_faces())
      m_reader.fail("the mesh has no such face");
    const std::array<Corner, 3> corners = {read_corner(), read_corner(), read_corner()};
    if (!m_reader.word().empty())
      m_reader.fail("the face is no triangle");
    int h = first_halfedge(m_reader, m_surface, m_number_of_faces,
                           {corners[0].vertex, corners[1].vertex, corners[2].vertex});
    for (const Corner& corner : corners) {
      m_result[h] = m_texture[corner.texture];
      h = Triangle_surface::next(h);
    }
    ++m_number_of_faces;
  }

  // reads "vertex/texture" or "vertex/texture/normal"
  Corner read_corner()
  {
    std::istringstream word(m_reader.word());
    int vertex = 0, texture = 0;
    char slash = 0;
    if (!(word >> vertex >> slash >> texture) || slash != '/')
      m_reader.fail("a corner with texture coordinates is expected");
    return {index(vertex, m_number_of_vertices), index(texture, int(m_texture.size()))};
  }

  // OBJ files count from 1, or back from the last with -1
  int index(int number, int count) const
  {
    const int result = number < 0 ? count + number : number - 1;
    if (number == 0 || result < 0 || result >= count)
      m_reader.fail("there is no element " + std::to_string(number) + " before this face");
    return result;
  }

  Line_reader m_reader;
  const Triangle_surface& m_surface;
  int m_number_of_vertices = 0, m_number_of_faces = 0;
  std::vector<Point2> m_texture, m_result;
};

inline std::vector<Point2> read_texture(std::istream& in, const Triangle_surface& surface)
{
  return Texture_reader(in, surface).read();
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_IO_READ_TEXTURE_H
