// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_REGION_CUTTER_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_REGION_CUTTER_H

#include <CGAL/Metric_tensor_2.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_region.h>
#include <CGAL/Parametric_surface_mesher/internal/partition/Patch_sketch.h>
#include <CGAL/intersections.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

/*
Finds where to cut a region in two. Straight lines of the domain are tried in several directions, with about half of the
triangles on either side. The part of a line inside the region, its ends moved to the nearest nodes of the boundary, is a cut if
it leaves the boundary at good angles and keeps a distance from it. The shortest cut is taken, where lengths are increased for
cuts into parts of unequal size. It is divided by the spacing of the sketch.
*/
template <class Evaluator>
class Region_cutter
{
public:
  typedef typename Evaluator::Kernel Kernel;
  typedef Patch_region<Kernel> Region;
  typedef Region_cut<Kernel> Cut;

private:
  typedef typename Cut::Chain Chain;
  typedef Region_node<Kernel> Node;
  typedef typename Kernel::Point_2 Point_2;
  typedef typename Kernel::Segment_2 Segment_2;
  typedef typename Kernel::Vector_2 Vector_2;

  // Lines are tried every 15 degrees, and the best candidates only are divided, which costs evaluations of the surface.
  static constexpr int number_of_directions = 12;
  static constexpr int max_number_of_attempts = 20;
  // The triangles to the left of a line, as shares of all, in the order in which they are tried. Parts of a third and two thirds
  // are the most unequal that are worth a cut.
  static constexpr double shares_to_the_left[] = {0.5, 0.46, 0.54, 0.42, 0.58, 0.38, 0.62, 0.34, 0.66};
  // Resolution with which the triangles on both sides of a line are balanced.
  static constexpr int number_of_slices = 512;
  // Of the angle between a cut and the perpendicular of the boundary: the cut and the boundary enclose at least
  // 50 degrees.
  static constexpr double smallest_cosine = 0.64;
  // A squared cosine of the angle between a cut and the boundary: above, that is below 60 degrees, the triangles at the end are worse
  // and the cut counts as longer by the factor below.
  static constexpr double squared_cosine_of_good_angle = 0.25, factor_of_bad_angle = 1.3;
  // The smallest distance between a cut and the boundary, in spacings.
  static constexpr double smallest_clearance = 0.7;
  // Cuts of fewer pieces cross narrow places, where the boundary leaves no room for good triangles on both sides.
  static constexpr std::size_t least_number_of_pieces = 6;
  // In edges along the boundary: cuts do not end so close to a pole.
  static constexpr std::size_t reach_of_pole = 20;
  // The number of equidistant points with which the length of a cut in spacings is integrated: at first; least and most afterwards,
  // when twice as many as there will be pieces are taken.
  static constexpr std::size_t first_number_of_samples = 16;
  static constexpr double least_number_of_samples = 64, most_samples = 1e6;

  // The line a x + b y = offset.
  struct Line
  {
    double a, b, offset = 0;
    double width = 0; // the extent of the region across the line

    double operator()(const Point_2& p) const { return a * p.x() + b * p.y() - offset; }
    double along(const Point_2& p) const { return a * p.y() - b * p.x(); }
  };

  struct Candidate
  {
    std::vector<std::pair<Region_place, Region_place>> ends;
    double score;
  };

  const Evaluator& m_evaluate;
  const Patch_sketch<Evaluator>& m_sketch;

public:
  Region_cutter(const Evaluator& evaluate, const Patch_sketch<Evaluator>& sketch) : m_evaluate(evaluate), m_sketch(sketch)
  {}

  // The cut; it has no chains if there is no good one. The indices of their inner nodes are not set.
  Cut operator()(const Region& region) const
  {
    std::vector<Candidate> candidates = all_candidates(region);
    std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.score < b.score;
    });
    for(std::size_t i = 0; i < candidates.size() && i < max_number_of_attempts; ++i) {
      Cut cut;
      for(const auto& ends : candidates[i].ends)
        if(!append_chain(region, ends.first, ends.second, cut))
          break;
      if(cut.chains.size() == candidates[i].ends.size() && is_clear(region, cut))
        return cut;
    }
    return Cut();
  }

