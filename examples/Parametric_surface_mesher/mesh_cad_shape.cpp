// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A shape that Open CASCADE builds, meshed without a file in between: a box with a hole, finer around the hole. Writes
// drilled_box.off, or the file of the first argument.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/make_parametric_surface_mesh.h>

// These come after the headers of CGAL, because Open CASCADE defines a macro `Handle`.
#include <CGAL/make_model_of_open_cascade_shape.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Ax2.hxx>

#include <algorithm>
#include <cmath>
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
  const auto face_of_shape = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:face").first;
  const auto report
    = CGAL::make_parametric_surface_mesh(shape.model, criteria, mesh, CGAL::parameters::face_patch_id_map(face_of_shape));
  std::cout << shape.model.faces().size() << " faces, " << report.number_of_faces << " triangles, smallest angle "
            << report.smallest_angle << " degrees, " << (CGAL::is_closed(mesh) ? "closed" : "NOT CLOSED") << "\n";
  return CGAL::IO::write_OFF(argc > 1 ? argv[1] : "drilled_box.off", mesh) ? 0 : 1;
}
