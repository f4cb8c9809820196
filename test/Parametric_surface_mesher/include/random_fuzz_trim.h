// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random trimmed domains of all kinds, those that must be refused included.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_FUZZ_TRIM_H
#define PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_FUZZ_TRIM_H

#include <Fuzz_case.h>
#include <Fuzz_random.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

struct Random_fuzz_trim
{
  Fuzz_domain domain;
  std::string name;
  Fuzz_expectation expectation = Fuzz_expectation::MESH;
  double narrowness = 1; // how wide its narrowest place is, over its size
};

// The shapes are made in the square `[-1, 1]^2`, and taken into the domain by a map.
class Random_fuzz_trim_maker
{
  typedef Fuzz_surface::Geom_traits::Point_2 Point_2;
  typedef Fuzz_surface::Geom_traits::Vector_2 Vector_2;
  typedef Fuzz_domain::Curve Curve;
  typedef Fuzz_domain::Loop Loop;
  typedef std::pair<double, double> Place;
  typedef std::vector<Place> Places;

  static constexpr double two_pi = 6.283185307179586;

  Fuzz_random& m_random;
  Fuzz_map_2 m_map;

public:
  Random_fuzz_trim_maker(Fuzz_random& random, const Fuzz_map_2& map) : m_random(random), m_map(map) {}

  Random_fuzz_trim operator()()
  {
    switch(m_random.integer(0, 9)) {
    case 0: return ring();
    case 1: return strip();
    case 2: return touching_holes();
    case 3: return near_touch();
    case 4: return wrong();
    default: return common();
    }
  }

private:
  Point_2 to_domain(const Place& p) const
  {
    const Place q = m_map(p.first, p.second);
    return Point_2(q.first, q.second);
  }

  static Vector_2 image(const Fuzz_map_2& map, const Vector_2& d)
  {
    return Vector_2(map.a * d.x() + map.b * d.y(), map.c * d.x() + map.d * d.y());
  }

  Loop polygon(Places places)
  {
    if(m_random.chance(0.3))
      std::reverse(places.begin(), places.end());
    std::vector<Point_2> points;
    for(const Place& p : places)
      points.push_back(to_domain(p));
    return Fuzz_domain::polygon(points);
  }

  static Places rectangle(double x, double y, double a, double b)
  {
    return {{x - a, y - b}, {x + a, y - b}, {x + a, y + b}, {x - a, y + b}};
  }

  // corners around `(x,y)`, at distances from `inner` to 1 times `radius`
  Places star(double x, double y, double radius, double inner, int n)
  {
    Places result;
    const double turn = m_random.real(0, 7);
    for(int i = 0; i < n; ++i) {
      const double angle = turn + two_pi * (i + m_random.real(-0.3, 0.3)) / n, r = radius * m_random.real(inner, 1);
      result.emplace_back(x + r * std::cos(angle), y + r * std::sin(angle));
    }
    return result;
  }

  // the closed curve around `(x,y)` with the radius `radius (1 + a cos(k t + p))`, in `n` pieces
  Loop smooth_loop(double x, double y, double radius, double a, int k, int n)
  {
    const Point_2 center = to_domain({x, y});
    const double p = m_random.real(0, 7), turn = m_random.real(0, 7);
    const auto jet = [map = m_map, center, radius, a, k, p](double t) {
      const double r = radius * (1 + a * std::cos(k * t + p)), dr = -radius * a * k * std::sin(k * t + p),
                   ddr = -radius * a * k * k * std::cos(k * t + p), c = std::cos(t), s = std::sin(t);
      return Curve::Jet{center + image(map, Vector_2(r * c, r * s)),
                        image(map, Vector_2(dr * c - r * s, dr * s + r * c)),
                        image(map, Vector_2((ddr - r) * c - 2 * dr * s, (ddr - r) * s + 2 * dr * c))};
    };
    const bool is_reversed = m_random.chance(0.3);
    Loop result;
    for(int i = 0; i < n; ++i) {
      const double begin = turn + two_pi * i / n, end = turn + two_pi * (i + 1) / n;
      result.push_back(is_reversed ? Curve(jet, end, begin) : Curve(jet, begin, end));
    }
    if(is_reversed)
      std::reverse(result.begin(), result.end());
    return result;
  }

  Loop ellipse(double x, double y, double radius) { return smooth_loop(x, y, radius, 0, 1, m_random.integer(1, 4)); }

