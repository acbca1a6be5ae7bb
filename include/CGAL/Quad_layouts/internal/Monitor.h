// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_MONITOR_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_MONITOR_H

#include <CGAL/Quad_layouts/exceptions.h>

#include <CGAL/Real_timer.h>

#include <functional>
#include <string>
#include <type_traits>
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

  // The members of the concept `QuadLayoutsVisitor`; what is empty is not called.
  struct Callbacks
  {
    std::function<void(const char* stage)> before_stage;
    std::function<void(const char* stage, double seconds)> after_stage;
    Report progress;
    std::function<void(double objective, double bound, double seconds)> improved;
    Go_on go_on;
  };

  Monitor() = default;
  explicit Monitor(Callbacks callbacks) : m_callbacks(std::move(callbacks)) {}
  Monitor(Go_on go_on, Report report)
  {
    m_callbacks.go_on = std::move(go_on);
    m_callbacks.progress = std::move(report);
  }

  // true if the user wants the work to end
  bool stopped() const { return m_callbacks.go_on && !m_callbacks.go_on(); }

  // throws `Cancelled` if the user wants the work to end
  void check(const char* stage) const
  {
    if (stopped())
      throw Cancelled(std::string(stage) + ": cancelled by the visitor");
  }

  // reports that `fraction` (0 to 1) of `stage` is done, and checks for a wish to stop
  void report(const char* stage, double fraction) const
  {
    if (m_callbacks.progress)
      m_callbacks.progress(stage, fraction);
    check(stage);
  }

  // reports that the integer program has a better solution or bound than before
  void improved(double objective, double bound, double seconds) const
  {
    if (m_callbacks.improved)
      m_callbacks.improved(objective, bound, seconds);
  }

  // returns what `work` returns, having told the visitor when the work, called `stage`, begins and
  // when and after how long it ends
  template <class Work>
  auto run(const char* stage, Work&& work) const
  {
    Real_timer timer;
    timer.start();
    if (m_callbacks.before_stage)
      m_callbacks.before_stage(stage);
    const auto finish = [&] {
      if (m_callbacks.after_stage)
        m_callbacks.after_stage(stage, timer.time());
    };
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      finish();
    } else {
      auto result = work();
      finish();
      return result;
    }
  }

private:
  Callbacks m_callbacks;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_MONITOR_H
