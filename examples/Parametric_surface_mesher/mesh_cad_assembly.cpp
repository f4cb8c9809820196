// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An assembly of two plates and the bolt through them, as one complex: where parts touch, both have the same triangles.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/make_parametric_surface_triangle_soup.h>

// These come after the headers of CGAL, because Open CASCADE defines a macro `Handle`.
#include <CGAL/fuse_open_cascade_solids.h>
#include <CGAL/make_model_of_open_cascade_shape.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>

#include <array>
#include <cstddef>
#include <iostream>
#include <map>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Open_cascade_model_3::Model Model;

// The parts lie beside each other, and know nothing of each other.
TopoDS_Shape make_assembly()
{
  const TopoDS_Shape bolt = BRepPrimAPI_MakeCylinder(gp_Ax2({20, 15, 0}, {0, 0, 1}), 5, 10).Shape();
  TopoDS_Compound assembly;
  BRep_Builder builder;
  builder.MakeCompound(assembly);
  builder.Add(assembly, BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40, 30, 4).Shape(), bolt).Shape());
  builder.Add(assembly, BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(10, 0, 4), 40, 30, 6).Shape(), bolt).Shape());
  builder.Add(assembly, bolt);
  return assembly;
}

int main()
{
  const CGAL::Fused_open_cascade_solids fused = CGAL::fuse_open_cascade_solids(make_assembly());
  for(const auto& contact : fused.contacts)
    std::cout << "parts " << contact.first + 1 << " and " << contact.second + 1 << " touch: " << contact.area << " square millimetres\n";

  const CGAL::Open_cascade_model_3 shape = CGAL::make_model_of_open_cascade_shape(fused.shape);
  CGAL::Parametric_surface_mesh_criteria criteria;
  criteria.set_max_edge(shape.diagonal / 15).set_distance(1e-3 * shape.diagonal).set_closeness(1.8);
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::size_t> patches;
  CGAL::make_parametric_surface_triangle_soup(shape.model, criteria, points, triangles, patches);
  std::cout << triangles.size() << " triangles with " << points.size() << " points\n";

  // A triangle of a contact has a part on either side: the shell of its face, and that of the other side of the face.
  std::map<std::size_t, std::size_t> behind;
  for(const Model::Face& face : shape.model.faces())
    if(face.other_side_of != Model::no_face)
      behind[face.other_side_of] = face.shell;
  std::map<std::size_t, std::size_t> numbers;
  std::size_t number_of_shared = 0;
  for(const std::size_t patch : patches) {
    ++numbers[shape.model.faces()[patch].shell];
    const auto other = behind.find(patch);
    if(other != behind.end()) {
      ++numbers[other->second];
      ++number_of_shared;
    }
  }
  for(const auto& part : numbers)
    std::cout << "part " << part.first + 1 << " is closed by " << part.second << " triangles\n";
  std::cout << number_of_shared << " triangles belong to two parts\n";
  return fused.contacts.size() == 3 && number_of_shared > 0 ? 0 : 1;
}
