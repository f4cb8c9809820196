// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program mesh_cad from outside: names, parts of assemblies, and groups in files. Other programs read these; without them a test is skipped.
#include "Named_assembly.h"
#include "program_test.h"

#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepTools.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <TopoDS_Compound.hxx>
#include <BRep_Builder.hxx>
#include <TopTools_ListOfShape.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

class Mesh_cad_groups : public Program_test
{
protected:
  Mesh_cad_groups() : Program_test(MESH_CAD_PROGRAM) {}

  void SetUp() override
  {
    Program_test::SetUp();
    write_named_assembly(file("bridge.step"));
  }

  // The boxes from 0 to 1 and from 1 to 2.
  void write_two_boxes(const std::string& name) const
  {
    BRepAlgoAPI_Splitter splitter;
    TopTools_ListOfShape arguments, tools;
    arguments.Append(BRepPrimAPI_MakeBox(2, 1, 1).Shape());
    tools.Append(BRepPrimAPI_MakeBox(gp_Pnt(1, -1, -1), 3, 3, 3).Shape());
    splitter.SetArguments(arguments);
    splitter.SetTools(tools);
    splitter.Build();
    BRepTools::Write(splitter.Shape(), file(name).c_str());
  }

  static bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
};

TEST_F(Mesh_cad_groups, lists_parts)
{
  const Result result = run("bridge.step --list --json list.json");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(has(result.out, "8 parts, 5 solids, 27 faces")) << result.out;
  EXPECT_TRUE(has(result.out, "30 x 10 x 9  bridge")) << result.out;
  EXPECT_TRUE(has(result.out, "10 x 10 x 1    right plate (pl\xc3\xa4te), steel, #808080, layer steel parts")) << result.out;
  EXPECT_TRUE(has(result.out, "      pin, the only one (pin), #0000ff")) << result.out;
  EXPECT_TRUE(has(result.out, "face 'top': ")) << result.out;
  const auto list = nlohmann::json::parse(content(file("list.json")));
  EXPECT_EQ(list["parts"].size(), 8u);
  EXPECT_FALSE(list.contains("triangles"));
  EXPECT_TRUE(has(run("bridge.step --list --unit CM").out, "3 x 1 x 0.9  bridge"));
  BRepTools::Write(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), file("box.brep").c_str());
  EXPECT_TRUE(has(run("box.brep --list").out, "1 x 2 x 3  box"));
}

TEST_F(Mesh_cad_groups, lists_faces)
{
  const Result result = run("bridge.step --list-faces --json list.json");
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(has(result.out, "8 parts, 5 solids, 27 faces")) << result.out;
  EXPECT_TRUE(has(result.out, "bridge/left plate, 'top'")) << result.out;
  const auto list = nlohmann::json::parse(content(file("list.json")))["face_list"];
  ASSERT_EQ(list.size(), 27u);
  std::map<std::string, int> kinds;
  for(const auto& face : list) {
    ++kinds[face["kind"].get<std::string>()];
    if(face["kind"] == "cylinder") {
      EXPECT_NEAR(face["area"].get<double>(), 3 * std::acos(-1.), 1e-9);
      EXPECT_NEAR(face["radius"].get<double>(), 0.5, 1e-9);
      EXPECT_NEAR(face["center"][2].get<double>(), 2.5, 1e-9);
      EXPECT_EQ(face["part"], 8);
    }
    else if(face.contains("name")) {
      EXPECT_EQ(face["name"], "top");
      EXPECT_NEAR(face["area"].get<double>(), 100, 1e-9);
      EXPECT_NEAR(face["center"][2].get<double>(), 1, 1e-9);
      EXPECT_NEAR(face["direction"][2].get<double>(), 1, 1e-9);
    }
  }
  EXPECT_EQ(kinds, (std::map<std::string, int>{{"plane", 26}, {"cylinder", 1}}));
  const auto in_metres = json("bridge.step --quiet --unit M")["face_list"];
  for(std::size_t f = 0; f < list.size(); ++f)
    EXPECT_NEAR(in_metres[f]["area"].get<double>(), 1e-6 * list[f]["area"].get<double>(), 1e-12);
  expect_refused("bridge.step --list-faces --out bridge.off", "--list-faces");
}

