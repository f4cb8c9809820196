// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shapes on which meshers are compared. Each is there twice: as parametric surfaces, and as the zero set of a function for meshers
// that have no parameters to mesh in.
#ifndef COMPARISON_SHAPE_H
#define COMPARISON_SHAPE_H

#include "Sample_models.h"
#include "cgal_meshers.h"

#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Parametric_surface_mesher/orient_faces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

struct Comparison_shape
{
  std::string name;
  Sample_surface_model model;
  double area;
  cgal_meshers::Distance distance; // signed, negative inside
  double smallest_radius;          // of curvature
  std::vector<double> rims = {};   // sharp edges: circles around the z axis with the radius 1 at these heights

  double edge_length(double number_of_triangles) const { return sample_surfaces::edge_length(area, number_of_triangles); }
};

namespace comparison_shapes {

const double height_of_tin = 1;

inline Sample_surface lid_of_tin(double height)
{
  return Sample_surface(CGAL::Parametric_plane_3<Sample_kernel>(Sample_surface::Point_3(0, 0, height), {1, 0, 0}, {0, 1, 0}));
}

// A cylinder that closes on itself along a seam, and two lids, as CAD programs make them.
inline Sample_surface_model tin()
{
  typedef Sample_surface_model::Curve Curve;
  typedef Curve::Point_2 Point_2;
  const double turn = 2 * sample_surfaces::pi;
  Sample_surface_model model;
  const std::size_t below = model.add_vertex({1, 0, 0}), above = model.add_vertex({1, 0, height_of_tin});
  const std::size_t bottom = model.add_edge(below, below), top = model.add_edge(above, above), seam = model.add_edge(below, above);
  const Point_2 a(0, 0), b(turn, 0), c(turn, height_of_tin), d(0, height_of_tin);
  model.add_face({Sample_surface(CGAL::Parametric_cylinder_3<Sample_kernel>(1)),
                  {{{bottom, false, Curve::segment(a, b)},
                    {seam, false, Curve::segment(b, c)},
                    {top, true, Curve::segment(d, c)},
                    {seam, true, Curve::segment(a, d)}}}});
  const Curve circle = Curve::from_function([turn](auto t) {
    using std::cos;
    using std::sin;
    return std::make_pair(cos(turn * t), sin(turn * t));
  }, 0, 1);
  model.add_face({lid_of_tin(0), {{{bottom, false, circle}}}});
  model.add_face({lid_of_tin(height_of_tin), {{{top, false, circle}}}});
  CGAL::Parametric_surface_mesher::orient_faces(model);
  return model;
}

inline double distance_to_tin(const cgal_meshers::Point_3& p)
{
  const double beside = std::hypot(p.x(), p.y()) - 1, above = std::abs(p.z() - height_of_tin / 2) - height_of_tin / 2;
  if(beside > 0 && above > 0)
    return std::hypot(beside, above);
  return (std::max)(beside, above);
}

} // namespace comparison_shapes

inline std::vector<Comparison_shape> comparison_shapes_of_space()
{
  using namespace comparison_shapes;
  std::vector<Comparison_shape> shapes;
  for(const char* name : {"sphere", "torus"}) {
    const Sample_model sample = make_sample_model(name);
    shapes.push_back({name, sample.model, sample.area, cgal_meshers::distance_to(name), std::string(name) == "torus" ? 0.3 : 1});
  }
  const double area = (2 + 2 * height_of_tin) * sample_surfaces::pi;
  shapes.push_back({"tin", tin(), area, distance_to_tin, 1, {0, height_of_tin}});
  return shapes;
}

#endif // COMPARISON_SHAPE_H
