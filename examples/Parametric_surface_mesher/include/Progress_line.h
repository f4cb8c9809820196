// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PROGRESS_LINE_H
#define PROGRESS_LINE_H

#include "Mesh_callbacks.h"

#include <CGAL/Parametric_surface_mesh_visitor.h>

#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <iostream>
#include <string>
#include <utility>

// Shows on the terminal, if there is one, how far meshing is: a line that overwrites itself. Callbacks are told
// and asked, too.
class Progress_line : public CGAL::Parametric_surface_mesh_visitor
{
  typedef std::chrono::steady_clock Clock;

  bool m_is_shown;
  std::string m_phase, m_face; // the latter is empty unless there are several
  Clock::time_point m_last = Clock::now();
  Mesh_callbacks m_callbacks;

public:
  explicit Progress_line(bool is_quiet, Mesh_callbacks callbacks = Mesh_callbacks())
    : m_is_shown(!is_quiet && isatty(STDERR_FILENO)), m_callbacks(std::move(callbacks))
  {}

  ~Progress_line() { clear(); }

  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;

  // Phases in which nothing else is told are shown at once.
  void on_phase(const char* name)
  {
    m_phase = name;
    if(m_callbacks.on_phase)
      m_callbacks.on_phase(name);
    if(m_phase == "intersections")
      show("looking for self-intersections");
    else if(m_phase == "measuring")
      show(m_phase);
  }

  void on_face(std::size_t number, std::size_t number_of_faces)
  {
    m_face = number_of_faces == 1 ? "" : "face " + std::to_string(number) + " of " + std::to_string(number_of_faces);
    if(!m_face.empty() && is_time_to_show())
      show(m_face);
  }

  bool go_further() { return !m_callbacks.go_further || m_callbacks.go_further(); }

  void on_progress(std::size_t number_of_vertices, std::size_t number_of_bad_faces)
  {
    if(m_callbacks.on_progress)
      m_callbacks.on_progress(number_of_vertices, number_of_bad_faces);
    if(is_time_to_show())
      show((m_face.empty() ? m_phase : m_face) + ": " + std::to_string(number_of_vertices) + " vertices, at most "
           + std::to_string(number_of_bad_faces) + " triangles waiting");
  }

  // removes the line
  void clear()
  {
    if(m_is_shown)
      std::cerr << "\r\033[K" << std::flush;
  }

private:
  bool is_time_to_show() const { return m_is_shown && Clock::now() - m_last >= std::chrono::milliseconds(100); }

  void show(const std::string& line)
  {
    if(!m_is_shown)
      return;
    m_last = Clock::now();
    std::cerr << "\r\033[K" << line << std::flush;
  }
};

#endif // PROGRESS_LINE_H
