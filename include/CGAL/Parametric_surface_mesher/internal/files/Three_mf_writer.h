// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_THREE_MF_WRITER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_THREE_MF_WRITER_H

#include <CGAL/Element_mesh_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Element_sets.h>
#include <CGAL/Parametric_surface_mesher/internal/files/Sides_of_parts.h>

#include <Model/COM/NMR_DLLInterfaces.h> // of lib3mf 1

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Writes .3mf files by lib3mf: an object for each part, and a material for each colour. The functions of CGAL/IO/3MF.h would not do:
// they write no units and no open surfaces, and give triangles no colours.
class Three_mf_writer
{
  // An object of the library, which is released with this one.
  struct Library_object
  {
    NMR::PLib3MFBase* object = nullptr;

    Library_object() = default;
    Library_object(const Library_object&) = delete;
    Library_object& operator=(const Library_object&) = delete;
    ~Library_object()
    {
      if(object != nullptr)
        NMR::lib3mf_release(object);
    }
  };

  typedef std::array<BYTE, 4> Color; // with the opacity

  std::string m_file_name;
  const Element_mesh_3& m_mesh;
  double m_unit; // in millimetres
  Library_object m_model, m_materials;
  DWORD m_materials_id = 0;
  std::map<Color, DWORD> m_indices; // of materials

public:
  Three_mf_writer(const std::string& file_name, const Element_mesh_3& mesh, double unit)
    : m_file_name(file_name), m_mesh(mesh), m_unit(unit)
  {
    check(NMR::lib3mf_createmodel(&m_model.object));
    check(NMR::lib3mf_model_setunit(m_model.object, NMR::MODELUNIT_MILLIMETER));
    check(NMR::lib3mf_model_addbasematerialgroup(m_model.object, &m_materials.object));
    check(NMR::lib3mf_resource_getresourceid(m_materials.object, &m_materials_id));
  }

  void write()
  {
    const auto parts = sides_by_part(m_mesh);
    for(std::size_t p = 0; p < parts.size(); ++p)
      if(!parts[p].empty())
        add_object(p < m_mesh.parts.size() ? m_mesh.parts[p].name : "faces", parts[p]);
    Library_object writer;
    check(NMR::lib3mf_model_querywriter(m_model.object, "3mf", &writer.object));
    check(NMR::lib3mf_writer_writetofileutf8(writer.object, m_file_name.c_str()));
  }

private:
  void check(LIB3MFRESULT result) const
  {
    if(result != 0)
      throw Parametric_surface_mesh_error("lib3mf cannot write " + m_file_name);
  }

  void add_object(const std::string& name, const std::vector<Side_of_part>& sides)
  {
    Library_object object, item;
    check(NMR::lib3mf_model_addmeshobject(m_model.object, &object.object));
    check(NMR::lib3mf_object_setnameutf8(object.object, one_line(name).c_str()));
    check(NMR::lib3mf_object_settype(object.object, is_closed(sides) ? NMR::MODELOBJECTTYPE_MODEL : NMR::MODELOBJECTTYPE_SURFACE));
    add_geometry(sides, object);
    add_colors(sides, object);
    check(NMR::lib3mf_model_addbuilditem(m_model.object, object.object, nullptr, &item.object));
  }

  // For the format, only closed objects are solids; others have a type of their own.
  static bool is_closed(const std::vector<Side_of_part>& sides)
  {
    std::set<std::pair<std::size_t, std::size_t>> edges; // that have no opposite yet
    for(const Side_of_part& side : sides)
      for(std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = side.nodes[i], b = side.nodes[(i + 1) % 3];
        if(edges.erase({b, a}) == 0)
          edges.insert({a, b});
      }
    return edges.empty();
  }

  void add_geometry(const std::vector<Side_of_part>& sides, const Library_object& object) const
  {
    std::map<std::size_t, DWORD> indices; // of the nodes that it has
    std::vector<NMR::MODELMESHVERTEX> vertices;
    std::vector<NMR::MODELMESHTRIANGLE> triangles;
    for(const Side_of_part& side : sides) {
      NMR::MODELMESHTRIANGLE triangle;
      for(std::size_t i = 0; i < 3; ++i) {
        const auto found = indices.emplace(side.nodes[i], DWORD(vertices.size()));
        triangle.m_nIndices[i] = found.first->second;
        if(found.second)
          vertices.push_back(vertex(m_mesh.nodes[side.nodes[i]]));
      }
      triangles.push_back(triangle);
    }
    check(NMR::lib3mf_meshobject_setgeometry(object.object, vertices.data(), DWORD(vertices.size()), triangles.data(),
                                             DWORD(triangles.size())));
  }

  NMR::MODELMESHVERTEX vertex(const Element_mesh_3::Point& p) const
  {
    NMR::MODELMESHVERTEX result;
    for(std::size_t i = 0; i < 3; ++i)
      result.m_fPosition[i] = FLOAT(m_unit * p[i]);
    return result;
  }

  // Writes colours if any triangle has one. Those without one are gray then.
  void add_colors(const std::vector<Side_of_part>& sides, const Library_object& object)
  {
    if(std::none_of(sides.begin(), sides.end(), [&](const Side_of_part& side) { return color_of(side).has_value(); }))
      return;
    std::vector<DWORD> materials;
    for(const Side_of_part& side : sides)
      materials.push_back(material(color_of(side)));
    std::vector<DWORD> groups(materials.size(), m_materials_id);
    Library_object properties, default_property;
    check(NMR::lib3mf_meshobject_createpropertyhandler(object.object, &properties.object));
    check(NMR::lib3mf_propertyhandler_setbasematerialarray(properties.object, groups.data(), materials.data()));
    // Objects with properties must have a default one.
    check(NMR::lib3mf_object_createdefaultpropertyhandler(object.object, &default_property.object));
    check(NMR::lib3mf_defaultpropertyhandler_setbasematerial(default_property.object, m_materials_id, materials.front()));
  }

  // The colour of the face or, if it has none, that of the part.
  const std::optional<Element_mesh_3::Color>& color_of(const Side_of_part& side) const
  {
    const auto& of_face = m_mesh.surfaces[side.surface].color;
    return of_face || side.part == m_mesh.parts.size() ? of_face : m_mesh.parts[side.part].color;
  }

  DWORD material(const std::optional<Element_mesh_3::Color>& given)
  {
    const Element_mesh_3::Color gray{0.75, 0.75, 0.75, 1}, color = given.value_or(gray);
    const auto byte = [](double value) { return BYTE((std::min)((std::max)(255 * value + 0.5, 0.), 255.)); };
    const Color bytes{{byte(color.red), byte(color.green), byte(color.blue), byte(color.opacity)}};
    const auto found = m_indices.find(bytes);
    if(found != m_indices.end())
      return found->second;
    char name[8];
    std::snprintf(name, sizeof(name), "#%02x%02x%02x", bytes[0], bytes[1], bytes[2]);
    DWORD index = 0;
    check(NMR::lib3mf_basematerial_addmaterialutf8(m_materials.object, name, bytes[0], bytes[1], bytes[2], &index));
    // Without a display colour the material is transparent.
    check(NMR::lib3mf_basematerial_setdisplaycolorrgba(m_materials.object, index, bytes[0], bytes[1], bytes[2], bytes[3]));
    return m_indices[bytes] = index;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_THREE_MF_WRITER_H
