// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program mesh_cad from outside.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include "program_test.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Plane.hxx>
#include <IGESControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

class Mesh_cad_program : public Program_test
{
protected:
  Mesh_cad_program() : Program_test(MESH_CAD_PROGRAM) {}

  void SetUp() override
  {
    Program_test::SetUp();
    STEPControl_Writer step;
    step.Transfer(box(), STEPControl_AsIs);
    step.Write(file("box.step").c_str());
    BRepTools::Write(box(), file("box.brep").c_str());
  }

  static TopoDS_Shape box() { return BRepPrimAPI_MakeBox(1, 2, 3).Shape(); }

  // a box and a square whose boundary crosses itself
  void write_dirty_file(const std::string& name) const
  {
    BRep_Builder builder;
    BRepBuilderAPI_MakePolygon polygon;
    for(const gp_Pnt& p : {gp_Pnt(0, 0, 0), gp_Pnt(1, 1, 0), gp_Pnt(1, 0, 0), gp_Pnt(0, 1, 0)})
      polygon.Add(p);
    polygon.Close();
    TopoDS_Face face;
    builder.MakeFace(face, new Geom_Plane(gp_Pln()), 1e-7);
    builder.Add(face, polygon.Wire());
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    builder.Add(compound, face);
    builder.Add(compound, BRepPrimAPI_MakeBox(gp_Pnt(5, 0, 0), 1, 2, 3).Shape());
    BRepTools::Write(compound, file(name).c_str());
  }

  double volume(const std::string& name) const
  {
    Mesh mesh;
    EXPECT_TRUE(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file(name), mesh)) << name;
    EXPECT_TRUE(CGAL::is_closed(mesh)) << name;
    return CGAL::Polygon_mesh_processing::volume(mesh);
  }
};

TEST_F(Mesh_cad_program, helps)
{
  const Result result = run("--help");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err, "");
  for(const char* option : {"--max-edge", "--min-edge", "--gamma", "--distance", "--relative-distance", "--angle", "--closeness", "--growth", "--sweeps", "--threads",
                            "--face-size", "--edge-size", "--no-measure",
                            "--local-size", "--size-field", "--sphere-size", "--sew", "--faces", "--unit", "--heal", "--out", "--picture", "--json", "--quiet",
                            ".vtu", ".msh", ".inp", ".step", ".iges", ".brep", "Exit status"})
    EXPECT_NE(result.out.find(option), std::string::npos) << option;
}

TEST_F(Mesh_cad_program, writes_closed_meshes_in_all_formats)
{
  for(const char* name : {"box.off", "box.obj", "box.ply", "box.stl"}) {
    const Result result = run(std::string("box.step --out ") + name);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("6 faces"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("closed"), std::string::npos) << result.out;
    if(std::string(name) != "box.stl") { // a soup
      EXPECT_NEAR(volume(name), 6, 1e-6) << name;
    }
  }
}

// As in all other formats, messages and the JSON file: faces are counted from 1.
TEST_F(Mesh_cad_program, counts_faces_from_1_in_ply_files)
{
  ASSERT_EQ(run("box.brep --quiet --faces 2,6 --out box.ply").status, 0);
  const std::string ply = content(file("box.ply"));
  EXPECT_NE(ply.find("property uint face_id\nproperty uint part_id\nend_header"), std::string::npos);
  EXPECT_EQ(ply.find(" patch\n"), std::string::npos);
  std::istringstream triangles(ply.substr(ply.find("\n3 ") + 1));
  std::set<std::size_t> faces;
  for(std::size_t n, a, b, c, face, part; triangles >> n >> a >> b >> c >> face >> part;) {
    faces.insert(face);
    EXPECT_EQ(part, 1u);
  }
  EXPECT_EQ(faces, (std::set<std::size_t>{2, 6}));
}

