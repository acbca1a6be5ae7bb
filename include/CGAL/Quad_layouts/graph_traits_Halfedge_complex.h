// Copyright (c) 2026 The Quad_layouts authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Quad_layouts authors

#ifndef CGAL_QUAD_LAYOUTS_GRAPH_TRAITS_HALFEDGE_COMPLEX_H
#define CGAL_QUAD_LAYOUTS_GRAPH_TRAITS_HALFEDGE_COMPLEX_H

// This header makes `Halfedge_complex` and the classes derived from it models of
// `HalfedgeListGraph` and `FaceListGraph`, so that the functions of CGAL and of the Boost Graph
// Library can read them. Descriptors know their number: `v.id()` is what the members of the classes
// take. The graphs can have loops and parallel edges; functions that cannot cope with them, or with
// faces that touch themselves, must be kept to layouts without.

#include <CGAL/Quad_layouts/internal/complex_descriptors.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Quad_layouts {

class T_mesh;
class Quad_layout;

} // namespace Quad_layouts
} // namespace CGAL

namespace boost {

template <>
struct graph_traits<CGAL::Quad_layouts::Halfedge_complex>
{
private:
  using Complex = CGAL::Quad_layouts::Halfedge_complex;

  struct Traversal_category : virtual bidirectional_graph_tag,
                              virtual vertex_list_graph_tag,
                              virtual edge_list_graph_tag,
                              virtual adjacency_graph_tag
  {};

public:
  using vertex_descriptor = CGAL::Quad_layouts::internal::Complex_vertex;
  using halfedge_descriptor = CGAL::Quad_layouts::internal::Complex_halfedge;
  using edge_descriptor = CGAL::Quad_layouts::internal::Complex_edge;
  using face_descriptor = CGAL::Quad_layouts::internal::Complex_face;

  using vertex_iterator = CGAL::Quad_layouts::internal::Complex_iterator<vertex_descriptor>;
  using halfedge_iterator = CGAL::Quad_layouts::internal::Complex_iterator<halfedge_descriptor>;
  using edge_iterator = CGAL::Quad_layouts::internal::Complex_iterator<edge_descriptor>;
  using face_iterator = CGAL::Quad_layouts::internal::Complex_iterator<face_descriptor>;
  using in_edge_iterator = CGAL::In_edge_iterator<Complex>;
  using out_edge_iterator = CGAL::Out_edge_iterator<Complex>;
  using adjacency_iterator = CGAL::Vertex_around_target_iterator<Complex>;

  using vertices_size_type = int;
  using halfedges_size_type = int;
  using edges_size_type = int;
  using faces_size_type = int;
  using degree_size_type = int;

  using directed_category = undirected_tag;
  using edge_parallel_category = allow_parallel_edge_tag;
  using traversal_category = Traversal_category;

  static vertex_descriptor null_vertex() { return vertex_descriptor(); }
  static halfedge_descriptor null_halfedge() { return halfedge_descriptor(); }
  static face_descriptor null_face() { return face_descriptor(); }
};

template <>
struct graph_traits<CGAL::Quad_layouts::T_mesh> : graph_traits<CGAL::Quad_layouts::Halfedge_complex>
{
};

template <>
struct graph_traits<CGAL::Quad_layouts::Quad_layout>
  : graph_traits<CGAL::Quad_layouts::Halfedge_complex>
{
};

} // namespace boost

