// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of an assembly in mesh_cad: which ones are meshed, and their list.
#ifndef MESH_CAD_PARTS_H
#define MESH_CAD_PARTS_H

#include "Usage_error.h"

#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Entities_of_shape.h>

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>

#include <array>
#include <cstddef>
#include <iomanip>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace mesh_cad {

typedef CGAL::Open_cascade_names_3 Names;

// Parts by their path, the name in the assembly or the name of the product.
inline std::set<std::size_t> parts_with_name(const Names& names, const std::string& word)
{
  std::set<std::size_t> result;
  for(std::size_t p = 0; p < names.parts.size(); ++p) {
    const auto& part = names.parts[p];
    if(!word.empty() && (word == part.path || word == part.instance || word == part.name))
      result.insert(p);
  }
  return result;
}

// The parts with a name or, if none has it, the one with this number, from 1.
inline std::set<std::size_t> parts_called(const Names& names, const std::string& word)
{
  std::set<std::size_t> result = parts_with_name(names, word);
  const bool is_number = !word.empty() && word.size() < 10 && word.find_first_not_of("0123456789") == std::string::npos;
  if(result.empty() && is_number && std::stoul(word) >= 1 && std::stoul(word) <= names.parts.size())
    result.insert(std::stoul(word) - 1);
  return result;
}

// The parts that a list of the user names. Names may contain commas: a list that is a name as a whole is taken for one.
inline std::set<std::size_t> parts_in(const Names& names, const std::string& option, const std::string& list)
{
  std::set<std::size_t> result = parts_called(names, list);
  if(!result.empty())
    return result;
  std::istringstream words(list + ",");
  for(std::string word; std::getline(words, word, ',');) {
    if(word.empty())
      throw Usage_error("--" + option + ": a name is missing in '" + list + "'");
    const auto parts = parts_called(names, word);
    if(parts.empty()) {
      std::string known;
      for(std::size_t p = 0; p < names.parts.size(); ++p)
        known += (p == 0 ? "" : ", ") + std::to_string(p + 1) + " " + names.parts[p].path;
      throw Usage_error("--" + option + ": there is no part '" + word + "'; the parts are " + known);
    }
    result.insert(parts.begin(), parts.end());
  }
  return result;
}

// Whether a part is one of some, or below one of them.
inline bool is_in(const Names& names, std::size_t part, const std::set<std::size_t>& some)
{
  for(; part != Names::none; part = names.parts[part].parent)
    if(some.count(part) > 0)
      return true;
  return false;
}

// The boxes of parts, of boxes of faces.
class Part_boxes
{
  std::vector<Bnd_Box> m_faces;

public:
  explicit Part_boxes(const TopoDS_Shape& shape)
  {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    for(int f = 1; f <= faces.Extent(); ++f) {
      Bnd_Box box;
      BRepBndLib::AddOptimal(faces(f), box, false, false);
      m_faces.push_back(box);
    }
  }

  // The lengths of the sides, or zeros.
  std::array<double, 3> size(const Names::Part& part) const
  {
    Bnd_Box box;
    for(const std::size_t face : part.faces)
      if(face < m_faces.size() && !m_faces[face].IsVoid() && !m_faces[face].IsOpen())
        box.Add(m_faces[face]);
    if(box.IsVoid())
      return {0, 0, 0};
    const gp_Pnt min = box.CornerMin(), max = box.CornerMax();
    return {max.X() - min.X(), max.Y() - min.Y(), max.Z() - min.Z()};
  }
};

inline std::size_t depth(const Names& names, std::size_t part)
{
  std::size_t result = 0;
  while((part = names.parts[part].parent) != Names::none)
    ++result;
  return result;
}

inline std::string description(const Names::Part& part)
{
  std::string result = part.instance.empty() ? part.name : part.instance;
  if(!part.instance.empty() && part.instance != part.name)
    result += " (" + part.name + ")";
  if(part.material)
    result += ", " + part.material->name;
  if(part.color)
    result += ", #" + CGAL::Parametric_surface_mesher::internal::hexadecimal(*part.color);
  for(const std::string& layer : part.layers)
    result += ", layer " + layer;
  return result;
}

// The numbers, from 1, of what has names, by name.
inline void print_named(std::ostream& out, const char* kind, const std::vector<std::string>& names)
{
  const std::size_t max_number_of_lines = 20; // --json has all
  std::map<std::string, std::string> numbers;
  for(std::size_t i = 0; i < names.size(); ++i)
    if(!names[i].empty())
      numbers[names[i]] += " " + std::to_string(i + 1);
  std::size_t number_of_lines = 0;
  for(const auto& name : numbers) {
    if(++number_of_lines > max_number_of_lines) {
      out << "  and " << numbers.size() - max_number_of_lines << " more " << kind << " names\n";
      break;
    }
    out << "  " << kind << " '" << name.first << "':" << name.second << "\n";
  }
}

// The tree of the parts. `unit`: in millimetres, that of the lengths.
inline void print_parts(std::ostream& out, const std::string& title, const std::string& unit_name, double unit, const Names& names,
                        const TopoDS_Shape& shape)
{
  const Part_boxes boxes(shape);
  out << title << ": " << mesh_patch::plural(names.parts.size(), "part") << ", "
      << mesh_patch::plural(names.solid_names.size(), "solid") << ", " << mesh_patch::plural(names.face_names.size(), "face") << ", "
      << mesh_patch::plural(names.edge_names.size(), "edge") << "; lengths in " << unit_name
      << (names.unit.empty() ? "" : ", the file's are in " + names.unit) << "\n";
  out << "number  solids   faces                            size  name\n" << std::setprecision(4);
  for(std::size_t p = 0; p < names.parts.size(); ++p) {
    const auto& part = names.parts[p];
    const auto size = boxes.size(part);
    std::ostringstream sides;
    sides << std::setprecision(4) << size[0] / unit << " x " << size[1] / unit << " x " << size[2] / unit;
    out << std::setw(6) << p + 1 << std::setw(8) << part.solids.size() << std::setw(8) << part.faces.size() << std::setw(32)
        << sides.str() << "  " << std::string(2 * depth(names, p), ' ') << description(part) << "\n";
  }
  print_named(out, "face", names.face_names);
  print_named(out, "edge", names.edge_names);
  print_named(out, "vertex", names.vertex_names);
  for(const std::string& fault : names.faults)
    out << "  note: " << fault << "\n";
}

} // namespace mesh_cad

#endif // MESH_CAD_PARTS_H
