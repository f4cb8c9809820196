// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program mesh_patch from outside: command lines, exit statuses and files.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include "program_test.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <Sample_models.h>
#include <Sample_surfaces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <sys/stat.h>
#include <utility>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

std::set<std::string> words_of(std::string text)
{
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()};
}

std::size_t number_of_occurrences(const std::string& word, const std::string& text)
{
  std::size_t n = 0;
  for(std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1))
    ++n;
  return n;
}

class Mesh_patch_program : public Program_test
{
protected:
  Mesh_patch_program() : Program_test(MESH_PATCH_PROGRAM) {}
};

const char* const teapot = PARAMETRIC_SURFACE_MESHER_DATA_DIR "/teapot.bpt";

TEST_F(Mesh_patch_program, helps)
{
  const Result result = run("--help");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  for(const char* option : {"--max-edge", "--min-edge", "--gamma", "--angle", "--size-factor", "--distance", "--metric",
                            "--division", "--out", "--uv", "--picture", "--uv-picture", "--ellipses", "--page", "--json", "--quiet",
                            "principal-curvature", "stretch", ".bpt", "boundary_limited", "unmet"})
    EXPECT_NE(result.out.find(option), std::string::npos) << option;
}

TEST_F(Mesh_patch_program, knows_short_options_and_capital_endings)
{
  EXPECT_EQ(run("-h").out, run("--help").out);
  const Result version = run("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.find("mesh_patch 0."), 0u) << version.out;
  EXPECT_NE(version.out.find("CGAL "), std::string::npos) << version.out;
  EXPECT_EQ(run("--quiet -o short.off -- flat").status, 0);
  EXPECT_EQ(run("flat --quiet --out capital.OFF").status, 0);
  EXPECT_EQ(content(file("short.off")), content(file("capital.OFF")));
}

TEST_F(Mesh_patch_program, names_all_samples)
{
  const std::set<std::string> help = words_of(run("--help").out), error = words_of(run("nothing").err);
  for(const std::string& name : all_sample_names()) {
    EXPECT_EQ(help.count(name), 1u) << name;
    EXPECT_EQ(error.count(name), 1u) << name;
  }
}

TEST_F(Mesh_patch_program, meshes_all_samples)
{
  for(const std::string& name : all_sample_names()) {
    const Result result = run(name);
    EXPECT_EQ(result.status, 0) << name;
    EXPECT_EQ(result.err, "") << name;
    EXPECT_EQ(result.out.find(name + ": "), 0u) << result.out;
    EXPECT_NE(result.out.find("angles: minimum "), std::string::npos) << result.out;
  }
  EXPECT_EQ(number_of_files(), 0u);
}

// the numbers of the model, then those of the mesh
struct Topology
{
  int faces, vertices, edges, border_edges, seams, poles, euler_characteristic, boundary_cycles;
};

Topology expected_topology(const std::string& name)
{
  const Topology rectangle = {1, 4, 4, 4, 0, 0, 1, 1}, torus = {1, 1, 2, 0, 2, 0, 0, 0};
  const std::map<std::string, Topology> all = {{"flat", rectangle},
                                               {"bend", rectangle},
                                               {"peak", rectangle},
                                               {"hole", {1, 5, 5, 5, 0, 0, 0, 2}},
                                               {"cap", rectangle},
                                               {"skew", rectangle},
                                               {"stretch", rectangle},
                                               {"sphere", {1, 2, 1, 0, 1, 2, 2, 0}},
                                               {"torus", torus},
                                               {"cyl", {1, 2, 3, 2, 1, 0, 0, 2}},
                                               {"cone", {2, 3, 3, 0, 2, 2, 2, 0}},
                                               {"vase", {1, 2, 2, 1, 1, 1, 1, 1}},
                                               {"ring", torus},
                                               {"box", {6, 8, 12, 0, 0, 0, 2, 0}}};
  return all.at(name);
}

TEST_F(Mesh_patch_program, closes_what_is_closed)
{
  for(const std::string& name : all_sample_names()) {
    SCOPED_TRACE(name);
    const Topology expected = expected_topology(name);
    const nlohmann::json result = json(name + " --max-edge 0.1");
    EXPECT_EQ(result.at("faces"), expected.faces);
    EXPECT_EQ(result.at("patches"), expected.faces);
    EXPECT_EQ(result.at("model_vertices"), expected.vertices);
    EXPECT_EQ(result.at("model_edges"), expected.edges);
    EXPECT_EQ(result.at("model_border_edges"), expected.border_edges);
    EXPECT_EQ(result.at("model_seams"), expected.seams);
    EXPECT_EQ(result.at("model_poles"), expected.poles);
    EXPECT_EQ(result.at("model_nonmanifold_edges"), 0);
    EXPECT_EQ(result.at("euler_characteristic"), expected.euler_characteristic);
    EXPECT_EQ(result.at("boundary_cycles"), expected.boundary_cycles);
    EXPECT_EQ(result.at("closed"), expected.boundary_cycles == 0);
    EXPECT_EQ(result.at("border_edges") == 0, expected.boundary_cycles == 0);
    EXPECT_EQ(result.at("connected_components"), 1);
    EXPECT_EQ(result.at("manifold"), true);
    EXPECT_EQ(result.at("inverted_triangles"), 0);
  }
}

TEST_F(Mesh_patch_program, tells_what_is_closed)
{
  EXPECT_NE(run("sphere").out.find(" vertices, closed\n"), std::string::npos);
  EXPECT_NE(run("cyl").out.find(" vertices, open: it has 2 borders\n"), std::string::npos);
  EXPECT_EQ(run("box").out.find("box: 6 faces; "), 0u);
  EXPECT_EQ(run("sphere").out.find("sphere: 2 x 2 x 2\n"), 0u) << run("sphere").out;
}

TEST_F(Mesh_patch_program, tells_people_what_the_mesh_is_like)
{
  const Result good = run("flat"), coarse = run("peak --max-edge 0.5 --min-edge 0.4 --distance 0.01");
  EXPECT_EQ(good.status, 0);
  EXPECT_NE(good.out.find("  verdict: all is well\n"), std::string::npos) << good.out;
  for(const char* words : {"WRONG", "note: ", "H/L", "2r/R", "allowed"})
    EXPECT_EQ(good.out.find(words), std::string::npos) << good.out;
  EXPECT_EQ(coarse.status, 1);
  EXPECT_NE(coarse.out.find("  WRONG: the mesh is much farther from the surface than allowed"), std::string::npos) << coarse.out;
  EXPECT_NE(coarse.out.find(" farther from the surface than 0.01: edges there are as short as they may be, 0.4; "), std::string::npos)
    << coarse.out;
}

// Around a pole, points of the surface are close to other triangles than those over which they are in the domain.
TEST_F(Mesh_patch_program, measures_the_distance_from_the_whole_mesh)
{
  const Result sphere = run("sphere --distance 0.001");
  EXPECT_EQ(sphere.status, 0) << sphere.out;
  EXPECT_EQ(sphere.out.find("WRONG"), std::string::npos) << sphere.out;
}

TEST_F(Mesh_patch_program, gives_samples_their_area)
{
  for(const std::string& name : sample_patch_names())
    EXPECT_NEAR(json(name + " --max-edge 0.05").at("area").get<double>() / make_sample(name).area, 1, 0.005) << name;
  for(const std::string& name : sample_model_names())
    EXPECT_NEAR(json(name + " --max-edge 0.05").at("area").get<double>() / make_sample_model(name).area, 1, 0.005) << name;
}

TEST_F(Mesh_patch_program, closed_models_face_outward)
{
  const double pi = 4 * std::atan(1.);
  for(const auto& volume : std::map<std::string, double>{{"sphere", 4 * pi / 3},
                                                         {"torus", 0.18 * pi * pi},
                                                         {"cone", 2 * pi / 3},
                                                         {"ring", 0.32 * pi * pi},
                                                         {"box", 1.125}}) {
    SCOPED_TRACE(volume.first);
    json(volume.first + " --max-edge 0.1 --out out.off");
    Mesh mesh;
    ASSERT_TRUE(CGAL::IO::read_OFF(file("out.off"), mesh));
    EXPECT_TRUE(CGAL::is_closed(mesh));
    EXPECT_NEAR(CGAL::Polygon_mesh_processing::volume(mesh) / volume.second, 1, 0.02);
  }
}

// Only triangles that the fixed edges limit may fail; and at the apex of the cone some have edges that are too far from the
// surface for their length, and too short to be divided.
TEST_F(Mesh_patch_program, has_good_angles_at_seams_and_poles)
{
  const double smallest = 30 - 1e-6;
  for(const char* name : {"sphere", "torus", "cyl", "cone"}) {
    SCOPED_TRACE(name);
    const nlohmann::json result = json(std::string(name) + " --max-edge 0.1");
    for(const auto& unmet : result.at("unmet_by"))
      if(unmet.at("cause") != "boundary") {
        EXPECT_EQ(std::string(name), "cone");
        EXPECT_EQ(unmet.at("criteria"), nlohmann::json::array({"deviation"}));
        EXPECT_EQ(unmet.at("cause"), "minimum edge");
      }
    EXPECT_LE(result.at("boundary_limited").get<int>(), 3);
    EXPECT_GE(result.at("min_angle_off_boundary").get<double>(), smallest);
    if(result.at("boundary_limited") == 0) {
      EXPECT_GE(result.at("min_angle").get<double>(), smallest);
    }
  }
}

TEST_F(Mesh_patch_program, is_quiet)
{
  const Result result = run("flat --quiet --json result.json");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(Mesh_patch_program, gives_all_numbers)
{
  const nlohmann::json result = json("bend --max-edge 0.1");
  for(const char* key : {"vertices", "triangles", "edges", "boundary_limited", "unmet", "connected_components",
                         "boundary_cycles", "border_edges", "euler_characteristic", "patches", "faces", "model_vertices",
                         "model_edges", "model_border_edges", "model_seams", "model_poles", "model_nonmanifold_edges"})
    EXPECT_TRUE(result.at(key).is_number_integer()) << key;
  for(const char* key : {"min_angle", "mean_min_angle", "mean_radius_ratio", "max_deviation", "max_edge"})
    EXPECT_TRUE(result.at(key).is_number_float()) << key;
  EXPECT_EQ(result.at("name"), "bend");
  EXPECT_EQ(result.at("closed"), false);
  EXPECT_EQ(result.at("euler_characteristic"), 1);
  EXPECT_EQ(result.at("inverted_triangles"), 0);

  std::size_t unmet = 0;
  for(const auto& count : result.at("unmet_by"))
    unmet += count.at("triangles").get<std::size_t>();
  EXPECT_EQ(result.at("unmet").get<std::size_t>() + result.at("boundary_limited").get<std::size_t>(), unmet);

  double sum = 0;
  for(const char* phase : {"division", "triangulation", "refinement", "improvement", "output"})
    sum += result.at("seconds").at(phase).get<double>();
  EXPECT_DOUBLE_EQ(result.at("seconds").at("meshing").get<double>(), sum);
}

TEST_F(Mesh_patch_program, writes_formats_that_cgal_reads)
{
  for(const char* surface : {"hole", teapot})
    for(const char* ending : {".off", ".obj", ".ply", ".stl"}) {
      const std::string out = std::string("out") + ending, uv = std::string("uv") + ending;
      const nlohmann::json result
        = json(std::string(surface) + " --max-edge 0.5 --gamma 0.3 --min-edge 0.1 --out " + out + " --uv " + uv);
      Mesh mesh, domain_mesh;
      ASSERT_TRUE(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file(out), mesh)) << surface << " " << out;
      EXPECT_EQ(mesh.number_of_faces(), result.at("triangles")) << surface << " " << out;
      ASSERT_TRUE(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file(uv), domain_mesh)) << surface << " " << uv;
      EXPECT_EQ(domain_mesh.number_of_faces(), result.at("triangles")) << surface << " " << uv;
      for(const auto v : domain_mesh.vertices())
        EXPECT_EQ(domain_mesh.point(v).z(), 0);
    }
}

