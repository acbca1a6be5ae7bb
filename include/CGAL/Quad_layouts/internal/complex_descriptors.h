// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_INTERNAL_COMPLEX_DESCRIPTORS_H
#define CGAL_QUAD_LAYOUTS_INTERNAL_COMPLEX_DESCRIPTORS_H

#include <CGAL/Quad_layouts/Halfedge_complex.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <ostream>

namespace CGAL {
namespace Quad_layouts {
namespace internal {

// The number of an element of a complex, as a type of its own for each kind of element.
template <class Kind>
class Complex_descriptor
{
public:
  Complex_descriptor() = default;
  explicit Complex_descriptor(int id) : m_id(id) {}

  // the number of the element, -1 if it is none
  int id() const { return m_id; }

  friend bool operator==(Complex_descriptor a, Complex_descriptor b) { return a.m_id == b.m_id; }
  friend bool operator!=(Complex_descriptor a, Complex_descriptor b) { return a.m_id != b.m_id; }
  friend bool operator<(Complex_descriptor a, Complex_descriptor b) { return a.m_id < b.m_id; }
  friend std::size_t hash_value(Complex_descriptor a) { return std::size_t(a.m_id); }
  friend std::ostream& operator<<(std::ostream& out, Complex_descriptor a) { return out << a.m_id; }

private:
  int m_id = -1;
};

using Complex_vertex = Complex_descriptor<struct Vertex_kind>;
using Complex_halfedge = Complex_descriptor<struct Halfedge_kind>;
using Complex_face = Complex_descriptor<struct Face_kind>;

// An edge together with one of its halfedges, which says from where to where it is seen: the edges
// around a vertex are seen from that vertex. Seen from either end, it is the same edge.
class Complex_edge
{
public:
  Complex_edge() = default;
  explicit Complex_edge(int id) : m_halfedge(2 * id) {}
  explicit Complex_edge(Complex_halfedge halfedge) : m_halfedge(halfedge) {}

  int id() const { return m_halfedge.id() < 0 ? -1 : Halfedge_complex::edge(m_halfedge.id()); }
  Complex_halfedge halfedge() const { return m_halfedge; }

  friend bool operator==(Complex_edge a, Complex_edge b) { return a.id() == b.id(); }
  friend bool operator!=(Complex_edge a, Complex_edge b) { return a.id() != b.id(); }
  friend bool operator<(Complex_edge a, Complex_edge b) { return a.id() < b.id(); }
  friend std::size_t hash_value(Complex_edge a) { return std::size_t(a.id()); }
  friend std::ostream& operator<<(std::ostream& out, Complex_edge a) { return out << a.id(); }

private:
  Complex_halfedge m_halfedge;
};

template <class Descriptor>
struct Make_descriptor
{
  Descriptor operator()(int id) const { return Descriptor(id); }
};

// runs over all elements of a kind
template <class Descriptor>
using Complex_iterator =
    boost::transform_iterator<Make_descriptor<Descriptor>, boost::counting_iterator<int>>;

// maps an element to its number
template <class Descriptor>
struct Complex_index_map
{
  using key_type = Descriptor;
  using value_type = std::size_t;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  value_type operator[](const key_type& key) const { return value_type(key.id()); }
  friend value_type get(const Complex_index_map& map, const key_type& key) { return map[key]; }
};

// maps a vertex to its point
struct Complex_point_map
{
  using key_type = Complex_vertex;
  using value_type = Exact_predicates_inexact_constructions_kernel::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const Halfedge_complex* complex = nullptr;

  value_type operator[](const key_type& key) const
  {
    const Halfedge_complex::Point& p = complex->point(key.id());
    return value_type(p.x(), p.y(), p.z());
  }
  friend value_type get(const Complex_point_map& map, const key_type& key) { return map[key]; }
};

} // namespace internal
} // namespace Quad_layouts
} // namespace CGAL

namespace std {

template <class Kind>
struct hash<CGAL::Quad_layouts::internal::Complex_descriptor<Kind>>
{
  std::size_t operator()(CGAL::Quad_layouts::internal::Complex_descriptor<Kind> a) const
  {
    return hash_value(a);
  }
};

template <>
struct hash<CGAL::Quad_layouts::internal::Complex_edge>
{
  std::size_t operator()(CGAL::Quad_layouts::internal::Complex_edge a) const
  {
    return hash_value(a);
  }
};

} // namespace std

#endif // CGAL_QUAD_LAYOUTS_INTERNAL_COMPLEX_DESCRIPTORS_H
