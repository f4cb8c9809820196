// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_MESH_PROGRESS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_MESH_PROGRESS_H

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

template <class Visitor, class = void>
struct Is_told_of_faces : std::false_type {};

template <class Visitor>
struct Is_told_of_faces<Visitor, std::void_t<decltype(std::declval<Visitor&>().on_face(std::size_t(), std::size_t()))>> : std::true_type {};

// The visitor of a run, for all threads of the run: they call it one at a time. Once it has said that the run is to stop, the
// run is stopped, and it is not asked again.
class Mesh_progress
{
  typedef std::chrono::steady_clock Clock;

  // A visitor may take its time: a progress bar redraws, an interpreter takes a lock. So it is asked no more often than
  // somebody who waits for an answer can tell.
  static constexpr Clock::duration time_between_questions = std::chrono::milliseconds(2);

  std::function<void(const char*)> m_on_phase;
  std::function<void(std::size_t, std::size_t)> m_on_progress;
  std::function<void(std::size_t, std::size_t)> m_on_face; // empty if the visitor has no such function
  std::function<bool()> m_go_further;
  std::size_t m_number_of_faces = 0, m_number_of_begun_faces = 0;
  std::mutex m_mutex;
  std::atomic<bool> m_is_stopped{false};
  std::atomic<Clock::rep> m_next_question{0}; // by the clock

public:
  // of a run that nobody watches
  Mesh_progress() {}

  // refers to `visitor`
  template <class Visitor>
  explicit Mesh_progress(Visitor& visitor)
    : m_on_phase([&visitor](const char* name) { visitor.on_phase(name); }),
      m_on_progress([&visitor](std::size_t number_of_vertices, std::size_t number_of_bad_faces) {
        visitor.on_progress(number_of_vertices, number_of_bad_faces);
      }),
      m_go_further([&visitor] { return visitor.go_further(); })
  {
    if constexpr(Is_told_of_faces<Visitor>::value)
      m_on_face = [&visitor](std::size_t number, std::size_t number_of_faces) { visitor.on_face(number, number_of_faces); };
  }

  // it is shared by reference
  Mesh_progress(const Mesh_progress&) = delete;
  Mesh_progress& operator=(const Mesh_progress&) = delete;

  bool is_stopped() const { return m_is_stopped.load(std::memory_order_relaxed); }

  // A phase begins, of the run or of a patch. The visitor is asked, too.
  void on_phase(const char* name)
  {
    if(!m_go_further)
      return;
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_on_phase(name);
    ask();
  }

  // The visitor is asked, too.
  void on_progress(std::size_t number_of_vertices, std::size_t number_of_bad_faces)
  {
    if(!m_go_further)
      return;
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_on_progress(number_of_vertices, number_of_bad_faces);
    ask();
  }

  // So many faces are going to begin.
  void begin_faces(std::size_t number_of_faces)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_number_of_faces = number_of_faces;
    m_number_of_begun_faces = 0;
  }

  // A face begins.
  void on_face()
  {
    if(!m_on_face)
      return;
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_on_face(++m_number_of_begun_faces, m_number_of_faces);
  }

  // Asks the visitor, if it is time to.
  bool go_further()
  {
    if(is_stopped())
      return false;
    if(!m_go_further || now() < m_next_question.load(std::memory_order_relaxed))
      return true;
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(now() >= m_next_question.load(std::memory_order_relaxed)) // else another thread has asked meanwhile
      ask();
    return !is_stopped();
  }

private:
  static Clock::rep now() { return Clock::now().time_since_epoch().count(); }

  // \pre the mutex is locked
  void ask()
  {
    if(is_stopped())
      return;
    if(!m_go_further())
      m_is_stopped.store(true, std::memory_order_relaxed);
    m_next_question.store((Clock::now() + time_between_questions).time_since_epoch().count(), std::memory_order_relaxed);
  }
};

// What one thread has of the progress of a run while it works on a patch, or a part of one. All loops of that work ask
// `go_further()` in each step: it costs next to nothing. Once it is false the patch stays as it is, and `is_stopped()`; a
// patch that was done before the stop is not.
class Patch_progress
{
  // A step takes a microsecond or less, or some when a surface is slow: so the clock is looked at often enough, and takes
  // less than a hundredth of the time.
  static constexpr unsigned int steps_between_looks = 16;

  Mesh_progress& m_progress;
  unsigned int m_steps_left = 1;
  bool m_is_stopped = false;

public:
  explicit Patch_progress(Mesh_progress& progress) : m_progress(progress) {}

  // it is shared by reference
  Patch_progress(const Patch_progress&) = delete;
  Patch_progress& operator=(const Patch_progress&) = delete;

  bool is_stopped() const { return m_is_stopped; }

  bool go_further()
  {
    if(--m_steps_left > 0)
      return true;
    return look();
  }

  void on_phase(const char* name)
  {
    m_progress.on_phase(name);
    m_steps_left = 1;
  }

  void on_progress(std::size_t number_of_vertices, std::size_t number_of_bad_faces)
  {
    m_progress.on_progress(number_of_vertices, number_of_bad_faces);
    m_steps_left = 1;
  }

private:
  bool look()
  {
    m_is_stopped = m_is_stopped || !m_progress.go_further();
    m_steps_left = m_is_stopped ? 1 : steps_between_looks;
    return !m_is_stopped;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_SUPPORT_MESH_PROGRESS_H
