// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Judges every criterion on every triangle and edge of a patch, short ones and those on the boundary included, by the surface
// alone, and compares with the report. It shares no code with the mesher.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_REPORT_AUDIT_H
#define PARAMETRIC_SURFACE_MESHER_TEST_REPORT_AUDIT_H

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel/global_functions_2.h>
#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_report.h>

#include <Mesh_audit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

// What a triangle has, over what it may have: below 1 all is well. What cannot be told to the last bit without the mesher's own
// quantities lies between a lower and an upper bound.
struct Audited_ratio
{
  double lower = 0, upper = 0;

  bool surely_fails() const { return lower > 1 + 1e-6; }
  bool surely_meets() const { return upper < 1 - 1e-6; }

  void add(double low, double high)
  {
    lower = (std::max)(lower, low);
    upper = (std::max)(upper, high);
  }
};

// For a patch without collapsed sides: around these edges are straight in coordinates of the mesher's.
template <class Kernel, class Surface>
class Report_audit
{
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef Mesh_with_domain<Kernel> Result;
  typedef typename Result::Face_index Face_index;
  typedef CGAL::Parametric_surface_mesh_criteria Criteria;
  typedef CGAL::Parametric_surface_mesher::Mesh_criterion Criterion;

  struct Corner
  {
    Point_2 uv;
    Point_3 point;
  };
  typedef std::array<Corner, 3> Triangle;

  const Result& m_result;
  const Surface& m_surface;
  const Criteria& m_criteria;
  const bool m_has_default_metric; // else angles are not those in space
  Audit_findings& m_findings;
  CGAL::Bbox_2 m_box; // of the domain

public:
  Report_audit(const Result& result, const Surface& surface, const Criteria& criteria, bool has_default_metric,
               Audit_findings& findings)
    : m_result(result), m_surface(surface), m_criteria(criteria), m_has_default_metric(has_default_metric), m_findings(findings)
  {}

  void operator()()
  {
    std::set<std::pair<std::size_t, Criterion>> reported;
    std::set<std::size_t> reported_faces;
    for(const auto& unmet : m_result.report.unmet) {
      reported_faces.insert(unmet.face);
      for(const Criterion criterion : CGAL::Parametric_surface_mesher::all_criteria())
        if(unmet.criteria.contains(criterion))
          reported.insert({unmet.face, criterion});
    }
    for(const Face_index f : m_result.mesh.faces())
      for(const Corner& corner : triangle(f))
        m_box += corner.uv.bbox();
    for(const Face_index f : m_result.mesh.faces()) {
      const Triangle t = triangle(f);
      if(m_has_default_metric)
        compare(f, Criterion::ANGLE, angle(t), reported);
      compare(f, Criterion::DEVIATION, deviation(t), reported);
      // A triangle that fails another criterion is not searched for its farthest place.
      if(m_criteria.distance() && reported_faces.count(f) == 0)
        compare(f, Criterion::DISTANCE, distance(t), reported);
    }
  }

private:
  Triangle triangle(Face_index f) const
  {
    const auto h = m_result.halfedges(f);
    Triangle result;
    for(std::size_t i = 0; i < 3; ++i)
      result[i] = {m_result.halfedge_uv[h[i]], m_result.mesh.point(m_result.mesh.target(h[i]))};
    return result;
  }

  void compare(Face_index f, Criterion criterion, const Audited_ratio& ratio,
               const std::set<std::pair<std::size_t, Criterion>>& reported)
  {
    const bool is_reported = reported.count({std::size_t(f), criterion}) > 0;
    if(ratio.surely_fails() && !is_reported)
      m_findings.add("criterion " + std::to_string(int(criterion)) + " fails and is not reported", f, ratio.lower);
    if(ratio.surely_meets() && is_reported)
      m_findings.add("criterion " + std::to_string(int(criterion)) + " is met and reported", f, ratio.upper);
  }

  Audited_ratio angle(const Triangle& t) const
  {
    const double smallest = audited_smallest_angle(t[0].point, t[1].point, t[2].point);
    const double ratio = smallest > 0 ? m_criteria.angle() / smallest : 1e300;
    return {ratio, ratio};
  }

  // Near singular points of the parametrisation only the part of the height along the normal counts.
  Audited_ratio deviation(const Triangle& t) const
  {
    Audited_ratio result;
    if(!m_criteria.distance()) // then it is reported for features between the edges, too
      result.upper = 1e300;
    for(std::size_t i = 0; i < 3; ++i) {
      const Corner &p = t[i], &q = t[(i + 1) % 3];
      const double u = 0.5 * (p.uv.x() + q.uv.x()), v = 0.5 * (p.uv.y() + q.uv.y());
      const auto chord = q.point - p.point, from = m_surface.point(u, v) - p.point;
      const double length = std::sqrt(chord.squared_length());
      if(!(length > 0))
        continue;
      const auto height = from - (from * chord / (length * length)) * chord;
      const auto jet = m_surface.jet(u, v);
      const auto normal = cross_product(jet.du, jet.dv);
      const double size = std::sqrt(normal.squared_length());
      result.add(size > 0 ? std::fabs(height * normal) / size / length / m_criteria.gamma() : 0,
                 std::sqrt(height.squared_length()) / length / m_criteria.gamma());
    }
    return result;
  }

