// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_SEAM_CONSTRAINTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_SEAM_CONSTRAINTS_H

#include <CGAL/Quad_layouts/Chart_transition.h>
#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/parametrization/Cut_graph.h>
#include <CGAL/Quad_layouts/internal/parametrization/Linear_relations.h>
#include <CGAL/Quad_layouts/internal/parametrization/find_seams.h>
#include <CGAL/Quad_layouts/internal/right_angle.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The unknowns of a seamless parametrization, and how they depend on free ones.
//
// A *wedge* is what the cut graph leaves of the star of a vertex; all its corners have the same
// coordinates, unknowns 2w and 2w + 1. Along each *seam*, a chain of cut edges, one motion takes
// the points on its one side to those on the other: quarter-turns, which are known, and a
// translation, which is two more unknowns. They keep the relations short, as each point depends on
// its partner and the translation, but not on other points of the seam. Fixed edges keep a
// coordinate, and the first corner of each component is the origin. Nothing else is demanded.
class Seam_constraints
{
public:
  Seam_constraints(const Triangle_surface& surface, const Cut_graph& cut)
    : m_surface(surface), m_cut(cut), m_seams(find_seams(surface, cut)),
      m_wedge(wedges(surface, cut)), m_relations(number_of_unknowns())
  {
    for (const int f : cut.first_faces())
      for (int i = 0; i < 2; ++i)
        m_relations.add({{unknown(3 * f, i), 1}});
    for (int seam = 0; seam < int(m_seams.size()); ++seam)
      join_sides(seam);
    for (int h = 0; h < surface.number_of_halfedges(); ++h)
      if (surface.is_fixed(h) && (surface.is_border(h) || h < surface.opposite(h)))
        keep_coordinate(h);
    m_relations.finish();
  }

  int number_of_unknowns() const { return 2 * (m_number_of_wedges + int(m_seams.size())); }
  // coordinate i, 0 or 1, of the corner at the source of h
  int unknown(int h, int i) const { return 2 * m_wedge[h] + i; }
  const Linear_relations& relations() const { return m_relations; }

  // sets the translations among the unknowns x to what the points tell
  void find_translations(Eigen::VectorXd& x) const
  {
    for (int seam = 0; seam < int(m_seams.size()); ++seam) {
      const int h = m_seams[seam].front(), same = Triangle_surface::next(m_surface.opposite(h));
      const auto point = [&](int g) { return Point2(x[unknown(g, 0)], x[unknown(g, 1)]); };
      const Point2 t = point(same) -
                       Chart_transition<double>::turned(point(h), m_cut.quarter_turns(h));
      for (const int i : {0, 1})
        x[translation(seam, i)] = t[i];
    }
  }

private:
  using Number = Linear_relations::Number;
  using Combination = Linear_relations::Combination;

  // the wedge of each corner
  std::vector<int> wedges(const Triangle_surface& surface, const Cut_graph& cut)
  {
    Disjoint_sets sets(surface.number_of_halfedges());
    for (int h = 0; h < surface.number_of_halfedges(); ++h)
      if (!cut.is_cut(h))
        sets.union_set(h, Triangle_surface::next(surface.opposite(h)));
    std::vector<int> number(surface.number_of_halfedges(), -1), result;
    for (int h = 0; h < surface.number_of_halfedges(); ++h) {
      int& n = number[sets.find_set(h)];
      if (n < 0)
        n = m_number_of_wedges++;
      result.push_back(n);
    }
    return result;
  }

  static void add(Combination& sum, int unknown, const Number& factor)
  {
    Number& number = sum[unknown];
    number += factor;
    if (number == 0)
      sum.erase(unknown);
  }

  int translation(int seam, int i) const { return 2 * (m_number_of_wedges + seam) + i; }

  // adds `factor` times coordinate i of the corner of h, turned left by quarter-turns
  void add_corner(Combination& sum, int h, int i, int quarter_turns, int factor) const
  {
    // a quarter-turn takes (x, y) to (-y, x)
    for (int turn = quarter_turns & 3; turn > 0; --turn) {
      factor *= i == 0 ? -1 : 1;
      i = 1 - i;
    }
    add(sum, unknown(h, i), factor);
  }

  // lets the motion of a seam take the corner of h to that of g, on the other side
  void join(int h, int g, int seam)
  {
    for (int i = 0; i < 2; ++i) {
      Combination sum;
      add_corner(sum, h, i, m_cut.quarter_turns(m_seams[seam].front()), 1);
      add(sum, translation(seam, i), 1);
      add(sum, unknown(g, i), -1);
      m_relations.add(std::move(sum));
    }
  }

  void join_sides(int seam)
  {
    for (const int h : m_seams[seam]) {
      const int g = m_surface.opposite(h);
      join(h, Triangle_surface::next(g), seam);
      if (next_on_seam(m_surface, m_cut, h) < 0)
        join(Triangle_surface::next(h), g, seam);
    }
  }

  void keep_coordinate(int h)
  {
    const int turns = nearest_quarter_turns(m_surface.halfedge_angle(h) -
                                            m_cut.x_angle(m_surface.face(h)));
    const int kept = turns % 2 == 0 ? 1 : 0;
    Combination sum;
    add(sum, unknown(Triangle_surface::next(h), kept), 1);
    add(sum, unknown(h, kept), -1);
    m_relations.add(std::move(sum));
  }

  const Triangle_surface& m_surface;
  const Cut_graph& m_cut;
  std::vector<std::vector<int>> m_seams; // the halfedges on one side of each
  int m_number_of_wedges = 0;
  std::vector<int> m_wedge; // per corner
  Linear_relations m_relations;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_SEAM_CONSTRAINTS_H
