// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes everything that one run of the mesher takes, at random.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_MAKE_FUZZ_CASE_H
#define PARAMETRIC_SURFACE_MESHER_TEST_MAKE_FUZZ_CASE_H

#include <CGAL/make_model_of_rectangular_patches.h>

#include <Fuzz_case.h>
#include <Fuzz_random.h>
#include <random_fuzz_surface.h>
#include <random_fuzz_trim.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <vector>

class Fuzz_case_maker
{
  typedef Fuzz_kernel::Point_3 Point_3;
  typedef Fuzz_kernel::Vector_3 Vector_3;

  Fuzz_random m_random;
  Fuzz_case m_case;
  std::ostringstream m_description;

  // of what is meshed, by samples
  double m_diagonal = 1, m_area = 1, m_perimeter = 1;
  double m_narrowness = 1;

public:
  explicit Fuzz_case_maker(std::uint64_t seed) : m_random(seed) { m_case.seed = seed; }

  Fuzz_case operator()()
  {
    m_description.precision(17);
    if(m_random.chance(0.12))
      make_model();
    else
      make_patch();
    set_criteria();
    set_metric();
    if(m_random.chance(0.08)) {
      m_case.number_of_questions = std::size_t(m_random.magnitude(1, 30));
      m_description << "; stop after " << *m_case.number_of_questions << " questions";
    }
    m_case.has_threads = m_random.chance(0.15);
    if(m_case.has_threads)
      m_description << "; threads";
    m_case.description = m_description.str();
    return m_case;
  }

private:
  void allow_anything() { m_case.expectation = Fuzz_expectation::ANY; }

  // ---- what is meshed

  double random_factor() { return m_random.chance(0.5) ? 1 : m_random.magnitude(1e-6, 1e6); }

  void make_patch()
  {
    Random_fuzz_surface s = Random_fuzz_surface_maker(m_random)();
    const double factor = random_factor();
    s.surface.set_factor(factor);
    s.surface.set_work(m_case.work);
    m_description << s.name << " times " << factor;
    const bool is_whole = m_random.chance(0.2);
    if(is_whole) {
      m_case.domain = Fuzz_domain::rectangle(s.surface.u_min(), s.surface.u_max(), s.surface.v_min(), s.surface.v_max());
      m_description << " over its rectangle";
    } else
      trim(s.surface);
    if(!s.is_regular && m_case.expectation == Fuzz_expectation::MESH)
      allow_anything();
    m_case.surface = s.surface;
    measure(s.surface, *m_case.domain);
  }

  void trim(Fuzz_surface& surface)
  {
    const double u = (surface.u_max() - surface.u_min()) / 2, v = (surface.v_max() - surface.v_min()) / 2;
    const Fuzz_map_2 to_rectangle = {u, 0, 0, v, surface.u_min() + u, surface.v_min() + v};
    Fuzz_map_2 to_domain = to_rectangle;
    if(m_random.chance(0.3)) {
      to_domain = random_map();
      surface.set_map(to_rectangle.after(to_domain.inverse()));
      m_description << " in coordinates (" << to_domain.a << " " << to_domain.b << " " << to_domain.c << " " << to_domain.d << ")";
    }
    Random_fuzz_trim trim = Random_fuzz_trim_maker(m_random, to_domain)();
    m_description << ", " << trim.name;
    m_case.domain = trim.domain;
    m_case.expectation = trim.expectation;
    m_narrowness = trim.narrowness;
  }

  // a rotation, scales, a shear
  Fuzz_map_2 random_map()
  {
    const double t = m_random.real(0, 7), scale = m_random.magnitude(1e-3, 1e3), s = scale * m_random.magnitude(0.01, 100),
                 shear = m_random.real(-1.5, 1.5), c = std::cos(t), d = std::sin(t);
    return {scale * c, shear * scale * c - s * d, scale * d, shear * scale * d + s * c,
            m_random.chance(0.3) ? scale * m_random.real(-10, 10) : 0, 0};
  }

