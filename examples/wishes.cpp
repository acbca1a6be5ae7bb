// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

// Asks for more than a simple layout: few patches on one side of a model, two singularities that do
// not merge, and two that an edge of the layout joins.

#include <CGAL/Quad_layouts/arc_weights.h>
#include <CGAL/Quad_layouts/compute_cross_field.h>
#include <CGAL/Quad_layouts/extract_quad_layout.h>
#include <CGAL/Quad_layouts/quantize.h>
#include <CGAL/Quad_layouts/trace_motorcycle_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace QL = CGAL::Quad_layouts;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// two singularities, by their vertices in the mesh
using Vertices = std::pair<int, int>;

void report(const std::string& what, const QL::Quad_layout& layout)
{
  std::cout << what << ": " << layout.number_of_patches << " patches, "
            << layout.number_of_irregular_vertices() << " irregular vertices\n";
}

template <class NamedParameters>
QL::Quad_layout layout_of(const QL::T_mesh& t_mesh, const NamedParameters& np)
{
  const QL::Quantization quantization = QL::quantize(t_mesh, np);
  if (quantization.status == QL::Quantization::INFEASIBLE)
    throw QL::Error("no layout found");
  return QL::extract_quad_layout(t_mesh, quantization);
}

// two singularities that fall onto one vertex of the layout
Vertices merged_pair(const QL::T_mesh& t_mesh, const QL::Quad_layout& layout)
{
  std::map<int, int> first; // per vertex of the layout, a vertex of the mesh
  for (int n = 0; n < t_mesh.number_of_vertices(); ++n)
    if (t_mesh.index(n) != 0) {
      const int v = t_mesh.surface_vertex(n);
      const auto inserted = first.emplace(layout.node_vertex[n], v);
      if (!inserted.second)
        return {inserted.first->second, v};
    }
  throw QL::Error("all singularities are separate");
}

// the singularity of a trace, and that of the trace at which it stops
Vertices neighbors(const QL::T_mesh& t_mesh)
{
  const auto& arcs = t_mesh.traces.front().arcs;
  const auto& visits = t_mesh.node_visits[t_mesh.target(2 * arcs.back())];
  const auto vertex = [&](const QL::T_mesh::Visit& visit) {
    return t_mesh.surface_vertex(t_mesh.traces[visit.trace].start);
  };
  return {vertex(visits.at(0)), vertex(visits.at(1))};
}

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bear.off");
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << "cannot read " << file << '\n';
    return EXIT_FAILURE;
  }
  try {
    const QL::T_mesh t_mesh = QL::trace_motorcycle_graph(QL::compute_cross_field(mesh));
    const QL::Quad_layout plain = layout_of(t_mesh, QL::parameters::default_values());
    report("as simple as possible", plain);

    // above the plane y = 0, lengths count ten times
    auto weight = mesh.add_property_map<Mesh::Face_index, double>("f:weight", 1.).first;
    for (Mesh::Face_index f : faces(mesh))
      if (mesh.point(source(halfedge(f, mesh), mesh)).y() > 0)
        weight[f] = 10;
    const std::vector<double> weights = QL::arc_weights(t_mesh, mesh, weight);
    const auto np = QL::parameters::arc_weight_map(CGAL::make_property_map(weights));
    report("with dear patches above", layout_of(t_mesh, np));

    const Vertices merged = merged_pair(t_mesh, plain);
    report("without a merge",
           layout_of(t_mesh, QL::parameters::forbidden_merges(std::vector<Vertices>{merged})));

    const Vertices near = neighbors(t_mesh);
    std::cout << "vertices " << near.first << " and " << near.second << ": ";
    report("with an edge",
           layout_of(t_mesh, QL::parameters::forced_connections(std::vector<Vertices>{near})));
  } catch (const QL::Unsatisfiable_demand& error) {
    std::cerr << "this cannot be had: " << error.what() << '\n';
  } catch (const QL::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
