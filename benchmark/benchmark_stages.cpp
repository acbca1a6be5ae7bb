// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Runs all stages on each of the given meshes, and prints a line of comma-separated values per
// mesh: the seconds of each stage, the peak memory of the process so far, and the quality reached.

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/embed_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/extract_quad_mesh.h>
#include <CGAL/Quad_layouts/measure_quad_mesh.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/smooth_quad_mesh.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace QL = CGAL::Quad_layouts;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

struct Figures
{
  std::vector<double> seconds; // per stage
  int singularities = 0;       // of the field
  double gap = 0;              // of the integer program
  QL::Quad_mesh_measures quality;
};

// returns what `work` returns, and notes how long it took
template <class Work>
auto timed(Figures& figures, const Work& work)
{
  struct Stopwatch
  {
    std::vector<double>& seconds;
    CGAL::Real_timer timer;

    explicit Stopwatch(std::vector<double>& notes) : seconds(notes) { timer.start(); }
    ~Stopwatch() { seconds.push_back(timer.time()); }
  } const stopwatch(figures.seconds);
  return work();
}

Figures run_stages(const Mesh& mesh)
{
  Figures result;
  const auto field = timed(result, [&] { return QL::compute_cross_field(mesh); });
  const auto t_mesh = timed(result, [&] { return QL::trace_motorcycle_graph(field); });
  const auto quantization = timed(result, [&] { return QL::quantize(t_mesh); });
  const auto layout = timed(result, [&] { return QL::extract_quad_layout(t_mesh, quantization); });
  const auto map = timed(result, [&] { return QL::embed_quad_layout(t_mesh, layout); });
  Mesh quads;
  timed(result, [&] { QL::extract_quad_mesh(map, layout, quads); });
  timed(result, [&] { QL::smooth_quad_mesh(quads, mesh); });
  result.singularities = field.number_of_singularities();
  result.gap = quantization.gap();
  result.quality = QL::measure_quad_mesh(quads, mesh);
  return result;
}

long peak_memory_in_megabytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

void print(const std::string& file, const Mesh& mesh, const Figures& figures)
{
  const QL::Quad_mesh_measures& quality = figures.quality;
  std::cout << file << ',' << mesh.number_of_faces();
  for (const double seconds : figures.seconds)
    std::cout << ',' << seconds;
  std::cout << ',' << peak_memory_in_megabytes() << ',' << figures.singularities << ','
            << quality.irregular_vertices << ',' << quality.patches_floor << ',' << quality.patches
            << ',' << figures.gap << ',' << quality.quads << ',' << quality.msj_minimum << ','
            << quality.msj_average << ',' << quality.maximum_distance_to_surface << std::endl;
}

int main(int argc, char* argv[])
{
  std::cout << "mesh,faces,field,trace,quantize,extract,embed,quad_mesh,smooth,megabytes,"
               "singularities_in,singularities_out,patches_floor,patches,gap,quads,msj_min,msj_avg,"
               "distance"
            << std::endl;
  int failures = 0;
  for (int i = 1; i < argc; ++i)
    try {
      Mesh mesh;
      if (!CGAL::IO::read_polygon_mesh(argv[i], mesh))
        throw QL::Error("cannot be read");
      print(argv[i], mesh, run_stages(mesh));
    } catch (const QL::Error& error) {
      std::cerr << argv[i] << ": " << error.what() << '\n';
      ++failures;
    }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
