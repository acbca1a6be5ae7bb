// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Parametrizes a model with lines that are close to each other at its lower end and far apart at
// the upper one, and along one direction of the field twice as far apart as along the other.

#include <CGAL/Quad_layouts/IO/seamless_parametrization.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/parametrize_seamlessly.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace QL = CGAL::Quad_layouts;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// a property map with the lengths along directions 0 and 1 of the field in each of its faces
class Length_map
{
public:
  using key_type = int;
  using value_type = std::array<double, 2>;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  Length_map(const QL::Cross_field& field, double length) : m_field(&field), m_length(length)
  {
    const auto by_height = [](const auto& p, const auto& q) { return p.z() < q.z(); };
    const auto& points = field.surface().points();
    const auto ends = std::minmax_element(points.begin(), points.end(), by_height);
    m_bottom = ends.first->z();
    m_height = ends.second->z() - m_bottom;
  }

  friend value_type get(const Length_map& map, int f)
  {
    const auto& surface = map.m_field->surface();
    const double above = surface.point(surface.source(3 * f)).z() - map.m_bottom;
    const double length = map.m_length * (0.5 + above / map.m_height);
    // the direction that is steeper gets the longer lines
    const bool is_steep = std::abs(map.m_field->direction(f, 0).z()) >
                          std::abs(map.m_field->direction(f, 1).z());
    return {is_steep ? 2 * length : length, is_steep ? length : 2 * length};
  }

private:
  const QL::Cross_field* m_field;
  double m_length, m_bottom, m_height;
};

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
    const Length_map lengths(field, 0.01 * field.surface().diagonal());
    const QL::Seamless_parametrization map = QL::parametrize_seamlessly(
        field, QL::parameters::target_edge_length_map(lengths));
    std::cout << map.inverted << " inverted triangles, " << map.wrong_winding
              << " vertices with a wrong sum of angles" << std::endl;
    std::ofstream out("sized.obj");
    return QL::IO::write_seamless_parametrization(out, map) ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const QL::Error& error) {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
