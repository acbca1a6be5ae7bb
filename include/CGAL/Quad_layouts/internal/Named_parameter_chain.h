// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_NAMED_PARAMETER_CHAIN_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_NAMED_PARAMETER_CHAIN_H

#include <CGAL/Named_function_parameters.h>

// The names that CGAL 6 adds for volume meshes, by macros of their own, are not offered in our
// packs.
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z)

namespace CGAL {
namespace Quad_layouts {

// the tags of CGAL and ours; of two alike, ours is meant
namespace internal_np {

using namespace CGAL::internal_np;

enum extension_t { extension };
// clang-format off
#define CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(name) enum name##_t { name };
// clang-format on
#include <CGAL/Quad_layouts/internal/parameters_interface.h>
#undef CGAL_QUAD_LAYOUTS_NAMED_PARAMETER

} // namespace internal_np

namespace internal {

// A pack of named parameters is a chain: it holds one value and inherits the pack before it.
// `Chain` marks the pack before it as one that a pack of ours follows: it selects the
// specialization below, and so CGAL's functions see our packs as what they know,
// `Named_function_parameters<T, Tag, Base>`.
template <class Previous>
struct Chain : Previous
{
  explicit Chain(const Previous& previous) : Previous(previous) {}
};

// returns `previous` followed by `value` under the name of `Tag`
template <class Tag, class Value, class Previous>
auto append(const Previous& previous, const Value& value)
{
  using Link = Chain<Previous>;
  return Named_function_parameters<Value, Tag, Link>(value, Link(previous));
}

// CGAL's names as members of `Pack`. They are inherited by the pack, so that its own names hide
// those that a later CGAL may have too; they do not come beside the inherited pack, where each name
// would be ambiguous.
template <class Pack, class T, class Tag, class Link>
struct Members_of_CGAL : CGAL::internal_np::Named_params_impl<T, Tag, Link>
{
  using CGAL::internal_np::Named_params_impl<T, Tag, Link>::Named_params_impl;

#define CGAL_add_named_parameter(X, Y, Z)                                        \
  template <class Value>                                                         \
  auto Z(const Value& value) const                                               \
  {                                                                              \
    return append<CGAL::internal_np::X>(static_cast<const Pack&>(*this), value); \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
};

} // namespace internal
} // namespace Quad_layouts

// A pack whose predecessor is marked: it offers CGAL's names and ours.
template <class T, class Tag, class Previous>
struct Named_function_parameters<T, Tag, Quad_layouts::internal::Chain<Previous>>
  : Quad_layouts::internal::Members_of_CGAL<
        Named_function_parameters<T, Tag, Quad_layouts::internal::Chain<Previous>>, T, Tag,
        Quad_layouts::internal::Chain<Previous>>
{
  using self = Named_function_parameters;
  using Link = Quad_layouts::internal::Chain<Previous>;
  using Members = Quad_layouts::internal::Members_of_CGAL<self, T, Tag, Link>;
  using Members::Members;
  // the name by which the look-up of a value goes from pack to pack
  using base = internal_np::Named_params_impl<T, Tag, Link>;
  // the mark by which CGAL 6 recognizes packs
  using CGAL_Named_function_parameters_class = int;

#define CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(name)                                               \
  template <class Value>                                                                      \
  auto name(const Value& value) const                                                         \
  {                                                                                           \
    return Quad_layouts::internal::append<Quad_layouts::internal_np::name##_t>(*this, value); \
  }
#include <CGAL/Quad_layouts/internal/parameters_interface.h>
#undef CGAL_QUAD_LAYOUTS_NAMED_PARAMETER
};

namespace Quad_layouts {
namespace parameters {

// CGAL's names as free functions that begin a pack of ours; in a namespace of their own, so that
// ours hide them
namespace of_CGAL {

#define CGAL_add_named_parameter(X, Y, Z)                                                     \
  template <class Value>                                                                      \
  auto Z(const Value& value)                                                                  \
  {                                                                                           \
    return internal::append<CGAL::internal_np::X>(CGAL::parameters::default_values(), value); \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter

} // namespace of_CGAL

using namespace of_CGAL;

#define CGAL_QUAD_LAYOUTS_NAMED_PARAMETER(name)                                                \
  template <class Value>                                                                       \
  auto name(const Value& value)                                                                \
  {                                                                                            \
    return internal::append<internal_np::name##_t>(CGAL::parameters::default_values(), value); \
  }
#include <CGAL/Quad_layouts/internal/parameters_interface.h>
#undef CGAL_QUAD_LAYOUTS_NAMED_PARAMETER

} // namespace parameters
} // namespace Quad_layouts
} // namespace CGAL

#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
#undef CGAL_add_extra_named_parameter_with_compatibility

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_NAMED_PARAMETER_CHAIN_H
