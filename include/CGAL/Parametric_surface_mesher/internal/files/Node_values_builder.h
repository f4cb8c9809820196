// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_NODE_VALUES_BUILDER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_NODE_VALUES_BUILDER_H

#include <CGAL/Node_values_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>

#include <cstddef>
#include <limits>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

[[noreturn]] inline void throw_file_error(const std::string& file_name, const std::string& what)
{
  throw Parametric_surface_mesh_error(file_name + ": " + what);
}

// The values that a file has by one name: one for each node, in the order or by the numbers of the file.
struct Named_node_values
{
  std::string name;
  std::size_t number_of_components;
};

// Chooses from what a file has: the scalar values with a name, or the only ones. Returns the index.
inline std::size_t chosen_values(const std::string& file_name, const std::vector<Named_node_values>& all, const std::string& name)
{
  std::string known;
  std::size_t result = all.size(), number_of_scalars = 0;
  for(std::size_t i = all.size(); i-- > 0;) {
    if(all[i].number_of_components != 1)
      continue;
    ++number_of_scalars;
    known = "'" + all[i].name + "'" + (known.empty() ? "" : ", " + known);
    if(name.empty() || all[i].name == name)
      result = i;
  }
  if(number_of_scalars == 0)
    throw_file_error(file_name, "there are no scalar values at the nodes");
  if(result == all.size())
    throw_file_error(file_name, "there are no values '" + name + "' at the nodes, but " + known);
  if(name.empty() && number_of_scalars > 1)
    throw_file_error(file_name, "there are several kinds of values at the nodes, and one of them must be chosen: " + known);
  return result;
}

// A mesh in the making, of elements whose nodes have numbers of their file. In the end only nodes of triangles and tetrahedra are left.
class Node_values_builder
{
  std::string m_file_name;
  Node_values_3 m_mesh;
  std::unordered_map<std::size_t, std::size_t> m_indices; // of nodes, by number

public:
  explicit Node_values_builder(const std::string& file_name) : m_file_name(file_name) {}

  std::size_t number_of_nodes() const { return m_mesh.nodes.size(); }

  void add_node(std::size_t number, double x, double y, double z)
  {
    if(!m_indices.emplace(number, m_mesh.nodes.size()).second)
      throw_file_error(m_file_name, "the node " + std::to_string(number) + " is there twice");
    m_mesh.nodes.push_back({{x, y, z}});
    m_mesh.values.push_back(std::numeric_limits<double>::quiet_NaN());
  }

  void set_value(std::size_t number, double value) { m_mesh.values[index(number)] = value; }

  // Adds the triangle with the first three nodes. This and the next functions take an element of any order, whose corners come first.
  void add_triangle(const std::size_t* nodes) { m_mesh.triangles.push_back({{index(nodes[0]), index(nodes[1]), index(nodes[2])}}); }

  void add_quadrilateral(const std::size_t* nodes)
  {
    const std::size_t rest[3] = {nodes[0], nodes[2], nodes[3]};
    add_triangle(nodes);
    add_triangle(rest);
  }

  void add_tetrahedron(const std::size_t* nodes)
  {
    m_mesh.tetrahedra.push_back({{index(nodes[0]), index(nodes[1]), index(nodes[2]), index(nodes[3])}});
  }

  [[noreturn]] void refuse_element(const std::string& kind) const
  {
    throw_file_error(m_file_name, "there are elements of " + kind + "; triangles, quadrilaterals and tetrahedra are read, no others");
  }

  Node_values_3 mesh()
  {
    if(m_mesh.triangles.empty() && m_mesh.tetrahedra.empty())
      throw_file_error(m_file_name, "there are no triangles and no tetrahedra");
    std::vector<std::size_t> new_indices(m_mesh.nodes.size(), m_mesh.nodes.size());
    Node_values_3 result;
    const auto take = [&](auto& elements) {
      for(auto& element : elements)
        for(std::size_t& node : element) {
          if(new_indices[node] == m_mesh.nodes.size()) {
            new_indices[node] = result.nodes.size();
            result.nodes.push_back(m_mesh.nodes[node]);
            result.values.push_back(m_mesh.values[node]);
          }
          node = new_indices[node];
        }
    };
    take(m_mesh.triangles);
    take(m_mesh.tetrahedra);
    result.triangles = std::move(m_mesh.triangles);
    result.tetrahedra = std::move(m_mesh.tetrahedra);
    return result;
  }

private:
  std::size_t index(std::size_t number) const
  {
    const auto found = m_indices.find(number);
    if(found == m_indices.end())
      throw_file_error(m_file_name, "there is no node " + std::to_string(number));
    return found->second;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_NODE_VALUES_BUILDER_H
