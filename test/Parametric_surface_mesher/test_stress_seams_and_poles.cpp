// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stress tests: surfaces that close on themselves along seams, and surfaces of revolution with their poles.
#include <gtest/gtest.h>

#include <random_patches.h>
#include <stress_test_helpers.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace {

// what a mesh must be, whatever its size
struct Expected
{
  std::vector<Surface_integrals> faces;
  std::size_t border_cycles;
  std::ptrdiff_t euler_characteristic;

  double area() const
  {
    return std::accumulate(faces.begin(), faces.end(), 0., [](double sum, const auto& face) { return sum + face.area; });
  }

  double volume() const
  {
    return std::fabs(
      std::accumulate(faces.begin(), faces.end(), 0., [](double sum, const auto& face) { return sum + face.volume; }));
  }

  double number_of_triangles(const Report& report, double gamma) const
  {
    double result = 0;
    for(const Surface_integrals& face : faces)
      result += face.number_of_triangles(report.max_edge, report.min_edge, gamma);
    return result;
  }
};

Expected expected_of(const std::vector<Patch>& patches, std::size_t border_cycles, std::ptrdiff_t euler_characteristic)
{
  Expected result{{}, border_cycles, euler_characteristic};
  for(const Patch& patch : patches)
    result.faces.emplace_back(patch);
  return result;
}

void expect_topology(const Meshed& m, const Expected& expected)
{
  expect_topology(m, 1, expected.border_cycles, expected.euler_characteristic);
  EXPECT_EQ(expected.border_cycles == 0, m.topology.border_edges == 0);
}

void check_against(const Model& model, const Expected& expected, const Criteria& criteria, double tolerance)
{
  const Meshed m = mesh_and_check(model, criteria);
  expect_topology(m, expected);
  expect_distinct_points(m.mesh);
  EXPECT_NEAR(1, m.area / expected.area(), tolerance);
  EXPECT_LE(m.triangles.size(), 3 * expected.number_of_triangles(m.report, criteria.gamma()) + 300);
  EXPECT_LE(number_of_unmet_but_at_short_edges(m.report), m.triangles.size() / 20 + 10);
  EXPECT_NEAR(1, expected.border_cycles == 0 ? m.volume() / expected.volume() : 1, tolerance);
}

// Edges as long as the curvature allows, and finer ones.
void check_at_all_sizes(const Model& model, const Expected& expected)
{
  const double size = std::sqrt(expected.area());
  for(double share : {10., 0.12, 0.03}) {
    SCOPED_TRACE("max_edge = " + std::to_string(share) + " of the root of the area");
    check_against(model, expected, Criteria().set_max_edge(share * size), share > 0.1 ? 0.08 : 0.02);
  }
}

// As few triangles as can be: the shape is lost, the topology is not.
void check_coarsest(const Model& model, const Expected& expected)
{
  for(double gamma : {0.2, 10.}) {
    SCOPED_TRACE("gamma = " + std::to_string(gamma));
    const Meshed m = mesh_and_check(model, Criteria().set_max_edge(100 * std::sqrt(expected.area())).set_gamma(gamma));
    expect_topology(m, expected);
    // curvature asks for some at a gamma of 0.2, and around an apex at any gamma
    EXPECT_LE(m.triangles.size(), (gamma < 1 ? 2000 : 400) * model.faces().size());
  }
}

// `profile(v)` is the pair (radius, height)
template <class Profile>
Sample_surface revolution(Profile profile)
{
  return function_surface([profile](auto u, auto v) {
    using std::cos;
    using std::sin;
    const auto rz = profile(v);
    return CGAL::parametric_surface_point(rz.first * cos(u), rz.first * sin(u), rz.second);
  });
}

template <class Profile>
std::vector<Patch> turned(Profile profile, double v_min, double v_max, double angle = 2 * pi)
{
  return {Patch(revolution(profile), 0, angle, v_min, v_max)};
}

std::vector<Patch> spindle()
{
  return turned([](auto v) { using std::sin; return std::make_pair(0.5 * sin(v), v); }, 0, pi);
}

std::vector<Patch> ellipsoid()
{
  return turned([](auto v) { using std::cos; using std::sin; return std::make_pair(sin(v), -1.5 * cos(v)); }, 0, pi);
}

std::vector<Patch> pebble()
{
  return turned([](auto v) { using std::cos; using std::sin; return std::make_pair(sin(v), -0.2 * cos(v)); }, 0, pi);
}

std::vector<Patch> hyperboloid()
{
  return turned([](auto v) { using std::sqrt; return std::make_pair(0.5 * sqrt(1 + v * v), v); }, -1.5, 1.5);
}

