// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CONVERT_SURFACE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CONVERT_SURFACE_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/B_spline_surface_3.h>
#include <CGAL/Bezier_surface_3.h>
#include <CGAL/Parametric_frame_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Surface_jet_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Periodic_b_spline_surface_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Stereographic_sphere_3.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/feature_lines.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <GeomAbs_Shape.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <gp_Ax3.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include <cmath>
#include <memory>
#include <variant>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

template <class Kernel>
typename Kernel::Point_3 to_point(const gp_XYZ& p)
{
  return typename Kernel::Point_3(p.X(), p.Y(), p.Z());
}

template <class Kernel>
typename Kernel::Vector_3 to_vector(const gp_XYZ& v)
{
  return typename Kernel::Vector_3(v.X(), v.Y(), v.Z());
}

template <class Kernel>
Parametric_frame_3<Kernel> to_frame(const gp_Ax3& a)
{
  return Parametric_frame_3<Kernel>(to_point<Kernel>(a.Location().XYZ()), to_vector<Kernel>(a.XDirection().XYZ()),
                                    to_vector<Kernel>(a.YDirection().XYZ()), to_vector<Kernel>(a.Direction().XYZ()));
}

// The same surface of the same parameters, with geometry of its own.
inline BRepAdaptor_Surface copy_with_geometry(const BRepAdaptor_Surface& adaptor)
{
  return guarded([&] {
    TopLoc_Location location;
    const auto surface = Handle(Geom_Surface)::DownCast(BRep_Tool::Surface(adaptor.Face(), location)->Copy());
    TopoDS_Face face;
    BRep_Builder().MakeFace(face, surface, location, BRep_Tool::Tolerance(adaptor.Face()));
    return BRepAdaptor_Surface(face, false);
  });
}

// A surface that Open CASCADE evaluates: offsets, extrusions, surfaces of revolution, and all others without a class of their own.
template <class Kernel>
class Kernel_surface_3
{
  BRepAdaptor_Surface m_adaptor;

public:
  typedef Kernel Geom_traits;

  explicit Kernel_surface_3(const BRepAdaptor_Surface& adaptor) : m_adaptor(adaptor) {}

  // The kernel keeps caches in adaptors and in those of the curves and surfaces that a surface is made of. A copy shares none
  // of them, so that another thread may evaluate it.
  Kernel_surface_3(const Kernel_surface_3& other) : m_adaptor(copy_with_geometry(other.m_adaptor)) {}
  Kernel_surface_3& operator=(const Kernel_surface_3&) = delete;

  typename Kernel::Point_3 point(double u, double v) const
  {
    return guarded([&] { return to_point<Kernel>(m_adaptor.Value(u, v).XYZ()); });
  }

  Surface_jet_3<Kernel> jet(double u, double v) const
  {
    gp_Pnt p;
    gp_Vec du, dv, duu, dvv, duv;
    guarded([&] { m_adaptor.D2(u, v, p, du, dv, duu, dvv, duv); });
    return {to_point<Kernel>(p.XYZ()),    to_vector<Kernel>(du.XYZ()),  to_vector<Kernel>(dv.XYZ()),
            to_vector<Kernel>(duu.XYZ()), to_vector<Kernel>(duv.XYZ()), to_vector<Kernel>(dvv.XYZ())};
  }

  // Each piece that is smooth counts as a polynomial. (Lines that are not finite belong to no face.)
  std::array<std::vector<double>, 2> feature_lines() const
  {
    const int degree = 4;
    return guarded([&] {
      TColStd_Array1OfReal ends_u(1, m_adaptor.NbUIntervals(GeomAbs_C2) + 1), ends_v(1, m_adaptor.NbVIntervals(GeomAbs_C2) + 1);
      m_adaptor.UIntervals(ends_u, GeomAbs_C2);
      m_adaptor.VIntervals(ends_v, GeomAbs_C2);
      return std::array<std::vector<double>, 2>{polynomial_lines({ends_u.begin(), ends_u.end()}, degree),
                                                polynomial_lines({ends_v.begin(), ends_v.end()}, degree)};
    });
  }
};

// Any surface that a face of a shape may have.
template <class Kernel>
using Any_surface_3
  = std::variant<Parametric_plane_3<Kernel>, Parametric_cylinder_3<Kernel>, Parametric_cone_3<Kernel>,
                 Parametric_sphere_3<Kernel>, Parametric_torus_3<Kernel>, Bezier_surface_3<Kernel>,
                 Periodic_b_spline_surface_3<Kernel>, Stereographic_sphere_3<Kernel>, Kernel_surface_3<Kernel>>;