TEST_F(Mesh_cad_program, tells_the_face_of_each_triangle)
{
  ASSERT_EQ(run("box.brep --quiet --out box.msh").status, 0);
  ASSERT_EQ(run("box.brep --quiet --out box.msh2").status, 0);
  ASSERT_EQ(run("box.brep --quiet --out box.vtu").status, 0);
  ASSERT_EQ(run("box.brep --quiet --out box.inp").status, 0);
  const std::string msh = content(file("box.msh")), msh_2 = content(file("box.msh2")), vtu = content(file("box.vtu")), inp = content(file("box.inp"));
  EXPECT_NE(msh.find("4.1 0 8"), std::string::npos);
  EXPECT_NE(msh_2.find("2.2 0 8"), std::string::npos);
  for(int face = 1; face <= 6; ++face) {
    EXPECT_NE(msh.find("2 " + std::to_string(face) + " \"face_" + std::to_string(face) + "\""), std::string::npos);
    EXPECT_NE(inp.find("ELSET=FACE_" + std::to_string(face) + "\n"), std::string::npos);
  }
  EXPECT_NE(vtu.find("Name=\"face_id\""), std::string::npos);
  const std::string last = std::to_string(json("box.brep --quiet")["triangles"].get<int>()); // the number of the last triangle
  EXPECT_NE(msh_2.find("\n" + last + " 2 2 6 6 "), std::string::npos);
  EXPECT_NE(inp.find("\n" + last + ", "), std::string::npos);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_F(Mesh_cad_program, threads_make_the_same_mesh)
{
  ASSERT_EQ(run("box.brep --quiet --out one.off").status, 0);
  ASSERT_EQ(run("box.brep --quiet --threads 3 --out three.off").status, 0);
  EXPECT_EQ(content(file("one.off")), content(file("three.off")));
  EXPECT_EQ(run("box.brep --threads 0").status, 2);
}

// Bit by bit: of curved faces, and of the data of triangles, too.
TEST_F(Mesh_cad_program, threads_measure_the_same)
{
  BRepTools::Write(BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(1, 2).Shape(), box()).Shape(), file("cut.brep").c_str());
  const auto numbers = [this](const std::string& options) {
    nlohmann::json result = json("cut.brep --quiet --max-edge 0.03 " + options);
    for(const char* time : {"seconds", "meshing_phases"})
      result.erase(time);
    return result;
  };
  EXPECT_EQ(numbers("--out one.vtu"), numbers("--threads 4 --out four.vtu"));
  EXPECT_EQ(content(file("one.vtu")), content(file("four.vtu")));
  EXPECT_EQ(numbers("--order 2"), numbers("--order 2 --threads 4"));
}
#endif

TEST_F(Mesh_cad_program, edges_grow_inside_faces)
{
  const auto triangles = [this](const std::string& options) {
    return json("box.brep --quiet --max-edge 1 --edge-size 1:0.02,2:0.02,3:0.02,4:0.02 " + options)["triangles"].get<int>();
  };
  EXPECT_LT(triangles("--growth 0.2"), 0.7 * triangles(""));
}

TEST_F(Mesh_cad_program, numbers)
{
  const nlohmann::json numbers = json("box.step --quiet");
  EXPECT_EQ(numbers["faces"], 6);
  EXPECT_EQ(numbers["meshed_faces"], 6);
  EXPECT_TRUE(numbers["left_out"].empty());
  EXPECT_TRUE(numbers["closed"]);
  EXPECT_TRUE(numbers["shape_closed"]);
  EXPECT_NEAR(numbers["diagonal"], std::sqrt(14.), 1e-5);
  EXPECT_NEAR(numbers["max_edge"], std::sqrt(14.) / 20, 1e-5);
  EXPECT_NEAR(numbers["area"], 22, 1e-9);
  EXPECT_GE(numbers["min_angle"], 25);
  EXPECT_EQ(numbers["below_10"], 0);
  EXPECT_LE(numbers["distance"], 1e-12);
}

