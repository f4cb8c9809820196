// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces, curves and models for Python, without the types of CGAL: the mesher is compiled apart from what Python sees.
#ifndef PYTHON_SURFACE_MESHER_H
#define PYTHON_SURFACE_MESHER_H

#include "Formula.h"
#include "Mesh_arrays.h"
#include "Mesh_callbacks.h"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

typedef std::array<double, 2> Pair;
typedef std::array<double, 3> Triple;
typedef std::array<double, 4> Rectangle; // u_min, u_max, v_min, v_max

// A surface of any kind. Copies share it.
class Surface
{
public:
  struct Data;
  typedef std::array<Triple, 6> Jet; // the point, and the derivatives by u, v, uu, uv and vv

private:
  std::shared_ptr<const Data> m_data;
  explicit Surface(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}

public:
  static Surface formula(const Formula& formula); // of u and v, with three results
  // Of functions that must not be called by two threads at the same time.
  static Surface function(std::function<Triple(double, double)> point, std::function<Jet(double, double)> jet);
  static Surface bezier(int degree_u, int degree_v, const std::vector<Triple>& control_points);
  static Surface b_spline(int degree_u, int degree_v, const std::vector<double>& knots_u, const std::vector<double>& knots_v,
                          const std::vector<Triple>& control_points, const std::vector<double>& weights);
  static std::vector<Surface> read_bezier_patches(const std::string& file_name);

  Jet jet(double u, double v) const;
  const std::optional<Rectangle>& domain() const; // of a surface that has one
  const Data& data() const { return *m_data; }
};

// A curve in the domain of a surface.
class Curve
{
public:
  struct Data;
  typedef std::array<Pair, 3> Jet; // the point and two derivatives

private:
  std::shared_ptr<const Data> m_data;
  explicit Curve(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}

public:
  static Curve segment(const Pair& from, const Pair& to);
  static Curve arc(const Pair& center, double radius, double begin, double end);
  static Curve circle(const Pair& center, double radius);
  static Curve formula(const Formula& formula, double begin, double end); // of t, with two results
  static Curve function(std::function<Jet(double)> jet, double begin, double end);

  Pair source() const;
  Pair target() const;
  const Data& data() const { return *m_data; }
};

typedef std::vector<Curve> Loop;

// What meshes are to be like. What is not given has the default of the mesher.
struct Criteria
{
  std::optional<double> max_edge, min_edge, gamma, angle, distance, detail, growth, closeness, size_factor;
  std::optional<unsigned int> sweeps;
  std::string self_intersections = "ignore";
  unsigned int threads = 1;
};

// The mesh of a model, with all that is known about it.
class Meshed_model
{
  struct Data;
  std::shared_ptr<const Data> m_data;
  friend class Surface_model;

public:
  Mesh_arrays arrays() const;
  std::string json() const;
  std::string summary() const; // a few lines for people
  std::string page() const;    // for a browser
  bool is_whole() const;       // whether the summary says that nothing is wrong
  void save(const std::string& file_name, bool is_binary) const;
};

// Faces that share edges.
class Surface_model
{
  struct Data;
  std::shared_ptr<Data> m_data;

public:
  struct Use
  {
    std::size_t edge;
    bool is_reversed;
    Curve curve;
  };

  Surface_model();
  // Of one surface over a domain; the outer loop comes first.
  static Surface_model patch(const Surface& surface, const std::vector<Loop>& loops);
  // Of surfaces over rectangles, whose sides become one edge where they are within `tolerance`; 0 for the default.
  static Surface_model joined(const std::vector<Surface>& surfaces, const std::vector<Rectangle>& rectangles, double tolerance);

  std::size_t add_vertex(const Triple& point);
  std::size_t add_edge(std::size_t source, std::size_t target, bool is_collapsed, double max_edge);
  std::size_t add_face(const Surface& surface, const std::vector<std::vector<Use>>& loops, bool is_reversed, double max_edge);
  void add_hole(std::size_t face, const Loop& loop);
  void orient_faces();
  void set_tolerance(double tolerance);

  std::array<std::size_t, 3> numbers() const; // of vertices, edges and faces
  Meshed_model mesh(const Criteria& criteria, const Mesh_callbacks& callbacks) const;
};

#endif // PYTHON_SURFACE_MESHER_H
