// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_VTK_DATA_ARRAY_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_VTK_DATA_ARRAY_H

#include <CGAL/Parametric_surface_mesher/internal/files/Node_values_builder.h>

#ifdef CGAL_LINKED_WITH_BOOST_IOSTREAMS
#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#endif

#include <boost/predef/other/endian.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The bytes of a text, as they are or written in base64. A padding in the middle ends a piece, and the next one begins.
class Byte_source
{
  const std::string& m_text;
  std::size_t m_position;
  bool m_is_base64;
  std::string m_decoded; // and not taken yet

public:
  Byte_source(const std::string& text, std::size_t position, bool is_base64) : m_text(text), m_position(position), m_is_base64(is_base64) {}

  // Returns less at the end of the text.
  std::string take(std::size_t number)
  {
    while(m_is_base64 && m_decoded.size() < number && decode_four())
      ;
    std::string result;
    if(m_is_base64) {
      result = m_decoded.substr(0, number);
      m_decoded.erase(0, result.size());
    }
    else if(m_position < m_text.size()) {
      result = m_text.substr(m_position, number);
      m_position += result.size();
    }
    return result;
  }

private:
  static int value_of(char c)
  {
    return c >= 'A' && c <= 'Z'   ? c - 'A'
           : c >= 'a' && c <= 'z' ? c - 'a' + 26
           : c >= '0' && c <= '9' ? c - '0' + 52
           : c == '+'             ? 62
           : c == '/'             ? 63
                                  : -1;
  }

  // Appends up to three bytes; false at the end.
  bool decode_four()
  {
    std::uint32_t bits = 0;
    int number_of_characters = 0, number_of_paddings = 0;
    for(; m_position < m_text.size() && number_of_characters < 4; ++m_position) {
      const char c = m_text[m_position];
      if(c == ' ' || c == '\n' || c == '\r' || c == '\t')
        continue;
      if(c != '=' && value_of(c) < 0)
        return false;
      number_of_paddings += c == '=' ? 1 : 0;
      bits = (bits << 6) | std::uint32_t(c == '=' ? 0 : value_of(c));
      ++number_of_characters;
    }
    if(number_of_characters < 4)
      return false;
    for(int i = 0; i < 3 - number_of_paddings; ++i)
      m_decoded += char((bits >> (16 - 8 * i)) & 0xff);
    return true;
  }
};

// How the arrays of an XML file of VTK are written.
struct Vtk_encoding
{
  std::string file_name;
  bool is_big_endian = false, has_long_header = false;
  std::string compressor;
};

// Decodes the binary arrays of an XML file of VTK.
class Vtk_data_array
{
  const Vtk_encoding& m_encoding;
  std::string m_type;

public:
  Vtk_data_array(const Vtk_encoding& encoding, const std::string& type) : m_encoding(encoding), m_type(type)
  {
    if(size_of_type() == 0)
      throw_file_error(encoding.file_name, "there are arrays of the type " + type + ", which is not read");
  }

  // Whole numbers up to 2^53 stay what they are.
  std::vector<double> numbers(Byte_source source) const
  {
    std::string bytes = m_encoding.compressor.empty() ? uncompressed(source) : decompressed(source);
    const std::size_t size = size_of_type();
    std::vector<double> result;
    for(std::size_t begin = 0; begin + size <= bytes.size(); begin += size)
      result.push_back(number(&bytes[begin]));
    return result;
  }

  std::vector<double> numbers_in_text(const std::string& text) const
  {
    std::istringstream in(text);
    std::vector<double> result;
    for(double value; in >> value;)
      result.push_back(value);
    if(!in.eof())
      throw_file_error(m_encoding.file_name, "there is something that is not a number in an array");
    return result;
  }

private:
  std::size_t size_of_type() const
  {
    for(const char* type : {"Float64", "Int64", "UInt64"})
      if(m_type == type)
        return 8;
    for(const char* type : {"Float32", "Int32", "UInt32"})
      if(m_type == type)
        return 4;
    return m_type == "Int16" || m_type == "UInt16" ? 2 : m_type == "Int8" || m_type == "UInt8" ? 1 : 0;
  }

  // Turns the bytes round if those of this machine have another order.
  template <class T>
  T value_at(char* bytes) const
  {
    if(m_encoding.is_big_endian != bool(BOOST_ENDIAN_BIG_BYTE))
      std::reverse(bytes, bytes + sizeof(T));
    T result;
    std::memcpy(&result, bytes, sizeof(T));
    return result;
  }

  double number(char* bytes) const
  {
    return m_type == "Float64"  ? value_at<double>(bytes)
           : m_type == "Float32" ? double(value_at<float>(bytes))
           : m_type == "Int64"   ? double(value_at<std::int64_t>(bytes))
           : m_type == "UInt64"  ? double(value_at<std::uint64_t>(bytes))
           : m_type == "Int32"   ? double(value_at<std::int32_t>(bytes))
           : m_type == "UInt32"  ? double(value_at<std::uint32_t>(bytes))
           : m_type == "Int16"   ? double(value_at<std::int16_t>(bytes))
           : m_type == "UInt16"  ? double(value_at<std::uint16_t>(bytes))
           : m_type == "Int8"    ? double(value_at<std::int8_t>(bytes))
                                 : double(value_at<std::uint8_t>(bytes));
  }

  std::string take(Byte_source& source, std::size_t number) const
  {
    std::string result = source.take(number);
    if(result.size() < number)
      throw_file_error(m_encoding.file_name, "the binary data end too early");
    return result;
  }

  std::size_t take_size(Byte_source& source) const
  {
    std::string bytes = take(source, m_encoding.has_long_header ? 8 : 4);
    return m_encoding.has_long_header ? std::size_t(value_at<std::uint64_t>(&bytes[0])) : std::size_t(value_at<std::uint32_t>(&bytes[0]));
  }

  std::string uncompressed(Byte_source& source) const
  {
    const std::size_t size = take_size(source);
    return take(source, size);
  }

#ifdef CGAL_LINKED_WITH_BOOST_IOSTREAMS
  // The numbers of blocks, of bytes in a block and in the last one, and of bytes of each compressed block; then the blocks.
  std::string decompressed(Byte_source& source) const
  {
    if(m_encoding.compressor != "vtkZLibDataCompressor")
      throw_file_error(m_encoding.file_name, "it is compressed by " + m_encoding.compressor + "; vtkZLibDataCompressor is read");
    const std::size_t number_of_blocks = take_size(source);
    take_size(source);
    take_size(source);
    std::vector<std::size_t> sizes;
    for(std::size_t i = 0; i < number_of_blocks; ++i)
      sizes.push_back(take_size(source));
    std::string result;
    for(const std::size_t size : sizes) {
      const std::string block = take(source, size);
      try {
        boost::iostreams::filtering_istream in;
        in.push(boost::iostreams::zlib_decompressor());
        in.push(boost::iostreams::array_source(block.data(), block.size()));
        in.exceptions(std::ios::badbit);
        boost::iostreams::copy(in, boost::iostreams::back_inserter(result));
      }
      catch(const std::exception&) {
        throw_file_error(m_encoding.file_name, "the compressed data are damaged");
      }
    }
    return result;
  }
#else
  std::string decompressed(Byte_source&) const
  {
    throw_file_error(m_encoding.file_name, "it is compressed, and this program was built without Boost.Iostreams, which decompresses it");
  }
#endif
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_FILES_VTK_DATA_ARRAY_H
