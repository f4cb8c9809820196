// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CAD files with random damage, and whether mesh_cad bears them: it ends in time, does not crash, and says so if something is lost.
#ifndef DAMAGED_FILES_H
#define DAMAGED_FILES_H

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Compound.hxx>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <sys/wait.h>

namespace damaged_files {

inline std::string content(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline void write(const std::string& file, const std::string& content)
{
  std::ofstream(file, std::ios::binary) << content;
}

// Writes some shapes in three formats to a folder and returns the names.
inline std::vector<std::string> write_shapes(const std::string& folder)
{
  TopoDS_Compound two;
  BRep_Builder builder;
  builder.MakeCompound(two);
  builder.Add(two, BRepPrimAPI_MakeTorus(2, 0.5).Shape());
  builder.Add(two, BRepPrimAPI_MakeSphere(1).Shape());
  const std::vector<TopoDS_Shape> shapes = {
    BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-1, -1, 0), 2, 2, 1).Shape(), BRepPrimAPI_MakeCylinder(0.5, 1).Shape()).Shape(),
    BRepPrimAPI_MakeCone(1, 0.3, 2).Shape(), two};
  std::vector<std::string> names;
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string name = folder + "/shape_" + std::to_string(i);
    BRepTools::Write(shapes[i], (name + ".brep").c_str());
    STEPControl_Writer step;
    step.Transfer(shapes[i], STEPControl_AsIs);
    step.Write((name + ".step").c_str());
    IGESControl_Writer iges;
    iges.AddShape(shapes[i]);
    iges.Write((name + ".iges").c_str());
    for(const char* ending : {".brep", ".step", ".iges"})
      names.push_back(name + ending);
  }
  return names;
}

// Changes the content of a file at random. The same generator, in the same state, does the same.
class Damage
{
  std::mt19937& m_random;
  std::string& m_content;

public:
  Damage(std::mt19937& random, std::string& content) : m_random(random), m_content(content) {}

  void operator()()
  {
    switch(number(7)) {
    case 0: m_content.resize(number(m_content.size())); break;
    case 1: change_bytes(); break;
    case 2: remove_lines(); break;
    case 3: repeat_lines(); break;
    case 4: change_digits(); break;
    case 5: swap_lines(); break;
    default: m_content.insert(number(m_content.size()), std::string(1 + number(200), char(number(256)))); break;
    }
  }

private:
  std::size_t number(std::size_t n) { return n == 0 ? 0 : m_random() % n; }

  void change_bytes()
  {
    for(std::size_t i = 1 + number(20); i > 0; --i)
      m_content[number(m_content.size())] = char(number(256));
  }

  void change_digits()
  {
    for(std::size_t i = 0, left = 1 + number(10); i < 1000 && left > 0; ++i) {
      char& c = m_content[number(m_content.size())];
      if(std::isdigit(static_cast<unsigned char>(c))) {
        c = char('0' + number(10));
        --left;
      }
    }
  }

  // the places where a line begins and where one after it ends
  std::pair<std::size_t, std::size_t> lines()
  {
    const std::size_t begin = m_content.rfind('\n', number(m_content.size()));
    std::size_t end = begin == std::string::npos ? 0 : begin + 1;
    for(std::size_t i = 1 + number(5); i > 0 && end < m_content.size(); --i)
      end = (std::min)(m_content.find('\n', end), m_content.size() - 1) + 1;
    return {begin == std::string::npos ? 0 : begin + 1, end};
  }

  void remove_lines()
  {
    const auto some = lines();
    m_content.erase(some.first, some.second - some.first);
  }

  void repeat_lines()
  {
    const auto some = lines();
    m_content.insert(some.first, m_content.substr(some.first, some.second - some.first));
  }

  void swap_lines()
  {
    const auto some = lines();
    const std::string moved = m_content.substr(some.first, some.second - some.first);
    m_content.erase(some.first, moved.size());
    const std::size_t place = m_content.rfind('\n', number(m_content.size()));
    m_content.insert(place == std::string::npos ? 0 : place + 1, moved);
  }
};

// Runs mesh_cad on a file for up to 30 seconds of processor time.
struct Run
{
  static const int status_after_time = 128 + SIGXCPU; // of a shell

  int status = -1; // -1 if it was ended by a signal
  nlohmann::json numbers;

  // `program`: with options
  Run(const std::string& program, const std::string& file, const std::string& json)
  {
    std::filesystem::remove(json);
    const int result = std::system(("ulimit -S -t 30; " + program + " '" + file + "' --quiet --json '" + json
                                    + "' > /dev/null 2> '" + json + ".err'").c_str());
    if(WIFEXITED(result))
      status = WEXITSTATUS(result) > 128 && WEXITSTATUS(result) != status_after_time ? -1 : WEXITSTATUS(result);
    if(status == 0 || status == 1)
      numbers = nlohmann::json::parse(content(json), nullptr, false);
  }

  // What is wrong with it, or nothing. `number_of_faces`: of the file before it was damaged
  std::string fault(std::size_t number_of_faces) const
  {
    if(status == -1)
      return "crash";
    if(status == status_after_time)
      return "more than 30 seconds";
    if(status != 0 && status != 1)
      return status == 2 ? std::string() : "exit status " + std::to_string(status);
    if(!numbers.is_object())
      return "no numbers";
    if(status == 0 && (numbers["meshed_faces"].get<std::size_t>() + numbers["closed_up"].size() < number_of_faces
                       || (numbers["shape_closed"].get<bool>() && !numbers["closed"].get<bool>())))
      return "false success";
    return "";
  }
};

} // namespace damaged_files

#endif // DAMAGED_FILES_H
