// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The compiled part of the Python module: what it contains is told by _core.pyi.
#include "Surface_mesher.h"
#include "Watched_meshing.h"
#ifdef PARAMETRIC_SURFACE_MESHER_PYTHON_WITH_CAD
#include "Meshed_cad_file.h"
#endif

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace py = pybind11;
using namespace py::literals;

namespace {

// An array of numbers with a shape that begins with the number of rows. Indices become signed, as NumPy's are.
template <class Row>
py::array array_of(const std::vector<Row>& rows, std::vector<py::ssize_t> shape_of_row)
{
  typedef typename Row::value_type Number;
  shape_of_row.insert(shape_of_row.begin(), py::ssize_t(rows.size()));
  typedef std::conditional_t<std::is_floating_point<Number>::value, double, std::int64_t> Numpy_number;
  py::array_t<Numpy_number> result(shape_of_row);
  Numpy_number* out = result.mutable_data();
  for(const Row& row : rows)
    for(const Number& x : row)
      *out++ = Numpy_number(x);
  return std::move(result);
}

py::array array_of(const std::vector<std::size_t>& numbers)
{
  py::array_t<std::int64_t> result(py::ssize_t(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), result.mutable_data());
  return std::move(result);
}

template <class Mesh>
py::dict arrays(const Mesh& mesh)
{
  const Mesh_arrays a = mesh.arrays();
  py::list groups;
  for(const auto& group : a.groups)
    groups.append(py::make_tuple(group.name, group.dimension, array_of(group.numbers)));
  return py::dict("points"_a = array_of(a.points, {3}), "triangles"_a = array_of(a.triangles, {3}), "face_ids"_a = array_of(a.face_ids),
                  "part_ids"_a = array_of(a.part_ids), "uv"_a = array_of(a.uv, {3, 2}), "edges"_a = array_of(a.edges, {2}),
                  "edge_ids"_a = array_of(a.edge_ids), "groups"_a = groups);
}

Formula make_formula(const std::vector<std::tuple<std::string, std::array<std::size_t, 3>, double>>& instructions,
                     const std::vector<std::size_t>& results)
{
  std::vector<Formula::Instruction> list;
  for(const auto& in : instructions)
    list.push_back({Formula::operation(std::get<0>(in)), std::get<1>(in), std::get<2>(in)});
  return Formula(list, results);
}

// A function of C++ that calls one of Python.
template <class Result, class... Arguments>
std::function<Result(Arguments...)> wrapped(py::object function)
{
  return [shared = share(std::move(function))](Arguments... arguments) {
    const py::gil_scoped_acquire lock;
    return (*shared)(arguments...).template cast<Result>();
  };
}

void define_surfaces(py::module_& m)
{
  py::class_<Formula>(m, "Formula")
    .def(py::init(&make_formula), "instructions"_a, "results"_a)
    .def_property_readonly("number_of_results", &Formula::number_of_results);

  py::class_<Surface>(m, "Surface")
    .def_static("formula", &Surface::formula, "formula"_a)
    .def_static("function",
                [](py::object point, py::object jet) {
                  return Surface::function(wrapped<Triple, double, double>(std::move(point)),
                                           wrapped<Surface::Jet, double, double>(std::move(jet)));
                },
                "point"_a, "jet"_a)
    .def_static("bezier", &Surface::bezier, "degree_u"_a, "degree_v"_a, "control_points"_a)
    .def_static("b_spline", &Surface::b_spline, "degree_u"_a, "degree_v"_a, "knots_u"_a, "knots_v"_a, "control_points"_a, "weights"_a)
    .def_static("read_bezier_patches", &Surface::read_bezier_patches, "file_name"_a)
    .def("jet", &Surface::jet, "u"_a, "v"_a)
    .def_property_readonly("domain", &Surface::domain);

  py::class_<Curve>(m, "Curve")
    .def_static("segment", &Curve::segment, "source"_a, "target"_a)
    .def_static("arc", &Curve::arc, "center"_a, "radius"_a, "begin"_a, "end"_a)
    .def_static("circle", &Curve::circle, "center"_a, "radius"_a)
    .def_static("formula", &Curve::formula, "formula"_a, "begin"_a, "end"_a)
    .def_static("function",
                [](py::object jet, double begin, double end) {
                  return Curve::function(wrapped<Curve::Jet, double>(std::move(jet)), begin, end);
                },
                "jet"_a, "begin"_a, "end"_a)
    .def_property_readonly("source", &Curve::source)
    .def_property_readonly("target", &Curve::target);

  py::class_<Criteria>(m, "Criteria")
    .def(py::init<>())
    .def_readwrite("max_edge", &Criteria::max_edge)
    .def_readwrite("min_edge", &Criteria::min_edge)
    .def_readwrite("gamma", &Criteria::gamma)
    .def_readwrite("angle", &Criteria::angle)
    .def_readwrite("distance", &Criteria::distance)
    .def_readwrite("detail", &Criteria::detail)
    .def_readwrite("growth", &Criteria::growth)
    .def_readwrite("closeness", &Criteria::closeness)
    .def_readwrite("size_factor", &Criteria::size_factor)
    .def_readwrite("sweeps", &Criteria::sweeps)
    .def_readwrite("self_intersections", &Criteria::self_intersections)
    .def_readwrite("threads", &Criteria::threads);
}

void define_models(py::module_& m)
{
  py::class_<Meshed_model>(m, "MeshedModel")
    .def("arrays", &arrays<Meshed_model>)
    .def("json", &Meshed_model::json)
    .def("page", &Meshed_model::page)
    .def("summary", &Meshed_model::summary)
    .def("save", &Meshed_model::save, "file_name"_a, "is_binary"_a)
    .def_property_readonly("is_whole", &Meshed_model::is_whole);

  py::class_<Surface_model>(m, "SurfaceModel")
    .def(py::init<>())
    .def_static("patch", &Surface_model::patch, "surface"_a, "loops"_a)
    .def_static("joined", &Surface_model::joined, "surfaces"_a, "rectangles"_a, "tolerance"_a)
    .def("add_vertex", &Surface_model::add_vertex, "point"_a)
    .def("add_edge", &Surface_model::add_edge, "source"_a, "target"_a, "is_collapsed"_a, "max_edge"_a)
    .def("add_face",
         [](Surface_model& model, const Surface& surface, const std::vector<std::vector<std::tuple<std::size_t, bool, Curve>>>& loops,
            bool is_reversed, double max_edge) {
           std::vector<std::vector<Surface_model::Use>> uses;
           for(const auto& loop : loops) {
             uses.emplace_back();
             for(const auto& use : loop)
               uses.back().push_back({std::get<0>(use), std::get<1>(use), std::get<2>(use)});
           }
           return model.add_face(surface, uses, is_reversed, max_edge);
         },
         "surface"_a, "loops"_a, "is_reversed"_a, "max_edge"_a)
    .def("add_hole", &Surface_model::add_hole, "face"_a, "loop"_a)
    .def("orient_faces", &Surface_model::orient_faces)
    .def("set_tolerance", &Surface_model::set_tolerance, "tolerance"_a)
    .def_property_readonly("numbers", &Surface_model::numbers)
    .def("mesh",
         [](const Surface_model& model, const Criteria& criteria, py::object progress, py::object size, std::optional<double> time_limit,
            bool handles_interrupts) {
           Watched_meshing watched(std::move(progress), std::move(size), time_limit, handles_interrupts);
           return watched([&](const Mesh_callbacks& callbacks) { return model.mesh(criteria, callbacks); });
         },
         "criteria"_a, "progress"_a, "size"_a, "time_limit"_a, "handles_interrupts"_a);
}

#ifdef PARAMETRIC_SURFACE_MESHER_PYTHON_WITH_CAD
void define_cad(py::module_& m)
{
  py::class_<Meshed_cad_file>(m, "MeshedCadFile")
    .def("arrays", &arrays<Meshed_cad_file>)
    .def("json", &Meshed_cad_file::json)
    .def("page", &Meshed_cad_file::page)
    .def("summary", &Meshed_cad_file::summary)
    .def("save", &Meshed_cad_file::save, "file_name"_a, "is_binary"_a, "node_parameters"_a, py::call_guard<py::gil_scoped_release>())
    .def_property_readonly("is_whole", &Meshed_cad_file::is_whole);
  m.def("mesh_cad",
        [](const std::vector<std::string>& arguments, py::object progress, py::object size, std::optional<double> time_limit,
           bool handles_interrupts) {
          Watched_meshing watched(std::move(progress), std::move(size), time_limit, handles_interrupts);
          return watched([&](const Mesh_callbacks& callbacks) { return Meshed_cad_file(arguments, callbacks); });
        },
        "arguments"_a, "progress"_a, "size"_a, "time_limit"_a, "handles_interrupts"_a);
  m.def("cad_options", &Meshed_cad_file::options);
}
#else
void define_cad(py::module_&) {}
#endif

} // namespace

PYBIND11_MODULE(_core, m)
{
  // Errors of the mesher, apart from those that functions of Python raise.
  static const py::handle core_error = py::exception<std::runtime_error>(m, "CoreError", PyExc_RuntimeError).release(); // never destroyed
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      std::rethrow_exception(error);
    }
    catch(const py::error_already_set&) {
      throw;
    }
    catch(const py::builtin_exception&) {
      throw;
    }
    catch(const std::runtime_error& runtime_error) {
      PyErr_SetString(core_error.ptr(), runtime_error.what());
    }
  });
  define_surfaces(m);
  define_models(m);
  define_cad(m);
}
