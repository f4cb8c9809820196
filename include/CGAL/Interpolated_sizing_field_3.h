// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTERPOLATED_SIZING_FIELD_3_H
#define CGAL_INTERPOLATED_SIZING_FIELD_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Node_values_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Simplex_location_3.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherSizing

Edge lengths that are known at the nodes of a mesh, for instance from the error that a solver estimates there. They are linear in each
triangle or tetrahedron. A point that is in no tetrahedron gets the length at the closest point of the triangles and of the boundary of the
tetrahedra.

\cgalModels{ParametricSurfaceSizingField_3}

\tparam Kernel a model of `Kernel` with `double` as number type

\sa `CGAL::IO::read_node_values()`
*/
template <class Kernel = Exact_predicates_inexact_constructions_kernel>
class Interpolated_sizing_field_3
{
public:
  typedef typename Kernel::Point_3 Point_3;

private:
  // Copies of the field share it.
  std::shared_ptr<const Parametric_surface_mesher::internal::Simplex_location_3> m_location;
  double m_smallest_value;

public:
  /*!
  creates a field of the edge lengths that are the values of `mesh`.
  \throws Parametric_surface_mesh_error if there are no triangles and no tetrahedra or all of them are degenerate, one of them has a node
  that does not exist, a coordinate is not finite, a value is not positive and finite, or the numbers of nodes and values differ
  */
  explicit Interpolated_sizing_field_3(const Node_values_3& mesh)
  {
    check(mesh);
    m_location = std::make_shared<const Parametric_surface_mesher::internal::Simplex_location_3>(mesh);
    if(m_location->is_empty())
      throw Parametric_surface_mesh_error("all triangles and tetrahedra of a sizing field are degenerate");
    m_smallest_value = *std::min_element(mesh.values.begin(), mesh.values.end());
  }

  /// the least of its values.
  double length() const { return m_smallest_value; }

  /// the wanted edge length at a point.
  double operator()(const Point_3& p) const { return m_location->value({{p.x(), p.y(), p.z()}}); }

private:
  static void check(const Node_values_3& mesh)
  {
    using Parametric_surface_mesher::internal::describe;
    using Parametric_surface_mesher::internal::numbered;
    if(mesh.triangles.empty() && mesh.tetrahedra.empty())
      throw Parametric_surface_mesh_error("the mesh of a sizing field has no triangles and no tetrahedra");
    if(mesh.values.size() != mesh.nodes.size())
      throw Parametric_surface_mesh_error("the mesh of a sizing field has " + std::to_string(mesh.nodes.size()) + " nodes and "
                                          + std::to_string(mesh.values.size()) + " values");
    for(std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      const auto& p = mesh.nodes[i];
      if(!std::isfinite(p[0] + p[1] + p[2]))
        throw Parametric_surface_mesh_error("the coordinates of " + numbered("node", i) + " of a sizing field are not finite");
      if(!(mesh.values[i] > 0 && std::isfinite(mesh.values[i])))
        throw Parametric_surface_mesh_error("the length at " + numbered("node", i) + " of a sizing field must be positive and finite, "
                                            "and is " + describe(mesh.values[i]));
    }
    check_nodes(mesh, mesh.triangles, "triangle");
    check_nodes(mesh, mesh.tetrahedra, "tetrahedron");
  }

  template <class Simplices>
  static void check_nodes(const Node_values_3& mesh, const Simplices& simplices, const char* what)
  {
    for(std::size_t i = 0; i < simplices.size(); ++i)
      for(const std::size_t node : simplices[i])
        if(node >= mesh.nodes.size())
          throw Parametric_surface_mesh_error(Parametric_surface_mesher::internal::numbered(what, i)
                                              + " of a sizing field has a node that does not exist, with the index "
                                              + std::to_string(node));
  }
};

} // namespace CGAL

#endif // CGAL_INTERPOLATED_SIZING_FIELD_3_H
