// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_CURVATURE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_CURVATURE_H

#include <CGAL/Quad_layouts/internal/field/Face_connection.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

using Complex = std::complex<double>;

// the signed angle between the normals of the faces beside the edge of h, 0 on the border
inline double dihedral_angle(const Triangle_surface& surface, int h)
{
  if (surface.is_border(h))
    return 0;
  const Point n = surface.area_vector(surface.face(h));
  const Point m = surface.area_vector(surface.face(surface.opposite(h)));
  return std::atan2(n.cross(m).dot(surface.vector(h).normalized()), n.dot(m));
}

// The directions of principal curvature, as *pulls* on the crosses of the faces: complex numbers
// whose argument is four times the angle of the direction, and whose absolute value says how
// strongly the face has it.
//
// The curvature of a mesh sits on its edges (Cohen-Steiner and Morvan 2003). An edge of length l,
// direction phi and dihedral angle beta gives each of its faces half of beta l e^(2 i phi); the
// sum D of a face is the trace-free part of its shape operator, |D| being the area times the
// difference of the principal curvatures. This is exact on prisms and cylinders however thin
// their triangles are. The pull is D^2 / area: it has no unit, and does not fade in finer meshes.
//
// A crease is a direction by itself, not a sample of a smooth curvature: in the corner of a cube
// two creases support the same cross, but would cancel in D. So creases are squared one by one.
class Curvature_pulls
{
public:
  explicit Curvature_pulls(const Face_connection& connection)
    : m_pull(connection.surface().number_of_faces())
  {
    const Triangle_surface& surface = connection.surface();
    std::vector<Complex> smooth(m_pull.size());
    for (int h = 0; h < surface.number_of_halfedges(); ++h) {
      const double angle = dihedral_angle(surface, h);
      const Complex d = std::polar(angle * surface.length(h) / 2, 2 * connection.halfedge_angle(h));
      if (std::abs(angle) > smallest_crease)
        m_pull[surface.face(h)] += d * d;
      else
        smooth[surface.face(h)] += d;
    }
    for (std::size_t f = 0; f < m_pull.size(); ++f)
      m_pull[f] = (m_pull[f] + smooth[f] * smooth[f]) / connection.area(int(f));
  }

  // the pulls times `weight`. That on one face is bounded, lest single edges of a noisy surface
  // hold the field against all their surroundings.
  std::vector<Complex> weighted(double weight) const
  {
    std::vector<Complex> result = m_pull;
    for (Complex& pull : result) {
      const double strength = std::abs(pull);
      if (strength * weight > bound)
        pull *= bound / strength;
      else
        pull *= weight;
    }
    return result;
  }

private:
  static constexpr double smallest_crease = 0.7; // radians, about 40 degrees
  static constexpr double bound = 0.05;

  std::vector<Complex> m_pull;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_CURVATURE_H
