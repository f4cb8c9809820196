// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PYTHON_INTERRUPT_GUARD_H
#define PYTHON_INTERRUPT_GUARD_H

#include <csignal>

// Notes an interrupt from the keyboard (SIGINT) as long as the object exists. Python's own handler only makes a note for the interpreter,
// which does not run while there is meshing. If `is_active` is false nothing is done: a program may have its own handler, and Python
// handles signals in its main thread only.
class Interrupt_guard
{
  static inline volatile std::sig_atomic_t is_noted = 0;

  bool m_is_active;
  struct sigaction m_old;

public:
  explicit Interrupt_guard(bool is_active) : m_is_active(is_active)
  {
    if(!m_is_active)
      return;
    is_noted = 0;
    struct sigaction note = {};
    note.sa_handler = [](int) { is_noted = 1; };
    sigemptyset(&note.sa_mask);
    note.sa_flags = SA_RESTART;
    ::sigaction(SIGINT, &note, &m_old);
  }

  ~Interrupt_guard()
  {
    if(m_is_active)
      ::sigaction(SIGINT, &m_old, nullptr);
  }

  Interrupt_guard(const Interrupt_guard&) = delete;
  Interrupt_guard& operator=(const Interrupt_guard&) = delete;

  bool is_interrupted() const { return m_is_active && is_noted != 0; }
};

#endif // PYTHON_INTERRUPT_GUARD_H