TEST_F(Mesh_patch_program, keeps_all_digits_and_the_order_of_vertices)
{
  json("skew --out out.off --uv uv.off");
  Mesh mesh, domain_mesh;
  ASSERT_TRUE(CGAL::IO::read_OFF(file("out.off"), mesh));
  ASSERT_TRUE(CGAL::IO::read_OFF(file("uv.off"), domain_mesh));
  ASSERT_EQ(mesh.number_of_vertices(), domain_mesh.number_of_vertices());
  for(const auto v : mesh.vertices()) { // x = u + 3v, y = v
    EXPECT_EQ(mesh.point(v).x(), domain_mesh.point(v).x() + 3 * domain_mesh.point(v).y());
    EXPECT_EQ(mesh.point(v).y(), domain_mesh.point(v).y());
  }
}

#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_PAGE

TEST_F(Mesh_patch_program, writes_pages)
{
  const auto largest = [](const nlohmann::json& values) {
    const double high = values["range"]["high"];
    return values["range"]["logarithmic"].get<bool>() ? std::exp(high) : high;
  };
  nlohmann::json page = data_of_page("sphere --max-edge 0.3");
  EXPECT_EQ(page["title"], "sphere");
  EXPECT_TRUE(page["closed"]);
  EXPECT_EQ(page["faces"].size(), 1u);
  EXPECT_NEAR(largest(page["values"][1]), 1, 1e-6); // the curvature, the same everywhere
  EXPECT_NEAR(page["values"][1]["range"]["low"], 0, 1e-6);
  page = data_of_page("peak --max-edge 0.15 --json peak.json");
  const nlohmann::json numbers = nlohmann::json::parse(content(file("peak.json")));
  EXPECT_FALSE(page["closed"]);
  EXPECT_EQ(page["numberOfPoints"], numbers["vertices"]);
  EXPECT_NEAR(page["angles"]["low"], numbers["min_angle"].get<double>(), 1e-6);
  const double distance = numbers["max_distance"]; // looked for at other places
  EXPECT_LE(largest(page["values"][0]), 1.25 * distance);
  EXPECT_GE(largest(page["values"][0]), 0.8 * distance);
  page = data_of_page("peak --max-edge 0.5 --min-edge 0.4");
  ASSERT_FALSE(page["findings"].empty());
  EXPECT_EQ(page["findings"][0]["kind"], "not met");
}

