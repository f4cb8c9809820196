// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/First_fundamental_form_metric_2.h>
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Principal_curvature_metric_2.h>
#include <CGAL/Triangle_mesh_quality.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <Sample_surfaces.h>
#include <mesher_test_helpers.h>
#include <random_input.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

typedef CGAL::First_fundamental_form_metric_2<Test_kernel> First_form;
typedef CGAL::Principal_curvature_metric_2<Test_kernel> Curvature_metric;
typedef CGAL::Metric_tensor_2 Tensor;

namespace {

const double no_bound = 1e6;

const auto ellipsoid_function = [](auto u, auto v) {
  using std::cos;
  using std::sin;
  return CGAL::parametric_surface_point(3 * cos(u) * cos(v), 2 * sin(u) * cos(v), sin(v));
};

const auto saddle_function = [](auto u, auto v) {
  return CGAL::parametric_surface_point(u, v, 0.5 * (u * u - 3 * v * v));
};

void expect_near(const Tensor& expected, const Tensor& found, double tolerance, const std::string& where)
{
  EXPECT_NEAR(expected.e(), found.e(), tolerance * expected.trace()) << where;
  EXPECT_NEAR(expected.f(), found.f(), tolerance * expected.trace()) << where;
  EXPECT_NEAR(expected.g(), found.g(), tolerance * expected.trace()) << where;
}

// The pull-back of the ellipse with half axes of ratio `k`, its major axis over the domain direction `along`. Domain
// directions `along` and `across` are perpendicular and of length 1 on the surface.
Tensor pull_back(const Vector_2& along, const Vector_2& across, double k)
{
  // M = A^-T diag(1/k, k) A^-1 for the matrix A of the two columns
  const double d = along.x() * across.y() - along.y() * across.x();
  const Vector_2 p(across.y() / d, -across.x() / d), q(-along.y() / d, along.x() / d);
  return Tensor(p.x() * p.x() / k + k * q.x() * q.x(), p.x() * p.y() / k + k * q.x() * q.y(),
                p.y() * p.y() / k + k * q.y() * q.y());
}

template <class Surface>
void check_first_form(const Surface& surface)
{
  Random_input random(1);
  for(int i = 0; i < 200; ++i) {
    const double u = random.real(-1, 1), v = random.real(-1, 1), h = 1e-5;
    const Vector_3 du = (surface.point(u + h, v) - surface.point(u - h, v)) / (2 * h),
                   dv = (surface.point(u, v + h) - surface.point(u, v - h)) / (2 * h);
    expect_near(Tensor(du * du, du * dv, dv * dv), First_form().tensor(surface.jet(u, v)), 1e-8,
                std::to_string(u) + ", " + std::to_string(v));
  }
}

// the area of the surface is kept: the determinant is that of the first fundamental form
template <class Surface>
void check_area(const Surface& surface, const Curvature_metric& metric)
{
  Random_input random(2);
  for(int i = 0; i < 200; ++i) {
    const auto jet = surface.jet(random.real(-1, 1), random.real(-1, 1));
    const Tensor tensor = metric.tensor(jet);
    EXPECT_TRUE(tensor.is_positive_definite());
    EXPECT_NEAR(1, tensor.determinant() / First_form().tensor(jet).determinant(), 1e-9);
  }
}

// The tensor of `S(f(x,y))` is that of `S` pulled back by the derivative of f, for a map f that is not linear.
template <class Function, class Metric>
void check_reparametrisation(const Function& function, const Metric& metric)
{
  const auto surface = CGAL::make_parametric_function_surface(function);
  const auto other = CGAL::make_parametric_function_surface([function](auto x, auto y) {
    using std::sin;
    return function(2 * x + y + 0.3 * sin(y), 0.5 * y - 0.2 * x * x);
  });
  Random_input random(3);
  for(int i = 0; i < 200; ++i) {
    const double x = random.real(-0.5, 0.5), y = random.real(-0.5, 0.5);
    const Tensor m = metric.tensor(surface.jet(2 * x + y + 0.3 * std::sin(y), 0.5 * y - 0.2 * x * x));
    const double a = 2, b = 1 + 0.3 * std::cos(y), c = -0.4 * x, d = 0.5;
    const double mixed = m.e() * a * b + m.f() * (a * d + b * c) + m.g() * c * d;
    expect_near(Tensor(m.squared_length(a, c), mixed, m.squared_length(b, d)), metric.tensor(other.jet(x, y)), 1e-7,
                std::to_string(x) + ", " + std::to_string(y));
  }
}

// a field written by a user: lengths along z count four times as much
struct Vertical_metric
{
  Tensor tensor(const CGAL::Surface_jet_3<Test_kernel>& jet) const
  {
    const double zu = jet.du.z(), zv = jet.dv.z();
    return Tensor(jet.du * jet.du + 15 * zu * zu, jet.du * jet.dv + 15 * zu * zv, jet.dv * jet.dv + 15 * zv * zv);
  }

