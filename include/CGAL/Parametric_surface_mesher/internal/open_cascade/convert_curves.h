// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CONVERT_CURVES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CONVERT_CURVES_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Domain_curve_2.h>
#include <CGAL/Space_curve_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/convert_surface.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Precision.hxx>
#include <ShapeConstruct_ProjectCurveOnSurface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Circ.hxx>
#include <gp_Circ2d.hxx>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Maps the range from 0 to 1 to the range of parameters of a curve of Open CASCADE. All curves of an edge get parameters from 0 to 1,
// whatever they have in the file.
struct Unit_range
{
  double first, last;

  double length() const { return last - first; }
  double operator()(double t) const { return first + t * (last - first); }
};

template <class Kernel>
Space_curve_3<Kernel> to_space_curve(const gp_Circ& circle, const Unit_range& range)
{
  typedef typename Space_curve_3<Kernel>::Jet Jet;
  const auto center = to_point<Kernel>(circle.Location().XYZ());
  const auto x = circle.Radius() * to_vector<Kernel>(circle.Position().XDirection().XYZ()),
             y = circle.Radius() * to_vector<Kernel>(circle.Position().YDirection().XYZ());
  return Space_curve_3<Kernel>(
    [=](double t) {
      const double c = std::cos(range(t)), s = std::sin(range(t)), k = range.length();
      const auto outward = c * x + s * y;
      return Jet{center + outward, k * (c * y - s * x), -k * k * outward};
    },
    0, 1);
}

// The curve of an edge in space; none if the edge has none.
template <class Kernel>
std::shared_ptr<const Space_curve_3<Kernel>> convert_space_curve(const TopoDS_Edge& edge)
{
  typedef Space_curve_3<Kernel> Curve;
  TopLoc_Location location;
  Unit_range range;
  if(BRep_Tool::Curve(edge, location, range.first, range.last).IsNull() || !(range.length() != 0))
    return nullptr;
  const auto adaptor = std::make_shared<const BRepAdaptor_Curve>(edge);
  if(adaptor->GetType() == GeomAbs_Line)
    return std::make_shared<const Curve>(Curve::segment(to_point<Kernel>(adaptor->Value(range.first).XYZ()),
                                                        to_point<Kernel>(adaptor->Value(range.last).XYZ())));
  if(adaptor->GetType() == GeomAbs_Circle)
    return std::make_shared<const Curve>(to_space_curve<Kernel>(adaptor->Circle(), range));
  return std::make_shared<const Curve>(
    [adaptor, range](double t) {
      gp_Pnt p;
      gp_Vec first, second;
      guarded([&] { adaptor->D2(range(t), p, first, second); });
      return typename Curve::Jet{to_point<Kernel>(p.XYZ()), range.length() * to_vector<Kernel>(first.XYZ()),
                                 range.length() * range.length() * to_vector<Kernel>(second.XYZ())};
    },
    0, 1);
}

// The part of a curve over a range of its parameters, with parameters from 0 to 1.
template <class Kernel>
std::shared_ptr<const Space_curve_3<Kernel>> restricted(const std::shared_ptr<const Space_curve_3<Kernel>>& curve,
                                                        const Unit_range& range)
{
  typedef Space_curve_3<Kernel> Curve;
  return std::make_shared<const Curve>(
    [curve, range](double t) {
      const auto jet = curve->jet(range(t));
      return typename Curve::Jet{jet.point, range.length() * jet.first, range.length() * range.length() * jet.second};
    },
    0, 1);
}

template <class Kernel>
Domain_curve_2<Kernel> restricted(const Domain_curve_2<Kernel>& curve, const Unit_range& range)
{
  typedef Domain_curve_2<Kernel> Curve;
  if(curve.is_straight())
    return Curve::segment(curve.point(range.first), curve.point(range.last));
  return Curve(
    [curve, range](double t) {
      const auto jet = curve.jet(range(t));
      return typename Curve::Jet{jet.point, range.length() * jet.first, range.length() * range.length() * jet.second};
    },
    0, 1);
}

// The parameter close to `t`, but not beyond the middle of the curve, where a curve with parameters from 0 to 1 is closest to a point.
template <class Kernel>
double parameter_near_end(const Space_curve_3<Kernel>& curve, double t, const typename Kernel::Point_3& p)
{
  const int number_of_newton_steps = 4;
  const double end = t;
  for(int i = 0; i < number_of_newton_steps; ++i) {
    const auto jet = curve.jet(t);
    const double next = t - (jet.point - p) * jet.first / jet.first.squared_length();
    t = end < 0.5 ? (std::min)((std::max)(next, 0.), 0.5) : (std::max)((std::min)(next, 1.), 0.5);
  }
  return std::isfinite(t) ? t : end;
}

