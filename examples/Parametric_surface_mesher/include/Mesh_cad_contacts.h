// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What mesh_cad --conformal tells of the parts of an assembly: where they touch, overlap, or nearly touch.
#ifndef MESH_CAD_CONTACTS_H
#define MESH_CAD_CONTACTS_H

#include "Mesh_findings.h"
#include "Usage_error.h"
#include "text_of_numbers.h"

#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/fuse_open_cascade_solids.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

// Two solids that touch, overlap or nearly touch.
struct Contact_of_parts
{
  std::array<std::string, 2> parts;          // the paths in the assembly
  std::array<std::size_t, 2> solids;         // their numbers in the file, from 1
  std::size_t number_of_faces = 0;           // between them
  double area = 0, common_volume = 0, distance = 0; // of these faces; in both solids; between them, if they do not touch
};

namespace mesh_cad {

// `names`: those of the shape before it was fused
inline std::vector<Contact_of_parts> contacts_between_parts(const CGAL::Fused_open_cascade_solids& fused,
                                                            const CGAL::Open_cascade_names_3& names)
{
  const std::vector<std::size_t> parts = names.parts_of_solids();
  std::map<std::pair<std::size_t, std::size_t>, Contact_of_parts> contacts;
  const auto between = [&](const auto& pair) -> Contact_of_parts& {
    Contact_of_parts& result = contacts[{pair.first, pair.second}];
    result.solids = {pair.first + 1, pair.second + 1};
    for(std::size_t i : {0, 1}) {
      const std::size_t solid = result.solids[i] - 1;
      const bool has_part = solid < parts.size() && parts[solid] != CGAL::Open_cascade_names_3::none;
      result.parts[i] = has_part ? names.parts[parts[solid]].path : "solid_" + std::to_string(solid + 1);
    }
    return result;
  };
  for(const auto& contact : fused.contacts) {
    between(contact).area = contact.area;
    between(contact).number_of_faces = contact.number_of_faces;
  }
  for(const auto& overlap : fused.overlaps)
    between(overlap).common_volume = overlap.volume;
  for(const auto& gap : fused.gaps)
    between(gap).distance = gap.distance;
  std::vector<Contact_of_parts> result;
  for(const auto& contact : contacts)
    result.push_back(contact.second);
  return result;
}

inline nlohmann::ordered_json json_of_contacts(const std::vector<Contact_of_parts>& contacts)
{
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for(const auto& contact : contacts)
    result.push_back({{"parts", contact.parts}, {"solids", contact.solids}, {"faces", contact.number_of_faces}, {"area", contact.area},
                      {"common_volume", contact.common_volume}, {"distance", contact.distance}});
  return result;
}

// In sentences: how many faces lie between parts, and which parts overlap or nearly touch.
inline void add_contacts(const std::vector<Contact_of_parts>& contacts, const mesh_patch::Text_of_length& length, Mesh_findings& findings)
{
  std::size_t number_of_faces = 0, number_touching = 0;
  std::vector<std::string> sentences;
  for(const auto& contact : contacts) {
    number_of_faces += contact.number_of_faces;
    number_touching += contact.number_of_faces > 0;
    const std::string parts = "parts " + contact.parts[0] + " and " + contact.parts[1];
    if(contact.common_volume > 0)
      sentences.push_back(parts + " overlap: they have a volume of " + mesh_patch::text_of(contact.common_volume)
                          + (length.unit.empty() ? "" : " " + length.unit + "^3") + " in common, which became a solid of its own");
    else if(contact.distance > 0)
      sentences.push_back(parts + " do not touch: they are " + length(contact.distance) + " apart; --fuzzy joins parts that are closer");
  }
  if(number_touching > 0)
    findings.notes.push_back(mesh_patch::plural(number_of_faces, "face") + " between " + mesh_patch::plural(number_touching, "pair")
                             + " of parts that touch: both parts have the same triangles there");
  mesh_patch::append_first(sentences, "pairs of parts that overlap or do not touch, which --json lists", findings.notes);
}

} // namespace mesh_cad

#endif // MESH_CAD_CONTACTS_H