inline std::vector<double> flat_knots(const TColStd_Array1OfReal& knots)
{
  return std::vector<double>(knots.begin(), knots.end());
}

template <class Kernel>
std::vector<typename Kernel::Point_3> control_points(const TColgp_Array2OfPnt& poles)
{
  std::vector<typename Kernel::Point_3> result;
  for(int j = poles.LowerCol(); j <= poles.UpperCol(); ++j)
    for(int i = poles.LowerRow(); i <= poles.UpperRow(); ++i)
      result.push_back(to_point<Kernel>(poles(i, j).XYZ()));
  return result;
}

// The weights, row by row; empty for a polynomial surface.
template <class Spline>
std::vector<double> weights(const Spline& spline)
{
  std::vector<double> result;
  if(spline.IsURational() || spline.IsVRational())
    for(int j = 1; j <= spline.NbVPoles(); ++j)
      for(int i = 1; i <= spline.NbUPoles(); ++i)
        result.push_back(spline.Weight(i, j));
  return result;
}

template <class Kernel>
Any_surface_3<Kernel> convert_b_spline(const BRepAdaptor_Surface& adaptor)
{
  const auto spline = Handle(Geom_BSplineSurface)::DownCast(adaptor.BSpline()->Copy());
  const bool is_periodic_u = spline->IsUPeriodic(), is_periodic_v = spline->IsVPeriodic();
  if(is_periodic_u)
    spline->SetUNotPeriodic();
  if(is_periodic_v)
    spline->SetVNotPeriodic();
  return Periodic_b_spline_surface_3<Kernel>(
    B_spline_surface_3<Kernel>(spline->UDegree(), spline->VDegree(), flat_knots(spline->UKnotSequence()),
                               flat_knots(spline->VKnotSequence()), control_points<Kernel>(spline->Poles()),
                               weights(*spline)),
    is_periodic_u, is_periodic_v);
}

inline std::vector<double> bezier_knots(int degree)
{
  std::vector<double> result(degree + 1, 0.);
  result.resize(2 * degree + 2, 1.);
  return result;
}

template <class Kernel>
Any_surface_3<Kernel> convert_bezier(const BRepAdaptor_Surface& adaptor)
{
  const auto bezier = adaptor.Bezier();
  const int degree_u = bezier->UDegree(), degree_v = bezier->VDegree();
  if(!bezier->IsURational() && !bezier->IsVRational())
    return Bezier_surface_3<Kernel>(degree_u, degree_v, control_points<Kernel>(bezier->Poles()));
  return Periodic_b_spline_surface_3<Kernel>(
    B_spline_surface_3<Kernel>(degree_u, degree_v, bezier_knots(degree_u), bezier_knots(degree_v),
                               control_points<Kernel>(bezier->Poles()), weights(*bezier)),
    false, false);
}

// The surface of a face: one of this package if that is the same function of its parameters, otherwise one that Open CASCADE
// evaluates.
template <class Kernel>
Any_surface_3<Kernel> convert_surface(const BRepAdaptor_Surface& adaptor)
{
  const double rounding_of_scale = 1e-12;
  if(std::fabs(std::fabs(adaptor.Trsf().ScaleFactor()) - 1) > rounding_of_scale)
    return Kernel_surface_3<Kernel>(adaptor); // a scaled plane has other parameters than ours
  switch(adaptor.GetType()) {
  case GeomAbs_Plane:
    return Parametric_plane_3<Kernel>(to_frame<Kernel>(adaptor.Plane().Position()));
  case GeomAbs_Cylinder:
    return Parametric_cylinder_3<Kernel>(adaptor.Cylinder().Radius(), to_frame<Kernel>(adaptor.Cylinder().Position()));
  case GeomAbs_Cone:
    return Parametric_cone_3<Kernel>(adaptor.Cone().RefRadius(), adaptor.Cone().SemiAngle(),
                                     to_frame<Kernel>(adaptor.Cone().Position()));
  case GeomAbs_Sphere:
    return Parametric_sphere_3<Kernel>(adaptor.Sphere().Radius(), to_frame<Kernel>(adaptor.Sphere().Position()));
  case GeomAbs_Torus:
    return Parametric_torus_3<Kernel>(adaptor.Torus().MajorRadius(), adaptor.Torus().MinorRadius(),
                                      to_frame<Kernel>(adaptor.Torus().Position()));
  case GeomAbs_BezierSurface:
    return convert_bezier<Kernel>(adaptor);
  case GeomAbs_BSplineSurface:
    return convert_b_spline<Kernel>(adaptor);
  default:
    return Kernel_surface_3<Kernel>(adaptor);
  }
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CONVERT_SURFACE_H