  double squared_length(const CGAL::Parametric_point_2<Test_kernel>& p,
                        const CGAL::Parametric_point_2<Test_kernel>& q) const
  {
    const Vector_3 d = q.surface_point() - p.surface_point();
    return d.squared_length() + 15 * d.z() * d.z();
  }
};

// lengths by the mean of the tensors at the ends
struct Mean_length
{
  double squared_length(const CGAL::Parametric_point_2<Test_kernel>& p,
                        const CGAL::Parametric_point_2<Test_kernel>& q) const
  {
    return (0.5 * (p.tensor() + q.tensor())).squared_length(q.x() - p.x(), q.y() - p.y());
  }
};

// a tensor inside a disc, the identity outside
struct Disc_metric : Mean_length
{
  Tensor inside;

  explicit Disc_metric(const Tensor& within) : inside(within) {}

  Tensor tensor(const CGAL::Surface_jet_3<Test_kernel>& jet) const
  {
    return std::hypot(jet.point.x() - 0.5, jet.point.y() - 0.5) < 0.3 ? inside : Tensor();
  }
};

// twice as long on the right half of the domain, whatever the surface is
struct Halves_metric : Mean_length
{
  Tensor tensor(const CGAL::Surface_jet_3<Test_kernel>& jet, double u, double) const
  {
    return (u > 0.5 ? 4. : 1.) * First_form().tensor(jet);
  }
};

// lengths that a user has got wrong
struct Negative_length : First_form
{
  double squared_length(const CGAL::Parametric_point_2<Test_kernel>&, const CGAL::Parametric_point_2<Test_kernel>&) const
  {
    return -1;
  }
};

Domain unit_square() { return Domain::rectangle(0, 1, 0, 1); }

Criteria at_most_20000_vertices() { return Criteria().set_max_edge(0.05).set_min_edge(0.001).set_max_number_of_vertices(20000); }

// Expects the eigenvectors of `m`, and the absolute values of its eigenvalues, or `least` where they are smaller.
void check_replaced(const Tensor& m, double least)
{
  const auto replaced = CGAL::Parametric_surface_mesher::internal::regular_tensor(m);
  EXPECT_TRUE(replaced.is_replaced);
  EXPECT_TRUE(replaced.tensor.is_positive_definite());
  Eigen::Matrix2d before, after;
  before << m.e(), m.f(), m.f(), m.g();
  after << replaced.tensor.e(), replaced.tensor.f(), replaced.tensor.f(), replaced.tensor.g();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(before);
  const double size = eigen.eigenvalues().cwiseAbs().maxCoeff();
  const Eigen::Matrix2d expected
    = eigen.eigenvectors() * eigen.eigenvalues().cwiseAbs().cwiseMax(least).asDiagonal() * eigen.eigenvectors().transpose();
  EXPECT_LE((after - expected).norm(), 1e-9 * size);
  EXPECT_EQ(eigen.eigenvalues().cwiseAbs().minCoeff() < least, replaced.is_singular);
}

} // namespace

