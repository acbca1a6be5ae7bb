// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_FACE_CONNECTION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_FACE_CONNECTION_H

#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The geometry that fields on faces are computed with: the angles of the halfedges, the transports
// across edges (the discrete Levi-Civita connection on the dual graph), areas and the weights of
// dual edges, which those on the border do not have. All of it is looked up often, and costs arc
// tangents and roots: hence the tables.
class Face_connection
{
public:
  explicit Face_connection(const Triangle_surface& surface) : m_surface(&surface)
  {
    compute_angles();
    compute_areas();
    compute_weights();
  }

  const Triangle_surface& surface() const { return *m_surface; }

  // the direction of h in the frame of its face, in [0, 2 pi)
  double halfedge_angle(int h) const { return m_halfedge_angle[h]; }

  // what must be added to an angle in the frame of face(h) to express it in that of the opposite
  // face. The transport back is the negative, not only up to full turns: rotations must cancel in
  // pairs.
  double transport(int h) const
  {
    const int g = m_surface->opposite(h);
    return m_halfedge_angle[g] - m_halfedge_angle[h] + (h < g ? CGAL_PI : -CGAL_PI);
  }

  // the angle at source(h) in face(h). The three of a face sum to pi up to rounding, whatever its
  // shape, because they are differences of the angles that make up the transports.
  double corner_angle(int h) const
  {
    const double turn = m_halfedge_angle[h] - m_halfedge_angle[Triangle_surface::prev(h)];
    return CGAL_PI - (turn < 0 ? turn + 2 * CGAL_PI : turn);
  }

  // the area of face f; not less than what the area of a needle loses by rounding, so that
  // quotients by it are finite
  double area(int f) const { return m_area[f]; }

  // length over dual length of edge e, the latter being the part normal to e of the way from one
  // barycentre to the other: positive for triangles of any shape, and the cotangent weight for
  // equilateral ones; bounded for the sake of the condition of systems of equations. 0 on the
  // border
  double weight(int e) const { return m_weight[e]; }

private:
  void compute_angles()
  {
    const int nh = m_surface->number_of_halfedges();
    m_halfedge_angle.resize(nh);
    for (int h = 0; h < nh; ++h)
      m_halfedge_angle[h] = m_surface->halfedge_angle(h);
  }

  void compute_areas()
  {
    constexpr double smallest_ratio = 1e-12;
    const int nf = m_surface->number_of_faces();
    m_area.resize(nf);
    for (int f = 0; f < nf; ++f) {
      const double square = m_surface->vector(3 * f).squaredNorm() +
                            m_surface->vector(3 * f + 1).squaredNorm();
      m_area[f] = (std::max)(m_surface->area(f), smallest_ratio * square);
    }
  }

  void compute_weights()
  {
    constexpr double bound = 1e6;
    const int ne = m_surface->number_of_edges();
    m_weight.assign(ne, 0);
    for (int e = 0; e < ne; ++e) {
      const int h = m_surface->halfedge_of_edge(e), g = m_surface->opposite(h);
      if (g < 0)
        continue;
      const double area = m_area[m_surface->face(h)] + m_area[m_surface->face(g)];
      m_weight[e] = (std::min)(1.5 * m_surface->vector(h).squaredNorm() / area, bound);
    }
  }

  const Triangle_surface* m_surface;
  std::vector<double> m_halfedge_angle, m_area, m_weight;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_FACE_CONNECTION_H
