// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANY_PARAMETRIC_SURFACE_3_H
#define CGAL_ANY_PARAMETRIC_SURFACE_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/surfaces/are_copies_independent.h>
#include <CGAL/Surface_jet_3.h>

#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSurfaces

A surface of any type. All faces of a `Parametric_surface_model_3` have surfaces of one type: with this one a model takes
planes, B-splines, formulas and surfaces of the user side by side.

It costs a virtual call for each evaluation. A copy has a copy of the surface that it holds.

\tparam Kernel the kernel of the surfaces, their `Geom_traits`

\cgalModels{ParametricSurface_3}
*/
template <class Kernel>
class Any_parametric_surface_3
{
public:
  typedef Kernel Geom_traits;
  typedef typename Kernel::Point_3 Point_3;

private:
  struct Held
  {
    virtual ~Held() {}
    virtual std::unique_ptr<const Held> copy() const = 0;
    virtual bool has_independent_copies() const = 0;
    virtual Point_3 point(double u, double v) const = 0;
    virtual Surface_jet_3<Kernel> jet(double u, double v) const = 0;
  };

  template <class Surface>
  struct Held_surface final
    : Held
  {
    Surface surface;

    explicit Held_surface(Surface s) : surface(std::move(s)) {}

    std::unique_ptr<const Held> copy() const override { return std::make_unique<Held_surface>(surface); }

    bool has_independent_copies() const override
    {
      return Parametric_surface_mesher::internal::are_copies_independent(surface);
    }

    Point_3 point(double u, double v) const override { return surface.point(u, v); }
    Surface_jet_3<Kernel> jet(double u, double v) const override { return surface.jet(u, v); }
  };

  std::unique_ptr<const Held> m_held;

public:
  /// holds a copy of `surface`.
  /// \tparam Surface a model of `ParametricSurface_3` with the `Geom_traits` `Kernel`
  template <class Surface, class = std::enable_if_t<!std::is_same<Surface, Any_parametric_surface_3>::value>>
  Any_parametric_surface_3(Surface surface) : m_held(std::make_unique<Held_surface<Surface>>(std::move(surface)))
  {
    static_assert(std::is_same<typename Surface::Geom_traits, Kernel>::value, "The surface has another kernel.");
  }

  /// @cond SKIP_IN_MANUAL
  Any_parametric_surface_3(const Any_parametric_surface_3& other) : m_held(other.m_held->copy()) {}
  Any_parametric_surface_3(Any_parametric_surface_3&&) = default;
  Any_parametric_surface_3& operator=(Any_parametric_surface_3 other)
  {
    m_held.swap(other.m_held);
    return *this;
  }
  /// @endcond

  /// as those of the surface that it holds; see `ParametricSurface_3`.
  bool has_independent_copies() const { return m_held->has_independent_copies(); }

  /// `S(u,v)`
  Point_3 point(double u, double v) const { return m_held->point(u, v); }

  /// `S(u,v)` with all partial derivatives up to second order.
  Surface_jet_3<Kernel> jet(double u, double v) const { return m_held->jet(u, v); }
};

} // namespace CGAL

#endif // CGAL_ANY_PARAMETRIC_SURFACE_3_H
