// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WEIGHTED_LENGTHS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WEIGHTED_LENGTHS_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/quantization/point_of_crossing.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The mean of weights of faces along arcs. Along an edge of the surface it is that of the two faces
// beside it.
class Weights_along_arcs
{
public:
  Weights_along_arcs(const T_mesh& t_mesh, const std::vector<double>& face_weight)
    : m_t_mesh(t_mesh), m_weight(face_weight), m_start_face(t_mesh.number_of_edges(), -1)
  {
    for (std::size_t corner = 0; corner < t_mesh.corner_arcs.size(); ++corner)
      for (const int h : t_mesh.corner_arcs[corner])
        if (h % 2 == 0)
          m_start_face[T_mesh::edge(h)] = int(corner) / 3;
  }

  // returns the lengths of all arcs, multiplied by the weights along them
  std::vector<double> lengths() const
  {
    std::vector<double> result(m_t_mesh.number_of_edges());
    for (const T_mesh::Trace& trace : m_t_mesh.traces) {
      int face = trace.arcs.empty() ? -1 : m_start_face[trace.arcs.front()];
      for (const int a : trace.arcs)
        result[a] = m_t_mesh.length(a) *
                    (m_t_mesh.is_fixed(a) ? mean_along_edges(a) : mean_across(a, face));
    }
    return result;
  }

private:
  double weight(int face) const { return m_weight[m_t_mesh.surface().origin(face)]; }

  // the mean of the faces beside an edge
  double weight_beside(int h) const
  {
    const int opposite = m_t_mesh.surface().opposite(h);
    return opposite < 0 ? weight(h / 3) : (weight(h / 3) + weight(opposite / 3)) / 2;
  }

  double mean_along_edges(int arc) const
  {
    double length = 0, weighted = 0;
    for (const T_mesh::Crossing& piece : m_t_mesh.arc_pieces[arc]) {
      const double l = length_of_piece(m_t_mesh, piece);
      length += l;
      weighted += l * weight_beside(piece.halfedge);
    }
    return length > 0 ? weighted / length
                      : weight_beside(m_t_mesh.arc_pieces[arc].front().halfedge);
  }

  // expects the face in which the arc begins, and leaves that in which it ends
  double mean_across(int arc, int& face) const
  {
    T_mesh::Point from = m_t_mesh.point(m_t_mesh.source(2 * arc));
    double length = 0, weighted = 0;
    const auto go_to = [&](const T_mesh::Point& to) {
      length += (to - from).norm();
      weighted += (to - from).norm() * weight(face);
      from = to;
    };
    const double first_weight = weight(face);
    for (const T_mesh::Crossing& c : m_t_mesh.arc_crossings[arc]) {
      go_to(point_of(m_t_mesh, c));
      face = c.halfedge / 3;
    }
    go_to(m_t_mesh.point(m_t_mesh.target(2 * arc)));
    return length > 0 ? weighted / length : first_weight;
  }

  const T_mesh& m_t_mesh;
  const std::vector<double>& m_weight; // per face of the user's mesh
  std::vector<int> m_start_face;       // of the first arcs of traces across faces
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_WEIGHTED_LENGTHS_H
