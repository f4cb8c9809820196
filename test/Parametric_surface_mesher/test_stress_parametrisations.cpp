// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stress tests: parametrisations that are singular inside the patch, change their speed or shear, and splines with creases.
#include <CGAL/B_spline_surface_3.h>
#include <CGAL/Parametric_surface_mesher/split_at_creases.h>

#include <gtest/gtest.h>

#include <random_patches.h>
#include <stress_test_helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

typedef CGAL::B_spline_surface_3<Test_kernel> Spline;

// of a function_surface()
template <class X, class Y, class Z>
auto point(const X& x, const Y& y, const Z& z)
{
  return CGAL::parametric_surface_point(x, y, z);
}

// All triangles are counterclockwise in the domain, exactly.
void expect_positive_orientation(const Meshed& m)
{
  std::size_t inverted = 0;
  for(const auto& p : m.corner_points)
    inverted += CGAL::orientation(p[0], p[1], p[2]) != CGAL::LEFT_TURN;
  EXPECT_EQ(0u, inverted) << "triangles are not counterclockwise in the domain";
}

// Triangles that face away from the surface, by its normal at the centroid, are in the report.
void expect_listed_where_turned_over(const Meshed& m, const Sample_surface& surface)
{
  const auto listed = unmet_by_face(m.report);
  std::size_t silent = 0;
  for(std::size_t t = 0; t < m.triangles.size(); ++t) {
    const auto& p = m.corner_points[t];
    const Point_2 uv = CGAL::centroid(p[0], p[1], p[2]);
    const auto jet = surface.jet(uv.x(), uv.y());
    silent += cross_product(jet.du, jet.dv) * m.area_vector(t) < 0 && listed.count(t) == 0;
  }
  EXPECT_EQ(0u, silent) << "triangles that face to the wrong side are not in the report";
}

// The surface is near every triangle that is not in the report, above the middles of its sides in the domain.
void expect_listed_where_far(const Meshed& m, const Sample_surface& surface, double gamma)
{
  const auto listed = unmet_by_face(m.report);
  std::size_t silent = 0;
  for(std::size_t t = 0; t < m.triangles.size(); ++t) {
    const Vector_3 normal = m.area_vector(t) / std::sqrt(m.area_vector(t).squared_length());
    const double longest = (std::max)({m.length(t, 0), m.length(t, 1), m.length(t, 2)});
    for(std::size_t k = 0; k < 3; ++k) {
      const Point_2 uv = CGAL::midpoint(m.corner_points[t][k], m.corner_points[t][(k + 1) % 3]);
      const double height = std::fabs(normal * (surface.point(uv.x(), uv.y()) - m.point(m.triangles[t][k])));
      silent += height > 1.5 * gamma * longest && longest > 4 * m.report.min_edge && listed.count(t) == 0;
    }
  }
  EXPECT_EQ(0u, silent) << "triangles that are far from the surface are not in the report";
}

// A patch over a parallelogram in its domain. Apart from the unit in space it is what `plain` is over `[min, max]`.
struct Wild_case
{
  std::string name;
  Sample_surface surface;
  Domain domain;
  Sample_surface plain;
  Point_2 min, max;
  double unit;
  bool is_singular;          // at a point of the division or inside
  double max_share_of_unmet; // of the triangles

  Surface_integrals integrals() const { return Surface_integrals(plain, min.x(), max.x(), min.y(), max.y()); }
};

std::ostream& operator<<(std::ostream& out, const Wild_case& c) { return out << c.name; }

Wild_case over_rectangle(const std::string& name, const Sample_surface& surface, double u_min, double u_max, double v_min,
                         double v_max, bool is_singular = false, double max_share_of_unmet = 0.02)
{
  return {name, surface, Domain::rectangle(u_min, u_max, v_min, v_max), surface, Point_2(u_min, v_min),
          Point_2(u_max, v_max), 1, is_singular, max_share_of_unmet};
}

// `(u r^n, v r^n, 0)`, with derivatives of zero at the origin
Sample_surface zero_at_origin(int n)
{
  const auto surface = CGAL::make_parametric_function_surface<Test_kernel>([n](auto u, auto v) {
    using std::pow;
    const auto factor = pow(u * u + v * v, 0.5 * n);
    return point(u * factor, v * factor, 0);
  });
  return Sample_surface(CGAL::make_parametric_jet_surface([surface](double u, double v) {
    const Vector_3 zero(0, 0, 0);
    return u == 0 && v == 0 ? CGAL::Surface_jet_3<Test_kernel>{Point_3(0, 0, 0), zero, zero, zero, zero, zero}
                            : surface.jet(u, v);
  }));
}

