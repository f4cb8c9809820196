// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many faces: the stop by a visitor in each phase, what bad faces cost, surfaces that are not evaluated by several threads.
#include <gtest/gtest.h>

#include <CGAL/Any_parametric_surface_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Parametric_surface_mesh_visitor.h>
#include <CGAL/Parametric_surface_mesher/internal/support/run_jobs.h>
#include <CGAL/Rectangular_patch_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>

#include <check_invariants.h>
#include <mesher_test_helpers.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// Where a wave is not finite: by the distance from the middle of its tile, in the square norm, and by how far the place is
// from those at multiples of 1/8, where models are checked.
struct Hole
{
  double from = 1, to = 0, distance_from_checked = 0;

  bool contains(double u, double v) const
  {
    const double r = (std::max)(std::fabs(u - std::floor(u) - 0.5), std::fabs(v - std::floor(v) - 0.5));
    return from <= r && r < to && (std::max)(distance(u), distance(v)) >= distance_from_checked;
  }

private:
  static double distance(double x) { return std::fabs(8 * x - std::round(8 * x)) / 8; }
};

const Hole in_the_middle{0, 0.2}, between_checked_points{0.499, 1, 0.02}, all_around{0.499, 1};

// (u, v, 0.1 sin(pi u) sin(pi v)), a function that counts its evaluations, and how many of these go on at the same time
class Wave
{
  Hole m_hole;
  bool m_is_independent;

public:
  typedef Test_kernel Geom_traits;
  typedef Geom_traits::Point_3 Point_3;

  struct Counters
  {
    std::atomic<std::size_t> evaluations{0}, at_work{0};
    std::atomic<bool> were_several_at_work{false};
    bool have_holes = false; // models are built before they have

    // as of the time when a model is built
    void begin()
    {
      evaluations = 0;
      have_holes = true;
    }
  };

private:
  Counters* m_counters;

public:
  Wave(Counters& counters, const Hole& hole = Hole(), bool is_independent = true)
    : m_hole(hole), m_is_independent(is_independent), m_counters(&counters)
  {}

  bool has_independent_copies() const { return m_is_independent; }

  Point_3 point(double u, double v) const { return jet(u, v).point; }

  CGAL::Surface_jet_3<Test_kernel> jet(double u, double v) const
  {
    ++m_counters->evaluations;
    if(++m_counters->at_work > 1)
      m_counters->were_several_at_work = true;
    const double w = CGAL_PI, h = 0.1;
    const double su = std::sin(w * u), cu = std::cos(w * u), sv = std::sin(w * v), cv = std::cos(w * v);
    const double z = m_counters->have_holes && m_hole.contains(u, v) ? NAN : h * su * sv;
    --m_counters->at_work;
    return {Point_3(u, v, z),
            Vector_3(1, 0, h * w * cu * sv),
            Vector_3(0, 1, h * w * su * cv),
            Vector_3(0, 0, -h * w * w * su * sv),
            Vector_3(0, 0, h * w * w * cu * cv),
            Vector_3(0, 0, -h * w * w * su * sv)};
  }
};

typedef CGAL::Rectangular_patch_3<Wave> Tile;
typedef CGAL::Parametric_surface_model_3<Tile> Model;

// `wave`: of the tile with a number
template <class Wave_of_tile>
Model tiles(int columns, int rows, const Wave_of_tile& wave)
{
  std::vector<Tile> result;
  for(int i = 0; i < columns; ++i)
    for(int j = 0; j < rows; ++j)
      result.emplace_back(wave(i * rows + j), i, i + 1, j, j + 1);
  return CGAL::make_model_of_rectangular_patches(result);
}

struct Stopping_visitor : CGAL::Parametric_surface_mesh_visitor
{
  std::string last_phase; // it stops when that begins
  std::size_t number_of_questions = 0;
  bool is_stopping = false, was_asked_after_stop = false;

  explicit Stopping_visitor(const std::string& phase) : last_phase(phase) {}

  void on_phase(const char* name) { is_stopping = is_stopping || name == last_phase; }

  bool go_further()
  {
    was_asked_after_stop = was_asked_after_stop || m_has_said_stop;
    ++number_of_questions;
    m_has_said_stop = is_stopping;
    return !is_stopping;
  }

private:
  bool m_has_said_stop = false;
};

template <class ConcurrencyTag, class AnyModel>
Report mesh_with_visitor(const AnyModel& model, const Criteria& criteria, Stopping_visitor& visitor, Mesh& mesh)
{
  return CGAL::make_parametric_surface_mesh<ConcurrencyTag>(model, criteria, mesh,
                                                            CGAL::parameters::visitor(std::ref(visitor)));
}

