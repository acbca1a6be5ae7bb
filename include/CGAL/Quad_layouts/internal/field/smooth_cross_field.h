// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SMOOTH_CROSS_FIELD_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SMOOTH_CROSS_FIELD_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/field/Field_diffusion.h>
#include <CGAL/Quad_layouts/internal/field/Jump_rounding.h>
#include <CGAL/Quad_layouts/internal/field/Jump_search.h>
#include <CGAL/Quad_layouts/internal/field/Singularity_splitter.h>
#include <CGAL/Quad_layouts/internal/field/curvature.h>
#include <CGAL/Quad_layouts/internal/field/face_vectors.h>
#include <CGAL/Quad_layouts/internal/field/matching.h>
#include <CGAL/Quad_layouts/internal/field/sectors.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

struct Cross_field_options
{
  Cross_field_method method = DIFFUSION;
  double curvature_alignment = 0.07;
  double diffusion_time = 32;
  int number_of_iterations = 40;
};

// the cross field with the given angles and period jumps
inline Cross_field make_cross_field(const std::shared_ptr<const Triangle_surface>& surface,
                                    const Face_connection& connection, std::vector<double> angles,
                                    const std::vector<int>& jumps)
{
  std::vector<int> vertex_indices = indices(connection, angles, jumps);
  Cross_field result(surface, std::move(angles), matchings(jumps), std::move(vertex_indices));
  CGAL_assertion(result.index_sum() == 4 * euler_characteristic(*surface));
  return result;
}

// the direction of the cross with angle `angle` in face f that is nearest to the fixed edge of f,
// turned such that it has that edge's direction exactly; `angle` itself if f has none
inline double aligned_angle(const Triangle_surface& surface, int f, double angle)
{
  const int h = surface.fixed_halfedge(f);
  if (h < 0)
    return angle;
  return angle + std::remainder(surface.halfedge_angle(h) - angle, right_angle);
}

// the field whose direction in each face is the projection of the vector there, turned as little as
// aligns it to fixed edges; `directions` has a vector per face of the user's mesh
inline Cross_field given_cross_field(const std::shared_ptr<const Triangle_surface>& surface,
                                     const std::vector<Eigen::Vector3d>& directions)
{
  const Face_connection connection(*surface);
  std::vector<double> angles;
  angles.reserve(surface->number_of_faces());
  for (int f = 0; f < surface->number_of_faces(); ++f)
    angles.push_back(aligned_angle(
        *surface, f,
        projected_angle(*surface, f, directions[surface->origin(f)], "face_direction_map")));
  std::vector<int> jumps = principal_period_jumps(connection, angles);
  open_sectors(connection, angles, jumps);
  return make_cross_field(surface, connection, std::move(angles), jumps);
}

// the representations of the directions of faces at fixed edges and of those with a vector, and 0
// for others
inline std::vector<Complex> fixed_crosses(const Triangle_surface& surface,
                                          const std::vector<Eigen::Vector3d>& constraints)
{
  std::vector<Complex> result(surface.number_of_faces());
  for (int f = 0; f < surface.number_of_faces(); ++f) {
    const int g = surface.origin(f), h = surface.fixed_halfedge(f);
    if (h >= 0)
      result[f] = std::polar(1., 4 * surface.halfedge_angle(h));
    else if (!constraints.empty() && constraints[g] != Eigen::Vector3d::Zero())
      result[f] = std::polar(
          1., 4 * projected_angle(surface, f, constraints[g], "face_constraint_map"));
  }
  return result;
}

// the crosses that diffusion makes of those of principal curvature; faces with a fixed cross keep
// it
inline std::vector<Complex> diffused_crosses(const Face_connection& connection,
                                             const std::vector<Complex>& fixed,
                                             const Cross_field_options& options,
                                             const Monitor& monitor)
{
  constexpr double converged = 1e-3;
  const Curvature_pulls pulls(connection);
  Field_diffusion diffusion(connection, pulls.weighted(options.curvature_alignment), fixed,
                            options.diffusion_time);
  diffusion.start(pulls.weighted(1));
  for (int i = 0; i < options.number_of_iterations; ++i) {
    monitor.report("compute_cross_field", double(i) / options.number_of_iterations);
    if (diffusion.step() < converged)
      break;
  }
  return diffusion.values();
}

// the angles, one of four each, of crosses; along fixed edges they are exact
inline std::vector<double> angles_of_crosses(const Triangle_surface& surface,
                                             const std::vector<Complex>& crosses)
{
  std::vector<double> angles;
  for (int f = 0; f < int(crosses.size()); ++f)
    angles.push_back(aligned_angle(surface, f, std::arg(crosses[f]) / 4));
  return angles;
}

// the period jumps of the halfedges, from those of the springs across the edges
inline std::vector<int> halfedge_jumps(const Triangle_surface& surface,
                                       const std::vector<int>& jumps)
{
  std::vector<int> result(surface.number_of_halfedges(), 0);
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    if (!surface.is_border(h)) {
      const int e = surface.edge(h);
      result[h] = surface.halfedge_of_edge(e) == h ? jumps[e] : -jumps[e];
    }
  return result;
}

// The period jumps that greedy rounding leads to, and then a local search. `angles` has those of
// the faces with a fixed cross, which are kept, and gets the others.
inline std::vector<int> round_jumps(const Face_connection& connection,
                                    const std::vector<char>& is_fixed,
                                    const Cross_field_options& options, const Monitor& monitor,
                                    std::vector<double>& angles)
{
  const Curvature_pulls pulls(connection);
  const Cross_springs springs(connection, pulls.weighted(options.curvature_alignment), is_fixed);
  std::vector<int> jumps(springs.number_of_springs(), 0);
  Jump_rounding(springs, angles, jumps).run(monitor);
  Jump_search(springs).run(angles, jumps, monitor);
  return halfedge_jumps(connection.surface(), jumps);
}

// a smooth cross field along fixed edges, with the directions that `constraints` has; it is empty
// or has a vector per face of the user's mesh
inline Cross_field smooth_cross_field(const std::shared_ptr<const Triangle_surface>& surface,
                                      const std::vector<Eigen::Vector3d>& constraints,
                                      const Cross_field_options& options, const Monitor& monitor)
{
  const Face_connection connection(*surface);
  const std::vector<Complex> fixed = fixed_crosses(*surface, constraints);
  std::vector<char> is_fixed(fixed.size());
  std::transform(fixed.begin(), fixed.end(), is_fixed.begin(),
                 [](const Complex& u) { return u != Complex(0); });

  std::vector<double> angles;
  std::vector<int> jumps;
  if (options.method == DIFFUSION) {
    angles = angles_of_crosses(*surface, diffused_crosses(connection, fixed, options, monitor));
    jumps = principal_period_jumps(connection, angles);
  } else {
    angles = angles_of_crosses(*surface, fixed);
    jumps = round_jumps(connection, is_fixed, options, monitor, angles);
  }
  const std::vector<int> opened = open_sectors(connection, angles, jumps);
  Singularity_splitter(connection, angles, jumps, is_fixed).split(opened);
  return make_cross_field(surface, connection, std::move(angles), jumps);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_FIELD_SMOOTH_CROSS_FIELD_H
