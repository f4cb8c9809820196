// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CHILD_PROCESS_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CHILD_PROCESS_H

#if defined(__unix__) || defined(__APPLE__)
#define CGAL_PARAMETRIC_SURFACE_MESHER_HAS_CHILD_PROCESSES

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What a child process may use.
struct Process_limits
{
  unsigned int seconds; // of processor time
  double bytes;         // of address space
};

// How a child process has ended.
struct Process_end
{
  enum Kind
  {
    DONE,     // its function has returned
    OUT_OF_TIME,
    CRASHED,  // by the signal that `text` names
    FAILED    // by an exception with the message `text`, which is the memory's if it ran out
  };

  Kind kind;
  std::string text; // what the function returned, or why there is nothing
};

/*
Runs a function in a copy of this process, with limits of its own and without output, and tells how that has ended: a crash
or an endless loop in a library ends the copy alone. The function returns a text; everything else that it does is gone with
the copy, but for files.
Processes are managed by the system's own calls: Boost.Process starts other programs, and a library has none to start.
*/
class Child_process
{
  // A copy that waits for something gets no processor time; it has this many times its seconds by the clock.
  static constexpr unsigned int clock_over_processor = 20;

  int m_pipe[2];
  pid_t m_process = -1;

public:
  template <class Function>
  Child_process(const Process_limits& limits, const Function& function)
  {
    if(::pipe(m_pipe) != 0)
      throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
    std::fflush(nullptr); // else the copy has what is not yet written, too
    m_process = ::fork();
    if(m_process < 0) {
      const int error = errno;
      ::close(m_pipe[0]);
      ::close(m_pipe[1]);
      throw std::system_error(error, std::generic_category(), "cannot start a process");
    }
    if(m_process == 0)
      run(limits, function);
    ::close(m_pipe[1]);
  }

  Child_process(const Child_process&) = delete;
  Child_process& operator=(const Child_process&) = delete;

  // waits for the end
  // \pre it was not called before
  Process_end operator()() const
  {
    const std::string text = read_all();
    int status = 0;
    while(::waitpid(m_process, &status, 0) < 0)
      if(errno != EINTR)
        throw std::system_error(errno, std::generic_category(), "cannot wait for a process");
    if(WIFSIGNALED(status)) {
      const int signal = WTERMSIG(status);
      if(signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL)
        return {Process_end::OUT_OF_TIME, ""};
      return {Process_end::CRASHED, ::strsignal(signal)};
    }
    return {WEXITSTATUS(status) == 0 ? Process_end::DONE : Process_end::FAILED, text};
  }

private:
  // in the copy; does not return
  template <class Function>
  [[noreturn]] void run(const Process_limits& limits, const Function& function) const
  {
    ::close(m_pipe[0]);
    for(int signal : {SIGINT, SIGTERM, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGALRM})
      std::signal(signal, SIG_DFL);
    silence();
    set_limit(RLIMIT_CPU, limits.seconds);
    set_limit(RLIMIT_AS, limits.bytes);
    set_limit(RLIMIT_CORE, 0);
    ::alarm(clock_over_processor * limits.seconds);
    int status = 1;
    std::string text;
    try {
      text = function();
      status = 0;
    }
    catch(const std::exception& error) {
      text = error.what();
    }
    catch(...) {
      text = "unknown exception";
    }
    write_all(text);
    ::_exit(status); // what the process would do at its end is left to the original
  }

  static void silence()
  {
    const int nowhere = ::open("/dev/null", O_WRONLY);
    if(nowhere < 0)
      return;
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
  }

  template <class Resource>
  static void set_limit(Resource resource, double limit)
  {
    rlimit limits;
    if(::getrlimit(resource, &limits) != 0)
      return;
    if(limits.rlim_cur == RLIM_INFINITY || double(limits.rlim_cur) > limit)
      limits.rlim_cur = rlim_t(limit);
    ::setrlimit(resource, &limits);
  }

  void write_all(const std::string& text) const
  {
    for(std::size_t begin = 0; begin < text.size();) {
      const ssize_t n = ::write(m_pipe[1], text.data() + begin, text.size() - begin);
      if(n < 0 && errno != EINTR)
        return;
      begin += n > 0 ? std::size_t(n) : 0;
    }
  }

  std::string read_all() const
  {
    std::string result;
    char buffer[4096];
    for(;;) {
      const ssize_t n = ::read(m_pipe[0], buffer, sizeof(buffer));
      if(n > 0)
        result.append(buffer, std::size_t(n));
      else if(n == 0 || errno != EINTR)
        break;
    }
    ::close(m_pipe[0]);
    return result;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // defined(__unix__) || defined(__APPLE__)

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_CHILD_PROCESS_H
