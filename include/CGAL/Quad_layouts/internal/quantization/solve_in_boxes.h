// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_SOLVE_IN_BOXES_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_SOLVE_IN_BOXES_H

#include <CGAL/Quad_layouts/internal/quantization/solve_in_box.h>

#include <atomic>
#include <chrono>
#include <future>
#include <vector>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Looks for the best solution in each box, all at the same time, each in a thread of its own; a
// single one in this thread. Only this thread asks `effort.stop`, which is the user's.
template <class Traits>
std::vector<Box_solution> solve_in_boxes(const Reduced_program& program,
                                         const std::vector<Box>& boxes,
                                         const std::vector<int>& known, const Search_effort& effort)
{
  if (boxes.size() == 1)
    return {solve_in_box<Traits>(program, boxes.front(), known, effort)};

  std::atomic<bool> is_stopped = false;
  Search_effort shared = effort;
  shared.stop = [&] { return is_stopped.load(); };
  std::vector<std::future<Box_solution>> searches;
  // whatever is thrown here: the destructors of `searches` wait, but not for long
  struct Stop_at_exit
  {
    std::atomic<bool>& flag;
    ~Stop_at_exit() { flag = true; }
  } stop_at_exit{is_stopped};
  for (const Box& box : boxes)
    searches.push_back(std::async(
        std::launch::async, [&] { return solve_in_box<Traits>(program, box, known, shared); }));

  constexpr std::chrono::milliseconds pause(10);
  std::vector<Box_solution> result;
  for (auto& search : searches) {
    while (search.wait_for(pause) != std::future_status::ready)
      if (effort.stop())
        is_stopped = true;
    result.push_back(search.get());
  }
  return result;
}

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_SOLVE_IN_BOXES_H
