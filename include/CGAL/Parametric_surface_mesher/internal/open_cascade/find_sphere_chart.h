// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FIND_SPHERE_CHART_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FIND_SPHERE_CHART_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_frame_3.h>
#include <CGAL/number_type_config.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Stereographic_sphere_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/convert_curves.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/convert_surface.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Sphere.hxx>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Finds the point of a sphere from which a face is projected: the farthest one from the face. A face with a seam keeps the parameters
// of the file, because the seam bounds the influence of a finely divided boundary, which otherwise would make the whole face fine;
// unless its boundary runs through a pole, where these parameters are singular.
class Sphere_chart_finder
{
  // 200 points on a sphere are about 0.25 radians apart.
  static constexpr int number_of_candidates = 200, samples_on_edge = 16;
  // In radians: the point must be so far from the face, as the projection is singular there; and a boundary so close to a pole
  // runs through it.
  static constexpr double least_distance = 0.15, pole_distance = 1e-3;

  TopoDS_Face m_face; // with forward orientation
  BRepAdaptor_Surface m_surface;
  std::vector<gp_Dir> m_boundary; // directions from the centre
  bool m_has_seam = false, m_touches_pole = false;

public:
  explicit Sphere_chart_finder(const TopoDS_Face& face) : m_face(face), m_surface(face, false) {}

  template <class Kernel>
  std::optional<Stereographic_sphere_3<Kernel>> find()
  {
    if(m_surface.GetType() != GeomAbs_Sphere || !sample_boundary())
      return std::nullopt;
    BRepTopAdaptor_FClass2d classifier(m_face, BRep_Tool::Tolerance(m_face));
    const gp_Ax3 frame = m_surface.Sphere().Position();
    gp_Dir best;
    double farthest = least_distance;
    for(int i = 0; i < number_of_candidates; ++i) {
      const gp_Pnt2d uv = candidate(i);
      const gp_Dir direction = this->direction(uv.X(), uv.Y());
      const double distance = distance_from_boundary(direction);
      if(distance > farthest && classifier.Perform(uv) == TopAbs_OUT) {
        farthest = distance;
        best = direction;
      }
    }
    if(!(farthest > least_distance))
      return std::nullopt;
    gp_Ax3 result(frame.Location(), best); // right-handed, so that the normal points inward
    if(frame.Direct())
      result.YReverse();
    return Stereographic_sphere_3<Kernel>(to_frame<Kernel>(result), m_surface.Sphere().Radius());
  }

private:
  // The candidates are spread evenly over the sphere, along a spiral.
  static gp_Pnt2d candidate(int i)
  {
    const double golden_angle = 2.399963229728653, full_turn = 2 * CGAL_PI;
    return gp_Pnt2d(std::fmod(i * golden_angle, full_turn), std::asin(1 - (2 * i + 1.) / number_of_candidates));
  }

  gp_Dir direction(double u, double v) const
  {
    return gp_Dir(m_surface.Value(u, v).XYZ() - m_surface.Sphere().Location().XYZ());
  }

  // Returns false if an edge has no curve in the domain, or if the face keeps the parameters of the file.
  bool sample_boundary()
  {
    for(TopExp_Explorer edge(m_face, TopAbs_EDGE); edge.More(); edge.Next()) {
      Unit_range range;
      const Handle(Geom2d_Curve) curve
        = BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Current()), m_face, range.first, range.last);
      if(curve.IsNull())
        return false;
      const bool is_seam = BRep_Tool::IsClosed(TopoDS::Edge(edge.Current()), m_face),
                 is_pole = BRep_Tool::Degenerated(TopoDS::Edge(edge.Current()));
      m_has_seam = m_has_seam || is_seam;
      for(int i = 0; i <= samples_on_edge && !is_seam; ++i) {
        const gp_Pnt2d p = curve->Value(range(double(i) / samples_on_edge));
        m_boundary.push_back(direction(p.X(), p.Y()));
        m_touches_pole = m_touches_pole || (!is_pole && std::cos(p.Y()) < pole_distance);
      }
    }
    return !m_boundary.empty() && (!m_has_seam || m_touches_pole);
  }

  double distance_from_boundary(const gp_Dir& direction) const
  {
    double result = 4;
    for(const gp_Dir& d : m_boundary)
      result = (std::min)(result, d.Angle(direction));
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_FIND_SPHERE_CHART_H
