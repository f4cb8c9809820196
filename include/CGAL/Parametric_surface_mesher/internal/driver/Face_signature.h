// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FACE_SIGNATURE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FACE_SIGNATURE_H

#include <CGAL/Kernel/global_functions_2.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Meshed_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/model/criteria_of_face.h>

#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What the functions of a face give where its vertices and triangles are. A face with the same boundary and the same values of the criteria
// (see `Meshed_faces`) would be meshed in the same way once more if these are the same, too.
template <class Kernel>
class Face_signature
{
  typedef typename Kernel::Point_2 Point_2;

  std::vector<double> m_sizes;
  std::vector<typename Kernel::Point_3> m_points;

public:
  // `criteria`: with all sizes
  // \pre the triangles have their inner and corner points in the domain
  template <class ModelFace, class Criteria>
  Face_signature(const typename Meshed_faces<Kernel>::Face& meshed, const ModelFace& face, const Criteria& criteria)
  {
    for(const auto& part : meshed.meshed.patch.parts)
      for(const Point_2& uv : part.mesh.domain_points)
        m_points.push_back(face.surface.point(uv.x(), uv.y()));
    const auto sizing_field = criteria_of_face(criteria, face).sizing_field();
    if(sizing_field)
      append_sizes(meshed, *sizing_field);
  }

  friend bool operator==(const Face_signature& a, const Face_signature& b)
  {
    return a.m_sizes == b.m_sizes && a.m_points == b.m_points;
  }

private:
  template <class SizingField>
  void append_sizes(const typename Meshed_faces<Kernel>::Face& meshed, const SizingField& size)
  {
    const auto append = [&](const Point_2& uv) { m_sizes.push_back(size(uv.x(), uv.y())); };
    for(const auto& loop : meshed.loops)
      for(const auto& vertex : loop)
        append(vertex.domain_point);
    for(const auto& part : meshed.meshed.patch.parts) {
      for(const Point_2& uv : part.mesh.domain_points)
        append(uv);
      for(const auto& corners : part.mesh.corner_points)
        append(centroid(corners[0], corners[1], corners[2]));
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_FACE_SIGNATURE_H