// A cylinder is as large as it is, although the vertices of its mesh do not reach that far everywhere.
TEST_F(Mesh_cad_program, tells_people_what_the_mesh_is_like)
{
  BRepTools::Write(BRepPrimAPI_MakeCylinder(50, 20).Shape(), file("cylinder.brep").c_str());
  const Result round = run("cylinder.brep"), flat = run("box.step --unit CM");
  EXPECT_EQ(round.status, 0);
  EXPECT_EQ(round.out.find("cylinder.brep: 1 solid, 3 faces; 100 x 100 x 20 in the unit of the file\n"), 0u) << round.out;
  EXPECT_NE(flat.out.find(", 1 solid, 6 faces; 0.1 x 0.2 x 0.3 cm\n"), std::string::npos) << flat.out;
  for(const char* words : {" triangles, ", ", closed\n  angles: minimum ", " degrees; none below 10\n  distance from the shape: at most ",
                           " allowed\n", "\n  edge lengths: decided for ", "\n  processor time: ", "\n  verdict: "})
    EXPECT_NE(round.out.find(words), std::string::npos) << words << "\n" << round.out;
  EXPECT_NE(flat.out.find("  verdict: all is well\n"), std::string::npos) << flat.out;
  for(const char* words : {"WRONG", "note: ", " 0 edges", " 0 faces", "gamma", "H/L"})
    EXPECT_EQ(flat.out.find(words), std::string::npos) << words << "\n" << flat.out;
}

