// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_MATCHING_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_MATCHING_H

#include <CGAL/Quad_layouts/internal/field/Face_connection.h>
#include <CGAL/Quad_layouts/internal/right_angle.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// How a field of directions in the faces goes on across the edges.
//
// The *period jump* of halfedge h is the integer p for which direction d of face(h) continues as
// direction d + p of the face on the other side; the *rotation* of h is the angle by which the
// field then turns more than the surface, theta' + p pi/2 - theta - transport(h). Both change
// their sign with the direction of h. The matching is p mod 4; the index needs p and the angles.

// the period jumps that turn the field least. Each edge is rounded once, on its canonical
// halfedge, so the two halfedges agree even if the field turns by an eighth of a turn.
inline std::vector<int> principal_period_jumps(const Face_connection& connection,
                                               const std::vector<double>& angles)
{
  const Triangle_surface& surface = connection.surface();
  std::vector<int> jumps(surface.number_of_halfedges(), 0);
  for (int e = 0; e < surface.number_of_edges(); ++e) {
    const int h = surface.halfedge_of_edge(e), g = surface.opposite(h);
    if (g < 0)
      continue;
    const double turn = angles[surface.face(h)] + connection.transport(h) - angles[surface.face(g)];
    jumps[h] = nearest_quarter_turns(turn);
    jumps[g] = -jumps[h];
  }
  return jumps;
}

// the rotation of halfedge h
inline double rotation(const Face_connection& connection, const std::vector<double>& angles,
                       const std::vector<int>& jumps, int h)
{
  const Triangle_surface& surface = connection.surface();
  const int f = surface.face(h), g = surface.face(surface.opposite(h));
  return angles[g] - angles[f] - connection.transport(h) + jumps[h] * right_angle;
}

// The index of vertex v in quarters. The angle defect of v and the rotations along a loop around
// it sum to a multiple of pi/2 (the frames cancel); so only rounding errors are rounded away.
//
// On the border the index is two minus the quarter-turns that the field makes from one border edge
// to the other, to both of which it is aligned: +1 in the corner of a square.
inline int index(const Face_connection& connection, const std::vector<double>& angles,
                 const std::vector<int>& jumps, int v)
{
  const Triangle_surface& surface = connection.surface();
  double turn = (surface.is_on_border(v) ? 2 : 4) * right_angle;
  surface.for_each_outgoing(v, [&](int h) {
    // counter-clockwise about v, edge h is crossed from its right to its left
    turn -= connection.corner_angle(h);
    if (!surface.is_border(h))
      turn -= rotation(connection, angles, jumps, h);
  });
  const double quarters = turn / right_angle;
  CGAL_assertion(std::abs(quarters - std::round(quarters)) < 0.25);
  return int(std::lround(quarters));
}

// whether an index is too strong for good quads: valences 0, 1 and 2, and those of 8 and more; on
// the border, no quad or more than five
inline bool is_strong(int index)
{
  return index >= 2 || index <= -4;
}

// the indices of all vertices, 0 for isolated ones. The angle defects and the turning of the border
// sum to 2 pi chi and rotations cancel in pairs, hence the indices sum to 4 chi, for any angles and
// antisymmetric jumps.
inline std::vector<int> indices(const Face_connection& connection,
                                const std::vector<double>& angles, const std::vector<int>& jumps)
{
  std::vector<int> result(connection.surface().number_of_vertices());
  for (int v = 0; v < int(result.size()); ++v)
    result[v] = connection.surface().halfedge(v) < 0 ? 0 : index(connection, angles, jumps, v);
  return result;
}

// vertices - edges + faces, without isolated vertices
inline int euler_characteristic(const Triangle_surface& surface)
{
  int vertices = 0;
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    vertices += surface.halfedge(v) >= 0;
  return vertices - surface.number_of_edges() + surface.number_of_faces();
}

// the period jumps mod 4, the form in which they are kept
inline std::vector<signed char> matchings(const std::vector<int>& jumps)
{
  std::vector<signed char> result(jumps.size());
  for (std::size_t h = 0; h < jumps.size(); ++h)
    result[h] = static_cast<signed char>(jumps[h] & 3);
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_MATCHING_H
