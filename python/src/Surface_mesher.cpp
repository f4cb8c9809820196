// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "Surface_data.h"

#include "Output_files.h"
#include "Progress_line.h"
#include "Unmet_count.h"
#include "distance_findings.h"
#include "distance_over_triangle.h"
#include "findings_of_report.h"
#include "summary_lines.h"
#include "text_of_numbers.h"
#include "write_mesh_file.h"
#include "write_page.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Element_mesh_3.h>
#include <CGAL/IO/write_BDF.h>
#include <CGAL/IO/write_INP.h>
#include <CGAL/IO/write_MSH.h>
#include <CGAL/IO/write_UNV.h>
#include <CGAL/IO/write_element_VTU.h>
#include <CGAL/Parametric_surface_mesher/internal/measures/pieces_of_patches.h>
#include <CGAL/Rectangular_patch_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Triangle_mesh_quality.h>
#include <CGAL/make_mesh_page.h>
#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <nlohmann/json.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace {

typedef CGAL::Parametric_surface_model_3<Any_surface> Model;
typedef CGAL::Parametric_domain_2<Kernel> Domain;
typedef CGAL::Surface_mesh<Point_3> Mesh;

} // namespace

struct Surface_model::Data
{
  Model model;
};

Surface_model::Surface_model() : m_data(std::make_shared<Data>()) {}

namespace {

Domain::Loop to_loop(const Loop& loop)
{
  Domain::Loop result;
  for(const Curve& curve : loop)
    result.push_back(curve.data().curve);
  return result;
}

// Takes the surfaces of another model for any surfaces.
template <class OtherModel>
Model with_any_surfaces(const OtherModel& other)
{
  Model result;
  for(const auto& vertex : other.vertices())
    result.add_vertex(vertex);
  for(const auto& edge : other.edges()) {
    const std::size_t e = result.add_edge(edge.source, edge.target, edge.is_collapsed);
    result.edges()[e].tolerance = edge.tolerance;
  }
  for(const auto& face : other.faces()) {
    Model::Face any{face.surface, {}};
    for(const auto& loop : face.loops) {
      any.loops.emplace_back();
      for(const auto& use : loop)
        any.loops.back().push_back({use.edge, use.is_reversed, use.curve});
    }
    any.is_reversed = face.is_reversed;
    result.add_face(std::move(any));
  }
  result.set_tolerance(other.tolerance());
  return result;
}

} // namespace

Surface_model Surface_model::patch(const Surface& surface, const std::vector<Loop>& loops)
{
  if(loops.empty())
    throw std::invalid_argument("a domain must have a boundary");
  Domain domain(to_loop(loops.front()));
  for(std::size_t i = 1; i < loops.size(); ++i)
    domain.add_hole(to_loop(loops[i]));
  Surface_model result;
  result.m_data->model = CGAL::Parametric_surface_mesher::internal::model_of_patch(surface.data().surface, domain);
  return result;
}

Surface_model Surface_model::joined(const std::vector<Surface>& surfaces, const std::vector<Rectangle>& rectangles, double tolerance)
{
  std::vector<CGAL::Rectangular_patch_3<Any_surface>> patches;
  for(std::size_t i = 0; i < surfaces.size(); ++i) {
    const Rectangle& r = rectangles.at(i);
    patches.emplace_back(surfaces[i].data().surface, r[0], r[1], r[2], r[3]);
  }
  Surface_model result;
  result.m_data->model = with_any_surfaces(CGAL::make_model_of_rectangular_patches(patches, tolerance));
  return result;
}

std::size_t Surface_model::add_vertex(const Triple& point) { return m_data->model.add_vertex(to_point(point)); }

std::size_t Surface_model::add_edge(std::size_t source, std::size_t target, bool is_collapsed, double max_edge)
{
  const std::size_t edge = m_data->model.add_edge(source, target, is_collapsed);
  m_data->model.edges()[edge].max_edge = max_edge;
  return edge;
}

std::size_t Surface_model::add_face(const Surface& surface, const std::vector<std::vector<Use>>& loops, bool is_reversed, double max_edge)
{
  Model::Face face{surface.data().surface, {}};
  for(const auto& loop : loops) {
    face.loops.emplace_back();
    for(const Use& use : loop)
      face.loops.back().push_back({use.edge, use.is_reversed, use.curve.data().curve});
  }
  face.is_reversed = is_reversed;
  face.max_edge = max_edge;
  return m_data->model.add_face(std::move(face));
}

