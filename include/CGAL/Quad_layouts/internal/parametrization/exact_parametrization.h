// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_EXACT_PARAMETRIZATION_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_EXACT_PARAMETRIZATION_H

#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/parametrization/Cut_graph.h>
#include <CGAL/Quad_layouts/internal/parametrization/Seam_constraints.h>
#include <CGAL/Quad_layouts/internal/parametrization/check_parametrization.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// A power of two so small that coordinates, of which `largest` is the largest, take as many bits as
// exact arithmetic leaves: lines hundreds of times as long have lengths that are exact as `double`,
// and sums of products of these fit into 128 bits.
inline double unit_for(double largest)
{
  constexpr int bits = 44;
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1., exponent - bits);
}

// The unknowns as integers that satisfy all relations: the free ones are rounded to multiples of
// the common denominator, and the others follow.
inline std::vector<std::int64_t> rounded_unknowns(const Seam_constraints& seams,
                                                  const Eigen::VectorXd& x, double unit)
{
  constexpr std::int64_t largest_denominator = std::int64_t(1) << 16; // leaves 28 bits of precision
  const Linear_relations& relations = seams.relations();
  const std::int64_t denominator = relations.common_denominator();
  if (denominator > largest_denominator)
    throw Stage_failure("seamless parametrization: the seams demand the denominator " +
                        std::to_string(denominator));
  std::vector<std::int64_t> result(seams.number_of_unknowns(), 0);
  for (int i = 0; i < seams.number_of_unknowns(); ++i)
    if (relations.is_free(i))
      result[i] = denominator * std::int64_t(std::llround(x[i] / (unit * double(denominator))));
  for (int i = 0; i < seams.number_of_unknowns(); ++i)
    if (!relations.is_free(i))
      for (const auto& term : relations.combination(i))
        result[i] += result[term.first] / term.second.denominator() * term.second.numerator();
  return result;
}

// the parametrization with rounded coordinates, without the counts of what is wrong
inline Seamless_parametrization rounded_parametrization(const Cross_field& field,
                                                        const Cut_graph& cut,
                                                        const Seam_constraints& seams,
                                                        const Eigen::VectorXd& x,
                                                        double edge_length)
{
  const Triangle_surface& surface = field.surface();
  Seamless_parametrization result;
  result.surface_pointer = field.surface_pointer();
  result.edge_length = edge_length;
  result.unit = unit_for(x.cwiseAbs().maxCoeff() * edge_length);
  const std::vector<std::int64_t> rounded = rounded_unknowns(seams, x, result.unit / edge_length);
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    result.corner_coordinates.emplace_back(rounded[seams.unknown(h, 0)],
                                           rounded[seams.unknown(h, 1)]);
  result.halfedge_transition.resize(surface.number_of_halfedges());
  for (int h = 0; h < surface.number_of_halfedges(); ++h)
    if (!surface.is_border(h)) {
      Seamless_parametrization::Transition& t = result.halfedge_transition[h];
      t.quarter_turns = cut.quarter_turns(h);
      const int same_vertex = Triangle_surface::next(surface.opposite(h));
      t.translation = result.coordinates(same_vertex) - t(result.coordinates(h));
    }
  for (int v = 0; v < surface.number_of_vertices(); ++v)
    result.vertex_index.push_back(field.index(v));
  return result;
}

// the parametrization with coordinates near to x, which are in target edge lengths, in integers,
// verified, with the counts of what is not locally injective
inline Seamless_parametrization exact_parametrization(const Cross_field& field,
                                                      const Cut_graph& cut,
                                                      const Seam_constraints& seams,
                                                      const Eigen::VectorXd& x, double edge_length)
{
  Seamless_parametrization result = rounded_parametrization(field, cut, seams, x, edge_length);
  const std::string error = inexactness(result);
  if (!error.empty())
    throw Stage_failure("seamless parametrization: " + error);
  result.inverted = number_of_inverted_faces(result);
  result.wrong_winding = int(wrong_windings(result).size());
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_EXACT_PARAMETRIZATION_H