std::vector<Wild_case> singular_cases()
{
  return {
    over_rectangle("cubic_speed", function_surface([](auto u, auto v) { return point(u * u * u, v, 0); }),
                   -1, 1, -1, 1, true),
    over_rectangle("cubic_speed_in_both",
                   function_surface([](auto u, auto v) { return point(u * u * u, v * v * v, 0); }), -1,
                   1, -1, 1, true),
    over_rectangle("quintic_speed_on_a_wave", function_surface([](auto u, auto v) {
                     using std::sin;
                     return point(u * u * u * u * u, v, 0.2 * sin(3 * v));
                   }),
                   -1, 1, -1, 1, true),
    over_rectangle("zero_along_a_side",
                   function_surface([](auto u, auto v) { return point(u * u, v, 0.3 * v * v); }), 0, 1,
                   0, 1, true),
    over_rectangle("zero_along_two_sides",
                   function_surface([](auto u, auto v) { return point(u * u, v * v * v, u * u * v * v * v); }),
                   0, 1, 0, 1, true),
    over_rectangle("zero_at_a_point", zero_at_origin(1), -1, 1, -1, 1, true),
    over_rectangle("zero_at_a_point_quadratic", zero_at_origin(2), -1, 1.3, -1, 1.1, true),
    over_rectangle("zero_at_a_point_of_no_vertex", zero_at_origin(2), -0.93, 1.17, -0.89, 1.31, true),
    over_rectangle("zero_in_a_corner", zero_at_origin(1), 0, 1, 0, 1, true),
    over_rectangle("square_of_complex_numbers_in_a_corner",
                   function_surface([](auto u, auto v) { return point(u * u - v * v, 2 * u * v, 0); }),
                   0, 1, 0, 1, true),
    over_rectangle("square_of_complex_numbers_on_a_side",
                   function_surface([](auto u, auto v) { return point(u * u - v * v, 2 * u * v, 0); }),
                   0, 1, -1, 1, true),
    over_rectangle("parallel_in_a_corner",
                   function_surface([](auto u, auto v) { return point(u + v, u * u - v * v, 0); }), 0, 1,
                   0, 1, true, 0.15), // a cusp
    over_rectangle("parallel_along_a_line", function_surface([](auto u, auto v) {
                     return point(u + v * v * v, v * v * v, 0.2 * u * u);
                   }),
                   0, 1, -1, 1, true, 0.05)}; // the tangents are parallel along a whole line: the hardest of all
}

std::vector<Wild_case> speed_cases()
{
  return {
    over_rectangle("exponential", function_surface([](auto u, auto v) {
                     using std::exp;
                     return point(exp(13.8155 * (u - 1)), v, 0.1 * v * v);
                   }),
                   0, 1, 0, 1, false, 0.05),
    over_rectangle("exponential_in_both", function_surface([](auto u, auto v) {
                     using std::exp;
                     return point(exp(6.9 * (u - 1)), exp(6.9 * (v - 1)), 0);
                   }),
                   0, 1, 0, 1, false, 0.05),
    over_rectangle("dip", function_surface([](auto u, auto v) {
                     return point(u * u * u / 3 + 1e-6 * u, v, 0);
                   }),
                   -1, 1, 0, 1),
    over_rectangle("dip_beside_the_middle", function_surface([](auto u, auto v) {
                     const auto w = u - 0.37;
                     return point(w * w * w / 3 + 1e-6 * w, v, 0.1 * v * v);
                   }),
                   -1, 1, 0, 1),
    over_rectangle("wavy_speed", function_surface([](auto u, auto v) {
                     using std::sin;
                     return point(u + 0.158 * sin(2 * pi * u), v + 0.158 * sin(2 * pi * v), 0);
                   }),
                   0, 2, 0, 2),
    over_rectangle("jump_of_10000", function_surface([](auto u, auto v) {
                     using std::tanh;
                     return point(0.001 * u + 0.22 * tanh(50 * u), v, 0);
                   }),
                   -1, 1, 0, 1, false, 0.04),
    over_rectangle("gentle_swirl", function_surface([](auto u, auto v) {
                     using std::cos;
                     using std::sin;
                     const auto angle = u * u + v * v;
                     return point(u * cos(angle) - v * sin(angle), u * sin(angle) + v * cos(angle), 0);
                   }),
                   -1, 1, -1, 1, false, 0.03)};
}