#else

TEST_F(Mesh_patch_program, tells_what_pages_need) { expect_refused("peak --page peak.html", "libjs-three"); }

#endif

TEST_F(Mesh_patch_program, draws_pictures)
{
  json("peak --picture surface.svg --uv-picture domain.svg --ellipses 20");
  for(const char* name : {"surface.svg", "domain.svg"}) {
    const std::string svg = content(file(name));
    EXPECT_EQ(svg.find("<svg "), 0u) << name;
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << name;
  }
  EXPECT_EQ(number_of_occurrences("<circle", content(file("domain.svg"))), 20u);
}

TEST_F(Mesh_patch_program, draws_all_samples)
{
  for(const std::string& name : all_sample_names()) {
    SCOPED_TRACE(name);
    const nlohmann::json result = json(name + " --max-edge 0.2 --picture surface.svg --uv-picture domain.svg");
    const std::string surface = content(file("surface.svg")), domain = content(file("domain.svg"));
    for(const std::string& svg : {surface, domain}) {
      EXPECT_EQ(number_of_occurrences("z\"/>", svg), result.at("triangles"));
      EXPECT_NE(svg.find(">" + name), std::string::npos);
      EXPECT_EQ(svg.find("nan"), std::string::npos);
    }
    EXPECT_EQ(number_of_occurrences("fill=\"none\"", surface), result.at("division_edges")); // drawn stronger
  }
}