// a mesh of all tiles with one border around, without a crack
void check_is_whole(const Mesh& mesh, const Model& model)
{
  EXPECT_TRUE(mesh.is_valid());
  double length_of_border = 0, area = 0;
  for(const auto e : mesh.edges())
    length_of_border += mesh.is_border(e) ? length(mesh, e) : 0;
  for(const auto f : mesh.faces()) {
    const auto v = corners(mesh, f);
    const Point_3 &p = mesh.point(v[0]), &q = mesh.point(v[1]), &r = mesh.point(v[2]);
    area += 0.5 * ((q.x() - p.x()) * (r.y() - p.y()) - (r.x() - p.x()) * (q.y() - p.y()));
  }
  double x = 0, y = 0;
  for(const auto& p : model.vertices()) {
    x = (std::max)(x, p.x());
    y = (std::max)(y, p.y());
  }
  EXPECT_NEAR(2 * (x + y), length_of_border, 1e-9);
  EXPECT_NEAR(x * y, area, 1e-9);
}

std::vector<Point_3> sorted_points(const Mesh& mesh)
{
  std::vector<Point_3> result;
  for(const auto v : mesh.vertices())
    result.push_back(mesh.point(v));
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::size_t> numbers_of(const std::vector<Report::Left_out_face>& faces)
{
  std::vector<std::size_t> result;
  for(const auto& face : faces)
    result.push_back(face.face);
  return result;
}

// Whether some triangles are said to be unfinished, or not to have been compared with the surface.
bool tells_of_stop(const Report& report)
{
  return report.count(CGAL::Parametric_surface_mesher::Unmet_cause::STOPPED) + report.number_of_unjudged_faces > 0;
}

} // namespace

// A model of many small patches, each too small for a question of its own by the number of its vertices.
TEST(Stop, at_once)
{
  Wave::Counters counters;
  const Model model = tiles(20, 20, [&](int) { return Wave(counters); });
  Stopping_visitor visitor("division");
  Mesh mesh;
  const Report report = mesh_with_visitor<CGAL::Sequential_tag>(model, Criteria().set_max_edge(0.1), visitor, mesh);
  EXPECT_EQ(1u, visitor.number_of_questions);
  EXPECT_LE(mesh.number_of_faces(), 2 * 400u);
  EXPECT_TRUE(report.is_stopped);
  EXPECT_TRUE(tells_of_stop(report));
  check_is_whole(mesh, model);
}

TEST(Stop, in_each_phase)
{
  Wave::Counters counters;
  const Model model = tiles(4, 5, [&](int) { return Wave(counters); });
  const Criteria criteria = Criteria().set_max_edge(0.06).set_max_number_of_sweeps(5).set_closeness(1.8);
  Stopping_visitor patient("never");
  Mesh whole;
  EXPECT_FALSE(mesh_with_visitor<CGAL::Sequential_tag>(model, criteria, patient, whole).is_stopped);
  for(const std::string phase : {"division", "triangulation", "refinement", "smoothing", "improvement", "polishing"}) {
    SCOPED_TRACE(phase);
    for(const bool is_parallel : {false, true}) {
      Stopping_visitor visitor(phase);
      Mesh mesh;
      const Report report = is_parallel ? mesh_with_visitor<CGAL::Parallel_tag>(model, criteria, visitor, mesh)
                                        : mesh_with_visitor<CGAL::Sequential_tag>(model, criteria, visitor, mesh);
      EXPECT_TRUE(report.is_stopped);
      EXPECT_FALSE(visitor.was_asked_after_stop);
      EXPECT_TRUE(tells_of_stop(report));
      EXPECT_LT(mesh.number_of_faces(), whole.number_of_faces());
      check_is_whole(mesh, model);
    }
  }
}

// in the parts of a split face, and between them
TEST(Stop, of_a_split_face)
{
  Wave::Counters counters;
  const Model model = tiles(1, 1, [&](int) { return Wave(counters); });
  const Criteria criteria = Criteria().set_max_edge(0.01).set_part_size(3000);
  for(const std::string phase : {"triangulation", "refinement", "smoothing", "improvement"}) {
    SCOPED_TRACE(phase);
    Stopping_visitor visitor(phase);
    Mesh mesh;
    const Report report = mesh_with_visitor<CGAL::Parallel_tag>(model, criteria, visitor, mesh);
    EXPECT_TRUE(report.is_stopped);
    EXPECT_FALSE(visitor.was_asked_after_stop);
    EXPECT_TRUE(tells_of_stop(report));
    check_is_whole(mesh, model);
  }
}

