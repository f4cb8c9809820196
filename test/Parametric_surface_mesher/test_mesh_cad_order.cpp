// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program mesh_cad from outside: elements of second order.
#include "program_test.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

class Mesh_cad_order : public Program_test
{
protected:
  Mesh_cad_order() : Program_test(MESH_CAD_PROGRAM) {}

  void write(const TopoDS_Shape& shape, const std::string& name) const { BRepTools::Write(shape, file(name).c_str()); }

  // the text between two tags of a file
  static std::istringstream between(const std::string& text, const std::string& from, const std::string& to)
  {
    const std::size_t begin = text.find(from);
    EXPECT_NE(begin, std::string::npos) << from;
    return std::istringstream(text.substr(begin + from.size(), text.find(to, begin) - begin - from.size()));
  }

  // the numbers of the nodes of each triangle in a file of Gmsh, version 2.2
  static std::vector<std::array<std::size_t, 6>> triangles_of_msh(const std::string& text)
  {
    std::istringstream in = between(text, "$Elements\n", "$EndElements");
    std::size_t number = 0, type = 0, ignored = 0;
    in >> number;
    std::vector<std::array<std::size_t, 6>> result;
    std::string line;
    std::getline(in, line);
    while(std::getline(in, line)) {
      std::istringstream element(line);
      element >> ignored >> type >> ignored >> ignored >> ignored;
      if(type == 15 || type == 8) // a point, or a line with three nodes
        continue;
      EXPECT_EQ(type, 9u); // the triangle with six nodes
      result.emplace_back();
      for(std::size_t& node : result.back())
        element >> node;
    }
    EXPECT_LT(result.size(), number);
    return result;
  }
};

TEST_F(Mesh_cad_order, of_a_ball_is_close_to_it)
{
  write(BRepPrimAPI_MakeSphere(10).Shape(), "ball.brep");
  const nlohmann::json numbers = json("ball.brep --order 2 --quiet --out ball.msh2");
  EXPECT_EQ(numbers["order"], 2);
  const auto& curved = numbers["second_order"];
  EXPECT_LT(curved["distance"], numbers["distance"].get<double>() / 20);
  EXPECT_GT(curved["smallest_scaled_jacobian"], 0.5);
  EXPECT_TRUE(curved["uncertified"].empty());
  EXPECT_EQ(curved["curved_less"], 0);
  EXPECT_EQ(curved["nodes_on_edges"].get<int>() + curved["nodes_on_faces"].get<int>(), 3 * numbers["triangles"].get<int>() / 2);

  const std::string text = content(file("ball.msh2"));
  const auto triangles = triangles_of_msh(text);
  EXPECT_EQ(triangles.size(), numbers["triangles"].get<std::size_t>());
  std::set<std::size_t> mid_side_nodes;
  for(const auto& triangle : triangles)
    mid_side_nodes.insert(triangle.begin() + 3, triangle.end());
  EXPECT_EQ(mid_side_nodes.size(), 3 * triangles.size() / 2); // each of two triangles
  std::istringstream nodes = between(text, "$Nodes\n", "$EndNodes");
  std::size_t number = 0, ignored = 0;
  nodes >> number;
  EXPECT_EQ(number, numbers["vertices"].get<std::size_t>() + mid_side_nodes.size());
  for(double x, y, z; nodes >> ignored >> x >> y >> z;)
    EXPECT_NEAR(std::sqrt(x * x + y * y + z * z), 10, 1e-4); // nodes are rounded in files
}

TEST_F(Mesh_cad_order, is_in_all_files_that_can_hold_it)
{
  write(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(4, 3, 2).Shape(), BRepPrimAPI_MakeCylinder(1, 5).Shape()).Shape(), "block.brep");
  const auto run_with = [this](const std::string& name) {
    const Result result = run("block.brep --order 2 --max-edge 1 --out " + name);
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("curved triangles with six nodes: at most "), std::string::npos) << result.out;
    return content(file(name));
  };
  EXPECT_NE(run_with("block.inp").find("TYPE=S6"), std::string::npos);
  EXPECT_FALSE(triangles_of_msh(run_with("block.msh2")).empty());
  EXPECT_NE(run_with("block.msh").find("4.1 0 8"), std::string::npos);
  EXPECT_NE(run_with("block.vtu").find("UnstructuredGrid"), std::string::npos);
  EXPECT_NE(run_with("block.bdf").find("\nCTRIA6  "), std::string::npos);
  for(const char* ending : {"off", "obj", "ply", "stl"})
    expect_refused("block.brep --order 2 --out block." + std::string(ending), "must end in");
  expect_refused("block.brep --order 3", "--order");
}

} // namespace
