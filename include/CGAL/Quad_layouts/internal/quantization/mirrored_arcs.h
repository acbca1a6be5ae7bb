// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MIRRORED_ARCS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MIRRORED_ARCS_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/quantization/Runs.h>
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
  // takes the images of the vertices of the user's mesh; throws if a face has no image
  Surface_symmetry(const Triangle_surface& surface, const std::vector<int>& vertex_image)
    : m_surface(surface), m_original(surface.original()), m_image(vertex_image)
  {
    for (int h = 0; h < m_original.number_of_halfedges(); ++h)
      m_corner_image.push_back(find_corner_image(h));
    find_images_of_added_vertices();
  }

  // -1 for vertices without an image: where edges are equally long, faces need not be divided alike
  int vertex_image(int v) const { return m_image[v]; }
  // of halfedges of the user's mesh: the one with the image of the source of `h` in the image of
  // the face of `h`
  int corner_image(int h) const { return m_corner_image[h]; }
  // says if the image of a face of the user's mesh runs the other way
  bool turns_over(int f) const
  {
    return m_original.target(m_corner_image[3 * f]) != m_image[m_original.target(3 * f)];
  }

private:
  int find_corner_image(int h) const
  {
    const int u = m_image[m_original.source(h)], v = m_image[m_original.target(h)];
    const int w = m_image[m_original.source(m_original.prev(h))];
    int result = -1;
    m_original.for_each_outgoing(u, [&](int g) {
      const int next = m_original.target(g), last = m_original.source(m_original.prev(g));
      if (std::minmax(next, last) == std::minmax(v, w))
        result = g;
    });
    if (result < 0)
      throw Invalid_parameter("vertex_symmetry: face " + std::to_string(h / 3) + " has no image");
    return result;
  }

  // Between images of vertices is the image of the vertex between them.
  void find_images_of_added_vertices()
  {
    const int first = m_original.number_of_vertices();
    std::map<std::vector<int>, int> between;
    for (int v = first; v < m_surface.number_of_vertices(); ++v)
      between[m_surface.parents(v)] = v;
    for (int v = first; v < m_surface.number_of_vertices(); ++v) {
      std::vector<int> images;
      for (const int parent : m_surface.parents(v))
        images.push_back(m_image[parent]);
      std::sort(images.begin(), images.end());
      const auto found = between.find(images);
      m_image.push_back(found == between.end() ? -1 : found->second);
    }
  }

  const Triangle_surface& m_surface;
  const Triangle_surface& m_original;
  std::vector<int> m_image; // per vertex
  std::vector<int> m_corner_image;
};

// Which segments of runs are the images of which, where a T-mesh is as symmetric as its surface.
// Traces of a symmetric field are so but for rounding, and for what depends on the order of traces
// that meet after equal lengths. Two runs correspond that start in corresponding directions; two
// nodes where runs that correspond meet after (nearly) equal lengths.
class Mirrored_runs
{
public:
  // arcs, and the arcs of the image
  using Segments = std::pair<std::vector<int>, std::vector<int>>;

  Mirrored_runs(const T_mesh& t_mesh, const Runs& runs, const Surface_symmetry& symmetry)
    : m_t_mesh(t_mesh), m_runs(runs), m_symmetry(symmetry), m_image(runs.size(), -1)
  {
    for (int n = 0; n < t_mesh.number_of_vertices(); ++n)
      if (t_mesh.is_singularity_or_seed(n))
        m_node_of_vertex[t_mesh.surface_vertex(n)] = n;
    for (const auto& [vertex, node] : m_node_of_vertex)
      match_traces(vertex);
    match_fixed_runs();
    find_meetings();
  }

  bool is_empty() const
  {
    return std::all_of(m_image.begin(), m_image.end(), [](int r) { return r < 0; });
  }

  // returns the segments between corresponding nodes, each with its image, but for those that are
  // their own images; a pair once, whichever comes first
  std::vector<Segments> segments() const
  {
    std::vector<Segments> result;
    // those of the other runs are the same, the other way
    for (std::size_t t = 0; t < m_t_mesh.traces.size(); ++t)
      if (m_image[t] >= 0)
        add_segments(int(t), result);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

private:
  bool is_fixed(int run) const
  {
    return !m_runs[run].arcs.empty() && m_t_mesh.is_fixed(m_runs[run].arcs.front());
  }

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
    } while (h >= 0 && h != first);
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

  // An outgoing halfedge of a vertex and the one that it is mapped to, {-1, -1} if there is none;
  // at the border, from where angles are counted, the most clockwise ones.
  std::pair<int, int> corresponding_halfedges(int vertex) const
  {
    const T_mesh::Surface& surface = m_t_mesh.surface();
    const int image = m_symmetry.vertex_image(vertex);
    std::pair<int, int> result(-1, -1);
    if (image < 0)
      return result;
    if (surface.is_on_border(vertex))
      return {surface.halfedge(vertex), surface.halfedge(image)};
    surface.for_each_outgoing(vertex, [&](int h) {
      surface.for_each_outgoing(image, [&](int g) {
        if (result.first < 0 && surface.target(g) == m_symmetry.vertex_image(surface.target(h)))
          result = {h, g};
      });
    });
    return result;
  }

