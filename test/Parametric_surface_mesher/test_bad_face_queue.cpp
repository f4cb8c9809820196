// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order in which bad faces are refined, and the cells of the domain that it follows.

#include <CGAL/Parametric_surface_mesher/internal/refinement/Bad_face_queue.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace internal = CGAL::Parametric_surface_mesher::internal;

namespace {

typedef CGAL::Simple_cartesian<double>::Point_2 Point_2;
typedef internal::Balanced_cells_2<Point_2> Cells;

struct Vertex
{
  Point_2 place;

  const Vertex& point() const { return *this; }
  const Point_2& domain_point() const { return place; }
};

struct Face
{
  Vertex first;
  std::uint32_t number_of_changes = 0;

  const Vertex* vertex(int) const { return &first; }
  std::uint32_t stamp() const { return number_of_changes; }
};

typedef internal::Bad_face_queue<Face*> Queue;

std::vector<Face> random_faces(std::size_t n)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Face> result(n);
  for(Face& face : result)
    face.first.place = Point_2(coordinate(random), coordinate(random));
  return result;
}

} // namespace

TEST(Balanced_cells_2, one_before_division)
{
  Cells cells;
  EXPECT_EQ(1u, cells.size());
  EXPECT_EQ(0u, cells(Point_2(3, 4)));
  cells.divide({}, 10);
  EXPECT_EQ(1u, cells.size());
  cells.divide({{Point_2(0, 0), 10}}, 10);
  EXPECT_EQ(1u, cells.size());
}

// also where points are crowded
TEST(Balanced_cells_2, have_similar_weights)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0, 1), angle(0, 6.28), weight(1, 2);
  std::vector<Cells::Weighted_point> points;
  for(int i = 0; i < 10000; ++i) {
    const double r = std::pow(radius(random), 4), a = angle(random);
    points.push_back({Point_2(r * std::cos(a), 100 * r * std::sin(a)), weight(random)});
  }
  Cells cells;
  cells.divide(points, 300);
  ASSERT_EQ(64u, cells.size()); // for a weight of about 15000
  std::vector<double> weights(cells.size());
  for(const auto& p : points) {
    ASSERT_LT(cells(p.point), cells.size());
    weights[cells(p.point)] += p.weight;
  }
  EXPECT_GT(*std::min_element(weights.begin(), weights.end()), 15000 / 64. - 12);
  EXPECT_LT(*std::max_element(weights.begin(), weights.end()), 15000 / 64. + 12);
}

TEST(Balanced_cells_2, of_points_in_one_place)
{
  Cells cells;
  cells.divide(std::vector<Cells::Weighted_point>(100, {Point_2(1, 1), 1.}), 10);
  EXPECT_EQ(16u, cells.size());
  EXPECT_LT(cells(Point_2(1, 1)), 16u);
  EXPECT_LT(cells(Point_2(0, 5)), 16u);
}

TEST(Bad_face_queue, is_by_urgency_then_badness)
{
  using internal::Urgency;
  std::vector<Face> faces = random_faces(8);
  Queue queue;
  queue.push(&faces[0], 1.5, Urgency::LAST);
  queue.push(&faces[1], 9, Urgency::LAST);
  queue.push(&faces[2], 1.5, Urgency::FIRST);
  queue.push(&faces[3], 5, Urgency::NORMAL);
  queue.push(&faces[4], 30, Urgency::NORMAL);
  queue.push(&faces[5], 1e4, Urgency::NORMAL); // coarse
  queue.push(&faces[6], std::numeric_limits<double>::infinity(), Urgency::FIRST);
  queue.push(&faces[7], 40, Urgency::NORMAL);
  faces[7].number_of_changes = 1;
  EXPECT_EQ(8u, queue.size());
  for(std::size_t i : {6, 5, 2, 4, 3, 1, 0})
    EXPECT_EQ(&faces[i], queue.pop());
  EXPECT_EQ(nullptr, queue.pop());
  EXPECT_EQ(0u, queue.size());
  queue.push(&faces[0], 2, Urgency::LAST); // anew
  EXPECT_EQ(&faces[0], queue.pop());
  EXPECT_EQ(nullptr, queue.pop());
}

// Faces for a million triangles, a part of which come back with less badness: each comes out as often as it was put in, and
// the queue moves through the domain cell by cell.
TEST(Bad_face_queue, goes_from_cell_to_cell)
{
  std::vector<Face> faces = random_faces(4000);
  std::vector<int> number_of_visits(faces.size());
  Queue queue;
  for(Face& face : faces)
    queue.push(&face, 256, internal::Urgency::LAST);
  std::vector<CGAL::Bbox_2> boxes(32); // of as many subsequent faces each
  std::size_t number = 0;
  while(Face* const face = queue.pop()) {
    ASSERT_LT(number, 5 * faces.size());
    boxes[number++ * boxes.size() / (5 * faces.size())] += face->first.place.bbox();
    ++face->number_of_changes;
    const int visits = ++number_of_visits[std::size_t(face - faces.data())];
    if(visits < 5)
      queue.push(face, std::ldexp(256, -2 * visits), visits % 2 == 0 ? internal::Urgency::FIRST : internal::Urgency::LAST);
  }
  EXPECT_EQ(5 * faces.size(), number);
  EXPECT_EQ(0u, queue.size());
  EXPECT_EQ(std::vector<int>(faces.size(), 5), number_of_visits);
  double area = 0;
  for(const CGAL::Bbox_2& box : boxes)
    area += box.x_span() * box.y_span();
  EXPECT_LT(area, 2); // of boxes from cells that share no place: 1; without cells each box is about 1
}
