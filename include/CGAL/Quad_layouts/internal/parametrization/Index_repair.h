// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_INDEX_REPAIR_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_INDEX_REPAIR_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/field/Jump_field.h>
#include <CGAL/Quad_layouts/internal/parametrization/check_parametrization.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The search for moves of index with which a field has a locally injective map.
//
// Not every field has one. An example is a fixed edge that ends within the surface and begins at a
// closed fixed curve under an acute angle: with the vertex of valence 5 at its beginning and that
// of valence 3 nearby, lines are displaced against each other by as much as the two are apart, and
// where other curves do not allow that, both would have to be in one place. Another such pair can
// displace the lines back. Where the map cannot be as it should, vertices miss their angles: there
// the search begins.
class Index_repair
{
public:
  using Parametrize = std::function<Seamless_parametrization(const Cross_field&)>;

  // takes a field and its map, and how to make that of another field
  Index_repair(const Cross_field& field, Seamless_parametrization map, Parametrize parametrize)
    : m_field(field), m_map(std::move(map)), m_parametrize(std::move(parametrize)),
      m_tries_left(most_triangles / field.surface().number_of_faces())
  {
  }

  // returns the map with the fewest defects
  Seamless_parametrization run()
  {
    constexpr int most_defects = 100; // more would take too many moves
    while (!m_map.is_locally_injective() && number_of_defects(m_map) <= most_defects && improve()) {
    }
    return std::move(m_map);
  }

private:
  static constexpr int most_triangles = 100000; // of all maps in sum: large ones take minutes

  // makes the best one of the first moves; returns whether there is one that is worth it
  bool improve()
  {
    constexpr std::size_t most_moves = 10;
    std::vector<int> moves = possible_moves();
    moves.resize((std::min)(moves.size(), most_moves));
    int best = -1;
    for (const int h : moves) {
      if (m_map.is_locally_injective() || m_tries_left-- <= 0)
        break;
      if (is_better_after(h))
        best = h;
    }
    if (best >= 0)
      m_field.move(best);
    return best >= 0;
  }

  // the halfedges along which a quarter of index can leave vertices that miss their angle: first
  // those, one for each vertex, with which the field turns least, then the second ones, and so on
  std::vector<int> possible_moves() const
  {
    std::vector<std::tuple<std::size_t, double, int>> moves; // rank, turning, and halfedge
    for (const int v : wrong_windings(m_map)) {
      std::vector<std::pair<double, int>> from_here;
      m_field.surface().for_each_outgoing(v, [&](int h) {
        if (m_field.can_move(h))
          from_here.emplace_back(m_field.turning_after_move(h), h);
      });
      std::sort(from_here.begin(), from_here.end());
      for (std::size_t i = 0; i < from_here.size(); ++i)
        moves.emplace_back(i, from_here[i].first, from_here[i].second);
    }
    std::sort(moves.begin(), moves.end());
    std::vector<int> result;
    for (const auto& move : moves)
      result.push_back(std::get<2>(move));
    return result;
  }

  // Keeps the map after a move if it has fewer defects. A field for which there is no map at all is
  // no better than one with a map that has defects.
  bool is_better_after(int h)
  {
    m_field.move(h);
    const Cross_field moved = m_field.field();
    m_field.undo_move(h);
    try {
      Seamless_parametrization map = m_parametrize(moved);
      if (number_of_defects(map) >= number_of_defects(m_map))
        return false;
      m_map = std::move(map);
      return true;
    } catch (const Stage_failure&) {
      return false;
    }
  }

  Jump_field m_field;
  Seamless_parametrization m_map;
  Parametrize m_parametrize;
  int m_tries_left;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_INDEX_REPAIR_H