TEST_F(Mesh_cad_groups, meshes_some_parts)
{
  const auto faces = [this](const std::string& parts) {
    const nlohmann::json numbers = json("bridge.step --quiet --parts " + parts);
    EXPECT_TRUE(numbers["closed"]) << parts;
    return numbers["meshed_faces"].get<int>();
  };
  EXPECT_EQ(faces("'left plate'"), 6);
  EXPECT_EQ(faces("pl\xc3\xa4te"), 12);            // the product, used twice
  EXPECT_EQ(faces("bridge/column"), 12);
  EXPECT_EQ(faces("solid_3,fastener"), 9);
  EXPECT_EQ(faces("'pin, the only one'"), 3);
  EXPECT_EQ(faces("2 --parts 4"), 18);
  for(const char* list : {"''", "column,", ",column"})
    EXPECT_EQ(run(std::string("bridge.step --parts ") + list).status, 2) << list; // an empty name is none
  const Result unknown = run("bridge.step --parts column,nail");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(has(unknown.err, "there is no part 'nail'; the parts are 1 bridge, 2 bridge/left plate")) << unknown.err;
}

TEST_F(Mesh_cad_groups, meshes_faces_with_names)
{
  const auto faces = [this](const std::string& list) { return json("bridge.step --quiet --faces " + list)["meshed_faces"].get<int>(); };
  EXPECT_EQ(faces("top"), 2);
  EXPECT_EQ(faces("column"), 12);                 // of a part
  EXPECT_EQ(faces("'pin, the only one'"), 3);     // a name with a comma
  EXPECT_EQ(faces("top,'left plate',25-27"), 10); // one of the two is in the plate
  EXPECT_TRUE(has(run("bridge.step --faces top,bottom").err, "there is no face 'bottom'"));
  EXPECT_TRUE(has(run("bridge.step --faces top,28").err, "there is no face 28, the shape has 27 faces"));
  expect_refused("bridge.step --faces ''", "--faces");
  expect_refused("bridge.step --faces top,", "--faces");
}

TEST_F(Mesh_cad_groups, names_stand_for_faces_and_edges_in_sizes)
{
  const auto triangles = [this](const std::string& options) { return json("bridge.step --quiet --max-edge 2 " + options)["triangles"].get<int>(); };
  const int plain = triangles(""), top = triangles("--face-size top:0.5"), pin = triangles("--face-size 'pin, the only one:0.05'");
  EXPECT_GT(top, plain + 1000); // two faces of 10 x 10
  EXPECT_GT(pin, plain);
  EXPECT_GT(triangles("--face-size top:0.5,pin:0.05"), (std::max)(top, pin));
  EXPECT_GT(triangles("--edge-size top:0.5"), plain);
  EXPECT_GT(triangles("--edge-size 'left plate:0.5'"), plain);
  expect_refused("bridge.step --face-size bottom:0.5", "there is no face 'bottom'");
  expect_refused("bridge.step --edge-size bottom:0.5", "there is no edge 'bottom'");
  expect_refused("bridge.step --face-size top:x", "--face-size");
}

