// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The options --page and --picture of mesh_patch and mesh_cad. The functions are in files of the folder library, which are compiled once.
#ifndef WRITE_PAGE_H
#define WRITE_PAGE_H

#include "Usage_error.h"

#include <CGAL/Mesh_page_3.h>

#include <ostream>
#include <string>

namespace mesh_patch {

// Throw Usage_error if this program was built without what the files need.
void check_page(const std::string& file_name);
void check_picture(const std::string& file_name);

// `summary`: lines of text
void write_page(std::ostream& out, CGAL::Mesh_page_3 page, const std::string& title, const std::string& unit, const std::string& summary);

// A picture of what a page shows; the ending of `file_name` tells the format.
void write_picture(std::ostream& out, const std::string& file_name, const CGAL::Mesh_page_3& page, const std::string& title);

inline void add_page_and_picture(po::options_description& options, std::string& page, std::string& picture)
{
  options.add_options()
    ("page", po::value<std::string>(&page)->value_name("FILE"),
     "a page to look at in a browser, as .html: the mesh can be turned and cut, is coloured by face, angle, distance and more, "
     "and shows what was not met")
    ("picture", po::value<std::string>(&picture)->value_name("FILE"),
     "a picture of the mesh, as .png, or for small meshes as .svg, which is painted back to front");
}

} // namespace mesh_patch

#endif // WRITE_PAGE_H
