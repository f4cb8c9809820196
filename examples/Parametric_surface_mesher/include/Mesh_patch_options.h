// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line of mesh_patch.
#ifndef MESH_PATCH_OPTIONS_H
#define MESH_PATCH_OPTIONS_H

#include "Sample_models.h"
#include "Usage_error.h"
#include "write_page.h"

#include <CGAL/Parametric_surface_mesh_criteria.h>

#include <boost/optional.hpp>
#include <boost/program_options.hpp>

#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

struct Mesh_patch_options
{
  std::string surface, metric = "first-fundamental-form", placement = "frontal";
  std::string out, uv, picture, uv_picture, page, json, division;
  double max_edge = 0, min_edge = 0, distance = 0; // 0 if not given
  double gamma = CGAL::Parametric_surface_mesh_criteria().gamma();
  double angle = CGAL::Parametric_surface_mesh_criteria().angle();
  double size_factor = CGAL::Parametric_surface_mesh_criteria().size_factor();
  double improvement_angle = CGAL::Parametric_surface_mesh_criteria().improvement_angle();
  boost::optional<unsigned int> sweeps;
  std::vector<unsigned int> numbers_of_edges; // from `division`
  unsigned int order = 1;
  unsigned int ellipses = 0;
  bool is_quiet = false, is_help_wanted = false, is_version_wanted = false;
};

