// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sizing fields in space, and files with values at nodes.
#include <CGAL/Element_mesh_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Graded_sizing_field_3.h>
#include <CGAL/Interpolated_sizing_field_3.h>
#include <CGAL/IO/read_node_values.h>
#include <CGAL/IO/write_element_VTU.h>
#include <CGAL/Least_sizing_field_3.h>
#include <CGAL/Parametric_surface_mesh_error.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/layer_sizes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <unistd.h>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Segment_3 Segment_3;
typedef Kernel::Triangle_3 Triangle_3;
typedef CGAL::Graded_sizing_field_3<Kernel> Graded;
typedef CGAL::Interpolated_sizing_field_3<Kernel> Interpolated;
typedef CGAL::Parametric_surface_mesh_error Error;

const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

class Random_points
{
  std::mt19937 m_generator{7};
  std::uniform_real_distribution<double> m_coordinate{-2, 2};

public:
  Point_3 operator()()
  {
    const double x = m_coordinate(m_generator), y = m_coordinate(m_generator), z = m_coordinate(m_generator);
    return Point_3(x, y, z);
  }
};

TEST(Sizing_fields, grow_outside_of_a_box)
{
  const auto field = Graded::in_box(Kernel::Iso_cuboid_3(0, 0, 0, 1, 2, 3), 0.1, 0.5);
  EXPECT_DOUBLE_EQ(field(Point_3(0.5, 1, 2.9)), 0.1);
  EXPECT_DOUBLE_EQ(field(Point_3(2, 1, 1)), 0.6);
  EXPECT_DOUBLE_EQ(field(Point_3(4, 6, 1)), 0.1 + 0.5 * 5);
  EXPECT_DOUBLE_EQ(field.length(), 0.1);
}

TEST(Sizing_fields, grow_outside_of_a_ball)
{
  const auto field = Graded::in_ball(Point_3(1, 0, 0), 2, 0.1);
  EXPECT_DOUBLE_EQ(field(Point_3(1, 1, 1)), 0.1);
  EXPECT_DOUBLE_EQ(field(Point_3(1, 3, 4)), 0.1 + 0.2 * 3);
}

TEST(Sizing_fields, grow_outside_of_a_cylinder_with_flat_ends)
{
  const auto field = Graded::in_cylinder(Segment_3(Point_3(0, 0, 0), Point_3(0, 0, 2)), 1, 0.1, 1);
  EXPECT_DOUBLE_EQ(field(Point_3(0.7, 0.7, 1.9)), 0.1);
  EXPECT_DOUBLE_EQ(field(Point_3(3, 0, 1)), 2.1);
  EXPECT_DOUBLE_EQ(field(Point_3(0.5, 0, 3)), 1.1);
  EXPECT_DOUBLE_EQ(field(Point_3(0, -4, -4)), 5.1);
}

TEST(Sizing_fields, grow_with_the_distance_from_points_segments_and_triangles)
{
  Random_points random;
  std::vector<Point_3> points;
  std::vector<Segment_3> segments;
  std::vector<Triangle_3> triangles;
  for(int i = 0; i < 50; ++i) {
    points.push_back(random());
    segments.push_back(Segment_3(random(), random()));
    triangles.push_back(Triangle_3(random(), random(), random()));
  }
  const auto expect_distances = [&](const auto& pieces) {
    const auto field = Graded::near(pieces, 0.1, 0.5), far_reaching = Graded::near(pieces, 0.1, 0.5, 0.25);
    for(int i = 0; i < 200; ++i) {
      const Point_3 p = random();
      double distance = infinity;
      for(const auto& piece : pieces)
        distance = (std::min)(distance, std::sqrt(squared_distance(p, piece)));
      EXPECT_NEAR(field(p), 0.1 + 0.5 * distance, 1e-9);
      EXPECT_NEAR(far_reaching(p), 0.1 + 0.5 * (std::max)(0., distance - 0.25), 1e-9);
    }
  };
  expect_distances(points);
  expect_distances(segments);
  expect_distances(triangles);
  const auto single = Graded::near(std::array<Point_3, 1>{{Point_3(0, 0, 0)}}, 0.1);
  EXPECT_DOUBLE_EQ(single(Point_3(0, 3, 4)), 1.1);
}

