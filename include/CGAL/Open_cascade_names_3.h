// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_OPEN_CASCADE_NAMES_3_H
#define CGAL_OPEN_CASCADE_NAMES_3_H

#include <CGAL/license/Parametric_surface_mesher.h>

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgParametricSurfaceMesherOpenCascade

What a CAD file says of its shape beside the geometry: the parts of the assembly, and names, colours, layers and materials.
Solids, shells, faces, edges and vertices are counted from 0, in the order of `TopExp::MapShapes()`. Names are in UTF-8.

\sa `CGAL::IO::read_open_cascade_shape()`
*/
struct Open_cascade_names_3
{
  /// the index of what does not exist, for instance of the parent of a part that has none.
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// a colour in sRGB; each value is between 0 and 1.
  struct Color
  {
    double red = 0, green = 0, blue = 0;
    double opacity = 1;
    bool operator==(const Color& c) const { return red == c.red && green == c.green && blue == c.blue && opacity == c.opacity; }
  };

  /// a material, with its density in grams per cubic centimetre, or 0 if the file does not tell it.
  struct Material
  {
    std::string name, description;
    double density = 0;
  };

  /// a node in the tree of the assembly: an assembly, a use of a product in one, or a body of a product with several of them.
  struct Part
  {
    std::string name;     ///< of the product or the body; if the file has none it is made up of the body's number
    std::string instance; ///< the name of this use of the product, or empty
    std::string path;     ///< the names from the root down to this part, with slashes between; no two parts have the same
    std::size_t parent = none;     ///< the index of the part that this one belongs to, or `none`
    bool is_assembly = false;      ///< whether it consists of other parts
    /// the place of the part in the shape: a matrix of rotation and, as its last column, a translation; row by row
    std::array<double, 12> location{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}};
    std::optional<Color> color;       ///< of the part as a whole; faces may have others
    std::optional<Material> material; ///< that of the part or of the next assembly above it that has one
    std::vector<std::string> layers;
    std::vector<std::size_t> solids, shells, faces; ///< what it consists of, with what is in the parts below
  };

  std::vector<Part> parts; ///< each one after its parent, before its younger siblings
  std::vector<std::string> solid_names, shell_names, face_names, edge_names, vertex_names; ///< empty if there is none
  /// of each face: its own colour, or the one of the smallest part around it that has one
  std::vector<std::optional<Color>> face_colors;
  std::vector<std::optional<Color>> edge_colors;       ///< of each edge, its own colour
  std::vector<std::vector<std::string>> face_layers;   ///< of each face, its own layers
  std::string unit;                                    ///< the unit of length of the file, as the file calls it, or empty
  /// what could not be read of names, colours, layers and materials
  std::vector<std::string> faults;

  /// for each face the smallest part that it belongs to, or `none`; the first one if there are several.
  std::vector<std::size_t> parts_of_faces() const { return parts_of(face_names.size(), &Part::faces); }
  /// for each solid the smallest part that it belongs to, or `none`; the first one if there are several.
  std::vector<std::size_t> parts_of_solids() const { return parts_of(solid_names.size(), &Part::solids); }
  /// for each shell the smallest part that it belongs to, or `none`; the first one if there are several.
  std::vector<std::size_t> parts_of_shells() const { return parts_of(shell_names.size(), &Part::shells); }

private:
  std::vector<std::size_t> parts_of(std::size_t number, std::vector<std::size_t> Part::*members) const
  {
    std::vector<std::size_t> result(number, none);
    for(std::size_t p = 0; p < parts.size(); ++p)
      for(const std::size_t member : parts[p].*members)
        if(member < number && (result[member] == none || parts[p].parent == result[member]))
          result[member] = p;
    return result;
  }
};

} // namespace CGAL

#endif // CGAL_OPEN_CASCADE_NAMES_3_H
