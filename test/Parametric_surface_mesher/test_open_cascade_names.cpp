// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names, colours, layers and materials of CAD files.
#include "Named_assembly.h"

#include <CGAL/IO/read_open_cascade_shape.h>
#include <CGAL/carry_over_open_cascade_names.h>
#include <CGAL/repair_open_cascade_shape.h>
#include <CGAL/sew_open_cascade_shape.h>

#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

typedef CGAL::Open_cascade_names_3 Names;

std::string temporary_file(const std::string& name) { return testing::TempDir() + "open_cascade_names_" + name; }

struct Read
{
  std::vector<std::string> faults;
  Names names;
  TopoDS_Shape shape;

  explicit Read(const std::string& name) : shape(CGAL::IO::read_open_cascade_shape(temporary_file(name), "MM", faults, names))
  {
    EXPECT_TRUE(faults.empty());
    EXPECT_TRUE(names.faults.empty());
  }

  const Names::Part& part(const std::string& path) const
  {
    for(const auto& p : names.parts)
      if(p.path == path)
        return p;
    ADD_FAILURE() << "no part " << path;
    return names.parts.front();
  }

  std::size_t count(const std::vector<std::string>& all, const std::string& name) const
  {
    return std::size_t(std::count(all.begin(), all.end(), name));
  }
};

Bnd_Box box(const TopoDS_Shape& shape)
{
  Bnd_Box result;
  BRepBndLib::AddOptimal(shape, result, false, false);
  return result;
}

std::string boxes_of_faces(const TopoDS_Shape& shape)
{
  std::ostringstream result;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for(int i = 1; i <= faces.Extent(); ++i) {
    const Bnd_Box b = box(faces(i));
    result << b.CornerMin().X() << ' ' << b.CornerMin().Y() << ' ' << b.CornerMin().Z() << ' ' << b.CornerMax().X() << ' '
           << b.CornerMax().Y() << ' ' << b.CornerMax().Z() << '\n';
  }
  return result.str();
}

void write_step(const std::string& name) { write_named_assembly(temporary_file(name)); }

TEST(Open_cascade_names, the_parts_of_an_assembly)
{
  write_step("parts.step");
  const Read read("parts.step");
  std::vector<std::string> paths;
  for(const auto& part : read.names.parts)
    paths.push_back(part.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"bridge", "bridge/left plate", "bridge/right plate", "bridge/column", "bridge/column/solid_3",
                                             "bridge/column/solid_4", "bridge/fastener", "bridge/fastener/pin, the only one"}));
  EXPECT_EQ(read.part("bridge/left plate").name, "pl\xc3\xa4te");
  EXPECT_EQ(read.part("bridge/fastener/pin, the only one").name, "pin");
  EXPECT_EQ(read.names.parts.front().faces.size(), 27u);
  EXPECT_EQ(read.part("bridge/column").solids, (std::vector<std::size_t>{2, 3}));
  EXPECT_TRUE(read.part("bridge/column").is_assembly);
  EXPECT_FALSE(read.part("bridge/left plate").is_assembly);
  EXPECT_EQ(read.part("bridge/fastener").faces, read.part("bridge/fastener/pin, the only one").faces);
  EXPECT_NE(read.names.unit.find("milli"), std::string::npos);
}

// Their faces are those of the shape at the place of the part.
TEST(Open_cascade_names, places_of_parts)
{
  write_step("places.step");
  const Read read("places.step");
  EXPECT_EQ(read.part("bridge/right plate").location, (std::array<double, 12>{{1, 0, 0, 20, 0, 1, 0, 0, 0, 0, 1, 0}}));
  EXPECT_EQ(read.part("bridge/fastener/pin, the only one").location[3], 25);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(read.shape, TopAbs_FACE, faces);
  const auto& pin = read.part("bridge/fastener/pin, the only one").faces;
  ASSERT_EQ(pin.size(), 3u);
  for(const std::size_t face : pin) {
    EXPECT_GE(box(faces(int(face) + 1)).CornerMin().X(), 24.4);
    EXPECT_GE(box(faces(int(face) + 1)).CornerMin().Z(), 0.9);
  }
  const auto parts = read.names.parts_of_faces(), shells = read.names.parts_of_shells();
  EXPECT_EQ(read.names.parts[parts[pin.front()]].name, "pin");
  EXPECT_EQ(std::set<std::size_t>(shells.begin(), shells.end()), (std::set<std::size_t>{1, 2, 4, 5, 7}));
}

TEST(Open_cascade_names, names_colors_layers_and_materials)
{
  write_step("colors.step");
  const Read read("colors.step");
  EXPECT_EQ(read.count(read.names.face_names, "top"), 2u); // of both uses
  const auto& plate = read.part("bridge/right plate");
  std::size_t number_of_gray_faces = 0;
  for(const std::size_t face : plate.faces) {
    ASSERT_TRUE(read.names.face_colors[face].has_value());
    const auto& color = *read.names.face_colors[face];
    if(read.names.face_names[face] == "top") {
      EXPECT_NEAR(color.red, 1, 1e-3);
      EXPECT_NEAR(color.blue, 0, 1e-3);
    }
    else
      number_of_gray_faces += std::abs(color.red - 0.5) < 1e-3 && std::abs(color.blue - 0.5) < 1e-3;
  }
  EXPECT_EQ(number_of_gray_faces, 5u);
  EXPECT_FALSE(read.names.face_colors[read.part("bridge/column").faces.front()].has_value());
  EXPECT_EQ(plate.layers, std::vector<std::string>{"steel parts"});
  ASSERT_TRUE(plate.material.has_value());
  EXPECT_EQ(plate.material->name, "steel");
  EXPECT_NEAR(plate.material->density, 7.85, 1e-9);
  EXPECT_FALSE(read.part("bridge/column").material.has_value());
}