TEST(Sizing_fields, are_combined_by_the_least_length)
{
  CGAL::Least_sizing_field_3<Point_3> field;
  EXPECT_TRUE(field.is_empty());
  EXPECT_EQ(field(Point_3(0, 0, 0)), infinity);
  field.add(Graded::in_ball(Point_3(0, 0, 0), 1, 0.1)).add(Graded::in_ball(Point_3(10, 0, 0), 1, 0.2));
  field.add([](const Point_3&) { return 0.5; });
  EXPECT_FALSE(field.is_empty());
  EXPECT_DOUBLE_EQ(field(Point_3(0, 0, 0)), 0.1);
  EXPECT_DOUBLE_EQ(field(Point_3(9.5, 0, 0)), 0.2);
  EXPECT_DOUBLE_EQ(field(Point_3(5, 0, 0)), 0.5);
  field.add([](const Point_3&) { return nan; }).add([](const Point_3&) { return 0.5; });
  EXPECT_TRUE(std::isnan(field(Point_3(5, 0, 0))));
}

TEST(Sizing_fields, refuse_what_is_no_length_or_place)
{
  const Kernel::Iso_cuboid_3 box(0, 0, 0, 1, 1, 1);
  for(const double length : {0., -1., infinity, nan})
    EXPECT_THROW(Graded::in_box(box, length), Error) << length;
  for(const double growth : {-0.1, infinity, nan})
    EXPECT_THROW(Graded::in_box(box, 1, growth), Error) << growth;
  EXPECT_THROW(Graded::in_ball(Point_3(0, 0, 0), -1, 1), Error);
  EXPECT_THROW(Graded::in_cylinder(Segment_3(Point_3(1, 0, 0), Point_3(1, 0, 0)), 1, 1), Error);
  EXPECT_THROW(Graded::near(std::vector<Point_3>(), 1), Error);
  EXPECT_THROW(Graded::near(std::vector<Segment_3>{Segment_3(Point_3(1, 0, 0), Point_3(1, 0, 0))}, 1), Error);
}

// A linear function of the place.
double linear(const std::array<double, 3>& p) { return 5 + p[0] - 0.5 * p[1] + 0.25 * p[2]; }

// The cubes of a grid in the unit cube, each divided into six tetrahedra along its diagonal.
CGAL::Node_values_3 grid_of_tetrahedra(std::size_t n)
{
  CGAL::Node_values_3 mesh;
  for(std::size_t i = 0; i <= n; ++i)
    for(std::size_t j = 0; j <= n; ++j)
      for(std::size_t k = 0; k <= n; ++k)
        mesh.nodes.push_back({{double(i) / double(n), double(j) / double(n), double(k) / double(n)}});
  for(const auto& p : mesh.nodes)
    mesh.values.push_back(linear(p));
  const std::size_t steps[3] = {(n + 1) * (n + 1), n + 1, 1};
  for(std::size_t i = 0; i < n; ++i)
    for(std::size_t j = 0; j < n; ++j)
      for(std::size_t k = 0; k < n; ++k) {
        std::array<std::size_t, 3> order{{0, 1, 2}};
        do {
          std::array<std::size_t, 4> t{{i * steps[0] + j * steps[1] + k}};
          for(std::size_t step = 0; step < 3; ++step)
            t[step + 1] = t[step] + steps[order[step]];
          mesh.tetrahedra.push_back(t);
        } while(std::next_permutation(order.begin(), order.end()));
      }
  return mesh;
}

TEST(Sizing_fields, are_linear_in_tetrahedra_and_those_of_the_closest_point_outside)
{
  const Interpolated field(grid_of_tetrahedra(4));
  EXPECT_DOUBLE_EQ(field.length(), 4.5);
  Random_points random;
  for(int i = 0; i < 500; ++i) {
    const Point_3 p = random();
    const auto inside = [](double x) { return (std::min)((std::max)(x, 0.), 1.); };
    EXPECT_NEAR(field(p), linear({{inside(p.x()), inside(p.y()), inside(p.z())}}), 1e-9);
  }
  for(double x : {0., 0.25, 0.3, 1.}) // on common sides, edges and corners
    EXPECT_NEAR(field(Point_3(x, x, 0.5)), linear({{x, x, 0.5}}), 1e-12);
}

