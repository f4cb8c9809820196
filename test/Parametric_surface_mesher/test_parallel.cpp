// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces meshed by several threads give the mesh that one thread gives, bit by bit.
#include <gtest/gtest.h>

#include <CGAL/IO/read_bezier_patches.h>
#include <CGAL/Parametric_surface_mesh_visitor.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/make_model_of_rectangular_patches.h>
#include <CGAL/make_parametric_surface_mesh.h>
#include <CGAL/make_parametric_surface_triangle_soup.h>

#include <Sample_models.h>
#include <check_invariants.h>
#include <mesher_test_helpers.h>

#include <boost/property_map/property_map.hpp>
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace {

// with four threads, also on a machine of fewer cores
template <class Model>
Report mesh_with_threads(const Model& model, const Criteria& criteria, Mesh& mesh)
{
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 4);
  return CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(model, criteria, mesh,
                                                                CGAL::parameters::vertex_uv_map(uv_map(mesh)));
}

template <class Model>
void check_same_mesh(const Model& model, const Criteria& criteria)
{
  Mesh sequential, parallel;
  const Report a = CGAL::make_parametric_surface_mesh(model, criteria, sequential,
                                                      CGAL::parameters::vertex_uv_map(uv_map(sequential)));
  const Report b = mesh_with_threads(model, criteria, parallel);
  ASSERT_GT(sequential.number_of_faces(), 0u);
  check_identical(sequential, parallel);
  check_identical_connectivity(sequential, parallel);
  EXPECT_EQ(a.smallest_angle, b.smallest_angle);
  EXPECT_EQ(a.number_of_replaced_tensors, b.number_of_replaced_tensors);
  ASSERT_EQ(a.unmet.size(), b.unmet.size());
  for(std::size_t i = 0; i < a.unmet.size(); ++i)
    EXPECT_EQ(a.unmet[i].face, b.unmet[i].face);
}

const double teapot_max_edge = 0.2;

auto teapot()
{
  return CGAL::make_model_of_rectangular_patches(
    CGAL::IO::read_bezier_patches<Test_kernel>(std::string(PARAMETRIC_SURFACE_MESHER_DATA_DIR) + "/teapot.bpt"));
}

// a surface that is not finite around a point
struct With_a_hole
{
  Sample_surface surface;
  Point_2 middle;
  double radius;

  bool is_in_hole(double u, double v) const { return CGAL::squared_distance(Point_2(u, v), middle) < radius * radius; }

  Point_3 point(double u, double v) const { return is_in_hole(u, v) ? Point_3(NAN, NAN, NAN) : surface.point(u, v); }

  Sample_surface::Jet jet(double u, double v) const
  {
    Sample_surface::Jet jet = surface.jet(u, v);
    jet.point = point(u, v);
    return jet;
  }
};

template <class Face>
Point_2 middle_of_domain(const Face& face)
{
  const auto& loop = face.loops.front();
  Test_kernel::Vector_2 sum(0, 0);
  for(const auto& use : loop)
    sum = sum + (use.curve.source() - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum / double(loop.size());
}

// one side of a pillow as narrow as its edges are long
struct Side_of_pillow : sample_surfaces::From_jet<Side_of_pillow>
{
  double height;

  explicit Side_of_pillow(double h) : height(h) {}

  sample_surfaces::Jet jet(double u, double v) const
  {
    const double w = sample_surfaces::pi;
    const double su = std::sin(w * u), cu = std::cos(w * u), sv = std::sin(w * v), cv = std::cos(w * v);
    return {Point_3(10 * u, v, height * su * sv),
            Vector_3(10, 0, height * w * cu * sv),
            Vector_3(0, 1, height * w * su * cv),
            Vector_3(0, 0, -height * w * w * su * sv),
            Vector_3(0, 0, height * w * w * cu * cv),
            Vector_3(0, 0, -height * w * w * su * sv)};
  }
};

auto pillow()
{
  std::vector<sample_surfaces::Patch> patches;
  for(const double height : {0.1, -0.1})
    patches.emplace_back(Sample_surface(Side_of_pillow(height)), 0, 1, 0, 1);
  return sample_surface_model(CGAL::make_model_of_rectangular_patches(patches));
}

struct Counting_visitor : CGAL::Parametric_surface_mesh_visitor
{
  std::size_t number_of_phases = 0, number_of_questions = 0, last_question = std::size_t(-1);

  void on_phase(const char*) { ++number_of_phases; }
  bool go_further() { return ++number_of_questions < last_question; }
};

} // namespace

