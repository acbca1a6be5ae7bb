// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Feeds files that libFuzzer makes to the way of the command from its reader to the layout. The
// first byte of an input says which format the rest is in, and how it is to be treated.

#include "../../examples/quad_layout/input.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include <unistd.h>

namespace QL = CGAL::Quad_layouts;

namespace {

// an input, as a file that lives as long as this
class Input_file
{
public:
  Input_file(const std::string& extension, const std::uint8_t* data, std::size_t size)
    : m_name(std::filesystem::temp_directory_path() /
             ("fuzz_quad_layout_" + std::to_string(getpid()) + extension))
  {
    std::ofstream(m_name, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), std::streamsize(size));
  }
  Input_file(const Input_file&) = delete;
  Input_file& operator=(const Input_file&) = delete;
  ~Input_file() { std::filesystem::remove(m_name); }

  std::string name() const { return m_name.string(); }

private:
  std::filesystem::path m_name;
};

// what the first byte of an input says
struct Treatment
{
  explicit Treatment(std::uint8_t byte)
    : extension(std::array<const char*, 4>{".off", ".obj", ".ply", ".stl"}[byte & 3]),
      repair(byte & 4), keep_features(byte & 8), alpha(byte & 16 ? 45 : 15),
      displacement(byte & 32 ? 0 : 2)
  {
  }

  std::string extension;
  bool repair, keep_features;
  double alpha, displacement; // as the command's options
};

void make_layout(Mesh& mesh, const Treatment& treatment)
{
  constexpr double seconds = 1;
  const auto is_feature =
      mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  if (treatment.keep_features)
    CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 40, is_feature);
  const auto np = QL::parameters::maximum_deviation(treatment.alpha)
                      .maximum_displacement(treatment.displacement)
                      .maximum_running_time(seconds);
  const QL::Cross_field field = QL::compute_cross_field(mesh,
                                                        np.edge_is_constrained_map(is_feature));
  const QL::T_mesh t_mesh = QL::trace_motorcycle_graph(field, np);
  const QL::Quantization quantization = QL::quantize(t_mesh, np);
  if (quantization.status != QL::Quantization::INFEASIBLE)
    QL::extract_quad_layout(t_mesh, quantization);
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  std::clog.rdbuf(nullptr); // readers of CGAL tell there what they do not understand
  std::cerr.rdbuf(nullptr);
  return 0;
}

// Whatever is in the file, there is a layout or an exception of this package that says why not.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::size_t most_faces = 500; // to be quick
  if (size == 0)
    return 0;
  const Treatment treatment(data[0]);
  const Input_file file(treatment.extension, data + 1, size - 1);
  try {
    Mesh mesh = read_mesh(file.name(), treatment.repair);
    if (mesh.number_of_faces() <= most_faces)
      make_layout(mesh, treatment);
  } catch (const QL::Error&) {
  }
  return 0;
}
