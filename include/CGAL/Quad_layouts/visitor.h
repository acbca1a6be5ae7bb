// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_VISITOR_H
#define CGAL_QUAD_LAYOUTS_VISITOR_H

#include <CGAL/Quad_layouts/internal/Monitor.h>
#include <CGAL/Quad_layouts/internal/running_time_limit.h>
#include <CGAL/Quad_layouts/parameters.h>

#include <functional>
#include <memory>
#include <utility>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsClasses

does nothing, at every moment at which the functions of this package call a visitor. Derive from it
to follow the work, or to stop it, and pass the visitor by the named parameter `visitor`, with
`std::ref` if it has a state to look at afterwards.

\cgalModels{QuadLayoutsVisitor}
*/
struct Default_visitor
{
  /// is called before the stage called `name`.
  void before_stage(const char* /* name */) {}
  /// is called after the stage called `name`, which took `seconds`.
  void after_stage(const char* /* name */, double /* seconds */) {}
  /// is called now and then when `fraction` (0 to 1) of a stage is done.
  void progress(const char* /* name */, double /* fraction */) {}
  /// is called when the integer program has a better solution or a better bound, `seconds` after
  /// its start.
  void improved(double /* objective */, double /* bound */, double /* seconds */) {}
  /// is called when there is a `reason` to go on by another `Layout_route` than the one asked for.
  void changed_route(const char* /* reason */) {}
  /// says whether the work shall go on; if not, it ends with the exception `Cancelled`.
  bool go_on() { return true; }
};

namespace internal {

// returns a monitor that calls `visitor` and shares in owning it
template <class Visitor>
Monitor make_monitor(const std::shared_ptr<Visitor>& visitor)
{
  Monitor::Callbacks callbacks;
  callbacks.before_stage = [visitor](const char* name) { visitor->before_stage(name); };
  callbacks.after_stage = [visitor](const char* name, double s) { visitor->after_stage(name, s); };
  callbacks.progress = [visitor](const char* name, double x) { visitor->progress(name, x); };
  callbacks.improved = [visitor](double objective, double bound, double seconds) {
    visitor->improved(objective, bound, seconds);
  };
  callbacks.changed_route = [visitor](const char* reason) { visitor->changed_route(reason); };
  callbacks.go_on = [visitor] { return visitor->go_on(); };
  return Monitor(std::move(callbacks));
}

// The next three tell how a visitor is stored in a pack: not at all, as a reference, as a copy.

inline Monitor monitor_of_visitor(const internal_np::Param_not_found&)
{
  return Monitor();
}

template <class Visitor>
Monitor monitor_of_visitor(const std::reference_wrapper<Visitor>& visitor)
{
  return make_monitor(std::shared_ptr<Visitor>(std::shared_ptr<void>(), &visitor.get()));
}

template <class Visitor>
Monitor monitor_of_visitor(const Visitor& visitor)
{
  return make_monitor(std::make_shared<Visitor>(visitor));
}

// returns a monitor that calls the visitor in `np`, and does nothing if there is none
template <class NamedParameters>
Monitor visitor_of(const NamedParameters& np)
{
  return monitor_of_visitor(parameters::get_parameter(np, internal_np::visitor));
}

// returns a monitor that calls the visitor in `np`, and ends the work at the time limit in `np`
template <class NamedParameters>
Monitor monitor_from(const NamedParameters& np)
{
  return visitor_of(np).limited_to(running_time_limit(np));
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_VISITOR_H
