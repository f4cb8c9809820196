// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A shape that Open CASCADE builds, meshed without a file in between: a box with a hole, finer around the hole. Writes
// drilled_box.msh for Gmsh, or the file of the first argument, in which the face of the hole is called "hole".
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_parametric_surface_mesh.h>

// These come after the headers of CGAL, because Open CASCADE defines a macro `Handle`.
#include <CGAL/IO/write_MSH.h>
#include <CGAL/make_element_mesh.h>
#include <CGAL/make_model_of_open_cascade_shape.h>
#include <CGAL/name_open_cascade_bodies.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char** argv)
{
  const gp_Ax2 axis(gp_Pnt(20, 15, -1), gp_Dir(0, 0, 1));
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(axis, 5, 12).Shape();
  const TopoDS_Shape part = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40, 30, 10).Shape(), drill).Shape();

  CGAL::Open_cascade_model_3 shape = CGAL::make_model_of_open_cascade_shape(part);
  for(const auto& face : shape.left_out)
    std::cout << "face " << face.shape_face + 1 << " is left out: " << face.reason << "\n";

  // the wanted edge lengths depend on the distance from the axis of the hole
  shape.model.set_sizing_field([](const Kernel::Point_3& p) {
    return 0.5 + 0.2 * (std::max)(std::hypot(p.x() - 20, p.y() - 15) - 5, 0.);
  });
  CGAL::Parametric_surface_mesh_criteria criteria;
  criteria.set_max_edge(shape.diagonal / 15).set_distance(1e-3 * shape.diagonal).set_closeness(1.8);

  Mesh mesh;
  namespace parameters = CGAL::parameters;
  namespace psm = CGAL::Parametric_surface_mesher;
  const auto places = parameters::face_patch_id_map(
    mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first,
    parameters::halfedge_uv_map(mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first,
                                parameters::vertex_place_map(mesh.add_property_map<Mesh::Vertex_index, psm::Vertex_place>("v:place").first,
                                                             parameters::edge_place_map(mesh.add_property_map<Mesh::Edge_index, psm::Edge_place>("e:place").first))));
  const auto report = CGAL::make_parametric_surface_mesh(shape.model, criteria, mesh, places);
  std::cout << shape.model.faces().size() << " faces, " << report.number_of_faces << " triangles, smallest angle "
            << report.smallest_angle << " degrees, " << (CGAL::is_closed(mesh) ? "closed" : "NOT CLOSED") << "\n";

  CGAL::Open_cascade_names_3 names = CGAL::name_open_cascade_bodies(part, "drilled box");
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(part, TopAbs_FACE, faces);
  for(int f = 1; f <= faces.Extent(); ++f)
    if(BRepAdaptor_Surface(TopoDS::Face(faces(f))).GetType() == GeomAbs_Cylinder)
      names.face_names[std::size_t(f) - 1] = "hole";
  std::ofstream out(argc > 1 ? argv[1] : "drilled_box.msh");
  return CGAL::IO::write_MSH(out, CGAL::make_element_mesh(shape, names, mesh, places)) ? 0 : 1;
}
