// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CAD_MESH_JUDGE_INPUT_H
#define CAD_MESH_JUDGE_INPUT_H

#include "Mesh_cad_output.h"
#include "Mesh_cad_result.h"

#include "Cad_mesh_judge.h"

#include <utility>

// The mesh of mesh_cad for the judge, with no more than a file would tell.
inline Judged_mesh judge_input(const Mesh_cad_result& result)
{
  mesh_cad::Elements elements = mesh_cad::elements(result);
  return {std::move(elements.points), std::move(elements.triangles), std::move(elements.face_ids)};
}

#endif // CAD_MESH_JUDGE_INPUT_H
