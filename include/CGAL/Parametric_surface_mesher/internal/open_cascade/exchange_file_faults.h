// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EXCHANGE_FILE_FAULTS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EXCHANGE_FILE_FAULTS_H

#include <IGESControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_TopologicalRepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What of a file has not become a part of its shape, gathered to sentences.
class Exchange_file_faults
{
  std::size_t m_number_of_faces = 0, m_number_of_missing_faces = 0, m_number_of_damaged_entities = 0;
  std::string m_first_missing_face, m_first_damaged_entity;
  std::vector<std::string> m_sentences;

public:
  void add_face(bool is_missing, const std::string& entity)
  {
    ++m_number_of_faces;
    if(is_missing && ++m_number_of_missing_faces == 1)
      m_first_missing_face = entity;
  }

  void add_damaged_entity(const std::string& entity)
  {
    if(++m_number_of_damaged_entities == 1)
      m_first_damaged_entity = entity;
  }

  void add_sentence(const std::string& sentence) { m_sentences.push_back(sentence); }

  std::vector<std::string> sentences() const
  {
    std::vector<std::string> result = m_sentences;
    if(m_number_of_missing_faces > 0)
      result.push_back(std::to_string(m_number_of_missing_faces) + " of " + std::to_string(m_number_of_faces)
                       + " faces in the file could not be read, the first one at " + m_first_missing_face);
    if(m_number_of_damaged_entities > 0)
      result.push_back(std::to_string(m_number_of_damaged_entities) + " faces, loops or edges in the file are damaged, the first one at "
                       + m_first_damaged_entity);
    return result;
  }
};

// Many files have faults in names, colours and the like, which do not touch the shape.
inline bool has_fault_of_shape(const Interface_Check& check)
{
  for(int i = 1; i <= check.NbFails(); ++i)
    if(std::string(check.CFail(i)).find("(name)") == std::string::npos)
      return true;
  return false;
}

// \pre the roots are transferred
inline std::vector<std::string> faults_of_file(const STEPControl_Reader& reader, const std::string&)
{
  Exchange_file_faults result;
  const Handle(Interface_InterfaceModel) model = reader.Model();
  const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  const auto name = [&](const Handle(Standard_Transient)& entity) { return std::string(model->StringLabel(entity)->ToCString()); };
  for(int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    if(entity->IsKind(STANDARD_TYPE(StepShape_FaceSurface)))
      result.add_face(TransferBRep::ShapeResult(process, entity).IsNull(), name(entity));
    const Handle(StepShape_ConnectedFaceSet) set = Handle(StepShape_ConnectedFaceSet)::DownCast(entity);
    if(!set.IsNull())
      for(int k = 1; k <= set->NbCfsFaces(); ++k)
        if(set->CfsFacesValue(k).IsNull())
          result.add_face(true, name(entity));
  }
  const Interface_CheckIterator checks = reader.WS()->ModelCheckList();
  for(checks.Start(); checks.More(); checks.Next())
    if(checks.Number() > 0 && has_fault_of_shape(*checks.Value())) {
      const Handle(Standard_Transient) entity = model->Value(checks.Number());
      if(entity->IsKind(STANDARD_TYPE(StepShape_TopologicalRepresentationItem))
         && !entity->IsKind(STANDARD_TYPE(StepShape_ConnectedFaceSet))) // its missing faces are counted
        result.add_damaged_entity(name(entity));
    }
  return result.sentences();
}

// The last record of an IGES file has the letter T in column 73 and tells how many records the sections before it have. The
// reader of Open CASCADE takes a file that ends before it for whole.
inline bool is_whole_iges_file(const std::string& file_name)
{
  const std::size_t column_of_section = 72, width_of_count = 8;
  std::map<char, std::size_t> counts;
  std::string line, last;
  for(std::ifstream file(file_name); std::getline(file, line);)
    if(line.size() > column_of_section) {
      ++counts[line[column_of_section]];
      last = line;
    }
  if(last.empty() || last[column_of_section] != 'T')
    return false;
  for(std::size_t i = 0; i < 4 * width_of_count; i += width_of_count)
    if(counts[last[i]] != std::strtoul(last.substr(i + 1, width_of_count - 1).c_str(), nullptr, 10))
      return false;
  return true;
}

// Records are numbered within their sections. With those of a section in another order the reader of Open CASCADE leaves out entities.
inline bool are_iges_records_in_order(const std::string& file_name)
{
  const std::size_t column_of_section = 72, width_of_number = 7;
  std::map<char, std::size_t> counts;
  std::string line;
  for(std::ifstream file(file_name); std::getline(file, line);)
    if(line.size() > column_of_section
       && std::strtoul(line.substr(column_of_section + 1, width_of_number).c_str(), nullptr, 10) != ++counts[line[column_of_section]])
      return false;
  return true;
}

// \pre the roots are transferred
inline std::vector<std::string> faults_of_file(const IGESControl_Reader& reader, const std::string& file_name)
{
  const int bounded_surface = 143, trimmed_surface = 144, face = 510; // types of entities
  Exchange_file_faults result;
  if(!is_whole_iges_file(file_name))
    result.add_sentence("the file has lost a part: its last record does not tell how long its sections are");
  else if(!are_iges_records_in_order(file_name))
    result.add_sentence("records of the file are missing or not in the order of their numbers");
  const Handle(Interface_InterfaceModel) model = reader.Model();
  const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  for(int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(IGESData_IGESEntity) entity = Handle(IGESData_IGESEntity)::DownCast(model->Value(i));
    if(entity.IsNull())
      continue;
    const int type = entity->TypeNumber();
    if(type == bounded_surface || type == trimmed_surface || type == face)
      result.add_face(TransferBRep::ShapeResult(process, entity).IsNull(), model->StringLabel(entity)->ToCString());
  }
  return result.sentences();
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_EXCHANGE_FILE_FAULTS_H
