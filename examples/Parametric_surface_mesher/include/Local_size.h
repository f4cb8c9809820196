// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Edge lengths in a part of space or near something, as the user writes them.
#ifndef LOCAL_SIZE_H
#define LOCAL_SIZE_H

#include "Usage_error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace mesh_cad {

struct Local_size
{
  enum Kind { BOX, SPHERE, CYLINDER, POINT, FACE, EDGE, VERTEX, PART };

  std::string option, text; // as given
  Kind kind = POINT;
  std::vector<double> lengths; // coordinates and a radius
  std::string name;            // of a face, edge, vertex or part
  double length = 0, growth = 0.2;
};

const char* const grammar_of_local_sizes
  = "box:X,Y,Z,X,Y,Z:L, sphere:X,Y,Z,R:L, cylinder:X,Y,Z,X,Y,Z,R:L, point:X,Y,Z:L, face:F:L, edge:E:L, vertex:V:L or part:P:L, "
    "or one of these with :G";

inline std::vector<std::string> words_between(const std::string& text, char separator)
{
  std::vector<std::string> result;
  std::istringstream in(text + separator);
  for(std::string word; std::getline(in, word, separator);)
    result.push_back(word);
  return result;
}

// Whether the whole word is a finite number.
inline bool is_finite_number(const std::string& word, double& value)
{
  std::istringstream in(word);
  return word.find_first_of(" \t") == std::string::npos && in >> value && in.peek() == std::istringstream::traits_type::eof()
         && std::isfinite(value);
}

// Reads `text`; false if it is not as the grammar says. A name may contain colons: it ends before the last number, or the last two.
inline bool read_local_size(Local_size& result)
{
  struct Form
  {
    const char* word;
    Local_size::Kind kind;
    std::size_t number_of_lengths;
    bool has_radius;
  };
  static const Form forms[]
    = {{"box", Local_size::BOX, 6, false},       {"sphere", Local_size::SPHERE, 4, true}, {"cylinder", Local_size::CYLINDER, 7, true},
       {"point", Local_size::POINT, 3, false},   {"face", Local_size::FACE, 0, false},    {"edge", Local_size::EDGE, 0, false},
       {"vertex", Local_size::VERTEX, 0, false}, {"part", Local_size::PART, 0, false}};
  const std::vector<std::string> words = words_between(result.text, ':');
  const auto form = std::find_if(std::begin(forms), std::end(forms), [&](const Form& f) { return f.word == words.front(); });
  if(form == std::end(forms) || words.size() < 3 || !is_finite_number(words.back(), result.length))
    return false;
  result.kind = form->kind;
  std::size_t end = words.size() - 1; // of what is not a length or growth
  double before = 0;
  if(end > 2 && is_finite_number(words[end - 1], before)) {
    result.growth = result.length;
    result.length = before;
    --end;
  }
  const double max_growth = 10; // as of --growth
  if(!(result.length > 0) || !(result.growth >= 0 && result.growth <= max_growth))
    return false;
  const std::size_t begin = words.front().size() + 1;
  std::size_t size = 0;
  for(std::size_t i = 1; i < end; ++i)
    size += words[i].size() + (i > 1 ? 1 : 0);
  result.name = result.text.substr(begin, size);
  if(form->number_of_lengths == 0)
    return !result.name.empty();
  for(const std::string& word : words_between(result.name, ',')) {
    result.lengths.push_back(0);
    if(!is_finite_number(word, result.lengths.back()))
      return false;
  }
  return result.lengths.size() == form->number_of_lengths && !(form->has_radius && result.lengths.back() < 0);
}

inline Local_size local_size_in(const std::string& option, const std::string& text)
{
  Local_size result;
  result.option = option;
  result.text = text;
  if(!read_local_size(result))
    throw Usage_error("--" + option + ": '" + text + "' must be " + grammar_of_local_sizes
                      + ", with a positive length L and a growth G from 0 to 10");
  const auto& x = result.lengths;
  if(result.kind == Local_size::CYLINDER && x[0] == x[3] && x[1] == x[4] && x[2] == x[5])
    throw Usage_error("--" + option + ": both ends of the axis of '" + text + "' are the same point");
  return result;
}

// The older form "X,Y,Z,R:L" of a sphere.
inline Local_size sphere_size_in(const std::string& option, const std::string& text)
{
  Local_size result;
  result.option = option;
  result.text = "sphere:" + text;
  if(words_between(text, ':').size() != 2 || !read_local_size(result))
    throw Usage_error("--" + option + ": '" + text + "' must be X,Y,Z,R:L, with a radius R of at least 0 and a positive length L");
  return result;
}

inline void scale(double factor, Local_size& size)
{
  for(double& length : size.lengths)
    length *= factor;
  size.length *= factor;
}

} // namespace mesh_cad

#endif // LOCAL_SIZE_H