TEST_F(Mesh_cad_groups, sizes_near_what_has_a_name)
{
  const auto triangles = [this](const std::string& options) { return json("bridge.step --quiet --max-edge 2 " + options)["triangles"].get<int>(); };
  const int plain = triangles(""), face = triangles("--local-size face:top:0.5:1"), part = triangles("--local-size part:column:0.5:1");
  EXPECT_GT(face, plain + 1000);
  EXPECT_GT(part, plain);
  EXPECT_GT(triangles("--local-size face:top:0.5:0.1"), face); // grows slower
  EXPECT_GT(triangles("--local-size face:top:0.5:1 --local-size part:column:0.5:1"), (std::max)(face, part));
  EXPECT_EQ(triangles("--local-size face:top:0.5:1 --local-size sphere:0,0,0,1000:2"), face); // the least counts
  EXPECT_GT(triangles("--parts 'left plate' --local-size part:column:0.5"), triangles("--parts 'left plate'")); // near what is not meshed
  EXPECT_EQ(json("bridge.step --quiet --unit M --max-edge 0.002 --local-size face:top:0.0005:1")["triangles"], face);
  expect_refused("bridge.step --local-size face:bottom:0.5", "there is no face 'bottom'");
  expect_refused("bridge.step --local-size part:nail:0.5", "there is no part 'nail'");
}

TEST_F(Mesh_cad_groups, names_in_numbers)
{
  const nlohmann::json numbers = json("bridge.step --quiet --max-edge 5");
  EXPECT_EQ(numbers["parts"].size(), 8u);
  const auto& pin = numbers["parts"][7];
  EXPECT_EQ(pin["path"], "bridge/fastener/pin, the only one");
  EXPECT_EQ(pin["parent"], 7);
  EXPECT_EQ(pin["color"]["rgb"], "#0000ff");
  EXPECT_EQ(pin["location"][3], 25);
  EXPECT_EQ(pin["faces"].size(), 3u);
  EXPECT_EQ(numbers["parts"][1]["material"]["name"], "steel");
  ASSERT_EQ(numbers["face_names"].size(), 2u);
  for(const auto& face : numbers["face_names"].items()) {
    EXPECT_EQ(face.value(), "top");
    EXPECT_EQ(numbers["face_colors"][face.key()]["rgb"], "#ff0000");
  }
  EXPECT_EQ(json("bridge.step --quiet --max-edge 0.005 --unit M")["parts"][7]["location"][3], 0.025);
}

// Two boxes with a common face.
TEST_F(Mesh_cad_groups, a_face_between_two_parts)
{
  write_two_boxes("two.brep");
  for(const char* parts : {"", "--parts solid_1", "--parts solid_2"}) {
    const nlohmann::json numbers = json(std::string("two.brep --quiet ") + parts);
    EXPECT_EQ(numbers["meshed_faces"], *parts == 0 ? 11 : 6) << parts;
    EXPECT_TRUE(numbers["closed"]) << parts;
  }
  ASSERT_EQ(run("two.brep --quiet --out two.inp").status, 0);
  const std::string inp = content(file("two.inp"));
  const std::string solid_1 = inp.substr(inp.find("*ELSET, ELSET=SOLID_1\n")), solid_2 = inp.substr(inp.find("*ELSET, ELSET=SOLID_2\n"));
  std::set<std::string> faces[2];
  for(const std::string* solid : {&solid_1, &solid_2}) {
    std::istringstream names(solid->substr(solid->find('\n')));
    for(std::string name; names >> name && name.compare(0, 5, "FACE_") == 0;)
      EXPECT_TRUE(faces[solid == &solid_2].insert(name).second);
  }
  EXPECT_EQ(faces[0].size(), 6u);
  EXPECT_EQ(faces[1].size(), 6u);
  faces[0].insert(faces[1].begin(), faces[1].end());
  EXPECT_EQ(faces[0].size(), 11u); // one is in both
  EXPECT_TRUE(has(inp, "*ELSET, ELSET=SOLID_1\n"));
  EXPECT_TRUE(has(inp, "*ELSET, ELSET=SOLID_2\n"));
}