// A surface over a parallelogram that a linear map takes to `[0,1] x [0,1]`, scaled by `factor`.
Wild_case mapped(const std::string& name, const Linear_map_2& map, double factor)
{
  const Sample_surface wave = function_surface([](auto u, auto v) {
    using std::sin;
    return point(u, v, 0.1 * sin(5 * u + 2 * v));
  });
  std::vector<Point_2> corners;
  for(const Vector_2& x : {Vector_2(0, 0), Vector_2(1, 0), Vector_2(1, 1), Vector_2(0, 1)})
    corners.push_back(CGAL::ORIGIN + map.inverse()(x));
  return {name, Sample_surface(Mapped_surface<Sample_surface>{wave, map, factor}), Domain(corners), wave, Point_2(0, 0),
          Point_2(1, 1), factor, false, 0.01};
}

Wild_case far_from_origin(double offset)
{
  const Sample_surface peak((sample_surfaces::Peak()));
  const auto shifted = CGAL::make_parametric_jet_surface(
    [peak, offset](double u, double v) { return peak.jet(u - offset, v + 2 * offset); });
  return over_rectangle("offset_" + std::to_string(int(offset)), Sample_surface(shifted), offset - 1, offset + 1,
                        -2 * offset - 1, -2 * offset + 1);
}

std::vector<Wild_case> linear_cases()
{
  return {mapped("sheared_by_100", {1, 100, 0, 1}, 1),
          mapped("sheared_by_1000", {1, 1000, 0, 1}, 1),
          mapped("sheared_in_both", {1, 30, 30, 901}, 1),
          mapped("stretched_by_1e5", {1e-5, 0, 0, 1}, 1),
          mapped("turned_and_stretched", {0.6e4, 0.8e-3, -0.8e4, 0.6e-3}, 1),
          mapped("unit_of_space_1e-6", {1, 0, 0, 1}, 1e-6),
          mapped("unit_of_space_1e6", {1, 0, 0, 1}, 1e6),
          mapped("unit_of_space_1e-30", {1, 0, 0, 1}, 1e-30),
          mapped("unit_of_domain_1e-6", {1e6, 0, 0, 1e6}, 1),
          mapped("unit_of_domain_1e6", {1e-6, 0, 0, 1e-6}, 1),
          mapped("all_units_1e6", {1e-6, 0, 0, 1e-6}, 1e6),
          far_from_origin(1e4),
          far_from_origin(1e7)};
}

std::vector<Wild_case> all_cases()
{
  std::vector<Wild_case> result = singular_cases();
  for(const auto& cases : {speed_cases(), linear_cases()})
    result.insert(result.end(), cases.begin(), cases.end());
  return result;
}

std::string name_of(const Wild_case& c)
{
  std::string result = c.name;
  std::replace(result.begin(), result.end(), '-', '_');
  return result;
}

class Parametrisations : public testing::TestWithParam<Wild_case>
{};

// The number of triangles is bounded by a multiple of that of equilateral ones, of edges as long as the curvature of lines
// that are straight in the domain allows. (Near singular points that has no bound, and the midpoint rule does not see all
// of it.)
void check_wild(const Wild_case& c, double size)
{
  const Surface_integrals integrals = c.integrals();
  const double max_edge = size * std::sqrt(integrals.area), area = c.unit * c.unit * integrals.area;
  const Meshed m = mesh_and_check(c.surface, c.domain, Criteria().set_max_edge(c.unit * max_edge));
  expect_topology(m, 1, 1, 1);
  expect_positive_orientation(m);
  expect_listed_where_turned_over(m, c.surface);
  expect_listed_where_far(m, c.surface, 0.05);
  EXPECT_NEAR(1, m.area / area, 0.02);
  const double number = integrals.number_of_triangles_by_lines(max_edge, m.report.min_edge / c.unit, 0.05);
  EXPECT_LE(m.triangles.size(), 4 * number + 2000);
  EXPECT_LE(number_of_unmet_but_at_short_edges(m.report), c.max_share_of_unmet * m.triangles.size() + 20);
  EXPECT_TRUE(!c.is_singular || m.report.number_of_replaced_tensors > 0);
}

