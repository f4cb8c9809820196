// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of the faces of a file, to choose from.
#ifndef MESH_CAD_FACES_H
#define MESH_CAD_FACES_H

#include "json_of_names.h"

#include <CGAL/describe_open_cascade_faces.h>

#include <nlohmann/json.hpp>

#include <TopoDS_Shape.hxx>

#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace mesh_cad {

typedef std::vector<CGAL::Open_cascade_face_3> Face_list;

// The faces of a shape that is in millimetres. `unit`: that of the lengths of the list, in millimetres
inline Face_list face_list(const TopoDS_Shape& shape, double unit)
{
  Face_list result = CGAL::describe_open_cascade_faces(shape);
  for(auto& face : result) {
    face.area /= unit * unit;
    for(double& x : face.center)
      x /= unit;
    if(face.radius)
      *face.radius /= unit;
  }
  return result;
}

inline nlohmann::ordered_json json_of_faces(const Face_list& faces, const Names& names)
{
  const auto parts = names.parts_of_faces();
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for(std::size_t f = 0; f < faces.size(); ++f) {
    const auto& face = faces[f];
    nlohmann::ordered_json item = {{"number", f + 1}, {"kind", face.kind}, {"area", face.area}, {"center", face.center}};
    if(face.direction)
      item["direction"] = *face.direction;
    if(face.radius)
      item["radius"] = *face.radius;
    if(!names.face_names[f].empty())
      item["name"] = names.face_names[f];
    if(parts[f] != Names::none)
      item["part"] = parts[f] + 1;
    if(!face.fault.empty())
      item["fault"] = face.fault;
    result.push_back(item);
  }
  return result;
}

// A line for each face.
inline void print_faces(std::ostream& out, const Face_list& faces, const Names& names)
{
  const auto parts = names.parts_of_faces();
  out << "number        kind        area                              center                  direction      radius  part, name\n"
      << std::setprecision(4);
  const auto place = [](const std::array<double, 3>& p) {
    const double rounding = 1e-9; // of directions: no -0
    std::ostringstream text;
    text << std::setprecision(4);
    for(std::size_t i = 0; i < 3; ++i)
      text << (i == 0 ? "" : " ") << (std::abs(p[i]) < rounding ? 0 : p[i]);
    return text.str();
  };
  for(std::size_t f = 0; f < faces.size(); ++f) {
    const auto& face = faces[f];
    out << std::setw(6) << f + 1 << std::setw(12) << face.kind << std::setw(12) << face.area << std::setw(36) << place(face.center)
        << std::setw(27) << (face.direction ? place(*face.direction) : "") << std::setw(12);
    if(face.radius)
      out << *face.radius;
    else
      out << "";
    out << "  " << (parts[f] == Names::none ? "" : names.parts[parts[f]].path)
        << (names.face_names[f].empty() ? "" : ", '" + names.face_names[f] + "'") << (face.fault.empty() ? "" : "; " + face.fault) << "\n";
  }
}

} // namespace mesh_cad

#endif // MESH_CAD_FACES_H