TEST_F(Mesh_cad_program, tells_causes_in_whole_sentences)
{
  BRepTools::Write(BRepPrimAPI_MakeCylinder(1, 2).Shape(), file("cylinder.brep").c_str());
  const Result result = run("cylinder.brep --min-edge 0.3 --max-edge 0.5");
  EXPECT_NE(result.out.find(" too coarse for the curvature"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find(": edges there are as short as they may be, 0.3; a smaller --min-edge lets them be"), std::string::npos)
    << result.out;
  EXPECT_NE(result.out.find("  WRONG: the mesh is much farther from the shape than allowed"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("  verdict: something is WRONG with the mesh"), std::string::npos) << result.out;
  EXPECT_EQ(result.status, 1);
}

TEST_F(Mesh_cad_program, leaves_out_measuring)
{
  BRepTools::Write(BRepPrimAPI_MakeCylinder(1, 2).Shape(), file("cylinder.brep").c_str());
  // it is too coarse for the distance, which nobody has measured
  const Result result = run("cylinder.brep --min-edge 0.3 --max-edge 0.5 --order 2 --no-measure --json numbers.json");
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find("  distance from the shape: not measured, "), std::string::npos) << result.out;
  EXPECT_EQ(result.out.find("edge lengths: "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("nothing wrong was found, but this was not looked at: the distance from the shape\n"), std::string::npos)
    << result.out;
  const auto numbers = nlohmann::json::parse(content(file("numbers.json")));
  for(const char* number : {"distance", "distance_over_diagonal", "decided_by"})
    EXPECT_TRUE(numbers[number].is_null()) << number;
  EXPECT_TRUE(numbers["second_order"]["distance"].is_null());
  EXPECT_GT(numbers["min_angle"], 20);
}

TEST_F(Mesh_cad_program, shows_progress_on_a_terminal)
{
  const Result result = run_on_terminal("box.brep --max-edge 0.02");
  EXPECT_EQ(result.status, 0);
  for(const char* words : {"face ", " of 6: ", " vertices", "looking for self-intersections", "measuring"})
    EXPECT_NE(result.err.find(words), std::string::npos) << words << "\n" << result.err;
  EXPECT_EQ(run_on_terminal("box.brep --quiet").err, "");
}

TEST_F(Mesh_cad_program, follows_sizes)
{
  const std::size_t coarse = json("box.step --quiet --max-edge 1")["triangles"], fine = json("box.step --quiet --max-edge 0.05")["triangles"],
                    one = json("box.step --quiet --max-edge 1 --face-size 1:0.05")["triangles"],
                    edge = json("box.step --quiet --max-edge 1 --edge-size 1:0.05")["triangles"];
  EXPECT_LT(50 * coarse, fine);
  EXPECT_LT(10 * coarse, one);
  EXPECT_LT(one, fine);
  EXPECT_LT(2 * coarse, edge);
}

// On the mantle of a cylinder curvature decides, on a flat box the maximum edge.
TEST_F(Mesh_cad_program, follows_the_fineness)
{
  BRepTools::Write(BRepPrimAPI_MakeCylinder(1, 2).Shape(), file("cylinder.brep").c_str());
  const auto numbers = [this](const std::string& options) { return json("cylinder.brep --quiet " + options); };
  const nlohmann::json coarse = numbers("--fineness coarse"), normal = numbers("--fineness normal"), fine = numbers("--fineness fine");
  EXPECT_LT(1.5 * coarse["triangles"].get<double>(), normal["triangles"].get<double>());
  EXPECT_LT(1.5 * normal["triangles"].get<double>(), fine["triangles"].get<double>());
  EXPECT_EQ(normal["triangles"], numbers("")["triangles"]);
  EXPECT_NEAR(numbers("--elements-per-turn 16")["gamma"], 0.049, 1e-3);
  EXPECT_EQ(numbers("--fineness coarse --gamma 0.05")["gamma"], 0.05);
  double sum = 0;
  for(const auto& share : normal["decided_by"])
    sum += share.get<double>();
  EXPECT_NEAR(sum, 1, 1e-9);
  EXPECT_EQ(normal["decided_by"]["gamma"].get<double>() + normal["decided_by"]["distance"].get<double>() > 0.1, true);
  EXPECT_EQ(json("box.step --quiet")["decided_by"]["gamma"], 0);
}

TEST_F(Mesh_cad_program, follows_the_unit)
{
  EXPECT_NEAR(json("box.step --quiet --unit M")["area"], 22e-6, 1e-12);
  EXPECT_NEAR(json("box.step --quiet --unit cm")["area"], 22e-2, 1e-8);
  STEPControl_Writer step;
  step.Transfer(BRepPrimAPI_MakeCylinder(1, 2).Shape(), STEPControl_AsIs);
  step.Write(file("round.step").c_str());
  const auto in_millimetres = json("round.step --quiet --max-edge 0.2"), in_kilometres = json("round.step --quiet --unit KM --max-edge 2e-7");
  for(const char* number : {"faces", "meshed_faces", "triangles", "closed"})
    EXPECT_EQ(in_kilometres[number], in_millimetres[number]) << number;
  for(const char* length : {"diagonal", "max_edge", "min_edge", "distance"})
    EXPECT_NEAR(in_kilometres[length], 1e-6 * in_millimetres[length].get<double>(), 1e-12) << length;
  EXPECT_NEAR(in_kilometres["area"], 1e-12 * in_millimetres["area"].get<double>(), 1e-16);
}

TEST_F(Mesh_cad_program, meshes_some_faces_only)
{
  const nlohmann::json numbers = json("box.step --quiet --faces 1,3-4");
  EXPECT_EQ(numbers["meshed_faces"], 3);
  EXPECT_FALSE(numbers["closed"]);
}

TEST_F(Mesh_cad_program, leaves_out_faces_that_cannot_be_meshed)
{
  write_dirty_file("dirty.brep");
  const Result result = run("dirty.brep --out dirty.off --json dirty.json");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("  WRONG: face 1 is left out: the boundary crosses"), std::string::npos) << result.out;
  EXPECT_NEAR(volume("dirty.off"), 6, 1e-9);
  const auto numbers = nlohmann::json::parse(content(file("dirty.json")));
  ASSERT_EQ(numbers["left_out"].size(), 1u);
  EXPECT_EQ(numbers["left_out"][0]["face"], 1);
}

TEST_F(Mesh_cad_program, closes_up_narrow_faces)
{
  BRepBuilderAPI_MakePolygon polygon;
  for(const gp_Pnt& p : {gp_Pnt(0, 0, 0), gp_Pnt(2, 0, 0), gp_Pnt(2, 1, 0), gp_Pnt(2 - 1e-6, 1 + 1e-7, 0), gp_Pnt(0, 1, 0)})
    polygon.Add(p);
  polygon.Close();
  BRepTools::Write(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Face(), gp_Vec(0, 0, 3)).Shape(),
                   file("narrow.brep").c_str());
  const Result result = run("narrow.brep --out narrow.off --json narrow.json");
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find("is closed up: it is nowhere wider than 1"), std::string::npos) << result.out;
  EXPECT_NEAR(volume("narrow.off"), 6, 1e-5);
  const auto numbers = nlohmann::json::parse(content(file("narrow.json")));
  EXPECT_EQ(numbers["faces"], 7);
  EXPECT_EQ(numbers["meshed_faces"], 6);
  EXPECT_TRUE(numbers["left_out"].empty());
  EXPECT_TRUE(numbers["closed"]);
  EXPECT_EQ(numbers["below_10"], 0);
  EXPECT_EQ(numbers["collapsed_edges"].size(), 2u);
  ASSERT_EQ(numbers["closed_up"].size(), 1u);
  EXPECT_NEAR(numbers["closed_up"][0]["width"], 1e-6, 1e-7);
  const std::string face = std::to_string(numbers["closed_up"][0]["face"].get<int>());
  const Result alone = run("narrow.brep --faces " + face);
  EXPECT_EQ(alone.status, 2);
  EXPECT_NE(alone.err.find("face " + face + " is closed up"), std::string::npos) << alone.err;
}

