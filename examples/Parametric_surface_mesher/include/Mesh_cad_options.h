// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line of mesh_cad.
#ifndef MESH_CAD_OPTIONS_H
#define MESH_CAD_OPTIONS_H

#include "Local_size.h"
#include "Mesh_callbacks.h"
#include "Mesh_cad_fineness.h"
#include "Mesh_cad_imprints.h"
#include "Usage_error.h"
#include "write_page.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/optional.hpp>
#include <boost/program_options.hpp>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

struct Mesh_cad_options
{
  std::string input, out, picture, page, json, unit = "MM";
  std::string face_list, face_sizes, edge_sizes, size_field, self_intersections = "refine";
  std::vector<std::string> sphere_list, local_list, part_lists;
  std::string fineness = "normal";
  double elements_per_turn = 0; // 0 if not given
  double share_of_max_edge = 1. / 20; // of the diagonal, from `fineness`
  double max_edge = 0, min_edge = 0, distance = 0, detail = 0; // 0 if not given
  double relative_distance = 5e-4, gamma = 0.05, angle = 30, closeness = 1.8, growth = 0;
  double layers = 0;            // 0 if not given
  double sewing_tolerance = -1; // 0 for never, below 0 if not given
  std::vector<mesh_cad::Local_size> local_sizes; // from `local_list` and `sphere_list`
  boost::optional<unsigned int> sweeps;
  unsigned int threads = 1, order = 1;
  double fuzzy = 0; // 0 for the tolerances of the file
  std::vector<std::string> point_list;
  std::vector<Point_on_faces> points; // from `point_list`
  std::string curves;                 // a file
  double reach = 0;                   // of points and curves; 0 if not given
  bool is_conformal = false, is_healing_wanted = false, is_detail_kept = false, is_measuring_left_out = false;
  bool is_quiet = false, is_help_wanted = false, is_version_wanted = false, is_list_wanted = false, is_face_list_wanted = false;
  bool are_node_parameters_wanted = false, is_binary = false;
  Mesh_callbacks callbacks; // of programs that use mesh_cad as a library
};