  // The traces around a vertex correspond in their order, which is cyclic away from the border,
  // such that their angles differ as little as possible.
  void match_traces(int vertex)
  {
    const auto [first, image] = corresponding_halfedges(vertex);
    if (first < 0)
      return;
    const std::vector<Start> here = starts(first);
    std::vector<Start> there = starts(image);
    if (here.size() != there.size())
      return;
    if (m_symmetry.turns_over(m_t_mesh.surface().origin(first / 3))) {
      std::reverse(there.begin(), there.end());
      for (Start& start : there)
        start.angle = -start.angle;
    }
    double least = (std::numeric_limits<double>::max)();
    const std::size_t shifts = m_t_mesh.surface().is_on_border(vertex) ? 1 : there.size();
    for (std::size_t shift = 0; shift < shifts; ++shift) {
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

  // the ends of the edge of the surface that a fixed run begins with
  std::pair<int, int> first_edge(int run) const
  {
    const T_mesh::Surface& surface = m_t_mesh.surface();
    const auto& pieces = m_t_mesh.arc_pieces[m_runs[run].arcs.front()];
    const int start = m_t_mesh.surface_vertex(m_runs[run].start);
    const int h = pieces.front().halfedge, last = pieces.back().halfedge;
    return {start, surface.source(h) == start ? surface.target(h) : surface.source(last)};
  }

  // Fixed runs correspond that begin with corresponding edges.
  void match_fixed_runs()
  {
    std::map<std::pair<int, int>, int> beginning;
    for (int r = 0; r < m_runs.size(); ++r)
      if (is_fixed(r))
        beginning[first_edge(r)] = r;
    for (const auto& [edge, run] : beginning) {
      const auto image = beginning.find(
          {m_symmetry.vertex_image(edge.first), m_symmetry.vertex_image(edge.second)});
      if (image != beginning.end())
        m_image[run] = image->second;
    }
  }

  // a place where a run meets another one, after so many arcs of both
  struct Meeting
  {
    int arcs, other_arcs;
  };

  void find_meetings()
  {
    m_meetings.resize(m_image.size());
    for (const Run_meeting& meeting : m_runs.meetings())
      for (int k : {0, 1}) {
        const Run_visit &own = meeting.visits[k], &other = meeting.visits[1 - k];
        m_meetings[own.run][other.run].push_back({own.arcs, other.arcs});
      }
  }

  // the difference between the lengths of a run to a node and its image to another one, as a
  // fraction of the whole run
  double difference(int run, int arcs, int arcs_of_image) const
  {
    const std::vector<double>& lengths = m_runs[run].lengths;
    return std::abs(lengths[arcs] - m_runs[m_image[run]].lengths[arcs_of_image]) / lengths.back();
  }

  // returns the number of arcs of the image of `run` before it meets the image of `other` at the
  // place that corresponds to a meeting of both, -1 if there is none
  int corresponding(int run, int other, const Meeting& meeting) const
  {
    const auto candidates = m_meetings[m_image[run]].find(m_image[other]);
    if (candidates == m_meetings[m_image[run]].end())
      return -1;
    double least = tolerance;
    int result = -1;
    for (const Meeting& m : candidates->second) {
      const double d = difference(run, meeting.arcs, m.arcs) +
                       difference(other, meeting.other_arcs, m.other_arcs);
      if (d < least) {
        least = d;
        result = m.arcs;
      }
    }
    return result;
  }

  // where a run and its image meet runs that correspond: arcs before that of both, ascending. Where
  // runs lead next to each other, they may come in another order there: these are left out. Fixed
  // runs that correspond have ends that do.
  std::vector<std::pair<int, int>> corresponding_meetings(int run) const
  {
    std::vector<std::pair<int, int>> all, result;
    for (const auto& [other, meetings] : m_meetings[run])
      for (const Meeting& m : meetings) {
        const int arcs = m_image[other] < 0 ? -1 : corresponding(run, other, m);
        if (arcs >= 0)
          all.emplace_back(m.arcs, arcs);
      }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::vector<int> least_after(all.size() + 1, (std::numeric_limits<int>::max)());
    for (std::size_t i = all.size(); i-- > 0;)
      least_after[i] = (std::min)(all[i].second, least_after[i + 1]);
    int most_before = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (most_before < all[i].second && all[i].second < least_after[i + 1])
        result.push_back(all[i]);
      most_before = (std::max)(most_before, all[i].second);
    }
    if (is_fixed(run))
      result.emplace_back(m_runs[run].arcs.size(), m_runs[m_image[run]].arcs.size());
    return result;
  }

  void add_segments(int run, std::vector<Segments>& result) const
  {
    std::pair<int, int> last(0, 0);
    for (const auto& meeting : corresponding_meetings(run)) {
      Segments segments{arcs_between(run, last.first, meeting.first),
                        arcs_between(m_image[run], last.second, meeting.second)};
      if (segments.second < segments.first)
        std::swap(segments.first, segments.second);
      if (segments.first != segments.second)
        result.push_back(std::move(segments));
      last = meeting;
    }
  }

  // ascending, whichever way the run leads
  std::vector<int> arcs_between(int run, int from, int to) const
  {
    const auto& arcs = m_runs[run].arcs;
    std::vector<int> result(arcs.begin() + from, arcs.begin() + to);
    std::sort(result.begin(), result.end());
    return result;
  }

  // Corresponding places of symmetric fields differ by rounding, and where traces pass vertices.
  static constexpr double tolerance = 0.01;

  const T_mesh& m_t_mesh;
  const Runs& m_runs;
  const Surface_symmetry& m_symmetry;
  std::map<int, int> m_node_of_vertex;
  std::vector<int> m_image;                                    // per run
  std::vector<std::map<int, std::vector<Meeting>>> m_meetings; // per run, by the other
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_MIRRORED_ARCS_H
