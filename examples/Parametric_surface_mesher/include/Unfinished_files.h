// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef UNFINISHED_FILES_H
#define UNFINISHED_FILES_H

#include <csignal>
#include <cstddef>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

// Files that are removed if the process is interrupted (SIGINT) or told to end (SIGTERM, SIGHUP) as long as this object exists.
// There must be no more than one such object at a time. A signal that is ignored, or handled by the program around, is left as it is.
class Unfinished_files
{
  static constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

  // What the handler of the signals reads: it may remove files and read memory that does not change meanwhile, but do little else.
  static inline const char* const* s_names = nullptr;
  static inline volatile std::sig_atomic_t s_number = 0;

  std::vector<std::string> m_names;
  std::vector<const char*> m_pointers;
  std::vector<std::pair<int, struct sigaction>> m_actions; // before

public:
  explicit Unfinished_files(std::vector<std::string> names) : m_names(std::move(names))
  {
    for(const std::string& name : m_names)
      m_pointers.push_back(name.c_str());
    s_names = m_pointers.data();
    s_number = std::sig_atomic_t(m_pointers.size());
    for(const int signal : signals) {
      struct sigaction before, action = {};
      action.sa_handler = &remove_all;
      if(sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_DFL && sigaction(signal, &action, nullptr) == 0)
        m_actions.emplace_back(signal, before);
    }
  }

  ~Unfinished_files()
  {
    for(const auto& action : m_actions)
      sigaction(action.first, &action.second, nullptr);
    s_number = 0;
  }

  Unfinished_files(const Unfinished_files&) = delete;
  Unfinished_files& operator=(const Unfinished_files&) = delete;

private:
  // The process ends as it would have without this handler.
  static void remove_all(int signal)
  {
    for(std::sig_atomic_t i = 0; i < s_number; ++i)
      unlink(s_names[i]);
    std::signal(signal, SIG_DFL);
    raise(signal);
  }
};

#endif // UNFINISHED_FILES_H
