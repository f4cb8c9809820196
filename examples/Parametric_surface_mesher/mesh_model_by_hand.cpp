// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tin, built from vertices, edges and faces: a side that closes on itself along a seam, and two round lids. Its mesh is
// closed. On the upper lid it follows a line, and has a vertex at a point with short edges around it.
#include <CGAL/Any_parametric_surface_3.h>
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Parametric_surface_model_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_parametric_surface_mesh.h>
#include <CGAL/Parametric_surface_mesher/orient_faces.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <utility>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

const double turn = 8 * std::atan(1.), tin_height = 1.5;

// The faces of a model have surfaces of one type: one that holds any surface.
typedef CGAL::Any_parametric_surface_3<Kernel> Surface;

const Surface side_of_tin = CGAL::make_parametric_function_surface([](auto u, auto v) {
  using std::cos;
  using std::sin;
  return CGAL::parametric_surface_point(cos(u), sin(u), v);
});

Surface lid(double h)
{
  return CGAL::Parametric_plane_3<Kernel>(Kernel::Point_3(0, 0, h), {1, 0, 0}, {0, 1, 0});
}

int main()
{
  typedef CGAL::Parametric_surface_model_3<Surface> Model;
  typedef Model::Curve Curve;
  typedef Kernel::Point_2 Point_2;

  Model model;
  const std::size_t below = model.add_vertex({1, 0, 0}), above = model.add_vertex({1, 0, tin_height});
  const std::size_t bottom = model.add_edge(below, below), top = model.add_edge(above, above),
                    seam = model.add_edge(below, above);

  // The side: once around, up the seam, back around, down the seam. All uses of an edge have the same parameters along it.
  const Point_2 a(0, 0), b(turn, 0), c(turn, tin_height), d(0, tin_height);
  model.add_face({side_of_tin,
                  {{{bottom, false, Curve::segment(a, b)},
                    {seam, false, Curve::segment(b, c)},
                    {top, true, Curve::segment(d, c)},
                    {seam, true, Curve::segment(a, d)}}}});
  // The lids: a circle each, from angle 0 to a full turn as the parameter of the segments above goes from 0 to 1.
  const auto circle = Curve::from_function([](auto t) {
    using std::cos;
    using std::sin;
    return std::make_pair(cos(turn * t), sin(turn * t));
  }, 0, 1);
  model.add_face({lid(0), {{{bottom, false, circle}}}});
  const std::size_t upper_lid = model.add_face({lid(tin_height), {{{top, false, circle}}}});
  // A line inside the upper lid, from its centre to a vertex of the boundary, and a point.
  const std::size_t center = model.add_vertex({0, 0, tin_height}), line = model.add_edge(center, above);
  model.add_inner_edge(upper_lid, line, Curve::segment({0, 0}, {1, 0}));
  model.add_inner_point(upper_lid, model.add_vertex({-0.5, 0, tin_height}), {-0.5, 0}, 0.02);
  CGAL::Parametric_surface_mesher::orient_faces(model); // the lower lid is turned over: a closed model faces outward

  Mesh mesh;
  const auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  const auto places = mesh.add_property_map<Mesh::Edge_index, CGAL::Parametric_surface_mesher::Edge_place>("e:place").first;
  const auto report = CGAL::make_parametric_surface_mesh(
    model, CGAL::Parametric_surface_mesh_criteria().set_max_edge(0.1), mesh,
    CGAL::parameters::face_patch_id_map(patch, CGAL::parameters::edge_place_map(places)));

  std::size_t on_lids = 0, on_line = 0;
  for(const auto face : mesh.faces())
    on_lids += patch[face] > 0;
  for(const auto edge : mesh.edges())
    on_line += places[edge].index == line;
  std::cout << report.number_of_faces << " triangles, " << on_lids << " of them on the lids; " << on_line
            << " edges on the line; smallest angle " << report.smallest_angle << " degrees; " << (CGAL::is_closed(mesh) ? "closed" : "open") << "\n";
  return CGAL::is_closed(mesh) && on_line >= 10 && report.unmet.empty() ? 0 : 1;
}
