// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_TEXT_ARCHIVE_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_TEXT_ARCHIVE_H

#include <CGAL/Open_cascade_names_3.h>

#include <array>
#include <cstddef>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// What one process hands over to another: numbers, and strings after their lengths. (Boost.Serialization would have to be linked.)

// Calls `archive` for each member of a structure: the same for writing and for reading, which is why it takes no constant.
template <class Archive>
void archive_members(Archive& archive, Open_cascade_names_3::Color& c)
{
  archive(c.red, c.green, c.blue, c.opacity);
}

template <class Archive>
void archive_members(Archive& archive, Open_cascade_names_3::Material& m)
{
  archive(m.name, m.description, m.density);
}

template <class Archive>
void archive_members(Archive& archive, Open_cascade_names_3::Part& p)
{
  archive(p.name, p.instance, p.path, p.parent, p.is_assembly, p.location, p.color, p.material, p.layers, p.solids, p.shells, p.faces);
}

template <class Archive>
void archive_members(Archive& archive, Open_cascade_names_3& n)
{
  archive(n.parts, n.solid_names, n.shell_names, n.face_names, n.edge_names, n.vertex_names, n.face_colors, n.edge_colors,
          n.face_layers, n.unit, n.faults);
}

class Text_writer
{
  std::ostream& m_out;

public:
  explicit Text_writer(std::ostream& out) : m_out(out) { m_out.precision(17); }

  template <class... T>
  void operator()(T&... values)
  {
    (write(values), ...);
  }

private:
  void write(std::string& text) { m_out << text.size() << ' ' << text << '\n'; }

  template <class T>
  void write(std::vector<T>& values)
  {
    m_out << values.size() << '\n';
    for(T& value : values)
      write(value);
  }

  template <class T, std::size_t n>
  void write(std::array<T, n>& values)
  {
    for(T& value : values)
      write(value);
  }

  template <class T>
  void write(std::optional<T>& value)
  {
    m_out << value.has_value() << '\n';
    if(value)
      write(*value);
  }

  template <class T>
  void write(T& value)
  {
    if constexpr(std::is_arithmetic<T>::value)
      m_out << value << '\n';
    else
      archive_members(*this, value);
  }
};

// Its stream fails if the text is not whole.
class Text_reader
{
  std::istream& m_in;

public:
  explicit Text_reader(std::istream& in) : m_in(in) {}

  template <class... T>
  void operator()(T&... values)
  {
    (read(values), ...);
  }

private:
  std::size_t size()
  {
    std::size_t result = 0;
    m_in >> result;
    return m_in ? result : 0;
  }

  void read(std::string& text)
  {
    text.resize(size());
    m_in.get(); // the space after the length
    m_in.read(&text[0], std::streamsize(text.size()));
  }

  template <class T>
  void read(std::vector<T>& values)
  {
    values.resize(size());
    for(T& value : values)
      read(value);
  }

  template <class T, std::size_t n>
  void read(std::array<T, n>& values)
  {
    for(T& value : values)
      read(value);
  }

  template <class T>
  void read(std::optional<T>& value)
  {
    bool is_there = false;
    m_in >> is_there;
    value.reset();
    if(m_in && is_there) {
      T there{}; // clang takes types within a class for not constructible by emplace()
      read(there);
      value = there;
    }
  }

  template <class T>
  void read(T& value)
  {
    if constexpr(std::is_arithmetic<T>::value)
      m_in >> value;
    else
      archive_members(*this, value);
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_OPEN_CASCADE_TEXT_ARCHIVE_H
