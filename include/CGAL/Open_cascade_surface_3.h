// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_OPEN_CASCADE_SURFACE_3_H
#define CGAL_OPEN_CASCADE_SURFACE_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_jet_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/convert_surface.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Face.hxx>

#include <array>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

The surface of a face of Open CASCADE, in the place that the location of the face gives it.

Planes, cylinders, cones, spheres, tori, Bezier and B-spline surfaces are evaluated by the classes of this package: the
same functions of the same parameters, without virtual calls. Periodic surfaces may be evaluated at any parameters. Other
surfaces (offsets, extrusions, surfaces of revolution) are evaluated by Open CASCADE; an exception that it throws becomes a
`Parametric_surface_mesh_error`.

Copies share a surface of this package. Open CASCADE keeps caches in its own surfaces: if `is_evaluated_by_open_cascade()`,
a copy has a surface of its own, so that copies can be evaluated by several threads at the same time; one object cannot.

\cgalModels{ParametricSurface_3}
*/
class Open_cascade_surface_3
{
public:
  typedef Exact_predicates_inexact_constructions_kernel Geom_traits;
  typedef Geom_traits::Point_3 Point_3;

private:
  typedef Parametric_surface_mesher::internal::Any_surface_3<Geom_traits> Any_surface;

  std::shared_ptr<const Any_surface> m_surface;
  double m_period_u = 0, m_period_v = 0;

public:
  /*!
  the surface of `face`.
  \throws Parametric_surface_mesh_error if the face has no surface or its surface is degenerate
  */
  explicit Open_cascade_surface_3(const TopoDS_Face& face)
  {
    using namespace Parametric_surface_mesher::internal;
    TopLoc_Location location;
    if(BRep_Tool::Surface(face, location).IsNull()) // as in a damaged file
      throw Parametric_surface_mesh_error("the face has no surface");
    guarded([&] {
      const BRepAdaptor_Surface adaptor(face, false);
      m_surface = std::make_shared<const Any_surface>(convert_surface<Geom_traits>(adaptor));
      m_period_u = adaptor.IsUPeriodic() ? adaptor.UPeriod() : 0;
      m_period_v = adaptor.IsVPeriodic() ? adaptor.VPeriod() : 0;
    });
  }

  /// @cond SKIP_IN_MANUAL
  Open_cascade_surface_3(const Open_cascade_surface_3& other)
    : m_surface(other.is_evaluated_by_open_cascade() ? std::make_shared<const Any_surface>(*other.m_surface) : other.m_surface),
      m_period_u(other.m_period_u), m_period_v(other.m_period_v)
  {}

  Open_cascade_surface_3(Open_cascade_surface_3&&) = default;

  Open_cascade_surface_3& operator=(const Open_cascade_surface_3& other) { return *this = Open_cascade_surface_3(other); }
  Open_cascade_surface_3& operator=(Open_cascade_surface_3&&) = default;

  // another parametrisation of the same surface, without periods
  template <class Surface>
  static Open_cascade_surface_3 reparametrized(const Surface& surface)
  {
    return Open_cascade_surface_3(std::make_shared<const Any_surface>(surface));
  }
  /// @endcond

  /// the period in `u`, or 0.
  double u_period() const { return m_period_u; }

  /// the period in `v`, or 0.
  double v_period() const { return m_period_v; }

  /// tells whether the surface is none of this package's.
  bool is_evaluated_by_open_cascade() const
  {
    return std::holds_alternative<Parametric_surface_mesher::internal::Kernel_surface_3<Geom_traits>>(*m_surface);
  }

  /// tells whether the parameters are others than those of the face: some parts of spheres are meshed in coordinates without poles.
  bool is_reparametrized() const
  {
    return std::holds_alternative<Parametric_surface_mesher::internal::Stereographic_sphere_3<Geom_traits>>(*m_surface);
  }

  /// `S(u,v)`
  Point_3 point(double u, double v) const
  {
    return std::visit([=](const auto& surface) -> Point_3 { return surface.point(u, v); }, *m_surface);
  }

  /// `S(u,v)` with all partial derivatives up to second order.
  Surface_jet_3<Geom_traits> jet(double u, double v) const
  {
    return std::visit([=](const auto& surface) -> Surface_jet_3<Geom_traits> { return surface.jet(u, v); }, *m_surface);
  }

  /// the lines between which no feature is looked for.
  std::array<std::vector<double>, 2> feature_lines() const
  {
    return std::visit([](const auto& surface) { return surface.feature_lines(); }, *m_surface);
  }

private:
  explicit Open_cascade_surface_3(std::shared_ptr<const Any_surface> surface) : m_surface(std::move(surface)) {}
};

} // namespace CGAL

#endif // CGAL_OPEN_CASCADE_SURFACE_3_H
