// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NAMES_OF_EXCHANGE_FILE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NAMES_OF_EXCHANGE_FILE_H

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Names_collector.h>

#include <IGESCAFControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_InterfaceModel.hxx>
#include <NCollection_DataMap.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDocStd_Document.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <boost/algorithm/string/trim.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What reads the shapes of a file, in a reader that reads names, too.
inline STEPControl_Reader& reader_of_shapes(STEPCAFControl_Reader& reader) { return reader.ChangeReader(); }
inline IGESControl_Reader& reader_of_shapes(IGESCAFControl_Reader& reader) { return reader; }

inline std::string name_of_entity(const Handle(StepRepr_RepresentationItem) & entity)
{
  const Handle(TCollection_HAsciiString) name = entity->Name();
  return name.IsNull() || name->String() == "NONE" ? "" : name->ToCString(); // "NONE" is what some programs write for no name
}

inline std::string name_of_entity(const Handle(IGESData_IGESEntity) & entity)
{
  if(!entity->HasName())
    return "";
  const Handle(TCollection_HAsciiString) name = entity->NameValue();
  return name.IsNull() ? "" : boost::algorithm::trim_copy(std::string(name->ToCString()));
}

inline std::string unit_of_file(STEPControl_Reader& reader)
{
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  return lengths.IsEmpty() ? "" : lengths.First().ToCString();
}

inline std::string unit_of_file(IGESControl_Reader& reader)
{
  const Handle(IGESData_IGESModel) model = Handle(IGESData_IGESModel)::DownCast(reader.Model());
  const Handle(TCollection_HAsciiString) name = model.IsNull() ? nullptr : model->GlobalSection().UnitName();
  return name.IsNull() ? "" : name->ToCString();
}

// The names that the entities of a file give to solids, shells, faces, edges and vertices. An entity may be in the shape several
// times, at different places. (The readers of names alone hand over those of assemblies and products.)
template <class Entity>
class Entity_names
{
  NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher> m_names; // by shapes without their places

public:
  // \pre the roots are transferred
  explicit Entity_names(const XSControl_Reader& reader)
  {
    const Handle(Interface_InterfaceModel) model = reader.Model();
    const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
    for(int i = 1; i <= model->NbEntities(); ++i) {
      const Handle(Entity) entity = Handle(Entity)::DownCast(model->Value(i));
      const std::string name = entity.IsNull() ? "" : name_of_entity(entity);
      if(name.empty())
        continue;
      const TopoDS_Shape shape = TransferBRep::ShapeResult(process, entity);
      if(!shape.IsNull() && !m_names.IsBound(shape.Located(TopLoc_Location())))
        m_names.Bind(shape.Located(TopLoc_Location()), name);
    }
  }

  std::vector<std::string> names(const TopTools_IndexedMapOfShape& shapes) const
  {
    std::vector<std::string> result(std::size_t(shapes.Extent()));
    for(int i = 1; i <= shapes.Extent(); ++i)
      if(const std::string* name = m_names.Seek(shapes(i).Located(TopLoc_Location())))
        result[std::size_t(i) - 1] = *name;
    return result;
  }
};

// Without it, what has no name is called "SOLID" or "COMPOUND" by Open CASCADE.
class No_made_up_names
{
  const bool m_old = XCAFDoc_ShapeTool::AutoNaming();

public:
  No_made_up_names() { XCAFDoc_ShapeTool::SetAutoNaming(false); }
  ~No_made_up_names() { XCAFDoc_ShapeTool::SetAutoNaming(m_old); }
  No_made_up_names(const No_made_up_names&) = delete;
  No_made_up_names& operator=(const No_made_up_names&) = delete;
};

inline void set_modes(STEPCAFControl_Reader& reader)
{
  reader.SetMatMode(true);
  reader.SetPropsMode(false); // volumes and centres of mass, which are not used here
  reader.SetGDTMode(false);   // dimensions and tolerances, neither
  reader.SetViewMode(false);
}

inline void set_modes(IGESCAFControl_Reader&) {}

template <class Entity, class Reader>
Open_cascade_names_3 names_of_file(Reader& reader, const TopoDS_Shape& shape, const std::string& default_name)
{
  Open_cascade_names_3 result;
  const Shape_index index(shape);
  const Entity_names<Entity> names(reader_of_shapes(reader));
  result.solid_names = names.names(index.solids);
  result.shell_names = names.names(index.shells);
  result.face_names = names.names(index.faces);
  result.edge_names = names.names(index.edges);
  result.vertex_names = names.names(index.vertices);
  result.unit = unit_of_file(reader_of_shapes(reader));
  set_modes(reader);
  const No_made_up_names no_made_up_names;
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  Names_collector collect(index, result, default_name);
  if(!reader.Transfer(document))
    throw Parametric_surface_mesh_error("Open CASCADE cannot read the names of the file");
  collect(document);
  return result;
}

// \pre the roots are transferred, and the shape is the reader's
inline Open_cascade_names_3 names_of_exchange_file(STEPCAFControl_Reader& reader, const TopoDS_Shape& shape,
                                                   const std::string& default_name)
{
  return names_of_file<StepRepr_RepresentationItem>(reader, shape, default_name);
}

inline Open_cascade_names_3 names_of_exchange_file(IGESCAFControl_Reader& reader, const TopoDS_Shape& shape,
                                                   const std::string& default_name)
{
  return names_of_file<IGESData_IGESEntity>(reader, shape, default_name);
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_NAMES_OF_EXCHANGE_FILE_H
