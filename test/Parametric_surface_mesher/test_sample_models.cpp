// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sample models of the example programs: areas, derivatives and how their sides are joined.
#include <gtest/gtest.h>

#include <Sample_models.h>
#include <surface_test_helpers.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

typedef Sample_surface_model::Face Face;

// the rectangle that a face of a sample model lies over
struct Rectangle
{
  double u_min, u_max, v_min, v_max;

  explicit Rectangle(const Face& face)
  {
    const auto& p = face.loops.front().front().curve.source();
    u_min = u_max = p.x(), v_min = v_max = p.y();
    for(const auto& use : face.loops.front())
      for(const auto& q : {use.curve.source(), use.curve.target()}) {
        u_min = (std::min)(u_min, q.x()), u_max = (std::max)(u_max, q.x());
        v_min = (std::min)(v_min, q.y()), v_max = (std::max)(v_max, q.y());
      }
  }
};

// by the midpoint rule
double area(const Face& face)
{
  const int n = 300;
  const Rectangle r(face);
  const double du = (r.u_max - r.u_min) / n, dv = (r.v_max - r.v_min) / n;
  double sum = 0;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const auto jet = face.surface.jet(r.u_min + (i + 0.5) * du, r.v_min + (j + 0.5) * dv);
      sum += std::sqrt(cross_product(jet.du, jet.dv).squared_length());
    }
  return sum * du * dv;
}

} // namespace

TEST(Sample_models, areas)
{
  for(const std::string& name : sample_model_names()) {
    const Sample_model sample = make_sample_model(name);
    double sum = 0;
    for(const Face& face : sample.model.faces())
      sum += area(face);
    EXPECT_NEAR(sum / sample.area, 1, 2e-5) << name;
    EXPECT_NEAR(sample.area, 100 * std::sqrt(3.) / 4 * std::pow(sample.edge_length(100), 2), 1e-9) << name;
  }
}

TEST(Sample_models, derivatives)
{
  for(const std::string& name : sample_model_names()) {
    SCOPED_TRACE(name);
    const Sample_model sample = make_sample_model(name);
    for(const Face& face : sample.model.faces()) {
      const Rectangle r(face);
      for(double s : {0.1, 0.4, 0.7}) // not at the knots of splines
        for(double t : {0.2, 0.6, 0.9})
          check_jet(face.surface, r.u_min + s * (r.u_max - r.u_min), r.v_min + t * (r.v_max - r.v_min));
    }
  }
}

TEST(Sample_models, uses_of_an_edge_are_equal)
{
  for(const std::string& name : sample_model_names()) {
    const Sample_model sample = make_sample_model(name);
    for(double t : {0., 0.3, 0.5, 1.}) {
      std::vector<std::vector<Point_3>> points(sample.model.edges().size());
      for(const Face& face : sample.model.faces())
        for(const auto& use : face.loops.front()) {
          const auto uv = use.curve.point(use.curve.begin() + t * (use.curve.end() - use.curve.begin()));
          points[use.edge].push_back(face.surface.point(uv.x(), uv.y()));
        }
      for(const auto& uses : points)
        for(const Point_3& p : uses)
          expect_near(uses.front(), p, 1e-12, name);
    }
  }
}

TEST(Sample_models, names)
{
  for(const std::string& name : sample_patch_names()) {
    EXPECT_EQ(make_sample(name).name, name);
    EXPECT_THROW(make_sample_model(name), std::invalid_argument);
  }
  for(const std::string& name : sample_model_names())
    EXPECT_EQ(make_sample_model(name).name, name);
  for(const std::string& name : sample_names()) { // the benchmarks take all of them as patches
    EXPECT_EQ(make_sample(name).name, name);
    const std::vector<std::string> all = all_sample_names();
    EXPECT_EQ(std::count(all.begin(), all.end(), name), 1) << name;
  }
}
