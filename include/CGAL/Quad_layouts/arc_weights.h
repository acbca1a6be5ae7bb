// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_ARC_WEIGHTS_H
#define CGAL_QUAD_LAYOUTS_ARC_WEIGHTS_H

#include <CGAL/Quad_layouts/T_mesh.h>
#include <CGAL/Quad_layouts/internal/quantization/Quantization_program.h>
#include <CGAL/Quad_layouts/internal/quantization/weighted_lengths.h>
#include <CGAL/Quad_layouts/internal/require_parameter.h>

#include <CGAL/assertions.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsFunctions

turns weights of the faces of a mesh into weights of the arcs of its T-mesh, for the parameter
`arc_weight_map` of `quantize()`.

With these weights, the objective of a quantization is the total length of all dual loops, where a
length within a face counts as many times as the weight of the face says; along an edge the mean of
the two faces counts. So layouts have fewer
patches where weights are large, and more where they are small. `quad_layout()` and `quad_remesh()`
call this function if they are given a `face_weight_map`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam FaceWeightMap a model of `ReadablePropertyMap` with the face descriptor of `TriangleMesh` as
        key type and `double` as value type

\param t_mesh a T-mesh of `tm`
\param tm the surface
\param weights positive weights; 1 changes nothing

\return a weight per arc

\pre `t_mesh` was traced in a field of `tm`.

\throw Invalid_parameter if a weight is not positive.

The time is linear in the number of edges that arcs cross.
*/
template <class TriangleMesh, class FaceWeightMap>
std::vector<double> arc_weights(const T_mesh& t_mesh, const TriangleMesh& tm,
                                const FaceWeightMap& weights)
{
  using namespace internal;
  std::vector<double> face_weight;
  for (const auto f : faces(tm)) {
    face_weight.push_back(get(weights, f));
    require_positive("face_weight_map", face_weight.back());
  }
  CGAL_precondition(int(face_weight.size()) == t_mesh.surface().original().number_of_faces());

  const Weights_along_arcs along_arcs(t_mesh, face_weight);
  std::vector<double> result = quantization_program::weights(t_mesh, along_arcs.lengths());
  const auto unweighted = quantization_program::weights(t_mesh, t_mesh.arc_length);
  for (std::size_t a = 0; a < result.size(); ++a)
    result[a] = unweighted[a] > 0 ? result[a] / unweighted[a] : 1;
  return result;
}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_ARC_WEIGHTS_H
