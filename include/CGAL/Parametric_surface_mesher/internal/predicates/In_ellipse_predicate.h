// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PREDICATES_IN_ELLIPSE_PREDICATE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PREDICATES_IN_ELLIPSE_PREDICATE_H

#include <CGAL/Metric_tensor_2.h>

#include <CGAL/FPU.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The sum of four numbers, added in ascending order, so that not even its rounding depends on their order.
inline double sum_in_sorted_order(double a, double b, double c, double d)
{
  if(b < a) std::swap(a, b);
  if(d < c) std::swap(c, d);
  if(c < a) std::swap(a, c);
  if(d < b) std::swap(b, d);
  if(c < b) std::swap(b, c);
  return ((a + b) + c) + d;
}

// The tensor that the predicate uses for four points: the sum of theirs. Its scale does not matter.
inline Metric_tensor_2 common_tensor(const Metric_tensor_2& m0, const Metric_tensor_2& m1,
                                     const Metric_tensor_2& m2, const Metric_tensor_2& m3)
{
  return Metric_tensor_2(sum_in_sorted_order(m0.e(), m1.e(), m2.e(), m3.e()),
                         sum_in_sorted_order(m0.f(), m1.f(), m2.f(), m3.f()),
                         sum_in_sorted_order(m0.g(), m1.g(), m2.g(), m3.g()));
}

/*
The in-circle determinant with |x|^2 replaced by x^T M x, on coordinates relative to `t`: positive iff `t` lies inside the
ellipse through the counterclockwise `p`, `q`, `r`. `f2`: twice the mixed coefficient
*/
template <class NT>
struct In_ellipse_determinant
{
  const NT ax, ay, bx, by, cx, cy;

  template <class Point>
  In_ellipse_determinant(const Point& p, const Point& q, const Point& r, const Point& t)
    : In_ellipse_determinant(p, q, r, NT(t.x()), NT(t.y()))
  {}

  NT value(const NT& e, const NT& f2, const NT& g) const
  {
    const NT az = ax * (e * ax + f2 * ay) + g * ay * ay;
    const NT bz = bx * (e * bx + f2 * by) + g * by * by;
    const NT cz = cx * (e * cx + f2 * cy) + g * cy * cy;
    return az * (bx * cy - by * cx) + bz * (cx * ay - cy * ax) + cz * (ax * by - ay * bx);
  }

private:
  template <class Point>
  In_ellipse_determinant(const Point& p, const Point& q, const Point& r, const NT& tx, const NT& ty)
    : ax(NT(p.x()) - tx), ay(NT(p.y()) - ty), bx(NT(q.x()) - tx), by(NT(q.y()) - ty), cx(NT(r.x()) - tx), cy(NT(r.y()) - ty)
  {}
};

/*
The sign in floating point, or `ZERO` if that does not tell it.

Let X, Y bound the relative coordinates and s = e X^2 + g Y^2. As the tensors are positive definite (Cauchy-Schwarz bounds the
off-diagonal sum), each lifted coordinate is at most 2 s and the sum of the absolute values of all monomials at most 12 s X Y.
A monomial passes through at most 4 (minor) + 12 (lifted coordinate; of these 6 for the sum of the tensors taken in another
order than the sorted one) + 3 roundings, each of half an epsilon, hence an error below 12 * 19 / 2 = 114 epsilons of s X Y.
The bound has room for its own rounding; near underflow or overflow the filter does not answer.
*/
template <class FT, class Point>
Sign filtered_sign_of_in_ellipse(const Point& p, const Point& q, const Point& r, const Point& t, FT e, FT f2, FT g)
{
  const In_ellipse_determinant<FT> determinant(p, q, r, t);
  const FT x = (std::max)((std::max)(std::fabs(determinant.ax), std::fabs(determinant.bx)), std::fabs(determinant.cx));
  const FT y = (std::max)((std::max)(std::fabs(determinant.ay), std::fabs(determinant.by)), std::fabs(determinant.cy));
  const FT scale = x * y * (e * x * x + g * y * y);
  if(x * y > FT(1e-290) && scale > FT(1e-250) && scale < FT(1e250)) {
    const FT value = determinant.value(e, f2, g), bound = FT(135 * std::numeric_limits<FT>::epsilon()) * scale;
    return Sign(int(value > bound) - int(value < -bound));
  }
  return ZERO;
}

// Whether `p`, `q`, `r`, `t` are, in this order, the corners of a rectangle with sides along the axes, the first one vertical.
template <class Point>
bool are_corners_of_rectangle(const Point& p, const Point& q, const Point& r, const Point& t)
{
  return p.x() == q.x() && q.y() == r.y() && r.x() == t.x() && t.y() == p.y() && p.x() != r.x() && p.y() != r.y();
}

/*
The sign for the doubles given as exact input. Four points that were computed to lie on an ellipse miss it by rounding of
their coordinates: most often a longer significand tells the side. Those that do lie on it take exact numbers; but for the
corners of a rectangle, as there are many between two lines of the domain: its sides w and h leave `f2 w^2 h^2` of the
determinant, with the other sign if the side from `t` to the next corner is horizontal.
*/
template <class Point>
Sign exact_sign_of_in_ellipse(const Point& p, const Point& q, const Point& r, const Point& t, const Metric_tensor_2& m)
{
  if(are_corners_of_rectangle(t, p, q, r) || are_corners_of_rectangle(t, q, r, p) || are_corners_of_rectangle(t, r, p, q))
    return CGAL::sign(m.f());
  if(are_corners_of_rectangle(t, r, q, p) || are_corners_of_rectangle(t, p, r, q) || are_corners_of_rectangle(t, q, p, r))
    return CGAL::sign(-m.f());
  typedef long double L;
  const Sign sign = filtered_sign_of_in_ellipse<L>(p, q, r, t, L(m.e()), 2 * L(m.f()), L(m.g()));
  if(sign != ZERO)
    return sign;
  Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  typedef CGAL::internal::Exact_ring_selector<double>::Type E;
  return CGAL::sign(In_ellipse_determinant<E>(p, q, r, t).value(E(m.e()), E(m.f()) + E(m.f()), E(m.g())));
}

// The exact sign of the in-ellipse determinant of four points under their common tensor.
template <class Point>
Sign sign_of_in_ellipse(const Point& p, const Point& q, const Point& r, const Point& t)
{
  const Metric_tensor_2 &mp = p.tensor(), &mq = q.tensor(), &mr = r.tensor(), &mt = t.tensor();
  const double e = (mp.e() + mq.e()) + (mr.e() + mt.e());
  const double f2 = 2 * ((mp.f() + mq.f()) + (mr.f() + mt.f()));
  const double g = (mp.g() + mq.g()) + (mr.g() + mt.g());
  const Sign sign = filtered_sign_of_in_ellipse<double>(p, q, r, t, e, f2, g);
  return sign != ZERO ? sign : exact_sign_of_in_ellipse(p, q, r, t, common_tensor(mp, mq, mr, mt));
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PREDICATES_IN_ELLIPSE_PREDICATE_H
