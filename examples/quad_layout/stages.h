// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef QUAD_LAYOUTS_EXAMPLES_STAGES_H
#define QUAD_LAYOUTS_EXAMPLES_STAGES_H

#include "input.h"
#include "options.h"

#include <CGAL/Quad_layouts/IO/quantization_program.h>
#include <CGAL/Quad_layouts/IO/seamless_parametrization.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/compute_t_mesh.h>
#include <CGAL/Quad_layouts/embed_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/extract_smooth_quad_mesh.h>
#include <CGAL/Quad_layouts/measure_quad_layout.h>
#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/parameters.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>
#include <CGAL/Quad_layouts/try_layout_routes.h>
#include <CGAL/Quad_layouts/visitor.h>
#ifdef CGAL_USE_CBC
#include <CGAL/Quad_layouts/CBC_mixed_integer_program_traits.h>
#endif
#ifdef CGAL_USE_HIGHS
#include <CGAL/Quad_layouts/HiGHS_mixed_integer_program_traits.h>
#endif

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace QL = CGAL::Quad_layouts;

// tells on the standard error stream how the work gets on
struct Progress : QL::Default_visitor
{
  bool quiet = false;

  void improved(double objective, double bound, double seconds)
  {
    if (!quiet)
      std::cerr << "  objective " << objective << ", bound " << bound << " after " << std::fixed
                << std::setprecision(1) << seconds << " s\n"
                << std::defaultfloat << std::setprecision(6);
  }
  void changed_route(const char* reason)
  {
    if (!quiet)
      std::cerr << "  by the route field, because of " << reason << '\n';
  }
};

// what the stages make of a T-mesh
struct Remeshing
{
  QL::T_mesh t_mesh;
  QL::Quantization quantization;
  QL::Quad_layout layout;
  QL::Integer_grid_map map;

  Mesh quads;
  Mesh::Property_map<Mesh::Face_index, int> patch;
  Mesh::Property_map<Mesh::Vertex_index, bool> is_node;
  Mesh::Property_map<Mesh::Edge_index, bool> is_layout_edge, is_on_feature;
  std::size_t number_of_bad_quads = 0; // that are inverted or oppose the surface
};

// what they make of a mesh
struct Results : Remeshing
{
  QL::Cross_field field;
  QL::Quad_mesh_measures quality;

  std::vector<std::pair<std::string, double>> seconds; // per stage, and in total
};

// measures and announces the stages, and knows how much time is left for them
class Stage_clock
{
public:
  Stage_clock(const Options& options, std::vector<std::pair<std::string, double>>& seconds)
    : m_options(options), m_seconds(seconds)
  {
    m_total.start();
  }

  // if none is left, still enough for a stage to find that out
  double seconds_left() const
  {
    constexpr double hardly_any = 1e-3;
    return (std::max)(hardly_any, m_options.time_limit - m_total.time());
  }

  template <class Work>
  auto operator()(const std::string& stage, const Work& work)
  {
    if (!m_options.quiet)
      std::cerr << stage << " ...\n";
    CGAL::Real_timer timer;
    timer.start();
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      note(stage, timer.time());
    } else {
      auto result = work();
      note(stage, timer.time());
      return result;
    }
  }

  void finish() { note("total", m_total.time()); }

private:
  // a stage that ran before takes its time in sum
  void note(const std::string& stage, double seconds)
  {
    const auto before = std::find_if(m_seconds.begin(), m_seconds.end(),
                                     [&](const auto& noted) { return noted.first == stage; });
    if (before != m_seconds.end())
      before->second += seconds;
    else
      m_seconds.emplace_back(stage, seconds);
    if (!m_options.quiet)
      std::cerr << "  " << std::fixed << std::setprecision(2) << seconds << " s\n"
                << std::defaultfloat << std::setprecision(6);
  }

  const Options& m_options;
  std::vector<std::pair<std::string, double>>& m_seconds;
  CGAL::Real_timer m_total;
};

inline double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) +
                   CGAL::square(box.z_span()));
}