std::vector<Patch> wavy_column()
{
  return turned([](auto v) { using std::sin; return std::make_pair(1 + 0.3 * sin(3 * v), v); }, 0, 4);
}

std::vector<Patch> bell()
{
  return turned([](auto v) { using std::cos; return std::make_pair(v, 1 + cos(v)); }, 0, 2.5);
}

std::vector<Patch> open_cone() { return {sample_surfaces::cone().front()}; }

// the control points `point(i, j)` row by row
template <class Control_point>
std::vector<Point_3> control_net(int nu, int nv, Control_point point)
{
  std::vector<Point_3> result;
  for(int j = 0; j < nv; ++j)
    for(int i = 0; i < nu; ++i)
      result.push_back(point(i, j));
  return result;
}

std::vector<double> uniform_knots(int n)
{
  std::vector<double> knots;
  for(int i = 0; i < n; ++i)
    knots.push_back(i);
  return knots;
}

Patch whole_spline(const CGAL::B_spline_surface_3<Test_kernel>& s)
{
  return Patch(Sample_surface(s), s.u_min(), s.u_max(), s.v_min(), s.v_max());
}

// cubic and closed around, quadratic and clamped along its axis
std::vector<Patch> spline_tube()
{
  const int n = 7;
  const std::array<double, 4> radius = {1, 0.5, 1.2, 0.8};
  const auto points = control_net(n + 3, 4, [&](int i, int j) {
    const double angle = 2 * pi * (i % n) / n;
    return Point_3(radius[j] * std::cos(angle), radius[j] * std::sin(angle), j);
  });
  return {whole_spline({3, 2, uniform_knots(n + 7), {0, 0, 0, 1, 2, 2, 2}, points})};
}

// cubic and closed in both directions
std::vector<Patch> spline_torus()
{
  const int n = 8, k = 5;
  const auto points = control_net(n + 3, k + 3, [&](int i, int j) {
    const double angle = 2 * pi * (i % n) / n, turn = 2 * pi * (j % k) / k;
    const double radius = 2 + (0.8 + 0.2 * (i % n % 2)) * std::cos(turn);
    return Point_3(radius * std::cos(angle), radius * std::sin(angle), std::sin(turn));
  });
  return {whole_spline({3, 3, uniform_knots(n + 7), uniform_knots(k + 7), points})};
}

std::vector<Patch> partial_torus(double angle, double turn)
{
  return {Patch(Sample_surface(CGAL::Parametric_torus_3<Test_kernel>(1, 0.4)), 0, angle, -1, turn - 1)};
}

std::vector<Patch> lune(double angle)
{
  return {Patch(Sample_surface(CGAL::Parametric_sphere_3<Test_kernel>(1)), 1, 1 + angle, -pi / 2, pi / 2)};
}

// a full turn in `n` parts of different widths
std::vector<Patch> sphere_in_lunes(int n)
{
  std::vector<Patch> result;
  for(int i = 0; i < n; ++i)
    result.push_back(Patch(Sample_surface(CGAL::Parametric_sphere_3<Test_kernel>(1)), 2 * pi * i * i / (n * n),
                           2 * pi * (i + 1) * (i + 1) / (n * n), -pi / 2, pi / 2));
  result.back() = Patch(result.back().surface(), result.back().u_min(), 2 * pi, -pi / 2, pi / 2);
  return result;
}

std::vector<Patch> torus_in_parts(int n, int k)
{
  std::vector<Patch> result;
  const Sample_surface torus(CGAL::Parametric_torus_3<Test_kernel>(1, 0.4));
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < k; ++j)
      result.push_back(Patch(torus, 2 * pi * i / n, 2 * pi * (i + 1) / n, 2 * pi * j / k, 2 * pi * (j + 1) / k));
  return result;
}

struct Seam_case
{
  const char* name;
  std::vector<Patch> patches;
  std::size_t border_cycles;
  std::ptrdiff_t euler_characteristic;

  Model model() const { return model_of_patches(patches); }
  Expected expected() const { return expected_of(patches, border_cycles, euler_characteristic); }
};

std::ostream& operator<<(std::ostream& out, const Seam_case& c) { return out << c.name; }

