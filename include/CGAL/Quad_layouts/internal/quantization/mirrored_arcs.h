// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MIRRORED_ARCS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MIRRORED_ARCS_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/quantization/point_of_crossing.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
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

  // the halfedge between the images of the source and the target of `h`
  int image(int h) const
  {
    const int g = m_corner_image[h];
    return turns_over(h) ? m_surface.turn_left(g) : g;
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
// that meet after equal lengths. Two traces correspond that start in corresponding directions; two
// nodes where traces that correspond cross after (nearly) equal lengths.
class Mirrored_traces
{
public:
  // arcs, and the arcs of the image
  using Segments = std::pair<std::vector<int>, std::vector<int>>;

  // `lengths`: of the first 0, 1, 2, ... arcs of each trace
  Mirrored_traces(const T_mesh& t_mesh, const std::vector<std::vector<double>>& lengths,
                  const Surface_symmetry& symmetry)
    : m_t_mesh(t_mesh), m_lengths(lengths), m_symmetry(symmetry), m_image(t_mesh.traces.size(), -1)
  {
    for (int n = 0; n < t_mesh.number_of_vertices(); ++n)
      if (t_mesh.is_singularity_or_seed(n))
        m_node_of_vertex[t_mesh.surface_vertex(n)] = n;
    for (const auto& [vertex, node] : m_node_of_vertex)
      match_traces(vertex);
    find_crossings();
  }

  bool is_empty() const
  {
    return std::all_of(m_image.begin(), m_image.end(), [](int t) { return t < 0; });
  }

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
  // a trace, and the angle from some halfedge to it, as a fraction of the full angle
  struct Start
  {
    int trace;
    double angle;
  };

  // the traces that start at the source of `first`, counter-clockwise from there
  std::vector<Start> starts(int first) const
  {
    const T_mesh::Surface& surface = m_t_mesh.surface();
    std::vector<Start> result;
    double angle = 0;
    int h = first;
    do {
      for (const int arc : m_t_mesh.corner_arcs[h]) {
        const int t = m_t_mesh.trace(T_mesh::edge(arc));
        if (arc % 2 == 0 && m_t_mesh.traces[t].arcs.front() == T_mesh::edge(arc))
          result.push_back({t, angle + angle_in_corner(h, t)});
      }
      angle += surface.corner_angle(h);
      h = surface.turn_left(h);
    } while (h != first);
    for (Start& start : result)
      start.angle /= angle;
    return result;
  }

  double angle_in_corner(int h, int trace) const
  {
    const T_mesh::Surface& surface = m_t_mesh.surface();
    for (const int a : m_t_mesh.traces[trace].arcs)
      if (!m_t_mesh.arc_crossings[a].empty()) {
        const T_mesh::Point to = point_of(m_t_mesh, m_t_mesh.arc_crossings[a].front()) -
                                 surface.point(surface.source(h));
        const T_mesh::Point side = surface.vector(h);
        return std::atan2(side.cross(to).norm(), side.dot(to));
      }
    return 0;
  }

  // The traces around a vertex correspond in their cyclic order, such that their angles differ as
  // little as possible.
  void match_traces(int vertex)
  {
    const int first = m_t_mesh.surface().halfedge(vertex);
    const std::vector<Start> here = starts(first);
    std::vector<Start> there = starts(m_symmetry.image(first));
    if (here.size() != there.size())
      return;
    if (m_symmetry.turns_over(first)) {
      std::reverse(there.begin(), there.end());
      for (Start& start : there)
        start.angle = -start.angle;
    }
    double least = (std::numeric_limits<double>::max)();
    for (std::size_t shift = 0; shift < there.size(); ++shift) {
      double difference = 0;
      for (std::size_t k = 0; k < here.size(); ++k)
        difference += std::abs(
            std::remainder(here[k].angle - there[(k + shift) % there.size()].angle, 1));
      if (difference >= least)
        continue;
      least = difference;
      for (std::size_t k = 0; k < here.size(); ++k)
        m_image[here[k].trace] = there[(k + shift) % there.size()].trace;
    }
  }

  // a place where a trace crosses another one, after so many arcs of both
  struct Trace_crossing
  {
    int arcs, other_arcs;
  };

  void find_crossings()
  {
    m_crossings.resize(m_image.size());
    const auto note = [&](const T_mesh::Visit& own, const T_mesh::Visit& other) {
      m_crossings[own.trace][other.trace].push_back({own.arcs, other.arcs});
    };
    for (const auto& visits : m_t_mesh.node_visits)
      if (visits.size() == 2) {
        note(visits[0], visits[1]);
        note(visits[1], visits[0]);
      }
  }

  // the difference between what a trace has run to a node and its image to another one, as a
  // fraction of the whole trace
  double difference(int trace, int arcs, int arcs_of_image) const
  {
    return std::abs(m_lengths[trace][arcs] - m_lengths[m_image[trace]][arcs_of_image]) /
           m_lengths[trace].back();
  }

  // returns the number of arcs of the image of trace `t` before it crosses the image of `other` at
  // the place that corresponds to a crossing of both, -1 if there is none
  int corresponding(int t, int other, const Trace_crossing& crossing) const
  {
    const auto candidates = m_crossings[m_image[t]].find(m_image[other]);
    if (candidates == m_crossings[m_image[t]].end())
      return -1;
    double least = tolerance;
    int result = -1;
    for (const Trace_crossing& c : candidates->second) {
      const double d = difference(t, crossing.arcs, c.arcs) +
                       difference(other, crossing.other_arcs, c.other_arcs);
      if (d < least) {
        least = d;
        result = c.arcs;
      }
    }
    return result;
  }

  // where a trace and its image cross traces that correspond: arcs before that of both, ascending.
  // Where traces run next to each other, they may come in another order there: these are left out.
  std::vector<std::pair<int, int>> corresponding_crossings(int t) const
  {
    std::vector<std::pair<int, int>> all, result;
    for (const auto& [other, crossings] : m_crossings[t])
      for (const Trace_crossing& c : crossings) {
        const int arcs = m_image[other] < 0 ? -1 : corresponding(t, other, c);
        if (arcs >= 0)
          all.emplace_back(c.arcs, arcs);
      }
    std::sort(all.begin(), all.end());
    std::vector<int> least_after(all.size() + 1, (std::numeric_limits<int>::max)());
    for (std::size_t i = all.size(); i-- > 0;)
      least_after[i] = (std::min)(all[i].second, least_after[i + 1]);
    int most_before = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (most_before < all[i].second && all[i].second < least_after[i + 1])
        result.push_back(all[i]);
      most_before = (std::max)(most_before, all[i].second);
    }
    return result;
  }

  void add_segments(int t, std::vector<Segments>& result) const
  {
    std::pair<int, int> last(0, 0);
    for (const auto& crossing : corresponding_crossings(t)) {
      Segments segments{arcs_between(t, last.first, crossing.first),
                        arcs_between(m_image[t], last.second, crossing.second)};
      if (segments.second < segments.first)
        std::swap(segments.first, segments.second);
      if (segments.first != segments.second)
        result.push_back(std::move(segments));
      last = crossing;
    }
  }

  std::vector<int> arcs_between(int trace, int from, int to) const
  {
    const auto& arcs = m_t_mesh.traces[trace].arcs;
    return {arcs.begin() + from, arcs.begin() + to};
  }

  // Corresponding places of symmetric fields differ by rounding, and where traces pass vertices.
  static constexpr double tolerance = 0.01;

  const T_mesh& m_t_mesh;
  const std::vector<std::vector<double>>& m_lengths;
  const Surface_symmetry& m_symmetry;
  std::map<int, int> m_node_of_vertex;
  std::vector<int> m_image;                                            // per trace
  std::vector<std::map<int, std::vector<Trace_crossing>>> m_crossings; // per trace, by the other
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MIRRORED_ARCS_H