namespace mesh_patch {

inline std::string introduction()
{
  return "Usage: mesh_patch SURFACE [OPTION]...\n"
         "\n"
         "Meshes a parametric surface and prints a summary.\n"
         "\n"
         "SURFACE is the name of a sample that is a single patch,\n"
         "    " + joined(sample_patch_names()) + ",\n"
         "of one that is a model, closed by seams and poles or made of several faces,\n"
         "    " + joined(sample_model_names()) + ",\n"
         "or a file of Bezier patches that ends in .bpt. Equal boundary curves of patches are\n"
         "joined, so that neighbours fit without a crack.\n";
}

const char* const conclusion =
  "\n"
  "Lengths are in the unit of the surface. The boundary is divided first and then never\n"
  "changed; so some triangles beside it may fail a criterion.\n"
  "Faces, edges and loops are counted from 1; a .ply file holds the face of each triangle.\n"
  "\n"
  "The file of --json contains, among others:\n"
  "  vertices, triangles\n"
  "  min_angle, mean_min_angle     of the triangles, in degrees in space\n"
  "  mean_radius_ratio             mean of 2r/R, which is 1 for equilateral triangles\n"
  "  max_deviation                 largest H/L of the inner edges of all patches that are\n"
  "                                not shorter than 2 times --min-edge, measured after meshing\n"
  "  max_normal_deviation          the same with the part of H along the surface normal; around\n"
  "                                poles only this one is held to --gamma\n"
  "  boundary_limited              triangles that fail a criterion at the boundary\n"
  "  unmet                         triangles that fail a criterion for another reason\n"
  "  unmet_by                      all of these triangles by criterion and cause\n"
  "  closed, boundary_cycles       whether the mesh has no border, and how many borders it has\n"
  "  euler_characteristic          of the mesh: vertices - edges + triangles\n"
  "  faces, model_vertices, model_edges     of the model; a single patch is one face\n"
  "  model_border_edges, model_seams, model_nonmanifold_edges     edges of the model that are\n"
  "                                used once, twice by one face, three times or more\n"
  "  model_poles                   collapsed edges, which none of the other numbers counts\n"
  "  seconds                       time of each phase; `meshing` is their sum,\n"
  "                                without reading, measuring and writing\n"
  "\n"
  "In --uv and --uv-picture the patches of a model lie side by side, uv_columns (of --json) in a\n"
  "row: the one in column i of row j, counted from 0, is moved by (i, -j) times uv_shift.\n"
  "\n"
  "In the summary, the mean of the angles is that of the smallest angle of each triangle; 60 would be\n"
  "perfect. Lines with WRONG tell what is wrong with the mesh, and decide the exit status; notes do not.\n"
  "\n"
  "Exit status: 0 if nothing is wrong with the mesh, even if not all triangles meet the criteria; 1 if\n"
  "something is: triangles are turned to the wrong side or outside of the domain, curved triangles have\n"
  "no area or are folded, or the mesh is more than 1.5 times as far from the surface as --distance\n"
  "allows; 2 after an error, which is one line on the standard error output, and no file is written.\n";

inline po::options_description described_options(Mesh_patch_options& o)
{
  const auto number = [](double& target) { return po::value<double>(&target)->value_name("X"); };
  const auto file = [](std::string& target) { return po::value<std::string>(&target)->value_name("FILE"); };
  const auto with_default = [](const std::string& text, double value) {
    std::ostringstream result;
    result << text << " (" << value << ")";
    return result.str();
  };
  po::options_description criteria("Criteria (default)", 92);
  criteria.add_options()
    ("max-edge", number(o.max_edge),
     "wanted edge length where nothing else requires shorter edges (1/20 of the diagonal of the boundary's bounding box)")
    ("min-edge", number(o.min_edge),
     "edges are not divided into pieces shorter than this (1/200 of --max-edge)")
    ("gamma", number(o.gamma),
     with_default("largest deviation ratio H/L of an edge: arc height over length", o.gamma).c_str())
    ("angle", number(o.angle),
     with_default("smallest angle in degrees, at least 0 and below 60", o.angle).c_str())
    ("size-factor", number(o.size_factor),
     with_default("factor C of the size criterion R <= C (S1 + S2 + S3)", o.size_factor).c_str())
    ("distance", number(o.distance), "largest distance from the surface to a triangle (none)")
    ("metric", po::value<std::string>(&o.metric)->value_name("NAME"),
     "first-fundamental-form: triangles well shaped in space; or principal-curvature: stretched along the direction of "
     "least curvature (first-fundamental-form)")
    ("placement", po::value<std::string>(&o.placement)->value_name("NAME"),
     "where new points are put: frontal, off-center or circumcenter (frontal)")
    ("improvement-angle", number(o.improvement_angle),
     with_default("angle in degrees below which triangles are improved one by one", o.improvement_angle).c_str())
    ("division", po::value<std::string>(&o.division)->value_name("N1,N2,..."),
     "numbers of edges of the boundary curves, loop by loop, or of the edges of a model that are no poles, in the order "
     "of their first use, face by face; 0: as the criteria require");
  add_sweeps(criteria, o.sweeps);
  po::options_description output("Output", 92);
  add_order(output, o.order);
  add_page_and_picture(output, o.page, o.picture);
  output.add_options()
    ("out,o", file(o.out), "the mesh, as .off, .obj, .ply or .stl; with --order 2 as .vtu, .msh, .inp or .bdf")
    ("uv", file(o.uv), "the same triangles in the domain, as points (u,v,0); endings as for --out")
    ("uv-picture", file(o.uv_picture), "a picture of the triangles in the domain, as .svg")
    ("ellipses", whole_number("ellipses", 0, 1000000, o.ellipses), "the number of circumellipses in --uv-picture (0)")
    ("json", file(o.json), "the results in numbers, as .json")
    ("quiet", po::bool_switch(&o.is_quiet), "print nothing but errors")
    ("version", po::bool_switch(&o.is_version_wanted), "print the versions of this program and of its libraries, and stop")
    ("help,h", po::bool_switch(&o.is_help_wanted), "print this and stop");
  criteria.add(output);
  return criteria;
}

inline void print_help(std::ostream& out)
{
  Mesh_patch_options defaults;
  out << introduction() << "\n" << described_options(defaults) << conclusion;
}

// the numbers of edges in a list like "400,10,0,10"
inline std::vector<unsigned int> numbers_in(const std::string& list)
{
  const unsigned int most = 1000000;
  std::vector<unsigned int> result;
  std::istringstream items(list + ",");
  for(std::string item; std::getline(items, item, ',');) {
    const bool is_number = !item.empty() && item.size() < 8 && item.find_first_not_of("0123456789") == std::string::npos;
    if(!is_number || std::stoul(item) > most)
      throw Usage_error("--division: '" + item + "' must be a whole number from 0 to " + std::to_string(most));
    result.push_back(static_cast<unsigned int>(std::stoul(item)));
  }
  return result;
}

inline void check_values(const po::variables_map& given, const Mesh_patch_options& o)
{
  for(const char* option : {"max-edge", "min-edge", "gamma", "size-factor", "distance"})
    check_positive(given, option);
  check_angle("angle", o.angle);
  check_angle("improvement-angle", o.improvement_angle);
  check_page(o.page);
  check_picture(o.picture);
  if(o.placement != "frontal" && o.placement != "off-center" && o.placement != "circumcenter")
    throw Usage_error("--placement: '" + o.placement + "' must be frontal, off-center or circumcenter");
  check_edge_lengths(o.min_edge, o.max_edge);
  if(o.metric != "first-fundamental-form" && o.metric != "principal-curvature")
    throw Usage_error("--metric: '" + o.metric + "' must be first-fundamental-form or principal-curvature");
  if(o.ellipses > 0 && o.uv_picture.empty())
    throw Usage_error("--ellipses needs --uv-picture, the picture that they are drawn in");
}

} // namespace mesh_patch

// Reads the command line; throws Usage_error.
inline Mesh_patch_options read_mesh_patch_options(int argc, char** argv)
{
  using namespace mesh_patch;
  Mesh_patch_options o;
  po::options_description options = described_options(o);
  options.add_options()("surface", po::value<std::string>(&o.surface));
  po::positional_options_description positional;
  positional.add("surface", 1);
  po::variables_map given;
  try {
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(argc, argv).options(options).positional(positional).style(style).run(), given);
    po::notify(given);
  }
  catch(const po::too_many_positional_options_error&) {
    throw Usage_error("more than one surface is given; --help lists the options");
  }
  catch(const po::error& error) {
    throw Usage_error(std::string(error.what()) + "; --help lists the options");
  }
  if(o.is_help_wanted || o.is_version_wanted)
    return o;
  if(o.surface.empty())
    throw Usage_error("no surface is given; --help lists the available ones");
  check_values(given, o);
  if(given.count("division") != 0)
    o.numbers_of_edges = numbers_in(o.division);
  return o;
}

#endif // MESH_PATCH_OPTIONS_H
