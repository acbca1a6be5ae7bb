// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/IO/cross_field.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_cross_field_IO)

namespace QL = CGAL::Quad_layouts;
namespace params = QL::parameters;

using generated::Mesh;
using generated::Point;
using generated::Vector;
using Directions = Mesh::Property_map<Mesh::Face_index, Vector>;
using Edge_flags = Mesh::Property_map<Mesh::Edge_index, bool>;

namespace {

using QL::internal::right_angle;
const std::vector<QL::Cross_field_format> formats = {QL::ROSY, QL::RAWFIELD, QL::FFIELD,
                                                     QL::FFIELD_MPZ14};

Edge_flags sharp_edges(Mesh& mesh, const char* name)
{
  const auto result = mesh.add_property_map<Mesh::Edge_index, bool>(name, false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 40, result);
  return result;
}

QL::Cross_field through_file(const QL::Cross_field& field, QL::Cross_field_format format,
                             Mesh& mesh, Edge_flags is_sharp)
{
  std::stringstream file;
  BOOST_TEST(QL::IO::write_cross_field(file, field, format));
  const auto directions = mesh.add_property_map<Mesh::Face_index, Vector>("f:read").first;
  const auto read = mesh.add_property_map<Mesh::Edge_index, bool>("e:read", true).first;
  QL::IO::read_cross_field(file, format, mesh, directions,
                           params::default_values().edge_is_constrained_map(read));
  for (const auto e : edges(mesh))
    BOOST_TEST(read[e] == (format == QL::FFIELD_MPZ14 && is_sharp[e] && !mesh.is_border(e)));
  return QL::compute_cross_field(
      mesh, params::face_direction_map(directions).edge_is_constrained_map(is_sharp));
}

void check_round_trips(Mesh mesh)
{
  const Edge_flags is_sharp = sharp_edges(mesh, "e:sharp");
  const QL::Cross_field field = QL::compute_cross_field(
      mesh, params::default_values().edge_is_constrained_map(is_sharp));
  const auto& surface = field.surface();
  const int nf = int(num_faces(mesh)), nv = int(num_vertices(mesh));
  // a file has one direction for each face, and so only the singularities at vertices of such faces
  std::vector<char> is_in_divided_face(surface.number_of_vertices(), 0);
  for (int h = 3 * nf; h < surface.number_of_halfedges(); ++h)
    is_in_divided_face[surface.source(h)] = 1;
  for (const QL::Cross_field_format format : formats) {
    const QL::Cross_field same = through_file(field, format, mesh, is_sharp);
    for (int f = 0; f < nf; ++f)
      BOOST_TEST(std::abs(std::remainder(same.angle(f) - field.angle(f), right_angle)) < 1e-9);
    for (int v = 0; v < nv; ++v)
      if (!is_in_divided_face[v])
        BOOST_TEST(same.index(v) == field.index(v));
  }
}

// the numbers after the title of a section
std::vector<double> section(const std::string& text, const std::string& title)
{
  std::istringstream rest(text.substr(text.find("\n" + title + "\n") + title.size() + 2));
  std::vector<double> result;
  for (double x; rest >> x;)
    result.push_back(x);
  return result;
}

Vector direction_read_from(const std::string& text, QL::Cross_field_format format)
{
  Mesh mesh = generated::mesh_of({Point(0, 0, 0), Point(2, 0, 0), Point(0, 2, 0)}, {{0, 1, 2}});
  const auto directions = mesh.add_property_map<Mesh::Face_index, Vector>("f:d").first;
  std::istringstream file(text);
  QL::IO::read_cross_field(file, format, mesh, directions);
  return directions[Mesh::Face_index(0)];
}

void check_direction(const Vector& v, double x, double y)
{
  BOOST_TEST(std::abs(v.x() - x) < 1e-12);
  BOOST_TEST(std::abs(v.y() - y) < 1e-12);
  BOOST_TEST(std::abs(v.z()) < 1e-12);
}

} // namespace

