// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/parameters.h>
#ifdef CGAL_USE_CBC
#include <CGAL/Quad_layouts/CBC_mixed_integer_program_traits.h>
#endif
#ifdef CGAL_USE_HIGHS
#include <CGAL/Quad_layouts/HiGHS_mixed_integer_program_traits.h>
#endif

namespace QL = CGAL::Quad_layouts;

template <class Traits>
[[maybe_unused]] bool solves()
{
  Traits program;
  program.create_variable(CGAL::Variable<double>::INTEGER, 0, 1);
  program.create_objective();
  return program.solve();
}

int main()
{
#ifdef CGAL_USE_CBC
  if (!solves<QL::CBC_mixed_integer_program_traits<double>>())
    return 1;
#endif
#ifdef CGAL_USE_HIGHS
  if (!solves<QL::HiGHS_mixed_integer_program_traits<double>>())
    return 1;
#endif
  const QL::Quad_layout layout;
  return layout.number_of_irregular_vertices();
}
