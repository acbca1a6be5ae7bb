// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_QUANTIZATION_H
#define CGAL_QUAD_LAYOUTS_QUANTIZATION_H

#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Quad_layouts {

/*!
\ingroup PkgQuadLayoutsClasses

is a quantization of a T-mesh: a non-negative integer length per arc, such that opposite sides of
every patch are equally long, and the evidence of how good it is.
*/
struct Quantization
{
  enum Status {
    OPTIMAL,   ///< proven, by `bound`, to have the least objective
    FEASIBLE,  ///< valid, but a better one may exist: the search ended at its limit of time or work
    INFEASIBLE ///< no valid quantization was found; `arc_length` is empty
  };

  std::vector<int> arc_length; ///< per arc of the T-mesh
  Status status = INFEASIBLE;
  std::string reason;   ///< why, and where, there is no valid quantization, as far as this is known
  double objective = 0; ///< Equation (9) of \cgalCite{lck-sqlrs-21}
  /// no valid quantization is below this, unless the shortest path between two close singularities
  /// gets longer than 10 there, the `Q` of Equation (3), and longer than in this one
  double bound = -(std::numeric_limits<double>::infinity)();
  int violated = 0; ///< number of soft constraints that had to be given up
  int variables = 0, constraints = 0, indicators = 0; ///< size of the integer program
  int rounds = 0; ///< how often validity cuts were added and the program solved again

  /// returns the relative distance of `objective` from `bound`, 0 if optimal.
  double gap() const
  {
    if (status == OPTIMAL || !(objective > bound))
      return 0;
    return objective > 0 ? (objective - bound) / objective : 0;
  }
};

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_QUANTIZATION_H
