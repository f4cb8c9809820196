// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the mesher on a random input.
#ifndef PARAMETRIC_SURFACE_MESHER_TEST_MESH_FUZZ_CASE_H
#define PARAMETRIC_SURFACE_MESHER_TEST_MESH_FUZZ_CASE_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Parametric_surface_mesh_visitor.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <Fuzz_case.h>
#include <Mesh_with_domain.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>

typedef Mesh_with_domain<Fuzz_kernel> Fuzz_mesh;

// What became of an input.
struct Fuzz_outcome
{
  std::string refusal, broken; // what was thrown, if it may be, and if it may not
  bool is_mesh() const { return refusal.empty() && broken.empty(); }
};

#ifdef CGAL_LINKED_WITH_TBB
typedef CGAL::Parallel_tag Fuzz_concurrency_tag;
#else
typedef CGAL::Sequential_tag Fuzz_concurrency_tag;
#endif

// Says stop after some questions, and again whenever it is asked afterwards.
struct Fuzz_visitor : CGAL::Parametric_surface_mesh_visitor
{
  std::optional<std::size_t> questions_left;

  bool go_further() { return !questions_left || (*questions_left > 0 && --*questions_left > 0); }
};

template <class ConcurrencyTag>
void mesh_fuzz_case_with(const Fuzz_case& fuzz_case, const CGAL::Parametric_surface_mesh_criteria& criteria, Fuzz_mesh& result)
{
  Fuzz_visitor visitor;
  visitor.questions_left = fuzz_case.number_of_questions;
  const auto np = CGAL::parameters::halfedge_uv_map(
    result.halfedge_uv, CGAL::parameters::face_patch_id_map(result.patch_id, CGAL::parameters::metric_field(fuzz_case.metric)))
                    .visitor(std::ref(visitor));
  result.report = fuzz_case.model
                    ? CGAL::make_parametric_surface_mesh<ConcurrencyTag>(*fuzz_case.model, criteria, result.mesh, np)
                    : CGAL::make_parametric_surface_mesh<ConcurrencyTag>(*fuzz_case.surface, *fuzz_case.domain, criteria,
                                                                         result.mesh, np);
}

inline Fuzz_outcome mesh_fuzz_case(const Fuzz_case& fuzz_case, const CGAL::Parametric_surface_mesh_criteria& criteria,
                                   bool has_threads, Fuzz_mesh& result)
{
  const std::uint64_t evaluations_for_any_input = 60000000;
  fuzz_case.work->allow(evaluations_for_any_input);
  Fuzz_outcome outcome;
  try {
    if(has_threads)
      mesh_fuzz_case_with<Fuzz_concurrency_tag>(fuzz_case, criteria, result);
    else
      mesh_fuzz_case_with<CGAL::Sequential_tag>(fuzz_case, criteria, result);
  } catch(const CGAL::Parametric_surface_mesh_error& error) {
    outcome.refusal = error.what();
  } catch(const std::exception& error) {
    outcome.broken = error.what();
  }
  fuzz_case.work->allow(~std::uint64_t(0));
  return outcome;
}

#endif // PARAMETRIC_SURFACE_MESHER_TEST_MESH_FUZZ_CASE_H
