// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_FUSE_OPEN_CASCADE_SOLIDS_H
#define CGAL_FUSE_OPEN_CASCADE_SOLIDS_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/suspend_handle_macro.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/restore_handle_macro.h>

#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Kernel_guard.h>
#include <CGAL/Parametric_surface_mesher/internal/open_cascade/Solid_fusing.h>
#include <CGAL/Parametric_surface_mesher/internal/support/check_value.h>

#include <BRepTools_History.hxx>
#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgParametricSurfaceMesherOpenCascade
/// Solids that share the faces where they touch, and what was found between them. Solids are numbered from 0, in the order of
/// `TopExp::MapShapes()` in the given shape.
struct Fused_open_cascade_solids
{
  /// two solids that share faces.
  struct Contact
  {
    std::size_t first, second;   ///< the indices of the solids, the smaller one first
    double area;                 ///< of the faces between them
    std::size_t number_of_faces; ///< between them
  };

  /// two solids with a volume in common. It became a solid of its own.
  struct Overlap
  {
    std::size_t first, second; ///< the indices of the solids, the smaller one first
    double volume;             ///< that both have
  };

  /// two solids that have nothing in common, but are close to each other.
  struct Gap
  {
    std::size_t first, second; ///< the indices of the solids, the smaller one first
    double distance;           ///< the smallest distance between them
  };

  TopoDS_Shape shape;
  opencascade::handle<BRepTools_History> history; ///< what has become of solids, faces, edges and vertices; null if there was nothing to fuse
  std::vector<Contact> contacts;
  std::vector<Overlap> overlaps;
  std::vector<Gap> gaps;
};

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

makes solids that touch share their faces, edges and vertices, by the general fuse operation of Open CASCADE (`BOPAlgo_Builder`). Faces are
divided where only a part of them touches another solid. Then a model of the shape has each contact in both shells, and its mesh has the
same triangles on both sides: the parts of an assembly fit together, as a simulation asks for. Shells and faces outside of solids take part, too.
The given shape is not changed. Numbers of faces and edges may change.

\param shape a shape with solids
\param fuzzy the distance up to which faces, edges and vertices that do not quite touch, or overlap by no more, are taken to touch; 0 for
the tolerances of the shape. More than a hundredth of the diagonal of the shape's bounding box is refused: parts would lose faces of their own.
\param reach the largest distance between solids that is listed as a gap

\throws Parametric_surface_mesh_error if `fuzzy` or `reach` is negative or not finite, if `fuzzy` is too large, or if Open CASCADE fails

\sa `CGAL::carry_over_open_cascade_names()`
*/
inline Fused_open_cascade_solids fuse_open_cascade_solids(const TopoDS_Shape& shape, double fuzzy = 0, double reach = 0)
{
  using namespace Parametric_surface_mesher::internal;
  check_not_negative_and_finite("fuzzy distance", fuzzy);
  check_not_negative_and_finite("reach of gaps", reach);
  return guarded([&] {
    const Solid_fusing fusing(shape, fuzzy);
    Fused_open_cascade_solids result;
    result.shape = fusing.shape();
    result.history = fusing.history();
    for(const auto& contact : fusing.contacts())
      result.contacts.push_back({contact.first.first, contact.first.second, contact.second.first, contact.second.second});
    for(const auto& overlap : fusing.overlaps())
      result.overlaps.push_back({overlap.first.first, overlap.first.second, overlap.second});
    for(const auto& gap : fusing.gaps(reach))
      result.gaps.push_back({gap.first.first, gap.first.second, gap.second});
    return result;
  });
}

} // namespace CGAL

#endif // CGAL_FUSE_OPEN_CASCADE_SOLIDS_H