// A step of a ten-thousandth of the diagonal
TEST_F(Mesh_cad_program, lists_detail_that_vanishes)
{
  BRepBuilderAPI_MakePolygon polygon;
  for(const gp_Pnt& p : {gp_Pnt(0, 0, 0), gp_Pnt(6, 0, 0), gp_Pnt(6, 0, 2), gp_Pnt(3, 0, 2), gp_Pnt(3, 0, 2.0005), gp_Pnt(0, 0, 2.0005)})
    polygon.Add(p);
  polygon.Close();
  BRepTools::Write(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(polygon.Wire()).Face(), gp_Vec(0, 4, 0)).Shape(), file("step.brep").c_str());
  const auto without = json("step.brep --quiet"), with = json("step.brep --quiet --keep-detail"),
             narrow = json("step.brep --quiet --detail 0.0001");
  EXPECT_LT(with["min_angle"], 10);
  EXPECT_TRUE(with["removed_details"].empty());
  EXPECT_TRUE(narrow["removed_details"].empty());
  EXPECT_LT(without["below_10"], with["below_10"]);
  EXPECT_TRUE(without["closed"]);
  ASSERT_FALSE(without["removed_details"].empty());
  for(const auto& detail : without["removed_details"]) {
    EXPECT_GE(detail["moved"], 0.0005 * (1 - 1e-9));
    EXPECT_LE(detail["moved"], 0.75 * 5e-4 * without["diagonal"].get<double>());
    EXPECT_NEAR(detail["place"][0], 3, 1e-9);
  }
  expect_refused("step.brep --detail 0.1 --keep-detail", "--keep-detail");
}

// A rectangle with a round hole that touches it in a vertex: two cusps, each with one sharp triangle.
TEST_F(Mesh_cad_program, knows_corners_where_loops_touch)
{
  const auto vertex = [](double x, double y) { return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, 0)).Vertex(); };
  const std::vector<TopoDS_Vertex> v{vertex(-10, -6), vertex(0, -6), vertex(10, -6), vertex(10, 6), vertex(-10, 6)};
  BRep_Builder builder;
  TopoDS_Wire outline, hole;
  builder.MakeWire(outline);
  builder.MakeWire(hole);
  for(std::size_t i = 0; i < v.size(); ++i)
    builder.Add(outline, BRepBuilderAPI_MakeEdge(v[i], v[(i + 1) % v.size()]).Edge());
  const gp_Circ circle(gp_Ax2(gp_Pnt(0, -3, 0), gp_Dir(0, 0, -1), gp_Dir(0, -1, 0)), 3);
  builder.Add(hole, BRepBuilderAPI_MakeEdge(circle, v[1], v[1]).Edge());
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Pln()), 1e-7);
  builder.Add(face, outline);
  builder.Add(face, hole);
  BRepTools::Write(face, file("touch.brep").c_str());
  const auto numbers = json("touch.brep --quiet");
  EXPECT_EQ(numbers["below_10"], 2);
  EXPECT_EQ(numbers["below_10_at_corners"], 2);
  EXPECT_GT(numbers["min_angle_apart_from_corners"], 20);
}

