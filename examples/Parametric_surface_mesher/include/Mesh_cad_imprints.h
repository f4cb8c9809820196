// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points and curves that mesh_cad puts on faces: --point and --curves.
#ifndef MESH_CAD_IMPRINTS_H
#define MESH_CAD_IMPRINTS_H

#include "Local_size.h"
#include "Mesh_findings.h"
#include "Usage_error.h"
#include "text_of_numbers.h"

#include <CGAL/IO/read_open_cascade_shape.h>
#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/imprint_on_open_cascade_shape.h>

#include <nlohmann/json.hpp>

#include <TopAbs_ShapeEnum.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Pnt.hxx>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

typedef std::array<double, 3> Point_on_faces; // X, Y and Z of --point

// What has become of a point or a curve.
struct Imprint_on_faces
{
  std::string name; // "point 1", "curve 1", ...
  double distance, length, projected_length;
};

namespace mesh_cad {

// Reads a point like "10,0,2.5".
inline Point_on_faces point_in(const std::string& item)
{
  const std::vector<std::string> words = words_between(item, ',');
  Point_on_faces result{};
  bool is_point = words.size() == result.size();
  for(std::size_t i = 0; is_point && i < result.size(); ++i)
    is_point = is_finite_number(words[i], result[i]);
  if(!is_point)
    throw Usage_error("--point: '" + item + "' must be X,Y,Z");
  return result;
}

// Gives elements of a shape that have no name a name.
inline void name_elements(const TopoDS_Shape& shape, TopAbs_ShapeEnum type, const std::vector<TopoDS_Shape>& elements,
                          const std::string& name, std::vector<std::string>& names)
{
  TopTools_IndexedMapOfShape all;
  TopExp::MapShapes(shape, type, all);
  names.resize(std::size_t(all.Extent()));
  for(const TopoDS_Shape& element : elements)
    if(const int index = all.FindIndex(element))
      if(names[std::size_t(index) - 1].empty())
        names[std::size_t(index) - 1] = name;
}

// Points and curves become sets of the files: point_1, curve_1, ...
inline void name_imprints(const CGAL::Imprinted_open_cascade_shape& imprinted, CGAL::Open_cascade_names_3& names)
{
  for(std::size_t i = 0; i < imprinted.points.size(); ++i)
    name_elements(imprinted.shape, TopAbs_VERTEX, imprinted.points[i].shapes, "point_" + std::to_string(i + 1), names.vertex_names);
  for(std::size_t i = 0; i < imprinted.curves.size(); ++i)
    name_elements(imprinted.shape, TopAbs_EDGE, imprinted.curves[i].shapes, "curve_" + std::to_string(i + 1), names.edge_names);
}

inline void append_imprints(const char* what, const std::vector<CGAL::Imprinted_open_cascade_shape::Imprint>& imprints,
                            std::vector<Imprint_on_faces>& result)
{
  for(std::size_t i = 0; i < imprints.size(); ++i)
    result.push_back({what + (" " + std::to_string(i + 1)), imprints[i].distance, imprints[i].length, imprints[i].projected_length});
}

const double default_share_of_reach = 0.02; // of the diagonal

// Puts points, and the curves of a file if its name is not empty, on the faces. `faults` takes what is wrong with the file.
inline CGAL::Imprinted_open_cascade_shape imprint(const TopoDS_Shape& shape, const std::vector<Point_on_faces>& points,
                                                  const std::string& curves, double reach, std::vector<std::string>& faults,
                                                  std::vector<Imprint_on_faces>& imprints)
{
  TopoDS_Shape shape_of_curves;
  if(!curves.empty()) {
    std::vector<std::string> faults_of_curves;
    shape_of_curves = CGAL::IO::read_open_cascade_shape(curves, "MM", faults_of_curves);
    for(const std::string& fault : faults_of_curves)
      faults.push_back(curves + ": " + fault);
  }
  std::vector<gp_Pnt> places;
  for(const Point_on_faces& p : points)
    places.emplace_back(p[0], p[1], p[2]);
  CGAL::Imprinted_open_cascade_shape result = CGAL::imprint_on_open_cascade_shape(shape, places, shape_of_curves, reach);
  append_imprints("point", result.points, imprints);
  append_imprints("curve", result.curves, imprints);
  return result;
}

inline nlohmann::ordered_json json_of_imprints(const std::vector<Imprint_on_faces>& imprints)
{
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for(const auto& imprint : imprints)
    result.push_back({{"name", imprint.name}, {"distance", imprint.distance}, {"length", imprint.length},
                      {"projected_length", imprint.projected_length}});
  return result;
}

inline void add_imprints(const std::vector<Imprint_on_faces>& imprints, const mesh_patch::Text_of_length& length, Mesh_findings& findings)
{
  std::vector<std::string> sentences;
  for(const auto& imprint : imprints) {
    sentences.push_back(imprint.name + " was " + length(imprint.distance) + " away from the faces");
    if(imprint.length > 0)
      sentences.back() += "; it is " + length(imprint.length) + " long, and on the faces " + length(imprint.projected_length);
  }
  mesh_patch::append_first(sentences, "points and curves, which --json lists", findings.notes);
}

} // namespace mesh_cad

#endif // MESH_CAD_IMPRINTS_H
