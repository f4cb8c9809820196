// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything that one run of the mesher takes.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_FUZZ_CASE_H
#define PARAMETRIC_SURFACE_MESHER_TEST_FUZZ_CASE_H

#include <CGAL/Parametric_domain_2.h>
#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_model_3.h>

#include <Fuzz_surface.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

typedef Fuzz_surface::Geom_traits Fuzz_kernel;
typedef CGAL::Parametric_domain_2<Fuzz_kernel> Fuzz_domain;

// What has to become of an input.
enum class Fuzz_expectation
{
  MESH,   // a mesh: nothing is wrong with it
  REFUSAL,
  ANY     // either: it is at the limit of what can be meshed
};

typedef CGAL::Parametric_surface_model_3<Fuzz_surface> Fuzz_model;

struct Fuzz_case
{
  std::uint64_t seed = 0;
  std::shared_ptr<Fuzz_work> work = std::make_shared<Fuzz_work>(); // of all surfaces
  // one patch, or a model
  std::optional<Fuzz_surface> surface;
  std::optional<Fuzz_domain> domain;
  std::optional<Fuzz_model> model;
  bool is_model_closed = false;
  CGAL::Parametric_surface_mesh_criteria criteria;
  Fuzz_metric metric;
  std::optional<std::size_t> number_of_questions; // after which the visitor says stop
  bool has_threads = false;
  Fuzz_expectation expectation = Fuzz_expectation::MESH;
  std::string description;
};

#endif // PARAMETRIC_SURFACE_MESHER_TEST_FUZZ_CASE_H
