// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_IMPORT_CHARTS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_IMPORT_CHARTS_H

#include <CGAL/Quad_layouts/Seamless_parametrization.h>
#include <CGAL/Quad_layouts/exceptions.h>
#include <CGAL/Quad_layouts/internal/parametrization/Cut_graph.h>
#include <CGAL/Quad_layouts/internal/parametrization/Given_charts.h>
#include <CGAL/Quad_layouts/internal/parametrization/Seam_constraints.h>
#include <CGAL/Quad_layouts/internal/parametrization/exact_parametrization.h>
#include <CGAL/Quad_layouts/internal/surface/Triangle_surface.h>
#include <CGAL/Quad_layouts/internal/surface/separate_fixed_curves.h>

#include <Eigen/Core>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// the coordinates of vertex v of `divided` in the chart of face f of the whole surface, in which,
// or on an edge of which, it lies
inline Point2 coordinates_in_face(const Given_charts& whole, const Triangle_surface& divided, int f,
                                  int v)
{
  for (int h = 3 * f; h < 3 * f + 3; ++h)
    if (whole.surface().source(h) == v)
      return whole.corner(h);
  Point2 sum = Point2::Zero();
  for (const int parent : divided.parents(v))
    sum += coordinates_in_face(whole, divided, f, parent);
  return sum / double(divided.parents(v).size());
}

// the charts of the surface whose faces are divided between fixed curves
inline Given_charts charts_between_fixed_curves(const Given_charts& whole)
{
  const auto divided = std::make_shared<const Triangle_surface>(
      separate_fixed_curves(whole.surface()));
  std::vector<Point2> corners;
  for (int h = 0; h < divided->number_of_halfedges(); ++h)
    corners.push_back(coordinates_in_face(
        whole, *divided, divided->origin(Triangle_surface::face(h)), divided->source(h)));
  return Given_charts(divided, std::move(corners));
}

// For each face the change from its given chart to the chart that it has in a cut graph of the
// field of the charts, in which those beside uncut edges are one.
inline std::vector<Given_charts::Transition> joint_charts(const Given_charts& charts,
                                                          const Cut_graph& cut)
{
  using Surface = Triangle_surface;
  const Surface& surface = charts.surface();
  std::vector<Given_charts::Transition> result(surface.number_of_faces());
  std::vector<char> is_reached(surface.number_of_faces(), 0);
  std::vector<int> reached = cut.first_faces();
  for (const int f : reached) {
    result[f].translation = -charts.corner(3 * f);
    is_reached[f] = 1;
  }
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (int h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h) {
      if (cut.is_cut(h))
        continue;
      const int g = surface.opposite(h), f = Surface::face(g);
      if (is_reached[f])
        continue;
      result[f] = result[reached[i]].after(charts.transition(g));
      is_reached[f] = 1;
      reached.push_back(f);
    }
  return result;
}

// the seamless parametrization nearby, in which 1 stands for an edge length on the surface
inline Seamless_parametrization import_charts(const Given_charts& charts, double edge_length)
{
  const Cross_field field = charts.field();
  const Cut_graph cut(field);
  const Seam_constraints seams(charts.surface(), cut);
  const auto joint = joint_charts(charts, cut);
  Eigen::VectorXd x(seams.number_of_unknowns());
  for (int h = 0; h < charts.surface().number_of_halfedges(); ++h) {
    const Point2 p = joint[Triangle_surface::face(h)](charts.corner(h));
    for (const int i : {0, 1})
      x[seams.unknown(h, i)] = p[i];
  }
  seams.find_translations(x);
  return exact_parametrization(field, cut, seams, x, edge_length);
}

// the length on the surface that 1 in the map stands for, if the map keeps the area
inline double edge_length_of(const Given_charts& charts)
{
  double on_surface = 0, in_map = 0;
  for (int f = 0; f < charts.surface().number_of_faces(); ++f) {
    on_surface += 2 * charts.surface().area(f);
    in_map += charts.area(f);
  }
  if (!(in_map > 0))
    throw Invalid_parametrization("the triangles together have no positive area in the map");
  return std::sqrt(on_surface / in_map);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_PARAMETRIZATION_IMPORT_CHARTS_H