std::vector<Seam_case> seam_cases()
{
  using namespace sample_surfaces;
  return {{"sphere", sphere(), 0, 2},
          {"torus", torus(), 0, 0},
          {"cylinder", cylinder(), 2, 0},
          {"cone_without_base", open_cone(), 1, 1},
          {"cone_with_base", cone(), 0, 2},
          {"vase_with_one_pole", vase(), 1, 1},
          {"rational_ring", ring(), 0, 0},
          {"spindle_with_two_pointed_poles", spindle(), 0, 2},
          {"ellipsoid", ellipsoid(), 0, 2},
          {"flat_ellipsoid", pebble(), 0, 2},
          {"hyperboloid", hyperboloid(), 2, 0},
          {"wavy_column", wavy_column(), 2, 0},
          {"bell", bell(), 1, 1},
          {"spline_tube", spline_tube(), 2, 0},
          {"spline_torus", spline_torus(), 0, 0},
          {"three_quarters_of_a_torus", partial_torus(1.5 * pi, 2 * pi), 2, 0},
          {"torus_open_along", partial_torus(2 * pi, 1.7 * pi), 2, 0},
          {"quarter_of_a_torus", partial_torus(0.5 * pi, pi), 1, 1},
          {"lune_of_30_degrees", lune(pi / 6), 1, 1},
          {"lune_of_180_degrees", lune(pi), 1, 1},
          {"lune_of_357_degrees", lune(2 * pi - 0.05), 1, 1},
          {"sphere_in_two_lunes", sphere_in_lunes(2), 0, 2},
          {"sphere_in_five_lunes", sphere_in_lunes(5), 0, 2},
          {"torus_in_1_x_2_parts", torus_in_parts(1, 2), 0, 0},
          {"torus_in_3_x_2_parts", torus_in_parts(3, 2), 0, 0}};
}

class Seams : public testing::TestWithParam<Seam_case>
{};

// Swapped and reversed parameters: the patch seen in one of 8 ways.
Patch seen_in_way(const Patch& patch, int way)
{
  const double a = way & 1 ? -1 : 1, b = way & 2 ? -1 : 1;
  const Linear_map_2 map = way & 4 ? Linear_map_2{0, a, b, 0} : Linear_map_2{a, 0, 0, b};
  const Vector_2 p = map.inverse()(Vector_2(patch.u_min(), patch.v_min())),
                 q = map.inverse()(Vector_2(patch.u_max(), patch.v_max()));
  return Patch(Sample_surface(Mapped_surface<Sample_surface>{patch.surface(), map, 1}), (std::min)(p.x(), q.x()),
               (std::max)(p.x(), q.x()), (std::min)(p.y(), q.y()), (std::max)(p.y(), q.y()));
}

class Seams_seen_in_way : public testing::TestWithParam<int>
{};

// t -> (u + bend sin(pi t), v) from `p` to `q`
Curve bent_curve(const Point_2& p, const Point_2& q, double bend)
{
  Curve curve = Curve::from_function(
    [p, q, bend](auto t) {
      using std::sin;
      return std::make_pair(p.x() + t * (q.x() - p.x()) + bend * sin(pi * t), p.y() + t * (q.y() - p.y()));
    },
    0, 1);
  curve.set_end_points(p, q);
  return curve;
}

// A full turn of a surface of revolution by hand. Its seam begins at `u`, advances by `advance` and bends.
Model full_turn(const Sample_surface& surface, double v_min, double v_max, double u, double advance, double bend,
                bool is_lower_pole, bool is_upper_pole)
{
  Model model;
  const Point_2 a(u, v_min), b(u + 2 * pi, v_min), c(u + advance + 2 * pi, v_max), d(u + advance, v_max);
  const std::size_t below = model.add_vertex(surface.point(a.x(), a.y())),
                    above = model.add_vertex(surface.point(d.x(), d.y()));
  const std::size_t bottom = model.add_edge(below, below, is_lower_pole), seam = model.add_edge(below, above),
                    top = model.add_edge(above, above, is_upper_pole);
  model.add_face({surface,
                  {{{bottom, false, Curve::segment(a, b)},
                    {seam, false, bent_curve(b, c, bend)},
                    {top, true, Curve::segment(d, c)},
                    {seam, true, bent_curve(a, d, bend)}}}});
  return model;
}

// A torus by hand, the seam around the tube winds.
Model torus_by_hand(double advance)
{
  Model model;
  const Sample_surface surface(CGAL::Parametric_torus_3<Test_kernel>(1, 0.3));
  const Point_2 a(0, 0), b(2 * pi, 0), c(2 * pi + advance, 2 * pi), d(advance, 2 * pi);
  const std::size_t vertex = model.add_vertex(surface.point(0, 0));
  const std::size_t around = model.add_edge(vertex, vertex), across = model.add_edge(vertex, vertex);
  model.add_face({surface,
                  {{{around, false, Curve::segment(a, b)},
                    {across, false, Curve::segment(b, c)},
                    {around, true, Curve::segment(d, c)},
                    {across, true, Curve::segment(a, d)}}}});
  return model;
}

