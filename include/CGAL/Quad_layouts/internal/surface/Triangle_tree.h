// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_TRIANGLE_TREE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_TRIANGLE_TREE_H

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Closest points on a set of triangles, by an AABB tree. The one place that knows how the names of
// the tree's classes differ between CGAL 5 and 6.
class Triangle_tree
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Triangles = std::vector<Kernel::Triangle_3>;
#if CGAL_VERSION_NR >= 1060000000
  using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
  using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif
  using Tree = CGAL::AABB_tree<Traits>;

public:
  struct Place
  {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    int triangle = -1; // -1: no triangle was admitted
    double distance = (std::numeric_limits<double>::infinity)();
  };

  using Corners = std::array<Eigen::Vector3d, 3>;

  // takes at least one triangle, the first corner of each
  explicit Triangle_tree(const std::vector<Corners>& corners)
  {
    m_triangles.reserve(corners.size());
    for (const Corners& c : corners)
      m_triangles.emplace_back(point_3(c[0]), point_3(c[1]), point_3(c[2]));
    m_tree.rebuild(m_triangles.cbegin(), m_triangles.cend());
    m_tree.accelerate_distance_queries();
  }

  Triangle_tree(const Triangle_tree&) = delete; // the tree points into m_triangles
  Triangle_tree& operator=(const Triangle_tree&) = delete;

  // the point nearest to p
  Place nearest(const Eigen::Vector3d& p) const
  {
    const auto found = m_tree.closest_point_and_primitive(point_3(p));
    const Eigen::Vector3d point(found.first.x(), found.first.y(), found.first.z());
    return {point, int(found.second - m_triangles.cbegin()), (point - p).norm()};
  }

  // The same, for which a point near to p is known; the nearer that is, the less there is to search.
  // Of triangles that are equally near, up to rounding, it is in the first by `less`, an order of
  // their indices.
  template <class Less>
  Place nearest(const Eigen::Vector3d& p, const Place& known, const Less& less) const
  {
    return search(
        p, [](int) { return true; }, less, known);
  }

  double distance(const Eigen::Vector3d& p) const
  {
    return nearest(p).distance;
  }

  // the point nearest to p in the triangles that `admitted`, a predicate on indices, lets pass
  template <class Admitted>
  Place nearest_if(const Eigen::Vector3d& p, const Admitted& admitted) const
  {
    return search(
        p, admitted, [](int, int) { return false; }, Place());
  }

private:
  template <class Admitted, class Less>
  Place search(const Eigen::Vector3d& p, const Admitted& admitted, const Less& less,
               const Place& known) const
  {
    Filtered_projection<Admitted, Less> projection(*this, p, admitted, less, known);
    m_tree.traversal(point_3(p), projection);
    return projection.best;
  }

  static Kernel::Point_3 point_3(const Eigen::Vector3d& p)
  {
    return {p.x(), p.y(), p.z()};
  }

  // the traversal traits of AABB_tree for a search in part of the primitives
  template <class Admitted, class Less>
  struct Filtered_projection
  {
    static constexpr double rounding = 1e-9; // relative error of distances

    Filtered_projection(const Triangle_tree& owner, const Eigen::Vector3d& p,
                        const Admitted& admitted, const Less& less, const Place& known)
      : owner(owner), p(p), admitted(admitted), less(less), best(known)
    {
    }
    bool go_further() const { return true; }
    void intersection(const Kernel::Point_3& query, const Primitive& primitive)
    {
      const int t = int(primitive.id() - owner.m_triangles.cbegin());
      if (!admitted(t))
        return;
      const Kernel::Point_3 c = Kernel().construct_projected_point_3_object()(*primitive.id(),
                                                                              query);
      const Eigen::Vector3d point(c.x(), c.y(), c.z());
      const double distance = (point - p).norm();
      if (is_better(t, distance))
        best = {point, t, distance};
    }
    bool is_better(int t, double distance) const
    {
      const bool is_equal = best.triangle >= 0 &&
                            std::abs(distance - best.distance) <= rounding * best.distance;
      return is_equal ? less(t, best.triangle) : distance < best.distance;
    }
    template <class Node>
    bool do_intersect(const Kernel::Point_3&, const Node& node) const
    {
      const auto box = node.bbox();
      double squared = 0;
      for (int i = 0; i < 3; ++i) {
        const double outside = (std::max)((std::max)((box.min)(i)-p[i], p[i] - (box.max)(i)), 0.);
        squared += outside * outside;
      }
      return squared <= best.distance * best.distance * (1 + 3 * rounding);
    }

    const Triangle_tree& owner;
    const Eigen::Vector3d p;
    const Admitted& admitted;
    const Less& less;
    Place best;
  };

  Triangles m_triangles;
  Tree m_tree;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_SURFACE_TRIANGLE_TREE_H
