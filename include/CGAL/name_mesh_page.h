// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_NAME_MESH_PAGE_H
#define CGAL_NAME_MESH_PAGE_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Mesh_page_3.h>
#include <CGAL/Open_cascade_model_3.h>
#include <CGAL/Open_cascade_names_3.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Page_names.h>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

gives faces and edges of the page of a mesh their numbers in the shape, in place of those in the model, and their names, colours and parts;
and adds faces of the shape that are not in the model, with the reason, to what was found.

\param shape the model of the shape
\param names its names
\param page the page that `make_mesh_page()` has made of a mesh of `shape.model`
*/
inline void name_mesh_page(const Open_cascade_model_3& shape, const Open_cascade_names_3& names, Mesh_page_3& page)
{
  Parametric_surface_mesher::internal::Page_names(shape, names, page)();
}

} // namespace CGAL

#endif // CGAL_NAME_MESH_PAGE_H
