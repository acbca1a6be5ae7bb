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
separatrices (the border, and chains of edges that leave an irregular vertex and go straight on): `patch` says to
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
