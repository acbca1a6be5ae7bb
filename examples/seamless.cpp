// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Parametrizes a model seamlessly, and writes the charts as texture coordinates: a grid as texture
// becomes a net of lines on the model that follows the cross field and has no seams but for its
// line numbers. Then reads such a file, as another tool may have made it, and traces in it.

#include <CGAL/Quad_layouts/IO/seamless_parametrization.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/parametrize_seamlessly.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace QL = CGAL::Quad_layouts;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

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
    if (!QL::IO::write_seamless_parametrization(out, map))
      return EXIT_FAILURE;
    out.close();

    std::ifstream in("seamless.obj");
    const QL::Seamless_parametrization read = QL::IO::read_seamless_parametrization(in, mesh);
    const QL::T_mesh t_mesh = QL::trace_motorcycle_graph(read);
    std::cout << t_mesh.number_of_faces() << " patches of the T-mesh in the parametrization read, "
              << QL::compute_cross_field(read).number_of_singularities() << " cones" << std::endl;
    return EXIT_SUCCESS;
  } catch (const QL::Error& error) {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
