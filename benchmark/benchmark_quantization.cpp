// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Quantizes each of the given meshes for several limits on deviation and displacement, and prints a
// line of comma-separated values per program: its size, the best solution and bound, and the
// seconds until the solution was within 1 % of the final one and until the end.
//
// usage: benchmark_quantization [--alpha LIST] [--displacement LIST] [--solver glpk|cbc|highs]
//        [--time-limit S] [--gap FRACTION] [--most-singularities N] [--threads N]
//        [--noise DEG] MESH...

#include <CGAL/Quad_layouts/GLPK_mixed_integer_program_traits.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/measure_quad_layout.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>
#ifdef CGAL_USE_CBC
#include <CGAL/Quad_layouts/CBC_mixed_integer_program_traits.h>
#endif
#ifdef CGAL_USE_HIGHS
#include <CGAL/Quad_layouts/HiGHS_mixed_integer_program_traits.h>
#endif

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/number_type_config.h>

#include <cstdlib>
#include <iostream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace QL = CGAL::Quad_layouts;
namespace parameters = QL::parameters;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

struct Options
{
  std::vector<double> alphas{15, 25, 35}, displacements{0, 1, 2, 4};
  std::string solver = "glpk";
  double seconds = 10, gap = 0.01;
  int most_singularities = 200;
  int threads = 1;
  double noise = 0; // in degrees
  std::vector<std::string> files;
};

// the steps towards a solution: seconds, objective
struct History : QL::Default_visitor
{
  std::vector<std::pair<double, double>>* steps;

  void improved(double objective, double, double seconds)
  {
    steps->emplace_back(seconds, objective);
  }
};

// turns each direction of a smooth field by up to `noise` degrees, which makes singularities
QL::Cross_field make_field(Mesh& mesh, double noise)
{
  const QL::Cross_field smooth = QL::compute_cross_field(mesh);
  if (noise == 0)
    return smooth;
  using Vector = CGAL::Simple_cartesian<double>::Vector_3;
  const auto directions = mesh.add_property_map<Mesh::Face_index, Vector>("f:direction").first;
  std::mt19937 random;
  for (const Mesh::Face_index f : mesh.faces()) {
    const double turn = noise * CGAL_PI / 180 * (2 * (random() / 4294967296.) - 1);
    const Eigen::Vector3d d = smooth.surface().direction(int(f), smooth.angle(int(f)) + turn);
    directions[f] = Vector(d.x(), d.y(), d.z());
  }
  return QL::compute_cross_field(mesh, parameters::face_direction_map(directions));
}

QL::Quantization quantize(const QL::T_mesh& t_mesh, const Options& options, double alpha, double r,
                          const History& history)
{
  const auto np = parameters::maximum_deviation(alpha)
                      .maximum_displacement(r)
                      .maximum_search_time(options.seconds)
                      .relative_gap(options.gap)
                      .concurrent_searches(options.threads)
                      .visitor(history);
#ifdef CGAL_USE_CBC
  if (options.solver == "cbc")
    return QL::quantize<QL::CBC_mixed_integer_program_traits<double>>(t_mesh, np);
#endif
#ifdef CGAL_USE_HIGHS
  if (options.solver == "highs")
    return QL::quantize<QL::HiGHS_mixed_integer_program_traits<double>>(t_mesh, np);
#endif
  if (options.solver != "glpk")
    throw std::invalid_argument("there is no solver " + options.solver + " here");
  return QL::quantize(t_mesh, np);
}

// returns when the solution was first within 1 % of the final one
double seconds_to_within_a_percent(const std::vector<std::pair<double, double>>& steps,
                                   double objective)
{
  for (const auto& step : steps)
    if (step.second <= 1.01 * objective)
      return step.first;
  return 0;
}

const char* status_name(QL::Quantization::Status status)
{
  switch (status) {
    case QL::Quantization::OPTIMAL: return "optimal";
    case QL::Quantization::FEASIBLE: return "feasible";
    default: return "infeasible";
  }
}

void run(const std::string& file, const QL::Cross_field& field, const Options& options,
         double alpha)
{
  const QL::T_mesh t_mesh = QL::trace_motorcycle_graph(field, parameters::maximum_deviation(alpha));
  for (const double r : options.displacements) {
    std::vector<std::pair<double, double>> steps;
    History history;
    history.steps = &steps;
    CGAL::Real_timer timer;
    timer.start();
    const QL::Quantization q = quantize(t_mesh, options, alpha, r, history);
    const double seconds = timer.time();
    const bool has_layout = q.status != QL::Quantization::INFEASIBLE;
    const int patches = has_layout
                            ? QL::measure_quad_layout(QL::extract_quad_layout(t_mesh, q)).patches
                            : 0;
    std::cout << file << ',' << alpha << ',' << r << ',' << field.number_of_singularities() << ','
              << t_mesh.number_of_edges() << ',' << q.variables << ',' << q.indicators << ','
              << status_name(q.status) << ',' << q.objective << ',' << q.bound << ',' << q.gap()
              << ',' << seconds_to_within_a_percent(steps, q.objective) << ',' << seconds << ','
              << patches << ',' << q.violated << std::endl;
  }
}

std::vector<double> numbers(const std::string& list)
{
  std::vector<double> result;
  std::istringstream in(list);
  for (std::string item; std::getline(in, item, ',');)
    result.push_back(std::stod(item));
  return result;
}

Options read(int argc, char* argv[])
{
  Options result;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return std::string(i + 1 < argc ? argv[++i] : ""); };
    if (word == "--alpha")
      result.alphas = numbers(value());
    else if (word == "--displacement")
      result.displacements = numbers(value());
    else if (word == "--solver")
      result.solver = value();
    else if (word == "--time-limit")
      result.seconds = std::stod(value());
    else if (word == "--gap")
      result.gap = std::stod(value());
    else if (word == "--threads")
      result.threads = std::stoi(value());
    else if (word == "--noise")
      result.noise = std::stod(value());
    else if (word == "--most-singularities")
      result.most_singularities = std::stoi(value());
    else
      result.files.push_back(word);
  }
  return result;
}

// returns how many meshes failed
int run_all(const Options& options)
{
  int failures = 0;
  std::cout << "mesh,alpha,r,singularities,arcs,variables,indicators,status,objective,bound,gap,"
               "seconds_to_1_percent,seconds,patches,violated"
            << std::endl;
  for (const std::string& file : options.files)
    try {
      Mesh mesh;
      if (!CGAL::IO::read_polygon_mesh(file, mesh))
        throw QL::Error("cannot be read");
      const QL::Cross_field field = make_field(mesh, options.noise);
      if (field.number_of_singularities() <= options.most_singularities)
        for (const double alpha : options.alphas)
          run(file, field, options, alpha);
    } catch (const QL::Error& error) {
      std::cerr << file << ": " << error.what() << '\n';
      ++failures;
    }
  return failures;
}

int main(int argc, char* argv[])
{
  try {
    return run_all(read(argc, argv)) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::logic_error& error) { // of options; by std::stod() if they are no numbers
    std::cerr << "benchmark_quantization: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
