// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The named models of the example programs, with their areas: surfaces closed by their seams and poles, or of several faces.
#ifndef SAMPLE_MODELS_H
#define SAMPLE_MODELS_H

#include "Sample_surfaces.h"

#include <CGAL/B_spline_surface_3.h>
#include <CGAL/Bezier_surface_3.h>
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Rectangular_patch_3.h>
#include <CGAL/make_model_of_rectangular_patches.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

typedef CGAL::Parametric_surface_model_3<Sample_surface> Sample_surface_model;

struct Sample_model
{
  std::string name;
  Sample_surface_model model;
  double area;

  double edge_length(double number_of_triangles) const
  {
    return sample_surfaces::edge_length(area, number_of_triangles);
  }
};

namespace sample_surfaces {

typedef CGAL::Rectangular_patch_3<Sample_surface> Patch;

// the patch over the domain of a sample, which is a rectangle
inline Patch whole_patch(const Sample& sample)
{
  const Domain::Loop& sides = sample.domain.loops().front();
  const Domain::Point_2 low = sides[0].source(), high = sides[2].source();
  return Patch(sample.surface, low.x(), high.x(), low.y(), high.y());
}

// (v cos u, v sin u, 0), which faces downward
struct Disk : From_jet<Disk>
{
  Jet jet(double u, double v) const
  {
    const double c = std::cos(u), s = std::sin(u);
    const Vector_3 outward(c, s, 0), along(-s, c, 0);
    return {Point_3(v * c, v * s, 0), v * along, outward, -v * outward, along, Vector_3(0, 0, 0)};
  }
};

inline std::vector<Patch> sphere() { return {whole_patch(make_sample("sphere"))}; }

inline std::vector<Patch> torus() { return {whole_patch(make_sample("torus"))}; }

inline std::vector<Patch> cylinder() { return {whole_patch(make_sample("cyl"))}; }

// the cone over the unit disk with the apex (0,0,2), and the disk
inline std::vector<Patch> cone()
{
  const CGAL::Parametric_cone_3<Sample_kernel> side(1, -std::atan(0.5));
  return {Patch(Sample_surface(side), 0, 2 * pi, 0, std::sqrt(5.)), Patch(Sample_surface(Disk()), 0, 2 * pi, 0, 1)};
}

// The profile turned about the z axis has a round bottom, a belly, a neck and an open rim.
inline std::vector<Patch> vase()
{
  const auto surface = CGAL::make_parametric_function_surface<Sample_kernel>([](auto u, auto v) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const auto radius = 0.45 * sin(2 * v) + 0.28 * v;
    return CGAL::parametric_surface_point(radius * cos(u), radius * sin(u), sqrt(v * v + 0.25) - 0.5);
  });
  return {Patch(Sample_surface(surface), 0, 2 * pi, 0, 2.75)};
}

// The torus with the radii 1 and 0.4 as a rational surface: a circle is four arcs of degree 2, its control points lie on a
// square. The knots are those of creases, but there is none.
inline std::vector<Patch> ring()
{
  const std::array<int, 9> x = {1, 1, 0, -1, -1, -1, 0, 1, 1}, y = {0, 1, 1, 1, 0, -1, -1, -1, 0};
  const std::vector<double> knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
  const auto weight = [](int i) { return i % 2 == 0 ? 1 : std::sqrt(0.5); };
  std::vector<Point_3> points;
  std::vector<double> weights;
  for(int j = 0; j < 9; ++j)
    for(int i = 0; i < 9; ++i) {
      const double radius = 1 + 0.4 * x[j];
      points.emplace_back(radius * x[i], radius * y[i], 0.4 * y[j]);
      weights.push_back(weight(i) * weight(j));
    }
  const CGAL::B_spline_surface_3<Sample_kernel> surface(2, 2, knots, knots, points, weights);
  return {Patch(Sample_surface(surface), surface.u_min(), surface.u_max(), surface.v_min(), surface.v_max())};
}

// The block [0,1.5] x [0,1] x [0,0.75]. All sides face along the axes: the model has to turn three of them over.
inline std::vector<Patch> box()
{
  const std::array<double, 3> size = {1.5, 1, 0.75};
  std::vector<Patch> sides;
  for(int axis = 0; axis < 3; ++axis)
    for(double level : {size[axis], 0.}) {
      const int a = (axis + 1) % 3, b = (axis + 2) % 3;
      std::vector<Point_3> corners;
      for(double y : {0., size[b]})
        for(double x : {0., size[a]}) {
          std::array<double, 3> p;
          p[axis] = level, p[a] = x, p[b] = y;
          corners.emplace_back(p[0], p[1], p[2]);
        }
      sides.emplace_back(Sample_surface(CGAL::Bezier_surface_3<Sample_kernel>(1, 1, corners)), 0, 1, 0, 1);
    }
  return sides;
}

struct Model_entry
{
  std::string name;
  std::vector<Patch> (*make_patches)();
  double area;
};

// Whatever names a model takes it from here.
inline const std::vector<Model_entry>& model_entries()
{
  static const std::vector<Model_entry> entries = {{"sphere", sphere, 4 * pi},
                                                   {"torus", torus, 1.2 * pi * pi},
                                                   {"cyl", cylinder, 4 * pi},
                                                   {"cone", cone, (1 + std::sqrt(5.)) * pi},
                                                   {"vase", vase, 7.2985925},
                                                   {"ring", ring, 1.6 * pi * pi},
                                                   {"box", box, 6.75}};
  return entries;
}

} // namespace sample_surfaces

// The model with surfaces of the type of the samples, so that the mesher is compiled once for all of them.
template <class Surface>
Sample_surface_model sample_surface_model(const CGAL::Parametric_surface_model_3<Surface>& model)
{
  Sample_surface_model result;
  for(const auto& vertex : model.vertices())
    result.add_vertex(vertex);
  for(const auto& edge : model.edges())
    result.add_edge(edge.source, edge.target, edge.is_collapsed);
  for(const auto& face : model.faces()) {
    Sample_surface_model::Face copy{Sample_surface(face.surface), {}, face.is_reversed};
    for(const auto& loop : face.loops) {
      copy.loops.emplace_back();
      for(const auto& use : loop)
        copy.loops.back().push_back({use.edge, use.is_reversed, use.curve});
    }
    result.add_face(copy);
  }
  return result;
}

inline std::vector<std::string> sample_model_names()
{
  std::vector<std::string> names;
  for(const auto& entry : sample_surfaces::model_entries())
    names.push_back(entry.name);
  return names;
}

// The samples of a single patch that are no models as well.
inline std::vector<std::string> sample_patch_names()
{
  const std::vector<std::string> models = sample_model_names();
  std::vector<std::string> names;
  for(const std::string& name : sample_names())
    if(std::find(models.begin(), models.end(), name) == models.end())
      names.push_back(name);
  return names;
}

inline std::vector<std::string> all_sample_names()
{
  std::vector<std::string> names = sample_patch_names();
  for(const std::string& name : sample_model_names())
    names.push_back(name);
  return names;
}

// The model with this name; throws std::invalid_argument if there is none.
inline Sample_model make_sample_model(const std::string& name)
{
  for(const auto& entry : sample_surfaces::model_entries())
    if(entry.name == name) {
      const auto model = CGAL::make_model_of_rectangular_patches(entry.make_patches());
      return {name, sample_surface_model(model), entry.area};
    }
  throw std::invalid_argument("no sample model is called '" + name + "'");
}

#endif // SAMPLE_MODELS_H
