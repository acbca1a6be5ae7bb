// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_TARGET_LENGTHS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_TARGET_LENGTHS_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/internal/require_parameter.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The lengths on the surface that a length of 1 in the map aims at: one for the whole surface, in
// which the map is measured, or two for each face, along directions 0 and 1 of the field.
class Target_lengths
{
public:
  Target_lengths(double uniform) : m_uniform(uniform) {} // a length is one for all faces
  Target_lengths(double uniform, std::vector<Eigen::Vector2d> in_faces)
    : m_uniform(uniform), m_in_faces(std::move(in_faces))
  {
  }

  double uniform() const { return m_uniform; }

  // those along the axes of a chart of face f, the first of which is the direction `x_axis`, in
  // units of the uniform one
  Eigen::Vector2d along_axes(int f, int x_axis) const
  {
    if (m_in_faces.empty())
      return Eigen::Vector2d::Ones();
    const Eigen::Vector2d lengths = m_in_faces[f] / m_uniform;
    return x_axis % 2 == 0 ? lengths : lengths.reverse();
  }

private:
  double m_uniform;
  std::vector<Eigen::Vector2d> m_in_faces;
};

inline Eigen::Vector2d in_both_directions(double length)
{
  return Eigen::Vector2d::Constant(length);
}

template <class Pair>
Eigen::Vector2d in_both_directions(const Pair& lengths)
{
  return {lengths[0], lengths[1]};
}

// reads a map that has a length, or two, for each face
template <class FaceLengthMap>
Target_lengths read_target_lengths(const Cross_field& field, double uniform,
                                   const FaceLengthMap& map)
{
  std::vector<Eigen::Vector2d> in_faces;
  for (int f = 0; f < field.surface().number_of_faces(); ++f) {
    in_faces.push_back(in_both_directions(get(map, f)));
    for (const double length : in_faces.back())
      require_positive("target_edge_length_map", length);
  }
  return {uniform, std::move(in_faces)};
}

// without a map
inline Target_lengths read_target_lengths(const Cross_field&, double uniform,
                                          internal_np::Param_not_found)
{
  return uniform;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_TARGET_LENGTHS_H