TEST(Metric_tensors, replaced)
{
  Random_input random(11);
  for(int i = 0; i < 1000; ++i) {
    const double alpha = random.real(-2, 2), large = random.real(1, 2), small = random.real(-2, 0);
    const double scale = std::pow(10, random.real(-80, 80)), c = std::cos(alpha), s = std::sin(alpha);
    const auto turned = [&](double a, double b) { // with these eigenvalues
      return Tensor(scale * (a * c * c + b * s * s), scale * (a - b) * s * c, scale * (a * s * s + b * c * c));
    };
    check_replaced(turned(large, small), scale * 1e-6 * (std::max)(large, -small));
    check_replaced(turned(-large, small), scale * 1e-6 * (std::max)(large, -small));
    const Tensor regular = turned(large, 0.5 - 0.2 * small);
    EXPECT_EQ(regular, CGAL::Parametric_surface_mesher::internal::regular_tensor(regular).tensor);
  }
  for(const Tensor& tensor : {Tensor(0, 0, 0), Tensor(1e-310, 0, 0), Tensor(-1e-120, 1e-130, 0)}) {
    const auto replaced = CGAL::Parametric_surface_mesher::internal::regular_tensor(tensor);
    EXPECT_TRUE(replaced.tensor.is_positive_definite());
    EXPECT_TRUE(replaced.is_singular);
  }
}

TEST(User_metric_field, tensors_that_are_not_positive_definite)
{
  for(const Tensor& inside : {Tensor(1, 1.5, 1), Tensor(-1, 0, 1), Tensor(-1, 0, -1), Tensor(0, 1, 0), Tensor(-1e-3, 2, 5)}) {
    Mesh mesh;
    const auto report = add_patch(make_sample("flat").surface, unit_square(), at_most_20000_vertices(), mesh,
                                  CGAL::parameters::metric_field(Disc_metric(inside)));
    EXPECT_GT(report.number_of_replaced_tensors, 10u) << inside.f();
    EXPECT_LT(report.number_of_vertices, 20000u);
    EXPECT_EQ(0u, number_of_inverted_faces(mesh));
  }
}

TEST(User_metric_field, tensors_without_a_size)
{
  Mesh mesh;
  const auto report = add_patch(make_sample("flat").surface, unit_square(), at_most_20000_vertices(), mesh,
                                CGAL::parameters::metric_field(Disc_metric(Tensor(0, 0, 0))));
  EXPECT_EQ(0u, number_of_inverted_faces(mesh));
  EXPECT_LE(report.number_of_vertices, 20000u);
  for(double size : {1e151, std::numeric_limits<double>::infinity()})
    expect_refused([&] {
      add_patch(make_sample("flat").surface, unit_square(), at_most_20000_vertices(), mesh,
                CGAL::parameters::metric_field(Disc_metric(Tensor(size, 0, size))));
    }, "metric tensor", size < 1e200 ? "too large" : "not finite", "(u,v) = (0.");
}

TEST(User_metric_field, lengths_that_are_negative)
{
  Mesh mesh;
  expect_refused([&] {
    add_patch(make_sample("flat").surface, unit_square(), at_most_20000_vertices(), mesh,
              CGAL::parameters::metric_field(Negative_length()));
  }, "squared length", "metric field", "and is -1");
  EXPECT_EQ(0u, mesh.number_of_faces());
}

// The metric does not see sizes of the surface but lengths four times as large on one half: smaller triangles there.
TEST(User_metric_field, sees_the_parameters)
{
  Mesh mesh;
  const auto report = add_patch(make_sample("flat").surface, unit_square(), Criteria().set_max_edge(0.05).set_min_edge(0.001),
                                mesh, CGAL::parameters::metric_field(Halves_metric()));
  EXPECT_EQ(0u, report.number_of_replaced_tensors);
  double left = 0, right = 0;
  for(const auto v : mesh.vertices())
    ++(mesh.point(v).x() > 0.5 ? right : left);
  EXPECT_GT(right, 2.5 * left);
  EXPECT_LT(right, 5 * left);
}

