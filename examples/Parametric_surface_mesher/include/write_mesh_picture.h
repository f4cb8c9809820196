// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_MESH_PICTURE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_MESH_PICTURE_H

/*!
\file write_mesh_picture.h

Pictures of triangle meshes as SVG files, in space and in the parameter domain.
*/

#include "write_domain_picture.h"
#include "write_surface_picture.h"

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_EXAMPLES_WRITE_MESH_PICTURE_H