  // The height of the surface over the plane of a triangle, as a multiple of the bound of the distance. What lies beside the triangle
  // is left out: at folds and creases the point of the surface that is nearest to a place of the triangle has other parameters than
  // that place.
  class Height
  {
    const Surface& m_surface;
    const Point_3 m_corner;
    const Vector_3 m_normal;
    const double m_unit;

  public:
    Height(const Surface& surface, const Triangle& t, double bound)
      : m_surface(surface), m_corner(t[0].point), m_normal(cross_product(t[1].point - t[0].point, t[2].point - t[0].point)),
        m_unit(std::sqrt(m_normal.squared_length()) * bound)
    {}

    bool is_known() const { return m_unit > 0; }

    double operator()(double u, double v) const { return std::fabs((m_surface.point(u, v) - m_corner) * m_normal) / m_unit; }
  };

  // The mesher may have looked at places that are farther than those here: what it reports is not called wrong.
  Audited_ratio distance(const Triangle& t) const
  {
    const Height height(m_surface, t, *m_criteria.distance());
    if(!height.is_known())
      return {0, 1e300};
    return {(std::max)(height_nearly_everywhere(t, height), height_of_feature(t, height)), 1e300};
  }

  // What the heights at a fifth of some places exceed, as narrower features are not promised. The mesher looks at fewer places than this:
  // on surfaces whose control points are random, heights between them were up to 1.8 times those at its places.
  static double height_nearly_everywhere(const Triangle& t, const Height& height)
  {
    const int n = 6;
    const double largest_share_missed = 0.2, share_between_samples = 2;
    std::vector<double> heights;
    for(int i = 0; i <= n; ++i)
      for(int k = 0; i + k <= n; ++k) {
        const double a = double(i) / n, b = double(k) / n, c = 1 - a - b;
        heights.push_back(height(a * t[0].uv.x() + b * t[1].uv.x() + c * t[2].uv.x(), a * t[0].uv.y() + b * t[1].uv.y() + c * t[2].uv.y()));
      }
    std::sort(heights.begin(), heights.end());
    return heights[std::size_t((1 - largest_share_missed) * double(heights.size()))] / share_between_samples;
  }

  // The largest height that all of a square in the triangle exceeds, the sides of which are those of the features that are promised to
  // be found: two gaps between the lines on which they are looked for.
  double height_of_feature(const Triangle& t, const Height& height) const
  {
    if(m_criteria.feature_resolution() == 0)
      return 0;
    const double reserve = 1.1; // the box of the domain is that of its boundary's points
    const double u_gap = reserve * m_box.x_span() / double(m_criteria.feature_resolution()),
                 v_gap = reserve * m_box.y_span() / double(m_criteria.feature_resolution());
    const auto us = std::minmax({t[0].uv.x(), t[1].uv.x(), t[2].uv.x()}), vs = std::minmax({t[0].uv.y(), t[1].uv.y(), t[2].uv.y()});
    double highest = 0;
    for(double u = us.first + u_gap; u <= us.second - u_gap; u += u_gap / 4)
      for(double v = vs.first + v_gap; v <= vs.second - v_gap; v += v_gap / 4)
        if(is_square_inside(t, u, v, u_gap, v_gap) && height(u, v) > (std::max)(highest, 1.))
          highest = (std::max)(highest, smallest_height(height, u, v, u_gap, v_gap));
    return highest;
  }

  static bool is_square_inside(const Triangle& t, double u, double v, double u_gap, double v_gap)
  {
    for(const double du : {-u_gap, u_gap})
      for(const double dv : {-v_gap, v_gap})
        for(std::size_t i = 0; i < 3; ++i)
          if(orientation(t[i].uv, t[(i + 1) % 3].uv, Point_2(u + du, v + dv)) != CGAL::LEFT_TURN)
            return false;
    return true;
  }

  static double smallest_height(const Height& height, double u, double v, double u_gap, double v_gap)
  {
    double smallest = height(u, v);
    for(int i = -2; i <= 2; ++i)
      for(int k = -2; k <= 2; ++k)
        smallest = (std::min)(smallest, height(u + 0.5 * i * u_gap, v + 0.5 * k * v_gap));
    return smallest;
  }
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_REPORT_AUDIT_H
