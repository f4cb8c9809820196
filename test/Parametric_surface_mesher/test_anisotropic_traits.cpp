// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Anisotropic_Delaunay_triangulation_traits_2.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <random_input.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Anisotropic_Delaunay_triangulation_traits_2<Kernel> Traits;
typedef Traits::Point_2 Point_2;
typedef CGAL::Metric_tensor_2 Tensor;

typedef CGAL::Delaunay_triangulation_2<Traits> Delaunay;
typedef CGAL::Constrained_Delaunay_triangulation_2<Traits> Constrained_Delaunay;
typedef CGAL::Delaunay_triangulation_2<Kernel> Euclidean_Delaunay;
typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel> Euclidean_constrained_Delaunay;

typedef std::set<std::array<std::size_t, 3> > Faces;
typedef std::pair<std::size_t, std::size_t> Edge;

namespace {

// The linear map (a b; c d), with entries of few bits: it maps multiples of 2^-20 without rounding.
struct Linear_map
{
  double a, b, c, d;

  Kernel::Point_2 operator()(const Kernel::Point_2& p) const
  {
    return Kernel::Point_2(a * p.x() + b * p.y(), c * p.x() + d * p.y());
  }

  Tensor tensor() const { return Tensor(a * a + c * c, a * b + c * d, b * b + d * d); }
};

// reflections, shears and stretchings included
const std::vector<Linear_map> maps = {
  {1, 0, 0, 1},   {0, 1, 1, 0},      {-1, 0, 0, 1},          {3, 1, -1, 2},     {1, 7, 0, 1},
  {16, 0, 0, 1},  {1, 0, 0, 1. / 64}, {5, -8, 3, 7},          {512, 3, 1, 1},    {1. / 4, 100, -1. / 8, 9},
  {99, 100, 98, 99}, {1024, 1023, 1, 1}
};

std::vector<Kernel::Point_2> random_domain_points(Random_input& random, int n)
{
  std::set<Kernel::Point_2> points;
  while(points.size() < static_cast<std::size_t>(n))
    points.insert(Kernel::Point_2(random.dyadic(20), random.dyadic(20)));
  std::vector<Kernel::Point_2> result(points.begin(), points.end());
  for(std::size_t i = result.size() - 1; i > 0; --i)
    std::swap(result[i], result[static_cast<std::size_t>(random.integer(i + 1))]);
  return result;
}

std::vector<Point_2> with_tensor(const std::vector<Kernel::Point_2>& points, const Tensor& m)
{
  std::vector<Point_2> result;
  for(const Kernel::Point_2& p : points)
    result.push_back(Point_2(p, Kernel::Point_3(p.x(), p.y(), 0), m));
  return result;
}

std::vector<Kernel::Point_2> mapped(const std::vector<Kernel::Point_2>& points, const Linear_map& map)
{
  std::vector<Kernel::Point_2> result;
  for(const Kernel::Point_2& p : points)
    result.push_back(map(p));
  return result;
}

// the triangles by the indices of their corners in `points`
template <class Triangulation, class Point>
Faces faces(const Triangulation& t, const std::vector<Point>& points)
{
  std::map<std::pair<double, double>, std::size_t> index;
  for(std::size_t i = 0; i < points.size(); ++i)
    index[std::make_pair(points[i].x(), points[i].y())] = i;
  Faces result;
  for(auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) {
    std::array<std::size_t, 3> corners;
    for(int i = 0; i < 3; ++i)
      corners[i] = index.at(std::make_pair(f->vertex(i)->point().x(), f->vertex(i)->point().y()));
    std::sort(corners.begin(), corners.end());
    result.insert(corners);
  }
  return result;
}

// every triangle counterclockwise, exactly, and as many of them as Euler's formula wants
template <class Triangulation>
void expect_valid(const Triangulation& t, std::size_t vertices)
{
  EXPECT_TRUE(t.tds().is_valid());
  EXPECT_EQ(t.number_of_vertices(), vertices);
  for(auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
    EXPECT_EQ(CGAL::orientation(f->vertex(0)->point().domain_point(), f->vertex(1)->point().domain_point(),
                                f->vertex(2)->point().domain_point()), CGAL::LEFT_TURN);
  std::size_t on_hull = 0;
  auto around = t.incident_faces(t.infinite_vertex()), end = around;
  do
    ++on_hull;
  while(++around != end);
  EXPECT_EQ(t.number_of_faces(), 2 * vertices - 2 - on_hull);
}

// a closed polygon, star-shaped about the origin: its edges do not cross
std::vector<Kernel::Point_2> random_polygon(Random_input& random, int n)
{
  const double pi = std::acos(-1.);
  std::vector<Kernel::Point_2> result;
  for(int i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n, radius = random.real(0.2, 0.9);
    const double x = std::ldexp(std::floor(std::ldexp(radius * std::cos(angle), 20)), -20);
    const double y = std::ldexp(std::floor(std::ldexp(radius * std::sin(angle), 20)), -20);
    result.push_back(Kernel::Point_2(x, y));
  }
  return result;
}

// the polygon is the first `n` points
std::vector<Edge> polygon_edges(std::size_t n)
{
  std::vector<Edge> result;
  for(std::size_t i = 0; i < n; ++i)
    result.push_back(Edge(i, (i + 1) % n));
  return result;
}

// one point after the other, in the order given
template <class Triangulation, class Point>
std::vector<typename Triangulation::Vertex_handle> insert(Triangulation& t, const std::vector<Point>& points)
{
  std::vector<typename Triangulation::Vertex_handle> vertices;
  typename Triangulation::Face_handle hint;
  for(const Point& p : points) {
    vertices.push_back(t.insert(p, hint));
    hint = vertices.back()->face();
  }
  return vertices;
}

template <class Triangulation, class Point>
void insert(Triangulation& t, const std::vector<Point>& points, const std::vector<Edge>& constraints)
{
  const auto vertices = insert(t, points);
  for(const Edge& e : constraints)
    t.insert_constraint(vertices[e.first], vertices[e.second]);
}

template <class Triangulation, class Point>
std::size_t number_of_kept_constraints(const Triangulation& t, const std::vector<Point>& points,
                                       const std::vector<Edge>& constraints)
{
  std::set<std::pair<Kernel::Point_2, Kernel::Point_2> > kept;
  for(auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e)
    if(t.is_constrained(*e)) {
      const Kernel::Point_2 p = e->first->vertex(t.cw(e->second))->point(),
                            q = e->first->vertex(t.ccw(e->second))->point();
      kept.insert(std::make_pair(p, q));
      kept.insert(std::make_pair(q, p));
    }
  EXPECT_EQ(kept.size(), 2 * constraints.size());
  std::size_t n = 0;
  for(const Edge& e : constraints)
    n += kept.count(std::make_pair(Kernel::Point_2(points[e.first]), Kernel::Point_2(points[e.second])));
  return n;
}

// a field that turns and stretches quickly
Tensor varying_tensor(double x, double y, double frequency, double stretching)
{
  const double alpha = frequency * (x + 2 * y);
  const double k = std::exp(stretching * (1 + std::sin(frequency * (3 * x - y))));
  return (1.5 + std::cos(frequency * x * y)) * Tensor::from_ellipse(alpha, k);
}

std::vector<Point_2> with_varying_tensor(const std::vector<Kernel::Point_2>& points, double frequency,
                                         double stretching)
{
  std::vector<Point_2> result;
  for(const Kernel::Point_2& p : points)
    result.push_back(Point_2(p, Kernel::Point_3(p.x(), p.y(), 0),
                             varying_tensor(p.x(), p.y(), frequency, stretching)));
  return result;
}

} // namespace

TEST(Anisotropic_traits, points_carry_their_data)
{
  const Kernel::Point_2 p(1, 2);
  const Kernel::Point_3 s(3, 4, 5);
  const Tensor m(2, 1, 3);
  Delaunay t;
  const Delaunay::Vertex_handle v = t.insert(Point_2(p, s, m));
  EXPECT_EQ(v->point().domain_point(), p);
  EXPECT_EQ(v->point().surface_point(), s);
  EXPECT_EQ(v->point().tensor(), m);
}

TEST(Anisotropic_traits, euclidean_points_by_default)
{
  Random_input random(1);
  const std::vector<Kernel::Point_2> domain = random_domain_points(random, 1000);
  const std::vector<Point_2> points(domain.begin(), domain.end());
  const Delaunay t(points.begin(), points.end());
  const Euclidean_Delaunay euclidean(domain.begin(), domain.end());
  EXPECT_EQ(faces(t, points), faces(euclidean, domain));
}

TEST(Anisotropic_traits, constant_tensor_is_delaunay_of_the_mapped_points)
{
  Random_input random(2);
  for(const Linear_map& map : maps)
    for(int n : {3, 10, 100, 2000}) {
      SCOPED_TRACE(::testing::Message() << n << " points, map " << map.a << " " << map.b << " " << map.c << " "
                                        << map.d);
      const std::vector<Kernel::Point_2> domain = random_domain_points(random, n), image = mapped(domain, map);
      const std::vector<Point_2> points = with_tensor(domain, map.tensor());
      Delaunay t;
      t.insert(points.begin(), points.end());
      EXPECT_TRUE(t.is_valid());
      expect_valid(t, domain.size());
      const Euclidean_Delaunay euclidean(image.begin(), image.end());
      EXPECT_EQ(faces(t, points), faces(euclidean, image));
    }
}

TEST(Anisotropic_traits, does_not_depend_on_the_order_for_a_constant_tensor)
{
  Random_input random(3);
  const std::vector<Kernel::Point_2> domain = random_domain_points(random, 1000);
  const std::vector<Point_2> points = with_tensor(domain, maps[7].tensor());
  const Delaunay sorted(points.begin(), points.end());
  Delaunay one_by_one;
  insert(one_by_one, points);
  EXPECT_EQ(faces(sorted, points), faces(one_by_one, points));
}

TEST(Anisotropic_traits, removal_works_for_a_constant_tensor)
{
  Random_input random(4);
  const Linear_map map = maps[3];
  std::vector<Kernel::Point_2> domain = random_domain_points(random, 500);
  Delaunay t;
  std::vector<Delaunay::Vertex_handle> vertices;
  for(const Point_2& p : with_tensor(domain, map.tensor()))
    vertices.push_back(t.insert(p));
  for(int i = 0; i < 200; ++i)
    t.remove(vertices[i]);
  domain.erase(domain.begin(), domain.begin() + 200);
  const std::vector<Kernel::Point_2> image = mapped(domain, map);
  EXPECT_EQ(faces(t, domain), faces(Euclidean_Delaunay(image.begin(), image.end()), image));
}

TEST(Anisotropic_traits, grids_are_valid_although_degenerate)
{
  // every unit parallelogram is cocircular, exactly
  for(const Linear_map& map : maps) {
    std::vector<Kernel::Point_2> domain;
    for(int i = 0; i < 20; ++i)
      for(int j = 0; j < 20; ++j)
        domain.push_back(Kernel::Point_2(i, j));
    const std::vector<Point_2> points = with_tensor(domain, map.tensor());
    const Delaunay t(points.begin(), points.end());
    EXPECT_TRUE(t.is_valid());
    expect_valid(t, domain.size());
  }
}

TEST(Anisotropic_traits, constrained_with_a_constant_tensor_is_that_of_the_mapped_points)
{
  Random_input random(5);
  for(const Linear_map& map : maps)
    for(int n : {10, 100, 1000}) {
      SCOPED_TRACE(::testing::Message() << n << " points, map " << map.a << " " << map.b << " " << map.c << " "
                                        << map.d);
      std::vector<Kernel::Point_2> domain = random_polygon(random, 40);
      const std::vector<Edge> constraints = polygon_edges(domain.size());
      for(const Kernel::Point_2& p : random_domain_points(random, n))
        domain.push_back(p);
      const std::vector<Kernel::Point_2> image = mapped(domain, map);
      const std::vector<Point_2> points = with_tensor(domain, map.tensor());
      Constrained_Delaunay t;
      insert(t, points, constraints);
      Euclidean_constrained_Delaunay euclidean;
      insert(euclidean, image, constraints);
      EXPECT_TRUE(t.is_valid());
      expect_valid(t, domain.size());
      EXPECT_EQ(faces(t, points), faces(euclidean, image));
      EXPECT_EQ(number_of_kept_constraints(t, points, constraints), constraints.size());
    }
}

TEST(Anisotropic_traits, range_insertion_into_a_constrained_triangulation)
{
  Random_input random(6);
  const std::vector<Kernel::Point_2> domain = random_domain_points(random, 2000), image = mapped(domain, maps[4]);
  const std::vector<Point_2> points = with_tensor(domain, maps[4].tensor());
  Constrained_Delaunay t;
  t.insert(points.begin(), points.end());
  EXPECT_EQ(faces(t, points), faces(Euclidean_Delaunay(image.begin(), image.end()), image));
}

TEST(Anisotropic_traits, varying_tensor_keeps_every_face_positively_oriented)
{
  Random_input random(7);
  for(double frequency : {0.5, 3., 20., 1000.})
    for(double stretching : {0.5, 2., 4.}) {
      SCOPED_TRACE(::testing::Message() << "frequency " << frequency << ", stretching " << stretching);
      const std::vector<Kernel::Point_2> domain = random_domain_points(random, 2000);
      const std::vector<Point_2> points = with_varying_tensor(domain, frequency, stretching);
      Delaunay one_by_one;
      insert(one_by_one, points);
      expect_valid(one_by_one, domain.size());
      const Delaunay sorted(points.begin(), points.end());
      expect_valid(sorted, domain.size());
    }
}

TEST(Anisotropic_traits, varying_tensor_makes_every_edge_opposite_the_last_vertex_locally_delaunay)
{
  Random_input random(8);
  const Traits traits;
  const auto inside = traits.side_of_oriented_circle_2_object();
  Delaunay t;
  Delaunay::Face_handle hint;
  for(const Point_2& p : with_varying_tensor(random_domain_points(random, 2000), 10, 2)) {
    const Delaunay::Vertex_handle v = t.insert(p, hint);
    hint = v->face();
    if(t.dimension() < 2)
      continue;
    auto around = t.incident_faces(v), end = around;
    do {
      const int i = around->index(v);
      if(t.is_infinite(around) || t.is_infinite(around->neighbor(i)))
        continue;
      EXPECT_NE(inside(around->vertex(0)->point(), around->vertex(1)->point(), around->vertex(2)->point(),
                       t.mirror_vertex(around, i)->point()), CGAL::ON_POSITIVE_SIDE);
    } while(++around != end);
  }
}

// The constraints first, under the Euclidean metric, then the points with theirs: the order that ends under any field.
TEST(Anisotropic_traits, varying_tensor_keeps_the_constraints)
{
  Random_input random(9);
  for(double frequency : {0.5, 3., 20., 1000.}) {
    SCOPED_TRACE(::testing::Message() << "frequency " << frequency);
    const std::vector<Kernel::Point_2> polygon = random_polygon(random, 60);
    const std::vector<Edge> constraints = polygon_edges(polygon.size());
    const std::vector<Point_2> boundary(polygon.begin(), polygon.end());
    Constrained_Delaunay t;
    insert(t, boundary, constraints);
    insert(t, with_varying_tensor(random_domain_points(random, 2000), frequency, 2));
    expect_valid(t, polygon.size() + 2000);
    EXPECT_EQ(number_of_kept_constraints(t, boundary, constraints), constraints.size());
  }
}
