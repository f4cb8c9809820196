// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reports in sentences for people, as the programs print them.
#include "findings_of_report.h"
#include "distance_findings.h"
#include "summary_lines.h"
#include "text_of_numbers.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace mesh_patch;
using CGAL::Parametric_surface_mesher::Criterion_set;
typedef std::vector<std::string> Sentences;

CGAL::Parametric_surface_mesh_criteria criteria()
{
  CGAL::Parametric_surface_mesh_criteria result;
  result.set_max_edge(1).set_min_edge(0.25).set_distance(0.125);
  return result;
}

Mesh_findings findings_of(const CGAL::Parametric_surface_mesh_report& report)
{
  Mesh_findings result;
  add_stop(report, result);
  add_unmet(report, criteria(), {"mm"}, result);
  add_intersections(report, [](std::size_t face) { return face + 1; }, result);
  return result;
}

TEST(Findings, numbers_are_short_and_have_no_exponent)
{
  EXPECT_EQ(text_of(0.012345678), "0.01235");
  EXPECT_EQ(text_of(12345.678), "12346");
  EXPECT_EQ(text_of(-12345.678), "-12346");
  EXPECT_EQ(text_of(0.), "0");
  EXPECT_EQ(text_of_size({100.02, 5.017, 1234.4}), "100 x 5.02 x 1234");
  EXPECT_EQ(Text_of_length{"mm"}(2.5), "2.5 mm");
  EXPECT_EQ(Text_of_length{}(2.5), "2.5");
  EXPECT_EQ((Text_of_length{"mm", 1e-9}(1e-10)), "0 mm");
}

TEST(Findings, nothing_to_say_is_well)
{
  const Mesh_findings found = findings_of({});
  std::ostringstream out;
  print_findings(out, found);
  EXPECT_EQ(out.str(), "  verdict: all is well\n");
}

TEST(Findings, each_cause_has_one_sentence)
{
  CGAL::Parametric_surface_mesh_report report;
  const Criterion_set angle = Mesh_criterion::ANGLE, size_and_angle = angle | Mesh_criterion::SIZE;
  report.unmet = {{0, angle, Unmet_cause::BOUNDARY}, {1, angle, Unmet_cause::BOUNDARY}, {2, angle, Unmet_cause::BOUNDARY}};
  EXPECT_EQ(findings_of(report).notes, (Sentences{"3 triangles are below 30 degrees: the fixed boundary leaves no better point"}));
  report.unmet.push_back({3, size_and_angle, Unmet_cause::BOUNDARY});
  report.unmet.push_back({4, Mesh_criterion::DISTANCE, Unmet_cause::MINIMUM_EDGE});
  const Mesh_findings found = findings_of(report);
  EXPECT_EQ(found.notes, (Sentences{"1 triangle is larger than wanted, 4 are below 30 degrees: the fixed boundary leaves no better point",
                                    "1 triangle is farther from the surface than 0.125 mm: edges there are as short as they may be, 0.25 mm; "
                                    "a smaller --min-edge lets them be divided"}));
  EXPECT_TRUE(found.faults.empty());
  EXPECT_EQ(verdict(found), "nothing is wrong with the mesh");
}

TEST(Findings, there_are_words_for_all_criteria_and_causes)
{
  for(const auto criterion : CGAL::Parametric_surface_mesher::all_criteria())
    EXPECT_NE(text_of(criterion, criteria(), {}), "");
  for(const auto cause : CGAL::Parametric_surface_mesher::all_causes())
    EXPECT_NE(text_of(cause, 1, {}), "");
}

TEST(Findings, triangles_that_face_the_wrong_way_are_wrong)
{
  CGAL::Parametric_surface_mesh_report inverted, folded, crossing, of_shape, stopped;
  inverted.unmet = {{0, Mesh_criterion::INVERTED, Unmet_cause::WORK_LIMIT}};
  folded.folds = {{{0, 2}, 1, {{1, 2, 3}}}};
  crossing.intersections = {{{1, 1}, 2, {{1, 2, 3}}, false}};
  of_shape.intersections = {{{1, 1}, 2, {{1, 2, 3}}, true}};
  stopped.is_stopped = true;
  for(const auto* report : {&inverted, &folded, &crossing, &stopped}) {
    const Mesh_findings found = findings_of(*report);
    EXPECT_EQ(found.faults.size(), 1u);
    EXPECT_TRUE(found.notes.empty());
    EXPECT_EQ(verdict(found), "something is WRONG with the mesh, as said above");
  }
  const std::string fold = findings_of(folded).faults.front();
  EXPECT_EQ(fold.find("the mesh is folded, triangles face the wrong way: faces 1 and 3 at (1, 2, 3), 1 pair of triangles"), 0u);
  EXPECT_EQ(findings_of(crossing).faults.front().find("the mesh intersects itself: face 2 at (1, 2, 3), 2 pairs of triangles"), 0u);
  EXPECT_TRUE(findings_of(of_shape).faults.empty());
  EXPECT_EQ(findings_of(of_shape).notes.size(), 1u);
}

TEST(Findings, long_lists_end_with_a_number)
{
  CGAL::Parametric_surface_mesh_report report;
  report.folds.resize(20);
  EXPECT_EQ(findings_of(report).faults.size(), 6u);
  EXPECT_EQ(findings_of(report).faults.back(), "and 15 more pairs of faces where it is folded");
  report.folds.resize(6);
  EXPECT_EQ(findings_of(report).faults.size(), 6u); // none is left out for the sake of a line
}

TEST(Findings, distances_a_little_too_large_are_no_fault)
{
  const auto found = [](double distance) {
    Mesh_findings result;
    add_distance("shape", distance, 1, result);
    return result;
  };
  EXPECT_TRUE(found(1).notes.empty() && found(1).faults.empty());
  EXPECT_EQ(found(1.2).notes.size(), 1u);
  EXPECT_TRUE(found(1.2).faults.empty());
  EXPECT_EQ(found(2).faults.size(), 1u);
}

TEST(Findings, what_was_not_looked_at_is_not_said_to_be_well)
{
  Mesh_findings found;
  found.unchecked = {"the distance"};
  EXPECT_EQ(verdict(found), "nothing wrong was found, but this was not looked at: the distance");
}

TEST(Findings, times_that_are_next_to_nothing_are_left_out)
{
  std::ostringstream out;
  print_seconds(out, {{"reading", 1.5}, {"curving", 0}, {"meshing", 2.5}});
  EXPECT_EQ(out.str(), "  processor time: 4 s, of which reading 1.5, meshing 2.5\n");
}

} // namespace
