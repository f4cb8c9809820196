// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An assembly with names, colours, layers and a material, as a document of Open CASCADE's XDE.
#ifndef NAMED_ASSEMBLY_H
#define NAMED_ASSEMBLY_H

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_MaterialTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include <string>

// Two plates, a box of 10 x 10 x 1 each with a red face called "top", a column of two solids on the first one, 8 high, and a second
// level of assembly with a pin in it.
class Named_assembly
{
public:
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");

private:
  Handle(XCAFDoc_ShapeTool) m_shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());

public:
  Named_assembly()
  {
    const TDF_Label root = m_shapes->NewShape(), inner = m_shapes->NewShape();
    name(root, "bridge");
    name(inner, "fastener");
    const TDF_Label plate = add_plate(), column = add_column(),
                    pin = m_shapes->AddShape(BRepPrimAPI_MakeCylinder(0.5, 3).Shape(), false);
    name(pin, "pin");
    color(pin, 0, 0, 1);
    name(m_shapes->AddComponent(root, plate, at(0, 0, 0)), "left plate");
    name(m_shapes->AddComponent(root, plate, at(20, 0, 0)), "right plate");
    name(m_shapes->AddComponent(root, column, at(0, 0, 1)), "column");
    name(m_shapes->AddComponent(inner, pin, at(5, 5, 0)), "pin, the only one");
    name(m_shapes->AddComponent(root, inner, at(20, 0, 1)), "fastener");
    m_shapes->UpdateAssemblies();
  }

private:
  static TopLoc_Location at(double x, double y, double z)
  {
    gp_Trsf translation;
    translation.SetTranslation(gp_Vec(x, y, z));
    return TopLoc_Location(translation);
  }

  static void name(const TDF_Label& label, const std::string& text)
  {
    TDataStd_Name::Set(label, TCollection_ExtendedString(text.c_str(), true));
  }

  void color(const TDF_Label& label, double red, double green, double blue) const
  {
    XCAFDoc_DocumentTool::ColorTool(document->Main())->SetColor(label, Quantity_Color(red, green, blue, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
  }

  TDF_Label add_plate() const
  {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 1).Shape();
    const TDF_Label plate = m_shapes->AddShape(box, false);
    name(plate, "pl\xc3\xa4te");
    color(plate, 0.5, 0.5, 0.5);
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(box, TopAbs_FACE, faces);
    const TDF_Label top = m_shapes->AddSubShape(plate, faces(6));
    name(top, "top");
    color(top, 1, 0, 0);
    XCAFDoc_DocumentTool::LayerTool(document->Main())->SetLayer(plate, TCollection_ExtendedString("steel parts"));
    const auto text = [](const char* t) { return Handle(TCollection_HAsciiString)(new TCollection_HAsciiString(t)); };
    XCAFDoc_DocumentTool::MaterialTool(document->Main())
      ->SetMaterial(plate, text("steel"), text("of any kind"), 7.85, text("density measure"), text("POSITIVE_RATIO_MEASURE"));
    return plate;
  }

  TDF_Label add_column() const
  {
    BRep_Builder builder;
    TopoDS_Compound solids;
    builder.MakeCompound(solids);
    builder.Add(solids, BRepPrimAPI_MakeBox(2, 2, 4).Shape());
    builder.Add(solids, BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 4), 1, 1, 4).Shape());
    const TDF_Label column = m_shapes->AddShape(solids, false);
    name(column, "column");
    return column;
  }
};

inline void write_named_assembly(const std::string& step_file_name)
{
  STEPCAFControl_Writer writer;
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  writer.Transfer(Named_assembly().document, STEPControl_AsIs);
  writer.Write(step_file_name.c_str());
}

#endif // NAMED_ASSEMBLY_H
