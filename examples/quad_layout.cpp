// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Computes a quad layout and a quad mesh of a triangle mesh, stage by stage, and writes them
// with statistics. `quad_layout --help` tells how it is used.

#include "quad_layout/input.h"
#include "quad_layout/options.h"
#include "quad_layout/output.h"
#include "quad_layout/stages.h"

#include <CGAL/Quad_layouts/IO/Json_object.h>
#include <CGAL/Quad_layouts/IO/write_layout.h>
#include <CGAL/Quad_layouts/IO/write_quad_mesh.h>

#include <CGAL/Polygon_mesh_processing/border.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using QL::IO::Json_object;

std::string status_name(QL::Quantization::Status status)
{
  switch (status) {
    case QL::Quantization::OPTIMAL: return "optimal";
    case QL::Quantization::FEASIBLE: return "feasible";
    default: return "infeasible";
  }
}

int number_of_borders(const Mesh& mesh)
{
  std::vector<Mesh::Halfedge_index> cycles;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  return int(cycles.size());
}

Json_object statistics(const Mesh& mesh, const Results& r)
{
  const QL::Quad_mesh_measures input = QL::measure_quad_mesh(mesh);
  const QL::Quantization& program = r.quantization;
  Json_object seconds;
  for (const auto& stage : r.seconds)
    seconds.add(stage.first, stage.second);
  return Json_object()
      .add("input", Json_object()
                        .add("vertices", input.vertices)
                        .add("faces", int(mesh.number_of_faces()))
                        .add("euler", input.euler_characteristic)
                        .add("components", input.components)
                        .add("borders", number_of_borders(mesh)))
      .add("route", r.t_mesh.route == QL::PARAMETRIZATION ? "parametrization" : "field")
      .add("singularities_in", r.field.number_of_singularities())
      .add("singularities_out", r.quality.irregular_vertices)
      .add("patches", r.quality.patches)
      .add("patches_floor", r.quality.patches_floor)
      .add("t_junctions", r.quality.t_junctions)
      .add("quads", r.quality.quads)
      .add("bad_quads", int(r.number_of_bad_quads))
      .add("msj_min", r.quality.msj_minimum)
      .add("msj_avg", r.quality.msj_average)
      .add("t_mesh", Json_object()
                         .add("nodes", r.t_mesh.number_of_vertices())
                         .add("arcs", r.t_mesh.number_of_edges())
                         .add("patches", r.t_mesh.number_of_faces())
                         .add("traces", int(r.t_mesh.traces.size())))
      .add("program", Json_object()
                          .add("variables", program.variables)
                          .add("constraints", program.constraints)
                          .add("indicators", program.indicators)
                          .add("objective", program.objective)
                          .add("bound", program.bound)
                          .add("gap", program.gap())
                          .add("status", status_name(program.status))
                          .add("rounds", program.rounds))
      .add("map", Json_object()
                      .add("triangles", r.map.surface().number_of_faces())
                      .add("inverted", r.map.inverted)
                      .add("wrong_winding", r.map.wrong_winding))
      .add("seconds", seconds);
}

void write(const Mesh& mesh, const Results& r, const std::string& folder)
{
  Output_files files(folder);
  files.write("layout.obj", [&](std::ostream& out) { return QL::IO::write_layout(out, r.layout); });
  files.write("layout_curves.obj", [&](std::ostream& out) {
    return QL::IO::write_layout_curves(out, r.quads, r.is_node, r.is_layout_edge);
  });
  files.write("quad_mesh.obj", [&](std::ostream& out) {
    return QL::IO::write_quad_mesh_obj(out, r.quads, r.patch);
  });
  files.write("quad_mesh.vtp", [&](std::ostream& out) {
    return QL::IO::write_quad_mesh_vtp(out, r.quads, r.patch);
  });
  files.write("stats.json",
              [&](std::ostream& out) { return bool(out << statistics(mesh, r) << '\n'); });
  files.commit();
}

int main(int argc, char* argv[])
{
  const int usage_status = 2;
  try {
    const Options options = parse(argc, argv);
    if (options.help) {
      std::cout << usage();
      return EXIT_SUCCESS;
    }
    Results results;
    Stage_clock clock(options, results.seconds);
    Mesh mesh = clock("read", [&] { return read_mesh(options.input, options.repair); });
    run_stages(mesh, options, clock, results);
    write(mesh, results, options.output);
    if (results.number_of_bad_quads > 0)
      std::cerr << "quad_layout: warning: " << results.number_of_bad_quads
                << " quads are inverted or oppose the surface\n";
    return EXIT_SUCCESS;
  } catch (const Usage_error& error) {
    std::cerr << "quad_layout: " << error.what() << "\n\n" << usage();
    return usage_status;
  } catch (const QL::Invalid_parameter& error) {
    std::cerr << "quad_layout: " << error.what() << '\n';
    return usage_status;
  } catch (const QL::Error& error) {
    std::cerr << "quad_layout: " << error.what() << repair_hint(error) << '\n';
  } catch (const std::exception& error) {
    std::cerr << "quad_layout: " << error.what() << '\n';
  }
  return EXIT_FAILURE;
}
