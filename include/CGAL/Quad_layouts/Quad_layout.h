// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_QUAD_LAYOUT_H
#define CGAL_QUAD_LAYOUTS_QUAD_LAYOUT_H

#include <CGAL/Quad_layouts/Halfedge_complex.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsClasses

is a conforming quad layout of a surface, as combinatorics: the quotient of a quantized T-mesh.

As a cell complex its faces are quadrilaterals, the unit squares of the quantization. Its *patches*
are the faces of the base complex, the coarsest sub-complex without T-joints that contains all
separatrices (the fixed curves, and chains of edges that leave an irregular vertex, or a corner of a
fixed curve, and go straight on): `patch` says to
which patch a face belongs.

A *chord* is a class of edges that are opposite each other in faces; all edges of a chord are
divided alike in every quad mesh with this layout.
*/
class Quad_layout : public Halfedge_complex
{
public:
  /// is a layout vertex that stands for one or more nodes at which traces of the T-mesh begin.
  struct Cluster
  {
    int vertex; ///< the vertex of the layout
    int index;  ///< sum of the members' indices, in quarters: that of the vertex
    std::vector<int>
        nodes; ///< the singularities and seeds of the T-mesh that were merged, ascending
  };

  /// is the grid of unit squares that a patch of the T-mesh turns into.
  struct Grid
  {
    int width = 0, height = 0; ///< lengths of sides 0 and 1 of the T-mesh patch
    /// the squares, if both are positive: `faces[j * width + i]` is, for square (i, j) counted from
    /// the corner where side 0 begins, its halfedge parallel to side 0 at the lower end, so that x
    /// runs along it
    std::vector<int> squares;
    int square(int i, int j) const { return squares[j * width + i]; }
  };

  int valence(int v) const
  {
    int n = 0, h = halfedge_from(v);
    do {
      ++n;
      h = turn_right(h);
    } while (h != halfedge_from(v));
    return n;
  }

  /// says if `v` has four edges, or three on the border.
  bool is_regular(int v) const { return index(v) == 0; }
  /// returns four minus the valence of `v`, on the border three minus it.
  int index(int v) const { return (is_on_border(v) ? 3 : 4) - valence(v); }

  /// says if an edge is part of a fixed curve, like the border.
  bool is_fixed(int edge) const
  {
    return is_border_edge(edge) || (!edge_is_fixed.empty() && edge_is_fixed[edge] != 0);
  }
  /// says if vertex `v` is on a fixed curve.
  bool is_on_fixed_curve(int v) const
  {
    int h = halfedge_from(v);
    do {
      if (is_fixed(edge(h)))
        return true;
      h = turn_right(h);
    } while (h != halfedge_from(v));
    return false;
  }
  /// says if `v` is regular, and on no fixed curve or on one that goes straight on there.
  bool goes_straight_on(int v) const
  {
    if (!is_regular(v))
      return false;
    std::vector<int> fixed; // positions among the edges at v
    int k = 0, h = halfedge_from(v);
    do {
      if (is_fixed(edge(h)))
        fixed.push_back(k);
      ++k;
      h = turn_right(h);
    } while (h != halfedge_from(v));
    if (is_on_border(v))
      return fixed.size() == 2;
    return fixed.empty() || (fixed.size() == 2 && fixed[1] - fixed[0] == 2);
  }

  int chord(int edge) const { return edge_chord[edge]; }
  bool is_on_separatrix(int edge) const { return edge_on_separatrix[edge] != 0; }
  int patch(int face) const { return face_patch[face]; }
  /// returns the number of layout vertices that are not regular.
  int number_of_irregular_vertices() const
  {
    int n = 0;
    for (int v = 0; v < number_of_vertices(); ++v)
      n += !is_regular(v);
    return n;
  }

  /// \name The arrays
  /// @{
  int number_of_patches = 0;
  int number_of_chords = 0;
  std::vector<int> edge_chord;
  std::vector<char> edge_on_separatrix;
  std::vector<char> edge_is_fixed; ///< empty if no edge but those on the border is
  std::vector<int> face_patch;
  std::vector<Cluster> clusters; ///< in ascending order of their first node
  std::vector<int> node_vertex;  ///< per node of the T-mesh the layout vertex it becomes
  std::vector<Grid> grids;       ///< per patch of the T-mesh
  /// per arc of the T-mesh the layout halfedges that it becomes, in its own direction; none where
  /// its length is 0
  std::vector<std::vector<int>> arc_halfedges;
  std::vector<double> chord_length; ///< per chord a length on the surface, fitted to the T-mesh
  /// @}
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_QUAD_LAYOUT_H
