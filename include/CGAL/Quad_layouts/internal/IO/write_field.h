// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_IO_WRITE_FIELD_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_IO_WRITE_FIELD_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/internal/field/matching.h>
#include <CGAL/Quad_layouts/internal/surface/Split_faces.h>

#include <cmath>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

inline void write_direction(std::ostream& out, const Cross_field& field, int f, int d)
{
  const Point v = field.direction(f, d);
  out << v.x() << ' ' << v.y() << ' ' << v.z();
}

// writes the first directions of each face, a line for each
inline void write_directions(std::ostream& out, const Cross_field& field, const Split_faces& faces,
                             int number_of_directions)
{
  for (int f = 0; f < faces.number_of_faces(); ++f)
    for (int d = 0; d < number_of_directions; ++d) {
      write_direction(out, field, f, d);
      out << (d + 1 < number_of_directions ? ' ' : '\n');
    }
}

// writes the columns of the frames of an .ffield file
inline void write_frames(std::ostream& out, const Cross_field& field, const Split_faces& faces)
{
  out << faces.number_of_faces() << "\nk1\tk2\tk1v_x\tk1v_y\tk1v_z\tk2v_x\tk2v_y\tk2v_z\n";
  for (int f = 0; f < faces.number_of_faces(); ++f) {
    out << "1 1 ";
    write_direction(out, field, f, 0);
    out << ' ';
    write_direction(out, field, f, 1);
    out << '\n';
  }
}

// the matching of the field from face f of the user's mesh to the one beside a side of it
inline int matching_of_side(const Cross_field& field, const Split_faces& faces, int f, int side)
{
  const auto& surface = field.surface();
  const int h = faces.halfedge(f, side), g = surface.opposite(h);
  const int neighbour = surface.origin(surface.face(g)), its_side = faces.side_of(g);
  // from the first part of a split face to that at side 1 or 2 the way leads over its halfedge 1 or 2
  const auto inside = [&](int face, int k) {
    return faces.is_split(face) && k > 0 ? field.matching(3 * face + k) : 0;
  };
  return (inside(f, side) + field.matching(h) - inside(neighbour, its_side)) & 3;
}

// writes the angles of all faces in a line
inline void write_angles(std::ostream& out, const Cross_field& field, const Split_faces& faces)
{
  const int nf = faces.number_of_faces();
  for (int f = 0; f < nf; ++f)
    out << field.angle(f) << (f + 1 < nf ? ' ' : '\n');
}

// The matching of a side as the integer p for which theta + kappa + p pi/2 is nearest to the angle of the
// neighbour, kappa being the transport in (-pi, pi]. It is, mod 4, the negative of ours.
inline int mixed_integer_matching(const Cross_field& field, const Split_faces& faces,
                                  const Triangle_surface& whole, int f, int side)
{
  const int h = 3 * f + side;
  if (whole.is_border(h))
    return 0;
  double kappa = std::remainder(whole.transport(h), 4 * right_angle);
  if (kappa <= -2 * right_angle)
    kappa += 4 * right_angle;
  const double turn = (field.angle(whole.face(whole.opposite(h))) - field.angle(f) - kappa) /
                      right_angle;
  const int matching = -matching_of_side(field, faces, f, side);
  return matching + 4 * int(std::lround((turn - matching) / 4));
}

// writes, for each face, its vertices, and the matchings and the sharpness of the halfedges that end in
// them; the angle of the face is measured from the first of these halfedges
inline void write_matchings(std::ostream& out, const Cross_field& field, const Split_faces& faces)
{
  const Triangle_surface whole = faces.whole();
  for (int f = 0; f < faces.number_of_faces(); ++f) {
    for (int side = 0; side < 3; ++side)
      out << whole.target(3 * f + side) << ' ';
    for (int side = 0; side < 3; ++side)
      out << mixed_integer_matching(field, faces, whole, f, side) << ' ';
    for (int side = 0; side < 3; ++side) {
      const int h = faces.halfedge(f, side);
      const bool is_sharp = field.surface().is_fixed(h) && !field.surface().is_border(h);
      out << is_sharp << (side < 2 ? ' ' : '\n');
    }
  }
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_IO_WRITE_FIELD_H
