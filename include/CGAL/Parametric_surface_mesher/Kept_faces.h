// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_KEPT_FACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_KEPT_FACES_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Parametric_surface_mesher/internal/driver/Face_signature.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Meshed_faces.h>

#include <cstddef>
#include <map>

namespace CGAL {
namespace Parametric_surface_mesher {

/*!
\ingroup PkgParametricSurfaceMesherRef

The faces of a model as they were meshed, for the next time that the model is meshed: those that would get the same triangles keep
them and are not meshed again. It is passed to the mesher by `CGAL::parameters::kept_faces()`, and serves wherever a model is meshed
several times with other sizes in some places, as in a loop of a solver and its estimate of the error.

A face keeps its triangles if

- its boundary is divided as before, point by point,
- the criteria have the same values, and so have its own sizes, and those beside narrow faces that
  `Parametric_surface_mesh_criteria::set_closeness()` asks for,
- its sizing field gives the same lengths as before at all vertices and in the middle of each triangle, and its surface the same points
  at all vertices.

So the mesh is the same as without it, unless a sizing field has changed in between these places only. With a metric field or a criterion
of the user, or points placed by a function of theirs, which cannot be compared, all faces are meshed anew.

It takes the memory of the triangles once more. It must not be used by two runs at the same time.

\tparam Kernel the kernel of the surfaces
*/
template <class Kernel>
class Kept_faces
{
  internal::Meshed_faces<Kernel> m_faces;
  std::map<std::size_t, internal::Face_signature<Kernel>> m_signatures;

public:
  /// the number of faces that have kept, in the last run, the triangles of the run before.
  std::size_t number_of_kept_faces() const { return m_faces.number_of_kept_faces(); }

  /// forgets all faces.
  void clear() { *this = Kept_faces(); }

  /// \cond SKIP_IN_MANUAL

  internal::Meshed_faces<Kernel>& meshed_faces() { return m_faces; }

  // Is called before a run: forgets the faces whose functions give other values than in the run before.
  template <class Model, class Criteria>
  void begin(const Model& model, const Criteria& criteria)
  {
    m_faces.begin_run();
    m_faces.forget_if([&](std::size_t f, const auto& face) {
      const auto before = m_signatures.find(f);
      return f >= model.faces().size() || before == m_signatures.end()
             || !(before->second == internal::Face_signature<Kernel>(face, model.faces()[f], criteria));
    });
  }

  // Is called after a run.
  template <class Model, class Criteria>
  void end(const Model& model, const Criteria& criteria)
  {
    m_signatures.clear();
    m_faces.for_each([&](std::size_t f, const auto& face) {
      m_signatures.emplace(f, internal::Face_signature<Kernel>(face, model.faces()[f], criteria));
    });
  }

  /// \endcond
};

} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_KEPT_FACES_H
