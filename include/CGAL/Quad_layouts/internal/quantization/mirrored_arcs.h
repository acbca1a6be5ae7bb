// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MIRRORED_ARCS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MIRRORED_ARCS_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A symmetry of a surface, given by the images of the vertices. It may turn the surface over.
class Surface_symmetry
{
public:
  // throws if an edge or a face has no image
  Surface_symmetry(const Triangle_surface& surface, const std::vector<int>& vertex_image)
    : m_surface(surface), m_image(vertex_image)
  {
    for (int h = 0; h < surface.number_of_halfedges(); ++h)
      m_corner_image.push_back(find_corner_image(h));
  }

  int vertex_image(int v) const { return m_image[v]; }
  // the halfedge with the image of the source of `h` in the image of the face of `h`
  int corner_image(int h) const { return m_corner_image[h]; }
  // says if the image of the face of `h` runs the other way
  bool turns_over(int h) const
  {
    return m_surface.target(m_corner_image[h]) != m_image[m_surface.target(h)];
  }

private:
  int find_corner_image(int h) const
  {
    const int u = m_image[m_surface.source(h)], v = m_image[m_surface.target(h)];
    const int w = m_image[m_surface.source(m_surface.prev(h))];
    int result = -1;
    m_surface.for_each_outgoing(u, [&](int g) {
      const int next = m_surface.target(g), last = m_surface.source(m_surface.prev(g));
      if (std::minmax(next, last) == std::minmax(v, w))
        result = g;
    });
    if (result < 0)
      throw Invalid_parameter("vertex_symmetry: face " + std::to_string(h / 3) + " has no image");
    return result;
  }

  const Triangle_surface& m_surface;
  const std::vector<int>& m_image;
  std::vector<int> m_corner_image;
};

// Which segments of traces are the images of which, where a T-mesh is as symmetric as its surface.
// Traces of a symmetric field are so but for rounding, and for what depends on the order of traces
// that meet after equal lengths. Two traces begin alike in corresponding directions; and their
// nodes correspond where they cross traces that correspond, once each.
class Mirrored_traces
{
public:
  // arcs, and the arcs of the image
  using Segments = std::pair<std::vector<int>, std::vector<int>>;

  Mirrored_traces(const T_mesh& t_mesh, const Surface_symmetry& symmetry)
    : m_t_mesh(t_mesh), m_symmetry(symmetry), m_image(t_mesh.traces.size(), -1)
  {
    for (int n = 0; n < t_mesh.number_of_vertices(); ++n)
      if (t_mesh.is_singularity_or_seed(n))
        m_node_of_vertex[t_mesh.surface_vertex(n)] = n;
    for (const auto& [vertex, node] : m_node_of_vertex)
      match_traces(vertex);
    find_crossings();
  }

  // the image of a trace, or -1
  int image(int trace) const { return m_image[trace]; }

  // returns the segments between corresponding nodes, each with its image, but for those that are
  // their own images; a pair once, whichever comes first
  std::vector<Segments> segments() const
  {
    std::vector<Segments> result;
    for (std::size_t t = 0; t < m_image.size(); ++t)
      if (m_image[t] >= 0)
        add_segments(int(t), result);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

private:
  struct Start
  {
    int trace, corner;
  };

  // the traces that start at a vertex, counter-clockwise
  std::vector<Start> starts(int vertex) const
  {
    std::vector<Start> result;
    m_t_mesh.surface().for_each_outgoing(vertex, [&](int corner) {
      for (const int h : m_t_mesh.corner_arcs[corner]) {
        const int t = m_t_mesh.trace(T_mesh::edge(h));
        if (h % 2 == 0 && m_t_mesh.traces[t].arcs.front() == T_mesh::edge(h))
          result.push_back({t, corner});
      }
    });
    return result;
  }

  // The traces around a vertex correspond in their cyclic order, such that as many as possible
  // start in corresponding faces.
  void match_traces(int vertex)
  {
    const std::vector<Start> here = starts(vertex);
    std::vector<Start> there = starts(m_symmetry.vertex_image(vertex));
    if (here.empty() || here.size() != there.size())
      return;
    if (m_symmetry.turns_over(here.front().corner))
      std::reverse(there.begin(), there.end());
    int best = 0;
    for (std::size_t shift = 0; shift < there.size(); ++shift) {
      int agreeing = 0;
      for (std::size_t k = 0; k < here.size(); ++k)
        agreeing += m_symmetry.corner_image(here[k].corner) ==
                    there[(k + shift) % there.size()].corner;
      if (agreeing <= best)
        continue;
      best = agreeing;
      for (std::size_t k = 0; k < here.size(); ++k)
        m_image[here[k].trace] = there[(k + shift) % there.size()].trace;
    }
  }

  // notes after how many arcs a trace crosses another one; not if it does so again
  void find_crossings()
  {
    m_crossings.resize(m_image.size());
    const auto note = [&](const T_mesh::Visit& own, const T_mesh::Visit& other) {
      const auto inserted = m_crossings[own.trace].emplace(other.trace, own.arcs);
      if (!inserted.second)
        inserted.first->second = REPEATED;
    };
    for (const auto& visits : m_t_mesh.node_visits)
      if (visits.size() == 2) {
        note(visits[0], visits[1]);
        note(visits[1], visits[0]);
      }
  }

  void add_segments(int t, std::vector<Segments>& result) const
  {
    std::vector<std::pair<int, int>> crossings; // arcs before it, trace
    for (const auto& [other, arcs] : m_crossings[t])
      if (arcs != REPEATED && m_image[other] >= 0)
        crossings.emplace_back(arcs, other);
    std::sort(crossings.begin(), crossings.end());
    const auto& there = m_crossings[m_image[t]];
    int last = 0, last_there = 0;
    for (const auto& [arcs, other] : crossings) {
      const auto found = there.find(m_image[other]);
      if (found == there.end() || found->second <= last_there)
        continue;
      Segments segments{arcs_between(t, last, arcs),
                        arcs_between(m_image[t], last_there, found->second)};
      if (segments.second < segments.first)
        std::swap(segments.first, segments.second);
      if (segments.first != segments.second)
        result.push_back(std::move(segments));
      last = arcs;
      last_there = found->second;
    }
  }

  std::vector<int> arcs_between(int trace, int from, int to) const
  {
    const auto& arcs = m_t_mesh.traces[trace].arcs;
    return {arcs.begin() + from, arcs.begin() + to};
  }

  static constexpr int REPEATED = -1;

  const T_mesh& m_t_mesh;
  const Surface_symmetry& m_symmetry;
  std::map<int, int> m_node_of_vertex;
  std::vector<int> m_image;                    // per trace
  std::vector<std::map<int, int>> m_crossings; // per trace: trace, arcs before it
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MIRRORED_ARCS_H
