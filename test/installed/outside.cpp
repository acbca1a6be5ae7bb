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

int main()
{
#ifdef CGAL_USE_CBC
  CGAL::Quad_layouts::CBC_mixed_integer_program_traits<double> program;
  program.create_variable(CGAL::Variable<double>::INTEGER, 0, 1);
  program.create_objective();
  if (!program.solve())
    return 1;
#endif
  const CGAL::Quad_layouts::Quad_layout layout;
  return layout.number_of_irregular_vertices();
}
