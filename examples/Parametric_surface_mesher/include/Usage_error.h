// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the command lines of mesh_patch and mesh_cad have in common.
#ifndef USAGE_ERROR_H
#define USAGE_ERROR_H

#include "text_of_numbers.h"

#include <boost/algorithm/string/predicate.hpp>
#include <boost/optional.hpp>
#include <boost/program_options.hpp>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// A command line that cannot be followed; the message says what to change.
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

namespace mesh_patch {

namespace po = boost::program_options;

inline std::string joined(const std::vector<std::string>& words)
{
  std::string result;
  for(const std::string& word : words)
    result += (result.empty() ? "" : " ") + word;
  return result;
}

inline std::string plural(std::size_t n, const std::string& what, const std::string& several = std::string())
{
  return std::to_string(n) + " " + (n == 1 ? what : several.empty() ? what + "s" : several);
}

// in capital or small letters
inline bool has_ending(const std::string& name, const std::string& ending)
{
  return name.size() > ending.size() && boost::algorithm::iends_with(name, ending);
}

inline void check_ending(const std::string& option, const std::string& file_name, const std::vector<std::string>& endings)
{
  std::string list;
  for(const std::string& ending : endings) {
    if(has_ending(file_name, ending))
      return;
    list += (list.empty() ? "" : &ending == &endings.back() ? " or " : ", ") + ending;
  }
  throw Usage_error("--" + option + ": the file name " + file_name + " must end in " + list);
}

// Refuses the value of an option. `range`: words for the values that it may have
template <class Value>
[[noreturn]] void refuse(const std::string& option, const Value& value, const std::string& range)
{
  std::ostringstream message;
  message << "--" << option << ": " << value << " must be " << range;
  throw Usage_error(message.str());
}

inline void check_positive(const po::variables_map& given, const std::string& option)
{
  if(given.count(option) == 0)
    return;
  const double value = given[option].as<double>();
  if(!(value > 0) || !std::isfinite(value))
    refuse(option, value, "a finite number greater than 0");
}

inline void check_at_least_0(const std::string& option, double value)
{
  if(!(value >= 0) || !std::isfinite(value))
    refuse(option, value, "a finite number of at least 0");
}

inline void check_angle(const std::string& option, double value)
{
  if(!(value >= 0 && value < 60))
    refuse(option, value, "an angle in degrees that is at least 0 and below 60");
}

inline void check_edge_lengths(double min_edge, double max_edge)
{
  if(max_edge > 0 && min_edge > max_edge)
    refuse("min-edge", min_edge, "at most the length of --max-edge, " + text_of(max_edge));
}

// The value of an option that is a whole number in a range; others are refused. It is read as a large number so that the message shows it
// as it was given.
template <class Number>
po::typed_value<long long>* whole_number(const std::string& option, long long least, long long most, Number& target)
{
  return po::value<long long>()->value_name("N")->notifier([option, least, most, &target](long long value) {
    if(value < least || value > most)
      refuse(option, value, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    target = static_cast<unsigned int>(value);
  });
}

inline void add_sweeps(po::options_description& options, boost::optional<unsigned int>& number)
{
  options.add_options()
    ("sweeps", whole_number("sweeps", 0, 1000, number),
     "largest number of sweeps that improve the triangles: two smooth, further ones polish (2, and 5 for patches of 2000 "
     "vertices or more where the second still moves a fifth of them)");
}

inline void add_order(po::options_description& options, unsigned int& order)
{
  options.add_options()
    ("order", whole_number("order", 1, 2, order),
     "order of the elements: 1, or 2 for six-node triangles with nodes on the curves and surfaces, proved not to be folded (1)");
}

} // namespace mesh_patch

#endif // USAGE_ERROR_H
