// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_page.h"
#include "write_surface_picture.h"
#ifdef MESH_PICTURES_WITH_Z_BUFFER
#include "write_png_picture.h"
#endif

namespace mesh_patch {

void check_picture(const std::string& file_name)
{
#ifndef MESH_PICTURES_WITH_Z_BUFFER
  if(has_ending(file_name, ".png"))
    throw Usage_error("--picture: this program was built without EGL, OpenGL or libpng, which .png files need; install them "
                      "(libegl-dev, libgl-dev and libpng-dev of Debian), configure and build again, or write .svg");
#else
  (void)file_name;
#endif
}

namespace {

// A little paler than in the file, where colours are often the purest ones.
mesh_picture::Color color_in_picture(const CGAL::Mesh_page_3::Color& c)
{
  const auto channel = [](double value) { return 30 + 200 * value; };
  return {channel(c[0]), channel(c[1]), channel(c[2])};
}

Surface_picture_options options_of_picture(const CGAL::Mesh_page_3& page, const std::string& title)
{
  Surface_picture_options result;
  result.title = title;
  result.faces = page.triangle_faces;
  for(const auto& line : page.lines)
    result.lines.push_back(line.points);
  for(const auto& face : page.faces) {
    result.face_colors.emplace_back();
    if(face.color)
      result.face_colors.back() = color_in_picture(*face.color);
    else if(face.part != CGAL::Mesh_page_3::none && page.parts[face.part].color)
      result.face_colors.back() = color_in_picture(*page.parts[face.part].color);
  }
  return result;
}

} // namespace

void write_picture(std::ostream& out, const std::string& file_name, const CGAL::Mesh_page_3& page, const std::string& title)
{
  const Surface_picture_options options = options_of_picture(page, title);
#ifdef MESH_PICTURES_WITH_Z_BUFFER
  if(has_ending(file_name, ".png")) {
    write_png_picture(out, page.points, page.triangles, options);
    return;
  }
#else
  (void)file_name;
#endif
  write_surface_picture(out, page.points, page.triangles, options);
}

} // namespace mesh_patch