namespace mesh_cad {

namespace po = boost::program_options;

// The file without its folder.
inline std::string title(const Mesh_cad_options& options)
{
  return options.input.substr(options.input.find_last_of('/') + 1);
}

const char* const introduction =
  "Usage: mesh_cad INPUT [OPTION]...\n"
  "\n"
  "Meshes the faces of a CAD file and prints a summary.\n"
  "\n"
  "INPUT is a STEP (.step .stp), IGES (.iges .igs) or BREP file (.brep .rle) with faces.\n";

const char* const conclusion =
  "\n"
  "Faces and edges are counted from 1, as Open CASCADE and Gmsh count them. The files .ply, .vtu,\n"
  ".msh, .inp, .bdf and .unv hold the number of the face of each triangle. Triangles of a solid face\n"
  "outward. The files .msh, .inp, .unv and .med have groups: face_1, edge_1, vertex_1, ...; parts and\n"
  "assemblies by their names; faces, edges and vertices that have names; color_rrggbb; layer_...\n"
  "A face between two parts is once in a file for a solver, with nodes that both parts share, and twice,\n"
  "for either part, in .stl, .ply, .off and .obj. A part is a solid of .stl, a node of .glb (in metres)\n"
  "or an object of .3mf (in millimetres); the latter two have its colours.\n"
  "\n"
  "A face that cannot be meshed is left out and listed with the reason; the others are meshed.\n"
  "A face that is nowhere wider than a millionth of the diagonal is closed up, and listed: it has\n"
  "no triangles, and the faces on both sides of it meet.\n"
  "\n"
  "The file of --json contains, among others:\n"
  "  size                           the lengths of the sides of the box around the mesh\n"
  "  faces, meshed_faces            the number of faces of the shape, and of those in the mesh\n"
  "  left_out, closed_up            faces that could not be meshed; faces that are closed up\n"
  "  collapsed_edges                edges so short that they became a vertex\n"
  "  removed_details                for each face where detail narrower than --detail vanished: its\n"
  "                                 triangles there, how far points moved, and a place\n"
  "  triangles, vertices, min_angle, mean_min_angle, mean_radius_ratio\n"
  "  min_angle_apart_from_corners   the smallest angle, apart from undivided corners of faces with\n"
  "                                 less than 30 degrees\n"
  "  below_10, below_10_at_corners  triangles with an angle below 10 degrees, and those of them\n"
  "                                 that have it in an equally sharp corner of a face\n"
  "  tiny_edges, sliver_faces       edges shorter than 1/1000 of the diagonal; faces with\n"
  "                                 4 pi area / perimeter^2 below 0.01\n"
  "  closed, shape_closed           whether the mesh, and the shape, has no border\n"
  "  self_intersections             pairs of faces of one solid, or faces, of which triangles pass through\n"
  "                                 each other: the number of pairs of triangles, a place,\n"
  "                                 and whether the shape itself meets itself there\n"
  "  folds                          the same for neighbouring triangles that face each other, though the\n"
  "                                 shape is not folded there\n"
  "  distance                       the largest distance measured from surfaces and edges to the mesh;\n"
  "                                 this and the next two are null with --no-measure\n"
  "  distance_over_diagonal         the same as a share of the diagonal of the shape's bounding box\n"
  "  decided_by                     the shares of triangles whose size is decided by the maximum edge,\n"
  "                                 by gamma, by the distance, or by what is around them\n"
  "  second_order                   of six-node triangles: their smallest scaled Jacobian (1: straight,\n"
  "                                 0: folded), those not certified, edges curved less to avoid folds,\n"
  "                                 the largest distance of places of triangles from their surfaces\n"
  "  inner_edges, inner_vertices    edges and vertices inside faces, and why the mesh does not follow\n"
  "                                 them if it does not\n"
  "  imprints                       how far points of --point and curves of --curves were from the faces\n"
  "  repeated_faces                 faces of shells that the file has once more outside of shells\n"
  "  turned_edges                   edges at which the mesh is open since a shell cannot be oriented\n"
  "  layers                         with --layers, the smallest edge length that was wanted for it, and\n"
  "                                 whether the thinnest places would need smaller ones\n"
  "  contacts                       with --conformal, for each two parts that touch, overlap or nearly\n"
  "                                 touch: their names and the area, volume or distance\n"
  "  sewn_edges, lost_faces         pairs of edges joined, and faces lost, by sewing\n"
  "  file_unit                      the unit of length of the file\n"
  "  parts                          the parts of the assembly: number, name, place, solids, faces, ...\n"
  "  face_list                      each face with its kind, area, centre, direction, radius, part, name\n"
  "  face_names, face_colors, ...   names, colours and layers, by the numbers of faces, edges, ...\n"
  "  largest_gap                    the largest distance of an edge from one of its faces\n"
  "  seconds                        processor time: reading, model, meshing, second_order, measuring,\n"
  "                                 and looking for intersections\n"
  "\n"
  "In the summary, the mean of the angles is that of the smallest angle of each triangle; 60 would be\n"
  "perfect. Lines with WRONG tell what is wrong with the mesh, and decide the exit status; notes do not.\n"
  "\n"
  "Exit status:\n"
  "  0  nothing is wrong: all faces are meshed, or closed up\n"
  "  1  the files are written, but something is wrong: a face is left out, could not be read or was\n"
  "     lost by sewing; the mesh is not closed although the shape is; the mesh intersects itself where\n"
  "     the shape does not, or is folded; triangles are turned to the wrong side; curved triangles have\n"
  "     no area or are folded; or the mesh is more than 1.5 times as far from the shape as --distance\n"
  "     allows, if that was measured\n"
  "  2  an error, which is one line on the standard error output; no file is written\n";

inline po::options_description described_options(Mesh_cad_options& o)
{
  const auto number = [](double& target) { return po::value<double>(&target)->value_name("X"); };
  const auto text = [](std::string& target, const char* name) { return po::value<std::string>(&target)->value_name(name); };
  po::options_description criteria("Criteria (default)", 92);
  criteria.add_options()
    ("fineness", text(o.fineness, "NAME"),
     "defaults of the options below: coarse (--gamma 0.08 --relative-distance 0.002 --growth 0.2), normal, or fine (--gamma 0.03 "
     "--relative-distance 0.000125, edges of at most 1/40 of the diagonal) (normal)")
    ("elements-per-turn", number(o.elements_per_turn),
     "edges around a full circle, in place of --gamma: 8 are about a gamma of 0.1, 16 one of 0.05")
    ("max-edge", number(o.max_edge), "wanted edge length where nothing else requires shorter edges (1/20 of the diagonal)")
    ("min-edge", number(o.min_edge),
     "edges are not divided into pieces shorter than this (1/1000 of the diagonal, or --max-edge if that is less)")
    ("gamma", number(o.gamma), "largest deviation ratio H/L of an edge: arc height over length (0.05)")
    ("distance", number(o.distance), "largest distance from a surface to its triangles (--relative-distance)")
    ("relative-distance", number(o.relative_distance), "the same as a share of the diagonal of the shape's bounding box (0.0005)")
    ("detail", number(o.detail),
     "width of edges, faces and parts of faces that may vanish where they would make small angles; no point moves farther (3/4 "
     "of the distance)")
    ("keep-detail", po::bool_switch(&o.is_detail_kept), "let no detail vanish")
    ("angle", number(o.angle),
     "smallest angle in degrees, at least 0 and below 60 (30); points are added for up to 32, and a larger angle is left to the "
     "improvement of the mesh")
    ("closeness", number(o.closeness), "maximum length of a boundary edge, as a multiple of the local width of its face (1.8)")
    ("growth", number(o.growth),
     "how fast edges grow away from the boundary of a face, as a share of the distance (0: not at all; 0.1 saves many triangles)")
    ("face-size", text(o.face_sizes, "F:L,..."),
     "wanted edge lengths of single faces; 3:0.5 sets 0.5 for face 3. F is a number, the name of faces or that of a part")
    ("edge-size", text(o.edge_sizes, "E:L,..."),
     "wanted edge lengths on single edges of the shape. E is a number, the name of edges, or that of faces or a part, for their "
     "edges")
    ("local-size", po::value<std::vector<std::string>>(&o.local_list)->value_name("WHERE:L[:G]"),
     "wanted edge length L in a part of space or near something, growing outside by G of the distance (0.2); WHERE is "
     "box:X,Y,Z,X,Y,Z (two corners), sphere:X,Y,Z,R, "
     "cylinder:X,Y,Z,X,Y,Z,R (the ends of its axis, and the radius), point:X,Y,Z, face:F, edge:E, vertex:V or part:P, with "
     "numbers or names; may be given several times, the least length counts")
    ("sphere-size", po::value<std::vector<std::string>>(&o.sphere_list)->value_name("X,Y,Z,R:L"),
     "the same as --local-size sphere:X,Y,Z,R:L")
    ("size-field", text(o.size_field, "FILE[:NAME]"),
     "wanted edge lengths at the nodes of a mesh of triangles or tetrahedra: the values called NAME, or the only ones, of a "
     ".vtu, .msh, or .mesh with .sol, in the unit of --unit; linear between the nodes, and outside of the mesh the length at its "
     "closest point")
    ("layers", po::value<double>(&o.layers)->value_name("N"),
     "edges of at most 1/N of the local thickness of walls and width of gaps, as a first mesh without this option shows them; "
     "not below --min-edge, or 1/4000 of the diagonal");
  criteria.add_options()
    ("self-intersections", text(o.self_intersections, "WHAT"),
     "triangles of one solid that pass through each other: refine (mesh again with shorter edges there, as far as that helps; "
     "list the rest), report or ignore (refine)");
  mesh_patch::add_sweeps(criteria, o.sweeps);
  po::options_description input("Input", 92);
  input.add_options()
    ("faces", text(o.face_list, "LIST"), "mesh these faces only, by numbers or names of faces or parts, for example 1,4,7-9,Flange")
    ("parts", po::value<std::vector<std::string>>(&o.part_lists)->value_name("NAME,..."),
     "mesh these parts of an assembly only: numbers of --list, names or paths; sizes and distances stay those of the whole; may "
     "be given several times")
    ("unit", text(o.unit, "UNIT"),
     "unit of lengths, of options and results: UM, MM, CM, M, KM, UIN, MIL, INCH, FT or MI (MM); BREP files have no unit")
    ("threads", mesh_patch::whole_number("threads", 1, 1024, o.threads), "number of threads that mesh faces and measure (1)")
    ("sew", number(o.sewing_tolerance),
     "join edges of different faces that are at most this far apart; IGES files are sewn by default, 0 turns this off (IGES: "
     "0.00001 of the diagonal, others: 0)")
    ("conformal", po::bool_switch(&o.is_conformal),
     "let parts that touch share their faces there, so that their meshes fit together; contacts, overlaps and gaps between parts "
     "are listed")
    ("fuzzy", number(o.fuzzy),
     "with --conformal, the distance up to which parts that do not quite touch, or overlap, are taken to touch (the tolerances "
     "of the file)")
    ("point", po::value<std::vector<std::string>>(&o.point_list)->value_name("X,Y,Z"),
     "put a point on the face closest to it, to be a vertex of the mesh; may be given several times. --point and --curves may "
     "change the numbers of faces and edges")
    ("curves", text(o.curves, "FILE"), "put the edges of a STEP, IGES or BREP file on the faces close to them, for the mesh to follow")
    ("reach", number(o.reach), "the largest distance of points and curves from the faces (1/50 of the diagonal)")
    ("heal", po::bool_switch(&o.is_healing_wanted), "let Open CASCADE repair the shape first (ShapeFix_Shape)");
  po::options_description output("Output", 92);
  mesh_patch::add_order(output, o.order);
  mesh_patch::add_page_and_picture(output, o.page, o.picture);
  output.add_options()
    ("list", po::bool_switch(&o.is_list_wanted),
     "print the parts of the assembly, their sizes, and what has names, write them with --json, and stop")
    ("list-faces", po::bool_switch(&o.is_face_list_wanted),
     "print what --list does, and each face with its kind, area, centre of gravity, direction (of planes out of the solid), "
     "radius, part and name")
    ("out,o", text(o.out, "FILE"),
     "the mesh, as .off, .obj, .ply, .stl, .vtu, .msh (.msh2: version 2.2), .inp, .bdf, .unv, .glb, .brep (the shape with the "
     "mesh as its triangulation, for Open CASCADE) or, if built with the libraries MED and lib3mf, .med and .3mf")
    ("binary", po::bool_switch(&o.is_binary), "write .stl, .off and .ply as binary files; .vtu always is one")
    ("node-parameters", po::bool_switch(&o.are_node_parameters_wanted),
     "write the parameters of nodes on their edges and faces, too, in .msh (Gmsh reads them, meshio does not) and .vtu")
    ("json", text(o.json, "FILE"), "the results in numbers, as .json")
    ("no-measure", po::bool_switch(&o.is_measuring_left_out),
     "do not measure how far the mesh is from the shape, nor what decides edge lengths, which may take as long as meshing")
    ("quiet", po::bool_switch(&o.is_quiet), "print nothing but errors")
    ("version", po::bool_switch(&o.is_version_wanted), "print the versions of this program and of its libraries, and stop")
    ("help,h", po::bool_switch(&o.is_help_wanted), "print this and stop");
  return criteria.add(input).add(output);
}

inline void print_help(std::ostream& out)
{
  Mesh_cad_options defaults;
  out << introduction << "\n" << described_options(defaults) << conclusion;
}

inline void check_values(const po::variables_map& given, const Mesh_cad_options& o)
{
  for(const char* option : {"max-edge", "min-edge", "gamma", "distance", "relative-distance", "detail", "closeness", "reach"})
    mesh_patch::check_positive(given, option);
  if(given.count("elements-per-turn") != 0 && !(o.elements_per_turn >= 3 && o.elements_per_turn <= 1e6))
    mesh_patch::refuse("elements-per-turn", o.elements_per_turn, "a number of at least 3 and at most 1000000");
  if(given.count("elements-per-turn") != 0 && given.count("gamma") != 0)
    throw Usage_error("--elements-per-turn and --gamma exclude each other");
  mesh_patch::check_angle("angle", o.angle);
  if(!(o.growth >= 0 && o.growth < 10))
    mesh_patch::refuse("growth", o.growth, "a number that is at least 0 and below 10");
  if(given.count("layers") != 0 && !(o.layers >= 1 && o.layers <= 1000))
    mesh_patch::refuse("layers", o.layers, "a number of at least 1 and at most 1000");
  if(given.count("sew") != 0)
    mesh_patch::check_at_least_0("sew", o.sewing_tolerance);
  if((o.is_list_wanted || o.is_face_list_wanted) && (given.count("out") != 0 || given.count("picture") != 0 || given.count("page") != 0))
    throw Usage_error("--list and --list-faces mesh nothing, and cannot be given with --out, --picture or --page");
  mesh_patch::check_at_least_0("fuzzy", o.fuzzy);
  if(given.count("reach") != 0 && given.count("point") == 0 && given.count("curves") == 0)
    throw Usage_error("--reach has a meaning only with --point or --curves");
  if(given.count("fuzzy") != 0 && !o.is_conformal)
    throw Usage_error("--fuzzy has a meaning only with --conformal");
  if(o.self_intersections != "refine" && o.self_intersections != "report" && o.self_intersections != "ignore")
    throw Usage_error("--self-intersections: '" + o.self_intersections + "' must be refine, report or ignore");
  mesh_patch::check_page(o.page);
  mesh_patch::check_picture(o.picture);
#ifndef CGAL_LINKED_WITH_TBB
  if(o.threads > 1)
    throw Usage_error("--threads: " + std::to_string(o.threads) + " must be 1, since this program was built without oneTBB");
#endif
  if(o.detail > 0 && o.is_detail_kept)
    throw Usage_error("--detail and --keep-detail exclude each other");
  mesh_patch::check_edge_lengths(o.min_edge, o.max_edge);
}

// Of the options that are not given.
inline void take_defaults_of_fineness(const po::variables_map& given, Mesh_cad_options& o)
{
  const Fineness& preset = fineness_called(o.fineness);
  o.share_of_max_edge = preset.max_edge;
  const auto take = [&](const char* option, double value, double& target) {
    if(given.count(option) == 0)
      target = value;
  };
  take("gamma", o.elements_per_turn > 0 ? gamma_of_elements_per_turn(o.elements_per_turn) : preset.gamma, o.gamma);
  take("relative-distance", preset.relative_distance, o.relative_distance);
  take("growth", preset.growth, o.growth);
}

} // namespace mesh_cad