// Boxes that touch, overlap, and nearly touch, without knowing of each other.
TEST_F(Mesh_cad_groups, parts_that_touch)
{
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for(const gp_Pnt& corner : {gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0), gp_Pnt(19, 0, 0), gp_Pnt(0, 10.01, 0)})
    builder.Add(compound, BRepPrimAPI_MakeBox(corner, 10, 10, 10).Shape());
  BRepTools::Write(compound, file("boxes.brep").c_str());
  EXPECT_EQ(json("boxes.brep --quiet")["contacts"].size(), 0u);
  const nlohmann::json numbers = json("boxes.brep --quiet --conformal"), contacts = numbers["contacts"];
  EXPECT_TRUE(numbers["closed"]);
  ASSERT_EQ(contacts.size(), 4u); // the second box is beside an edge of the last one, too
  EXPECT_EQ(contacts[0]["parts"], nlohmann::json({"boxes/solid_1", "boxes/solid_2"}));
  EXPECT_NEAR(contacts[0]["area"], 100, 1e-6);
  EXPECT_NEAR(contacts[1]["distance"], 0.01, 1e-6); // of the first box and the last one
  EXPECT_NEAR(contacts[2]["common_volume"], 100, 1e-6);
  EXPECT_EQ(json("boxes.brep --quiet --conformal --fuzzy 0.02")["contacts"][1]["faces"], 1);
  const std::string summary = run("boxes.brep --conformal").out;
  EXPECT_TRUE(has(summary, "parts boxes/solid_1 and boxes/solid_4 do not touch: they are 0.01 apart")) << summary;
  EXPECT_TRUE(has(summary, "parts boxes/solid_2 and boxes/solid_3 overlap: they have a volume of 100 in common")) << summary;
  EXPECT_EQ(run("boxes.brep --fuzzy 0.1").status, 2);
}

TEST_F(Mesh_cad_groups, gmsh_fills_a_part)
{
  if(!succeeds("command -v gmsh"))
    GTEST_SKIP() << "gmsh is not installed";
  ASSERT_EQ(run("bridge.step --quiet --node-parameters --out bridge.msh").status, 0);
  const std::string msh = content(file("bridge.msh")), name = " \"right plate\"";
  const std::size_t end = msh.find(name), begin = msh.rfind('\n', end) + 1;
  ASSERT_NE(end, std::string::npos);
  EXPECT_EQ(msh.substr(begin, 2), "2 ");
  const std::string tag = msh.substr(begin + 2, end - begin - 2);
  std::ofstream(file("bridge.geo")) << "Merge \"bridge.msh\";\nSurface Loop(1) = Physical Surface {" << tag
                                    << "};\nVolume(1) = {1};\nPhysical Volume(\"filled\") = {1};\n";
  EXPECT_TRUE(succeeds("cd " + file("") + " && gmsh bridge.geo -3 -format msh22 -o filled.msh"));
  const std::string filled = content(file("filled.msh"));
  for(const char* group : {"filled", "right plate", "pl\xc3\xa4te", "top", "face_1", "color_ff0000", "layer_steel parts", "column", "edge_1", "vertex_1"})
    EXPECT_EQ(has(filled, std::string("\"") + group + "\""), group != std::string("pl\xc3\xa4te")) << group;
  std::istringstream lines(filled.substr(filled.find("$Elements")));
  std::map<int, std::size_t> number_by_type;
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  while(std::getline(lines, line) && line.front() != '$') {
    std::istringstream element(line);
    int number = 0, type = 0;
    element >> number >> type;
    ++number_by_type[type];
  }
  EXPECT_GT(number_by_type[4], 100u); // tetrahedra
  EXPECT_GT(number_by_type[2], 0u);
}