// Each curve becomes an edge between vertices of its own.
void Surface_model::add_hole(std::size_t face, const Loop& loop)
{
  Model& model = m_data->model;
  if(face >= model.faces().size())
    throw std::out_of_range("there is no face " + std::to_string(face) + " in the model");
  const Any_surface& surface = model.faces()[face].surface;
  // What closes and joins the curves is the same as for the domain of a single patch.
  const Model hole = CGAL::Parametric_surface_mesher::internal::model_of_patch(surface, Domain(to_loop(loop)));
  const std::size_t first_vertex = model.vertices().size(), first_edge = model.edges().size();
  for(const auto& vertex : hole.vertices())
    model.add_vertex(vertex);
  for(const auto& edge : hole.edges())
    model.add_edge(first_vertex + edge.source, first_vertex + edge.target, edge.is_collapsed);
  model.faces()[face].loops.emplace_back();
  for(const auto& use : hole.faces().front().loops.front())
    model.faces()[face].loops.back().push_back({first_edge + use.edge, use.is_reversed, use.curve});
}

void Surface_model::orient_faces() { CGAL::Parametric_surface_mesher::orient_faces(m_data->model); }

void Surface_model::set_tolerance(double tolerance) { m_data->model.set_tolerance(tolerance); }

std::array<std::size_t, 3> Surface_model::numbers() const
{
  return {m_data->model.vertices().size(), m_data->model.edges().size(), m_data->model.faces().size()};
}

struct Meshed_model::Data
{
  Model model;
  Mesh mesh;
  Mesh::Property_map<Mesh::Halfedge_index, Point_2> uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  Mesh::Property_map<Mesh::Face_index, std::size_t> patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch").first;
  Mesh::Property_map<Mesh::Edge_index, CGAL::Parametric_surface_mesher::Edge_place> edge_place
    = mesh.add_property_map<Mesh::Edge_index, CGAL::Parametric_surface_mesher::Edge_place>("e:place").first;
  CGAL::Parametric_surface_mesh_criteria criteria; // with the default sizes filled in
  CGAL::Parametric_surface_mesh_report report;
  CGAL::Triangle_mesh_quality quality;
  double distance = 0; // the largest one that was measured from the surfaces

  // Where the mesh lies in the model, as named parameters.
  auto places() const
  {
    namespace parameters = CGAL::parameters;
    return parameters::halfedge_uv_map(uv, parameters::face_patch_id_map(patch, parameters::edge_place_map(edge_place)));
  }
};

namespace {

CGAL::Parametric_surface_mesher::Self_intersections self_intersections(const std::string& name)
{
  typedef CGAL::Parametric_surface_mesher::Self_intersections Self_intersections;
  const std::map<std::string, Self_intersections> values{
    {"ignore", Self_intersections::IGNORED}, {"report", Self_intersections::REPORTED}, {"refine", Self_intersections::REFINED}};
  const auto found = values.find(name);
  if(found == values.end())
    throw std::invalid_argument("self_intersections: '" + name + "' must be refine, report or ignore");
  return found->second;
}

CGAL::Parametric_surface_mesh_criteria to_criteria(const Criteria& c)
{
  CGAL::Parametric_surface_mesh_criteria result;
  const auto set = [&](const auto& value, auto setter) {
    if(value)
      (result.*setter)(*value);
  };
  typedef CGAL::Parametric_surface_mesh_criteria Result;
  set(c.max_edge, &Result::set_max_edge);
  set(c.min_edge, &Result::set_min_edge);
  set(c.gamma, &Result::set_gamma);
  set(c.angle, &Result::set_angle);
  set(c.distance, &Result::set_distance);
  set(c.detail, &Result::set_detail);
  set(c.growth, &Result::set_growth);
  set(c.closeness, &Result::set_closeness);
  set(c.size_factor, &Result::set_size_factor);
  set(c.sweeps, &Result::set_max_number_of_sweeps);
  result.set_self_intersections(self_intersections(c.self_intersections));
  return result;
}

// The largest distance of the mesh from its surfaces, measured on the threads that meshing has.
template <class Data>
double largest_distance(const Data& data)
{
  using namespace CGAL::Parametric_surface_mesher::internal;
  if(data.mesh.number_of_faces() == 0)
    return 0;
  mesh_patch::Triangle_tree tree(data.mesh.faces().begin(), data.mesh.faces().end(), data.mesh);
  tree.build();
  tree.accelerate_distance_queries(); // else the first of the threads would do it, and the others wait
  const auto pieces = pieces_of_patches(data.mesh.faces(), [&](auto f) { return data.patch[f]; });
  std::vector<double> squared(pieces.size());
  for_each_piece<CGAL::Parallel_if_available_tag>(
    data.model, pieces, [&](const auto& piece, std::size_t i, const Model::Surface_3& surface) {
      for(const auto f : piece.faces)
        squared[i] = mesh_patch::largest_squared_distance(squared[i], mesh_patch::corners_of_triangle(data.mesh, data.uv, f), surface, tree);
    });
  return std::sqrt(*std::max_element(squared.begin(), squared.end()));
}

// Meshes and measures, on as many threads as are wanted.
template <class Data>
void mesh_and_measure(const Model& model, const Criteria& given, Progress_line& progress, Data& data)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, (std::max)(given.threads, 1u));
#else
  if(given.threads > 1)
    throw std::invalid_argument("threads: " + std::to_string(given.threads) + " must be 1, since this module was built without oneTBB");