// the sharp edges of a mesh, none if the angle is 0
inline Mesh::Property_map<Mesh::Edge_index, bool> sharp_edges(Mesh& mesh, double angle)
{
  const auto result = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  if (angle > 0)
    CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, angle, result);
  return result;
}

template <class EdgeMap>
QL::Cross_field field_of(Mesh& mesh, const Options& options, const EdgeMap& features,
                         Progress& progress, double seconds)
{
  const auto np = QL::parameters::visitor(std::ref(progress))
                      .edge_is_constrained_map(features)
                      .maximum_running_time(seconds)
                      .cross_field_method(options.field_method == "mixed-integer"
                                              ? QL::MIXED_INTEGER
                                              : QL::DIFFUSION);
  if (options.field.empty())
    return QL::compute_cross_field(mesh, np);
  return QL::compute_cross_field(mesh, np.face_direction_map(read_field(options.field, mesh)));
}

// reads a parametrization, in which lines of constant coordinates run along the features
template <class EdgeMap>
QL::Seamless_parametrization read_parametrization(const std::string& file, const Mesh& mesh,
                                                  const EdgeMap& features)
{
  std::ifstream in(file);
  if (!in)
    throw Input_error(file + ": no such file");
  return QL::IO::read_seamless_parametrization(
      in, mesh, QL::parameters::default_values().edge_is_constrained_map(features));
}

inline void write_field(const std::string& file, const QL::Cross_field& field)
{
  const auto format = field_format(file);
  if (!format)
    throw Usage_error("--write-field needs a file .rosy, .rawfield or .ffield, not " + file);
  std::ofstream out(file);
  if (!QL::IO::write_cross_field(out, field, *format))
    throw std::runtime_error(file + ": cannot be written");
}

template <class NamedParameters>
void write_program(const std::string& file, const QL::T_mesh& t_mesh, const NamedParameters& np)
{
  std::ofstream out(file);
  if (!QL::IO::write_quantization_program(out, t_mesh, np))
    throw std::runtime_error(file + ": cannot be written");
}

template <class NamedParameters>
QL::Quantization read_solution(const std::string& file, const QL::T_mesh& t_mesh,
                               const NamedParameters& np)
{
  std::ifstream in(file);
  if (!in)
    throw Input_error(file + ": no such file");
  return QL::IO::read_quantization(in, t_mesh, np);
}

template <class NamedParameters>
QL::Quantization quantize_by(const std::string& solver, const QL::T_mesh& t_mesh,
                             const NamedParameters& np)
{
#ifdef CGAL_USE_CBC
  if (solver == "cbc")
    return QL::quantize<QL::CBC_mixed_integer_program_traits<double>>(t_mesh, np);
#endif
#ifdef CGAL_USE_HIGHS
  if (solver == "highs")
    return QL::quantize<QL::HiGHS_mixed_integer_program_traits<double>>(t_mesh, np);
#endif
  CGAL_USE(solver);
  return QL::quantize<QL::GLPK_mixed_integer_program_traits<double>>(t_mesh, np);
}

inline QL::Layout_route route_of(const Options& options)
{
  if (options.route == "field")
    return QL::FIELD;
  return options.route == "parametrization" ? QL::PARAMETRIZATION : QL::AUTOMATIC;
}

// the named parameters that all stages share
inline auto shared_parameters(const Mesh& mesh, const Options& options, Progress& progress)
{
  return QL::parameters::maximum_deviation(options.alpha)
      .maximum_displacement(options.displacement)
      .target_edge_length(options.edge_length * diagonal(mesh))
      .minimum_valence(options.min_valence)
      .maximum_valence(options.max_valence)
      .concurrent_searches(options.threads)
      .layout_route(route_of(options))
      .visitor(std::ref(progress));
}

template <class NamedParameters>
QL::Quantization quantization_of(const QL::T_mesh& t_mesh, const Options& options,
                                 Stage_clock& clock, const NamedParameters& np)
{
  if (!options.program.empty())
    write_program(options.program, t_mesh, np);
  QL::Quantization result = clock("quantize", [&] {
    if (!options.solution.empty())
      return read_solution(options.solution, t_mesh, np);
    return quantize_by(options.solver, t_mesh,
                       np.maximum_search_time(options.search_limit)
                           .maximum_running_time(clock.seconds_left() / 2));
  });
  if (result.status == QL::Quantization::INFEASIBLE)
    throw QL::Stage_failure("quantize: no valid quantization was found" +
                            (result.reason.empty() ? "" : "; " + result.reason));
  return result;
}

