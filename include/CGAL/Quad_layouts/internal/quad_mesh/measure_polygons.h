// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_POLYGONS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_POLYGONS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A polygon mesh in index arrays, for the measures and the smoothing of quad meshes.
//
// Vertices and faces have the order of vertices(mesh) and faces(mesh). The halfedges of a face are
// consecutive and in order: those of face f are first_halfedge[f] to first_halfedge[f + 1] - 1, so
// that a halfedge is also the corner at its source. Border halfedges do not exist; the opposite is
// -1 there.
struct Polygons
{
  using Point = Eigen::Vector3d;

  std::vector<Point> points;
  std::vector<int> first_halfedge;         // one more than there are faces
  std::vector<int> source, face, opposite; // per halfedge
  std::vector<char> on_feature;            // per halfedge, empty if there are no features

  int number_of_vertices() const { return int(points.size()); }
  int number_of_halfedges() const { return int(source.size()); }
  int number_of_faces() const { return int(first_halfedge.size()) - 1; }

  int degree(int f) const { return first_halfedge[f + 1] - first_halfedge[f]; }
  int next(int h) const
  {
    return h + 1 == first_halfedge[face[h] + 1] ? first_halfedge[face[h]] : h + 1;
  }
  int prev(int h) const
  {
    return h == first_halfedge[face[h]] ? first_halfedge[face[h] + 1] - 1 : h - 1;
  }
  int target(int h) const { return source[next(h)]; }
  bool is_border(int h) const { return opposite[h] < 0; }
  // among quads, at a target of valence 4 that is not on the border
  int straight_on(int h) const { return next(opposite[next(h)]); }
  // says if the edge of h is on the border or on a feature curve
  bool is_fixed(int h) const { return is_border(h) || (!on_feature.empty() && on_feature[h]); }

  // the corner k (mod 4) of the quad f
  int corner(int f, int k) const { return source[first_halfedge[f] + (k & 3)]; }
  const Point& corner_point(int f, int k) const { return points[corner(f, k)]; }
};

// tells which edges are features, if there is a map
template <class PolygonMesh, class EdgeMap>
void mark_features(const PolygonMesh& mesh, const EdgeMap& is_feature, Polygons& polygons)
{
  for (const auto f : faces(mesh))
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      polygons.on_feature.push_back(get(is_feature, edge(h, mesh)));
}

template <class PolygonMesh>
void mark_features(const PolygonMesh&, const internal_np::Param_not_found&, Polygons&)
{
}

// copies a mesh into arrays
template <class PolygonMesh, class VertexPointMap>
Polygons make_polygons(const PolygonMesh& mesh, const VertexPointMap vpm)
{
  const auto vertex_id = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  const auto halfedge_id = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
  Polygons result;
  for (const auto v : vertices(mesh)) {
    put(vertex_id, v, result.number_of_vertices());
    const auto& p = get(vpm, v);
    result.points.emplace_back(to_double(p.x()), to_double(p.y()), to_double(p.z()));
  }
  result.first_halfedge.push_back(0);
  for (const auto f : faces(mesh)) {
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      put(halfedge_id, h, result.number_of_halfedges());
      result.source.push_back(get(vertex_id, source(h, mesh)));
      result.face.push_back(int(result.first_halfedge.size()) - 1);
    }
    result.first_halfedge.push_back(result.number_of_halfedges());
  }
  for (const auto f : faces(mesh))
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh)) {
      const auto twin = opposite(h, mesh);
      result.opposite.push_back(is_border(twin, mesh) ? -1 : get(halfedge_id, twin));
    }
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUAD_MESH_MEASURE_POLYGONS_H
