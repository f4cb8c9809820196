// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef OUTPUT_FILES_H
#define OUTPUT_FILES_H

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Files that are written all or none. Each goes to a temporary name first; only when all of them are complete do they get
// their own names.
class Output_files
{
public:
  typedef std::function<void(std::ostream&)> Writer;

private:
  struct File
  {
    std::string name;
    Writer write;
    std::string temporary_name() const { return name + ".part"; }
  };

  std::vector<File> m_files;

public:
  // Throws std::runtime_error if the file could not be written later. Writes nothing yet.
  void add(const std::string& name, Writer write)
  {
    for(const File& file : m_files)
      if(file.name == name)
        throw std::runtime_error(name + " is given for two outputs; give each of them a name of its own");
    const File file{name, std::move(write)};
    if(std::ifstream(name, std::ios::in) && !std::ofstream(name, std::ios::in | std::ios::out))
      refuse(name);
    if(!std::ofstream(file.temporary_name(), std::ios::binary))
      refuse(name);
    std::remove(file.temporary_name().c_str());
    m_files.push_back(file);
  }

  void write() const
  {
    try {
      for(const File& file : m_files)
        write(file);
      for(const File& file : m_files)
        if(std::rename(file.temporary_name().c_str(), file.name.c_str()) != 0)
          refuse(file.name);
    }
    catch(...) {
      for(const File& file : m_files)
        std::remove(file.temporary_name().c_str());
      throw;
    }
  }

private:
  static void write(const File& file)
  {
    std::ofstream out(file.temporary_name(), std::ios::binary);
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