TEST(Sizing_fields, are_linear_on_triangles)
{
  CGAL::Node_values_3 mesh;
  mesh.nodes = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{1, 1, 0}}, {{0.5, 0, 0}}};
  mesh.triangles = {{{0, 1, 2}}, {{1, 3, 2}}, {{0, 4, 1}}}; // the last one has no area
  for(const auto& p : mesh.nodes)
    mesh.values.push_back(linear(p));
  const Interpolated field(mesh);
  EXPECT_NEAR(field(Point_3(0.3, 0.2, 0)), linear({{0.3, 0.2, 0}}), 1e-12);
  EXPECT_NEAR(field(Point_3(0.8, 0.9, 7)), linear({{0.8, 0.9, 0}}), 1e-12);
  EXPECT_NEAR(field(Point_3(3, 5, 7)), linear({{1, 1, 0}}), 1e-12);
}

TEST(Sizing_fields, refuse_meshes_without_lengths)
{
  CGAL::Node_values_3 mesh;
  EXPECT_THROW(Interpolated{mesh}, Error);
  mesh.nodes = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}};
  mesh.triangles = {{{0, 1, 2}}};
  EXPECT_THROW(Interpolated{mesh}, Error);
  mesh.values = {1, 2, 3};
  EXPECT_NO_THROW(Interpolated{mesh});
  for(const double length : {0., -1., infinity, nan}) {
    mesh.values[1] = length;
    EXPECT_THROW(Interpolated{mesh}, Error) << length;
  }
  mesh.values[1] = 1;
  mesh.triangles[0][2] = 3;
  EXPECT_THROW(Interpolated{mesh}, Error);
  mesh.triangles[0][2] = 1;
  EXPECT_THROW(Interpolated{mesh}, Error); // no area
}

// The volume is 0 by rounding, and so are the weights of the corners of the tetrahedron.
TEST(Sizing_fields, have_a_length_in_tetrahedra_that_are_nearly_flat)
{
  CGAL::Node_values_3 mesh;
  mesh.nodes = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, std::numeric_limits<double>::denorm_min()}}};
  mesh.values = {1, 2, 3, 4};
  mesh.tetrahedra = {{{0, 1, 2, 3}}};
  const double length = Interpolated(mesh)(Point_3(0.25, 0.25, 0));
  EXPECT_GE(length, 1);
  EXPECT_LE(length, 4);
}

// Files in a directory that goes away with the test.
class Node_value_files : public testing::Test
{
  const std::filesystem::path m_directory
    = std::filesystem::temp_directory_path()
      / (std::string("node_values_") + testing::UnitTest::GetInstance()->current_test_info()->name() + "_" + std::to_string(getpid()));

protected:
  void SetUp() override { std::filesystem::create_directories(m_directory); }
  void TearDown() override { std::filesystem::remove_all(m_directory); }