// Coarse facets of a thin pipe pass through each other; its seams are not side by side, so that these are not, either.
TEST_F(Mesh_cad_program, meshes_thin_walls_apart)
{
  const TopoDS_Shape inside = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp::DZ(), gp_Dir(3, 1, 0)), 5, 20).Shape();
  BRepTools::Write(BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(5.05, 20).Shape(), inside).Shape(), file("pipe.brep").c_str());
  const std::string options
    = "pipe.brep --gamma 0.5 --relative-distance 0.05 --closeness 1000 --max-edge 4 --json pipe.json --out pipe.off";
  const Result reported = run(options + " --self-intersections report");
  EXPECT_EQ(1, reported.status) << reported.err;
  EXPECT_NE(std::string::npos, reported.out.find("  WRONG: the mesh intersects itself: faces "));
  const auto intersections = [&] { return nlohmann::json::parse(content(file("pipe.json")))["self_intersections"]; };
  ASSERT_EQ(1u, intersections().size());
  EXPECT_FALSE(intersections()[0]["of_shape"].get<bool>());
  EXPECT_EQ(0, run(options + " --self-intersections refine").status);
  EXPECT_EQ(0u, intersections().size());
  const Result ignored = run(options + " --self-intersections ignore");
  EXPECT_EQ(0, ignored.status);
  EXPECT_NE(std::string::npos, ignored.out.find("but this was not looked at: whether the mesh intersects itself\n"));
}

TEST_F(Mesh_cad_program, sews_the_faces_of_an_iges_file)
{
  IGESControl_Writer iges;
  iges.AddShape(box());
  iges.Write(file("box.iges").c_str());
  const nlohmann::json sewn = json("box.iges --quiet --out sewn.off"), loose = json("box.iges --quiet --sew 0");
  EXPECT_EQ(sewn["sewn_edges"], 12);
  EXPECT_EQ(sewn["lost_faces"], 0);
  EXPECT_EQ(sewn["closed"], true);
  EXPECT_EQ(sewn["shape_closed"], true);
  EXPECT_NEAR(volume("sewn.off"), 6, 1e-6);
  EXPECT_EQ(loose["sewn_edges"], 0);
  EXPECT_EQ(loose["closed"], false);
  EXPECT_EQ(json("box.brep --quiet")["sewn_edges"], 0); // has common edges already
  expect_refused("box.iges --sew -1", "--sew");
}

TEST_F(Mesh_cad_program, spheres_ask_for_small_edges)
{
  const auto mean_area = [this](const std::string& options) {
    const nlohmann::json numbers = json("box.brep --quiet --max-edge 0.5 " + options);
    return numbers["area"].get<double>() / numbers["triangles"].get<double>();
  };
  const double small = mean_area("--sphere-size 0,0,0,100:0.1"); // all of it
  EXPECT_NEAR(small, 0.25 * std::sqrt(3.) * 0.01, 0.003);
  EXPECT_LT(mean_area("--sphere-size 0,0,0,0.2:0.05"), 0.8 * mean_area(""));
  EXPECT_LT(mean_area("--sphere-size 0,0,0,0.2:0.05 --sphere-size 1,2,3,0.2:0.05"), 0.8 * mean_area("--sphere-size 0,0,0,0.2:0.05"));
  for(const char* sphere : {"0,0,0:1", "0,0,0,1", "0,0,0,1:0", "0,0,0,-1:1", "0,0,0,1:x", "0,0,0,1:1:1", "0,0,nan,1:1", "0,0,0,1:1e-9"})
    expect_refused(std::string("box.brep --sphere-size ") + sphere, "--sphere-size");
}

