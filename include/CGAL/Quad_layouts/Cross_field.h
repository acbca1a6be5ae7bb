// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_CROSS_FIELD_H
#define CGAL_QUAD_LAYOUTS_CROSS_FIELD_H

#include <CGAL/Quad_layouts/internal/right_angle.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>

#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsFunctions

names the ways in which `compute_cross_field()` finds a smooth cross field.
*/
enum Cross_field_method {
  DIFFUSION,    ///< by alternating diffusion and normalization of the crosses
  MIXED_INTEGER ///< by greedy rounding of the period jumps, and a local search
};

/*!
\ingroup PkgQuadLayoutsClasses

is a cross field on a triangle mesh: four directions a quarter-turn apart in each face, a matching
of the directions of adjacent faces, and the index of each vertex that follows.

The elements of the mesh are numbered: face `f` is the `f`-th of `faces(tm)`, vertex `v` the `v`-th
of `vertices(tm)`. The field carries a compact copy of the mesh, its *surface*, in which face `f`
owns the halfedges `3f`, `3f+1`, `3f+2`, in the order in which `halfedge(f, tm)` and its successors
come in the mesh. Where fixed edges are close to each other, faces are divided: one part has the
number of the face and begins its first halfedge where the face does, the others follow behind the
last face of the mesh, as new vertices behind the last vertex.

Direction `d` (0 to 3, counter-clockwise) of face `f` has the angle `angle(f)` + `d` pi/2 with the
first halfedge of the face.
*/
class Cross_field
{
public:
  using Surface = internal::Triangle_surface;

  Cross_field() = default;

  /// takes a surface, an angle per face, a matching (0 to 3) per halfedge and an index per vertex.
  Cross_field(std::shared_ptr<const Surface> surface, std::vector<double> angles,
              std::vector<signed char> matchings, std::vector<int> indices)
    : m_surface(std::move(surface)), m_angle(std::move(angles)), m_matching(std::move(matchings)),
      m_index(std::move(indices))
  {
  }

  const Surface& surface() const { return *m_surface; }
  const std::shared_ptr<const Surface>& surface_pointer() const { return m_surface; }

  /// returns the angle, in radians, from the first halfedge of face `f` to its direction 0.
  double angle(int f) const { return m_angle[f]; }
  /// returns direction `d` of face `f` as a unit vector in space.
  Eigen::Vector3d direction(int f, int d) const
  {
    return m_surface->direction(f, m_angle[f] + d * internal::right_angle);
  }
  /// returns the `p` in 0..3 such that direction `d` of the face of halfedge `h` continues as
  /// direction `d + p` (mod 4) of the face on the other side.
  int matching(int h) const { return m_matching[h]; }
  /// returns the index of vertex `v` in quarters: +1 where four minus one lines leave, -1 where
  /// five do. On the border it is two minus the number of quadrants: +1 in a corner.
  int index(int v) const { return m_index[v]; }
  /// returns the number of vertices whose index is not 0.
  int number_of_singularities() const
  {
    return int(std::count_if(m_index.begin(), m_index.end(), [](int i) { return i != 0; }));
  }
  /// returns the sum of all indices: four times the Euler characteristic.
  int index_sum() const { return std::accumulate(m_index.begin(), m_index.end(), 0); }

private:
  std::shared_ptr<const Surface> m_surface;
  std::vector<double> m_angle;
  std::vector<signed char> m_matching;
  std::vector<int> m_index;
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_CROSS_FIELD_H
