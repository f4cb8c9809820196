// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_SYNCHRONIZED_VISITOR_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_SYNCHRONIZED_VISITOR_H

#include <cstddef>
#include <mutex>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Passes on the calls of several threads, one at a time.
template <class Visitor>
class Synchronized_visitor
{
  Visitor& m_visitor;
  std::mutex m_mutex;

public:
  explicit Synchronized_visitor(Visitor& visitor) : m_visitor(visitor) {}

  void on_phase(const char* name)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_visitor.on_phase(name);
  }

  void on_progress(std::size_t number_of_vertices, std::size_t number_of_bad_faces)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_visitor.on_progress(number_of_vertices, number_of_bad_faces);
  }

  bool go_further()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_visitor.go_further();
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_SYNCHRONIZED_VISITOR_H
