// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUAD_UNTANGLER_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUAD_UNTANGLER_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/parametrization/Regularized_distortion.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Place_search.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Quads_on_surface.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Star.h>
#include <CGAL/Quad_layouts/internal/quad_mesh/smooth_Vertex_steps.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Puts bad quads of a mesh right: those that are inverted or oppose the surface.
//
// Each group of bad quads is treated on its own, with more and more of its surroundings. What has
// been tried is kept only if it makes fewer quads bad.
class Quad_untangler
{
public:
  using Vector = Eigen::Vector3d;

  Quad_untangler(Quads_on_surface& quads, const Monitor& monitor)
    : m_quads(quads), m_steps(quads), m_search(quads), m_monitor(monitor)
  {
  }

  // Turns folded quads back with surroundings that grow, and opens those that are nearly so with
  // small ones, as they can be many, and improves the shape there.
  void unfold()
  {
    constexpr double slim = 0.05;
    const auto attempt = [this](const std::vector<int>& region) {
      unfold(region);
      for (int i = 0; i < 10; ++i)
        for (const int v : region)
          m_steps.improve_shape(v);
    };
    std::vector<int> suspects = all_quads();
    for (int rings = 1; rings <= 16; rings *= 2)
      treat_groups(suspects, rings <= 2 ? slim : 0, rings, attempt);
  }

  // Searches for better places of single vertices at poor quads, then for bad ones in more and more
  // ways. Begins anew with these, which is with better surroundings, as long as this makes fewer
  // quads bad.
  void repair()
  {
    constexpr double poor = 0.5;
    std::vector<int> suspects = all_quads();
    for (int rings = 1; rings <= 2; ++rings)
      treat_groups(suspects, poor, rings,
                   [this](const std::vector<int>& region) { m_search.improve(region); });
    std::size_t before, after = m_quads.bad_quads().size();
    do {
      before = after;
      repair_bad_quads();
      after = m_quads.bad_quads().size();
    } while (after > 0 && after < before);
  }

  // Begins anew near quads that are still bad, from the places that the movable vertices had
  // before: what has been moved into a fold of the surface may find no way out.
  void repair_from(const std::vector<Surface_walk::Place>& before)
  {
    for (int rings = 4; rings <= 8; rings += 2) {
      const std::vector<int> bad_quads = m_quads.bad_quads();
      if (bad_quads.empty() || !m_monitor.has_time("smooth_quad_mesh"))
        return;
      const std::vector<Surface_walk::Place> best = m_quads.places(m_quads.movable());
      move_back(m_quads.surroundings(bad_quads, rings), before);
      repair();
      if (m_quads.bad_quads().size() >= bad_quads.size())
        for (std::size_t i = 0; i < best.size(); ++i)
          m_quads.move(m_quads.movable()[i], best[i]);
    }
  }

private:
  // the least that determinants, in units of the area of a quad, are regularized with
  static constexpr std::array<double, 3> least_epsilons = {1e-5, 1e-4, 1e-3};

  // Moves vertices of a region to places that are given for all movable ones. On curves, where
  // their order counts, they stay.
  void move_back(const std::vector<int>& region, const std::vector<Surface_walk::Place>& before)
  {
    const std::vector<int>& movable = m_quads.movable();
    for (const int v : region)
      if (!m_quads.is_on_curve(v))
        m_quads.move(v, before[std::lower_bound(movable.begin(), movable.end(), v) -
                               movable.begin()]);
  }

  // Searches for better places of single vertices, from where they are and from the unfolded state,
  // then from random places, and of sides of quads.
  void repair_bad_quads()
  {
    const auto search_here = [this](const std::vector<int>& region) { m_search.improve(region); };
    const auto search_anew = [this](double least_epsilon) {
      return [this, least_epsilon](const std::vector<int>& region) {
        unfold(region, least_epsilon);
        m_search.improve(region);
      };
    };
    std::vector<int> suspects = m_quads.bad_quads();
    for (int rings = 1; rings <= 8; rings *= 2) {
      treat_groups(suspects, 0, rings, search_here);
      for (const double least_epsilon : least_epsilons)
        treat_groups(suspects, 0, rings, search_anew(least_epsilon));
    }
    shake(suspects);
    treat_groups(suspects, 0, 1, [this](const std::vector<int>& region) { squeeze(region); });
  }

