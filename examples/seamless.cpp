// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Parametrizes a model seamlessly, and writes the charts as texture coordinates: a grid as texture
// becomes a net of lines on the model that follows the cross field and has no seams but for its
// line numbers.

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/parametrize_seamlessly.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace QL = CGAL::Quad_layouts;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// writes the surface, which may have more triangles than the mesh, with coordinates for each corner
void write_textured(std::ostream& out, const QL::Seamless_parametrization& map)
{
  const auto& surface = map.surface();
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    out << "v " << surface.point(v).transpose() << '\n';
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    out << "vt " << map.point(h).transpose() << '\n';
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    out << (h % 3 == 0 ? "f " : " ") << surface.source(h) + 1 << '/' << h + 1
        << (h % 3 == 2 ? "\n" : "");
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  try {
    const QL::Cross_field field = QL::compute_cross_field(mesh);
    const QL::Seamless_parametrization map = QL::parametrize_seamlessly(field);
    int seams = 0;
    for (int h = 0; h < map.surface().number_of_halfedges(); ++h)
      seams += map.transition(h).quarter_turns != 0;
    std::cout << field.number_of_singularities() << " cones, " << seams / 2
              << " edges with a quarter-turn, " << map.inverted << " inverted triangles, "
              << map.wrong_winding << " vertices with a wrong sum of angles" << std::endl;
    std::ofstream out("seamless.obj");
    write_textured(out, map);
    return out.good() ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const QL::Error& error) {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