// The mesh is whole before detail may vanish from it.
TEST(Stop, when_detail_may_vanish)
{
  Wave::Counters counters;
  const Model model = tiles(4, 5, [&](int) { return Wave(counters); });
  const Criteria criteria = Criteria().set_max_edge(0.06).set_detail(1e-4);
  Mesh whole, mesh;
  Stopping_visitor patient("never"), visitor("curing");
  EXPECT_FALSE(mesh_with_visitor<CGAL::Sequential_tag>(model, criteria, patient, whole).is_stopped);
  const Report report = mesh_with_visitor<CGAL::Sequential_tag>(model, criteria, visitor, mesh);
  EXPECT_TRUE(report.is_stopped);
  EXPECT_FALSE(visitor.was_asked_after_stop);
  EXPECT_EQ(whole.number_of_faces(), mesh.number_of_faces());
  check_is_whole(mesh, model);
}

// No face is divided or meshed more than once for the sake of others that are bad.
TEST(Bad_faces, cost_what_they_cost)
{
  const Criteria criteria = Criteria().set_max_edge(0.08);
  Wave::Counters good_counters;
  const Model good = tiles(8, 5, [&](int) { return Wave(good_counters); });
  Mesh mesh_of_good;
  good_counters.begin();
  CGAL::make_parametric_surface_mesh(good, criteria, mesh_of_good, CGAL::parameters::leaves_out_bad_faces(true));

  // the holes are found when the boundary is checked, divided, or not before faces are meshed
  for(const Hole& hole : {all_around, between_checked_points, in_the_middle}) {
    SCOPED_TRACE(hole.from + hole.distance_from_checked);
    std::vector<std::size_t> expected;
    for(std::size_t f = 1; f < 40; f += 2)
      expected.push_back(f);
    Mesh meshes[2];
    for(const bool is_parallel : {false, true}) {
      Wave::Counters counters;
      const Model model = tiles(8, 5, [&](int i) { return Wave(counters, i % 2 == 1 ? hole : Hole()); });
      counters.begin();
      Mesh& mesh = meshes[is_parallel];
      const auto parameters = CGAL::parameters::leaves_out_bad_faces(true);
      const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
      const Report report = is_parallel ? CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(model, criteria, mesh, parameters)
                                        : CGAL::make_parametric_surface_mesh(model, criteria, mesh, parameters);
      EXPECT_LT(counters.evaluations, 1.05 * double(good_counters.evaluations));
      EXPECT_EQ(expected, numbers_of(report.left_out));
      EXPECT_EQ(mesh.number_of_faces(), report.number_of_faces);
      EXPECT_EQ(mesh.number_of_vertices(), report.number_of_vertices);
      EXPECT_TRUE(mesh.is_valid());
      for(const auto v : mesh.vertices())
        EXPECT_FALSE(mesh.is_isolated(v));
    }
    check_identical_connectivity(meshes[0], meshes[1]);
  }
}

// Of a bad face nothing is left in the mesh, and the others are as they would be without it.
TEST(Bad_faces, leave_no_trace)
{
  const Criteria criteria = Criteria().set_max_edge(0.1);
  Wave::Counters counters;
  const Model model = tiles(3, 1, [&](int i) { return Wave(counters, i == 1 ? in_the_middle : Hole()); });
  Model rest = model;
  rest.faces()[1].loops.clear();
  counters.begin();
  Mesh a, b;
  const auto parameters = CGAL::parameters::leaves_out_bad_faces(true);
  CGAL::make_parametric_surface_mesh(model, criteria, a, parameters);
  CGAL::make_parametric_surface_mesh(rest, criteria, b, parameters);
  ASSERT_GT(a.number_of_faces(), 0u);
  EXPECT_EQ(a.number_of_faces(), b.number_of_faces());
  EXPECT_EQ(sorted_points(a), sorted_points(b));
}

// All of them are told of, in the order of the faces.
TEST(Bad_faces, all_errors)
{
  Wave::Counters counters;
  Model model = tiles(4, 2, [&](int i) {
    return Wave(counters, i == 6 ? in_the_middle : i == 3 ? between_checked_points : i == 1 ? all_around : Hole());
  });
  counters.begin();
  model.faces()[4].loops.front().pop_back();
  Mesh mesh;
  const Report report = CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(
    model, Criteria().set_max_edge(0.1), mesh, CGAL::parameters::leaves_out_bad_faces(true));
  EXPECT_EQ((std::vector<std::size_t>{1, 3, 4, 6}), numbers_of(report.left_out));
  for(const auto& face : report.left_out)
    EXPECT_NE(std::string::npos, face.reason.find(face.face == 4 ? "open" : "not finite"))
      << face.reason;
}