// The shape is the one that a reader without names hands over.
TEST(Open_cascade_names, the_shape_is_the_same)
{
  write_step("same.step");
  STEPControl_Reader reader;
  reader.ReadFile(temporary_file("same.step").c_str());
  reader.TransferRoots();
  EXPECT_EQ(boxes_of_faces(Read("same.step").shape), boxes_of_faces(reader.OneShape()));
}

TEST(Open_cascade_names, iges)
{
  IGESCAFControl_Writer writer;
  writer.Transfer(Named_assembly().document);
  writer.Write(temporary_file("colors.iges").c_str());
  const Read read("colors.iges");
  EXPECT_EQ(read.names.face_names.size(), 27u);
  EXPECT_EQ(read.names.parts.front().faces.size(), 27u);
  const auto is_red = [](const auto& color) { return color && color->red > 0.99 && color->blue < 0.01; };
  EXPECT_EQ(std::count_if(read.names.face_colors.begin(), read.names.face_colors.end(), is_red), 2);
}

// The red faces are the same after the operation.
void expect_red_tops(const Names& names, const TopoDS_Shape& shape)
{
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  ASSERT_EQ(names.face_colors.size(), std::size_t(faces.Extent()));
  std::size_t number = 0;
  for(int f = 1; f <= faces.Extent(); ++f) {
    const auto& color = names.face_colors[std::size_t(f) - 1];
    if(color && color->red > 0.99 && color->blue < 0.01) {
      ++number;
      EXPECT_NEAR(box(faces(f)).CornerMin().Z(), 1, 1e-6);
      EXPECT_NEAR(box(faces(f)).CornerMax().Z(), 1, 1e-6);
    }
  }
  EXPECT_EQ(number, 2u);
}

TEST(Open_cascade_names, names_survive_sewing_and_repair)
{
  IGESCAFControl_Writer writer;
  writer.Transfer(Named_assembly().document);
  writer.Write(temporary_file("loose.iges").c_str());
  const Read loose("loose.iges");
  const auto sewn = CGAL::sew_open_cascade_shape(loose.shape, 1e-4);
  EXPECT_GT(sewn.number_of_sewn_edges, 40u);
  expect_red_tops(CGAL::carry_over_open_cascade_names(loose.names, loose.shape, sewn.history, sewn.shape), sewn.shape);

  write_step("repaired.step");
  const Read read("repaired.step");
  opencascade::handle<BRepTools_History> history;
  const TopoDS_Shape repaired = CGAL::repair_open_cascade_shape(read.shape, history);
  const Names names = CGAL::carry_over_open_cascade_names(read.names, read.shape, history, repaired);
  expect_red_tops(names, repaired);
  EXPECT_EQ(std::count(names.face_names.begin(), names.face_names.end(), "top"), 2);
  ASSERT_EQ(names.parts.size(), read.names.parts.size());
  for(std::size_t p = 0; p < names.parts.size(); ++p) {
    EXPECT_EQ(names.parts[p].faces.size(), read.names.parts[p].faces.size());
    EXPECT_EQ(names.parts[p].shells.size(), read.names.parts[p].shells.size());
    EXPECT_EQ(names.parts[p].solids.size(), read.names.parts[p].solids.size());
  }
}

TEST(Open_cascade_names, what_has_no_names_has_numbers)
{
  BRep_Builder builder;
  TopoDS_Compound shape;
  builder.MakeCompound(shape);
  builder.Add(shape, BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  builder.Add(shape, BRepPrimAPI_MakeBox(gp_Pnt(5, 0, 0), 1, 2, 3).Shape());
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(BRepPrimAPI_MakeBox(gp_Pnt(9, 0, 0), 1, 2, 3).Shape(), TopAbs_FACE, faces);
  builder.Add(shape, faces(1));
  BRepTools::Write(shape, temporary_file("numbers.brep").c_str());
  const Read brep("numbers.brep");
  ASSERT_EQ(brep.names.parts.size(), 4u);
  EXPECT_EQ(brep.names.parts[0].name, "open_cascade_names_numbers");
  EXPECT_EQ(brep.names.parts[2].name, "solid_2");
  EXPECT_EQ(brep.names.parts[3].name, "faces");
  EXPECT_EQ(brep.names.parts[3].faces, std::vector<std::size_t>{12});
  EXPECT_EQ(brep.names.unit, "");
  STEPControl_Writer step;
  step.Transfer(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), STEPControl_AsIs);
  step.Write(temporary_file("numbers.step").c_str());
  const Read one("numbers.step");
  ASSERT_EQ(one.names.parts.size(), 1u);
  EXPECT_EQ(one.names.parts[0].faces.size(), 6u);
}

} // namespace