TEST(Parallel, teapot)
{
  check_same_mesh(teapot(), Criteria().set_max_edge(teapot_max_edge));
}

TEST(Parallel, sample_models)
{
  for(const std::string name : {"sphere", "box", "ring", "cyl"}) {
    SCOPED_TRACE(name);
    const Sample_model sample = make_sample_model(name);
    check_same_mesh(sample.model, Criteria().set_max_edge(sample.edge_length(3000)));
  }
}

// The faces share the limit; then one after the other is meshed.
TEST(Parallel, limit_of_vertices)
{
  const Sample_model sample = make_sample_model("box");
  const Criteria criteria = Criteria().set_max_edge(sample.edge_length(3000));
  Mesh unlimited;
  const Report report = CGAL::make_parametric_surface_mesh(sample.model, criteria, unlimited);
  check_same_mesh(sample.model, Criteria(criteria).set_max_number_of_vertices(report.number_of_vertices / 2));
}

TEST(Parallel, triangle_soup)
{
  const auto model = teapot();
  const Criteria criteria = Criteria().set_max_edge(teapot_max_edge);
  std::vector<Test_kernel::Point_3> a, b;
  std::vector<std::size_t> ids_a, ids_b;
  std::vector<std::array<std::size_t, 3>> ta, tb;
  CGAL::make_parametric_surface_triangle_soup(model, criteria, a, ta, ids_a);
  CGAL::make_parametric_surface_triangle_soup<CGAL::Parallel_tag>(model, criteria, b, tb, ids_b);
  EXPECT_EQ(a, b);
  EXPECT_EQ(ta, tb);
  EXPECT_EQ(ids_a, ids_b);
}

