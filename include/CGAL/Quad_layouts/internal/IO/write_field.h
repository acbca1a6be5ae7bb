// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_IO_WRITE_FIELD_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_IO_WRITE_FIELD_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/internal/field/matching.h>

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

// A face of the user's mesh has the field of its first part, whose first halfedge points the same
// way.

// writes the first directions of each face, a line for each
inline void write_directions(std::ostream& out, const Cross_field& field, int number_of_directions)
{
  for (int f = 0; f < field.surface().original().number_of_faces(); ++f)
    for (int d = 0; d < number_of_directions; ++d) {
      write_direction(out, field, f, d);
      out << (d + 1 < number_of_directions ? ' ' : '\n');
    }
}

// writes the columns of the frames of an .ffield file
inline void write_frames(std::ostream& out, const Cross_field& field)
{
  const int nf = field.surface().original().number_of_faces();
  out << nf << "\nk1\tk2\tk1v_x\tk1v_y\tk1v_z\tk2v_x\tk2v_y\tk2v_z\n";
  for (int f = 0; f < nf; ++f) {
    out << "1 1 ";
    write_direction(out, field, f, 0);
    out << ' ';
    write_direction(out, field, f, 1);
    out << '\n';
  }
}

// writes the angles of all faces in a line
inline void write_angles(std::ostream& out, const Cross_field& field)
{
  const int nf = field.surface().original().number_of_faces();
  for (int f = 0; f < nf; ++f)
    out << field.angle(f) << (f + 1 < nf ? ' ' : '\n');
}

// says if the first parts of the faces beside a halfedge of the user's mesh are adjacent there
inline bool is_between_first_parts(const Triangle_surface& surface, int h)
{
  const auto keeps_its_ends = [&](int g) {
    return surface.source(g) == surface.original().source(g) &&
           surface.target(g) == surface.original().target(g);
  };
  return keeps_its_ends(h) && keeps_its_ends(surface.original().opposite(h));
}

// The matching of a halfedge of the user's mesh as the integer p for which theta + kappa + p pi/2
// is nearest to the angle of the neighbour, kappa being the transport in (-pi, pi]. It is, mod 4,
// the negative of ours; from and to divided faces it is the one for which the field turns least.
inline int mixed_integer_matching(const Cross_field& field, int h)
{
  const Triangle_surface& original = field.surface().original();
  if (original.is_border(h))
    return 0;
  double kappa = std::remainder(original.transport(h), 4 * right_angle);
  if (kappa <= -2 * right_angle)
    kappa += 4 * right_angle;
  const double turn = (field.angle(original.face(original.opposite(h))) -
                       field.angle(original.face(h)) - kappa) /
                      right_angle;
  if (!is_between_first_parts(field.surface(), h))
    return int(std::lround(turn));
  const int matching = -field.matching(h);
  return matching + 4 * int(std::lround((turn - matching) / 4));
}

// writes, for each face, its vertices, and the matchings and the sharpness of the halfedges that
// end in them; the angle of the face is measured from the first of these halfedges
inline void write_matchings(std::ostream& out, const Cross_field& field)
{
  const Triangle_surface& original = field.surface().original();
  for (int f = 0; f < original.number_of_faces(); ++f) {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      out << original.target(h) << ' ';
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      out << mixed_integer_matching(field, h) << ' ';
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const bool is_sharp = original.is_fixed(h) && !original.is_border(h);
      out << is_sharp << (h < 3 * f + 2 ? ' ' : '\n');
    }
  }
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_IO_WRITE_FIELD_H
