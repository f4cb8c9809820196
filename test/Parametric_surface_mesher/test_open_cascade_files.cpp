// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reading files; and real models, where there are some: those of the folder PARAMETRIC_SURFACE_MESHER_CAD_DIR of CMake, and
// one that Debian's package occt-misc installs.
#include "open_cascade_test_helpers.h"

#include <CGAL/IO/read_open_cascade_shape.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

std::string temporary_file(const std::string& name) { return testing::TempDir() + "open_cascade_" + name; }

std::vector<std::string> cad_files()
{
  std::vector<std::string> result;
  const std::string dir = CAD_DIR, part = "/usr/share/opencascade/data/step/linkrods.step";
  if(!dir.empty() && std::filesystem::is_directory(dir))
    for(const auto& entry : std::filesystem::directory_iterator(dir)) {
      const std::string ending = entry.path().extension().string();
      if(ending == ".step" || ending == ".stp" || ending == ".iges" || ending == ".brep" || ending == ".rle")
        result.push_back(entry.path().string());
    }
  else if(std::filesystem::exists(part))
    result.push_back(part);
  std::sort(result.begin(), result.end());
  return result;
}

std::string test_name(const testing::TestParamInfo<std::string>& info)
{
  std::string result = std::filesystem::path(info.param).filename().string();
  std::replace_if(result.begin(), result.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return result;
}

class Cad_files : public testing::TestWithParam<std::string>
{};

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Cad_files);

TEST_P(Cad_files, all_faces_are_meshed_and_closed_where_the_shape_is)
{
  const TopoDS_Shape shape = CGAL::IO::read_open_cascade_shape(GetParam());
  const Meshed_shape meshed(shape);
  EXPECT_TRUE(meshed.shape.left_out.empty());
  EXPECT_TRUE(meshed.report.left_out.empty());
  EXPECT_EQ(meshed.quality.is_closed, meshed.shape.is_shape_closed);
  const Cad_mesh_verdict verdict = Cad_mesh_judge(shape, meshed.judged())();
  EXPECT_LE(verdict.deviation, 1e-3);
  // two faces of this one are not valid, and edges of theirs are as short as the tolerance
  if(GetParam().find("wrongshape") == std::string::npos) {
    EXPECT_EQ(verdict.text(), "ok");
  }
}

INSTANTIATE_TEST_SUITE_P(, Cad_files, testing::ValuesIn(cad_files()), test_name);

TEST(Open_cascade_files, brep_step_and_iges)
{
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  BRepTools::Write(box, temporary_file("box.brep").c_str());
  STEPControl_Writer step;
  step.Transfer(box, STEPControl_AsIs);
  step.Write(temporary_file("box.stp").c_str());
  IGESControl_Writer iges;
  iges.AddShape(box);
  iges.Write(temporary_file("box.igs").c_str());
  for(const char* name : {"box.brep", "box.stp", "box.igs"}) {
    const auto shape = CGAL::make_model_of_open_cascade_shape(CGAL::IO::read_open_cascade_shape(temporary_file(name)));
    EXPECT_EQ(shape.model.faces().size(), 6u) << name;
    EXPECT_NEAR(shape.diagonal, std::sqrt(14.), 1e-5) << name;
  }
}

TEST(Open_cascade_files, lengths_are_in_the_unit_asked_for)
{
  STEPControl_Writer step;
  step.Transfer(BRepPrimAPI_MakeBox(100, 200, 300).Shape(), STEPControl_AsIs);
  step.Write(temporary_file("unit.step").c_str());
  const auto diagonal = [](const std::string& unit) {
    return CGAL::make_model_of_open_cascade_shape(CGAL::IO::read_open_cascade_shape(temporary_file("unit.step"), unit)).diagonal;
  };
  EXPECT_NEAR(diagonal("M"), std::sqrt(0.14), 1e-6);
  EXPECT_NEAR(diagonal("MM"), 1000 * std::sqrt(0.14), 1e-3);
  EXPECT_THROW(diagonal("PARSEC"), CGAL::Parametric_surface_mesh_error);
}