// Two boxes with a common face, whose tetrahedra fit together: one complex of nodes.
TEST_F(Mesh_cad_groups, gmsh_fills_parts_that_share_a_face)
{
  if(!succeeds("command -v gmsh"))
    GTEST_SKIP() << "gmsh is not installed";
  write_two_boxes("two.brep");
  ASSERT_EQ(run("two.brep --quiet --max-edge 0.3 --out two.msh").status, 0);
  const std::string msh = content(file("two.msh"));
  std::string loops;
  for(int solid : {1, 2}) {
    const std::size_t end = msh.find(" \"solid_" + std::to_string(solid)), begin = msh.rfind("\n2 ", end) + 3;
    ASSERT_NE(end, std::string::npos);
    const std::string number = std::to_string(solid);
    loops += "Surface Loop(" + number + ") = Physical Surface {" + msh.substr(begin, end - begin) + "};\nVolume(" + number + ") = {" + number + "};\n";
  }
  std::ofstream(file("two.geo")) << "Merge \"two.msh\";\n" << loops << "Physical Volume(\"both\") = {1, 2};\n";
  ASSERT_TRUE(succeeds("cd " + file("") + " && gmsh two.geo -3 -format msh22 -setnumber Mesh.SaveAll 1 -o filled.msh"));
  std::map<std::set<std::size_t>, int> uses; // of sides of tetrahedra
  std::size_t number_of_triangles = 0;
  std::istringstream lines(content(file("filled.msh")));
  for(std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::vector<std::size_t> element;
    for(std::size_t word; words >> word;)
      element.push_back(word);
    if(element.size() == 9 && element[1] == 4)
      for(std::size_t i = 5; i < 9; ++i) {
        std::set<std::size_t> side(element.begin() + 5, element.end());
        side.erase(element[i]);
        ++uses[side];
      }
    number_of_triangles += element.size() == 8 && element[1] == 2;
  }
  EXPECT_GT(uses.size(), 100u);
  std::size_t number_on_border = 0;
  for(const auto& side : uses)
    number_on_border += side.second == 1;
  const std::size_t number_of_sides = json("two.brep --quiet --max-edge 0.3")["triangles"];
  EXPECT_LT(number_of_triangles, number_of_sides); // which has both sides of the common face
  EXPECT_EQ(number_on_border, 2 * number_of_triangles - number_of_sides);
}

// A point above the top of a box, and a line on it: sets of the files, on the surface of the tetrahedra.
TEST_F(Mesh_cad_groups, points_and_curves_on_faces)
{
  BRepTools::Write(BRepPrimAPI_MakeBox(4, 4, 4).Shape(), file("box.brep").c_str());
  BRepTools::Write(BRepBuilderAPI_MakeEdge(gp_Pnt(1, 1, 4), gp_Pnt(3, 2, 4)).Edge(), file("line.brep").c_str());
  const std::string options = "box.brep --point 1,3,4.1 --curves line.brep ";
  const nlohmann::json numbers = json(options);
  EXPECT_TRUE(numbers["closed"]);
  ASSERT_EQ(numbers["imprints"].size(), 2u);
  EXPECT_NEAR(numbers["imprints"][0]["distance"].get<double>(), 0.1, 1e-9);
  EXPECT_NEAR(numbers["imprints"][1]["projected_length"].get<double>(), std::sqrt(5), 1e-6);
  EXPECT_EQ(numbers["inner_edges"].size(), 1u);
  EXPECT_EQ(numbers["inner_vertices"].size(), 1u);
  EXPECT_TRUE(has(run(options).out, "the mesh follows 1 edge and 1 vertex inside faces"));
  ASSERT_EQ(run(options + "--quiet --out box.inp").status, 0);
  const std::string inp = content(file("box.inp"));
  EXPECT_TRUE(has(inp, "NSET=POINT_1")) << inp.substr(0, 300);
  EXPECT_TRUE(has(inp, "NSET=CURVE_1"));
  ASSERT_EQ(run(options + "--quiet --out box.msh").status, 0);
  EXPECT_TRUE(has(content(file("box.msh")), "\"curve_1\""));
  expect_refused("box.brep --point 1,3", "--point");
  expect_refused("box.brep --point 1,3,9", "away from the faces");
  expect_refused("box.brep --reach 1", "--reach");
  expect_refused("box.brep --curves none.brep", "none.brep");
  if(!succeeds("command -v gmsh"))
    GTEST_SKIP() << "gmsh is not installed";
  std::ofstream(file("box.geo")) << "Merge \"box.msh\";\nSurface Loop(1) = Surface {:};\nVolume(1) = {1};\nPhysical Volume(\"filled\") = {1};\n";
  EXPECT_TRUE(succeeds("cd " + file("") + " && gmsh box.geo -3 -format msh22 -o filled.msh"));
  const std::string filled = content(file("filled.msh"));
  for(const char* group : {"filled", "point_1", "curve_1"})
    EXPECT_TRUE(has(filled, std::string("\"") + group + "\"")) << group;
}

