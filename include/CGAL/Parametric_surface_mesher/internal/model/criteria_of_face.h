// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_CRITERIA_OF_FACE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_CRITERIA_OF_FACE_H

#include <CGAL/Parametric_surface_mesher/internal/sizing/Size_sources_3.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/least_length.h>

#include <algorithm>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

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

// Wanted edge lengths become shorter towards inner points that ask for it.
template <class Criteria, class Face>
void set_sizes_of_inner_points(const Face& face, Criteria& criteria)
{
  typedef Size_sources_3<std::decay_t<decltype(face.surface.point(0., 0.))>> Sources;
  std::vector<typename Sources::Source> sources;
  for(const auto& point : face.inner_points)
    if(point.max_edge > 0 && point.max_edge < criteria.max_edge()) {
      sources.push_back({face.surface.point(point.parameters.x(), point.parameters.y()), point.max_edge});
      criteria.set_min_edge((std::min)(criteria.min_edge(), point.max_edge / 2)); // the spacing is never below 1.4 times of that
    }
  if(sources.empty())
    return;
  criteria.set_sizing_field([before = criteria.sizing_field(), max_edge = criteria.max_edge(), surface = face.surface,
                             sources = std::make_shared<const Sources>(std::move(sources))](double u, double v) {
    const double length = (std::min)((*sources)(surface.point(u, v)), max_edge);
    return before ? least_length(length, (*before)(u, v)) : length;
  });
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
  set_sizes_of_inner_points(face, result);
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_CRITERIA_OF_FACE_H