TEST(Open_cascade_files, what_is_no_shape_is_refused)
{
  const auto read = [](const std::string& name) { return CGAL::IO::read_open_cascade_shape(name); };
  EXPECT_THROW(read(temporary_file("nowhere.step")), CGAL::Parametric_surface_mesh_error);
  for(const char* name : {"garbage.step", "garbage.iges", "garbage.brep", "garbage.txt"}) {
    std::ofstream(temporary_file(name)) << "garbage\n";
    EXPECT_THROW(read(temporary_file(name)), CGAL::Parametric_surface_mesh_error) << name;
  }
}

// Open CASCADE takes a folder for a file that is too large for the memory.
TEST(Open_cascade_files, folders_are_refused)
{
  const std::string folder = temporary_file("folder.step");
  std::filesystem::create_directory(folder);
  try {
    CGAL::IO::read_open_cascade_shape(folder);
    ADD_FAILURE() << "read a folder";
  }
  catch(const CGAL::Parametric_surface_mesh_error& error) {
    EXPECT_NE(std::string(error.what()).find("is a folder"), std::string::npos) << error.what();
  }
}

std::string content(const std::string& file_name)
{
  std::ifstream file(file_name, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

std::string cut_file(const std::string& name, double share)
{
  const std::string all = content(temporary_file(name)), result = temporary_file("cut_" + name);
  std::ofstream(result, std::ios::binary) << all.substr(0, std::size_t(share * double(all.size())));
  return result;
}

std::string file_with(const std::string& name, const std::string& old_text, const std::string& new_text)
{
  std::string all = content(temporary_file(name));
  const std::string result = temporary_file("changed_" + name);
  all.replace(all.find(old_text), old_text.size(), new_text);
  std::ofstream(result, std::ios::binary) << all;
  return result;
}

void write_box(const std::string& name)
{
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  BRepTools::Write(box, temporary_file(name + ".brep").c_str());
  STEPControl_Writer step;
  step.Transfer(box, STEPControl_AsIs);
  step.Write(temporary_file(name + ".step").c_str());
  IGESControl_Writer iges;
  iges.AddShape(box);
  iges.Write(temporary_file(name + ".iges").c_str());
}

// The readers of Open CASCADE crash on some of these, and never come back from others.
TEST(Open_cascade_files, files_without_their_end_are_refused)
{
  write_box("whole");
  for(const char* name : {"whole.brep", "whole.step", "whole.iges"})
    for(double share : {0.05, 0.3, 0.5, 0.7, 0.8, 0.9, 0.99}) {
      const std::string file = cut_file(name, share);
      EXPECT_THROW(CGAL::IO::read_open_cascade_shape(file), CGAL::Parametric_surface_mesh_error) << name << " " << share;
    }
}

TEST(Open_cascade_files, faces_that_are_lost_in_reading_are_told)
{
  write_box("faces");
  const std::string file = file_with("faces.step", "ADVANCED_FACE", "ADVANCED_FASE");
  std::vector<std::string> faults;
  CGAL::IO::read_open_cascade_shape(file, "MM", faults);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults.front().find("1 of 6 faces in the file could not be read"), 0u) << faults.front();
  EXPECT_THROW(CGAL::IO::read_open_cascade_shape(file), CGAL::Parametric_surface_mesh_error);
}

// On some of these Open CASCADE crashes.
TEST(Open_cascade_files, loops_that_are_lost_in_reading_are_told)
{
  write_box("loops");
  for(const char* entity : {"FACE_BOUND", "EDGE_LOOP", "ORIENTED_EDGE", "EDGE_CURVE"}) {
    const std::string file = file_with("loops.step", std::string(entity) + "(", std::string(entity) + "S(");
    EXPECT_THROW(CGAL::IO::read_open_cascade_shape(file), CGAL::Parametric_surface_mesh_error) << entity;
  }
}

} // namespace
