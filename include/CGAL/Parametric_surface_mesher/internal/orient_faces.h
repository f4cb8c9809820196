// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ORIENT_FACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ORIENT_FACES_H

#include <CGAL/Parametric_surface_mesh_error.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Reverses faces of a model so that neighbours run through their common edge in opposite directions. The outer loops are
// counterclockwise in the domains. The first face of each connected piece stays as it is.
template <class Model>
class Face_orientation
{
  typedef std::pair<std::size_t, bool> Use; // face, is reversed there

  Model& m_model;
  std::vector<std::vector<Use>> m_uses; // of each edge
  std::vector<bool> m_is_done;

public:
  explicit Face_orientation(Model& model) : m_model(model), m_uses(model.edges().size()), m_is_done(model.faces().size())
  {
    for(std::size_t f = 0; f < model.faces().size(); ++f)
      for(const auto& loop : model.faces()[f].loops)
        for(const auto& use : loop)
          m_uses[use.edge].emplace_back(f, use.is_reversed);
  }

  void operator()()
  {
    for(std::size_t e = 0; e < m_uses.size(); ++e)
      if(m_uses[e].size() > 2)
        throw Parametric_surface_mesh_error("edge " + std::to_string(e) + " is used by "
                                            + std::to_string(m_uses[e].size()) + " faces, of which faces "
                                            + std::to_string(m_uses[e][0].first) + " and "
                                            + std::to_string(m_uses[e][2].first) + "; at most two are possible");
    for(std::size_t f = 0; f < m_is_done.size(); ++f)
      if(!m_is_done[f])
        orient_piece(f);
  }

private:
  void orient_piece(std::size_t first)
  {
    std::vector<std::size_t> stack(1, first);
    m_is_done[first] = true;
    while(!stack.empty()) {
      const std::size_t face = stack.back();
      stack.pop_back();
      for(const auto& loop : m_model.faces()[face].loops)
        for(const auto& use : loop)
          for(const Use& other : m_uses[use.edge])
            if(other.first != face)
              orient_neighbor(face, use.is_reversed, other, use.edge, stack);
    }
  }

  void orient_neighbor(std::size_t face, bool is_use_reversed, const Use& other, std::size_t edge,
                       std::vector<std::size_t>& stack)
  {
    const bool runs_backward = m_model.faces()[face].is_reversed != is_use_reversed;
    const bool should_be_reversed = other.second == runs_backward;
    if(!m_is_done[other.first]) {
      m_model.faces()[other.first].is_reversed = should_be_reversed;
      m_is_done[other.first] = true;
      stack.push_back(other.first);
    }
    else if(m_model.faces()[other.first].is_reversed != should_be_reversed)
      throw Parametric_surface_mesh_error("the surface is not orientable: faces " + std::to_string(face) + " and "
                                          + std::to_string(other.first) + " cannot face to the same side along edge "
                                          + std::to_string(edge));
  }
};

template <class Model>
void orient_faces(Model& model)
{
  Face_orientation<Model> orientation(model);
  orientation();
}

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_ORIENT_FACES_H
