// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts, names, colours, layers and materials in the JSON file of mesh_cad.
#ifndef JSON_OF_NAMES_H
#define JSON_OF_NAMES_H

#include "Mesh_cad_parts.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mesh_cad {

inline std::vector<std::size_t> numbers_from_1(std::vector<std::size_t> numbers)
{
  for(std::size_t& number : numbers)
    ++number;
  return numbers;
}

inline nlohmann::ordered_json json_of(const Names::Color& color)
{
  return {{"rgb", "#" + CGAL::Parametric_surface_mesher::internal::hexadecimal(color)}, {"opacity", color.opacity}};
}

inline nlohmann::ordered_json json_of(const Names& names, std::size_t number)
{
  const Names::Part& part = names.parts[number];
  nlohmann::ordered_json result = {{"number", number + 1}, {"name", part.name}, {"instance", part.instance}, {"path", part.path}};
  if(part.parent != Names::none)
    result["parent"] = part.parent + 1;
  result["is_assembly"] = part.is_assembly;
  result["location"] = part.location;
  result["solids"] = numbers_from_1(part.solids);
  result["faces"] = numbers_from_1(part.faces);
  if(part.color)
    result["color"] = json_of(*part.color);
  if(part.material)
    result["material"] = {{"name", part.material->name}, {"description", part.material->description}, {"density", part.material->density}};
  if(!part.layers.empty())
    result["layers"] = part.layers;
  return result;
}

// By number, from 1, as far as there is anything.
inline nlohmann::ordered_json json_of_list(const std::vector<std::string>& names)
{
  nlohmann::ordered_json result = nlohmann::ordered_json::object();
  for(std::size_t i = 0; i < names.size(); ++i)
    if(!names[i].empty())
      result[std::to_string(i + 1)] = names[i];
  return result;
}

inline nlohmann::ordered_json json_of_list(const std::vector<std::optional<Names::Color>>& colors)
{
  nlohmann::ordered_json result = nlohmann::ordered_json::object();
  for(std::size_t i = 0; i < colors.size(); ++i)
    if(colors[i])
      result[std::to_string(i + 1)] = json_of(*colors[i]);
  return result;
}

inline nlohmann::ordered_json json_of_list(const std::vector<std::vector<std::string>>& layers)
{
  nlohmann::ordered_json result = nlohmann::ordered_json::object();
  for(std::size_t i = 0; i < layers.size(); ++i)
    if(!layers[i].empty())
      result[std::to_string(i + 1)] = layers[i];
  return result;
}

inline nlohmann::ordered_json json_of_names(const Names& names)
{
  nlohmann::ordered_json parts = nlohmann::ordered_json::array();
  for(std::size_t p = 0; p < names.parts.size(); ++p)
    parts.push_back(json_of(names, p));
  return {{"file_unit", names.unit},
          {"parts", parts},
          {"solid_names", json_of_list(names.solid_names)},
          {"face_names", json_of_list(names.face_names)},
          {"edge_names", json_of_list(names.edge_names)},
          {"vertex_names", json_of_list(names.vertex_names)},
          {"face_colors", json_of_list(names.face_colors)},
          {"edge_colors", json_of_list(names.edge_colors)},
          {"face_layers", json_of_list(names.face_layers)},
          {"name_faults", names.faults}};
}

} // namespace mesh_cad

#endif // JSON_OF_NAMES_H