TEST_F(Mesh_cad_program, lets_layers_fit_into_walls)
{
  BRepTools::Write(BRepPrimAPI_MakeBox(4, 4, 0.5).Shape(), file("plate.brep").c_str());
  const nlohmann::json plain = json("plate.brep --quiet"), layers = json("plate.brep --quiet --layers 3 --out plate.off");
  EXPECT_NEAR(0.5 / 3 / 1.4, layers["layers"]["smallest_length"].get<double>(), 1e-9);
  EXPECT_FALSE(layers["layers"]["limited"].get<bool>());
  EXPECT_GT(layers["min_angle"].get<double>(), 25);
  Mesh mesh;
  ASSERT_TRUE(CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file("plate.off"), mesh));
  for(const auto e : mesh.edges())
    EXPECT_LT(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))), CGAL::square(1.15 * 0.5 / 3));
  EXPECT_GT(layers["triangles"].get<int>(), 2 * plain["triangles"].get<int>());
  EXPECT_TRUE(json("plate.brep --quiet --layers 30 --min-edge 0.05")["layers"]["limited"].get<bool>());
  expect_refused("box.brep --layers 0", "--layers");
}

// Of the triangles on the sides of a box around the origin.
TEST_F(Mesh_cad_program, sizes_in_parts_of_space_and_near_edges_and_vertices)
{
  const auto triangles = [this](const std::string& options) { return json("box.brep --quiet --max-edge 0.5 " + options)["triangles"].get<int>(); };
  const int plain = triangles("");
  for(const char* size : {"box:0,0,0,0.5,0.5,0.5:0.05", "box:0.5,0.5,0.5,0,0,0:0.05", "sphere:1,2,3,0.1:0.05:0.5", "cylinder:0,0,0,0,0,3,0.1:0.05", "point:1,2,3:0.05",
                          "face:1:0.1", "edge:12:0.05:0.5", "vertex:8:0.05"})
    EXPECT_GT(triangles(std::string("--local-size ") + size), 1.2 * plain) << size;
  EXPECT_EQ(triangles("--local-size box:5,5,5,6,6,6:0.5"), plain); // no edge is longer
  EXPECT_EQ(triangles("--local-size sphere:0,0,0,0.2:0.05"), triangles("--sphere-size 0,0,0,0.2:0.05"));
  for(const char* size : {"box:0,0,0,1,1:1", "box:0,0,0,1,1,1", "sphere:0,0,0,-1:1", "cone:0,0,0:1", "cylinder:0,0,0,0,0,0,1:1", "point:0,0,0:0", "point:0,0,x:1", "point:0,0,0:1:-1",
                          "point:0,0,0:1:11", "point:0,0,0:1:1:1", "face::1", "face:1", "face:7:1", "edge:13:1", "vertex:9:1", "vertex:x:1", "point:0,0,0:1e-9", "", ":", "::::"})
    expect_refused(std::string("box.brep --local-size '") + size + "'", "--local-size");
}

// A tetrahedron around the box, with small edges at one of its corners.
TEST_F(Mesh_cad_program, takes_sizes_from_the_nodes_of_a_mesh)
{
  const auto write = [this](const char* name, double unit) {
    std::ofstream out(file(name));
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n";
    for(const char* node : {"1 0 0 0", "2 10 0 0", "3 0 10 0", "4 0 0 10"}) {
      double number, x, y, z;
      std::istringstream(node) >> number >> x >> y >> z;
      out << number << " " << x / unit << " " << y / unit << " " << z / unit << "\n";
    }
    out << "$EndNodes\n$Elements\n1\n1 4 2 0 1 1 2 3 4\n$EndElements\n";
    for(const char* data : {"size", "other"})
      out << "$NodeData\n1\n\"" << data << "\"\n1\n0.0\n3\n0\n1\n4\n1 " << 0.05 / unit << "\n2 " << 2 / unit << "\n3 " << 2 / unit << "\n4 " << 2 / unit
          << "\n$EndNodeData\n";
  };
  write("sizes.msh", 1);
  write("sizes_in_metres.msh", 1000);
  const auto triangles = [this](const std::string& options) { return json("box.brep --quiet --max-edge 0.5 " + options)["triangles"].get<int>(); };
  const int plain = triangles(""), finer = triangles("--size-field sizes.msh:size"), nearly = triangles("--local-size point:0,0,0:0.05:0.195");
  EXPECT_GT(finer, 1.3 * plain);
  EXPECT_NEAR(finer, nearly, 0.5 * nearly); // which measures distances by another norm
  EXPECT_GT(triangles("--size-field sizes.msh:other --local-size point:1,2,3:0.05"), finer);
  EXPECT_NEAR(json("box.step --quiet --unit M --max-edge 0.0005 --size-field sizes_in_metres.msh:size")["triangles"].get<int>(), finer, 0.05 * finer);
  expect_refused("box.brep --size-field sizes.msh", "'size', 'other'");
  expect_refused("box.brep --size-field sizes.msh:strain", "no values 'strain'");
  expect_refused("box.brep --size-field nowhere.msh", "cannot be opened");
  expect_refused("box.brep --min-edge 0.1 --size-field sizes.msh:size", "--size-field: the length 0.05 is below");
}

