// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NAMES_COLLECTOR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NAMES_COLLECTOR_H

#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Part_builder.h>

#include <Quantity_ColorRGBA.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDataStd_TreeNode.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_MaterialTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFPrs.hxx>
#include <XCAFPrs_IndexedDataMapOfShapeStyle.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Gathers what a document of Open CASCADE's XDE says of a shape. The parts of the document are the shape's, with the same places.
class Names_collector
{
  typedef Open_cascade_names_3::Part Part;

  const Shape_index& m_index;
  Open_cascade_names_3& m_names;
  Part_builder m_builder;
  std::string m_default_name;
  Handle(XCAFDoc_ShapeTool) m_shapes;
  Handle(XCAFDoc_LayerTool) m_layers;

public:
  // `names` have the names of solids and shells already, if there are any: bodies are called by them.
  Names_collector(const Shape_index& index, Open_cascade_names_3& names, const std::string& default_name)
    : m_index(index), m_names(names), m_builder(index, names), m_default_name(default_name)
  {}

  void operator()(const Handle(TDocStd_Document) & document)
  {
    m_shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    m_layers = XCAFDoc_DocumentTool::LayerTool(document->Main());
    TDF_LabelSequence roots;
    m_shapes->GetFreeShapes(roots);
    for(const TDF_Label& root : roots)
      add(root, TopLoc_Location(), Open_cascade_names_3::none);
    m_builder.add_rest();
    for(Part& part : m_names.parts)
      if(!part.material && part.parent != Open_cascade_names_3::none)
        part.material = m_names.parts[part.parent].material;
    add_colors(roots);
  }

private:
  static std::string utf_8(const TCollection_ExtendedString& text) { return TCollection_AsciiString(text).ToCString(); }

  static std::string name_of(const TDF_Label& label)
  {
    Handle(TDataStd_Name) name;
    const std::string result = label.FindAttribute(TDataStd_Name::GetID(), name) ? utf_8(name->Get()) : "";
    const std::string unnamed_reference = "=>["; // what the reader puts in place of a name
    return result.compare(0, unnamed_reference.size(), unnamed_reference) == 0 ? "" : result;
  }

  void add(const TDF_Label& label, const TopLoc_Location& place, std::size_t parent)
  {
    TDF_Label product = label;
    const bool is_reference = m_shapes->GetReferredShape(label, product);
    const TopLoc_Location location = place * m_shapes->GetLocation(label);
    Part part;
    part.name = name_of(product);
    if(part.name.empty())
      part.name = parent == Open_cascade_names_3::none ? m_default_name : "part_" + std::to_string(m_names.parts.size() + 1);
    if(is_reference)
      part.instance = name_of(label);
    part.parent = parent;
    set_location(location.Transformation(), part);
    part.layers = layers(label);
    if(is_reference)
      for(const std::string& layer : layers(product))
        if(std::find(part.layers.begin(), part.layers.end(), layer) == part.layers.end())
          part.layers.push_back(layer);
    part.material = material(product);
    if(!part.material)
      part.material = material(label);
    TDF_LabelSequence components;
    part.is_assembly = m_shapes->GetComponents(product, components);
    const std::size_t number = m_builder.add(std::move(part));
    for(const TDF_Label& component : components)
      add(component, location, number);
    if(components.IsEmpty())
      add_contents(number, product, location);
  }

  void add_contents(std::size_t part, const TDF_Label& product, const TopLoc_Location& location)
  {
    const std::size_t before = m_names.parts.size();
    m_builder.fill(part, XCAFDoc_ShapeTool::GetShape(product).Moved(location));
    m_names.parts[part].is_assembly = m_names.parts.size() > before;
    TDF_LabelSequence members;
    XCAFDoc_ShapeTool::GetSubShapes(product, members);
    for(const TDF_Label& member : members) {
      if(!m_names.parts[part].material)
        m_names.parts[part].material = material(member); // one of a product; the reader gives it to the product's first solid
      const auto names = layers(member);
      if(!names.empty())
        for(const std::size_t face : faces(XCAFDoc_ShapeTool::GetShape(member).Moved(location)))
          m_names.face_layers[face].insert(m_names.face_layers[face].end(), names.begin(), names.end());
    }
  }

  std::vector<std::size_t> faces(const TopoDS_Shape& shape) const
  {
    return Shape_index::members(m_index.faces, shape, TopAbs_FACE);
  }

  static void set_location(const gp_Trsf& transformation, Part& part)
  {
    for(int row = 1; row <= 3; ++row)
      for(int column = 1; column <= 4; ++column)
        part.location[std::size_t(4 * (row - 1) + column - 1)] = transformation.Value(row, column);
  }

  std::vector<std::string> layers(const TDF_Label& label) const
  {
    std::vector<std::string> result;
    const Handle(TColStd_HSequenceOfExtendedString) names = m_layers->GetLayers(label);
    for(int i = 1; !names.IsNull() && i <= names->Length(); ++i)
      if(!names->Value(i).IsEmpty())
        result.push_back(utf_8(names->Value(i)));
    return result;
  }

  static std::optional<Open_cascade_names_3::Material> material(const TDF_Label& label)
  {
    Handle(TDataStd_TreeNode) node;
    if(!label.FindAttribute(XCAFDoc::MaterialRefGUID(), node) || !node->HasFather())
      return {};
    Handle(TCollection_HAsciiString) name, description, density_name, density_type;
    Open_cascade_names_3::Material result;
    if(!XCAFDoc_DocumentTool::MaterialTool(label)->GetMaterial(node->Father()->Label(), name, description, result.density, density_name,
                                                               density_type))
      return {};
    result.name = name.IsNull() ? "" : name->ToCString();
    result.description = description.IsNull() ? "" : description->ToCString();
    return result;
  }

  static Open_cascade_names_3::Color color(const Quantity_ColorRGBA& c)
  {
    Open_cascade_names_3::Color result;
    c.GetRGB().Values(result.red, result.green, result.blue, Quantity_TOC_sRGB);
    result.opacity = c.Alpha();
    return result;
  }

  // A colour of something small counts more than one of what it is a part of.
  void add_colors(const TDF_LabelSequence& roots)
  {
    struct Colored_faces
    {
      std::vector<std::size_t> faces;
      Open_cascade_names_3::Color color;
    };
    XCAFPrs_IndexedDataMapOfShapeStyle styles;
    for(const TDF_Label& root : roots)
      XCAFPrs::CollectStyleSettings(root, TopLoc_Location(), styles);
    std::vector<Colored_faces> colored;
    for(int i = 1; i <= styles.Extent(); ++i) {
      const TopoDS_Shape& shape = styles.FindKey(i);
      const XCAFPrs_Style& style = styles(i);
      const int edge = shape.ShapeType() == TopAbs_EDGE ? m_index.edges.FindIndex(shape) : 0;
      if(edge > 0 && style.IsSetColorCurv())
        m_names.edge_colors[std::size_t(edge) - 1] = color(Quantity_ColorRGBA(style.GetColorCurv()));
      else if(style.IsSetColorSurf())
        colored.push_back({faces(shape), color(style.GetColorSurfRGBA())});
    }
    const auto is_larger = [](const Colored_faces& a, const Colored_faces& b) { return a.faces.size() > b.faces.size(); };
    std::stable_sort(colored.begin(), colored.end(), is_larger);
    for(const Colored_faces& set : colored) {
      for(const std::size_t face : set.faces)
        m_names.face_colors[face] = set.color;
      for(Part& part : m_names.parts)
        if(!set.faces.empty() && part.faces == set.faces)
          part.color = set.color;
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NAMES_COLLECTOR_H
