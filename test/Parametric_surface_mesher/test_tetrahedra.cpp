// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed meshes filled with tetrahedra by TetGen: the surface is the boundary, and stays as it was.
#include <CGAL/Bezier_surface_3.h>
#include <CGAL/Parametric_function_surface_3.h>
#include <CGAL/Parametric_primitive_surfaces_3.h>
#include <CGAL/Rectangular_patch_3.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/make_model_of_rectangular_patches.h>

#include <gtest/gtest.h>

#include <Sample_surfaces.h>
#include <Tetrahedra.h>
#include <check_tetrahedra.h>
#include <mesher_test_helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace {

typedef CGAL::Rectangular_patch_3<Sample_surface> Patch;
typedef std::array<std::size_t, 3> Sorted_facet;

const double pi = 4 * std::atan(1.);

template <class Surface>
Patch patch(const Surface& surface, double u_min, double u_max, double v_min, double v_max)
{
  return Patch(Sample_surface(surface), u_min, u_max, v_min, v_max);
}

template <class AnyPatch>
Mesh mesh_patches(const std::vector<AnyPatch>& patches, const Criteria& criteria)
{
  Mesh result;
  CGAL::make_parametric_surface_mesh(CGAL::make_model_of_rectangular_patches(patches, 1e-9), criteria, result);
  EXPECT_TRUE(CGAL::is_closed(result));
  return result;
}

Mesh sphere(double radius = 1)
{
  const CGAL::Parametric_sphere_3<Test_kernel> sphere(radius);
  return mesh_patches<Patch>({patch(sphere, 0, 2 * pi, -pi / 2, pi / 2)}, Criteria().set_max_edge(0.15));
}

Mesh torus()
{
  const CGAL::Parametric_torus_3<Test_kernel> torus(1, 0.3);
  return mesh_patches<Patch>({patch(torus, 0, 2 * pi, 0, 2 * pi)}, Criteria().set_max_edge(0.1));
}

Mesh cone_with_base(double slope)
{
  const CGAL::Parametric_cone_3<Test_kernel> cone(1, -slope);
  const auto base = CGAL::make_parametric_function_surface([](auto u, auto v) {
    using std::cos;
    using std::sin;
    return CGAL::parametric_surface_point(v * cos(u), v * sin(u), 0);
  });
  return mesh_patches<Patch>({patch(cone, 0, 2 * pi, 0, 1 / std::sin(slope)), patch(base, 0, 2 * pi, 0, 1)},
                             Criteria().set_max_edge(0.2).set_min_edge(0.02));
}

// six bilinear patches, the first one seen from outside
Mesh box()
{
  const Point_3 o(0, 0, 0), x(1, 0, 0), y(0, 2, 0), z(0, 0, 3), xy(1, 2, 0), xz(1, 0, 3), yz(0, 2, 3), xyz(1, 2, 3);
  std::vector<CGAL::Bezier_surface_3<Test_kernel>> patches;
  for(const auto& p : std::vector<std::array<Point_3, 4>>{
        {o, y, xy, x}, {z, xz, xyz, yz}, {o, x, xz, z}, {y, yz, xyz, xy}, {o, z, yz, y}, {x, xy, xyz, xz}})
    patches.emplace_back(1, 1, std::vector<Point_3>{p[0], p[1], p[3], p[2]});
  return mesh_patches(patches, Criteria().set_max_edge(0.25));
}

Sorted_facet sorted(std::size_t a, std::size_t b, std::size_t c)
{
  Sorted_facet result = {a, b, c};
  std::sort(result.begin(), result.end());
  return result;
}

// six times the signed volume of the tetrahedron with these corners
double determinant(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s)
{
  return cross_product(q - p, r - p) * (s - p);
}

// None of the meshes has removed vertices: their numbers are those of the points.
void expect_points_of(const Mesh& surface, const Tetrahedra& tetrahedra)
{
  ASSERT_FALSE(surface.has_garbage());
  ASSERT_LE(surface.number_of_vertices(), tetrahedra.points.size());
  for(const auto v : surface.vertices())
    EXPECT_EQ(surface.point(v), tetrahedra.points[v]);
}

// All other points are used, and inside: none is on the boundary.
void expect_others_inside(const Mesh& surface, const Tetrahedra& tetrahedra)
{
  std::set<std::size_t> used;
  for(const auto& cell : tetrahedra.cells)
    used.insert(cell.begin(), cell.end());
  EXPECT_EQ(tetrahedra.points.size(), used.size());
  const CGAL::Side_of_triangle_mesh<Mesh, Test_kernel> side(surface);
  for(std::size_t i = surface.number_of_vertices(); i < tetrahedra.points.size(); ++i)
    EXPECT_EQ(CGAL::ON_BOUNDED_SIDE, side(tetrahedra.points[i])) << tetrahedra.points[i];
}

