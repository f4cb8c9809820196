// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef OPEN_CASCADE_TEST_HELPERS_H
#define OPEN_CASCADE_TEST_HELPERS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include "Cad_mesh_judge.h"

#include <CGAL/make_model_of_open_cascade_shape.h>

#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>

#include <algorithm>
#include <cstddef>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// the criteria that mesh_cad takes by default
inline CGAL::Parametric_surface_mesh_criteria cad_criteria(double diagonal)
{
  CGAL::Parametric_surface_mesh_criteria criteria;
  criteria.set_max_edge(diagonal / 20).set_min_edge(diagonal / 1000);
  return criteria.set_distance(5e-4 * diagonal).set_closeness(1.8);
}

struct Meshed_shape
{
  CGAL::Open_cascade_model_3 shape;
  Mesh mesh;
  Mesh::Property_map<Mesh::Face_index, std::size_t> patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  CGAL::Parametric_surface_mesh_report report;
  CGAL::Triangle_mesh_quality quality;

  explicit Meshed_shape(const TopoDS_Shape& s) : Meshed_shape(s, cad_criteria) {}

  // `criteria`: makes criteria of the diagonal
  template <class Criteria>
  Meshed_shape(const TopoDS_Shape& s, const Criteria& criteria) : shape(CGAL::make_model_of_open_cascade_shape(s))
  {
    namespace parameters = CGAL::parameters;
    report = CGAL::make_parametric_surface_mesh(shape.model, criteria(shape.diagonal), mesh,
                                                parameters::face_patch_id_map(patch, parameters::leaves_out_bad_faces(true)));
    quality = CGAL::triangle_mesh_quality(mesh);
  }

  Judged_mesh judged() const
  {
    Judged_mesh result;
    for(const auto v : mesh.vertices())
      result.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
    for(const auto f : mesh.faces()) {
      std::array<std::size_t, 3> triangle;
      auto corner = triangle.begin();
      for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        *corner++ = v;
      result.triangles.push_back(triangle);
      result.face_ids.push_back(shape.shape_faces[patch[f]] + 1);
    }
    for(const auto& face : shape.closed_up)
      result.closed_up_faces.push_back(face.shape_face + 1);
    return result;
  }

  double volume() const { return CGAL::Polygon_mesh_processing::volume(mesh); }
};

inline TopoDS_Compound compound_of(const std::vector<TopoDS_Shape>& shapes)
{
  BRep_Builder builder;
  TopoDS_Compound result;
  builder.MakeCompound(result);
  for(const TopoDS_Shape& shape : shapes)
    builder.Add(result, shape);
  return result;
}

inline double volume_of(const TopoDS_Shape& shape)
{
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

#endif // OPEN_CASCADE_TEST_HELPERS_H
