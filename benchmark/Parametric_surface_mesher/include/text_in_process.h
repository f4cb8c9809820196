// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What programs that go through a folder of CAD models share.
#ifndef TEXT_IN_PROCESS_H
#define TEXT_IN_PROCESS_H

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

// What `make_text` returns, from a process that may use so many seconds of processor time; or why there is none.
template <class MakeText>
std::string text_in_process(unsigned int seconds, const MakeText& make_text)
{
  int ends[2];
  if(pipe(ends) != 0)
    return "no pipe";
  const pid_t child = fork();
  if(child == 0) {
    const rlimit limit = {seconds, seconds};
    setrlimit(RLIMIT_CPU, &limit);
    std::string result;
    try {
      result = make_text();
    }
    catch(const std::exception& error) {
      result = std::string("-\t-\tERROR ") + error.what();
    }
    const bool is_written = write(ends[1], result.data(), result.size()) == ssize_t(result.size());
    _exit(is_written ? 0 : 1);
  }
  close(ends[1]);
  std::string result;
  char buffer[4096];
  for(ssize_t n; (n = read(ends[0], buffer, sizeof(buffer))) > 0;)
    result.append(buffer, std::size_t(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return !WIFSIGNALED(status) ? result : WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL ? "-\t-\tTIMEOUT" : "-\t-\tCRASH";
}

// The CAD files in a folder, by name.
inline std::vector<std::string> cad_files_in(const std::string& folder)
{
  std::vector<std::string> result;
  for(const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::string ending = entry.path().extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    for(const char* known : {".step", ".stp", ".iges", ".igs", ".brep", ".rle"})
      if(ending == known)
        result.push_back(entry.path().string());
  }
  std::sort(result.begin(), result.end());
  return result;
}

// printf for one number
inline std::string text_of_number(const char* format, double value)
{
  char buffer[64];
  std::snprintf(buffer, sizeof(buffer), format, value);
  return buffer;
}

#endif // TEXT_IN_PROCESS_H
