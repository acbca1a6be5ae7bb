// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_SEAM_CONSTRAINTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_SEAM_CONSTRAINTS_H

#include <CGAL/Quad_layouts/internal/Disjoint_sets.h>
#include <CGAL/Quad_layouts/internal/parametrization/Cut_graph.h>
#include <CGAL/Quad_layouts/internal/parametrization/Linear_relations.h>
#include <CGAL/Quad_layouts/internal/right_angle.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The unknowns of a seamless parametrization, and how they depend on free ones.
//
// A *wedge* is what the cut graph leaves of the star of a vertex; all its corners have the same
// coordinates, unknowns 2w and 2w + 1. The two sides of a cut edge are equal vectors up to
// quarter-turns, fixed edges keep a coordinate, and the first corner of each component is the
// origin. Nothing else is demanded: translations are free, and so are the places of cones.
class Seam_constraints
{
public:
  Seam_constraints(const Triangle_surface& surface, const Cut_graph& cut)
    : m_surface(surface), m_cut(cut), m_wedge(wedges(surface, cut)),
      m_relations(2 * m_number_of_wedges)
  {
    for (const int f : cut.first_faces())
      for (int i = 0; i < 2; ++i)
        m_relations.add({{unknown(3 * f, i), 1}});
    for (int h = 0; h < surface.number_of_halfedges(); ++h) {
      const bool is_first = surface.is_border(h) || h < surface.opposite(h);
      if (is_first && cut.is_cut(h) && !surface.is_border(h))
        join_sides(h);
      if (is_first && surface.is_fixed(h))
        keep_coordinate(h);
    }
    m_relations.finish();
  }

  int number_of_unknowns() const { return 2 * m_number_of_wedges; }
  // coordinate i, 0 or 1, of the corner at the source of h
  int unknown(int h, int i) const { return 2 * m_wedge[h] + i; }
  const Linear_relations& relations() const { return m_relations; }

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

  // adds `factor` times coordinate i of the vector of halfedge h, turned left by quarter-turns
  void add_vector(Combination& sum, int h, int i, int quarter_turns, int factor) const
  {
    // a quarter-turn takes (x, y) to (-y, x)
    for (int turn = quarter_turns & 3; turn > 0; --turn) {
      factor *= i == 0 ? -1 : 1;
      i = 1 - i;
    }
    add(sum, unknown(Triangle_surface::next(h), i), factor);
    add(sum, unknown(h, i), -factor);
  }

  void join_sides(int h)
  {
    for (int i = 0; i < 2; ++i) {
      Combination sum; // the opposite halfedge runs the other way
      add_vector(sum, m_surface.opposite(h), i, 0, 1);
      add_vector(sum, h, i, m_cut.quarter_turns(h), 1);
      m_relations.add(std::move(sum));
    }
  }

  void keep_coordinate(int h)
  {
    const int f = m_surface.face(h);
    const int turns = int(
        std::lround((m_surface.halfedge_angle(h) - m_cut.x_angle(f)) / right_angle));
    Combination sum;
    add_vector(sum, h, turns % 2 == 0 ? 1 : 0, 0, 1);
    m_relations.add(std::move(sum));
  }

  const Triangle_surface& m_surface;
  const Cut_graph& m_cut;
  int m_number_of_wedges = 0;
  std::vector<int> m_wedge; // per corner
  Linear_relations m_relations;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_SEAM_CONSTRAINTS_H
