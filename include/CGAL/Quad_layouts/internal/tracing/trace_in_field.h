// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_FIELD_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_FIELD_H

#include <CGAL/Quad_layouts/Cross_field.h>
#include <CGAL/Quad_layouts/internal/tracing/Field_chords.h>
#include <CGAL/Quad_layouts/internal/tracing/repair_labels.h>
#include <CGAL/Quad_layouts/internal/tracing/trace_motorcycles.h>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// traces the extended motorcycle graph of a field; `tangent` is that of the maximum deviation,
// `displacement` a length
inline T_mesh trace_in_field(const Cross_field& field, double tangent, double displacement,
                             const Monitor& monitor)
{
  return trace_motorcycles<Field_chords>(field.surface_pointer(), field, make_labels(field),
                                         tangent, displacement, monitor);
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_TRACING_TRACE_IN_FIELD_H