// Reads the command line; throws Usage_error.
inline Mesh_cad_options read_mesh_cad_options(int argc, char** argv)
{
  using namespace mesh_cad;
  Mesh_cad_options o;
  po::options_description options = described_options(o);
  options.add_options()("input", po::value<std::string>(&o.input));
  po::positional_options_description positional;
  positional.add("input", 1);
  po::variables_map given;
  try {
    const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(argc, argv).options(options).positional(positional).style(style).run(), given);
    po::notify(given);
  }
  catch(const po::too_many_positional_options_error&) {
    throw Usage_error("more than one input file is given; --help lists the options");
  }
  catch(const po::error& error) {
    throw Usage_error(std::string(error.what()) + "; --help lists the options");
  }
  if(o.is_help_wanted || o.is_version_wanted)
    return o;
  boost::algorithm::to_upper(o.unit);
  if(o.input.empty())
    throw Usage_error("no input file is given; --help lists the options");
  check_values(given, o);
  take_defaults_of_fineness(given, o);
  for(const char* option : {"faces", "face-size", "edge-size"})
    if(given.count(option) != 0 && given[option].as<std::string>().empty())
      throw Usage_error(std::string("--") + option + ": the list is empty");
  for(const std::string& size : o.local_list)
    o.local_sizes.push_back(local_size_in("local-size", size));
  for(const std::string& sphere : o.sphere_list)
    o.local_sizes.push_back(sphere_size_in("sphere-size", sphere));
  for(const std::string& point : o.point_list)
    o.points.push_back(point_in(point));
  return o;
}

#endif // MESH_CAD_OPTIONS_H