  void measure(const Fuzz_surface& surface, const Fuzz_domain& domain)
  {
    CGAL::Bbox_3 box;
    double u_min = 1e300, u_max = -1e300, v_min = 1e300, v_max = -1e300;
    m_perimeter = 0;
    for(const auto& loop : domain.loops())
      for(const auto& curve : loop) {
        Point_3 last;
        for(int k = 0; k <= 16; ++k) {
          const auto uv = curve.point(k == 16 ? curve.end() : curve.begin() + k / 16. * (curve.end() - curve.begin()));
          const Point_3 p = surface.point(uv.x(), uv.y());
          u_min = (std::min)(u_min, uv.x());
          u_max = (std::max)(u_max, uv.x());
          v_min = (std::min)(v_min, uv.y());
          v_max = (std::max)(v_max, uv.y());
          m_perimeter += k > 0 ? std::sqrt((p - last).squared_length()) : 0;
          last = p;
        }
      }
    m_area = area(surface, u_min, u_max, v_min, v_max, box);
    m_diagonal = std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
    for(double* x : {&m_diagonal, &m_area, &m_perimeter})
      if(!(*x > 0) || !std::isfinite(*x))
        *x = 1;
  }

  static double area(const Fuzz_surface& surface, double u_min, double u_max, double v_min, double v_max, CGAL::Bbox_3& box)
  {
    const int n = 12;
    std::vector<Point_3> points;
    for(int i = 0; i <= n; ++i)
      for(int k = 0; k <= n; ++k) {
        points.push_back(surface.point(u_min + i * (u_max - u_min) / n, v_min + k * (v_max - v_min) / n));
        box += points.back().bbox();
      }
    double result = 0;
    for(int i = 0; i < n; ++i)
      for(int k = 0; k < n; ++k) {
        const Point_3& p = points[std::size_t(i * (n + 1) + k)];
        const Vector_3 across = points[std::size_t((i + 1) * (n + 1) + k)] - p, up = points[std::size_t(i * (n + 1) + k + 1)] - p;
        result += std::sqrt(cross_product(across, up).squared_length());
      }
    return result;
  }

  void make_model()
  {
    std::vector<Fuzz_surface> patches;
    switch(m_random.integer(0, 3)) {
    case 0: append_box(patches); break;
    case 1: append_bezier_grid(patches); break;
    case 2: append_turn(patches); break;
    default: append_boxes_in_a_row(patches); break;
    }
    const double factor = random_factor();
    m_description << " times " << factor;
    CGAL::Bbox_3 box;
    m_area = m_perimeter = 0;
    for(Fuzz_surface& s : patches) {
      s.set_factor(factor);
      m_area += area(s, s.u_min(), s.u_max(), s.v_min(), s.v_max(), box);
    }
    m_diagonal = std::sqrt(CGAL::square(box.x_span()) + CGAL::square(box.y_span()) + CGAL::square(box.z_span()));
    m_perimeter = 2 * std::sqrt(m_area * double(patches.size()));
    for(Fuzz_surface& s : patches)
      s.set_work(m_case.work);
    m_case.model = CGAL::make_model_of_rectangular_patches(patches);
  }

  // a face of the cube, deformed smoothly with the space around
  Fuzz_surface cube_face(int axis, int side, double shift, const std::array<double, 6>& c)
  {
    const auto formula = [axis, side, shift, c](const Second_order_jet& u, const Second_order_jet& v) {
      std::array<Second_order_jet, 3> p;
      p[std::size_t(axis)] = Second_order_jet(side);
      p[std::size_t((axis + 1) % 3)] = side == 1 ? u : v;
      p[std::size_t((axis + 2) % 3)] = side == 1 ? v : u;
      p[0] = p[0] + Second_order_jet(shift);
      return std::array<Second_order_jet, 3>{p[0] + sin(p[1] * 3.) * c[0] + p[2] * c[1], p[1] + sin(p[2] * 2. + p[0]) * c[2],
                                             p[2] + sin(p[0] * 2.) * c[3] + p[1] * p[1] * c[4]};
    };
    return Fuzz_surface(make_fuzz_formula_surface(formula), 0, 1, 0, 1);
  }

  std::array<double, 6> deformation()
  {
    const double size = m_random.chance(0.3) ? 0 : m_random.real(0, 0.2);
    std::array<double, 6> result;
    for(double& x : result)
      x = size * m_random.real(-1, 1);
    return result;
  }

  void append_box(std::vector<Fuzz_surface>& patches)
  {
    const std::array<double, 6> c = deformation();
    const int left_out = m_random.chance(0.3) ? m_random.integer(0, 5) : 6;
    for(int i = 0; i < 6; ++i)
      if(i != left_out)
        patches.push_back(cube_face(i / 2, i % 2, 0, c));
    m_case.is_model_closed = left_out == 6;
    m_description << "box of " << patches.size() << " faces";
  }

