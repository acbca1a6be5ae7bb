// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_EXCEPTIONS_H
#define CGAL_QUAD_LAYOUTS_EXCEPTIONS_H

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Quad_layouts {

/// \addtogroup PkgQuadLayoutsExceptions
/// @{

/// is the base of everything that this package throws on purpose.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// says that the input mesh cannot be used; the derived class says why, the message says where.
class Invalid_mesh : public Error
{
public:
  using Error::Error;
};

/// says that the mesh has no face.
class Empty_mesh : public Invalid_mesh
{
public:
  using Invalid_mesh::Invalid_mesh;
};

/// says that a face does not have three sides.
class Non_triangle_face : public Invalid_mesh
{
public:
  using Invalid_mesh::Invalid_mesh;
};

/// says that a face has no area or repeats a vertex.
class Degenerate_face : public Invalid_mesh
{
public:
  using Invalid_mesh::Invalid_mesh;
};

/// says that two faces have the same three vertices.
class Duplicate_face : public Invalid_mesh
{
public:
  using Invalid_mesh::Invalid_mesh;
};

/// says that two vertices are joined by several edges, or that more than two faces meet in an edge.
class Non_manifold_edge : public Invalid_mesh
{
public:
  using Invalid_mesh::Invalid_mesh;
};

/// says that several fans of faces meet in one vertex.
class Non_manifold_vertex : public Invalid_mesh
{
public:
  using Invalid_mesh::Invalid_mesh;
};

/// says that a coordinate is infinite or not a number.
class Non_finite_point : public Invalid_mesh
{
public:
  using Invalid_mesh::Invalid_mesh;
};

/// says that a mesh is so large or so small that computations in double precision overflow or
/// vanish.
class Unsuitable_scale : public Invalid_mesh
{
public:
  using Invalid_mesh::Invalid_mesh;
};

/// says that given coordinates of corners are no seamless parametrization, and names an edge.
class Invalid_parametrization : public Error
{
public:
  using Error::Error;
};

/// says that the value of a named parameter is outside its range.
class Invalid_parameter : public Error
{
public:
  using Error::Error;
};

/// says that a stage could not deliver a valid result; the message names the stage and the place.
class Stage_failure : public Error
{
public:
  using Error::Error;
};

/// says that no quantization of the T-mesh can do what a named parameter asks for; the message
/// names the singularities.
class Unsatisfiable_demand : public Error
{
public:
  using Error::Error;
};

/// says that the work was not done within `maximum_running_time`; the message names the stage.
class Time_limit_exceeded : public Error
{
public:
  using Error::Error;
};

/// says that a file or stream cannot be read; the message says why and in which line.
class Invalid_file : public Error
{
public:
  using Error::Error;
};

/// says that the visitor asked to stop.
class Cancelled : public Error
{
public:
  using Error::Error;
};

/// @}

} // namespace Quad_layouts
} // namespace CGAL

#endif // CGAL_QUAD_LAYOUTS_EXCEPTIONS_H
