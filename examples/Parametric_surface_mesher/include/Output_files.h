// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef OUTPUT_FILES_H
#define OUTPUT_FILES_H

#include "Unfinished_files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

// Files that are written all or none. Each goes to a temporary name first; only when all of them are complete do they get
// their own names. A pipe, or a device, is written to directly.
class Output_files
{
public:
  typedef std::function<void(std::ostream&)> Writer;

private:
  struct File
  {
    std::string name;
    Writer write;
    bool is_special; // a pipe or a device

    std::string written_name() const { return is_special ? name : name + ".part"; }
  };

  std::vector<File> m_files;

public:
  // Throws std::runtime_error if the file could not be written later. Writes nothing yet.
  void add(const std::string& name, Writer write)
  {
    for(const File& file : m_files)
      if(file.name == name)
        throw std::runtime_error(name + " is given for two outputs; give each of them a name of its own");
    const File file{name, std::move(write), is_special(name)};
    if(!file.is_special)
      check_that_it_can_be_written(file);
    m_files.push_back(file);
  }

  void write() const
  {
    std::vector<std::string> temporary_names;
    for(const File& file : m_files)
      if(!file.is_special)
        temporary_names.push_back(file.written_name());
    const Unfinished_files unfinished(temporary_names);
    try {
      for(const File& file : m_files)
        write(file);
      for(const File& file : m_files)
        if(!file.is_special && std::rename(file.written_name().c_str(), file.name.c_str()) != 0)
          refuse(file.name);
    }
    catch(...) {
      for(const std::string& name : temporary_names)
        std::remove(name.c_str());
      throw;
    }
  }

private:
  static bool is_special(const std::string& name)
  {
    std::error_code error;
    const auto status = std::filesystem::status(name, error);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) && !std::filesystem::is_directory(status);
  }

  static void check_that_it_can_be_written(const File& file)
  {
    if(std::ifstream(file.name, std::ios::in) && !std::ofstream(file.name, std::ios::in | std::ios::out))
      refuse(file.name);
    if(!std::ofstream(file.written_name(), std::ios::binary))
      refuse(file.name);
    std::remove(file.written_name().c_str());
  }

  static void write(const File& file)
  {
    std::ofstream out(file.written_name(), std::ios::binary);
    out.precision(17);
    file.write(out);
    out.close();
    if(!out)
      refuse(file.name);
  }

  [[noreturn]] static void refuse(const std::string& name)
  {
    const int error = errno;
    throw std::runtime_error("cannot write " + name + (error != 0 ? std::string(": ") + std::strerror(error) : ""));
  }
};

#endif // OUTPUT_FILES_H
