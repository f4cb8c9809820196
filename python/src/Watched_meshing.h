// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PYTHON_WATCHED_MESHING_H
#define PYTHON_WATCHED_MESHING_H

#include "Formula.h"
#include "Interrupt_guard.h"
#include "Mesh_callbacks.h"

#include <pybind11/pybind11.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// A Python object that is copied, and destroyed, by threads without Python's lock.
typedef std::shared_ptr<pybind11::object> Shared_object;

inline Shared_object share(pybind11::object object)
{
  return Shared_object(new pybind11::object(std::move(object)), [](pybind11::object* shared) {
    const pybind11::gil_scoped_acquire lock;
    delete shared;
  });
}

// Runs the mesher without Python's lock, calls what Python passes with it, and stops when Python's user wants that.
class Watched_meshing
{
  typedef std::chrono::steady_clock Clock;

  pybind11::object m_progress, m_size;
  std::optional<Clock::time_point> m_end;
  Interrupt_guard m_interrupt;
  std::string m_phase;
  std::mutex m_mutex;
  std::exception_ptr m_error; // the first one that a function of Python has raised
  std::atomic<bool> m_is_stopped{false};

public:
  // `progress`: called with the phase and the number of vertices; `size`: with three coordinates, or a Formula; both may be None
  Watched_meshing(pybind11::object progress, pybind11::object size, std::optional<double> time_limit, bool handles_interrupts)
    : m_progress(std::move(progress)), m_size(std::move(size)), m_interrupt(handles_interrupts)
  {
    if(time_limit)
      m_end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(*time_limit));
  }

  // What `mesh` returns for the callbacks, and whether the user has interrupted it. What functions of Python have raised is raised again.
  template <class Function>
  auto operator()(const Function& mesh)
  {
    const Mesh_callbacks callbacks = this->callbacks();
    std::optional<decltype(mesh(callbacks))> result;
    std::exception_ptr error;
    {
      const pybind11::gil_scoped_release no_lock;
      try {
        result.emplace(mesh(callbacks));
      }
      catch(...) {
        error = std::current_exception();
      }
    }
    if(m_error)
      std::rethrow_exception(m_error);
    if(error && m_interrupt.is_interrupted()) { // for instance the reader of a file, which was interrupted, too
      PyErr_SetNone(PyExc_KeyboardInterrupt);
      throw pybind11::error_already_set();
    }
    if(error)
      std::rethrow_exception(error);
    return std::make_pair(std::move(*result), m_interrupt.is_interrupted());
  }

private:
  // Calls a function of Python with Python's lock; an error stops the run.
  template <class Function>
  auto guarded(const Function& function)
  {
    const pybind11::gil_scoped_acquire lock;
    try {
      return function();
    }
    catch(...) {
      {
        const std::lock_guard<std::mutex> only_one(m_mutex);
        if(!m_error)
          m_error = std::current_exception();
      }
      m_is_stopped = true;
      throw;
    }
  }

  Mesh_callbacks callbacks()
  {
    Mesh_callbacks result;
    result.go_further = [this] { return goes_further(); };
    if(!m_progress.is_none()) {
      result.on_phase = [this](const char* name) {
        m_phase = name;
        tell(0);
      };
      result.on_progress = [this](std::size_t number_of_vertices, std::size_t) { tell(number_of_vertices); };
    }
    if(pybind11::isinstance<Formula>(m_size))
      result.size = [formula = m_size.cast<Formula>()](double x, double y, double z) {
        std::vector<double> registers;
        return formula.evaluate<1>(std::array<double, 3>{x, y, z}, registers)[0];
      };
    else if(!m_size.is_none())
      result.size = [this](double x, double y, double z) {
        return guarded([&] { return number_of(m_size(x, y, z)); });
      };
    return result;
  }

  static double number_of(const pybind11::object& size)
  {
    try {
      return size.cast<double>();
    }
    catch(const pybind11::cast_error&) {
      throw pybind11::type_error("size: the function must return a number, but returned " + pybind11::repr(size).cast<std::string>());
    }
  }

  bool goes_further() const { return !m_is_stopped && !m_interrupt.is_interrupted() && !(m_end && Clock::now() > *m_end); }

  void tell(std::size_t number_of_vertices)
  {
    if(m_is_stopped)
      return;
    const bool stops = guarded([&] {
      const pybind11::object answer = m_progress(m_phase, number_of_vertices);
      return !answer.is_none() && !answer.cast<bool>();
    });
    if(stops)
      m_is_stopped = true;
  }
};

#endif // PYTHON_WATCHED_MESHING_H
