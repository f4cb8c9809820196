// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A loop of a solver and its estimate of the error: mesh, solve, estimate, and mesh again with shorter edges where the error is too large.
// Here, the solution is a known function on the teapot, hot at the tip of its spout; a solver would compute it.
// Faces where nothing changes keep their triangles and are not meshed again.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_bezier_patches.h>
#include <CGAL/Interpolated_sizing_field_3.h>
#include <CGAL/Least_sizing_field_3.h>
#include <CGAL/Parametric_surface_mesher/Kept_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Least_sizing_field_3<Point_3> Sizing_field;

const double longest_edge = 0.4, bound_of_error = 0.02;

double solution(const Point_3& p)
{
  const Point_3 hot(3.2, 0, 2.4);
  return std::exp(-10 * squared_distance(p, hot));
}

struct Element
{
  std::array<Mesh::Vertex_index, 3> nodes;
  double area, length; // of an equilateral triangle with this area
  Vector_3 gradient;   // of the solution
};

std::vector<Element> elements(const Mesh& mesh, const Mesh::Property_map<Mesh::Vertex_index, double>& values)
{
  std::vector<Element> result;
  for(const auto f : mesh.faces()) {
    Element e;
    std::size_t i = 0;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      e.nodes[i++] = v;
    const Point_3 p[3] = {mesh.point(e.nodes[0]), mesh.point(e.nodes[1]), mesh.point(e.nodes[2])};
    const Vector_3 normal = cross_product(p[1] - p[0], p[2] - p[0]); // twice as long as the area
    e.area = std::sqrt(normal.squared_length()) / 2;
    e.length = std::sqrt(e.area * 4 / std::sqrt(3.));
    e.gradient = CGAL::NULL_VECTOR;
    for(i = 0; i < 3; ++i)
      e.gradient += values[e.nodes[i]] / normal.squared_length() * cross_product(normal, p[(i + 2) % 3] - p[(i + 1) % 3]);
    result.push_back(e);
  }
  return result;
}

// The estimate of Zienkiewicz and Zhu: at each node, the gradient is averaged over the elements around it. The error of an element is
// the difference between its own gradient and the mean of those of its nodes, times its length.
std::vector<double> estimated_errors(const Mesh& mesh, const std::vector<Element>& elements)
{
  std::vector<Vector_3> gradients(mesh.number_of_vertices(), CGAL::NULL_VECTOR);
  std::vector<double> areas(mesh.number_of_vertices(), 0);
  for(const Element& e : elements)
    for(const auto v : e.nodes) {
      gradients[v] += e.area * e.gradient;
      areas[v] += e.area;
    }
  std::vector<double> result;
  for(const Element& e : elements) {
    Vector_3 smooth = CGAL::NULL_VECTOR;
    for(const auto v : e.nodes)
      smooth += gradients[v] / (3 * areas[v]);
    result.push_back(e.length * std::sqrt((smooth - e.gradient).squared_length()));
  }
  return result;
}

// The wanted edge lengths at the nodes: shorter ones where the error of an element is too large, and the longest elsewhere.
// The error is taken as proportional to the square of the length. An element may be longer than was asked for; the new length is then
// a share of what was asked for.
CGAL::Node_values_3 wanted_lengths(const Mesh& mesh, const Sizing_field& lengths, const std::vector<Element>& elements,
                                   const std::vector<double>& errors)
{
  const double least_factor = 0.4; // an estimate on a coarse mesh is not trusted any farther
  const double safety = 0.9;       // the error comes out somewhat below the bound
  CGAL::Node_values_3 result;
  for(const auto v : mesh.vertices())
    result.nodes.push_back({{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}});
  result.values.assign(result.nodes.size(), longest_edge);
  for(std::size_t i = 0; i < elements.size(); ++i) {
    const auto& nodes = elements[i].nodes;
    result.triangles.push_back({{std::size_t(nodes[0]), std::size_t(nodes[1]), std::size_t(nodes[2])}});
    const double factor = (std::max)(least_factor, safety * std::sqrt(bound_of_error / errors[i]));
    if(errors[i] > bound_of_error)
      for(const auto v : nodes)
        result.values[v] = (std::min)({result.values[v], factor * elements[i].length, factor * lengths(mesh.point(v))});
  }
  return result;
}

int main()
try {
  const auto patches = CGAL::IO::read_bezier_patches<Kernel>(PARAMETRIC_SURFACE_MESHER_DATA_DIR "/teapot.bpt");
  auto model = CGAL::make_model_of_rectangular_patches(patches);
  CGAL::Parametric_surface_mesh_criteria criteria;
  criteria.set_max_edge(longest_edge).set_min_edge(0.005).set_gamma(0.3).set_growth(0.2);
  CGAL::Parametric_surface_mesher::Kept_faces<Kernel> kept_faces;
  Sizing_field lengths; // of all rounds: no edge gets longer again, and the loop ends
  lengths.add([](const Point_3&) { return longest_edge; });
  model.set_sizing_field(lengths);
  double error = 1;
  for(int round = 1; round <= 8 && error > bound_of_error; ++round) {
    Mesh mesh;
    CGAL::make_parametric_surface_mesh(model, criteria, mesh, CGAL::parameters::kept_faces(std::ref(kept_faces)));
    const auto values = mesh.add_property_map<Mesh::Vertex_index, double>("v:solution").first;
    for(const auto v : mesh.vertices())
      values[v] = solution(mesh.point(v)); // a solver's part
    const std::vector<Element> all = elements(mesh, values);
    const std::vector<double> errors = estimated_errors(mesh, all);
    error = *std::max_element(errors.begin(), errors.end());
    std::cout << "round " << round << ": " << mesh.number_of_faces() << " triangles, largest error " << error << ", "
              << kept_faces.number_of_kept_faces() << " of " << model.faces().size() << " faces kept\n";
    lengths.add(CGAL::Interpolated_sizing_field_3<Kernel>(wanted_lengths(mesh, lengths, all, errors)));
    model.set_sizing_field(lengths);
  }
  return error <= bound_of_error ? 0 : 1;
}
catch(const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
