// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_PARAMETERS_H
#define CGAL_QUAD_LAYOUTS_PARAMETERS_H

#include <CGAL/Quad_layouts/internal/Named_parameter_chain.h>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsFunctions

contains the named parameters of this package, together with all of CGAL's, so that both can be
chained in any order:

\code
namespace QL = CGAL::Quad_layouts;
QL::quad_remesh(mesh, quads, QL::parameters::maximum_deviation(20).maximum_displacement(3)
                                            .vertex_point_map(points));
\endcode

Such a pack is accepted by every function of CGAL, and the functions of this package accept those
that begin with a name of `CGAL::parameters`.
*/
namespace parameters {

using CGAL::parameters::choose_parameter;
using CGAL::parameters::Default_named_parameters;
using CGAL::parameters::default_values;
using CGAL::parameters::get_parameter;
using CGAL::parameters::get_parameter_reference;
using CGAL::parameters::is_default_parameter;

/// continues a pack that begins with names of `CGAL::parameters`, so that names of this package can
/// follow.
template <class NamedParameters>
auto extend(const NamedParameters& np)
{
  return internal::append<internal_np::extension_t>(np, true);
}

} // namespace parameters
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_PARAMETERS_H