// Facets with one tetrahedron are triangles, those with two are not, and there is nothing else.
void expect_boundary(const Mesh& surface, const Tetrahedra& tetrahedra)
{
  std::map<Sorted_facet, int> number_of_cells;
  for(const auto& c : tetrahedra.cells)
    for(int i = 0; i < 4; ++i)
      ++number_of_cells[sorted(c[i], c[(i + 1) % 4], c[(i + 2) % 4])];
  std::set<Sorted_facet> triangles;
  for(const auto f : surface.faces()) {
    const auto v = corners(surface, f);
    triangles.insert(sorted(v[0], v[1], v[2]));
  }
  EXPECT_EQ(surface.number_of_faces(), triangles.size());
  for(const auto& facet : number_of_cells)
    EXPECT_EQ(triangles.count(facet.first) == 1 ? 1 : 2, facet.second);
  for(const Sorted_facet& triangle : triangles)
    EXPECT_EQ(1u, number_of_cells.count(triangle));
}

void expect_volume(const Mesh& surface, const Tetrahedra& tetrahedra)
{
  const auto& p = tetrahedra.points;
  double expected = 0, found = 0;
  for(const auto f : surface.faces()) {
    const auto v = corners(surface, f);
    expected += determinant(CGAL::ORIGIN, surface.point(v[0]), surface.point(v[1]), surface.point(v[2]));
  }
  for(const auto& c : tetrahedra.cells) {
    EXPECT_EQ(CGAL::POSITIVE, CGAL::orientation(p[c[0]], p[c[1]], p[c[2]], p[c[3]]));
    found += determinant(p[c[0]], p[c[1]], p[c[2]], p[c[3]]);
  }
  EXPECT_GT(expected, 0);
  EXPECT_NEAR(expected, found, 1e-9 * expected);
}

Tetrahedra expect_filled(const Mesh& surface)
{
  const Tetrahedra result = fill_with_tetrahedra(surface);
  expect_points_of(surface, result);
  expect_others_inside(surface, result);
  expect_boundary(surface, result);
  expect_volume(surface, result);
  EXPECT_NO_THROW(check_tetrahedra(surface, result));
  return result;
}