const Sample_surface unit_sphere(CGAL::Parametric_sphere_3<Test_kernel>(1)),
  unit_cylinder(CGAL::Parametric_cylinder_3<Test_kernel>(1));

Expected expected_sphere() { return expected_of(sample_surfaces::sphere(), 0, 2); }

Expected expected_cylinder() { return expected_of(sample_surfaces::cylinder(), 2, 0); }

Expected expected_torus() { return expected_of(sample_surfaces::torus(), 0, 0); }

} // namespace

TEST_P(Seams, at_all_sizes) { check_at_all_sizes(GetParam().model(), GetParam().expected()); }

TEST_P(Seams, coarsest) { check_coarsest(GetParam().model(), GetParam().expected()); }

INSTANTIATE_TEST_SUITE_P(Stress, Seams, testing::ValuesIn(seam_cases()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

TEST_P(Seams_seen_in_way, sphere_cone_and_tori)
{
  const std::vector<std::pair<std::vector<Patch>, std::ptrdiff_t>> surfaces
    = {{sample_surfaces::sphere(), 2}, {sample_surfaces::cone(), 2}, {sample_surfaces::torus(), 0}, {spline_torus(), 0}};
  for(const auto& surface : surfaces) {
    const Expected expected = expected_of(surface.first, 0, surface.second);
    std::vector<Patch> patches;
    for(const Patch& patch : surface.first)
      patches.push_back(seen_in_way(patch, (GetParam() + 3 * int(patches.size())) % 8));
    check_against(model_of_patches(patches), expected, Criteria().set_max_edge(0.05 * std::sqrt(expected.area())), 0.03);
  }
}

INSTANTIATE_TEST_SUITE_P(Stress, Seams_seen_in_way, testing::Range(0, 8));

TEST(Seams_by_hand, sphere)
{
  check_at_all_sizes(full_turn(unit_sphere, -pi / 2, pi / 2, 1, 0, 0, true, true), expected_sphere());
}

TEST(Seams_by_hand, sphere_with_a_bent_seam)
{
  check_at_all_sizes(full_turn(unit_sphere, -pi / 2, pi / 2, 0, 0, 0.4, true, true), expected_sphere());
}

TEST(Seams_by_hand, sphere_with_a_slanted_seam)
{
  check_at_all_sizes(full_turn(unit_sphere, -pi / 2, pi / 2, 0, 1, 0, true, true), expected_sphere());
}

TEST(Seams_by_hand, cylinder)
{
  check_at_all_sizes(full_turn(unit_cylinder, 0, 2, -5, 0, 0, false, false), expected_cylinder());
}

TEST(Seams_by_hand, cylinder_with_a_helix_as_seam)
{
  for(double advance : {1., -2., 7.}) {
    SCOPED_TRACE(advance);
    check_at_all_sizes(full_turn(unit_cylinder, 0, 2, 0, advance, 0, false, false), expected_cylinder());
  }
}

TEST(Seams_by_hand, cylinder_with_a_bent_seam)
{
  check_at_all_sizes(full_turn(unit_cylinder, 0, 2, 0, 0, 1.5, false, false), expected_cylinder());
}

TEST(Seams_by_hand, hemisphere)
{
  const Expected expected = expected_of({Patch(unit_sphere, 0, 2 * pi, 0, pi / 2)}, 1, 1);
  check_at_all_sizes(full_turn(unit_sphere, 0, pi / 2, 0, 0, 0.2, false, true), expected);
}

TEST(Seams_by_hand, torus) { check_at_all_sizes(torus_by_hand(0), expected_torus()); }

TEST(Seams_by_hand, torus_with_a_winding_seam)
{
  for(double turns : {1., -2.}) {
    SCOPED_TRACE(turns);
    check_at_all_sizes(torus_by_hand(2 * pi * turns), expected_torus());
  }
}

TEST(Seams_by_hand, torus_with_an_open_seam_is_refused)
{
  expect_refused([] { mesh_and_check(torus_by_hand(1), Criteria().set_max_edge(0.1)); }, "face 1", "edge 1");
}

TEST(Seams_by_hand, coarsest_sphere)
{
  check_coarsest(full_turn(unit_sphere, -pi / 2, pi / 2, 0, 0, 0, true, true), expected_sphere());
}

TEST(Seams_by_hand, coarsest_cylinder)
{
  check_coarsest(full_turn(unit_cylinder, 0, 2, 0, 0, 0, false, false), expected_cylinder());
}

TEST(Seams_by_hand, coarsest_torus) { check_coarsest(torus_by_hand(0), expected_torus()); }