TEST(First_fundamental_form_metric, finite_differences)
{
  check_first_form(CGAL::Parametric_torus_3<Test_kernel>(2, 0.7));
  check_first_form(CGAL::make_parametric_function_surface(ellipsoid_function));
  check_first_form(CGAL::make_parametric_function_surface(saddle_function));
  check_first_form(sample_surfaces::Skew());
}

TEST(First_fundamental_form_metric, length_is_that_of_the_chord)
{
  const CGAL::Parametric_point_2<Test_kernel> p(Point_2(0, 0), Point_3(1, 2, 3), Tensor()),
    q(Point_2(9, 9), Point_3(3, 5, 9), Tensor());
  EXPECT_EQ(49, First_form().squared_length(p, q));
}

TEST(First_fundamental_form_metric, reparametrisation)
{
  check_reparametrisation(ellipsoid_function, First_form());
}

TEST(Principal_curvature_metric, cylinder_has_the_bound_along_its_lines)
{
  const CGAL::Parametric_cylinder_3<Test_kernel> cylinder(0.5);
  for(double bound : {1., 4., 10.})
    expect_near(pull_back(Vector_2(0, 1), Vector_2(2, 0), bound), Curvature_metric(bound).tensor(cylinder.jet(0.3, 7)), 1e-12,
                "cylinder");
}

TEST(Principal_curvature_metric, torus)
{
  const double large = 2, small = 0.5;
  const CGAL::Parametric_torus_3<Test_kernel> torus(large, small);
  for(double v : {0., 0.4, 1.2, 2.5, 3.1}) {
    const double across = large + small * std::cos(v); // curvatures 1/small along v, cos(v)/across along u
    const double k = across / (small * std::fabs(std::cos(v)));
    expect_near(pull_back(Vector_2(1 / across, 0), Vector_2(0, 1 / small), k),
                Curvature_metric(no_bound).tensor(torus.jet(1, v)), 1e-9, std::to_string(v));
  }
}

TEST(Principal_curvature_metric, ellipsoid_on_its_plane_of_symmetry)
{
  // x^2/9 + y^2/4 + z^2 = 1 at v = 0: curvature ab/q^3 along the ellipse, ab/(q c^2) across, with q = |dS/du|
  const auto ellipsoid = CGAL::make_parametric_function_surface(ellipsoid_function);
  for(double u : {0., 0.5, 1., 1.5}) {
    const double q = std::sqrt(9 * std::sin(u) * std::sin(u) + 4 * std::cos(u) * std::cos(u));
    expect_near(pull_back(Vector_2(1 / q, 0), Vector_2(0, 1), q * q), Curvature_metric(no_bound).tensor(ellipsoid.jet(u, 0)),
                1e-9, std::to_string(u));
  }
}

TEST(Principal_curvature_metric, saddle)
{
  const auto saddle = CGAL::make_parametric_function_surface(saddle_function);
  expect_near(pull_back(Vector_2(1, 0), Vector_2(0, 1), 3), Curvature_metric(no_bound).tensor(saddle.jet(0, 0)), 1e-12,
              "the curvatures 1 and -3");
}

