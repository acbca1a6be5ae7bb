// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SQUARE_MAP_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SQUARE_MAP_H

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/embedding/Layout_squares.h>
#include <CGAL/Quad_layouts/internal/embedding/Map.h>
#include <CGAL/Quad_layouts/internal/embedding/Mean_coordinates.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Maps each face of an embedded layout to its square: the points of each curve are spaced evenly,
// the vertices between go where each is the mean of its neighbours. As no edge joins two points of
// curves but those of the curves, no triangle is inverted (Tutte 1963).
class Square_map
{
public:
  // `vertices`: per layout vertex its place
  Square_map(Map& map, const std::vector<int>& vertices, const Quad_layout& layout,
             const Layout_squares& squares)
    : m_map(map), m_on_curve(map.points.size(), 0)
  {
    std::vector<std::map<int, Side>> pieces(layout.number_of_halfedges()); // by their sources
    for (std::size_t f = 0; f < map.faces.size(); ++f)
      for (int k = 0; k < 3; ++k)
        if (const int l = map.faces[f].curve[k]; l >= 0)
          pieces[l][map.faces[f].vertex[k]] = {int(f), k};
    for (int l = 0; l < layout.number_of_halfedges(); ++l)
      place_curve(l, pieces[l], vertices[layout.source(l)], squares);
    place_others();
  }

private:
  using Side = std::pair<int, int>; // a face and which of its sides

  void place_curve(int l, const std::map<int, Side>& pieces, int v, const Layout_squares& squares)
  {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const auto piece = pieces.find(v);
      if (piece == pieces.end())
        throw Stage_failure("embed: the curve of layout edge " + std::to_string(l / 2) +
                            " is interrupted");
      const auto [f, k] = piece->second;
      const Map::Face& face = m_map.faces[f];
      m_map.coordinates[v] = face.chart[k].inverse()(
          squares.point(l, double(i) / double(pieces.size())));
      m_on_curve[v] = 1;
      v = face.vertex[(k + 1) % 3];
    }
  }

  // Every edge between two free vertices is seen from both its sides, all edges count twice. The
  // chart of a free vertex is that of its square.
  void place_others()
  {
    std::vector<int> number(m_map.points.size(), -1), vertex;
    for (const Map::Face& f : m_map.faces)
      for (const int v : f.vertex)
        if (!m_on_curve[v] && number[v] < 0) {
          number[v] = int(vertex.size());
          vertex.push_back(v);
        }
    Mean_coordinates mean(int(vertex.size()));
    for (const Map::Face& f : m_map.faces)
      for (int k = 0; k < 3; ++k)
        for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
          const int i = number[f.vertex[k]], j = number[f.vertex[other]];
          if (i >= 0 && j >= 0)
            mean.add_neighbour(i, j);
          else if (i >= 0)
            mean.add_neighbour(i, m_map.corner(f, other));
        }
    const std::vector<Point2> place = mean.solve();
    for (std::size_t i = 0; i < vertex.size(); ++i)
      m_map.coordinates[vertex[i]] = place[i];
  }

  Map& m_map;
  std::vector<char> m_on_curve; // per vertex
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_EMBEDDING_SQUARE_MAP_H
