// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_page.h"

#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_PAGE
#include <CGAL/IO/write_HTML.h>
#endif

#include <sstream>

namespace mesh_patch {

void check_page(const std::string& file_name)
{
#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_USE_PAGE
  if(!file_name.empty())
    throw Usage_error("--page: this program was built without three.js; install it (libjs-three of Debian and Ubuntu, or "
                      "npm install three@0.147), configure and build again");
#else
  (void)file_name;
#endif
}

void write_page(std::ostream& out, CGAL::Mesh_page_3 page, const std::string& title, const std::string& unit, const std::string& summary)
{
  page.title = title;
  page.unit = unit;
  std::istringstream lines(summary);
  for(std::string line; std::getline(lines, line);)
    page.summary.push_back(line);
#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_PAGE
  CGAL::IO::write_HTML(out, page);
#else
  (void)out; // the option is refused before
#endif
}

} // namespace mesh_patch