// The spline of degree `p` in `u` (with the knots) and 1 in `v` with the profile x -> z.
Spline profile_spline(int p, const std::vector<double>& knots, const std::vector<double>& z)
{
  std::vector<Point_3> points;
  for(double y : {0., 1.})
    for(std::size_t i = 0; i < z.size(); ++i)
      points.emplace_back(2. * i / (z.size() - 1), y, z[i]);
  return Spline(p, 1, knots, {0, 0, 1, 1}, points);
}

// with a crease at u = 1, where x = 1
Spline roof() { return profile_spline(2, {0, 0, 0, 1, 1, 2, 2, 2}, {0, 0.3, 1, 0.3, 0}); }

// with creases along u = 1 and v = 1 that cross at (x,y) = (1,1)
Spline tent()
{
  std::vector<Point_3> points;
  for(int j = 0; j < 3; ++j)
    for(int i = 0; i < 3; ++i)
      points.emplace_back(i, j, i == 1 && j == 1 ? 0.8 : 0);
  return Spline(1, 1, {0, 0, 1, 2, 2}, {0, 0, 1, 2, 2}, points);
}

// of degree 1, with many creases
Spline zigzag() { return profile_spline(1, {0, 0, 1, 2, 3, 4, 4}, {0, 0.3, 0, 0.3, 0}); }

Domain domain_of(const Spline& s) { return Domain::rectangle(s.u_min(), s.u_max(), s.v_min(), s.v_max()); }

double area_of(const Spline& s)
{
  return Surface_integrals(Sample_surface(s), s.u_min(), s.u_max(), s.v_min(), s.v_max()).area;
}

Model split(const Spline& s)
{
  std::vector<Patch> patches;
  for(const auto& piece : CGAL::Parametric_surface_mesher::split_at_creases(s))
    patches.emplace_back(Sample_surface(piece), piece.u_min(), piece.u_max(), piece.v_min(), piece.v_max());
  return model_of_patches(patches);
}

// the length of the mesh's edges whose ends both are where `is_on_line` says
double length_of_edges(const Meshed& m, const std::function<bool(const Point_3&)>& is_on_line)
{
  double sum = 0;
  for(const auto e : m.mesh.edges())
    if(is_on_line(m.mesh.point(m.mesh.vertex(e, 0))) && is_on_line(m.mesh.point(m.mesh.vertex(e, 1))))
      sum += length(m.mesh, e);
  return sum;
}

Meshed mesh_split(const Spline& spline, double max_edge)
{
  const Meshed m = mesh_and_check(split(spline), Criteria().set_max_edge(max_edge));
  expect_topology(m, 1, 1, 1);
  expect_distinct_points(m.mesh);
  EXPECT_LE(number_of_unmet_but_at_short_edges(m.report), m.triangles.size() / 100 + 2);
  EXPECT_NEAR(1, m.area / area_of(spline), 0.01);
  return m;
}

// A crease within a patch is meshed down to the minimum edge, if not all of it can be met then that is in the report.
void check_crease_inside(const Spline& spline, double max_edge)
{
  const Sample_surface surface(spline);
  const Meshed m = mesh_and_check(surface, domain_of(spline), Criteria().set_max_edge(max_edge).set_min_edge(max_edge / 20));
  expect_topology(m, 1, 1, 1);
  expect_positive_orientation(m);
  expect_listed_where_far(m, surface, 0.05);
  EXPECT_NEAR(1, m.area / area_of(spline), 0.02);
  EXPECT_LE(m.triangles.size(), 40000u);
  for(const auto& unmet : m.report.unmet)
    EXPECT_NE(CGAL::Parametric_surface_mesher::Unmet_cause::VERTEX_LIMIT, unmet.cause);
}

} // namespace

TEST_P(Parametrisations, coarse) { check_wild(GetParam(), 0.24); }

TEST_P(Parametrisations, fine) { check_wild(GetParam(), 0.06); }

INSTANTIATE_TEST_SUITE_P(Stress, Parametrisations, testing::ValuesIn(all_cases()),
                         [](const auto& parameter) { return name_of(parameter.param); });

