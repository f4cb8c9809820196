// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IN_ELLIPSE_PREDICATE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IN_ELLIPSE_PREDICATE_H

#include <CGAL/Metric_tensor_2.h>

#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Number_types/internal/Exact_type_selector.h>
#include <CGAL/Uncertain.h>
#include <CGAL/determinant.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The in-circle determinant with |x|^2 replaced by x^T M x, on coordinates relative to `t`.
// Positive iff `t` lies inside the ellipse through the counterclockwise `p`, `q`, `r`.
template <class NT>
Uncertain<Sign> sign_of_in_ellipse_determinant(const NT& px, const NT& py, const NT& qx, const NT& qy,
                                               const NT& rx, const NT& ry, const NT& tx, const NT& ty,
                                               const NT& e, const NT& f, const NT& g)
{
  const NT ax = px - tx, ay = py - ty;
  const NT bx = qx - tx, by = qy - ty;
  const NT cx = rx - tx, cy = ry - ty;
  const NT f2 = f + f;
  const NT az = ax * (e * ax + f2 * ay) + g * ay * ay;
  const NT bz = bx * (e * bx + f2 * by) + g * by * by;
  const NT cz = cx * (e * cx + f2 * cy) + g * cy * cy;
  return CGAL_NTS sign(determinant(ax, ay, az, bx, by, bz, cx, cy, cz));
}

// The sum of four numbers that does not depend on their order, to the last bit:
// rounding is fixed by adding in ascending order.
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

// The sign for the doubles given as exact input: intervals first, then an exact ring.
template <class Point>
Sign exact_sign_of_in_ellipse_determinant(const Point& p, const Point& q, const Point& r, const Point& t,
                                          const Metric_tensor_2& m)
{
  {
    typedef Interval_nt_advanced I;
    Protect_FPU_rounding<true> upward;
    const Uncertain<Sign> s = sign_of_in_ellipse_determinant<I>(p.x(), p.y(), q.x(), q.y(), r.x(), r.y(),
                                                               t.x(), t.y(), m.e(), m.f(), m.g());
    if(is_certain(s))
      return get_certain(s);
  }
  Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
  typedef CGAL::internal::Exact_ring_selector<double>::Type E;
  return get_certain(sign_of_in_ellipse_determinant<E>(E(p.x()), E(p.y()), E(q.x()), E(q.y()), E(r.x()), E(r.y()),
                                                       E(t.x()), E(t.y()), E(m.e()), E(m.f()), E(m.g())));
}

/*
The exact sign of the in-ellipse determinant of four points under their common tensor.

Semi-static filter. Let X, Y bound the relative coordinates and s = e X^2 + g Y^2. As the tensors are positive
definite (Cauchy-Schwarz bounds the off-diagonal sum), each lifted coordinate is at most 2 s and the sum of the
absolute values of all monomials at most 12 s X Y. A monomial passes through at most 4 (minor) + 12 (lifted
coordinate; of these 6 for the sum of the tensors taken in another order than the sorted one) + 3 roundings,
hence an error below 12 * 19 * 2^-53 s X Y < 2.54e-14 s X Y. The bound has room for its own rounding; near
underflow or overflow the filter does not answer.
*/
template <class Point>
Sign sign_of_in_ellipse(const Point& p, const Point& q, const Point& r, const Point& t)
{
  const Metric_tensor_2 &mp = p.tensor(), &mq = q.tensor(), &mr = r.tensor(), &mt = t.tensor();
  const double ax = p.x() - t.x(), ay = p.y() - t.y();
  const double bx = q.x() - t.x(), by = q.y() - t.y();
  const double cx = r.x() - t.x(), cy = r.y() - t.y();
  const double e = (mp.e() + mq.e()) + (mr.e() + mt.e());
  const double f2 = 2 * ((mp.f() + mq.f()) + (mr.f() + mt.f()));
  const double g = (mp.g() + mq.g()) + (mr.g() + mt.g());
  const double az = ax * (e * ax + f2 * ay) + g * ay * ay;
  const double bz = bx * (e * bx + f2 * by) + g * by * by;
  const double cz = cx * (e * cx + f2 * cy) + g * cy * cy;
  const double det = az * (bx * cy - by * cx) + bz * (cx * ay - cy * ax) + cz * (ax * by - ay * bx);

  const double x = (std::max)((std::max)(std::fabs(ax), std::fabs(bx)), std::fabs(cx));
  const double y = (std::max)((std::max)(std::fabs(ay), std::fabs(by)), std::fabs(cy));
  const double scale = x * y * (e * x * x + g * y * y);
  if(x * y > 1e-290 && scale > 1e-250 && scale < 1e250) {
    const double bound = 3e-14 * scale;
    if(det > bound)
      return POSITIVE;
    if(det < -bound)
      return NEGATIVE;
  }
  return exact_sign_of_in_ellipse_determinant(p, q, r, t, common_tensor(mp, mq, mr, mt));
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_IN_ELLIPSE_PREDICATE_H
