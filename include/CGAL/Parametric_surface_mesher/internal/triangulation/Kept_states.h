// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_KEPT_STATES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_KEPT_STATES_H

#include <CGAL/Parametric_surface_mesher/internal/triangulation/Patch_triangulation_2.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The verdicts on faces, to be given back where a change is undone.
template <class Face_handle>
class Kept_states
{
  std::vector<std::pair<Face_handle, Verdict>> m_states;

public:
  template <class Faces>
  void keep(const Faces& faces)
  {
    m_states.clear();
    for(Face_handle face : faces)
      m_states.emplace_back(face, face->verdict());
  }

  void give_back() const
  {
    for(const auto& kept : m_states)
      kept.first->set_verdict(kept.second);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_TRIANGULATION_KEPT_STATES_H
