// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files of element meshes, read back by other programs; without these a test is skipped.
#include "program_test.h"

#include <CGAL/IO/write_BDF.h>
#include <CGAL/IO/write_INP.h>
#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_MED
#include <CGAL/IO/write_MED.h>
#endif
#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_3MF
#include <CGAL/IO/write_element_3MF.h>
#endif
#include <CGAL/IO/write_MSH.h>
#include <CGAL/IO/write_UNV.h>
#include <CGAL/IO/write_element_STL.h>
#include <CGAL/IO/write_element_VTU.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Element_mesh_3 Element_mesh;

// Cubes with 12 triangles each, side by side and apart from each other.
class Cubes
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_mid_side_nodes;

public:
  Element_mesh mesh;

  Cubes(std::size_t number_of_cubes, bool is_second_order)
  {
    mesh.is_second_order = is_second_order;
    for(std::size_t i = 0; i < number_of_cubes; ++i)
      add_cube(i);
    mesh.groups.push_back({"tops & \"bottoms\"", 2, {4, 5}});
    mesh.groups.push_back({"both", 3, {0}});
    mesh.triangle_data.push_back({"height", 1, std::vector<double>(mesh.triangles.size(), 1)});
    mesh.places.resize(mesh.nodes.size());
  }

private:
  void add_cube(std::size_t number)
  {
    const std::size_t first = mesh.nodes.size();
    for(std::size_t i = 0; i < 8; ++i)
      mesh.nodes.push_back({double(i & 1) + 2 * double(number), double(i / 2 & 1), double(i / 4)});
    mesh.parts.push_back({number + 1, "k\xc3\xb6rper " + std::to_string(number + 1), Element_mesh::Color{1, 0, 0, 1}});
    const std::array<std::array<std::size_t, 4>, 6> faces{{{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for(const auto& face : faces) {
      Element_mesh::Entity surface;
      surface.number = mesh.surfaces.size() + 1;
      surface.parts[0] = number;
      mesh.surfaces.push_back(surface);
      add_triangle({face[0], face[1], face[2]}, first);
      add_triangle({face[0], face[2], face[3]}, first);
      for(std::size_t i = 0; i < 4; ++i)
        if(face[i] < face[(i + 1) % 4]) // each edge once
          add_line(face[i] + first, face[(i + 1) % 4] + first, number);
    }
    for(std::size_t i = 0; i < 8; ++i) {
      mesh.points.push_back(first + i);
      mesh.point_vertices.push_back(mesh.vertices.size());
      mesh.vertices.push_back(entity(mesh.vertices.size() + 1, number));
    }
  }

  static Element_mesh::Entity entity(std::size_t number, std::size_t part)
  {
    Element_mesh::Entity result;
    result.number = number;
    result.parts[0] = part;
    return result;
  }

  void add_triangle(const std::array<std::size_t, 3>& corners, std::size_t first)
  {
    Element_mesh::Triangle triangle;
    triangle.fill(Element_mesh::none);
    for(std::size_t i = 0; i < 3; ++i) {
      triangle[i] = corners[i] + first;
      triangle[3 + i] = mid_side_node(corners[i] + first, corners[(i + 1) % 3] + first);
    }
    mesh.triangles.push_back(triangle);
    mesh.triangle_surfaces.push_back(mesh.surfaces.size() - 1);
  }

  void add_line(std::size_t a, std::size_t b, std::size_t part)
  {
    mesh.lines.push_back({a, b, mid_side_node(a, b)});
    mesh.line_curves.push_back(mesh.curves.size());
    mesh.curves.push_back(entity(mesh.curves.size() + 1, part));
  }

  std::size_t mid_side_node(std::size_t a, std::size_t b)
  {
    if(!mesh.is_second_order)
      return Element_mesh::none;
    const auto found = m_mid_side_nodes.emplace(std::minmax(a, b), mesh.nodes.size());
    if(found.second) {
      Element_mesh::Point p;
      for(std::size_t i = 0; i < 3; ++i)
        p[i] = (mesh.nodes[a][i] + mesh.nodes[b][i]) / 2;
      mesh.nodes.push_back(p);
    }
    return found.first->second;
  }
};

class Element_files : public Program_test
{
protected:
  Element_files() : Program_test("") {}

  void write(const std::string& name, const std::function<bool(std::ostream&)>& writer) const
  {
    std::ofstream out(file(name), std::ios::binary);
    EXPECT_TRUE(writer(out)) << name;
  }

  void write_all(const Element_mesh& mesh) const
  {
    write("mesh.msh", [&](std::ostream& out) { return CGAL::IO::write_MSH(out, mesh); });
    write("mesh2.msh", [&](std::ostream& out) { return CGAL::IO::write_MSH_2(out, mesh); });
    write("mesh.inp", [&](std::ostream& out) { return CGAL::IO::write_INP(out, mesh); });
    write("mesh.vtu", [&](std::ostream& out) { return CGAL::IO::write_VTU(out, mesh); });
    write("mesh.bdf", [&](std::ostream& out) { return CGAL::IO::write_BDF(out, mesh); });
    write("mesh.unv", [&](std::ostream& out) { return CGAL::IO::write_UNV(out, mesh); });
    write("mesh.stl", [&](std::ostream& out) { return CGAL::IO::write_STL(out, mesh); });
    write("binary.stl", [&](std::ostream& out) {
      CGAL::IO::set_binary_mode(out);
      return CGAL::IO::write_STL(out, mesh);
    });
  }

  // What meshio reads: numbers of cells by type, of points, and names.
  nlohmann::json read(const std::string& name) const
  {
    std::ofstream(file("read.py")) << "import json, meshio, sys\n"
                                      "m = meshio.read(sys.argv[1])\n"
                                      "cells = {}\n"
                                      "for c in m.cells: cells[c.type] = cells.get(c.type, 0) + len(c.data)\n"
                                      "json.dump({'points': len(m.points), 'cells': cells, 'cell_data': {k: [x.tolist() for x in v] for k, v in "
                                      "m.cell_data.items() if all(x.dtype.kind != 'f' for x in v)}, 'names': sorted(list(m.field_data) + list(m.cell_sets) + list(m.point_sets)),\n"
                                      "  'text': {k: bytes(v.astype('uint8')).decode() for k, v in m.field_data.items() if v.dtype == 'int8'}\n"
                                      "}, open('read.json', 'w'))\n";
    EXPECT_TRUE(succeeds("cd " + file("") + " && /usr/bin/python3 read.py " + name)) << name;
    return nlohmann::json::parse(content(file("read.json")));
  }

  static bool has_meshio() { return succeeds("/usr/bin/python3 -c 'import meshio'"); }
};

TEST_F(Element_files, of_first_order)
{
  if(!has_meshio())
    GTEST_SKIP() << "meshio is not installed";
  write_all(Cubes(2, false).mesh);
  for(const char* name : {"mesh.msh", "mesh2.msh", "mesh.inp", "mesh.vtu", "mesh.bdf"}) {
    const auto mesh = read(name);
    EXPECT_EQ(mesh["points"], 16) << name;
    EXPECT_EQ(mesh["cells"]["triangle"], 24) << name;
    const bool has_lines = name != std::string("mesh.inp") && name != std::string("mesh.bdf");
    EXPECT_EQ(mesh["cells"].value("line", 0), has_lines ? 24 : 0) << name;
    EXPECT_EQ(mesh["cells"].value("vertex", 0), has_lines ? 16 : 0) << name;
  }
  EXPECT_EQ(read("binary.stl")["cells"]["triangle"], 24);
}

TEST_F(Element_files, of_second_order)
{
  if(!has_meshio())
    GTEST_SKIP() << "meshio is not installed";
  write_all(Cubes(1, true).mesh);
  for(const char* name : {"mesh.msh", "mesh2.msh", "mesh.vtu", "mesh.bdf"}) { // meshio does not know S6
    const auto mesh = read(name);
    EXPECT_EQ(mesh["points"], 8 + 18) << name;
    EXPECT_EQ(mesh["cells"]["triangle6"], 12) << name << mesh["cells"];
  }
  EXPECT_EQ(read("mesh.msh")["cells"]["line3"], 12);
}

TEST_F(Element_files, groups)
{
  if(!has_meshio())
    GTEST_SKIP() << "meshio is not installed";
  write_all(Cubes(2, false).mesh);
  for(const char* name : {"mesh.msh", "mesh2.msh"}) {
    const std::string names = read(name)["names"].dump();
    for(const char* group : {"face_12", "edge_24", "vertex_16", "k\xc3\xb6rper 2", "both", "tops & _bottoms_"})
      EXPECT_NE(names.find("\"" + std::string(group) + "\""), std::string::npos) << name << names;
  }
  const std::string names = read("mesh.inp")["names"].dump();
  for(const char* group : {"FACE_12", "EDGE_24", "VERTEX_16", "K_RPER_2", "BOTH", "TOPS____BOTTOMS_", "EALL"})
    EXPECT_NE(names.find("\"" + std::string(group) + "\""), std::string::npos) << group << names;
  const auto vtu = read("mesh.vtu");
  EXPECT_EQ(vtu["text"]["part_names"], "1 k\xc3\xb6rper 1\n2 k\xc3\xb6rper 2\n");
  const auto value = [&](const char* data, std::size_t block, std::size_t i) { // meshio has arrays of one number each
    const auto& entry = vtu["cell_data"][data][block][i];
    return entry.is_array() ? entry[0].get<int>() : entry.get<int>();
  };
  EXPECT_EQ(value("face_id", 0, 23), 12);
  EXPECT_EQ(value("part_id", 0, 23), 2);
  EXPECT_EQ(value("edge_id", 1, 23), 24);
  EXPECT_EQ(value("vertex_id", 2, 15), 16);
}

// Gmsh reads all solids of an STL file, and fills the cubes.
TEST_F(Element_files, gmsh_fills_cubes)
{
  if(!succeeds("command -v gmsh"))
    GTEST_SKIP() << "gmsh is not installed";
  write_all(Cubes(2, false).mesh);
  for(const char* name : {"mesh.msh", "mesh2.msh", "mesh.bdf", "mesh.unv", "mesh.stl", "binary.stl"}) {
    const bool has_solids = name == std::string("mesh.stl"), has_one_solid = name == std::string("binary.stl");
    std::ofstream(file("fill.geo")) << "Merge \"" << name << "\";\n"
                                    << (has_one_solid ? "Surface Loop(1) = {1};\n"
                                        : has_solids  ? "Surface Loop(1) = {2};\n"
                                                      : "Surface Loop(1) = {7:12};\n")
                                    << "Volume(1) = {1};\nPhysical Volume(\"filled\") = {1};\n";
    EXPECT_TRUE(succeeds("cd " + file("") + " && gmsh fill.geo -3 -format msh22 -o filled.msh")) << name;
    std::istringstream elements(content(file("filled.msh")));
    std::size_t number_of_tetrahedra = 0, number = 0, type = 0;
    for(std::string line; std::getline(elements, line);) {
      std::istringstream words(line);
      number_of_tetrahedra += (words >> number >> type) && type == 4 && std::count(line.begin(), line.end(), ' ') == 8;
    }
    EXPECT_GE(number_of_tetrahedra, 5u) << name;
  }
}

TEST_F(Element_files, calculix_takes_elements_of_second_order)
{
  if(!succeeds("command -v ccx"))
    GTEST_SKIP() << "CalculiX is not installed";
  write_all(Cubes(1, true).mesh);
  std::ofstream(file("job.inp")) << "*INCLUDE, INPUT=mesh.inp\n*MATERIAL, NAME=STEEL\n*ELASTIC\n210000, 0.3\n"
                                    "*SHELL SECTION, ELSET=EALL, MATERIAL=STEEL\n0.01\n*STEP\n*STATIC\n*BOUNDARY\nFACE_5, 1, 6\n"
                                    "*DLOAD\nFACE_6, P, 3.\n*NODE PRINT, NSET=FACE_5, TOTALS=ONLY\nRF\n*END STEP\n";
  ASSERT_TRUE(succeeds("cd " + file("") + " && ccx job"));
  const std::string result = content(file("job.dat")), title = "total force (fx,fy,fz) for set FACE_5";
  std::istringstream forces(result.substr(result.find('\n', result.find(title))));
  double fx = 0, fy = 0, fz = 0;
  forces >> fx >> fy >> fz;
  EXPECT_NEAR(fz, -3, 0.01) << result;
}

#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_MED
TEST_F(Element_files, med)
{
  for(const bool is_second_order : {false, true}) {
    CGAL::IO::write_MED(file("mesh.med"), Cubes(2, is_second_order).mesh);
    std::ofstream(file("read_med.py")) << "import json, meshio\n"
                                          "m = meshio.read('mesh.med')\n"
                                          "json.dump({'points': len(m.points), 'cells': {c.type: len(c.data) for c in m.cells},\n"
                                          "  'groups': m.cell_tags['-12'] if '-12' in m.cell_tags else m.cell_tags[-12]}, open('read.json', 'w'))\n";
    if(!has_meshio() || !succeeds("/usr/bin/python3 -c 'import h5py'"))
      GTEST_SKIP() << "meshio or h5py is not installed";
    ASSERT_TRUE(succeeds("cd " + file("") + " && /usr/bin/python3 read_med.py"));
    const auto mesh = nlohmann::json::parse(content(file("read.json")));
    EXPECT_EQ(mesh["points"], is_second_order ? 2 * (8 + 18) : 16);
    EXPECT_EQ(mesh["cells"], (is_second_order ? nlohmann::json{{"triangle6", 24}, {"line3", 24}, {"vertex", 16}}
                                              : nlohmann::json{{"triangle", 24}, {"line", 24}, {"vertex", 16}}));
    EXPECT_EQ(mesh["groups"], (std::vector<std::string>{"face_12", "k_rper 2"}));
  }
  EXPECT_THROW(CGAL::IO::write_MED("/nowhere/mesh.med", Cubes(1, false).mesh), CGAL::Parametric_surface_mesh_error);
}
#endif

#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_3MF
TEST_F(Element_files, three_mf)
{
  Element_mesh cubes = Cubes(2, false).mesh;
  cubes.surfaces[3].color = Element_mesh::Color{0, 0, 1, 0.2};
  cubes.triangles.pop_back(); // the second one is open
  cubes.triangle_surfaces.pop_back();
  cubes.triangle_data.clear();
  CGAL::IO::write_3MF(file("mesh.3mf"), cubes, 10);
  std::ofstream(file("read_3mf.py")) << "import json, zipfile\n"
                                        "import xml.etree.ElementTree as tree\n"
                                        "ns = '{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}'\n"
                                        "model = tree.fromstring(zipfile.ZipFile('mesh.3mf').read('3D/3dmodel.model'))\n"
                                        "colors = [m.get('displaycolor').lower() for m in model.iter(ns + 'base')]\n"
                                        "objects = [{'name': o.get('name'), 'type': o.get('type'), 'points': len(list(o.iter(ns + 'vertex'))),\n"
                                        "  'largest': max(float(v.get('x')) for v in o.iter(ns + 'vertex')), 'triangles': len(list(o.iter(ns + 'triangle'))),\n"
                                        "  'colors': sorted(set(colors[int(t.get('p1') or o.get('pindex'))] for t in o.iter(ns + 'triangle')))} for o in model.iter(ns + 'object')]\n"
                                        "json.dump({'unit': model.get('unit'), 'objects': objects, 'items': len(list(model.iter(ns + 'item')))}, open('read.json', 'w'))\n";
  if(!succeeds("python3 -c 'import zipfile, xml.etree.ElementTree'"))
    GTEST_SKIP() << "python3 is not installed";
  ASSERT_TRUE(succeeds("cd " + file("") + " && python3 read_3mf.py"));
  const auto model = nlohmann::json::parse(content(file("read.json")));
  EXPECT_EQ(model["unit"], "millimeter");
  EXPECT_EQ(model["items"], 2);
  ASSERT_EQ(model["objects"].size(), 2u);
  const auto &first = model["objects"][0], &second = model["objects"][1];
  EXPECT_EQ(first["name"], "k\xc3\xb6rper 1");
  EXPECT_EQ(first["type"], "model");
  EXPECT_EQ(first["points"], 8);
  EXPECT_EQ(first["triangles"], 12);
  EXPECT_EQ(first["largest"], 10);
  EXPECT_EQ(first["colors"], (std::vector<std::string>{"#0000ff33", "#ff0000ff"}));
  EXPECT_EQ(second["type"], "surface");
  EXPECT_EQ(second["triangles"], 11);
  EXPECT_EQ(second["colors"], std::vector<std::string>{"#ff0000ff"});
  EXPECT_THROW(CGAL::IO::write_3MF("/nowhere/mesh.3mf", cubes), CGAL::Parametric_surface_mesh_error);
}
#endif

// CalculiX does not read more.
TEST_F(Element_files, numbers_of_at_most_20_characters)
{
  Element_mesh mesh = Cubes(1, false).mesh;
  mesh.nodes[0] = {{-4.4408920985006262e-16, -1.2345678901234567e-110, -0.125}};
  std::ostringstream out;
  EXPECT_TRUE(CGAL::IO::write_INP(out, mesh));
  EXPECT_NE(out.str().find("\n1, -4.4408920985006e-16, -1.234567890123e-110, -0.125\n"), std::string::npos) << out.str().substr(0, 200);
  mesh.nodes[0] = {{-1.2345678901234567e110, 1e200, 0}}; // large numbers stay large
  out.str("");
  EXPECT_TRUE(CGAL::IO::write_INP(out, mesh));
  EXPECT_NE(out.str().find("\n1, -1.234567890123e+110, "), std::string::npos) << out.str().substr(0, 200);
}

// Nastran's fields have 16.
TEST_F(Element_files, numbers_of_at_most_16_characters)
{
  Element_mesh mesh = Cubes(1, false).mesh;
  mesh.nodes[0] = {{-1.2345678901234567e110, 0.5, -0.125}};
  std::ostringstream out;
  EXPECT_TRUE(CGAL::IO::write_BDF(out, mesh));
  EXPECT_NE(out.str().find("                -1.23456789E+110 5.000000000E-01*\n*       -1.250000000E-01\n"), std::string::npos)
    << out.str().substr(0, 1200);
}

TEST_F(Element_files, arrays_that_do_not_fit_are_refused)
{
  const auto expect_refused_mesh = [](const std::function<void(Element_mesh&)>& change) {
    Element_mesh mesh = Cubes(1, false).mesh;
    change(mesh);
    std::ostringstream out;
    EXPECT_THROW(CGAL::IO::write_MSH(out, mesh), CGAL::Parametric_surface_mesh_error);
    EXPECT_THROW(CGAL::IO::write_VTU(out, mesh), CGAL::Parametric_surface_mesh_error);
    EXPECT_EQ(out.str(), "");
  };
  expect_refused_mesh([](Element_mesh& mesh) { mesh.triangles.front()[2] = 100; });
  expect_refused_mesh([](Element_mesh& mesh) { mesh.triangle_surfaces.pop_back(); });
  expect_refused_mesh([](Element_mesh& mesh) { mesh.line_curves.front() = 100; });
  expect_refused_mesh([](Element_mesh& mesh) { mesh.is_second_order = true; });
}

} // namespace