#endif
  data.report = CGAL::make_parametric_surface_mesh<CGAL::Parallel_if_available_tag>(model, data.criteria, data.mesh,
                                                                                    data.places().visitor(std::ref(progress)));
  data.criteria.set_max_edge(data.report.max_edge).set_min_edge(data.report.min_edge);
  progress.on_phase("measuring");
  data.distance = largest_distance(data);
  data.quality = CGAL::triangle_mesh_quality(data.mesh);
}

} // namespace

Meshed_model Surface_model::mesh(const Criteria& given, const Mesh_callbacks& callbacks) const
{
  if(m_data->model.faces().empty())
    throw std::invalid_argument("the model has no face");
  Model model = m_data->model;
  if(callbacks.size)
    model.set_sizing_field([size = callbacks.size](const Point_3& p) { return size(p.x(), p.y(), p.z()); });
  const auto data = std::make_shared<Meshed_model::Data>();
  data->model = m_data->model;
  data->criteria = to_criteria(given);
  Progress_line progress(true, callbacks);
  mesh_and_measure(model, given, progress, *data);
  Meshed_model result;
  result.m_data = data;
  return result;
}

Mesh_arrays Meshed_model::arrays() const
{
  const Mesh& mesh = m_data->mesh;
  Mesh_arrays arrays;
  for(const auto v : mesh.vertices())
    arrays.points.push_back(to_triple(mesh.point(v)));
  for(const auto f : mesh.faces()) {
    arrays.triangles.emplace_back();
    arrays.uv.emplace_back();
    std::size_t i = 0;
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      arrays.triangles.back()[i] = std::size_t(mesh.target(h));
      arrays.uv.back()[2 * i] = m_data->uv[h].x();
      arrays.uv.back()[2 * i++ + 1] = m_data->uv[h].y();
    }
    arrays.face_ids.push_back(m_data->patch[f] + 1);
    arrays.part_ids.push_back(0);
  }
  for(const auto e : mesh.edges())
    if(m_data->edge_place[e].index != CGAL::Parametric_surface_mesher::Edge_place::none) {
      arrays.edges.push_back({std::size_t(mesh.vertex(e, 0)), std::size_t(mesh.vertex(e, 1))});
      arrays.edge_ids.push_back(m_data->edge_place[e].index + 1);
    }
  return arrays;
}

std::string Meshed_model::json() const
{
  const auto& report = m_data->report;
  const auto& q = m_data->quality;
  const auto& s = report.seconds;
  nlohmann::ordered_json intersections = nlohmann::ordered_json::array();
  for(const auto& i : report.intersections)
    intersections.push_back({{"faces", {i.faces[0] + 1, i.faces[1] + 1}}, {"triangle_pairs", i.number_of_pairs}, {"place", i.place},
                             {"of_shape", i.is_of_surfaces}});
  nlohmann::ordered_json json = {
    {"faces", m_data->model.faces().size()}, {"vertices", q.number_of_vertices}, {"triangles", q.number_of_faces}, {"area", q.area},
    {"closed", q.is_closed}, {"components", q.number_of_connected_components}, {"max_edge", report.max_edge}, {"min_edge", report.min_edge},
    {"min_angle", q.min_angle}, {"mean_min_angle", q.mean_min_angle}, {"mean_radius_ratio", q.mean_radius_ratio},
    {"distance", m_data->distance}, {"self_intersections", intersections}, {"unmet_by", mesh_patch::json_of_unmet(report)},
    {"unjudged", report.number_of_unjudged_faces}, {"work_limits", report.number_of_work_limits}, {"stopped", report.is_stopped},
    {"meshing_phases", {{"division", s.division}, {"triangulation", s.triangulation}, {"refinement", s.refinement},
                        {"improvement", s.improvement}, {"intersections", s.intersections}, {"output", s.output}}}};
  return json.dump();
}