TEST(Creases, roof_is_split)
{
  for(double max_edge : {0.5, 0.1, 0.03}) {
    const Meshed m = mesh_split(roof(), max_edge);
    EXPECT_NEAR(1, length_of_edges(m, [](const Point_3& p) { return p.x() == 1; }), 1e-9);
  }
}

TEST(Creases, tent_is_split)
{
  for(double max_edge : {0.5, 0.1, 0.03}) {
    const Meshed m = mesh_split(tent(), max_edge);
    const double expected = 2 * std::sqrt(1 + 0.64);
    EXPECT_NEAR(expected, length_of_edges(m, [](const Point_3& p) { return p.x() == 1; }), 1e-9);
    EXPECT_NEAR(expected, length_of_edges(m, [](const Point_3& p) { return p.y() == 1; }), 1e-9);
  }
}

TEST(Creases, zigzag_is_split)
{
  const Meshed m = mesh_split(zigzag(), 0.1);
  for(double x : {0.5, 1., 1.5})
    EXPECT_NEAR(1, length_of_edges(m, [x](const Point_3& p) { return std::fabs(p.x() - x) < 1e-12; }), 1e-9);
}

TEST(Creases, roof_inside) { check_crease_inside(roof(), 0.2); }

TEST(Creases, tent_inside) { check_crease_inside(tent(), 0.2); }

TEST(Creases, zigzag_inside) { check_crease_inside(zigzag(), 0.1); }

// Where only the curvature jumps there is nothing to split.
TEST(Creases, smooth_knots_need_no_split)
{
  const Spline spline = profile_spline(2, {0, 0, 0, 1, 2, 3, 3, 3}, {0, 0.3, 0, 0.5, 0});
  EXPECT_EQ(1u, CGAL::Parametric_surface_mesher::split_at_creases(spline).size());
  for(double max_edge : {0.2, 0.05}) {
    const Meshed m = mesh_and_check(Sample_surface(spline), domain_of(spline), Criteria().set_max_edge(max_edge));
    expect_topology(m, 1, 1, 1);
    expect_positive_orientation(m);
    EXPECT_EQ(0u, m.report.unmet.size());
  }
}

TEST(Creases, flat_spline_of_degree_1)
{
  std::vector<Point_3> points; // equal steps of the knots, different ones in space: only the speed jumps
  for(double y : {0., 0.01, 1.})
    for(double x : {0., 0.001, 0.5, 1.})
      points.emplace_back(x, y, 0);
  const Spline spline(1, 1, {0, 0, 1, 2, 3, 3}, {0, 0, 1, 2, 2}, points);
  const Meshed m = mesh_and_check(Sample_surface(spline), domain_of(spline), Criteria().set_max_edge(0.1));
  expect_topology(m, 1, 1, 1);
  expect_positive_orientation(m);
  EXPECT_NEAR(1, m.area, 1e-9); // nothing is turned over
  EXPECT_LE(m.triangles.size(), 3 * number_of_equilateral_triangles(1, 0.1));
}

// A surface that is defined on a disc only, and may not be asked outside the box around it.
class Bowl
{
public:
  typedef Test_kernel Geom_traits;

  static constexpr double radius = 0.95;

  Point_3 point(double u, double v) const { return jet(u, v).point; }

  CGAL::Surface_jet_3<Test_kernel> jet(double u, double v) const
  {
    if(std::max(std::fabs(u), std::fabs(v)) > radius * (1 + 1e-12))
      throw std::logic_error("evaluated outside the box of the domain");
    return CGAL::make_parametric_function_surface<Test_kernel>([](auto x, auto y) {
      using std::sqrt;
      const auto w = x * x * x;
      return CGAL::parametric_surface_point(w, y, -sqrt(1 - w * w - y * y)); // not a number in the corners of the box
    }).jet(u, v);
  }
};

TEST(Domains, nothing_outside_their_box_is_evaluated)
{
  const Domain disc({Curve::circle(Point_2(0, 0), Bowl::radius)});
  for(double max_edge : {10., 0.1}) {
    Mesh mesh;
    const Report report = add_patch(Bowl(), disc, Criteria().set_max_edge(max_edge), mesh);
    EXPECT_GT(report.number_of_replaced_tensors, 0u);
    EXPECT_TRUE(mesh.is_valid());
    EXPECT_EQ(0u, number_of_inverted_faces(mesh));
    EXPECT_LT(report.number_of_faces, 20000u);
  }
}