TEST_F(Mesh_cad_groups, meshio_reads_groups)
{
  if(!succeeds("/usr/bin/python3 -c 'import meshio'"))
    GTEST_SKIP() << "meshio is not installed";
  std::ofstream(file("read.py")) << "import json, meshio, sys\n"
                                    "m = meshio.read(sys.argv[1])\n"
                                    "json.dump({'points': len(m.points), 'cells': {c.type: len(c.data) for c in m.cells},\n"
                                    "  'sets': sorted(list(m.field_data) + list(m.cell_sets) + list(m.point_sets)),\n"
                                    "  'data': sorted(m.cell_data)}, open('read.json', 'w'))\n";
  const nlohmann::json numbers = json("bridge.step --quiet");
  for(const char* name : {"bridge.msh", "bridge2.msh", "bridge.inp"}) {
    const bool is_version_2 = name == std::string("bridge2.msh");
    ASSERT_EQ(run(std::string("bridge.step --quiet --out ") + (is_version_2 ? "bridge.msh2" : name)).status, 0);
    if(is_version_2)
      std::filesystem::rename(file("bridge.msh2"), file(name));
    ASSERT_TRUE(succeeds("cd " + file("") + " && /usr/bin/python3 read.py " + name)) << name;
    const auto read = nlohmann::json::parse(content(file("read.json")));
    EXPECT_EQ(read["points"], numbers["vertices"]) << name;
    const std::string text = read["sets"].dump();
    EXPECT_TRUE(has(text, name == std::string("bridge.inp") ? "\"RIGHT_PLATE\"" : "\"right plate\"")) << text;
    EXPECT_TRUE(has(text, name == std::string("bridge.inp") ? "\"TOP\"" : "\"top\"")) << text;
  }
}

TEST_F(Mesh_cad_groups, binary_files)
{
  const nlohmann::json numbers = json("bridge.step --quiet --binary --out bridge.stl");
  const std::size_t triangles = numbers["triangles"];
  EXPECT_EQ(std::filesystem::file_size(file("bridge.stl")), 84 + 50 * triangles);
  ASSERT_EQ(run("bridge.step --quiet --out text.stl").status, 0);
  const std::string stl = content(file("text.stl"));
  for(const char* solid : {"solid left plate\n", "solid right plate\n", "solid solid_3\n", "solid solid_4\n", "solid pin, the only one\n"})
    EXPECT_TRUE(has(stl, solid)) << solid;
  ASSERT_EQ(run("bridge.step --quiet --out bridge.vtu").status, 0);
  const std::string vtu = content(file("bridge.vtu"));
  for(const char* data : {"part_id", "color", "smallest_angle", "deviation", "curvature", "part_names", "face_names"})
    EXPECT_TRUE(has(vtu, std::string("Name=\"") + data + "\"")) << data;
  EXPECT_FALSE(has(vtu, "place_parameters"));
  ASSERT_EQ(run("bridge.step --quiet --out bridge.ply").status, 0);
  const std::string ply = content(file("bridge.ply"));
  for(const char* property : {"uint face_id", "uint part_id", "uchar red", "uchar green", "uchar blue"})
    EXPECT_TRUE(has(ply, std::string("property ") + property + "\n")) << property;
  ASSERT_EQ(run("bridge.step --quiet --node-parameters --out bridge.vtu").status, 0);
  EXPECT_TRUE(has(content(file("bridge.vtu")), "place_parameters"));
}

