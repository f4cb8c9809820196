// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Meshed_cad_file.h"

#include "Mesh_cad_findings.h"
#include "Mesh_cad_json.h"
#include "Mesh_cad_options.h"
#include "Mesh_cad_output.h"
#include "Mesh_cad_result.h"
#include "Mesh_cad_summary.h"
#include "print_version.h"

#include <Standard_Version.hxx>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

// returns the exit status
int run(const Mesh_cad_options& options)
{
  if(options.is_list_wanted || options.is_face_list_wanted) {
    mesh_cad::list(std::cout, options);
    return 0;
  }
  Mesh_cad_result result;
  const Output_files files = mesh_cad::output_files(options, result);
  mesh_cad::mesh_and_measure(options, result);
  files.write();
  if(!options.is_quiet)
    mesh_cad::print_summary(std::cout, options, result);
  return mesh_cad::findings(options, result).faults.empty() ? 0 : 1;
}

int fail(std::string message)
{
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "mesh_cad: " << message << "\n";
  return 2;
}

Mesh_cad_options read_options(std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), "mesh_cad");
  std::vector<char*> words;
  for(std::string& argument : arguments)
    words.push_back(&argument[0]);
  return read_mesh_cad_options(int(words.size()), words.data());
}

// Appends those edges of the mesh that lie on edges of the shape.
void append_edges(const Mesh_cad_result& result, Mesh_arrays& arrays)
{
  const auto shape_edges = CGAL::Parametric_surface_mesher::internal::shape_edges_of_model(result.shape);
  const auto& mesh = result.mesh.mesh;
  for(const auto e : mesh.edges()) {
    const std::size_t edge = result.mesh.edge_place[e].index;
    if(edge >= shape_edges.size() || shape_edges[edge] == CGAL::Open_cascade_model_3::none)
      continue;
    arrays.edges.push_back({std::size_t(mesh.vertex(e, 0)), std::size_t(mesh.vertex(e, 1))});
    arrays.edge_ids.push_back(shape_edges[edge] + 1);
  }
}

void append_groups(const CGAL::Element_mesh_3& elements, Mesh_arrays& arrays)
{
  for(const auto& group : elements.groups) {
    Mesh_arrays::Group named{group.name, group.dimension, {}};
    for(const std::size_t i : group.entities)
      named.numbers.push_back(group.dimension == 3   ? elements.parts[i].number
                              : group.dimension == 2 ? elements.surfaces[i].number
                              : group.dimension == 1 ? elements.curves[i].number
                                                     : elements.vertices[i].number);
    arrays.groups.push_back(std::move(named));
  }
  for(const auto& part : elements.parts)
    arrays.groups.push_back({part.name, 3, {part.number}});
}

} // namespace

int run_mesh_cad(int argc, char** argv)
{
  try {
    const Mesh_cad_options options = read_mesh_cad_options(argc, argv);
    if(options.is_help_wanted)
      mesh_cad::print_help(std::cout);
    else if(options.is_version_wanted)
      print_version(std::cout, "mesh_cad", {"Open CASCADE " OCC_VERSION_COMPLETE});
    else
      return run(options);
    return 0;
  }
  catch(const std::bad_alloc&) {
    return fail("the memory is too small for this mesh; choose a larger --max-edge or --min-edge");
  }
  catch(const std::exception& error) {
    return fail(error.what());
  }
}

struct Meshed_cad_file::Data
{
  Mesh_cad_options options;
  Mesh_cad_result result;
};

Meshed_cad_file::Meshed_cad_file(const std::vector<std::string>& arguments, const Mesh_callbacks& callbacks)
{
  const auto data = std::make_shared<Data>();
  data->options = read_options(arguments);
  data->options.is_quiet = true;
  data->options.out = "mesh.vtu"; // which shows all that is measured of triangles
  data->options.page = "mesh.html";
  data->options.callbacks = callbacks;
  mesh_cad::mesh_and_measure(data->options, data->result);
  data->options.callbacks = Mesh_callbacks(); // what they refer to may go
  m_data = data;
}

Mesh_arrays Meshed_cad_file::arrays() const
{
  const Mesh_cad_result& result = m_data->result;
  Mesh_arrays arrays;
  mesh_cad::Elements elements = mesh_cad::elements(result);
  arrays.points = std::move(elements.points);
  arrays.triangles = std::move(elements.triangles);
  arrays.face_ids = std::move(elements.face_ids);
  const auto parts = CGAL::Parametric_surface_mesher::internal::parts_of_model_faces(result.shape, result.names);
  for(const auto f : result.mesh.mesh.faces()) {
    const std::size_t part = parts[result.mesh.patch[f]];
    arrays.part_ids.push_back(part == mesh_cad::Names::none ? 0 : part + 1);
    arrays.uv.emplace_back();
    std::size_t i = 0;
    for(const auto h : result.mesh.mesh.halfedges_around_face(result.mesh.mesh.halfedge(f))) {
      arrays.uv.back()[i++] = result.mesh.uv[h].x();
      arrays.uv.back()[i++] = result.mesh.uv[h].y();
    }
  }
  append_edges(result, arrays);
  append_groups(mesh_cad::element_mesh(m_data->options, result), arrays);
  return arrays;
}

std::string Meshed_cad_file::json() const
{
  std::ostringstream out;
  mesh_cad::write_json(out, m_data->options, m_data->result);
  return out.str();
}

std::string Meshed_cad_file::summary() const
{
  std::ostringstream out;
  mesh_cad::print_summary(out, m_data->options, m_data->result);
  return out.str();
}

std::string Meshed_cad_file::page() const
{
  std::ostringstream out;
  mesh_patch::check_page(m_data->options.page);
  mesh_cad::write_page(out, m_data->options, m_data->result);
  return out.str();
}

bool Meshed_cad_file::is_whole() const { return mesh_cad::findings(m_data->options, m_data->result).faults.empty(); }

void Meshed_cad_file::save(const std::string& file_name, bool is_binary, bool are_node_parameters_wanted) const
{
  Mesh_cad_options options = m_data->options;
  options.out = file_name;
  options.page.clear();
  options.is_binary = is_binary;
  options.are_node_parameters_wanted = are_node_parameters_wanted;
  mesh_cad::output_files(options, m_data->result).write();
}

std::vector<std::pair<std::string, std::string>> Meshed_cad_file::options()
{
  Mesh_cad_options defaults;
  std::vector<std::pair<std::string, std::string>> result;
  const auto described = mesh_cad::described_options(defaults);
  for(const auto& option : described.options())
    result.emplace_back(option->long_name(), option->description());
  return result;
}
