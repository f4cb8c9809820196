// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_PIECE_TREE_3_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_PIECE_TREE_3_H

#include <CGAL/AABB_tree.h>
#if __has_include(<CGAL/AABB_traits_3.h>)
#  include <CGAL/AABB_traits_3.h>
#else
#  include <CGAL/AABB_traits.h>
#endif

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// A segment, triangle or tetrahedron with its number, for CGAL's trees of boxes.
template <class Kernel, class Piece>
class Numbered_piece_3
{
  Piece m_piece;
  std::size_t m_number;

public:
  typedef typename Kernel::Point_3 Point;
  typedef Piece Datum;
  typedef std::size_t Id;

  Numbered_piece_3(const Piece& piece, std::size_t number) : m_piece(piece), m_number(number) {}

  Id id() const { return m_number; }
  const Datum& datum() const { return m_piece; }
  Point reference_point() const { return m_piece.vertex(0); }
};

#if __has_include(<CGAL/AABB_traits_3.h>)
template <class Kernel, class Piece>
using Piece_tree_3 = AABB_tree<AABB_traits_3<Kernel, Numbered_piece_3<Kernel, Piece>>>;
#else
template <class Kernel, class Piece>
using Piece_tree_3 = AABB_tree<AABB_traits<Kernel, Numbered_piece_3<Kernel, Piece>>>;
#endif

template <class Tree, class Piece>
void add_pieces(const std::vector<Piece>& pieces, Tree& tree)
{
  for(std::size_t i = 0; i < pieces.size(); ++i)
    tree.insert(typename Tree::Primitive(pieces[i], i));
}

// Stops at the first piece that a query intersects. any_intersected_primitive() of CGAL's tree finds the same piece and returns a copy of an
// optional, of which g++ warns: it would read a number that may never have been written.
template <class Tree>
class Any_piece_traversal
{
  const typename Tree::AABB_traits& m_traits;
  bool m_is_found = false;
  std::size_t m_number = 0;

public:
  explicit Any_piece_traversal(const Tree& tree) : m_traits(tree.traits()) {}

  bool is_found() const { return m_is_found; }
  std::size_t number() const { return m_number; }

  // What Tree::traversal() asks for.
  bool go_further() const { return !m_is_found; }

  template <class Query>
  void intersection(const Query& query, const typename Tree::Primitive& piece)
  {
    if(m_traits.do_intersect_object()(query, piece)) {
      m_is_found = true;
      m_number = piece.id();
    }
  }

  template <class Query, class Node>
  bool do_intersect(const Query& query, const Node& node) const
  {
    return m_traits.do_intersect_object()(query, node.bbox());
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SIZING_PIECE_TREE_3_H
