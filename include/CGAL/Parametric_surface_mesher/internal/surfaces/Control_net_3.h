// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_CONTROL_NET_3_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_CONTROL_NET_3_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/surfaces/B_spline_basis.h>
#include <CGAL/Surface_jet_3.h>
#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The control points of a tensor-product surface, with weights if it is rational, and their sums with two bases.
template <class Kernel>
class Control_net_3
{
public:
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;

private:
  typedef Eigen::Vector4d Homogeneous;

  int m_size_u, m_size_v;
  std::vector<Homogeneous> m_points; // (x, y, z, 1), so that the sum of the weights comes with that of the points
  std::vector<double> m_weights;     // empty if all are equal

public:
  // The points come row by row: the index in the u direction runs fastest.
  template <class Point_range>
  Control_net_3(const std::string& place, int size_u, int size_v,
                const Point_range& points, std::vector<double> weights)
    : m_size_u(size_u), m_size_v(size_v), m_weights(std::move(weights))
  {
    for(const Point_3& p : points)
      m_points.emplace_back(p.x(), p.y(), p.z(), 1);
    check_points(place);
    if(!m_weights.empty())
      check_weights(place);
    if(std::all_of(m_weights.begin(), m_weights.end(), [this](double w) { return w == m_weights.front(); }))
      m_weights.clear();
  }

  bool is_rational() const { return !m_weights.empty(); }

  Point_3 point(int i, int j) const
  {
    const Homogeneous& p = m_points[index(i, j)];
    return Point_3(p[0], p[1], p[2]);
  }

  double weight(int i, int j) const { return is_rational() ? m_weights[index(i, j)] : 1; }

  // The sum over the points from `(first_u, first_v)` on, weighted by the basis functions.
  Point_3 evaluate(const Basis_functions& u, int degree_u, int first_u,
                   const Basis_functions& v, int degree_v, int first_v) const
  {
    Homogeneous sum = Homogeneous::Zero();
    for(int j = 0; j <= degree_v; ++j) {
      Homogeneous row = Homogeneous::Zero();
      for(int i = 0; i <= degree_u; ++i) {
        const std::size_t k = row_begin(first_v + j) + first_u + i;
        row += (is_rational() ? u.value[i] * m_weights[k] : u.value[i]) * m_points[k];
      }
      sum += v.value[j] * row;
    }
    return is_rational() ? Point_3(sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3])
                         : Point_3(sum[0], sum[1], sum[2]);
  }

  // The sum with its derivatives (Piegl and Tiller, The NURBS Book, algorithm A3.6).
  Surface_jet_3<Kernel> evaluate(const Basis_function_jets& u, int degree_u, int first_u,
                                 const Basis_function_jets& v, int degree_v, int first_v) const
  {
    Homogeneous s = Homogeneous::Zero(), du = s, dv = s, duu = s, duv = s, dvv = s;
    for(int j = 0; j <= degree_v; ++j) {
      Homogeneous row = Homogeneous::Zero(), row_u = row, row_uu = row;
      for(int i = 0; i <= degree_u; ++i) {
        const std::size_t k = row_begin(first_v + j) + first_u + i;
        const Homogeneous& p = m_points[k];
        const double weight = is_rational() ? m_weights[k] : 1;
        row += u.value[i] * weight * p;
        row_u += u.first[i] * weight * p;
        row_uu += u.second[i] * weight * p;
      }
      s += v.value[j] * row;
      du += v.value[j] * row_u;
      duu += v.value[j] * row_uu;
      dv += v.first[j] * row;
      duv += v.first[j] * row_u;
      dvv += v.second[j] * row;
    }
    if(is_rational())
      project(s, du, dv, duu, duv, dvv);
    return { Point_3(s[0], s[1], s[2]), vector(du), vector(dv), vector(duu), vector(duv), vector(dvv) };
  }

private:
  std::size_t row_begin(int j) const { return std::size_t(j) * m_size_u; }

  std::size_t index(int i, int j) const
  {
    CGAL_precondition(i >= 0 && i < m_size_u && j >= 0 && j < m_size_v);
    return row_begin(j) + i;
  }

  static Vector_3 vector(const Homogeneous& h) { return Vector_3(h[0], h[1], h[2]); }

  // Turns homogeneous derivatives into those of the projected point by the quotient rule, lowest order first (The NURBS Book,
  // algorithm A4.4).
  static void project(Homogeneous& s, Homogeneous& du, Homogeneous& dv,
                      Homogeneous& duu, Homogeneous& duv, Homogeneous& dvv)
  {
    const double w = s[3], wu = du[3], wv = dv[3], wuu = duu[3], wuv = duv[3], wvv = dvv[3];
    s /= w;
    du = (du - wu * s) / w;
    dv = (dv - wv * s) / w;
    duu = (duu - 2 * wu * du - wuu * s) / w;
    duv = (duv - wu * dv - wv * du - wuv * s) / w;
    dvv = (dvv - 2 * wv * dv - wvv * s) / w;
  }

  void check_points(const std::string& place) const
  {
    check_count(place, "control points", m_points.size());
    for(std::size_t k = 0; k < m_points.size(); ++k)
      if(!m_points[k].allFinite()) {
        std::ostringstream found;
        found << m_points[k].head<3>().transpose();
        refuse_at(place, "finite coordinates", k, found.str());
      }
  }

  void check_weights(const std::string& place) const
  {
    check_count(place, "weights", m_weights.size());
    for(std::size_t k = 0; k < m_weights.size(); ++k)
      if(!(m_weights[k] > 0 && std::isfinite(m_weights[k])))
        refuse_at(place, "a positive finite weight", k, std::to_string(m_weights[k]));
  }

  void check_count(const std::string& place, const char* what, std::size_t found) const
  {
    if(found == std::size_t(m_size_u) * m_size_v)
      return;
    std::ostringstream message;
    message << place << ": expected " << m_size_u << " x " << m_size_v << ' ' << what << ", found " << found;
    throw Parametric_surface_mesh_error(message.str());
  }

  [[noreturn]] void refuse_at(const std::string& place, const char* expected,
                              std::size_t k, const std::string& found) const
  {
    std::ostringstream message;
    message << place << ", control point (" << k % m_size_u << "," << k / m_size_u << "): expected "
            << expected << ", found " << found;
    throw Parametric_surface_mesh_error(message.str());
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SURFACES_CONTROL_NET_3_H
