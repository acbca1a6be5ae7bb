// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_FACE_VECTORS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_FACE_VECTORS_H

#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// the vectors that `map` has for the faces of tm, in the order of the faces
template <class TriangleMesh, class FaceVectorMap>
std::vector<Eigen::Vector3d> read_face_vectors(const TriangleMesh& tm, FaceVectorMap map)
{
  std::vector<Eigen::Vector3d> result;
  result.reserve(num_faces(tm));
  for (auto f : faces(tm)) {
    const auto& v = get(map, f);
    result.emplace_back(to_double(v.x()), to_double(v.y()), to_double(v.z()));
  }
  return result;
}

// nothing, if the pack has no map
template <class TriangleMesh>
std::vector<Eigen::Vector3d> read_face_vectors(const TriangleMesh&,
                                               const internal_np::Param_not_found&)
{
  return {};
}

// the angle in the frame of face f of the projection of `vector`; throws if there is none.
// `parameter` names the origin of the vector in the message.
inline double projected_angle(const Triangle_surface& surface, int f, const Eigen::Vector3d& vector,
                              const char* parameter)
{
  const std::string where = std::string(parameter) + ": the vector of face " + std::to_string(f);
  if (!vector.allFinite())
    throw Invalid_parameter(where + " is not finite");
  // this normalisation, unlike Eigen's, neither overflows nor underflows
  const double size = vector.cwiseAbs().maxCoeff();
  if (size == 0)
    throw Invalid_parameter(where + " is zero");
  const Eigen::Vector3d v = (vector / size).normalized();

  // what remains of a unit vector below this is rounding of the vector and of the normal
  constexpr double smallest_projection = 1e-6;
  const Eigen::Vector3d x = surface.direction(f, 0), y = surface.normal(f).cross(x);
  if (std::hypot(v.dot(x), v.dot(y)) < smallest_projection)
    throw Invalid_parameter(where + " is normal to the face");
  return std::atan2(v.dot(y), v.dot(x));
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_FACE_VECTORS_H
