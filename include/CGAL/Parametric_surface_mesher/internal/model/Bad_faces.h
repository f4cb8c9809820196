// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_BAD_FACES_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_BAD_FACES_H

#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Parametric_surface_mesher/internal/support/describe.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What happens to the faces of a model that cannot be meshed: they are left out, each with the first error that it causes,
// or that error is thrown.
class Bad_faces
{
  const bool m_are_left_out;
  std::map<std::size_t, std::string> m_reasons; // of those that are left out

public:
  explicit Bad_faces(bool are_left_out) : m_are_left_out(are_left_out) {}

  bool are_left_out() const { return m_are_left_out; }
  bool is_empty() const { return m_reasons.empty(); }
  std::size_t size() const { return m_reasons.size(); }
  bool contains(std::size_t face) const { return m_reasons.count(face) > 0; }

  // To be called where an error is caught. Returns the face that is left out because of it. The error is thrown on if faces
  // are not left out, or it does not tell of a face, or that one is left out already.
  std::size_t add(const Parametric_surface_mesh_error& error)
  {
    if(!m_are_left_out || !error.face() || contains(*error.face()))
      throw error;
    m_reasons.emplace(*error.face(), without_name_of_face(error));
    return *error.face();
  }

  // in the order of their numbers
  std::vector<Parametric_surface_mesh_report::Left_out_face> left_out() const
  {
    std::vector<Parametric_surface_mesh_report::Left_out_face> result;
    for(const auto& reason : m_reasons)
      result.push_back({reason.first, reason.second});
    return result;
  }

  // Throws if none of the faces of a model is left.
  void check_that_some_are_good(std::size_t number_of_faces) const
  {
    if(number_of_faces == 0)
      throw Parametric_surface_mesh_error("the model has no faces");
    if(size() == number_of_faces)
      throw Parametric_surface_mesh_error("no face can be meshed; " + numbered("face", m_reasons.begin()->first) + ": "
                                          + m_reasons.begin()->second);
  }

private:
  // An error without the name of the face that it begins with.
  static std::string without_name_of_face(const Parametric_surface_mesh_error& error)
  {
    const std::string what = error.what(), name = numbered("face", *error.face());
    const bool has_name = what.compare(0, name.size(), name) == 0 && what.size() > name.size() + 2;
    return !has_name ? what : what.substr(name.size() + (what[name.size()] == ' ' ? 1 : 2));
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_MODEL_BAD_FACES_H