TEST_F(Mesh_cad_program, heals) { EXPECT_EQ(run("box.step --heal --out healed.off").status, 0); }

TEST_F(Mesh_cad_program, draws)
{
  EXPECT_EQ(run("box.step --quiet --picture box.svg").status, 0);
  EXPECT_NE(content(file("box.svg")).find("<svg"), std::string::npos);
}

TEST_F(Mesh_cad_program, refuses_what_it_cannot_do)
{
  std::ofstream(file("garbage.step")) << "garbage\n";
  std::ofstream(file("garbage.brep")) << "garbage\n";
  expect_refused("", "no input file");
  expect_refused("nowhere.step --out a.off", "cannot open");
  expect_refused("garbage.step --out a.off", "as STEP");
  expect_refused("garbage.brep --out a.off", "as BREP");
  expect_refused("box.txt --out a.off", "cannot open");
  expect_refused("box.step box.brep", "more than one");
  expect_refused("box.step --out a.xyz", "must end in .off, .obj");
  expect_refused("box.step --angle 60", "--angle: 60 must be an angle in degrees that is at least 0 and below 60");
  expect_refused("box.step --max-edge -1", "--max-edge: -1 must be a finite number greater than 0");
  expect_refused("box.step --max-edge 1 --min-edge 2", "--min-edge: 2 must be at most the length of --max-edge, 1");
  expect_refused("box.step --growth 11", "--growth: 11 must be a number that is at least 0 and below 10");
  expect_refused("box.step --layers 2000", "--layers: 2000 must be a number of at least 1 and at most 1000");
  expect_refused("box.step --sew -2", "--sew: -2 must be a finite number of at least 0");
  expect_refused("box.step --conformal --fuzzy nan", "--fuzzy: nan must be a finite number of at least 0");
  expect_refused("box.step --threads -1", "--threads: -1 must be a whole number from 1 to 1024");
  expect_refused("box.step --sweeps 1001", "--sweeps: 1001 must be a whole number from 0 to 1000");
  expect_refused("box.step --order 3", "--order: 3 must be a whole number from 1 to 2");
  expect_refused("box.step --faces 7", "there is no face 7");
  expect_refused("box.step --faces 3-1", "ascending");
  expect_refused("box.step --face-size 1", "--face-size");
  expect_refused("box.step --edge-size 99:1", "there is no edge 99");
  expect_refused("box.step --unit PARSEC", "not a unit");
  expect_refused("box.step --fineness ultra", "must be coarse, normal or fine");
  expect_refused("box.step --elements-per-turn 2", "--elements-per-turn: 2 must be a number of at least 3 and at most 1000000");
  expect_refused("box.step --elements-per-turn 20 --gamma 0.1", "exclude each other");
  expect_refused("box.step --edge-size 1:1e-9", "is below that of --min-edge");
  expect_refused("box.step --face-size 1:1e-9", "is below that of --min-edge");
  expect_refused("box.step --out nowhere/a.off", "cannot write");
}

} // namespace
