// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_MONITOR_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_MONITOR_H

#include <CGAL/Quad_layouts/exceptions.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// What long work sees of the user's visitor and time limit: a place to report progress to, and to
// be stopped from. It is not a template, so that the algorithms behind the public functions need
// not be.
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
    std::function<void(const char* reason)> changed_route;
    Go_on go_on;
  };

  Monitor() = default;
  explicit Monitor(Callbacks callbacks) : m_callbacks(std::move(callbacks)) {}
  Monitor(Go_on go_on, Report report)
  {
    m_callbacks.go_on = std::move(go_on);
    m_callbacks.progress = std::move(report);
  }

  // returns this monitor for work that has to end within `seconds` from now
  Monitor limited_to(double seconds) const
  {
    constexpr double endless = 1e9; // more than what a clock can count would overflow
    Monitor result = *this;
    if (seconds < endless)
      result.m_end = (std::min)(m_end, Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                          std::chrono::duration<double>(seconds)));
    return result;
  }

  // True if the user wants the work to end. Who has said so is not asked again.
  bool stopped() const
  {
    *m_is_stopped = *m_is_stopped || (m_callbacks.go_on && !m_callbacks.go_on());
    return *m_is_stopped;
  }

  // true if the time is over
  bool is_late() const { return m_end != (Clock::time_point::max)() && Clock::now() > m_end; }

  // for work that has a result at any time: says if there is time for more of `stage`, and throws
  // `Cancelled` if the user wants the work to end
  bool has_time(const char* stage) const
  {
    if (stopped())
      throw Cancelled(std::string(stage) + ": cancelled by the visitor");
    return !is_late();
  }

  // throws if the user wants the work to end or the time is over
  void check(const char* stage) const
  {
    if (!has_time(stage))
      throw Time_limit_exceeded(std::string(stage) + ": not done within the time limit");
  }

  // reports that `fraction` (0 to 1) of `stage` is done
  void tell(const char* stage, double fraction) const
  {
    if (m_callbacks.progress)
      m_callbacks.progress(stage, fraction);
  }

  // reports that `fraction` (0 to 1) of `stage` is done, and checks whether it is to end
  void report(const char* stage, double fraction) const
  {
    tell(stage, fraction);
    check(stage);
  }

  // reports that the integer program has a better solution or bound than before
  void improved(double objective, double bound, double seconds) const
  {
    if (m_callbacks.improved)
      m_callbacks.improved(objective, bound, seconds);
  }

  // reports that another route than the one asked for is taken
  void changed_route(const char* reason) const
  {
    if (m_callbacks.changed_route)
      m_callbacks.changed_route(reason);
  }

  // returns what `work` returns, having told the visitor when the work, called `stage`, begins and
  // when and after how long it ends; does not begin it if the user wants the work to end
  template <class Work>
  auto run(const char* stage, Work&& work) const
  {
    Real_timer timer;
    timer.start();
    has_time(stage);
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
  using Clock = std::chrono::steady_clock;

  Callbacks m_callbacks;
  std::shared_ptr<bool> m_is_stopped = std::make_shared<bool>(false); // the same for copies
  Clock::time_point m_end = (Clock::time_point::max)();
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_MONITOR_H