private:
  static const Node& node(const Region& region, const Region_place& place) { return region.loops[place.loop][place.number]; }

  std::vector<Candidate> all_candidates(const Region& region) const
  {
    Metric_tensor_2 mean(0, 0, 0);
    const double weight = region.weight();
    for(const auto& cell : region.cells)
      mean = mean + (cell.weight / weight) * cell.tensor;
    std::vector<Candidate> result;
    // the directions are equally far apart in the mean metric: the factor is that of Cholesky
    const double l0 = std::sqrt(mean.e()), l1 = mean.f() / l0, l2 = std::sqrt(mean.g() - l1 * l1);
    for(int k = 0; k < number_of_directions; ++k) {
      const double angle = k * CGAL_PI / number_of_directions, c = std::cos(angle), s = std::sin(angle);
      append_candidates(region, mean, Line{l0 * c, l1 * c + l2 * s}, result);
    }
    return result;
  }

  void append_candidates(const Region& region, const Metric_tensor_2& mean, Line line, std::vector<Candidate>& result) const
  {
    const std::vector<double> weights = weights_across(region, line);
    const double total = std::accumulate(weights.begin(), weights.end(), 0.);
    const double first = line.offset, width = line.width / number_of_slices;
    for(double share : shares_to_the_left) {
      double sum = 0;
      std::size_t i = 0;
      for(; i + 1 < weights.size() && sum + weights[i] < share * total; ++i)
        sum += weights[i];
      line.offset = first + (double(i) + (share * total - sum) / weights[i]) * width;
      Candidate candidate;
      if(find_ends(region, mean, line, candidate)) {
        candidate.score /= (std::min)(share, 1 - share);
        result.push_back(std::move(candidate));
      }
    }
  }

  // The weights of slices along the line. Sets the offset of the line, to that of the first slice, and the width.
  static std::vector<double> weights_across(const Region& region, Line& line)
  {
    double smallest = line(region.loops[0][0].domain_point), largest = smallest;
    for(const Node& node : region.loops[0]) {
      smallest = (std::min)(smallest, line(node.domain_point));
      largest = (std::max)(largest, line(node.domain_point));
    }
    line.offset = smallest;
    line.width = largest - smallest;
    std::vector<double> result(number_of_slices, 0.);
    for(const auto& cell : region.cells) {
      const double place = line(cell.center) / line.width * number_of_slices;
      result[std::size_t((std::min)((std::max)(place, 0.), number_of_slices - 1.))] += cell.weight;
    }
    return result;
  }

  // Finds what of the line is inside the region. The score is its length, increased for bad angles with the boundary.
  bool find_ends(const Region& region, const Metric_tensor_2& mean, const Line& line, Candidate& candidate) const
  {
    std::vector<std::pair<double, Region_place>> crossings;
    for(std::size_t l = 0; l < region.loops.size(); ++l) {
      const auto& loop = region.loops[l];
      double here = line(loop[0].domain_point);
      for(std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t next = (i + 1) % loop.size();
        const double there = line(loop[next].domain_point);
        if((here < 0) != (there < 0))
          crossings.emplace_back(line.along(midpoint(loop[i].domain_point, loop[next].domain_point)),
                                 Region_place{l, std::fabs(here) < std::fabs(there) ? i : next});
        here = there;
      }
    }
    if(crossings.empty() || crossings.size() % 2 != 0)
      return false;
    std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    candidate.score = 0;
    for(std::size_t i = 0; i < crossings.size(); i += 2) {
      const Region_place &source = crossings[i].second, &target = crossings[i + 1].second;
      if(is_close_to_pole(region, source) || is_close_to_pole(region, target))
        return false;
      const double largest = (std::max)(squared_cosine(region, source, node(region, target).domain_point),
                                        squared_cosine(region, target, node(region, source).domain_point));
      if(largest > square(smallest_cosine))
        return false;
      const auto d = node(region, target).domain_point - node(region, source).domain_point;
      candidate.score += std::sqrt(mean.squared_length(d.x(), d.y())) * (largest > squared_cosine_of_good_angle ? factor_of_bad_angle : 1);
      candidate.ends.emplace_back(source, target);
    }
    return true;
  }

  // Whether a node is so close to a pole that a cut would disturb the ring of triangles around it.
  bool is_close_to_pole(const Region& region, const Region_place& place) const
  {
    const auto& chart = m_evaluate.oracle().surface().chart();
    const std::size_t n = region.loops[place.loop].size(), reach = (std::min)(reach_of_pole, n / 2);
    for(std::size_t i = 0; i <= 2 * reach; ++i)
      if(chart.is_pole(region.loops[place.loop][(place.number + n - reach + i) % n].domain_point))
        return true;
    return false;
  }

  static double cross(const Vector_2& a, const Vector_2& b) { return a.x() * b.y() - a.y() * b.x(); }

  // The larger one of the squared cosines of the two angles between the segment from a node to `p` and the edges of the boundary
  // at the node; 1 if that segment does not lead inside.
  static double squared_cosine(const Region& region, const Region_place& place, const Point_2& p)
  {
    const auto& loop = region.loops[place.loop];
    const Node& here = loop[place.number];
    const auto next = loop[(place.number + 1) % loop.size()].domain_point - here.domain_point,
               before = loop[(place.number + loop.size() - 1) % loop.size()].domain_point - here.domain_point,
               way = p - here.domain_point;
    const Metric_tensor_2& m = here.tensor;
    double result = 0;
    for(const auto& edge : {next, before}) {
      const double product = edge.x() * (m.e() * way.x() + m.f() * way.y()) + edge.y() * (m.f() * way.x() + m.g() * way.y());
      if(product > 0)
        result = (std::max)(result, square(product) / (m.squared_length(edge.x(), edge.y()) * m.squared_length(way.x(), way.y())));
    }
    const bool is_left_of_next = cross(next, way) > 0, is_right_of_before = cross(way, before) > 0;
    const bool is_inside = cross(next, before) > 0 ? is_left_of_next && is_right_of_before : is_left_of_next || is_right_of_before;
    return is_inside ? result : 1;
  }

  // Divides a segment into pieces as long as the spacing. Returns false if this is impossible or makes too few pieces.
  bool append_chain(const Region& region, const Region_place& source, const Region_place& target, Cut& cut) const
  {
    const Node &from = node(region, source), &to = node(region, target);
    const std::vector<double> lengths = lengths_along(from.domain_point, to.domain_point);
    const std::size_t n = lengths.empty() ? 0 : std::size_t(std::lround(lengths.back()));
    if(n < least_number_of_pieces)
      return false;
    Chain chain{source, target, {from}};
    for(std::size_t k = 1, i = 0; k < n; ++k) {
      const double wanted = lengths.back() * double(k) / double(n);
      while(lengths[i + 1] < wanted)
        ++i;
      const double share = (double(i) + (wanted - lengths[i]) / (lengths[i + 1] - lengths[i])) / double(lengths.size() - 1);
      const Point_2 p = from.domain_point + share * (to.domain_point - from.domain_point);
      const auto position = m_evaluate.position(p, m_sketch.spacing(p));
      if(position.is_tensor_replaced)
        return false;
      chain.nodes.emplace_back(Boundary_vertex<Kernel>{p, position.point.surface_point(), 0}, position.point.tensor());
    }
    chain.nodes.push_back(to);
    cut.chains.push_back(std::move(chain));
    return true;
  }

  // The lengths, in spacings, from `p` to equidistant points on the way to `q`; none if the way leaves the patch.
  std::vector<double> lengths_along(const Point_2& p, const Point_2& q) const
  {
    std::size_t n = first_number_of_samples;
    std::vector<double> result;
    for(int pass = 0; pass < 2; ++pass) {
      result.assign(1, 0.);
      double previous = density(p, q - p);
      for(std::size_t i = 1; i <= n; ++i) {
        const double next = density(p + double(i) / double(n) * (q - p), q - p);
        if(!(next > 0))
          return {};
        result.push_back(result.back() + 0.5 * (previous + next) / double(n));
        previous = next;
      }
      n = std::size_t((std::min)((std::max)(2 * result.back(), double(least_number_of_samples)), double(most_samples)));
    }
    return result;
  }

  // The length of the vector `d` at `p`, in spacings.
  double density(const Point_2& p, const Vector_2& d) const
  {
    const double spacing = m_sketch.spacing(p);
    if(!(spacing > 0))
      return 0;
    const auto position = m_evaluate.position(p, spacing);
    return std::sqrt(position.point.tensor().squared_length(d.x(), d.y()))
           / (std::min)(spacing, m_evaluate.spacing_limit(position));
  }

  // Whether the cut keeps its distance from the boundary, and its chains have no common end.
  static bool is_clear(const Region& region, const Cut& cut)
  {
    for(const Chain& chain : cut.chains) {
      const double reach = largest_clearance(chain);
      for(std::size_t l = 0; l < region.loops.size(); ++l)
        for(std::size_t i = 0; i < region.loops[l].size(); ++i)
          if(!is_clear(region, {l, i}, chain, reach))
            return false;
      for(const Chain& other : cut.chains)
        if(&other != &chain && (has_end(other, chain.source) || has_end(other, chain.target)))
          return false;
    }
    return true;
  }

  static bool are_one(const Region_place& a, const Region_place& b) { return a.loop == b.loop && a.number == b.number; }

  static bool has_end(const Chain& chain, const Region_place& place)
  {
    return are_one(chain.source, place) || are_one(chain.target, place);
  }

  // The largest distance, in the domain, that a point of the chain must keep.
  static double largest_clearance(const Chain& chain)
  {
    double squared = 0;
    for(std::size_t k = 0; k + 1 < chain.nodes.size(); ++k)
      squared = (std::max)(squared, squared_clearance(chain, k) / chain.nodes[k].tensor.lambda_min());
    return std::sqrt(squared);
  }

  // The squared distance, in space, that node `k` must keep.
  static double squared_clearance(const Chain& chain, std::size_t k)
  {
    const auto step = chain.nodes[k + 1].domain_point - chain.nodes[k].domain_point;
    return square(smallest_clearance) * chain.nodes[k].tensor.squared_length(step.x(), step.y());
  }

  // Whether a node of the boundary keeps its distance. Nodes farther than `reach` from the line of the chain always do.
  static bool is_clear(const Region& region, const Region_place& place, const Chain& chain, double reach)
  {
    const Region_place next{place.loop, (place.number + 1) % region.loops[place.loop].size()};
    const bool is_source = are_one(place, chain.source), is_target = are_one(place, chain.target);
    if(is_source && is_target)
      return false;
    const Point_2 &p = node(region, place).domain_point, &from = chain.nodes.front().domain_point,
                  &to = chain.nodes.back().domain_point;
    if(!is_source && !is_target && !are_one(next, chain.source) && !are_one(next, chain.target)
       && do_intersect(Segment_2(p, node(region, next).domain_point), Segment_2(from, to)))
      return false;
    const auto way = to - from, d = p - from;
    if(is_source || is_target || square(cross(way, d)) > square(reach) * way.squared_length())
      return true;
    for(std::size_t k = 1; k + 1 < chain.nodes.size(); ++k) {
      const auto away = p - chain.nodes[k].domain_point;
      if(chain.nodes[k].tensor.squared_length(away.x(), away.y()) < squared_clearance(chain, k))
        return false;
    }
    return true;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_PARTITION_REGION_CUTTER_H
