// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_NEIGHBOURHOOD_SCHEDULE_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_NEIGHBOURHOOD_SCHEDULE_H

#include <algorithm>
#include <array>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// Says of which kind the next neighbourhood is, and how large. All kinds get the same share of the
// work, where searches that succeed count little: cheap and successful kinds come often. The
// neighbourhoods of a kind grow while they are solved to optimality without a gain. See Ropke and
// Pisinger 2006, whose search is adaptive, too.
class Neighbourhood_schedule
{
public:
  // Free are the variables near a singularity, then also the dual loops through these, of which
  // perhaps only what the relaxation uses; the same near a dual loop; or everything, but less than
  // some dual loops must be enough.
  enum Kind {
    REGION,
    SINGULARITY,
    SINGULARITY_ON_SUPPORT,
    LOOP,
    LOOP_ON_SUPPORT,
    WITHOUT_LOOPS,
    NUMBER_OF_KINDS
  };

  // `singularities` bounds the sizes; as much as one search among all `variables` is worked in
  // regions before anything else is tried
  Neighbourhood_schedule(int singularities, int variables)
    : m_most((std::max)(double(singularities), least))
  {
    m_work.fill(variables);
    m_work[REGION] = 0;
  }

  Kind next() const
  {
    return Kind(std::min_element(m_work.begin(), m_work.end()) - m_work.begin());
  }

  int size(Kind kind) const { return int(m_size[kind]); }

  // A search in a neighbourhood with `variables` free ones begins. Until it ends it counts as one
  // that is solved, so that others can begin beside it.
  void begin(Kind kind, int variables) { m_work[kind] += variables; }

  void end(Kind kind, int variables, bool was_solved, bool improved)
  {
    constexpr double factor = 1.25;
    constexpr double work_of_success = 0.1, work_at_limit = 10; // per variable, about
    m_work[kind] += variables * ((improved ? work_of_success : was_solved ? 1 : work_at_limit) - 1);
    if (!improved)
      m_size[kind] = was_solved ? (std::min)(m_size[kind] * factor, m_most)
                                : (std::max)(m_size[kind] / factor, least);
  }

private:
  static constexpr double least = 2;

  double m_most;
  std::array<double, NUMBER_OF_KINDS> m_size{32, 16, 16, 16, 16, 2}, m_work;
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_QUANTIZATION_NEIGHBOURHOOD_SCHEDULE_H