  // an edge between two boxes has more than two uses
  void append_boxes_in_a_row(std::vector<Fuzz_surface>& patches)
  {
    const std::array<double, 6> c = deformation();
    const int n = m_random.integer(2, 4);
    for(int k = 0; k < n; ++k)
      for(int i = 0; i < 6; ++i)
        if(i != 0 || k == 0)
          patches.push_back(cube_face(i / 2, i % 2, k, c));
    m_description << n << " boxes in a row";
  }

  void append_bezier_grid(std::vector<Fuzz_surface>& patches)
  {
    const int n = m_random.integer(1, 4), m = m_random.integer(1, 4), degree = m_random.integer(1, 3);
    const int columns = n * degree + 1;
    Random_fuzz_surface_maker maker(m_random);
    const std::vector<Point_3> net = maker.control_net(columns, m * degree + 1);
    for(int j = 0; j < m; ++j)
      for(int i = 0; i < n; ++i) {
        std::vector<Point_3> part;
        for(int l = 0; l <= degree; ++l)
          for(int k = 0; k <= degree; ++k)
            part.push_back(net[std::size_t((j * degree + l) * columns + i * degree + k)]);
        patches.emplace_back(CGAL::Bezier_surface_3<Fuzz_kernel>(degree, degree, part), 0, 1, 0, 1);
      }
    allow_anything(); // patches may be folded
    m_description << n << " x " << m << " Bezier patches of degree " << degree;
  }

  // a surface of revolution that meets itself
  void append_turn(std::vector<Fuzz_surface>& patches)
  {
    const double pi = CGAL_PI;
    Random_fuzz_surface_maker maker(m_random);
    const auto frame = maker.frame();
    switch(m_random.integer(0, 2)) {
    case 0:
      patches.emplace_back(CGAL::Parametric_cylinder_3<Fuzz_kernel>(1, frame), 0, 2 * pi, 0, m_random.magnitude(0.01, 5));
      m_description << "pipe";
      break;
    case 1:
      patches.emplace_back(CGAL::Parametric_torus_3<Fuzz_kernel>(1, m_random.real(0.05, 0.9), frame), 0, 2 * pi, 0, 2 * pi);
      m_description << "torus";
      m_case.is_model_closed = true;
      break;
    default:
      patches.emplace_back(CGAL::Parametric_sphere_3<Fuzz_kernel>(1, frame), 0, 2 * pi, -pi / 2, pi / 2);
      m_description << "sphere";
      m_case.is_model_closed = true;
      break;
    }
  }

  // ---- options

  void set_criteria()
  {
    auto& criteria = m_case.criteria;
    const double largest_number = m_random.magnitude(10, 1500);
    double size = m_diagonal * m_random.magnitude(0.02, 1);
    if(m_random.chance(0.08))
      size = m_diagonal * m_random.magnitude(1, 1e4);
    size = (std::max)({size, std::sqrt(m_area / largest_number), m_perimeter / largest_number});
    if(m_narrowness < 0.1) // fine at its narrowest place, or coarse
      size = (std::max)(size, m_perimeter * m_random.magnitude(1e-3, 1));
    const double min_size = (std::max)(size * m_random.magnitude(0.003, 0.7), m_perimeter / 1500);
    criteria.set_max_edge(size).set_max_number_of_vertices(std::size_t(m_random.chance(0.1) ? m_random.integer(1, 300) : 2500));
    if(criteria.max_number_of_vertices() < 2500 && m_case.expectation == Fuzz_expectation::MESH)
      allow_anything(); // the boundary alone may take more
    if(min_size <= size)
      criteria.set_min_edge(min_size);
    m_description << "; edges " << min_size << " to " << size << ", " << criteria.max_number_of_vertices() << " vertices at most";
    if(m_random.chance(0.7))
      criteria.set_gamma(m_random.magnitude(0.005, 0.5));
    if(m_random.chance(0.5))
      criteria.set_angle(m_random.chance(0.7) ? m_random.real(0, 34) : m_random.real(34, 59));
    if(m_random.chance(0.25))
      criteria.set_distance(m_diagonal * m_random.magnitude(1e-5, 0.1));
    if(m_random.chance(0.2))
      criteria.set_size_factor(m_random.magnitude(0.1, 3));
    if(m_random.chance(0.2))
      criteria.set_growth(m_random.real(0, 1));
    if(m_random.chance(0.25))
      criteria.set_closeness(m_random.real(0.5, 4));
    m_description << "; gamma " << criteria.gamma() << ", angle " << criteria.angle() << ", distance " << criteria.distance().value_or(0)
                  << ", size factor " << criteria.size_factor() << ", growth " << criteria.growth() << ", closeness "
                  << criteria.closeness().value_or(0);
    set_method();
    set_sizing_field();
  }

