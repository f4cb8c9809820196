// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PAGE_PAGE_TEXT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PAGE_PAGE_TEXT_H

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// The number of bytes of the character of UTF-8 that begins at `i`, or 0 if none does.
inline std::size_t length_of_character(const std::string& text, std::size_t i)
{
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
  const unsigned int first = byte(i);
  const std::size_t length = first < 0x80                     ? 1
                             : first >= 0xc2 && first < 0xe0 ? 2
                             : first >= 0xe0 && first < 0xf0 ? 3
                             : first >= 0xf0 && first < 0xf5 ? 4
                                                              : 0;
  for(std::size_t k = 1; k < length; ++k)
    if((byte(i + k) & 0xc0u) != 0x80u)
      return 0;
  return length;
}

// A string of JSON that may stand inside a script of a page: names in CAD files may contain anything. Bytes that are not UTF-8 become
// question marks.
inline std::string json_text(const std::string& text)
{
  std::string result = "\"";
  for(std::size_t i = 0; i < text.size();) {
    const std::size_t length = length_of_character(text, i);
    const char c = text[i];
    if(length == 0)
      result += '?';
    else if(length > 1)
      result.append(text, i, length);
    else if(static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\\' || c == '<' || c == '>' || c == '&') {
      char escaped[7];
      std::snprintf(escaped, sizeof(escaped), "\\u%04x", unsigned(static_cast<unsigned char>(c)));
      result += escaped;
    }
    else
      result += c;
    i += (std::max)(length, std::size_t(1));
  }
  return result + '"';
}

// A number of JSON; numbers that are not finite become null, since JSON has none.
inline std::string json_number(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.12g", value);
  return std::isfinite(value) ? text : "null";
}

// Bytes that are collected, and written into a page as text in base64.
class Page_bytes
{
  std::string m_bytes;
  std::int64_t m_last = 0;

public:
  void reserve(std::size_t number) { m_bytes.reserve(number); }

  // The lower bytes of a number, the lowest first.
  void add(std::uint32_t number, int number_of_bytes)
  {
    for(int i = 0; i < number_of_bytes; ++i)
      m_bytes += static_cast<char>(number >> 8 * i & 0xffu);
  }

  // A share of a range, from 0 to 1, in whole steps.
  void add_share(double share, int number_of_bytes)
  {
    const double steps = std::ldexp(1., 8 * number_of_bytes) - 1;
    add(static_cast<std::uint32_t>((std::min)((std::max)(share, 0.), 1.) * steps + 0.5), number_of_bytes);
  }

  // The difference to the number before, which is small for most: seven bits a byte, the sign in the lowest one.
  void add_difference(std::size_t number)
  {
    const std::int64_t difference = static_cast<std::int64_t>(number) - m_last;
    m_last = static_cast<std::int64_t>(number);
    std::uint64_t rest
      = difference < 0 ? 2 * static_cast<std::uint64_t>(-(difference + 1)) + 1 : 2 * static_cast<std::uint64_t>(difference);
    for(; rest >= 0x80u; rest >>= 7)
      m_bytes += static_cast<char>(0x80u | (rest & 0x7fu));
    m_bytes += static_cast<char>(rest);
  }

  void write(std::ostream& out) const
  {
    using namespace boost::archive::iterators;
    typedef base64_from_binary<transform_width<std::string::const_iterator, 6, 8>> To_text;
    const std::string text(To_text(m_bytes.begin()), To_text(m_bytes.end()));
    out << '"' << text << std::string((3 - m_bytes.size() % 3) % 3, '=') << '"';
  }
};

// Values in 16 bits each, in equal steps or in equal steps of their logarithms. The value 0 and values that are not finite have codes
// of their own.
class Rounded_values
{
  static constexpr std::uint32_t zero = 0, unknown = 1, first = 2, last = 0xffff;
  double m_low = (std::numeric_limits<double>::infinity)(), m_high = -m_low;
  bool m_is_logarithmic;

public:
  Rounded_values(const std::vector<double>& values, bool is_logarithmic) : m_is_logarithmic(is_logarithmic)
  {
    for(const double value : values)
      if(std::isfinite(value) && value != 0) {
        m_low = (std::min)(m_low, scaled(value));
        m_high = (std::max)(m_high, scaled(value));
      }
    if(!(m_low <= m_high))
      m_low = m_high = 0;
  }

  std::uint32_t operator()(double value) const
  {
    if(!std::isfinite(value))
      return unknown;
    if(value == 0)
      return zero;
    const double share = m_high > m_low ? (scaled(value) - m_low) / (m_high - m_low) : 0;
    return first + static_cast<std::uint32_t>((std::min)((std::max)(share, 0.), 1.) * (last - first) + 0.5);
  }

  void write_range(std::ostream& out) const
  {
    out << "\"low\":" << json_number(m_low) << ",\"high\":" << json_number(m_high)
        << ",\"logarithmic\":" << (m_is_logarithmic ? "true" : "false");
  }

private:
  double scaled(double value) const { return m_is_logarithmic ? std::log(std::fabs(value)) : value; }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PAGE_PAGE_TEXT_H