// Each face counts once. A visitor need not have the function.
TEST(Parallel, visitors_are_told_of_faces)
{
  struct Face_counter : CGAL::Parametric_surface_mesh_visitor
  {
    std::vector<std::size_t> numbers;

    void on_face(std::size_t number, std::size_t number_of_faces)
    {
      EXPECT_EQ(number_of_faces, 6u);
      numbers.push_back(number);
    }
  };
  struct Visitor_without_faces
  {
    void on_phase(const char*) {}
    void on_progress(std::size_t, std::size_t) {}
    bool go_further() { return true; }
  };
  const Sample_model sample = make_sample_model("box");
  const Criteria criteria = Criteria().set_max_edge(sample.edge_length(300));
  Face_counter one, several;
  Visitor_without_faces none;
  Mesh mesh;
  CGAL::make_parametric_surface_mesh(sample.model, criteria, mesh, CGAL::parameters::visitor(std::ref(one)));
  CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(sample.model, criteria, mesh, CGAL::parameters::visitor(std::ref(several)));
  CGAL::make_parametric_surface_mesh(sample.model, criteria, mesh, CGAL::parameters::visitor(std::ref(none)));
  EXPECT_EQ(one.numbers, (std::vector<std::size_t>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(several.numbers, one.numbers);
}

// Edges across both sides of a pillow would join the same vertices. With threads, too, no side is meshed twice.
TEST(Parallel, faces_with_common_chords)
{
  const auto model = pillow();
  const Criteria criteria = Criteria().set_max_edge(1);
  check_same_mesh(model, criteria);
  Counting_visitor visitor;
  Mesh mesh;
  CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(model, criteria, mesh, CGAL::parameters::visitor(std::ref(visitor)));
  // of a face that is refined and repaired once more there are two more phases
  EXPECT_GE(visitor.number_of_phases, 2 + 5 * model.faces().size());
  EXPECT_LE(visitor.number_of_phases, 2 + 7 * model.faces().size());
  EXPECT_EQ(0u, (visitor.number_of_phases - 5 * model.faces().size()) % 2);
  EXPECT_TRUE(mesh.is_valid());
  EXPECT_TRUE(CGAL::is_closed(mesh));
}

TEST(Parallel, faces_that_may_have_a_common_chord)
{
  struct Vertex
  {
    std::size_t index;
  };
  CGAL::Parametric_surface_mesher::internal::Faces_of_points faces;
  faces.add(0, std::vector<std::vector<Vertex>>{{{0}, {1}, {2}, {3}}});
  faces.add(1, std::vector<std::vector<Vertex>>{{{4}, {5}}, {{1}, {3}, {1}}});
  faces.add(2, std::vector<std::vector<Vertex>>{{{0}, {2}, {5}}});
  faces.finish();
  EXPECT_TRUE(faces.have_other_common_face(1, 3, 0));
  EXPECT_TRUE(faces.have_other_common_face(3, 1, 1));
  EXPECT_TRUE(faces.have_other_common_face(0, 2, 0));
  EXPECT_TRUE(faces.have_other_common_face(0, 1, 2));
  EXPECT_FALSE(faces.have_other_common_face(0, 1, 0));
  EXPECT_FALSE(faces.have_other_common_face(3, 5, 1));
  EXPECT_FALSE(faces.have_other_common_face(2, 4, 0));
  EXPECT_FALSE(faces.have_other_common_face(6, 7, 0));
}

// Maps that several threads cannot write are filled by one.
TEST(Parallel, property_maps_that_are_no_arrays)
{
  const auto model = teapot();
  const Criteria criteria = Criteria().set_max_edge(teapot_max_edge);
  Mesh a, b;
  std::map<Mesh::Face_index, std::size_t> patches_a, patches_b;
  CGAL::make_parametric_surface_mesh(model, criteria, a,
                                     CGAL::parameters::face_patch_id_map(boost::make_assoc_property_map(patches_a)));
  CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(
    model, criteria, b, CGAL::parameters::face_patch_id_map(boost::make_assoc_property_map(patches_b)));
  EXPECT_EQ(a.number_of_faces(), patches_a.size());
  EXPECT_EQ(patches_a, patches_b);
  check_identical_connectivity(a, b);
}

// Of several bad faces the first one is named, and the mesh stays as it was.
TEST(Parallel, the_first_error_is_thrown)
{
  Sample_model sample = make_sample_model("box");
  auto& faces = sample.model.faces();
  ASSERT_GT(faces.size(), 4u);
  for(std::size_t f : {4u, 2u})
    faces[f].surface = Sample_surface(With_a_hole{faces[f].surface, middle_of_domain(faces[f]), 0.1});
  Mesh mesh;
  try {
    mesh_with_threads(sample.model, Criteria().set_max_edge(0.05), mesh);
    FAIL() << "accepted";
  }
  catch(const CGAL::Parametric_surface_mesh_error& error) {
    EXPECT_NE(std::string::npos, std::string(error.what()).find("face 3")) << error.what();
  }
  EXPECT_TRUE(mesh.is_empty());
}

TEST(Parallel, visitor_is_called_by_one_thread_at_a_time)
{
  const auto model = teapot();
  Counting_visitor visitor;
  Mesh mesh;
  const Criteria criteria = Criteria().set_max_edge(0.1).set_max_number_of_sweeps(2); // the same phases for all faces
  CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(model, criteria, mesh,
                                                         CGAL::parameters::visitor(std::ref(visitor)));
  // of a face that is refined and repaired once more there are two more phases
  EXPECT_GE(visitor.number_of_phases, 2 + 5 * model.faces().size());
  EXPECT_LE(visitor.number_of_phases, 2 + 7 * model.faces().size());
  EXPECT_EQ(0u, (visitor.number_of_phases - 5 * model.faces().size()) % 2);
  EXPECT_GT(visitor.number_of_questions, 0u);

  Counting_visitor stopping;
  stopping.last_question = 3;
  Mesh coarse;
  const Report report = CGAL::make_parametric_surface_mesh<CGAL::Parallel_tag>(
    model, criteria, coarse, CGAL::parameters::visitor(std::ref(stopping)));
  EXPECT_GT(report.count(CGAL::Parametric_surface_mesher::Unmet_cause::STOPPED) + report.number_of_unjudged_faces, 0u);
  EXPECT_LT(coarse.number_of_faces(), mesh.number_of_faces());
  EXPECT_TRUE(coarse.is_valid());
}
