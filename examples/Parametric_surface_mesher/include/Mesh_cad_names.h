// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces, edges and vertices by what the user calls them: names, or numbers from 1.
#ifndef MESH_CAD_NAMES_H
#define MESH_CAD_NAMES_H

#include "Local_size.h"
#include "Mesh_cad_parts.h"
#include "Usage_error.h"

#include <CGAL/Open_cascade_model_3.h>

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace mesh_cad {

typedef std::set<std::size_t> Indices;

// The kinds of things that have numbers and names.
class Named_entities
{
  const char* m_kind;
  std::size_t m_number;

protected:
  Named_entities(const char* kind, std::size_t number) : m_kind(kind), m_number(number) {}

  static Indices with_name(const std::vector<std::string>& names, const std::string& word)
  {
    Indices result;
    for(std::size_t i = 0; i < names.size(); ++i)
      if(!word.empty() && names[i] == word)
        result.insert(i);
    return result;
  }

public:
  const char* kind() const { return m_kind; }

  // The indices that a number, or two numbers with a dash between, stand for.
  Indices numbered(const std::string& option, const std::string& word) const
  {
    const bool is_number = !word.empty() && word.find_first_not_of("0123456789-") == std::string::npos;
    if(!is_number)
      throw Usage_error("--" + option + ": there is no " + m_kind + " '" + word + "'; names are listed by --list, numbers go from 1 to "
                        + std::to_string(m_number));
    const std::size_t dash = word.find('-');
    const std::size_t first = positive_number(option, word.substr(0, dash)),
                      last = dash == std::string::npos ? first : positive_number(option, word.substr(dash + 1));
    if(last < first)
      throw Usage_error("--" + option + ": '" + word + "' must be a number, or two ascending numbers with a dash between");
    if(last > m_number)
      throw Usage_error("--" + option + ": there is no " + m_kind + " " + std::to_string(last) + ", the shape has "
                        + mesh_patch::plural(m_number, m_kind));
    Indices result;
    for(std::size_t i = first; i <= last; ++i)
      result.insert(i - 1);
    return result;
  }

private:
  static std::size_t positive_number(const std::string& option, const std::string& word)
  {
    const bool is_number = !word.empty() && word.size() < 10 && word.find_first_not_of("0123456789") == std::string::npos;
    if(!is_number || std::stoul(word) == 0)
      throw Usage_error("--" + option + ": '" + word + "' must be a whole number, at least 1");
    return std::stoul(word);
  }
};

// Faces by their names, or by that of a part: all its faces.
class Named_faces : public Named_entities
{
  const Names& m_names;

public:
  Named_faces(const Names& names, const CGAL::Open_cascade_model_3& shape)
    : Named_entities("face", shape.number_of_shape_faces), m_names(names)
  {}

  Indices called(const std::string& word) const
  {
    Indices result = with_name(m_names.face_names, word);
    if(result.empty())
      for(const std::size_t part : parts_with_name(m_names, word))
        result.insert(m_names.parts[part].faces.begin(), m_names.parts[part].faces.end());
    return result;
  }
};

// Edges by their names, or by that of a face or part: all edges of its faces.
class Named_edges : public Named_entities
{
  const Names& m_names;
  const CGAL::Open_cascade_model_3& m_shape;

public:
  Named_edges(const Names& names, const CGAL::Open_cascade_model_3& shape)
    : Named_entities("edge", shape.number_of_shape_edges), m_names(names), m_shape(shape)
  {}

  Indices called(const std::string& word) const
  {
    const Indices result = with_name(m_names.edge_names, word);
    return result.empty() ? edges_of(Named_faces(m_names, m_shape).called(word)) : result;
  }

private:
  Indices edges_of(const Indices& faces) const
  {
    Indices model_edges, result;
    for(std::size_t f = 0; f < m_shape.shape_faces.size(); ++f)
      if(faces.count(m_shape.shape_faces[f]) > 0)
        for(const auto& loop : m_shape.model.faces()[f].loops)
          for(const auto& use : loop)
            model_edges.insert(use.edge);
    for(std::size_t e = 0; e < m_shape.model_edges.size(); ++e)
      for(const std::size_t edge : m_shape.model_edges[e])
        if(model_edges.count(edge) > 0)
          result.insert(e);
    return result;
  }
};

class Named_vertices : public Named_entities
{
  const Names& m_names;

public:
  explicit Named_vertices(const Names& names) : Named_entities("vertex", names.vertex_names.size()), m_names(names) {}

  Indices called(const std::string& word) const { return with_name(m_names.vertex_names, word); }
};

// The indices of what has a name or, if nothing has, a number.
template <class Entities>
Indices indices_of(const Entities& entities, const std::string& option, const std::string& word)
{
  const Indices result = entities.called(word);
  return result.empty() ? entities.numbered(option, word) : result;
}

// The indices in a list like "1,4,7-9,Flange". Names may contain commas: a list that is a name as a whole is taken for one.
template <class Entities>
Indices indices_in(const Entities& entities, const std::string& option, const std::string& list)
{
  Indices result = entities.called(list);
  if(result.empty())
    for(const std::string& word : words_between(list, ',')) {
      const Indices some = indices_of(entities, option, word);
      result.insert(some.begin(), some.end());
    }
  return result;
}

// The lengths in a list like "3:0.5,Flange:0.25". The last one counts if there are several for the same.
template <class Entities>
std::map<std::size_t, double> sizes_in(const Entities& entities, const std::string& option, const std::string& list)
{
  std::map<std::size_t, double> result;
  const bool is_single = !entities.called(list.substr(0, list.rfind(':'))).empty(); // a name with commas
  for(const std::string& item : is_single ? std::vector<std::string>{list} : words_between(list, ',')) {
    const std::size_t colon = item.rfind(':');
    double length = 0;
    if(colon == std::string::npos || !is_finite_number(item.substr(colon + 1), length) || !(length > 0))
      throw Usage_error("--" + option + ": '" + item + "' must be a number or a name, a colon and a positive length");
    for(const std::size_t i : indices_of(entities, option, item.substr(0, colon)))
      result[i] = length;
  }
  return result;
}

} // namespace mesh_cad

#endif // MESH_CAD_NAMES_H