inline bool is_segment(const Geom2dAdaptor_Curve& curve)
{
  return curve.GetType() == GeomAbs_Line
         || (curve.GetType() == GeomAbs_BSplineCurve && curve.Degree() == 1 && curve.NbPoles() == 2);
}

template <class Kernel>
Domain_curve_2<Kernel> to_domain_curve(const gp_Circ2d& circle, const Unit_range& range)
{
  typedef typename Kernel::Vector_2 Vector_2;
  const typename Kernel::Point_2 center(circle.Location().X(), circle.Location().Y());
  const Vector_2 x(circle.Radius() * circle.XAxis().Direction().X(), circle.Radius() * circle.XAxis().Direction().Y()),
    y(circle.Radius() * circle.YAxis().Direction().X(), circle.Radius() * circle.YAxis().Direction().Y());
  return Domain_curve_2<Kernel>(
    [=](double t) {
      const double c = std::cos(range(t)), s = std::sin(range(t)), k = range.length();
      const Vector_2 outward = c * x + s * y;
      return typename Domain_curve_2<Kernel>::Jet{center + outward, k * (c * y - s * x), -k * k * outward};
    },
    0, 1);
}

template <class Kernel>
Domain_curve_2<Kernel> to_domain_curve(const Handle(Geom2d_Curve)& pcurve, const Unit_range& range)
{
  typedef Domain_curve_2<Kernel> Curve;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Vector_2 Vector_2;
  const auto adaptor = std::make_shared<const Geom2dAdaptor_Curve>(pcurve);
  const auto point = [&](double t) { return Point_2(adaptor->Value(t).X(), adaptor->Value(t).Y()); };
  if(is_segment(*adaptor))
    return Curve::segment(point(range.first), point(range.last));
  if(adaptor->GetType() == GeomAbs_Circle)
    return to_domain_curve<Kernel>(adaptor->Circle(), range);
  return Curve(
    [adaptor, range](double t) {
      gp_Pnt2d p;
      gp_Vec2d first, second;
      guarded([&] { adaptor->D2(range(t), p, first, second); });
      const double k = range.length();
      return typename Curve::Jet{Point_2(p.X(), p.Y()), k * Vector_2(first.X(), first.Y()),
                                 k * k * Vector_2(second.X(), second.Y())};
    },
    0, 1);
}

// The curve of an edge in the domain of a face; none if the file has none. A seam has two, of which the orientation of `edge` selects
// one.
template <class Kernel>
std::optional<Domain_curve_2<Kernel>> convert_domain_curve(const TopoDS_Edge& edge, const TopoDS_Face& face)
{
  Unit_range range;
  const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, face, range.first, range.last);
  if(pcurve.IsNull() || !(range.length() != 0))
    return std::nullopt;
  return to_domain_curve<Kernel>(pcurve, range);
}

// The curve of an edge in the domain of a face, computed by projecting its curve in space. The precision is not the tolerance of the edge:
// if that is wide the result may be as far off.
// \pre the edge is no seam of the face
template <class Kernel>
std::optional<Domain_curve_2<Kernel>> project_domain_curve(const TopoDS_Edge& edge, const TopoDS_Face& face)
{
  Unit_range range;
  Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, range.first, range.last);
  if(curve.IsNull())
    return std::nullopt;
  ShapeConstruct_ProjectCurveOnSurface project;
  project.Init(BRep_Tool::Surface(face), Precision::Confusion());
  Handle(Geom2d_Curve) result;
  if(!project.Perform(curve, range.first, range.last, result) || result.IsNull())
    return std::nullopt;
  return to_domain_curve<Kernel>(result, range);
}

// The curve translated by `v`.
template <class Kernel>
Domain_curve_2<Kernel> translated(const Domain_curve_2<Kernel>& curve, const typename Kernel::Vector_2& v)
{
  typedef Domain_curve_2<Kernel> Curve;
  if(curve.is_straight())
    return Curve::segment(curve.source() + v, curve.target() + v);
  Curve result(
    [curve, v](double t) {
      auto jet = curve.jet(t);
      jet.point = jet.point + v;
      return jet;
    },
    curve.begin(), curve.end());
  result.set_end_points(curve.source() + v, curve.target() + v);
  return result;
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CONVERT_CURVES_H