TEST(Principal_curvature_metric, umbilics_and_flat_points)
{
  const Curvature_metric metric(4);
  const CGAL::Parametric_sphere_3<Test_kernel> sphere(2);
  const CGAL::Parametric_plane_3<Test_kernel> plane(Point_3(0, 0, 0), Vector_3(3, 0, 0), Vector_3(1, 1, 1));
  const sample_surfaces::Paraboloid paraboloid;
  Random_input random(4);
  for(int i = 0; i < 100; ++i) {
    const double u = random.real(-1, 1), v = random.real(-1, 1);
    expect_near(First_form().tensor(sphere.jet(u, v)), metric.tensor(sphere.jet(u, v)), 1e-6, "sphere");
    expect_near(First_form().tensor(plane.jet(u, v)), metric.tensor(plane.jet(u, v)), 1e-12, "plane");
    // k is 1 + r^2 on the paraboloid: continuous at its umbilic
    expect_near(First_form().tensor(paraboloid.jet(0, 0)), metric.tensor(paraboloid.jet(1e-3 * u, 1e-3 * v)), 1e-5,
                "paraboloid");
  }
}

TEST(Principal_curvature_metric, bound_of_the_ratio)
{
  EXPECT_EQ(4, Curvature_metric().max_ratio());
  const sample_surfaces::Peak peak;
  Random_input random(5);
  for(int i = 0; i < 1000; ++i) {
    const double ratio = Curvature_metric(2.5).ratio(
      CGAL::Surface_curvature_3<Test_kernel>(peak.jet(random.real(-0.4, 0.4), random.real(-0.4, 0.4))));
    EXPECT_GE(ratio, 1);
    EXPECT_LE(ratio, 2.5);
  }
}

TEST(Principal_curvature_metric, area)
{
  check_area(CGAL::Parametric_torus_3<Test_kernel>(2, 0.7), Curvature_metric(5));
  check_area(CGAL::make_parametric_function_surface(ellipsoid_function), Curvature_metric(no_bound));
  check_area(CGAL::make_parametric_function_surface(saddle_function), Curvature_metric(4));
  check_area(sample_surfaces::Skew(), Curvature_metric(4));
}

TEST(Principal_curvature_metric, reparametrisation)
{
  check_reparametrisation(ellipsoid_function, Curvature_metric(50));
  check_reparametrisation(saddle_function, Curvature_metric(4));
}

TEST(Principal_curvature_metric, stretches_triangles_along_the_cylinder)
{
  const Sample cyl = make_sample("cyl");
  Mesh mesh;
  const auto report = add_patch(cyl.surface, cyl.domain, Criteria().set_max_edge(0.1).set_min_edge(0.01), mesh,
                                CGAL::parameters::metric_field(Curvature_metric(4)));
  EXPECT_GT(report.number_of_faces, 1000u);
  EXPECT_EQ(0u, number_of_inverted_faces(mesh));
  double along = 0, around = 0;
  for(const auto e : mesh.edges()) {
    const Vector_3 d = mesh.point(mesh.vertex(e, 1)) - mesh.point(mesh.vertex(e, 0));
    along += d.z() * d.z();
    around += d.x() * d.x() + d.y() * d.y();
  }
  EXPECT_GT(along, 4 * around); // 16 without the fixed boundary
}

TEST(User_metric_field, decides_the_shape)
{
  const Sample skew = make_sample("skew");
  Mesh mesh;
  const auto report = add_patch(skew.surface, skew.domain, Criteria().set_max_edge(0.1).set_min_edge(0.01), mesh,
                                CGAL::parameters::metric_field(Vertical_metric()));
  EXPECT_EQ(0u, number_of_inverted_faces(mesh));
  // in the space stretched along z the triangles meet the angle
  Mesh stretched = mesh;
  for(const auto v : stretched.vertices()) {
    const Point_3 p = mesh.point(v);
    stretched.point(v) = Point_3(p.x(), p.y(), 4 * p.z());
  }
  const auto unmet = unmet_by_face(report);
  // all because of the boundary, which is divided without this metric
  EXPECT_EQ(unmet.size(), report.count(CGAL::Parametric_surface_mesher::Unmet_cause::BOUNDARY));
  EXPECT_LE(unmet.size(), mesh.number_of_faces() / 50);
  for(const auto f : stretched.faces())
    EXPECT_TRUE(unmet.count(f) == 1 || shape(stretched, f).min_angle >= 30 - 1e-9) << f;
}