template <class NamedParameters>
auto with_time_left(const NamedParameters& np, const Stage_clock& clock)
{
  return np.maximum_running_time(clock.seconds_left());
}

// runs the stages from a T-mesh on
template <class EdgeMap, class NamedParameters>
Remeshing remesh(QL::T_mesh t_mesh, const Mesh& mesh, const Options& options,
                 const EdgeMap& features, Stage_clock& clock, const NamedParameters& np)
{
  Remeshing r;
  r.t_mesh = std::move(t_mesh);
  r.quantization = quantization_of(r.t_mesh, options, clock, np);
  r.layout = clock("extract", [&] { return QL::extract_quad_layout(r.t_mesh, r.quantization); });
  r.map = clock("embed", [&] {
    return QL::embed_quad_layout(r.t_mesh, r.layout, with_time_left(np, clock));
  });
  r.patch = r.quads.add_property_map<Mesh::Face_index, int>("f:patch", -1).first;
  r.is_node = r.quads.add_property_map<Mesh::Vertex_index, bool>("v:is_node", false).first;
  r.is_layout_edge =
      r.quads.add_property_map<Mesh::Edge_index, bool>("e:is_layout_edge", false).first;
  r.is_on_feature =
      r.quads.add_property_map<Mesh::Edge_index, bool>("e:is_on_feature", false).first;
  r.number_of_bad_quads = clock("smooth", [&] {
    return QL::extract_smooth_quad_mesh(
        r.map, r.layout, mesh, r.quads,
        with_time_left(np, clock)
            .face_patch_map(r.patch)
            .vertex_is_layout_node_map(r.is_node)
            .edge_is_layout_edge_map(r.is_layout_edge)
            .edge_is_constrained_map(r.is_on_feature),
        QL::parameters::default_values().edge_is_constrained_map(features));
  });
  return r;
}

// runs all stages on a mesh
inline void run_stages(Mesh& mesh, const Options& options, Stage_clock& clock, Results& results)
{
  Progress progress;
  progress.quiet = options.quiet;
  const auto np = shared_parameters(mesh, options, progress);
  const auto features = sharp_edges(mesh, options.features);
  const auto trace = [&](QL::Layout_route route) {
    return clock("trace", [&] {
      return QL::compute_t_mesh(results.field, with_time_left(np.layout_route(route), clock));
    });
  };
  const auto remesh_on = [&](QL::T_mesh t_mesh) {
    return remesh(std::move(t_mesh), mesh, options, features, clock, np);
  };
  const auto keep_field = [&](QL::Cross_field field) {
    results.field = std::move(field);
    if (!options.written_field.empty())
      write_field(options.written_field, results.field);
  };
  Remeshing& best = results;
  if (!options.parametrization.empty()) {
    const QL::Seamless_parametrization map = clock("parametrization", [&] {
      return read_parametrization(options.parametrization, mesh, features);
    });
    keep_field(QL::compute_cross_field(map));
    best = remesh_on(
        clock("trace", [&] { return QL::trace_motorcycle_graph(map, with_time_left(np, clock)); }));
  } else {
    keep_field(clock("field", [&] {
      return field_of(mesh, options, features, progress, clock.seconds_left());
    }));
    // files of programs are of one T-mesh
    const bool is_bound = !options.program.empty() || !options.solution.empty();
    best = is_bound ? remesh_on(trace(route_of(options)))
                    : QL::try_layout_routes(trace, remesh_on, np);
  }
  clock.finish();
  results.quality = QL::measure_quad_mesh(
      results.quads, QL::parameters::default_values().edge_is_constrained_map(best.is_on_feature));
}

#endif // QUAD_LAYOUTS_EXAMPLES_STAGES_H