  // a polygon of cubic curves, which bend outwards or inwards
  Loop curved_polygon(double x, double y, double radius)
  {
    const int n = m_random.integer(3, 7);
    Places corners;
    for(int i = 0; i < n; ++i)
      corners.emplace_back(x + radius * std::cos(two_pi * i / n), y + radius * std::sin(two_pi * i / n));
    Loop result;
    for(int i = 0; i < n; ++i) {
      const Place &p = corners[std::size_t(i)], &q = corners[std::size_t((i + 1) % n)];
      const double bend = m_random.chance(0.3) ? 0 : m_random.real(-0.25, 0.25);
      const Vector_2 d(q.first - p.first, q.second - p.second), side(bend * d.y(), -bend * d.x());
      const Point_2 from = to_domain(p);
      const Vector_2 chord = image(m_map, d), normal = image(m_map, side);
      if(bend == 0)
        result.push_back(Curve::segment(from, to_domain(q)));
      else
        result.push_back(Curve(
          [from, chord, normal](double t) { // bends by t (1 - t) (1 + t)
            return Curve::Jet{from + t * chord + (t - t * t * t) * normal, chord + (1 - 3 * t * t) * normal, -6 * t * normal};
          },
          0, 1));
    }
    return result;
  }

  // all within the unit circle, and around the circle of radius `inner`
  Loop outline(double& inner)
  {
    switch(m_random.integer(0, 5)) {
    case 0: inner = 0.7; return polygon(rectangle(0, 0, m_random.real(0.7, 1), m_random.real(0.7, 1)));
    case 1: inner = 0.45; return polygon(star(0, 0, 1, 0.98, m_random.integer(5, 9)));
    case 2: inner = 0.2; return polygon(star(0, 0, 1, 0.35, m_random.integer(7, 16)));
    case 3: inner = 0.9; return ellipse(0, 0, 0.95);
    case 4: inner = 0.35; return smooth_loop(0, 0, 0.7, m_random.real(0.05, 0.4), m_random.integer(2, 9), m_random.integer(1, 5));
    default: inner = 0.3; return curved_polygon(0, 0, 0.95);
    }
  }

  // within a circle
  Loop hole(double x, double y, double radius)
  {
    switch(m_random.integer(0, 5)) {
    case 0: return polygon(rectangle(x, y, 0.7 * radius, radius * m_random.magnitude(0.002, 0.7))); // a slit, perhaps
    case 1: return polygon(star(x, y, radius, 0.5, m_random.integer(5, 9)));
    case 2: return ellipse(x, y, radius);
    case 3: return smooth_loop(x, y, 0.6 * radius, m_random.real(0.1, 0.6), m_random.integer(2, 6), m_random.integer(1, 3));
    case 4: return curved_polygon(x, y, 0.7 * radius);
    default: return polygon({{x - radius, y}, {x + radius, y}, {x, y + radius}});
    }
  }

  Random_fuzz_trim common()
  {
    double inner;
    Random_fuzz_trim result{Fuzz_domain(outline(inner)), "outline"};
    const int n = m_random.chance(0.5) ? 0 : m_random.integer(1, 5);
    const double distance = 0.6 * inner, turn = m_random.real(0, 7);
    const double largest = n > 1 ? (std::min)(0.35 * inner, 0.8 * distance * std::sin(two_pi / (2 * n))) : 0.35 * inner;
    for(int i = 0; i < n; ++i)
      result.domain.add_hole(hole(distance * std::cos(turn + two_pi * i / n), distance * std::sin(turn + two_pi * i / n),
                                  largest * m_random.magnitude(0.02, 1)));
    if(n > 0)
      result.name += " with " + std::to_string(n) + " holes";
    if(m_random.chance(0.15)) {
      prescribe_divisions(result.domain);
      result.name += ", divisions prescribed";
      result.expectation = Fuzz_expectation::ANY;
    }
    return result;
  }

  void prescribe_divisions(Fuzz_domain& domain)
  {
    for(Loop& loop : domain.loops())
      for(Curve& curve : loop)
        if(m_random.chance(0.5))
          curve.set_number_of_edges(unsigned(m_random.integer(1, 40)));
  }

  Random_fuzz_trim ring()
  {
    const double width = m_random.magnitude(0.0005, 0.5);
    Random_fuzz_trim result{Fuzz_domain(ellipse(0, 0, 1)), "ring of width " + std::to_string(width), Fuzz_expectation::ANY, width};
    result.domain.add_hole(ellipse(0, 0, 1 - width));
    return result;
  }

  Random_fuzz_trim strip()
  {
    const double width = m_random.magnitude(1e-4, 0.3);
    return {Fuzz_domain(polygon(rectangle(0, 0, 1, width))), "strip of width " + std::to_string(width), Fuzz_expectation::MESH,
            width};
  }

