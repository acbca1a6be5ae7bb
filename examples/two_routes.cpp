// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Compares the layouts of a model by two routes: along the directions of its cross field, and along the lines
// of a seamless parametrization, whose T-mesh has exactly equal opposite sides.

#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/compute_t_mesh.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/measure_quad_layout.h>
#include <CGAL/Quad_layouts/quantize.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace QL = CGAL::Quad_layouts;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// says why the parametrization is not taken, if it is not
struct Reporter : QL::Default_visitor
{
  void changed_route(const char* reason) { std::cout << "no parametrization: " << reason << '\n'; }
};

// the largest difference between the lengths of opposite sides of a patch
double largest_difference(const QL::T_mesh& t_mesh)
{
  const auto length = [&](const std::vector<int>& side) {
    double sum = 0;
    for (const int h : side)
      sum += t_mesh.length(QL::T_mesh::edge(h));
    return sum;
  };
  double result = 0;
  for (int patch = 0; patch < t_mesh.number_of_faces(); ++patch) {
    const auto sides = t_mesh.sides(patch);
    for (const int i : {0, 1})
      result = (std::max)(result, std::abs(length(sides[i]) - length(sides[i + 2])));
  }
  return result;
}

void try_route(const QL::Cross_field& field, QL::Layout_route route)
{
  const QL::T_mesh t_mesh = QL::compute_t_mesh(
      field, QL::parameters::layout_route(route).visitor(Reporter()));
  const QL::Quad_layout_measures layout = QL::measure_quad_layout(
      QL::extract_quad_layout(t_mesh, QL::quantize(t_mesh)));
  std::cout << (t_mesh.route == QL::FIELD ? "field: " : "parametrization: ") << layout.patches
            << " patches, opposite sides in the T-mesh differ by up to "
            << largest_difference(t_mesh) << '\n';
}

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/handle.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  try {
    const QL::Cross_field field = QL::compute_cross_field(mesh);
    for (const QL::Layout_route route : {QL::FIELD, QL::PARAMETRIZATION})
      try_route(field, route);
    return EXIT_SUCCESS;
  } catch (const QL::Error& error) {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
