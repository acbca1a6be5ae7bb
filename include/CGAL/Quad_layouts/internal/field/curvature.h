// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_CURVATURE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_CURVATURE_H

#include <CGAL/Quad_layouts/internal/field/Face_connection.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

using Complex = std::complex<double>;

// the signed angle between the normals of the faces beside the edge of h
inline double dihedral_angle(const Triangle_surface& surface, int h)
{
  const Point n = surface.area_vector(surface.face(h));
  const Point m = surface.area_vector(surface.face(surface.opposite(h)));
  return std::atan2(n.cross(m).dot(surface.vector(h).normalized()), n.dot(m));
}

// the trace-free part of the shape operator of each face, integrated over the face, as a complex number D: |D| is the
// area times the difference of the principal curvatures, and half its argument a principal direction.
//
// The curvature of a mesh sits on its edges (Cohen-Steiner and Morvan 2003): an edge of length l with
// direction phi and dihedral angle beta carries beta l e^(2 i phi), half of it in each of its faces.
// This is exact on prisms and cylinders however thin their triangles are, and sees a crease as what it is.
inline std::vector<Complex> curvature_deviators(const Face_connection& connection)
{
  const Triangle_surface& surface = connection.surface();
  std::vector<Complex> result(surface.number_of_faces());
  for (int e = 0; e < surface.number_of_edges(); ++e) {
    const int h = surface.halfedge_of_edge(e), g = surface.opposite(h);
    const double bend = dihedral_angle(surface, h) * surface.length(h) / 2;
    for (int side : {h, g})
      result[surface.face(side)] += std::polar(bend, 2 * connection.halfedge_angle(side));
  }
  return result;
}

// what pulls the crosses of the faces to the principal directions: the integral of the squared difference of the
// curvatures, times `alignment`. That has no unit, and a crease pulls as strongly in a finer mesh. The pull on one
// face is bounded, lest single edges of a noisy surface hold the field against all their surroundings.
inline std::vector<Complex> curvature_pulls(const Face_connection& connection, double alignment)
{
  constexpr double bound = 0.015;
  std::vector<Complex> result = curvature_deviators(connection);
  for (int f = 0; f < int(result.size()); ++f) {
    const double size = std::abs(result[f]);
    if (size > 0) {
      const Complex direction = result[f] / size;
      result[f] = direction * direction * (std::min)(alignment * size * size / connection.area(f), bound);
    }
  }
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_CURVATURE_H
