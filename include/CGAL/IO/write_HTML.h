// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_IO_WRITE_HTML_H
#define CGAL_IO_WRITE_HTML_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Mesh_page_3.h>
#include <CGAL/Parametric_surface_mesher/internal/page/Page_writer.h>

#include <ostream>

// What a page consists of beside its mesh. CMake makes this file of the folder page/ and three.js.
#include <Parametric_surface_mesher_page_source.h>

namespace CGAL {
namespace IO {

/*!
\ingroup PkgParametricSurfaceMesherFiles

writes a mesh as a page to look at in a browser. The page is one file and needs no network: the mesh can be turned, zoomed and cut; it
is coloured by face, part, smallest angle, the values of the page or by what was not met; a click tells the face, the triangle and its
values, and shows the domain of the face beside it, with circumellipses. Coordinates are rounded to \f$ 2^{-24} \f$ of the size of the
mesh, values to \f$ 2^{-16} \f$ of their range.

This header needs three.js (`libjs-three` of Debian). Link with the target `Parametric_surface_mesher::Page_support`, which exists if
three.js was found. Without CMake's targets, `cmake -DTHREE_JS_DIR=... -DOUTPUT=... -P make_mesh_page_source.cmake` makes the header
`Parametric_surface_mesher_page_source.h`, which is included here.

\return whether the stream is good
\throws Parametric_surface_mesh_error if the arrays of the page do not fit together
*/
inline bool write_HTML(std::ostream& out, const Mesh_page_3& page)
{
  namespace source = Parametric_surface_mesher::internal::page_source;
  Parametric_surface_mesher::internal::check_page(page);
  for(const char* text : source::before_mesh)
    out << text;
  Parametric_surface_mesher::internal::Page_writer(page, out).write();
  for(const char* text : source::after_mesh)
    out << text;
  return out.good();
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_WRITE_HTML_H
