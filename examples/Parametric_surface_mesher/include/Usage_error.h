// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the command lines of mesh_patch and mesh_cad have in common.
#ifndef USAGE_ERROR_H
#define USAGE_ERROR_H

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

inline void check_positive(const po::variables_map& given, const std::string& option)
{
  if(given.count(option) == 0)
    return;
  const double value = given[option].as<double>();
  if(!(value > 0) || !std::isfinite(value)) {
    std::ostringstream message;
    message << "--" << option << ": " << value << " must be a finite number greater than 0";
    throw Usage_error(message.str());
  }
}

// Adds the option --sweeps, and checks it afterwards.
inline void add_sweeps(po::options_description& options, boost::optional<unsigned int>& number)
{
  options.add_options()
    ("sweeps", po::value<boost::optional<unsigned int>>(&number)->value_name("N"),
     "largest number of sweeps that improve the triangles: two smooth, further ones polish (2, and 5 for patches of 2000 "
     "vertices or more where the second still moves a fifth of them)");
}

inline void check_sweeps(const boost::optional<unsigned int>& number)
{
  if(number && *number > 1000) // also what a negative number is read as
    throw Usage_error("--sweeps: the number must be at least 0 and at most 1000");
}

// Adds the option --order, and checks it afterwards.
inline void add_order(po::options_description& options, unsigned int& order)
{
  options.add_options()
    ("order", po::value<unsigned int>(&order)->value_name("N"),
     "order of the elements: 1, or 2 for six-node triangles with nodes on the curves and surfaces, proved not to be folded (1)");
}

inline void check_order(unsigned int order)
{
  if(order != 1 && order != 2)
    throw Usage_error("--order: the order must be 1 or 2");
}

} // namespace mesh_patch

#endif // USAGE_ERROR_H