  void set_method()
  {
    auto& criteria = m_case.criteria;
    const int placement = m_random.integer(0, 3);
    if(placement < 2)
      criteria.set_placement(placement == 0 ? CGAL::Parametric_surface_mesher::Mesh_point_placement::CIRCUMCENTER : CGAL::Parametric_surface_mesher::Mesh_point_placement::OFF_CENTER);
    if(m_random.chance(0.5))
      criteria.set_max_number_of_sweeps(unsigned(m_random.integer(0, 6)));
    if(m_random.chance(0.3))
      criteria.set_improvement_angle(m_random.chance(0.3) ? 0 : m_random.real(0, 59));
    if(m_random.chance(0.3))
      criteria.set_part_size(std::size_t(m_random.magnitude(10, 2000)));
    if(m_random.chance(0.2))
      criteria.set_curve_deviation(CGAL::Parametric_surface_mesher::Curve_deviation::HEIGHT_OVER_RADIUS);
    m_description << "; placement " << int(criteria.placement()) << ", sweeps "
                  << (criteria.max_number_of_sweeps() ? int(*criteria.max_number_of_sweeps()) : -1) << ", improvement "
                  << criteria.improvement_angle() << ", parts " << criteria.part_size();
  }

  void set_sizing_field()
  {
    if(!m_random.chance(0.15))
      return;
    const double size = m_case.criteria.max_edge(), k = m_random.real(-3, 3), l = m_random.real(-3, 3);
    switch(m_random.integer(0, 3)) {
    case 0:
    case 1:
      m_case.criteria.set_sizing_field([=](double u, double v) { return size * (0.6 + 0.4 * std::sin(k * u + l * v)); });
      m_description << "; smooth sizing field";
      break;
    case 2:
      m_case.criteria.set_sizing_field([=](double u, double v) { return k * u + l * v > 0 ? size : 0.2 * size; });
      m_description << "; sizing field with a jump";
      break;
    default:
      m_case.criteria.set_sizing_field([=](double u, double v) { return size * (k * u + l * v); });
      m_description << "; sizing field with negative values";
      allow_anything();
    }
  }

  void set_metric()
  {
    if(!m_random.chance(0.2))
      return;
    const double ratio = m_random.magnitude(1, 1000), c = m_random.real(-1, 1), d = m_random.real(-1, 1), size = m_diagonal;
    typedef CGAL::Metric_tensor_2 Tensor;
    switch(m_random.integer(0, 4)) {
    case 0:
      m_case.metric = Fuzz_metric(CGAL::Principal_curvature_metric_2<Fuzz_kernel>(ratio));
      m_description << "; metric of principal curvatures to " << ratio;
      break;
    case 1: // stretched along u
      m_case.metric = Fuzz_metric([=](const Tensor& m, const Point_3&) { return Tensor(m.e() / ratio, m.f() / std::sqrt(ratio), m.g()); });
      m_description << "; metric stretched by " << ratio;
      break;
    case 2:
      m_case.metric = Fuzz_metric([=](const Tensor& m, const Point_3& p) {
        return c * p.x() + d * p.y() > 0 ? m : Tensor(m.e(), m.f() / 3, m.g() / 9);
      });
      m_description << "; metric with a jump";
      break;
    case 3: // not definite in parts
      m_case.metric = Fuzz_metric([=](const Tensor& m, const Point_3& p) {
        return Tensor(m.e(), m.f() + std::sin(5 * (c * p.x() + d * p.y()) / size) * std::sqrt(m.e() * m.g()), m.g());
      });
      m_description << "; indefinite metric";
      break;
    default: // nearly of rank one
      m_case.metric = Fuzz_metric([=](const Tensor& m, const Point_3&) {
        return Tensor(m.e(), std::sqrt(m.e() * m.g()) * (1 - 1e-9 * ratio), m.g());
      });
      m_description << "; nearly singular metric";
    }
    if(m_case.expectation == Fuzz_expectation::MESH)
      allow_anything();
  }
};

inline Fuzz_case make_fuzz_case(std::uint64_t seed) { return Fuzz_case_maker(seed)(); }

#endif // PARAMETRIC_SURFACE_MESHER_TEST_MAKE_FUZZ_CASE_H
