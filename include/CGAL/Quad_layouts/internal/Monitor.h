// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_MONITOR_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_MONITOR_H

#include <CGAL/Quad_layouts/exceptions.h>

#include <functional>
#include <string>
#include <utility>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// What long work sees of the user's visitor: a place to report progress to, and to be stopped from.
// It is not a template, so that the algorithms behind the public functions need not be.
class Monitor
{
public:
  using Go_on = std::function<bool()>;
  using Report = std::function<void(const char* stage, double fraction)>;

  Monitor() = default;
  Monitor(Go_on go_on, Report report) : m_go_on(std::move(go_on)), m_report(std::move(report)) {}

  // true if the user wants the work to end
  bool stopped() const { return m_go_on && !m_go_on(); }

  // throws `Cancelled` if the user wants the work to end
  void check(const char* stage) const
  {
    if (stopped())
      throw Cancelled(std::string(stage) + ": cancelled by the visitor");
  }

  // reports that `fraction` (0 to 1) of `stage` is done, and checks for a wish to stop
  void report(const char* stage, double fraction) const
  {
    if (m_report)
      m_report(stage, fraction);
    check(stage);
  }

private:
  Go_on m_go_on;
  Report m_report;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_MONITOR_H