  // how far quads are from being good
  struct Badness
  {
    int bad_quads = 0;
    double deficit = 0; // sum of the squares by which the scores of quads miss a threshold
    bool operator<(const Badness& other) const
    {
      return std::make_pair(bad_quads, deficit) < std::make_pair(other.bad_quads, other.deficit);
    }
  };

  Badness badness(const std::vector<int>& quads, double threshold) const
  {
    Badness result;
    for (const int f : quads) {
      const double s = m_quads.score(f);
      result.bad_quads += !(s > 0);
      result.deficit += CGAL::square((std::max)(threshold - s, 0.));
    }
    return result;
  }

  std::vector<int> all_quads() const
  {
    std::vector<int> result(m_quads.mesh().number_of_faces());
    std::iota(result.begin(), result.end(), 0);
    return result;
  }

  // the quads at some vertices, ascending
  std::vector<int> quads_at(const std::vector<int>& vertices) const
  {
    std::vector<int> result;
    for (const int v : vertices)
      for (const int h : m_quads.corners(v))
        result.push_back(m_quads.mesh().face[h]);
    sort_and_unify(result);
    return result;
  }

  static void sort_and_unify(std::vector<int>& quads)
  {
    std::sort(quads.begin(), quads.end());
    quads.erase(std::unique(quads.begin(), quads.end()), quads.end());
  }

  // Groups those of some quads whose score is at most `threshold`: if they have a common corner,
  // they belong together.
  std::vector<std::vector<int>> groups(const std::vector<int>& suspects, double threshold) const
  {
    std::vector<char> is_open(m_quads.mesh().number_of_faces(), 0);
    for (const int f : suspects)
      is_open[f] = !(m_quads.score(f) > threshold);
    std::vector<std::vector<int>> result;
    for (const int f : suspects)
      if (is_open[f])
        result.push_back(group_from(f, is_open));
    return result;
  }

  std::vector<int> group_from(int first, std::vector<char>& is_open) const
  {
    std::vector<int> result = {first};
    is_open[first] = 0;
    for (std::size_t i = 0; i < result.size(); ++i)
      for (int k = 0; k < 4; ++k)
        for (const int h : m_quads.corners(m_quads.mesh().corner(result[i], k))) {
          const int f = m_quads.mesh().face[h];
          if (std::exchange(is_open[f], 0))
            result.push_back(f);
        }
    return result;
  }

  // Makes an attempt for each group of bad quads among `suspects`, and replaces these by the quads
  // that may be bad now: these groups, even where nothing of them can move, and those around, each
  // once.
  template <class Attempt>
  void treat_groups(std::vector<int>& suspects, double threshold, int rings, const Attempt& attempt)
  {
    std::vector<int> treated;
    for (const std::vector<int>& group : groups(suspects, threshold)) {
      if (!m_monitor.has_time("smooth_quad_mesh"))
        break;
      const std::vector<int> region = m_quads.surroundings(group, rings), quads = quads_at(region);
      keep_if_better(region, threshold, attempt);
      treated.insert(treated.end(), group.begin(), group.end());
      treated.insert(treated.end(), quads.begin(), quads.end());
    }
    sort_and_unify(treated);
    suspects.swap(treated);
  }

  // Makes an attempt with the vertices of a region, and undoes it if it does not help the quads
  // there.
  template <class Attempt>
  void keep_if_better(const std::vector<int>& region, double threshold, const Attempt& attempt)
  {
    const std::vector<int> quads = quads_at(region);
    const Badness before = badness(quads, threshold);
    const std::vector<Surface_walk::Place> old = m_quads.places(region);
    attempt(region);
    if (!(badness(quads, threshold) < before))
      for (std::size_t i = 0; i < region.size(); ++i)
        m_quads.move(region[i], old[i]);
  }

  // Makes the bad quads of a region thinner, or wider. Where the surface is folded so tightly that
  // both of its sheets are beside a quad, only a thin one agrees with its own, and no corner can go
  // there alone.
  void squeeze(const std::vector<int>& region)
  {
    for (const int f : quads_at(region))
      if (!(m_quads.score(f) > 0))
        squeeze_quad(f);
  }

  void squeeze_quad(int f)
  {
    constexpr double sufficient = 0.01;
    const std::vector<int> around = m_quads.surroundings({f}, 1);
    for (int k = 0; k < 4; ++k)
      for (const double fraction : {0.5, 0.75, 0.875, 0.95, 0.98, -0.5, -1.}) {
        keep_if_better(around, sufficient, [&](const std::vector<int>& vertices) {
          move_side(f, k, fraction, vertices);
        });
        if (m_quads.score(f) > 0 || !m_monitor.has_time("smooth_quad_mesh"))
          return;
      }
  }

