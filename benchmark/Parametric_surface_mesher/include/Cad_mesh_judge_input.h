// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CAD_MESH_JUDGE_INPUT_H
#define CAD_MESH_JUDGE_INPUT_H

#include "Mesh_cad_output.h"
#include "Mesh_cad_result.h"

#include "Cad_mesh_judge.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

// The mesh of mesh_cad for the judge, with no more than its files tell.
inline Judged_mesh judge_input(const Mesh_cad_result& result)
{
  mesh_cad::Elements elements = mesh_cad::elements(result);
  std::vector<std::size_t> closed_up, thinned;
  for(const auto& face : result.shape.closed_up)
    closed_up.push_back(face.shape_face + 1);
  for(const auto& detail : mesh_cad::details_by_face(result))
    thinned.push_back(detail.first);
  Judged_mesh mesh{std::move(elements.points), std::move(elements.triangles), std::move(elements.face_ids), closed_up, thinned};
  if(result.criteria.detail())
    mesh.closed_up_width = (std::max)(mesh.closed_up_width, *result.criteria.detail() / result.shape.diagonal);
  return mesh;
}

#endif // CAD_MESH_JUDGE_INPUT_H
