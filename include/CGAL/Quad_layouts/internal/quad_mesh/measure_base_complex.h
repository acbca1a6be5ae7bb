// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_BASE_COMPLEX_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_BASE_COMPLEX_H

#include <CGAL/Quad_layouts/internal/quad_mesh/measure_polygons.h>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The number of edges at each vertex, and whether it lies on the border.
struct Vertex_valences
{
  explicit Vertex_valences(const Polygons& mesh)
    : valence(mesh.number_of_vertices(), 0), on_border(mesh.number_of_vertices(), 0)
  {
    for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
      ++valence[mesh.source[h]];
      if (mesh.is_border(h)) { // the edge that no other halfedge counts at the target
        ++valence[mesh.target(h)];
        on_border[mesh.source[h]] = on_border[mesh.target(h)] = 1;
      }
    }
  }

  bool is_regular(int v) const { return valence[v] == (on_border[v] ? 3 : 4); }

  std::vector<int> valence;
  std::vector<char> on_border;
};

// The cells that the separatrices and the fixed edges cut a quad mesh into.
struct Base_complex
{
  std::vector<char> on_separatrix; // per halfedge: fixed or part of a separatrix
  std::vector<int> patch;          // per face
  int number_of_patches = 0;
};

// returns per vertex whether no separatrix begins there: the vertex is regular, and feature curves
// go straight on if there are any
inline std::vector<char> ordinary_vertices(const Polygons& mesh, const Vertex_valences& vertices)
{
  std::vector<char> result(mesh.number_of_vertices());
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    result[v] = vertices.is_regular(v);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h) {
    const int v = mesh.target(h);
    if (vertices.is_regular(v) && !vertices.on_border[v] &&
        mesh.is_fixed(h) != mesh.is_fixed(mesh.straight_on(h)))
      result[v] = 0;
  }
  return result;
}

// marks the edges from the halfedge h straight on, up to the border or a vertex that is not
// ordinary
inline void mark_separatrix(const Polygons& mesh, const Vertex_valences& vertices,
                            const std::vector<char>& is_ordinary, int h, std::vector<char>& marked)
{
  while (!marked[h]) {
    marked[h] = 1;
    if (!mesh.is_border(h))
      marked[mesh.opposite[h]] = 1;
    const int v = mesh.target(h);
    if (vertices.on_border[v] || !is_ordinary[v])
      return;
    h = mesh.straight_on(h);
  }
}

// numbers the components of the faces that remain when the marked halfedges are cut
inline int number_components(const Polygons& mesh, const std::vector<char>& cut,
                             std::vector<int>& component)
{
  component.assign(mesh.number_of_faces(), -1);
  int n = 0;
  std::vector<int> pending;
  for (int seed = 0; seed < mesh.number_of_faces(); ++seed) {
    if (component[seed] >= 0)
      continue;
    component[seed] = n;
    pending.push_back(seed);
    while (!pending.empty()) {
      const int f = pending.back();
      pending.pop_back();
      for (int h = mesh.first_halfedge[f]; h < mesh.first_halfedge[f + 1]; ++h) {
        const int g = cut[h] ? -1 : mesh.opposite[h];
        if (g < 0 || component[mesh.face[g]] >= 0)
          continue;
        component[mesh.face[g]] = n;
        pending.push_back(mesh.face[g]);
      }
    }
    ++n;
  }
  return n;
}

// cuts a quad mesh along its fixed edges and all separatrices; a component without any is one
// patch. All faces must be quads.
inline Base_complex base_complex(const Polygons& mesh, const Vertex_valences& vertices)
{
  const std::vector<char> is_ordinary = ordinary_vertices(mesh, vertices);
  Base_complex result;
  result.on_separatrix.assign(mesh.number_of_halfedges(), 0);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (!mesh.is_fixed(h) && !is_ordinary[mesh.source[h]])
      mark_separatrix(mesh, vertices, is_ordinary, h, result.on_separatrix);
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.is_fixed(h))
      result.on_separatrix[h] = 1;
  result.number_of_patches = number_components(mesh, result.on_separatrix, result.patch);
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_BASE_COMPLEX_H
