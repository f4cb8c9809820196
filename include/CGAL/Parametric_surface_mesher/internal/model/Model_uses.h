// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_MODEL_USES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_MODEL_USES_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Boundary_size.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Refuses a loop with an edge that a model does not have.
template <class Model>
void check_edge_numbers(const Model& model, std::size_t face, std::size_t loop)
{
  for(const auto& use : model.faces()[face].loops[loop])
    if(use.edge >= model.edges().size())
      throw Parametric_surface_mesh_error(numbered("face", face) + ", " + numbered("loop", loop)
                                          + ": there is no edge with index " + std::to_string(use.edge) + ", only "
                                          + std::to_string(model.edges().size()) + " edges", face);
}

// The uses of each edge of a model, with the side of the edge on which the face lies. Refers to the loops of the model.
template <class Model>
class Model_uses
{
public:
  typedef typename Model::Edge_use Edge_use;

  struct Use
  {
    std::size_t face;
    const Edge_use* use;
    bool is_domain_left; // whether the domain lies to the left of the edge's curve in it
  };

private:
  const Model& m_model;
  std::vector<std::vector<Use>> m_uses; // by edge
  std::vector<std::size_t> m_order;     // the edges in the order of their first use

public:
  // \throws Parametric_surface_mesh_error if a use is of an edge that does not exist
  explicit Model_uses(const Model& model) : m_model(model), m_uses(model.edges().size())
  {
    for(std::size_t f = 0; f < model.faces().size(); ++f)
      for(std::size_t l = 0; l < model.faces()[f].loops.size(); ++l)
        append(f, l);
  }

  const std::vector<Use>& operator[](std::size_t edge) const { return m_uses[edge]; }
  const std::vector<std::size_t>& order() const { return m_order; }

  // The face uses no edge any more. The others keep their order.
  void leave_out(std::size_t face)
  {
    for(const auto& loop : m_model.faces()[face].loops)
      for(const Edge_use& use : loop) {
        auto& uses = m_uses[use.edge];
        uses.erase(std::remove_if(uses.begin(), uses.end(), [=](const Use& u) { return u.face == face; }), uses.end());
      }
    m_order.erase(std::remove_if(m_order.begin(), m_order.end(), [this](std::size_t edge) { return m_uses[edge].empty(); }),
                  m_order.end());
  }

  // Whether the face of `use`, seen from the side that it faces to, lies to the left of the edge.
  bool is_face_left(const Use& use) const { return use.is_domain_left != m_model.faces()[use.face].is_reversed; }

  // The uses of an edge, by shell.
  std::map<std::size_t, std::vector<Use>> by_shell(std::size_t edge) const
  {
    std::map<std::size_t, std::vector<Use>> result;
    for(const Use& use : m_uses[edge])
      result[m_model.faces()[use.face].shell].push_back(use);
    return result;
  }

  // The uses of an edge in one shell.
  std::vector<Use> in_shell(std::size_t edge, std::size_t shell) const
  {
    std::vector<Use> result;
    std::copy_if(m_uses[edge].begin(), m_uses[edge].end(), std::back_inserter(result),
                 [this, shell](const Use& use) { return m_model.faces()[use.face].shell == shell; });
    return result;
  }

  // Whether the edge has at most two uses, both in the same shell, and on different sides.
  bool is_manifold(std::size_t edge) const
  {
    return m_uses[edge].size() < 2
           || (m_uses[edge].size() == 2 && !m_model.edges()[edge].allows_turned_faces
               && m_model.faces()[m_uses[edge][0].face].shell == m_model.faces()[m_uses[edge][1].face].shell);
  }

private:
  void append(std::size_t face, std::size_t number)
  {
    const auto& loop = m_model.faces()[face].loops[number];
    check_edge_numbers(m_model, face, number);
    double double_area = 0;
    for(const Edge_use& use : loop)
      double_area += (use.is_reversed ? -1 : 1) * double_area_seen_from(loop.front().curve.source(), use.curve);
    const bool is_loop_left = (double_area > 0) == (number == 0);
    for(const Edge_use& use : loop) {
      if(m_uses[use.edge].empty())
        m_order.push_back(use.edge);
      m_uses[use.edge].push_back({face, &use, is_loop_left != use.is_reversed});
    }
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_MODEL_USES_H
