// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <CGAL/Quad_layouts/Quad_layout.h>
#include <CGAL/Quad_layouts/parameters.h>

int main()
{
  const CGAL::Quad_layouts::Quad_layout layout;
  return layout.number_of_irregular_vertices();
}