namespace CGAL {
namespace Quad_layouts {
namespace internal {

using Complex_traits = boost::graph_traits<Halfedge_complex>;

// returns the elements numbered 0 to n - 1
template <class Descriptor>
Iterator_range<Complex_iterator<Descriptor>> complex_range(int n)
{
  using Iterator = Complex_iterator<Descriptor>;
  return make_range(Iterator(boost::counting_iterator<int>(0), {}),
                    Iterator(boost::counting_iterator<int>(n), {}));
}

} // namespace internal

/// \cond SKIP_IN_MANUAL

// HalfedgeGraph and FaceGraph

inline internal::Complex_vertex source(internal::Complex_halfedge h, const Halfedge_complex& g)
{
  return internal::Complex_vertex(g.source(h.id()));
}

inline internal::Complex_vertex target(internal::Complex_halfedge h, const Halfedge_complex& g)
{
  return internal::Complex_vertex(g.target(h.id()));
}

inline internal::Complex_halfedge next(internal::Complex_halfedge h, const Halfedge_complex& g)
{
  return internal::Complex_halfedge(g.next(h.id()));
}

inline internal::Complex_halfedge prev(internal::Complex_halfedge h, const Halfedge_complex& g)
{
  return internal::Complex_halfedge(g.prev(h.id()));
}

inline internal::Complex_halfedge opposite(internal::Complex_halfedge h, const Halfedge_complex& g)
{
  return internal::Complex_halfedge(g.opposite(h.id()));
}

inline internal::Complex_edge edge(internal::Complex_halfedge h, const Halfedge_complex&)
{
  return internal::Complex_edge(h);
}

inline internal::Complex_face face(internal::Complex_halfedge h, const Halfedge_complex& g)
{
  return internal::Complex_face(g.face(h.id()));
}

// A graph gives a halfedge that ends in `v`, a complex one that begins there.
inline internal::Complex_halfedge halfedge(internal::Complex_vertex v, const Halfedge_complex& g)
{
  const int h = g.halfedge_from(v.id());
  return h < 0 ? internal::Complex_halfedge() : internal::Complex_halfedge(g.opposite(h));
}

inline internal::Complex_halfedge halfedge(internal::Complex_edge e, const Halfedge_complex&)
{
  return e.halfedge();
}

inline internal::Complex_halfedge halfedge(internal::Complex_face f, const Halfedge_complex& g)
{
  return internal::Complex_halfedge(g.halfedge_of(f.id()));
}

inline std::pair<internal::Complex_halfedge, bool> halfedge(internal::Complex_vertex u,
                                                            internal::Complex_vertex v,
                                                            const Halfedge_complex& g)
{
  for (const auto h : CGAL::halfedges_around_target(v, g))
    if (source(h, g) == u)
      return {h, true};
  return {internal::Complex_halfedge(), false};
}

// the lists of elements

inline int num_vertices(const Halfedge_complex& g)
{
  return g.number_of_vertices();
}

inline int num_halfedges(const Halfedge_complex& g)
{
  return g.number_of_halfedges();
}

inline int num_edges(const Halfedge_complex& g)
{
  return g.number_of_edges();
}

inline int num_faces(const Halfedge_complex& g)
{
  return g.number_of_faces();
}

inline auto vertices(const Halfedge_complex& g)
{
  return internal::complex_range<internal::Complex_vertex>(num_vertices(g));
}

inline auto halfedges(const Halfedge_complex& g)
{
  return internal::complex_range<internal::Complex_halfedge>(num_halfedges(g));
}

inline auto edges(const Halfedge_complex& g)
{
  return internal::complex_range<internal::Complex_edge>(num_edges(g));
}

inline auto faces(const Halfedge_complex& g)
{
  return internal::complex_range<internal::Complex_face>(num_faces(g));
}

// BidirectionalGraph and AdjacencyGraph

inline internal::Complex_vertex source(internal::Complex_edge e, const Halfedge_complex& g)
{
  return source(e.halfedge(), g);
}

inline internal::Complex_vertex target(internal::Complex_edge e, const Halfedge_complex& g)
{
  return target(e.halfedge(), g);
}

inline std::pair<internal::Complex_edge, bool> edge(internal::Complex_vertex u,
                                                    internal::Complex_vertex v,
                                                    const Halfedge_complex& g)
{
  const auto [h, exists] = halfedge(u, v, g);
  return {internal::Complex_edge(h), exists};
}

inline int degree(internal::Complex_vertex v, const Halfedge_complex& g)
{
  return int(CGAL::halfedges_around_target(v, g).size());
}

inline int degree(internal::Complex_face f, const Halfedge_complex& g)
{
  return int(CGAL::halfedges_around_face(halfedge(f, g), g).size());
}

inline int out_degree(internal::Complex_vertex v, const Halfedge_complex& g)
{
  return degree(v, g);
}

inline int in_degree(internal::Complex_vertex v, const Halfedge_complex& g)
{
  return degree(v, g);
}

inline auto out_edges(internal::Complex_vertex v, const Halfedge_complex& g)
{
  using Iterator = internal::Complex_traits::out_edge_iterator;
  return make_range(Iterator(halfedge(v, g), g), Iterator(halfedge(v, g), g, 1));
}

inline auto in_edges(internal::Complex_vertex v, const Halfedge_complex& g)
{
  using Iterator = internal::Complex_traits::in_edge_iterator;
  return make_range(Iterator(halfedge(v, g), g), Iterator(halfedge(v, g), g, 1));
}

inline auto adjacent_vertices(internal::Complex_vertex v, const Halfedge_complex& g)
{
  return CGAL::vertices_around_target(v, g);
}

// property maps

inline auto get(boost::vertex_index_t, const Halfedge_complex&)
{
  return internal::Complex_index_map<internal::Complex_vertex>();
}

inline auto get(boost::halfedge_index_t, const Halfedge_complex&)
{
  return internal::Complex_index_map<internal::Complex_halfedge>();
}

inline auto get(boost::edge_index_t, const Halfedge_complex&)
{
  return internal::Complex_index_map<internal::Complex_edge>();
}

inline auto get(boost::face_index_t, const Halfedge_complex&)
{
  return internal::Complex_index_map<internal::Complex_face>();
}

inline auto get(boost::vertex_point_t, const Halfedge_complex& g)
{
  return internal::Complex_point_map{&g};
}

template <class Tag, class Key>
auto get(Tag tag, const Halfedge_complex& g, const Key& key)
{
  return get(get(tag, g), key);
}

/// \endcond

namespace internal {

// says if the maps of `Tag` are those above
template <class Tag>
using Is_complex_tag = Boolean_tag<
    std::is_same_v<Tag, boost::vertex_index_t> || std::is_same_v<Tag, boost::halfedge_index_t> ||
    std::is_same_v<Tag, boost::edge_index_t> || std::is_same_v<Tag, boost::face_index_t> ||
    std::is_same_v<Tag, boost::vertex_point_t>>;

template <class Graph, class Tag>
constexpr bool has_complex_map = Is_complex_tag<Tag>::value &&
                                 (std::is_same_v<Graph, Halfedge_complex> ||
                                  std::is_same_v<Graph, T_mesh> ||
                                  std::is_same_v<Graph, Quad_layout>);

} // namespace internal
} // namespace Quad_layouts

template <class Tag>
struct graph_has_property<Quad_layouts::Halfedge_complex, Tag>
  : Quad_layouts::internal::Is_complex_tag<Tag>
{
};

template <class Tag>
struct graph_has_property<Quad_layouts::T_mesh, Tag> : Quad_layouts::internal::Is_complex_tag<Tag>
{
};

template <class Tag>
struct graph_has_property<Quad_layouts::Quad_layout, Tag>
  : Quad_layouts::internal::Is_complex_tag<Tag>
{
};

} // namespace CGAL

namespace boost {

template <class Complex, class Tag>
struct property_map<Complex, Tag,
                    std::enable_if_t<CGAL::Quad_layouts::internal::has_complex_map<Complex, Tag>>>
{
  using type = decltype(get(Tag(), std::declval<const CGAL::Quad_layouts::Halfedge_complex&>()));
  using const_type = type;
};

} // namespace boost

#endif // CGAL_QUAD_LAYOUTS_GRAPH_TRAITS_HALFEDGE_COMPLEX_H