TEST_F(Mesh_patch_program, follows_a_prescribed_division)
{
  const nlohmann::json result = json("hole --max-edge 0.5 --division 10,10,10,10,400");
  EXPECT_EQ(result.at("border_edges"), 440);
  EXPECT_EQ(json("flat --max-edge 0.25 --division 8,0,0,0").at("border_edges"), 8 + 3 * 4);
}

TEST_F(Mesh_patch_program, follows_a_prescribed_division_of_a_model)
{
  EXPECT_EQ(json("sphere --max-edge 0.5 --division 30").at("division_edges"), 30);
  const nlohmann::json cylinder = json("cyl --max-edge 0.5 --division 20,9,24"); // below, seam, above
  EXPECT_EQ(cylinder.at("border_edges"), 20 + 24);
  EXPECT_EQ(cylinder.at("division_edges"), 20 + 9 + 24);
  EXPECT_EQ(json("box --max-edge 0.5 --division 5,6,7,8,9,5,6,7,8,9,5,6").at("division_edges"), 81);
  const std::size_t divided_by_criteria = json("torus --max-edge 0.2 --division 0,0").at("division_edges");
  EXPECT_EQ(json("torus --max-edge 0.2").at("division_edges"), divided_by_criteria);
}

TEST_F(Mesh_patch_program, curves_triangles)
{
  for(const char* surface : {"torus", "hole"}) {
    const nlohmann::json numbers = json(std::string(surface) + " --order 2 --quiet");
    EXPECT_EQ(numbers["order"], 2);
    EXPECT_LT(numbers["second_order"]["distance"], numbers["max_distance"].get<double>() / 20);
    EXPECT_TRUE(numbers["second_order"]["uncertified"].empty());
  }
  EXPECT_EQ(run("box --order 2 --out box.inp").status, 0);
  EXPECT_NE(content(file("box.inp")).find("TYPE=S6"), std::string::npos);
  expect_refused("box --order 2 --out box.off", "must end in");
  expect_refused("box --order 0", "--order");
}

