// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_OTHER_SIDES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_OTHER_SIDES_H

#include <CGAL/Parametric_surface_mesher/internal/model/Bad_faces.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Which faces of a model are the other sides of which, as far as both are good.
class Other_sides
{
public:
  static constexpr std::size_t none = std::size_t(-1);

private:
  std::vector<std::size_t> m_fronts, m_backs; // by face

public:
  template <class Model>
  Other_sides(const Model& model, const Bad_faces& bad_faces)
    : m_fronts(model.faces().size(), std::size_t(none)), m_backs(m_fronts)
  {
    for(std::size_t back = 0; back < m_fronts.size(); ++back) {
      const std::size_t front = model.faces()[back].other_side_of;
      if(front == Model::no_face || bad_faces.contains(front) || bad_faces.contains(back))
        continue;
      m_fronts[back] = front;
      m_backs[front] = back;
    }
  }

  // The face whose triangles a face takes, turned over, or `none`.
  std::size_t front(std::size_t back) const { return m_fronts[back]; }

  // The face that takes the triangles of a face, or `none`.
  std::size_t back(std::size_t front) const { return m_backs[front]; }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_OTHER_SIDES_H
