// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PRINT_VERSION_H
#define PRINT_VERSION_H

#include <CGAL/version.h>

#include <boost/version.hpp>

#include <ostream>
#include <string>
#include <vector>

// The versions of a program, which is that of the package, and of the libraries that decide its results. `others`: names and versions of
// further libraries
inline void print_version(std::ostream& out, const std::string& program, const std::vector<std::string>& others = {})
{
  out << program << " " << PARAMETRIC_SURFACE_MESHER_VERSION << " (CGAL " << CGAL_VERSION_STR << ", Boost " << BOOST_VERSION / 100000 << "."
      << BOOST_VERSION / 100 % 1000 << "." << BOOST_VERSION % 100;
  for(const std::string& other : others)
    out << ", " << other;
  out << ")\n";
}

#endif // PRINT_VERSION_H