TEST_F(Mesh_patch_program, joins_the_patches_of_the_teapot)
{
  const nlohmann::json result = json(std::string(teapot) + " --max-edge 0.3 --gamma 0.2");
  EXPECT_EQ(result.at("faces"), 28);
  EXPECT_EQ(result.at("model_vertices").get<int>() - result.at("model_edges").get<int>() + result.at("faces").get<int>(),
            result.at("euler_characteristic"));
  EXPECT_EQ(result.at("connected_components"), 4);
  EXPECT_EQ(result.at("boundary_cycles"), 7);
  EXPECT_EQ(result.at("manifold"), true);
  EXPECT_EQ(result.at("inverted_triangles"), 0);
}

// What the README says of the meshes that scripts/demo.sh makes.
TEST_F(Mesh_patch_program, makes_the_angles_that_the_readme_promises)
{
  const std::string readme = content(PARAMETRIC_SURFACE_MESHER_DATA_DIR "/../../../README.md"), words = "angles down to ";
  ASSERT_NE(readme.find(words), std::string::npos);
  const double smallest = std::stod(readme.substr(readme.find(words) + words.size()));
  const nlohmann::json teapot_mesh = json(std::string(teapot) + " --quiet --max-edge 0.12 --gamma 0.1 --out teapot.off");
  EXPECT_LT(teapot_mesh.at("min_angle"), 30);
  EXPECT_GE(teapot_mesh.at("min_angle"), smallest - 0.5);
  Mesh mesh;
  ASSERT_TRUE(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file("teapot.off"), mesh));
  std::size_t below_30 = 0;
  for(const auto face : mesh.faces()) {
    double least = 180;
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(face)))
      least = (std::min)(least, CGAL::approximate_angle(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                                        mesh.point(mesh.target(mesh.next(h)))));
    below_30 += least < 30 - 1e-6;
  }
  EXPECT_GT(below_30, 0u);
  EXPECT_LE(below_30, teapot_mesh.at("boundary_limited").get<std::size_t>() + teapot_mesh.at("unmet").get<std::size_t>());
  for(const char* others : {"bend --max-edge 0.0304", "peak --max-edge 0.0455", "hole --max-edge 0.0477", "cap --max-edge 0.0320"})
    EXPECT_GE(json(std::string(others) + " --quiet").at("min_angle"), 38) << others;
}

TEST_F(Mesh_patch_program, knows_both_metrics)
{
  EXPECT_EQ(json("torus --metric first-fundamental-form").at("metric"), "first-fundamental-form");
  EXPECT_EQ(json("torus --metric principal-curvature").at("metric"), "principal-curvature");
}

TEST_F(Mesh_patch_program, replaces_its_files)
{
  json("flat --max-edge 0.5 --out out.off");
  const std::string coarse = content(file("out.off"));
  json("flat --max-edge 0.2 --out out.off");
  EXPECT_GT(content(file("out.off")).size(), coarse.size());
}

TEST_F(Mesh_patch_program, refuses_bad_command_lines)
{
  expect_refused("", "--help");
  expect_refused("--quiet", "--help");
  expect_refused("flat --wrong", "--wrong");
  expect_refused("flat --max-ed 0.1", "--max-ed");
  expect_refused("flat -q", "-q");
  expect_refused("flat peak", "more than one");
  expect_refused("flat --max-edge", "--max-edge");
  expect_refused("flat --max-edge 0.1 --max-edge 0.2", "--max-edge");
  expect_refused("flat --max-edge ten", "ten");
  expect_refused("flat --max-edge 1e-2x", "1e-2x");
}

