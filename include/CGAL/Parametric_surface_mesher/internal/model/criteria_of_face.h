// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_CRITERIA_OF_FACE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_CRITERIA_OF_FACE_H

#include <algorithm>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Lowers the maximum edge length, and the minimum edge length if it would be larger.
template <class Criteria>
void limit_max_edge(double length, Criteria& criteria)
{
  if(!(length > 0) || length >= criteria.max_edge())
    return;
  criteria.set_max_edge(length);
  criteria.set_min_edge((std::min)(criteria.min_edge(), length));
}

// The criteria with the sizes that a face of a model prescribes.
template <class Criteria, class Face>
Criteria criteria_of_face(const Criteria& criteria, const Face& face)
{
  Criteria result = criteria;
  limit_max_edge(face.max_edge, result);
  if(face.min_edge > 0)
    result.set_min_edge((std::min)(result.min_edge(), face.min_edge));
  if(face.sizing_field)
    result.set_sizing_field(face.sizing_field);
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_CRITERIA_OF_FACE_H
