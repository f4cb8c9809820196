// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_STAMPED_FACE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_STAMPED_FACE_H

#include <cstdint>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// An entry for a queue of faces, which can tell whether the face has changed since the entry was made.
template <class Face_handle>
struct Stamped_face
{
  Face_handle face;
  std::uint32_t stamp;

  explicit Stamped_face(Face_handle f) : face(f), stamp(f->stamp()) {}

  bool is_up_to_date() const { return face->stamp() == stamp; }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_STAMPED_FACE_H