// A surface whose copies are not independent is evaluated by one thread at a time, whole or in parts; the mesh is the same.
TEST(Threads, surfaces_without_independent_copies)
{
  Wave::Counters counters, free_counters;
  const Criteria criteria = Criteria().set_max_edge(0.05).set_part_size(500);
  Mesh sequential, parallel;
  CGAL::make_parametric_surface_mesh(tiles(4, 4, [&](int) { return Wave(free_counters); }), criteria, sequential);
  const Model model = tiles(4, 4, [&](int) { return Wave(counters, Hole(), false); });
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
  CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(model, criteria, parallel);
  EXPECT_FALSE(counters.were_several_at_work);
  check_identical_connectivity(sequential, parallel);
}

// Each job evaluates a copy of its own.
TEST(Threads, each_job_has_its_own_surface)
{
  struct Guarded_surface
  {
    typedef Test_kernel Geom_traits;
    typedef Geom_traits::Point_3 Point_3;

    mutable std::atomic<bool> is_at_work{false};

    Guarded_surface() {}
    Guarded_surface(const Guarded_surface&) {}

    Point_3 point(double u, double v) const { return jet(u, v).point; }

    CGAL::Surface_jet_3<Test_kernel> jet(double u, double v) const
    {
      if(is_at_work.exchange(true))
        throw std::logic_error("two threads at the same time");
      const Vector_3 zero(0, 0, 0);
      const CGAL::Surface_jet_3<Test_kernel> result{Point_3(u, v, 0), Vector_3(1, 0, 0), Vector_3(0, 1, 0), zero, zero, zero};
      is_at_work = false;
      return result;
    }
  };
  Mesh mesh;
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
  EXPECT_NO_THROW(CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(
    Guarded_surface(), Domain::rectangle(0, 1, 0, 1),
    Criteria().set_max_edge(0.005).set_part_size(3000), mesh));
  EXPECT_GT(mesh.number_of_faces(), 0u);
}

TEST(Threads, exclusive_jobs)
{
  using namespace CGAL::Parametric_surface_mesher::internal;
  std::vector<Job> jobs;
  for(int i = 0; i < 100; ++i)
    jobs.push_back({double(i % 7), i % 3 == 0});
  std::atomic<int> number_at_work{0};
  std::atomic<bool> were_several_at_work{false};
  std::vector<std::atomic<int>> numbers_of_calls(jobs.size());
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
  const auto errors = run_jobs<CGAL::Parallel_tag>(jobs, [&](std::size_t i) {
    ++numbers_of_calls[i];
    if(jobs[i].is_exclusive && ++number_at_work > 1)
      were_several_at_work = true;
    if(jobs[i].is_exclusive)
      --number_at_work;
    if(i % 10 == 5)
      throw std::runtime_error(std::to_string(i));
  });
  EXPECT_FALSE(were_several_at_work);
  for(std::size_t i = 0; i < jobs.size(); ++i) {
    EXPECT_EQ(1, numbers_of_calls[i]);
    EXPECT_EQ(i % 10 == 5, bool(errors[i]));
  }
}

// Surfaces of several types in one model.
TEST(Any_surface, holds_surfaces_of_several_types)
{
  typedef CGAL::Any_parametric_surface_3<Test_kernel> Any;
  Wave::Counters counters;
  const Any wave = Wave(counters, Hole(), false), flat = CGAL::Parametric_plane_3<Test_kernel>(Point_3(0, 0, 0), {1, 0, 0}, {0, 1, 0});
  EXPECT_FALSE(wave.has_independent_copies());
  EXPECT_TRUE(flat.has_independent_copies());
  EXPECT_EQ(Point_3(0.5, 0.5, 0.1), wave.point(0.5, 0.5));
  EXPECT_EQ(Wave(counters).jet(0.3, 0.4).duv, Any(wave).jet(0.3, 0.4).duv);
  std::vector<CGAL::Rectangular_patch_3<Any>> patches{{wave, 0, 1, 0, 1}, {flat, 1, 2, 0, 1}};
  Mesh mesh;
  CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(CGAL::make_model_of_rectangular_patches(patches),
                                                         Criteria().set_max_edge(0.1), mesh);
  EXPECT_TRUE(mesh.is_valid());
  EXPECT_GT(mesh.number_of_faces(), 400u);
}