TEST_F(Mesh_patch_program, refuses_impossible_values)
{
  for(const char* option : {"--max-edge", "--min-edge", "--gamma", "--size-factor", "--distance"})
    for(const char* value : {"0", "-1", "nan", "inf", "1e999"})
      expect_refused(std::string("flat --out out.off ") + option + " " + value, option);
  for(const char* value : {"-1", "60", "90", "nan"})
    expect_refused(std::string("flat --angle ") + value, "--angle");
  expect_refused("flat --max-edge 0.1 --min-edge 0.2", "--min-edge: 0.2 must be at most the length of --max-edge, 0.1");
  expect_refused("flat --min-edge 5", "--min-edge: 5 must be at most the length of --max-edge, which is ");
  expect_refused("flat --metric euclidean", "euclidean");
  expect_refused("flat --ellipses 5", "--uv-picture");
  expect_refused("flat --ellipses -5 --uv-picture u.svg", "--ellipses: -5 must be a whole number from 0 to 1000000");
  expect_refused("flat --improvement-angle 61", "--improvement-angle: 61 must be an angle in degrees that is at least 0 and below 60");
  for(const char* value : {"1,2", "1,2,3,4,5", "a,b,c,d", "-1,1,1,1", "1,,1,1", "99999999,1,1,1", "''"})
    expect_refused(std::string("flat --division ") + value, "--division");
  expect_refused("hole --division 1,2", "hole takes 5 numbers");
  expect_refused("sphere --division 1,2,3,4", "sphere takes 1 number,");
  expect_refused("box --division 1", "box takes 12 numbers");
  expect_refused(std::string(teapot) + " --division 1,2,3", "--division");
}

TEST_F(Mesh_patch_program, refuses_bad_files)
{
  expect_refused("nothing", "peak");
  expect_refused("missing.bpt", "missing.bpt");
  expect_refused("part.STEP", "mesh_cad");
  std::ofstream(file("bad.bpt")) << "1\n3 3\n0 0 zero\n";
  expect_refused("bad.bpt --out out.off", "bad.bpt, line 3");
  expect_refused("flat --out out.vtk", ".ply");
  expect_refused("flat --uv uv", ".off");
  expect_refused("flat --picture p.jpg", ".svg");
  expect_refused("flat --uv-picture p.png", ".svg");
  expect_refused("flat --json j.txt", ".json");
  expect_refused("flat --out no/such/directory/out.off", "out.off");
  expect_refused("flat --out same.off --uv same.off", "same.off");
  expect_refused("flat --out out.off --json no/such/result.json", "result.json");
}

TEST_F(Mesh_patch_program, keeps_old_files_if_meshing_fails)
{
  std::ofstream(file("out.off")) << "old";
  // a division into two edges in all cannot bound the hole
  expect_refused("hole --division 1,1,1,1,2 --out out.off", "loop 2");
  EXPECT_EQ(content(file("out.off")), "old");
}

TEST_F(Mesh_patch_program, writes_into_a_pipe)
{
  ASSERT_EQ(mkfifo(file("pipe.off").c_str(), 0600), 0);
  EXPECT_EQ(run("flat --quiet --out whole.off && { timeout 60 cat pipe.off > read.off & timeout 60 '" + program
                + "' flat --quiet --out pipe.off; wait; }").status, 0);
  EXPECT_TRUE(std::filesystem::is_fifo(file("pipe.off")));
  EXPECT_NE(content(file("read.off")), "");
  EXPECT_EQ(content(file("read.off")), content(file("whole.off")));
}

// Nobody reads the pipe, so the program waits there, and has the first file under its temporary name.
TEST_F(Mesh_patch_program, removes_unfinished_files_if_it_is_told_to_end)
{
  ASSERT_EQ(mkfifo(file("pipe.json").c_str(), 0600), 0);
  for(const char* signal : {"TERM", "HUP"}) {
    run("--version && { '" + program + "' flat --quiet --out mesh.off --json pipe.json & job=$!; for i in $(seq 600); do test -s mesh.off.part && break; sleep 0.1; done; "
        "ls > seen; kill -" + std::string(signal) + " $job; wait $job; echo $? > status; }");
    EXPECT_NE(content(file("seen")).find("mesh.off.part"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(file("mesh.off.part")));
    EXPECT_FALSE(std::filesystem::exists(file("mesh.off")));
    EXPECT_EQ(content(file("status")), signal == std::string("TERM") ? "143\n" : "129\n");
  }
}

} // namespace