namespace {

template <class Data>
Mesh_findings findings(const Data& data)
{
  const mesh_patch::Text_of_length length;
  const auto& distance = data.criteria.distance();
  Mesh_findings found;
  mesh_patch::add_stop(data.report, found);
  mesh_patch::add_unmet(data.report, data.criteria, length, found);
  if(distance)
    mesh_patch::add_distance("surface", data.distance, *distance, found);
  mesh_patch::add_intersections(data.report, [](std::size_t face) { return face + 1; }, found);
  return found;
}

} // namespace

bool Meshed_model::is_whole() const { return findings(*m_data).faults.empty(); }

std::string Meshed_model::summary() const
{
  const CGAL::Bbox_3 box = mesh_patch::box_of(m_data->mesh);
  const auto& allowed = m_data->criteria.distance();
  std::ostringstream out;
  out << "mesh of " << mesh_patch::plural(m_data->model.faces().size(), "face") << "; "
      << mesh_patch::text_of_size(mesh_patch::sides(box)) << "\n";
  mesh_patch::print_triangles(out, m_data->quality);
  mesh_patch::print_angles(out, m_data->quality, mesh_patch::number_below_10_degrees(m_data->quality));
  mesh_patch::print_distance(out, "surface", &m_data->distance, allowed ? &*allowed : nullptr, mesh_patch::text_of_length(box));
  mesh_patch::print_findings(out, findings(*m_data));
  return out.str();
}

std::string Meshed_model::page() const
{
  const std::string title = "mesh";
  mesh_patch::check_page(title);
  std::ostringstream out;
  mesh_patch::write_page(out, CGAL::make_mesh_page(m_data->model, m_data->mesh, m_data->report, m_data->places()), title, "", summary());
  return out.str();
}

namespace {

// Each face of the model is a surface with its number, each of its edges a curve.
CGAL::Element_mesh_3 element_mesh(const Mesh_arrays& arrays, std::size_t number_of_faces)
{
  CGAL::Element_mesh_3 elements;
  elements.nodes = arrays.points;
  const std::size_t none = CGAL::Element_mesh_3::none;
  for(std::size_t i = 0; i < number_of_faces; ++i) {
    elements.surfaces.emplace_back();
    elements.surfaces.back().number = i + 1;
  }
  for(std::size_t i = 0; i < arrays.triangles.size(); ++i) {
    const auto& t = arrays.triangles[i];
    elements.triangles.push_back({{t[0], t[1], t[2], none, none, none}});
    elements.triangle_surfaces.push_back(arrays.face_ids[i] - 1);
  }
  std::map<std::size_t, std::size_t> curves; // by number
  for(std::size_t i = 0; i < arrays.edges.size(); ++i) {
    const auto found = curves.emplace(arrays.edge_ids[i], elements.curves.size());
    if(found.second) {
      elements.curves.emplace_back();
      elements.curves.back().number = arrays.edge_ids[i];
    }
    elements.lines.push_back({{arrays.edges[i][0], arrays.edges[i][1], none}});
    elements.line_curves.push_back(found.first->second);
  }
  return elements;
}

} // namespace

void Meshed_model::save(const std::string& file_name, bool is_binary) const
{
  typedef bool (*Writer)(std::ostream&, const CGAL::Element_mesh_3&);
  const std::vector<std::pair<std::string, Writer>> writers{
    {".vtu", CGAL::IO::write_VTU}, {".msh", CGAL::IO::write_MSH}, {".msh2", CGAL::IO::write_MSH_2},
    {".inp", CGAL::IO::write_INP}, {".bdf", CGAL::IO::write_BDF}, {".unv", CGAL::IO::write_UNV}};
  std::vector<std::string> endings{".off", ".obj", ".ply", ".stl"};
  for(const auto& writer : writers)
    endings.push_back(writer.first);
  mesh_patch::check_ending("save", file_name, endings);
  Output_files files;
  files.add(file_name, [&](std::ostream& out) {
    if(is_binary)
      CGAL::IO::set_binary_mode(out);
    for(const auto& writer : writers)
      if(mesh_patch::has_ending(file_name, writer.first)) {
        if(!writer.second(out, element_mesh(arrays(), m_data->model.faces().size())))
          out.setstate(std::ios::failbit);
        return;
      }
    mesh_patch::write_mesh(out, file_name, m_data->mesh, [](std::size_t patch) { return patch + 1; });
  });
  files.write();
}
