// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Remeshes a triangle mesh with quads, stage by stage, and looks at what each one makes.

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/embed_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_mesh.h>
#include <CGAL/Quad_layouts/measure_quad_layout.h>
#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/smooth_quad_mesh.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>
#include <CGAL/Quad_layouts/visitor.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace QL = CGAL::Quad_layouts;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// tells how long the stages take
struct Clock : QL::Default_visitor
{
  void after_stage(const char* name, double seconds)
  {
    std::cout << name << ": " << seconds << " s\n";
  }
};

void remesh(const Mesh& mesh, Mesh& quads)
{
  const auto np = QL::parameters::maximum_deviation(15).maximum_displacement(2).visitor(Clock());

  const QL::Cross_field field = QL::compute_cross_field(mesh, np);
  std::cout << "  " << field.number_of_singularities() << " singularities of the field\n";

  const QL::T_mesh t_mesh = QL::trace_motorcycle_graph(field, np);
  std::cout << "  " << t_mesh.traces.size() << " traces, which cut the surface into "
            << t_mesh.number_of_faces() << " patches\n";

  const QL::Quantization quantization = QL::quantize(t_mesh, np.maximum_search_time(10));
  std::cout << "  an objective of " << quantization.objective << ", at most "
            << 100 * quantization.gap() << " % above the least\n";

  const QL::Quad_layout layout = QL::extract_quad_layout(t_mesh, quantization);
  const QL::Quad_layout_measures simplicity = QL::measure_quad_layout(layout);
  std::cout << "  a layout of " << simplicity.patches << " patches with "
            << simplicity.irregular_vertices << " irregular vertices\n";

  const QL::Integer_grid_map map = QL::embed_quad_layout(t_mesh, layout, np);
  std::cout << "  a map of " << map.surface().number_of_faces() << " triangles, " << map.inverted
            << " of them inverted\n"
            << "  " << QL::layout_curves(map, layout).size()
            << " edges of the layout as curves on the surface\n";

  // each quad is told its patch
  const auto patch = quads.add_property_map<Mesh::Face_index, int>("f:patch", -1).first;
  QL::extract_quad_mesh(map, layout, quads, QL::parameters::face_patch_map(patch));
  std::cout << "  average scaled Jacobian " << QL::measure_quad_mesh(quads).msj_average << '\n';

  QL::smooth_quad_mesh(quads, mesh, np);
  std::cout << "  average scaled Jacobian " << QL::measure_quad_mesh(quads).msj_average << '\n';
}

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elk.off");
  Mesh mesh, quads;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "cannot read " << file << '\n';
    return EXIT_FAILURE;
  }
  try {
    remesh(mesh, quads);
  } catch (const QL::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return CGAL::IO::write_polygon_mesh("quads.off", quads) ? EXIT_SUCCESS : EXIT_FAILURE;
}
