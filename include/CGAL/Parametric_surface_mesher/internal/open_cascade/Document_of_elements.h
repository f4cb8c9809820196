// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_DOCUMENT_OF_ELEMENTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_DOCUMENT_OF_ELEMENTS_H

#include <CGAL/Element_mesh_3.h>

#include <BRep_Builder.hxx>
#include <Poly_Array1OfTriangle.hxx>
#include <Poly_Triangle.hxx>
#include <Poly_Triangulation.hxx>
#include <Quantity_Color.hxx>
#include <Quantity_ColorRGBA.hxx>
#include <Standard_Version.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Makes a document of Open CASCADE's XDE of an element mesh, for its writers: a part is a compound of
// faces, one for each colour, that have triangles and no surface.
class Document_of_elements
{
  typedef std::array<float, 4> Rgba;
  // A node on one surface: its normal differs from that on a surface beside it.
  typedef std::pair<std::size_t, std::size_t> Corner;

  // What has one colour in one part.
  struct Patch
  {
    std::map<Corner, int> corners; // with their numbers from 1
    std::vector<std::size_t> nodes;
    std::vector<std::array<int, 3>> triangles;
  };

  const Element_mesh_3& m_mesh;
  opencascade::handle<TDocStd_Document> m_document = new TDocStd_Document("BinXCAF");
  opencascade::handle<XCAFDoc_ShapeTool> m_shapes = XCAFDoc_DocumentTool::ShapeTool(m_document->Main());
  opencascade::handle<XCAFDoc_ColorTool> m_colors = XCAFDoc_DocumentTool::ColorTool(m_document->Main());

public:
  Document_of_elements(const Element_mesh_3& mesh, const std::string& title) : m_mesh(mesh)
  {
    const TDF_Label root = m_shapes->NewShape();
    set_name(root, title);
    const std::size_t number_of_parts = mesh.parts.size();
    std::vector<std::map<Rgba, Patch>> parts(number_of_parts + 1); // the last one is for triangles without a part
    for(std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& t = mesh.triangles[i];
      const std::size_t s = mesh.triangle_surfaces[i];
      const auto& surface = mesh.surfaces[s];
      add_triangle({t[0], t[1], t[2]}, s, parts[(std::min)(surface.parts[0], number_of_parts)][rgba(surface)]);
      if(surface.parts[1] < number_of_parts)
        add_triangle({t[0], t[2], t[1]}, s, parts[surface.parts[1]][rgba(surface)]);
    }
    for(std::size_t p = 0; p <= number_of_parts; ++p)
      if(!parts[p].empty())
        add_part(root, p < number_of_parts ? mesh.parts[p].name : "faces", parts[p]);
    m_shapes->UpdateAssemblies();
  }

  const opencascade::handle<TDocStd_Document>& document() const { return m_document; }

private:
  static void set_name(const TDF_Label& label, const std::string& name)
  {
    TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
  }

  static Rgba rgba(const Element_mesh_3::Entity& surface)
  {
    const Element_mesh_3::Color gray{0.75, 0.75, 0.75, 1}, color = surface.color.value_or(gray);
    return {{float(color.red), float(color.green), float(color.blue), float(color.opacity)}};
  }

  static void add_triangle(const std::array<std::size_t, 3>& nodes, std::size_t surface, Patch& patch)
  {
    std::array<int, 3> triangle;
    for(std::size_t k = 0; k < 3; ++k) {
      const auto found = patch.corners.emplace(Corner(nodes[k], surface), int(patch.nodes.size()) + 1);
      if(found.second)
        patch.nodes.push_back(nodes[k]);
      triangle[k] = found.first->second;
    }
    patch.triangles.push_back(triangle);
  }

  gp_Pnt point(std::size_t node) const
  {
    const auto& p = m_mesh.nodes[node];
    return gp_Pnt(p[0], p[1], p[2]);
  }

  opencascade::handle<Poly_Triangulation> triangulation(const Patch& patch) const
  {
    TColgp_Array1OfPnt points(1, int(patch.nodes.size()));
    Poly_Array1OfTriangle triangles(1, int(patch.triangles.size()));
    std::vector<gp_Vec> normals(patch.nodes.size());
    for(std::size_t i = 0; i < patch.nodes.size(); ++i)
      points.SetValue(int(i) + 1, point(patch.nodes[i]));
    for(std::size_t i = 0; i < patch.triangles.size(); ++i) {
      const auto& t = patch.triangles[i];
      triangles.SetValue(int(i) + 1, Poly_Triangle(t[0], t[1], t[2]));
      const gp_Vec area = gp_Vec(points(t[0]), points(t[1])).Crossed(gp_Vec(points(t[0]), points(t[2])));
      for(const int corner : t)
        normals[std::size_t(corner) - 1] += area;
    }
    const opencascade::handle<Poly_Triangulation> result = new Poly_Triangulation(points, triangles);
#if OCC_VERSION_HEX >= 0x070600
    result->AddNormals();
    for(std::size_t i = 0; i < normals.size(); ++i)
      result->SetNormal(int(i) + 1, normals[i].SquareMagnitude() > 0 ? gp_Dir(normals[i]) : gp_Dir(0, 0, 1));
#endif
    return result;
  }

  void add_part(const TDF_Label& root, const std::string& name, const std::map<Rgba, Patch>& patches) const
  {
    BRep_Builder builder;
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    std::vector<std::pair<TopoDS_Face, Rgba>> faces;
    for(const auto& patch : patches) {
      TopoDS_Face face;
      builder.MakeFace(face, triangulation(patch.second));
      builder.Add(compound, face);
      faces.emplace_back(face, patch.first);
    }
    const TDF_Label product = m_shapes->AddShape(compound, false);
    set_name(product, name);
    for(const auto& face : faces) {
      const Rgba& c = face.second;
      m_colors->SetColor(m_shapes->AddSubShape(product, face.first),
                         Quantity_ColorRGBA(Quantity_Color(c[0], c[1], c[2], Quantity_TOC_sRGB), c[3]), XCAFDoc_ColorSurf);
    }
    set_name(m_shapes->AddComponent(root, product, TopLoc_Location()), name);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_DOCUMENT_OF_ELEMENTS_H