  std::string file(const std::string& name) const { return (m_directory / name).string(); }

  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(file(name), std::ios::binary) << text;
    return file(name);
  }

  // Of a unit square in two triangles, with the values 1, 2, 3 and 4.
  static void expect_square(const CGAL::Node_values_3& mesh)
  {
    EXPECT_EQ(mesh.nodes.size(), 4u);
    EXPECT_EQ(mesh.triangles.size(), 2u);
    EXPECT_TRUE(mesh.tetrahedra.empty());
    const Interpolated field(mesh);
    EXPECT_DOUBLE_EQ(field(Point_3(0, 0, 0)), 1);
    EXPECT_DOUBLE_EQ(field(Point_3(1, 0, 0)), 2);
    EXPECT_DOUBLE_EQ(field(Point_3(1, 1, 0)), 3);
    EXPECT_DOUBLE_EQ(field(Point_3(0, 1, 0)), 4);
    EXPECT_DOUBLE_EQ(field(Point_3(0.5, 0, 1)), 1.5);
  }

  // Refused by one sentence that contains `hint`.
  void expect_refused(const std::string& file_name, const std::string& hint, const std::string& name = "") const
  {
    try {
      CGAL::IO::read_node_values(file_name, name);
      ADD_FAILURE() << file_name << " is read";
    }
    catch(const Error& error) {
      EXPECT_NE(std::string(error.what()).find(hint), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
};

const char* const msh_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n30 1 1 0\n4 0 1 0\n5 9 9 9\n$EndNodes\n"
                          "$Elements\n3\n1 15 2 0 1 1\n2 2 2 0 -7 1 2 30\n3 2 2 0 1 1 30 4\n$EndElements\n";
const char* const msh_4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n7 0 0 0 1 1 0 0 0\n$EndEntities\n"
                          "$Nodes\n2 5 1 30\n2 7 1 3\n1\n2\n30\n0 0 0 0.5 0.5\n1 0 0 0.5 0.5\n1 1 0 0.5 0.5\n2 7 0 2\n4\n5\n0 1 0\n9 9 9\n$EndNodes\n"
                          "$Elements\n1 2 1 2\n2 7 2 2\n1 1 2 30\n2 1 30 4\n$EndElements\n";
const char* const size_data = "$NodeData\n1\n\"size\"\n1\n0.0\n3\n0\n1\n4\n1 1\n2 2\n30 3\n4 4\n$EndNodeData\n";
const char* const other_data = "$NodeData\n1\n\"stress\"\n1\n0.0\n3\n0\n1\n1\n1 7\n$EndNodeData\n";

TEST_F(Node_value_files, of_gmsh)
{
  for(const std::string mesh : {msh_2, msh_4}) {
    expect_square(CGAL::IO::read_node_values(write("one.msh", mesh + size_data)));
    expect_square(CGAL::IO::read_node_values(write("two.msh", mesh + other_data + size_data), "size"));
    expect_refused(file("two.msh"), "several kinds of values at the nodes, and one of them must be chosen: 'stress', 'size'");
    expect_refused(file("two.msh"), "no values 'strain'", "strain");
    expect_refused(write("no_data.msh", mesh), "no scalar values");
    expect_refused(write("cut.msh", mesh.substr(0, mesh.size() - 30)), "ends too early");
    EXPECT_THROW(Interpolated{CGAL::IO::read_node_values(write("few.msh", mesh + other_data))}, Error); // three nodes are without a value
  }
  expect_refused(write("old.msh", "$MeshFormat\n4.0 0 8\n$EndMeshFormat\n"), "its version is 4.0");
  expect_refused(write("binary.msh", "$MeshFormat\n4.1 1 8\n"), "binary");
  expect_refused(write("hexahedron.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n1\n1 5 0 1 2 3 4 5 6 7 8\n"), "elements of type 5");
  for(const char* count : {"-1", "4000000000000000000"}) { // of tags, lines and components
    const std::string number = count;
    expect_refused(write("tags.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n1\n1 2 " + number + " 1 2 3\n"), "ends too early");
    expect_refused(write("lines.msh", msh_2 + ("$NodeData\n" + number + "\n\"size\"\n")), "ends too early");
    expect_refused(write("components.msh", msh_2 + ("$NodeData\n1\n\"size\"\n0\n3\n0\n" + number + "\n1\n1 1\n")), "ends too early");
  }
  expect_refused(file("nowhere.msh"), "cannot be opened");
  expect_refused(file("nowhere.xyz"), "must end in");
}

TEST_F(Node_value_files, of_medit)
{
  const std::string mesh = "MeshVersionFormatted 2\n\nDimension 3\nVertices\n5\n0 0 0 1\n1 0 0 1\n# a comment\n1 1 0 -1\n0 1 0 0\n7 7 7 0\nEdges 1\n1 2 0\n"
                           "Triangles\n2\n1 2 3 5\n1 3 4 -5\nRequiredVertices 1\n1\nEnd\n",
                    values = "MeshVersionFormatted 2\nDimension 3\nSolAtVertices\n5\n1 1\n1\n2\n3\n4\n0\nEnd\n";
  write("square.mesh", mesh);
  write("square.sol", values);
  expect_square(CGAL::IO::read_node_values(file("square.mesh")));
  expect_square(CGAL::IO::read_node_values(file("square.sol")));
  expect_refused(file("square.mesh"), "no names", "size");
  expect_refused(write("alone.mesh", mesh), "alone.sol: the file cannot be opened");
  write("square.sol", "Dimension 3\nSolAtVertices 5\n1 3\n1 0 0 0 0 1\n");
  expect_refused(file("square.mesh"), "metric tensors are not read");
  write("square.sol", "Dimension 3\nSolAtVertices 2\n1 1\n1 2\n");
  expect_refused(file("square.mesh"), "2 values for 5 nodes");
  write("square.sol", "Dimension 3\nSolAtVertices 5\n1 1\n1 2\n");
  expect_refused(file("square.mesh"), "ends too early");
  write("hexahedron.mesh", "Dimension 3\nHexahedra 1\n1 2 3 4 5 6 7 8 0\n");
  expect_refused(file("hexahedron.mesh"), "the kind Hexahedra");
}

// The rest of a file of VTK with the square, its arrays in text.
std::string vtu_text(const std::string& attributes, const std::string& values, const std::string& types = "5 5")
{
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\"" + attributes
         + "><!-- a comment --><UnstructuredGrid><Piece NumberOfPoints=\"4\" NumberOfCells=\"2\">\n<PointData>" + values + "</PointData>\n"
           "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0\n1 1 0 0 1 0</DataArray></Points>\n"
           "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 0 2 3</DataArray>\n"
           "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3 6</DataArray>\n"
           "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">" + types + "</DataArray></Cells></Piece></UnstructuredGrid>";
}

TEST_F(Node_value_files, of_vtk)
{
  const std::string size = "<DataArray type=\"Float32\" Name=\"size\" format=\"ascii\">1 2 3 4</DataArray>",
                    vectors = "<DataArray type=\"Float32\" Name=\"v\" NumberOfComponents=\"3\" format=\"ascii\">"
                              "1 2 3 4 5 6 7 8 9 10 11 12</DataArray>",
                    end = "</VTKFile>\n";
  expect_square(CGAL::IO::read_node_values(write("text.vtu", vtu_text("", vectors + size) + end)));
  // 16 bytes, header and numbers in one piece of base64, and each in its own
  const std::string one_piece = "EAAAAAAAgD8AAABAAABAQAAAgEA=", two_pieces = "EAAAAA==AACAPwAAAEAAAEBAAACAQA==";
  for(const std::string& base64 : {one_piece, two_pieces})
    expect_square(CGAL::IO::read_node_values(
      write("binary.vtu",
            vtu_text("", "<DataArray type=\"Float32\" Name=\"size\" format=\"binary\">\n  " + base64 + "\n</DataArray>") + end)));
  const std::string appended = "<DataArray type=\"Float32\" Name=\"size\" format=\"appended\" offset=\"0\"/>";
  expect_square(CGAL::IO::read_node_values(
    write("base64.vtu", vtu_text("", appended) + "<AppendedData encoding=\"base64\">\n_" + two_pieces + "\n</AppendedData>" + end)));
  const std::string big_endian("\0\0\0\x10\x3f\x80\0\0\x40\0\0\0\x40\x40\0\0\x40\x80\0\0", 20);
  expect_square(CGAL::IO::read_node_values(
    write("raw.vtu", vtu_text(" byte_order=\"BigEndian\"", appended)
                       + "<AppendedData encoding=\"raw\">_" + big_endian + "</AppendedData>" + end)));
  expect_refused(write("short.vtu",
                       vtu_text("", appended) + "<AppendedData encoding=\"base64\">\n_" + two_pieces.substr(0, 16) + "\n</AppendedData>" + end),
                 "end too early");
  expect_refused(write("two.vtu", vtu_text("", size
                                               + "<DataArray type=\"Float32\" Name=\"error\" format=\"ascii\">1 2 3 4</DataArray>") + end), "'size', 'error'");
  expect_refused(write("vectors.vtu", vtu_text("", vectors) + end), "no scalar values");
  expect_refused(write("hexahedra.vtu", vtu_text("", size, "12 12") + end), "elements of type 12");
  expect_refused(write("few.vtu",
                       vtu_text("", "<DataArray type=\"Float32\" Name=\"size\" format=\"ascii\">1 2 3</DataArray>") + end), "3 values for 4 nodes");
  expect_refused(write("lz4.vtu", vtu_text(" compressor=\"vtkLZ4DataCompressor\"", appended)
                                  + "<AppendedData encoding=\"raw\">_" + big_endian), "compressed");
  expect_refused(write("other.vtu", "<VTKFile type=\"PolyData\"></VTKFile>"), "no unstructured grid");
  expect_refused(write("garbage.vtu", "garbage"), "no XML");
}

// As this package writes it: 64 bits, appended, and compressed if Boost.Iostreams is there.
TEST_F(Node_value_files, of_vtk_written_here)
{
  CGAL::Element_mesh_3 mesh;
  mesh.nodes = {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}};
  mesh.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  mesh.surfaces.resize(1);
  mesh.triangle_surfaces = {0, 0};
  mesh.node_data.push_back({"size", 1, {1, 2, 3, 4}});
  {
    std::ofstream out(file("square.vtu"), std::ios::binary);
    CGAL::IO::write_VTU(out, mesh);
  }
  expect_square(CGAL::IO::read_node_values(file("square.vtu")));
}

typedef CGAL::Surface_mesh<Point_3> Mesh;

// The two sides of a sheet of a given thickness over the square [0,10]^2, as grids. Each side has points of its own.
template <class Thickness>
Mesh sheet(const Thickness& thickness)
{
  const int n = 20;
  Mesh mesh;
  for(const bool is_top : {false, true}) {
    std::vector<Mesh::Vertex_index> v;
    for(int i = 0; i <= n; ++i)
      for(int k = 0; k <= n; ++k) {
        const double x = 0.5 * i, y = 0.5 * k;
        v.push_back(mesh.add_vertex(Point_3(x, y, is_top ? thickness(x) : 0)));
      }
    for(int i = 0; i < n; ++i)
      for(int k = 0; k < n; ++k) {
        const auto a = v[i * (n + 1) + k], b = v[(i + 1) * (n + 1) + k], c = v[(i + 1) * (n + 1) + k + 1], d = v[i * (n + 1) + k + 1];
        mesh.add_face(a, is_top ? b : c, is_top ? c : b);
        mesh.add_face(a, is_top ? c : d, is_top ? d : c);
      }
  }
  return mesh;
}

TEST(Layer_sizes, are_shares_of_the_thickness)
{
  const auto sizes = CGAL::layer_sizes(sheet([](double) { return 0.6; }), 3, 0.01, 5);
  for(const double value : sizes.values)
    EXPECT_NEAR(value, 0.6 / 3 / 1.4, 1e-9);
  EXPECT_DOUBLE_EQ(Interpolated(sizes)(Point_3(3, 4, 0.3)), sizes.values[0]);
}

TEST(Layer_sizes, grow_away_from_what_is_thin)
{
  const auto thickness = [](double x) { return x < 2.2 ? 0.5 : x < 2.7 ? 2. : 4.; };
  const auto sizes = CGAL::layer_sizes(sheet(thickness), 2, 0.01, 5, 0.2);
  for(std::size_t i = 0; i < sizes.nodes.size(); ++i) {
    const double x = sizes.nodes[i][0], wanted = thickness(x) / 2 / 1.4;
    EXPECT_LE(sizes.values[i], wanted * (1 + 1e-9));
    if(x < 2) {
      EXPECT_NEAR(sizes.values[i], wanted, 1e-9);
    }
    if(x > 9) {
      EXPECT_GT(sizes.values[i], 0.99 * wanted);
    }
  }
}

TEST(Layer_sizes, have_bounds)
{
  for(const double value : CGAL::layer_sizes(sheet([](double) { return 1e-3; }), 2, 0.01, 5).values)
    EXPECT_EQ(value, 0.01);
  for(const double value : CGAL::layer_sizes(sheet([](double) { return 100.; }), 2, 0.01, 5).values)
    EXPECT_EQ(value, 5);
  // Sides that touch have no room between them, and one with a slope of 3 is not opposite to the other one.
  for(const double value : CGAL::layer_sizes(sheet([](double) { return 0.; }), 2, 0.01, 5).values)
    EXPECT_EQ(value, 5);
  for(const double value : CGAL::layer_sizes(sheet([](double x) { return 3 * x + 0.1; }), 2, 0.01, 5).values)
    EXPECT_EQ(value, 5);
  const Mesh mesh = sheet([](double) { return 1.; });
  EXPECT_THROW(CGAL::layer_sizes(mesh, 0, 0.01, 5), Error);
  EXPECT_THROW(CGAL::layer_sizes(mesh, 2, -1, 5), Error);
  EXPECT_THROW(CGAL::layer_sizes(mesh, 2, 0.01, infinity), Error);
  EXPECT_THROW(CGAL::layer_sizes(mesh, 2, 0.01, 5, -1), Error);
  Mesh square;
  square.add_face(std::vector<Mesh::Vertex_index>{square.add_vertex(Point_3(0, 0, 0)), square.add_vertex(Point_3(1, 0, 0)),
                                                  square.add_vertex(Point_3(1, 1, 0)), square.add_vertex(Point_3(0, 1, 0))});
  EXPECT_THROW(CGAL::layer_sizes(square, 2, 0.01, 5), Error);
}

} // namespace
