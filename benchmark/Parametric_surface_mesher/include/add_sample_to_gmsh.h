// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sample surfaces in the geometry kernel of Gmsh, which is Open CASCADE: exact where that has such a surface, else the
// bicubic B-spline surface through the points of a grid.
#ifndef ADD_SAMPLE_TO_GMSH_H
#define ADD_SAMPLE_TO_GMSH_H

#include "Sample_surfaces.h"

#include <CGAL/Bbox_2.h>

#include <Eigen/Core>
#include <gmsh.h>
#include <unsupported/Eigen/Splines>

#include <cmath>
#include <string>
#include <vector>

namespace gmsh_geometry {

typedef Eigen::Spline<double, Eigen::Dynamic> Spline;

const int degree = 3;
const int points_per_side = 101; // the samples are met within 1e-5

// Knots as Gmsh wants them, once each.
struct Knots
{
  std::vector<double> values;
  std::vector<int> multiplicities;
};

// knots from 0 to 1, to go from `low` to `high`
inline Knots knots(const Spline& spline, double low, double high)
{
  Knots result;
  for(Eigen::Index i = degree; i < spline.knots().size() - degree; ++i) {
    result.values.push_back(low + (high - low) * spline.knots()[i]);
    result.multiplicities.push_back(1);
  }
  result.multiplicities.front() = result.multiplicities.back() = degree + 1;
  return result;
}

// the cubic spline through the columns of a matrix, at parameters of equal distance
inline Spline interpolating_spline(const Eigen::MatrixXd& columns)
{
  const Spline::KnotVectorType parameters = Spline::KnotVectorType::LinSpaced(columns.cols(), 0, 1);
  return Eigen::SplineFitting<Spline>::Interpolate(columns, degree, parameters);
}

// the rectangle around the domain, whose curves are straight but for holes
inline CGAL::Bbox_2 outer_rectangle(const Sample& sample)
{
  CGAL::Bbox_2 result;
  for(const auto& curve : sample.domain.loops().front())
    result += curve.source().bbox();
  return result;
}

inline bool is_rectangle(const sample_surfaces::Domain& domain)
{
  for(const auto& curve : domain.loops().front())
    if(curve.source().x() != curve.target().x() && curve.source().y() != curve.target().y())
      return false;
  return domain.loops().size() == 1;
}

// A loop in the parameter plane: a full circle if it is a single curve, else a polygon.
inline int add_loop(const sample_surfaces::Domain::Loop& loop)
{
  namespace occ = gmsh::model::occ;
  const auto& first = loop.front();
  if(loop.size() == 1) {
    const auto opposite = first.point((first.begin() + first.end()) / 2);
    const auto center = CGAL::midpoint(first.source(), opposite);
    const double radius = std::sqrt(CGAL::squared_distance(first.source(), opposite)) / 2;
    return occ::addWire({occ::addCircle(center.x(), center.y(), 0, radius)});
  }
  std::vector<int> corners, sides;
  for(const auto& curve : loop)
    corners.push_back(occ::addPoint(curve.source().x(), curve.source().y(), 0));
  for(std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back(occ::addLine(corners[i], corners[(i + 1) % corners.size()]));
  return occ::addWire(sides);
}

inline std::vector<int> add_loops(const sample_surfaces::Domain& domain)
{
  std::vector<int> result;
  if(!is_rectangle(domain))
    for(const auto& loop : domain.loops())
      result.push_back(add_loop(loop));
  return result;
}

// Adds the B-spline surface over the rectangle around the domain, trimmed by the loops of the domain.
inline void add_b_spline_surface(const Sample& sample)
{
  const CGAL::Bbox_2 box = outer_rectangle(sample);
  const int n = points_per_side;
  Eigen::MatrixXd coordinates(3 * n, n), along_u(3 * n, n); // three rows for each v, a column for each u
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      const auto p = sample.surface.point(box.xmin() + (box.xmax() - box.xmin()) * i / (n - 1),
                                          box.ymin() + (box.ymax() - box.ymin()) * j / (n - 1));
      coordinates.block<3, 1>(3 * j, i) << p.x(), p.y(), p.z();
    }
  const Spline u_spline = interpolating_spline(coordinates);
  for(int j = 0; j < n; ++j) // now three rows for each u, a column for each v
    for(int i = 0; i < n; ++i)
      along_u.block<3, 1>(3 * i, j) = u_spline.ctrls().matrix().block<3, 1>(3 * j, i);
  const Spline v_spline = interpolating_spline(along_u);

  std::vector<int> points;
  for(int j = 0; j < n; ++j)
    for(int i = 0; i < n; ++i) {
      const Eigen::Vector3d p = v_spline.ctrls().matrix().block<3, 1>(3 * i, j);
      points.push_back(gmsh::model::occ::addPoint(p.x(), p.y(), p.z()));
    }
  const Knots u = knots(u_spline, box.xmin(), box.xmax()), v = knots(v_spline, box.ymin(), box.ymax());
  const std::vector<int> loops = add_loops(sample.domain);
  gmsh::model::occ::addBSplineSurface(points, n, -1, degree, degree, {}, u.values, v.values, u.multiplicities,
                                      v.multiplicities, loops);
}

// a plane, a quarter of a cylinder, and a plane
inline void add_bend()
{
  namespace occ = gmsh::model::occ;
  const double r = sample_surfaces::Bend::radius, begin = 1 - r * sample_surfaces::pi / 4;
  const int p = occ::addPoint(0, 0, 0), q = occ::addPoint(begin, 0, 0), center = occ::addPoint(begin, 0, r),
            s = occ::addPoint(begin + r, 0, r), t = occ::addPoint(begin + r, 0, r + begin);
  gmsh::vectorpair ignored;
  occ::extrude({{1, occ::addLine(p, q)}, {1, occ::addCircleArc(q, center, s)}, {1, occ::addLine(s, t)}}, 0, 1, 0, ignored);
}

// an arc of a meridian, turned about the axis
inline void add_cap()
{
  namespace occ = gmsh::model::occ;
  const double pi = sample_surfaces::pi;
  const int arc = occ::addCircle(0, 0, 0, 1, -1, -pi / 4, pi / 4);
  gmsh::vectorpair ignored;
  occ::rotate({{1, arc}}, 0, 0, 0, 1, 0, 0, pi / 2);
  occ::revolve({{1, arc}}, 0, 0, 0, 0, 0, 1, pi / 2, ignored);
}

inline void add_cylinder()
{
  gmsh::vectorpair ignored;
  gmsh::model::occ::extrude({{1, gmsh::model::occ::addCircle(0, 0, 0, 1)}}, 0, 0, 2, ignored);
}

inline void add_surface(const Sample& sample)
{
  namespace occ = gmsh::model::occ;
  if(sample.name == "flat")
    occ::addRectangle(0, 0, 0, 1, 1);
  else if(sample.name == "bend")
    add_bend();
  else if(sample.name == "cap")
    add_cap();
  else if(sample.name == "sphere")
    occ::addSphere(0, 0, 0, 1);
  else if(sample.name == "torus")
    occ::addTorus(0, 0, 0, 1, 0.3);
  else if(sample.name == "cyl")
    add_cylinder();
  else
    add_b_spline_surface(sample);
}

} // namespace gmsh_geometry

// Adds the sample to the current model of Gmsh.
inline void add_sample_to_gmsh(const Sample& sample)
{
  gmsh_geometry::add_surface(sample);
  gmsh::model::occ::synchronize();
}

#endif // ADD_SAMPLE_TO_GMSH_H