BOOST_AUTO_TEST_CASE(by_hand)
{
  check_direction(direction_read_from("1\n4\n1 0 0\n", QL::ROSY), 1, 0);
  check_direction(direction_read_from("4 1\n0 1 0 -1 0 0 0 -1 0 1 0 0\n", QL::RAWFIELD), 0, 1);
  const std::string vcg = "# frame generated with VCG \ntarget frame \n1\nk1\t k2\t k1v_x\n"
                          "1 1 0 1 0 -1 0 0\n";
  check_direction(direction_read_from(vcg, QL::FFIELD), 0, 1);

  // the angle is measured from the halfedge that ends in the vertex named first
  const std::string frame = "# version 2\ntarget_frame\n1\nk1 k2\n1 1 0 1 0 -1 0 0\n";
  const std::string angle = frame + "crossfield_angles\n0.25\nfixed\n0\nfixed_vertices\n1 2\n";
  const double c = std::cos(0.25), s = std::sin(0.25);
  check_direction(direction_read_from(angle + "MI_matchings\n1 2 0 0 0 0\n", QL::FFIELD_MPZ14), c,
                  s);
  check_direction(
      direction_read_from(angle + "matchings_and_sharp\n0 1 2 0 0 0 1 0 0\n", QL::FFIELD_MPZ14), s,
      -c);
  // without angles the frame counts, whichever dialect is expected
  check_direction(direction_read_from(frame + "fixed\n0\n", QL::FFIELD), 0, 1);
}

BOOST_AUTO_TEST_CASE(round_trips)
{
  check_round_trips(generated::icosphere(2));
  check_round_trips(generated::noisy(generated::torus(20, 10), 0.05, 3));
  check_round_trips(generated::cube(3));
  // faces with two edges on the border are divided
  check_round_trips(generated::plate_with_holes(3, 3, {{1, 1}}, 2));
}

// Matchings that are written must be those of the angles that are written: theta + kappa + p pi/2
// is the angle of the neighbour but for the small turn of the field, and opposite ones cancel.
BOOST_AUTO_TEST_CASE(matchings_fit_angles)
{
  for (Mesh mesh : {generated::icosphere(2), generated::cube(2),
                    generated::plate_with_holes(3, 3, {{1, 1}}, 2)}) {
    const Edge_flags is_sharp = sharp_edges(mesh, "e:sharp");
    const QL::Cross_field field = QL::compute_cross_field(
        mesh, params::default_values().edge_is_constrained_map(is_sharp));
    std::ostringstream file;
    QL::IO::write_cross_field(file, field, QL::FFIELD_MPZ14);
    const std::vector<double> angles = section(file.str(), "crossfield_angles");
    const std::vector<double> rows = section(file.str(), "MI_matchings_and_sharp");
    const auto whole = QL::internal::make_triangle_surface(mesh, mesh.points());
    const int nf = whole.number_of_faces();
    BOOST_TEST_REQUIRE(int(angles.size()) == nf);
    BOOST_TEST_REQUIRE(int(rows.size()) == 9 * nf);
    for (int h = 0; h < whole.number_of_halfedges(); ++h) {
      const int f = whole.face(h), g = whole.opposite(h);
      BOOST_TEST(rows[9 * f + h % 3] == whole.target(h));
      if (g < 0)
        continue;
      const double p = rows[9 * f + 3 + h % 3], q = rows[9 * whole.face(g) + 3 + g % 3];
      const double kappa = std::remainder(whole.transport(h), 4 * right_angle);
      BOOST_TEST(std::fmod(p + q, 4) == 0);
      const double turn = angles[f] + kappa + p * right_angle - angles[whole.face(g)];
      BOOST_TEST(std::abs(turn) < 0.51 * right_angle);
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_files_are_refused)
{
  const auto expect = [](const std::string& text, QL::Cross_field_format format,
                         const std::string& words) {
    BOOST_CHECK_EXCEPTION(direction_read_from(text, format), QL::Invalid_file,
                          [&](const QL::Invalid_file& error) {
                            return std::string(error.what()).find(words) != std::string::npos;
                          });
  };
  expect("", QL::ROSY, "ends after line 0");
  expect("1\n4\n1 0\n", QL::ROSY, "ends after line 3");
  expect("1\n6\n1 0 0\n", QL::ROSY, "line 2: a field of degree 6");
  expect("# two faces\n2\n4\n", QL::ROSY, "line 2: the field has 2 faces, the mesh has 1");
  expect("4 1\n1 0 0 0 1 0 x", QL::RAWFIELD, "line 2: a number is expected");
  expect("#\nsomething\n", QL::FFIELD, "line 2: \"something\" is neither");
  const std::string frame = "target_frame\n1\nk1 k2\n1 1 0 1 0 -1 0 0\n";
  expect(frame + "colours\n1\n", QL::FFIELD, "line 6: \"colours\" is no section");
  expect(frame + "matchings\n0 2 1 0 0 0\n", QL::FFIELD, "face 0 has other vertices");
}

BOOST_AUTO_TEST_SUITE_END()