// the message of the exception that `call` throws
template <class Exception, class Call>
std::string message_of(const Call& call)
{
  try {
    call();
  }
  catch(const Exception& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

std::string mistake(const Mesh& surface, const Tetrahedra& tetrahedra)
{
  return message_of<std::runtime_error>([&] { check_tetrahedra(surface, tetrahedra); });
}

} // namespace

TEST(Tetrahedra, sphere) { expect_filled(sphere()); }

TEST(Tetrahedra, torus) { expect_filled(torus()); }

TEST(Tetrahedra, cone_with_base)
{
  for(double slope : {pi / 4, pi / 3})
    expect_filled(cone_with_base(slope));
}

// Flat sides, whose triangles are not to be joined.
TEST(Tetrahedra, box)
{
  EXPECT_GT(expect_filled(box()).points.size(), box().number_of_vertices());
}

TEST(Tetrahedra, two_pieces)
{
  Mesh both = torus();
  both += sphere(0.6); // in the hole of the torus
  expect_filled(both);
}

TEST(Tetrahedra, removed_vertices_do_not_count)
{
  Mesh surface = box();
  const std::size_t n = surface.number_of_vertices();
  surface.remove_vertex(surface.add_vertex(Point_3(5, 5, 5)));
  EXPECT_TRUE(surface.has_garbage());
  const Tetrahedra tetrahedra = fill_with_tetrahedra(surface);
  EXPECT_EQ(n, surface.number_of_vertices());
  EXPECT_NO_THROW(check_tetrahedra(surface, tetrahedra));
}

TEST(Tetrahedra, refuses_what_has_no_inside)
{
  const auto refusal = [](const Mesh& mesh) {
    return message_of<std::invalid_argument>([&] { fill_with_tetrahedra(mesh); });
  };
  EXPECT_NE(std::string::npos, refusal(Mesh()).find("not a closed mesh"));
  Mesh open = box();
  CGAL::Euler::remove_face(open.halfedge(*open.faces().begin()), open);
  EXPECT_NE(std::string::npos, refusal(open).find("not a closed mesh"));
  Mesh crossing;
  for(double x : {0., 0.1})
    CGAL::make_tetrahedron(Point_3(x, x, x), Point_3(x + 1, x, x), Point_3(x, x + 1, x), Point_3(x, x, x + 1), crossing);
  EXPECT_NE(std::string::npos, refusal(crossing).find("intersects itself"));
}

// The checks that the example makes.
TEST(Tetrahedra, mistakes_are_found)
{
  const Mesh surface = box();
  const Tetrahedra good = fill_with_tetrahedra(surface);
  EXPECT_NO_THROW(check_tetrahedra(surface, good));
  Tetrahedra bad = good;
  bad.cells.pop_back();
  EXPECT_NE(std::string::npos, mistake(surface, bad).find("the boundary of the tetrahedra lacks"));
  bad = good;
  bad.cells.push_back(bad.cells.front());
  EXPECT_NE(std::string::npos, mistake(surface, bad).find("same side of a facet"));
  bad = good;
  bad.points[0] = Point_3(std::nextafter(bad.points[0].x(), 1), bad.points[0].y(), bad.points[0].z());
  EXPECT_NE(std::string::npos, mistake(surface, bad).find("point 0 of the surface has been moved"));
  bad = good;
  bad.points.resize(3);
  EXPECT_NE(std::string::npos, mistake(surface, bad).find("fewer points"));
  bad = good;
  bad.points.back() = Point_3(9, 9, 9);
  EXPECT_NE(std::string::npos, mistake(surface, bad).find("is not positive"));
  bad = fill_with_tetrahedra(surface, "pq1.4a0.001Q"); // without Y, which keeps the triangles
  EXPECT_NE(std::string::npos, mistake(surface, bad).find("the boundary of the tetrahedra lacks"));
}

TEST(Tetrahedra, vtk_file_holds_them)
{
  const Tetrahedra tetrahedra = fill_with_tetrahedra(sphere());
  std::stringstream file;
  file.precision(17);
  write_VTK(file, tetrahedra);
  std::string line, word;
  for(const char* expected : {"# vtk DataFile Version 3.0", "tetrahedra", "ASCII", "DATASET UNSTRUCTURED_GRID"}) {
    std::getline(file, line);
    EXPECT_EQ(expected, line);
  }
  std::size_t points = 0, cells = 0, numbers = 0, types = 0;
  file >> word >> points >> line;
  EXPECT_EQ("POINTS double", word + " " + line);
  ASSERT_EQ(tetrahedra.points.size(), points);
  for(const Point_3& expected : tetrahedra.points) {
    double x = 0, y = 0, z = 0;
    file >> x >> y >> z;
    EXPECT_EQ(expected, Point_3(x, y, z));
  }
  file >> word >> cells >> numbers;
  EXPECT_EQ("CELLS", word);
  ASSERT_EQ(tetrahedra.cells.size(), cells);
  EXPECT_EQ(5 * cells, numbers);
  for(const auto& expected : tetrahedra.cells) {
    std::size_t n = 0;
    Tetrahedra::Cell cell = {};
    file >> n >> cell[0] >> cell[1] >> cell[2] >> cell[3];
    EXPECT_EQ(4u, n);
    EXPECT_EQ(expected, cell);
  }
  file >> word >> types;
  EXPECT_EQ("CELL_TYPES", word);
  EXPECT_EQ(cells, types);
  for(int type = 0; file >> type; --types)
    EXPECT_EQ(10, type);
  EXPECT_EQ(0u, types);
  EXPECT_TRUE(file.eof());
}

TEST(Tetrahedra, program_refuses_bad_file_names)
{
  const auto directory = std::filesystem::temp_directory_path() / ("tetrahedra_" + std::to_string(getpid()));
  std::filesystem::create_directories(directory);
  for(const char* arguments : {"no/such/directory/out.vtk", "out.off", ".", "''", "a.vtk b.vtk"}) {
    const std::string command = "cd '" + directory.string() + "' && '" FILL_WITH_TETRAHEDRA_PROGRAM "' " + arguments
                                + " > out 2> err";
    const int status = std::system(command.c_str());
    EXPECT_EQ(1, WIFEXITED(status) ? WEXITSTATUS(status) : -1) << arguments;
    EXPECT_EQ(0u, std::filesystem::file_size(directory / "out")) << arguments;
    std::ifstream err(directory / "err");
    std::string line, second_line;
    EXPECT_TRUE(std::getline(err, line)) << arguments;
    EXPECT_EQ(0u, line.find("fill_with_tetrahedra: ")) << line;
    EXPECT_FALSE(std::getline(err, second_line)) << second_line;
    EXPECT_EQ(2, std::distance(std::filesystem::directory_iterator(directory), std::filesystem::directory_iterator()));
  }
  std::filesystem::remove_all(directory);
}
