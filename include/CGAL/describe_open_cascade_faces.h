// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DESCRIBE_OPEN_CASCADE_FACES_H
#define CGAL_DESCRIBE_OPEN_CASCADE_FACES_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <GeomAbs_SurfaceType.hxx>
#include <TopAbs_Orientation.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Dir.hxx>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

What a face of a shape of Open CASCADE is, for lists that people choose faces from.

\sa `CGAL::describe_open_cascade_faces()`
*/
struct Open_cascade_face_3
{
  /// its surface: `plane`, `cylinder`, `cone`, `sphere`, `torus`, `Bezier`, `B-spline`, `revolution`, `extrusion`, `offset` or `other`
  std::string kind;
  double area = 0;
  std::array<double, 3> center{{0, 0, 0}}; ///< the centre of gravity
  /// the normal of a plane, out of the solid; the axis of a cylinder, cone, torus or surface of revolution, the direction of an extrusion
  std::optional<std::array<double, 3>> direction;
  std::optional<double> radius; ///< of a cylinder or sphere
  std::string fault;            ///< what Open CASCADE says if it cannot measure the face, or nothing
};

namespace Parametric_surface_mesher {
namespace internal {

inline std::string kind_of_surface(GeomAbs_SurfaceType type)
{
  switch(type) {
  case GeomAbs_Plane: return "plane";
  case GeomAbs_Cylinder: return "cylinder";
  case GeomAbs_Cone: return "cone";
  case GeomAbs_Sphere: return "sphere";
  case GeomAbs_Torus: return "torus";
  case GeomAbs_BezierSurface: return "Bezier";
  case GeomAbs_BSplineSurface: return "B-spline";
  case GeomAbs_SurfaceOfRevolution: return "revolution";
  case GeomAbs_SurfaceOfExtrusion: return "extrusion";
  case GeomAbs_OffsetSurface: return "offset";
  default: return "other";
  }
}

// The direction of a surface that has one.
inline std::optional<gp_Dir> direction_of_surface(const BRepAdaptor_Surface& surface)
{
  switch(surface.GetType()) {
  case GeomAbs_Plane: // its axes may be left-handed
    return surface.Plane().Direct() ? surface.Plane().Axis().Direction() : surface.Plane().Axis().Direction().Reversed();
  case GeomAbs_Cylinder: return surface.Cylinder().Axis().Direction();
  case GeomAbs_Cone: return surface.Cone().Axis().Direction();
  case GeomAbs_Torus: return surface.Torus().Axis().Direction();
  case GeomAbs_SurfaceOfRevolution: return surface.AxeOfRevolution().Direction();
  case GeomAbs_SurfaceOfExtrusion: return surface.Direction();
  default: return std::nullopt;
  }
}

inline void describe_face(const TopoDS_Face& face, Open_cascade_face_3& result)
{
  const BRepAdaptor_Surface surface(face);
  result.kind = kind_of_surface(surface.GetType());
  if(const auto direction = direction_of_surface(surface)) {
    const bool is_turned = surface.GetType() == GeomAbs_Plane && face.Orientation() == TopAbs_REVERSED;
    const gp_Dir d = is_turned ? direction->Reversed() : *direction;
    result.direction = {{d.X(), d.Y(), d.Z()}};
  }
  if(surface.GetType() == GeomAbs_Cylinder)
    result.radius = surface.Cylinder().Radius();
  else if(surface.GetType() == GeomAbs_Sphere)
    result.radius = surface.Sphere().Radius();
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(face, properties);
  const gp_Pnt center = properties.CentreOfMass();
  result.area = properties.Mass();
  result.center = {{center.X(), center.Y(), center.Z()}};
}

} // namespace internal
} // namespace Parametric_surface_mesher

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

returns the kind, area and centre of each face of a shape, in the order of `TopExp::MapShapes()`. Lengths are in the unit of the shape.
A face that Open CASCADE cannot measure has a `fault`, and what was found before.
*/
inline std::vector<Open_cascade_face_3> describe_open_cascade_faces(const TopoDS_Shape& shape)
{
  using namespace Parametric_surface_mesher::internal;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  std::vector<Open_cascade_face_3> result(faces.Extent());
  for(int f = 1; f <= faces.Extent(); ++f) {
    Open_cascade_face_3& face = result[f - 1];
    try {
      guarded([&] { describe_face(TopoDS::Face(faces(f)), face); });
    }
    catch(const Parametric_surface_mesh_error& error) {
      face.fault = error.what();
    }
  }
  return result;
}

} // namespace CGAL

#endif // CGAL_DESCRIBE_OPEN_CASCADE_FACES_H