  // a hole that has a vertex in common with the outline or with another hole
  Random_fuzz_trim touching_holes()
  {
    const Place touch(0.8, m_random.real(-0.25, 0.25));
    Random_fuzz_trim result{Fuzz_domain(polygon({{-0.8, -0.8}, {0.8, -0.8}, touch, {0.8, 0.8}, {-0.8, 0.8}})),
                            "hole that touches the outline"};
    const double size = m_random.magnitude(0.01, 0.5);
    const Places first = {touch, {touch.first - size, touch.second + 0.5 * size}, {touch.first - size, touch.second - 0.3 * size}};
    if(m_random.chance(0.5)) {
      result.domain.add_hole(polygon(first));
      if(m_random.chance(0.4)) {
        result.domain.add_hole(polygon({first[1], {first[1].first - size / 2, first[1].second},
                                        {first[1].first - size / 2, first[1].second + size / 2}}));
        result.name += ", and another one that touches it";
      }
    } else {
      result.name = "two holes that touch";
      result.domain.add_hole(polygon({{0, 0}, {0.5, 0.1}, {0.4, 0.5}}));
      result.domain.add_hole(polygon({{0, 0}, {-size, 0.3 * size}, {-size, -0.2 * size}}));
    }
    return result;
  }

  Random_fuzz_trim near_touch()
  {
    const double gap = m_random.magnitude(1e-9, 0.1);
    Random_fuzz_trim result{Fuzz_domain(polygon(rectangle(0, 0, 0.9, 0.9))), "gap of " + std::to_string(gap), Fuzz_expectation::ANY,
                            gap};
    switch(m_random.integer(0, 2)) {
    case 0: result.domain.add_hole(polygon(rectangle(0.5 - gap, 0, 0.4, 0.3))); break;
    case 1: result.domain.add_hole(ellipse(0.5 - gap, 0, 0.4)); break;
    default:
      result.domain.add_hole(ellipse(-0.4, 0, 0.4));
      result.domain.add_hole(ellipse(0.4 + gap, 0, 0.4));
    }
    return result;
  }

  // what must not be meshed
  Random_fuzz_trim wrong()
  {
    Random_fuzz_trim result{Fuzz_domain(polygon(rectangle(0, 0, 0.9, 0.9))), "", Fuzz_expectation::REFUSAL};
    const double x = m_random.real(-0.1, 0.1), y = m_random.real(-0.1, 0.1);
    const auto outline = [&](const char* name, const Places& places) {
      result.name = name;
      result.domain = Fuzz_domain(polygon(places));
    };
    const auto hole = [&](const char* name, const Loop& loop) {
      result.name = name;
      result.domain.add_hole(loop);
    };
    switch(m_random.integer(0, 9)) {
    case 0: outline("outline that crosses itself", {{-1, -1 + x}, {1, 1}, {1, -1}, {-1, 1 + y}}); break;
    case 1: hole("hole outside", ellipse(3 + x, y, 0.4)); break;
    case 2: hole("hole across the outline", ellipse(0.9 + x, y, 0.4)); break;
    case 3:
      hole("", polygon(rectangle(x, y, 0.5, 0.5)));
      hole("hole in a hole", ellipse(x, y, 0.3));
      break;
    case 4:
      hole("", polygon(rectangle(-0.2, 0, 0.4, 0.4)));
      hole("holes that cross", ellipse(0.3 + x, y, 0.4));
      break;
    case 5:
      outline("outline with a side run through twice", {{-1, -1}, {1, -1}, {1, 1}, {x, 1}, {x, y}, {x, 1}, {-1, 1}});
      result.expectation = Fuzz_expectation::ANY; // rounding may part the two
      break;
    case 6:
      outline("outline of no area", {{-1, -1}, {1, 1}, {0, 0}});
      result.expectation = Fuzz_expectation::ANY; // rounding may give it some
      break;
    case 7:
      result.name = "open outline";
      result.domain = Fuzz_domain(Loop{Curve::segment(to_domain({-1, -1}), to_domain({1, -1})),
                                       Curve::segment(to_domain({1, -1}), to_domain({x, 1}))});
      break;
    case 8:
      hole("hole that is the outline", polygon(rectangle(0, 0, 0.9, 0.9)));
      result.expectation = Fuzz_expectation::ANY; // rounding may part the two
      break;
    default: hole("hole around the outline", polygon(rectangle(x, y, 2, 2))); break;
    }
    return result;
  }
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_RANDOM_FUZZ_TRIM_H