  // moves side k of a quad by a fraction of the way to the opposite side, and searches for better
  // places of those of the other vertices around that can move
  void move_side(int f, int k, double fraction, std::vector<int> around)
  {
    const Polygons& mesh = m_quads.mesh();
    const auto target = [&](int from, int to) -> Vector {
      return mesh.points[from] + fraction * (mesh.points[to] - mesh.points[from]);
    };
    const auto corner = [&](int i) { return mesh.corner(f, i & 3); };
    const auto move = [&](int v, const Vector& x) {
      const auto i = std::lower_bound(around.begin(), around.end(), v);
      if (i != around.end() && *i == v) {
        m_quads.slide(v, x);
        around.erase(i);
      }
    };
    const Vector x = target(corner(k), corner(k + 3)), y = target(corner(k + 1), corner(k + 2));
    move(corner(k), x);
    move(corner(k + 1), y);
    m_search.improve(around);
  }

  // Searches from random places around, for what nothing else helps, until many rounds in a row do
  // not help either; the last of these squeeze quads, too.
  void shake(std::vector<int>& suspects)
  {
    constexpr int patience = 12;
    std::minstd_rand random; // always the same numbers
    int rings = 1, failures = 0;
    const auto attempt = [&](const std::vector<int>& region) {
      for (const int v : region)
        displace(v, random);
      unfold(region);
      m_search.improve(region);
      if (rings == 1 && failures >= patience / 2) // it takes long
        squeeze(region);
    };
    int bad_quads = badness(suspects, 0).bad_quads;
    for (int i = 0; bad_quads > 0 && failures < patience; ++i) {
      rings = 1 + i % 4;
      treat_groups(suspects, 0, rings, attempt);
      const int remaining = badness(suspects, 0).bad_quads;
      failures = remaining < bad_quads ? 0 : failures + 1;
      bad_quads = remaining;
    }
  }

  // moves v along the surface by at most half the length of its edges
  void displace(int v, std::minstd_rand& random)
  {
    const Vector normal = m_quads.normal(v), t1 = normal.unitOrthogonal(), t2 = normal.cross(t1);
    const auto fraction = [&] { return double(random()) / double(std::minstd_rand::max()) - 0.5; };
    const double x = fraction(), y = fraction(), length = m_quads.edge_length(v);
    m_quads.slide(v, m_quads.place(v).point + length * (x * t1 + y * t2));
  }

  // Turns the folded quads of a region back together: the less the worst corner is folded, the more
  // decisive its part of the regularized distortion becomes (Garanzha et al. 2021). Where quads are
  // tiny or slim it depends on `least_epsilon` what this leads to. Ends soon after the last of them
  // has turned.
  void unfold(const std::vector<int>& region, double least_epsilon = least_epsilons.front())
  {
    constexpr int most_sweeps = 60, sufficient_sweeps = 8;
    constexpr double area_weight = 1;
    const std::vector<int> quads = quads_at(region);
    double length = 0;
    for (const int v : region)
      length += m_quads.edge_length(v) / double(region.size());
    int sweeps_without_folds = 0;
    for (int i = 0; i < most_sweeps && sweeps_without_folds < sufficient_sweeps &&
                    m_monitor.has_time("smooth_quad_mesh");
         ++i) {
      const double worst = (std::min)(least_determinant(quads) / (length * length), 0.);
      sweeps_without_folds = worst < 0 ? 0 : sweeps_without_folds + 1;
      const Regularized_distortion measure(std::hypot(least_epsilon, 0.2 * worst), area_weight);
      for (const int v : region)
        m_steps.unfold(v, measure, length);
    }
  }

  // of the corners of some quads
  double least_determinant(const std::vector<int>& quads) const
  {
    double result = (std::numeric_limits<double>::infinity)();
    for (const int f : quads)
      result = (std::min)(result, internal::least_determinant(m_quads.quad_on_surface(f)));
    return result;
  }

  Quads_on_surface& m_quads;
  Vertex_steps m_steps;
  Place_search m_search;
  const Monitor& m_monitor;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_SMOOTH_QUAD_UNTANGLER_H
