// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_PATCH_TRIANGULATION_2_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_PATCH_TRIANGULATION_2_H

#include <CGAL/Anisotropic_Delaunay_triangulation_traits_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_point_2.h>
#include <CGAL/Parametric_surface_mesher/internal/triangulation/Verdict.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_2.h>
#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The index of a vertex that has none in the mesh: the largest one that fits.
const std::size_t no_vertex_index = std::uint32_t(-1);

// A vertex with its spacing (paper, eq. 2) and its index in the mesh. Boundary vertices come first and have the index that the
// division gave them.
template <class Traits, class Base = Triangulation_vertex_base_2<Traits>>
class Patch_vertex_base_2
  : public Base
{
  double m_spacing = 0;
  std::uint32_t m_index = 0;
  bool m_is_on_boundary = false, m_is_on_cut = false, m_is_settled = false, m_is_kept = false;

public:
  using Base::Base;

  template <class Tds>
  struct Rebind_TDS
  {
    typedef Patch_vertex_base_2<Traits, typename Base::template Rebind_TDS<Tds>::Other> Other;
  };

  double spacing() const { return m_spacing; }
  void set_spacing(double spacing) { m_spacing = spacing; }
  std::size_t index() const { return m_index; }
  void set_index(std::size_t index)
  {
    CGAL_assertion(index <= no_vertex_index); // the output refuses meshes with more points
    m_index = std::uint32_t(index);
  }
  bool is_on_boundary() const { return m_is_on_boundary; }
  void set_on_boundary(bool b) { m_is_on_boundary = b; }

  // Whether the vertex is on the boundary of a part only because a large patch was cut there.
  bool is_on_cut() const { return m_is_on_cut; }
  void set_on_cut(bool b) { m_is_on_cut = b; }

  // Whether smoothing need not visit the vertex as long as its star does not change.
  bool is_settled() const { return m_is_settled; }
  void set_settled(bool b) { m_is_settled = b; }

  // Whether smoothing must not move the vertex.
  bool is_kept() const { return m_is_kept; }
  void set_kept(bool b) { m_is_kept = b; }
};

// Where a face stands as seen from the advancing front, which asks for its size alone.
enum class Front_mark : std::uint8_t
{
  NONE,
  DONE,
  ACTIVE, // not done, and not on the front
  QUEUED, // on the front
  GIVEN_UP
};

template <class Traits, class Base = Constrained_triangulation_face_base_2<Traits>>
class alignas(64) Patch_face_base_2
  : public Base
{
  static const std::uint32_t no_number = std::uint32_t(-1);

  struct Bits
  {
    std::uint16_t close_edges : 3; // one each
    std::uint16_t is_waiting : 1;
    std::uint16_t front_mark : 3;
    std::uint16_t nesting_level : 4;
  };

  // In an order without gaps, from the byte on that constraints leave: so a face is no longer than a line of the processor's
  // cache. That is 64 bytes; with the next multiple of it meshing would take a tenth more time.
  Bits m_bits = {0, 0, 0, 0};
  Verdict m_verdict;
  std::uint32_t m_stamp = 0, m_number = no_number;

public:
  static constexpr int largest_nesting_level = 15;

  using Base::Base;

  template <class Tds>
  struct Rebind_TDS
  {
    typedef Patch_face_base_2<Traits, typename Base::template Rebind_TDS<Tds>::Other> Other;
  };

  // The number of boundary loops around the face: none outside of all, one in the domain, two in its holes.
  // \pre it is not above the largest one
  int nesting_level() const { return m_bits.nesting_level; }
  void set_nesting_level(int level) { m_bits.nesting_level = std::uint16_t(level) & largest_nesting_level; }
  bool is_in_domain() const { return m_bits.nesting_level == 1; }
  void set_in_domain(bool b) { m_bits.nesting_level = b ? 1 : 0; }

  // Changes whenever the face does, so that a queue entry can tell whether it is out of date.
  std::uint32_t stamp() const { return m_stamp; }

  // Whether the face has its index in the mesh; it gets one when the final triangulation is collected.
  bool has_number() const { return m_number != no_number; }
  std::size_t number() const { return m_number; }
  void set_number(std::size_t number) { m_number = std::uint32_t(number); }

  // Where the front has left it.
  Front_mark front_mark() const { return Front_mark(m_bits.front_mark); }
  void set_front_mark(Front_mark mark) { m_bits.front_mark = std::uint16_t(mark) & 7; }

  Verdict verdict() const { return m_verdict; }
  void set_verdict(Verdict verdict) { m_verdict = verdict; }
  void refuse(Unmet_cause cause) { m_verdict.refuse(cause); }

  // Whether the face waits to be repaired.
  bool is_waiting() const { return m_bits.is_waiting != 0; }
  void set_waiting(bool b) { m_bits.is_waiting = b; }

  // Whether edge `i` is known to be close to the surface.
  bool is_close(int i) const { return (m_bits.close_edges >> i & 1) != 0; }
  void set_close(int i) { m_bits.close_edges = std::uint16_t(m_bits.close_edges | 1 << i) & 7; }

  // Must be called when vertices of the face have changed.
  void touch()
  {
    ++m_stamp;
    m_bits.close_edges = 0;
    set_front_mark(Front_mark::NONE);
    m_verdict = Verdict();
  }

  // Must be called when vertex `i` alone has changed. The edge opposite to it is as close to the surface as before.
  void touch_by_vertex(int i)
  {
    const int close_edge = m_bits.close_edges & 1 << i;
    touch();
    m_bits.close_edges = std::uint16_t(close_edge) & 7;
  }
};

template <class Kernel>
struct Patch_triangulation_types
{
  typedef Anisotropic_Delaunay_triangulation_traits_2<Kernel, Patch_point_2<Kernel>> Traits;
  typedef Triangulation_data_structure_2<Patch_vertex_base_2<Traits>, Patch_face_base_2<Traits>> Tds;
  typedef Constrained_Delaunay_triangulation_2<Traits, Tds, No_constraint_intersection_requiring_constructions_tag>
    Triangulation;
};

template <class Kernel>
using Patch_triangulation_2 = typename Patch_triangulation_types<Kernel>::Triangulation;

// Whether a face has an edge without length in space: between two copies of the point of a collapsed side.
template <class Face_handle>
bool is_collapsed(Face_handle face)
{
  for(int i = 0; i < 3; ++i) {
    const auto v = face->vertex((i + 1) % 3), w = face->vertex((i + 2) % 3);
    if(v->is_on_boundary() && w->is_on_boundary() && v->index() == w->index())
      return true;
  }
  return false;
}

// Whether a constrained edge is on the boundary of the patch, and not on a cut.
template <class Face_handle>
bool is_on_true_boundary(Face_handle face, int i)
{
  return !face->vertex((i + 1) % 3)->is_on_cut() && !face->vertex((i + 2) % 3)->is_on_cut();
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_PATCH_TRIANGULATION_2_H
