// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program mesh_cad from outside: names and parts of assemblies.
#include "Named_assembly.h"
#include "program_test.h"

#include <BRepTools.hxx>

#include <cstddef>
#include <fstream>
#include <set>
#include <string>

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
  const Result unknown = run("bridge.step --parts column,nail");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(has(unknown.err, "there is no part 'nail'; the parts are 1 bridge, 2 bridge/left plate")) << unknown.err;
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

} // namespace