// A node for each part, and a material for each colour, in metres and with y upward.
TEST_F(Mesh_cad_groups, gltf)
{
  ASSERT_EQ(run("bridge.step --quiet --out bridge.glb").status, 0);
  const std::string glb = content(file("bridge.glb"));
  ASSERT_EQ(glb.substr(0, 4), "glTF");
  const auto byte = [&](std::size_t i) { return std::size_t(static_cast<unsigned char>(glb[i])); };
  const std::size_t length = byte(12) + 256 * byte(13) + 65536 * byte(14);
  const auto gltf = nlohmann::json::parse(glb.substr(20, length));
  std::set<std::string> names;
  for(const auto& node : gltf["nodes"])
    names.insert(node["name"].get<std::string>());
  EXPECT_EQ(names, (std::set<std::string>{"bridge", "left plate", "right plate", "solid_3", "solid_4", "pin, the only one"}));
  EXPECT_EQ(gltf["materials"].size(), 4u); // gray, red, blue, and that of faces without a colour
  double height = 0;
  for(const auto& accessor : gltf["accessors"])
    if(accessor.contains("max"))
      height = std::max(height, accessor["max"][1].get<double>());
  EXPECT_NEAR(height, 0.009, 1e-6);
}

// A plate with a fixed bottom and a pressure on its top, by their names. Pressure on a shell acts along its normal.
TEST_F(Mesh_cad_groups, calculix_runs_a_shell_job)
{
  if(!succeeds("command -v ccx"))
    GTEST_SKIP() << "CalculiX is not installed";
  ASSERT_EQ(run("bridge.step --quiet --max-edge 3 --parts 'left plate' --out plate.inp").status, 0);
  std::ofstream(file("job.inp")) << "*INCLUDE, INPUT=plate.inp\n*MATERIAL, NAME=STEEL\n*ELASTIC\n210000, 0.3\n"
                                    "*SHELL SECTION, ELSET=EALL, MATERIAL=STEEL\n0.1\n*STEP\n*STATIC\n"
                                    "*BOUNDARY\nFACE_5, 1, 6\n*DLOAD\nTOP, P, 2.\n"
                                    "*NODE PRINT, NSET=FACE_5, TOTALS=ONLY\nRF\n*END STEP\n";
  ASSERT_TRUE(succeeds("cd " + file("") + " && ccx job"));
  const std::string result = content(file("job.dat")), title = "total force (fx,fy,fz) for set FACE_5";
  ASSERT_TRUE(has(result, title)) << result;
  std::istringstream forces(result.substr(result.find('\n', result.find(title))));
  double fx = 0, fy = 0, fz = 0;
  forces >> fx >> fy >> fz;
  EXPECT_NEAR(fz, -200, 0.1); // what bears the pressure of 2 on an area of 100
}

#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_PAGE

TEST_F(Mesh_cad_groups, pages_have_names)
{
  const auto page = data_of_page("bridge.step --max-edge 3 --unit CM");
  EXPECT_EQ(page["title"], "bridge.step");
  EXPECT_EQ(page["unit"], "cm");
  EXPECT_EQ(page["high"][0].get<double>() - page["low"][0].get<double>(), 3); // of 30 mm
  std::set<std::string> names;
  for(const auto& part : page["parts"])
    names.insert(part["name"].get<std::string>());
  EXPECT_EQ(names.count("left plate"), 1u);
  EXPECT_EQ(names.count("pin, the only one"), 1u);
  EXPECT_EQ(page["faces"].size(), 27u);
  EXPECT_EQ(page["faces"][26]["number"], 27);
  const auto is_top = [](const auto& face) { return face.contains("name") && face["name"] == "top"; };
  EXPECT_GE(std::count_if(page["faces"].begin(), page["faces"].end(), is_top), 1);
  const auto has_color = [](const auto& face) { return face.contains("color"); };
  EXPECT_GT(std::count_if(page["faces"].begin(), page["faces"].end(), has_color), 6);
}

#endif

} // namespace
