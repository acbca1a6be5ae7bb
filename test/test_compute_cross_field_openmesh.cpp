// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#include <boost/test/unit_test.hpp>

// OpenMesh appends points without a value to its vectors, and g++ sees it when it inlines.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "generated_meshes.h"

#include <CGAL/Quad_layouts/compute_cross_field.h>

#include <CGAL/boost/graph/copy_face_graph.h>

#include <tuple>

BOOST_AUTO_TEST_SUITE(test_compute_cross_field_openmesh)

namespace QL = CGAL::Quad_layouts;

struct Double_traits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

using Meshes = std::tuple<OpenMesh::PolyMesh_ArrayKernelT<Double_traits>,
                          OpenMesh::TriMesh_ArrayKernelT<Double_traits>>;

BOOST_AUTO_TEST_CASE_TEMPLATE(same_field_as_on_a_surface_mesh, OpenMesh_mesh, Meshes)
{
  const auto mesh = generated::noisy(generated::torus(24, 12), 0.05, 4);
  OpenMesh_mesh copy;
  CGAL::copy_face_graph(mesh, copy);
  const QL::Cross_field expected = QL::compute_cross_field(mesh);
  const QL::Cross_field field = QL::compute_cross_field(copy);
  BOOST_TEST(field.index_sum() == 0);
  BOOST_TEST(field.number_of_singularities() == expected.number_of_singularities());
}

BOOST_AUTO_TEST_SUITE_END()
