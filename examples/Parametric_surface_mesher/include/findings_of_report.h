// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of the mesher in sentences for people.
#ifndef FINDINGS_OF_REPORT_H
#define FINDINGS_OF_REPORT_H

#include "Mesh_findings.h"
#include "Usage_error.h"
#include "text_of_numbers.h"

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_report.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace mesh_patch {

typedef CGAL::Parametric_surface_mesher::Mesh_criterion Mesh_criterion;
typedef CGAL::Parametric_surface_mesher::Unmet_cause Unmet_cause;

// What a triangle is that fails a criterion.
inline std::string text_of(Mesh_criterion criterion, const CGAL::Parametric_surface_mesh_criteria& criteria, const Text_of_length& length)
{
  switch(criterion) {
  case Mesh_criterion::SIZE: return "larger than wanted";
  case Mesh_criterion::ANGLE: return "below " + text_of(criteria.angle()) + " degrees";
  case Mesh_criterion::DEVIATION: return "too coarse for the curvature";
  case Mesh_criterion::DISTANCE: return "farther from the surface than " + (criteria.distance() ? length(*criteria.distance()) : "allowed");
  case Mesh_criterion::USER: return "not as the user's own criterion wants them";
  case Mesh_criterion::INVERTED: return "turned to the wrong side";
  }
  return "";
}

// Why triangles stay so. `min_edge`: in effect
inline std::string text_of(Unmet_cause cause, double min_edge, const Text_of_length& length)
{
  switch(cause) {
  case Unmet_cause::BOUNDARY: return "the fixed boundary leaves no better point";
  case Unmet_cause::MINIMUM_EDGE:
    return "edges there are as short as they may be, " + length(min_edge) + "; a smaller --min-edge lets them be divided";
  case Unmet_cause::SPACING: return "another point there would make triangles much smaller than wanted";
  case Unmet_cause::NO_BETTER_POINT: return "no other point makes the triangles there better";
  case Unmet_cause::VERTEX_LIMIT: return "the mesh has as many vertices as it may have";
  case Unmet_cause::WORK_LIMIT: return "the place is difficult, and the search for better points was given up";
  case Unmet_cause::STOPPED: return "meshing was stopped";
  case Unmet_cause::ANGLE_LIMIT: return "points are added only for angles below 32 degrees; more --sweeps may help";
  }
  return "";
}

// As "3 triangles are below 30 degrees, 1 is larger than wanted".
inline std::string text_of_unmet(const std::map<Mesh_criterion, std::size_t>& numbers,
                                 const CGAL::Parametric_surface_mesh_criteria& criteria, const Text_of_length& length)
{
  std::string result;
  for(const auto& number : numbers)
    result += (result.empty() ? plural(number.second, "triangle") : ", " + std::to_string(number.second))
              + (number.second == 1 ? " is " : " are ") + text_of(number.first, criteria, length);
  return result;
}

// The triangles that fail criteria, in one sentence for each cause. A triangle that fails several of them counts for each.
inline void add_unmet(const CGAL::Parametric_surface_mesh_report& report, const CGAL::Parametric_surface_mesh_criteria& criteria,
                      const Text_of_length& length, Mesh_findings& findings)
{
  std::map<Unmet_cause, std::map<Mesh_criterion, std::size_t>> notes, faults;
  for(const auto& unmet : report.unmet)
    for(const Mesh_criterion criterion : CGAL::Parametric_surface_mesher::all_criteria())
      if(unmet.criteria.contains(criterion))
        ++(criterion == Mesh_criterion::INVERTED ? faults : notes)[unmet.cause][criterion];
  const auto sentence = [&](const auto& of_cause) {
    return text_of_unmet(of_cause.second, criteria, length) + ": " + text_of(of_cause.first, criteria.min_edge(), length);
  };
  std::transform(faults.begin(), faults.end(), std::back_inserter(findings.faults), sentence);
  std::transform(notes.begin(), notes.end(), std::back_inserter(findings.notes), sentence);
  findings.is_any_triangle_unmet = findings.is_any_triangle_unmet || !notes.empty();
}

// A mesh that is not done is valid, and coarser than was asked for.
inline void add_stop(const CGAL::Parametric_surface_mesh_report& report, Mesh_findings& findings)
{
  if(report.is_stopped)
    findings.faults.push_back("meshing was stopped before it was done: triangles are larger and farther from the surface than wanted");
}

// As "faces 3 and 5 at (0, 1, 2), 12 pairs of triangles". `where`: an intersection or a fold; `faces`: its faces, from 1
template <class Where>
std::string text_of_place(const Where& where, const std::array<std::size_t, 2>& faces)
{
  const std::string first = std::to_string(faces[0]), second = std::to_string(faces[1]);
  return (faces[0] == faces[1] ? "face " + first : "faces " + first + " and " + second) + " at " + text_of(where.place) + ", "
         + plural(where.number_of_pairs, "pair") + " of triangles";
}

// `number_of`: gives the number, from 1, of a face of the model by its index
template <class NumberOf>
void add_intersections(const CGAL::Parametric_surface_mesh_report& report, const NumberOf& number_of, Mesh_findings& findings)
{
  const auto place = [&](const auto& where) { return text_of_place(where, {number_of(where.faces[0]), number_of(where.faces[1])}); };
  const std::string hint = "; shorter edges there would help"; // said once of many
  std::vector<std::string> of_mesh, of_surfaces, folds;
  for(const auto& intersection : report.intersections)
    if(intersection.is_of_surfaces)
      of_surfaces.push_back("the shape intersects itself, and so does the mesh: " + place(intersection));
    else
      of_mesh.push_back("the mesh intersects itself: " + place(intersection) + (of_mesh.empty() ? hint : ""));
  for(const auto& fold : report.folds)
    folds.push_back("the mesh is folded, triangles face the wrong way: " + place(fold) + (folds.empty() ? hint : ""));
  append_first(of_mesh, "pairs of faces where it does so", findings.faults);
  append_first(folds, "pairs of faces where it is folded", findings.faults);
  append_first(of_surfaces, "pairs of faces where it does so", findings.notes);
}

} // namespace mesh_patch

#endif // FINDINGS_OF_REPORT_H
