// Copyright (c) 2026 The authors of Parametric_surface_mesher.
// All rights reserved.
//
// This file is part of Parametric_surface_mesher, an extension package of CGAL.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_INTERSECTION_REFINEMENT_H
#define CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_INTERSECTION_REFINEMENT_H

#include <CGAL/Parametric_surface_mesh_criteria.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Meshed_faces.h>
#include <CGAL/Parametric_surface_mesher/internal/driver/Room_between_triangles.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Indexed_mesh.h>
#include <CGAL/Parametric_surface_mesher/internal/output/Intersection_search.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/Size_sources_3.h>
#include <CGAL/Parametric_surface_mesher/internal/sizing/least_length.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Parametric_surface_mesher {
namespace internal {

// Sizes with which a mesh does not intersect itself. Facets pass through each other where they are farther from their surfaces than
// these are apart. There the wanted edges become shorter, by as much as that takes, and the model is meshed again. Where surfaces
// themselves meet that cannot help, and is not tried.
template <class Model>
class Intersection_refinement
{
public:
  typedef typename Model::Surface_3 Surface;
  typedef typename Model::Geom_traits Kernel;
  typedef typename Kernel::Point_3 Point_3;
  typedef Indexed_mesh<Kernel> Mesh;
  typedef Intersection_search<Kernel> Search;

private:
  typedef Size_sources_3<Point_3> Sources;
  typedef typename Sources::Source Source;
  typedef Triangle_on_surface<Surface> Triangle;
  typedef std::pair<std::size_t, std::size_t> Patches;
  typedef std::map<std::size_t, std::vector<Source>> Sources_of_patches;

  // The deviation of an edge of the wanted length, as a share of the distance between two surfaces. Edges may be 1.4 times as long, then
  // deviations are twice as large; and both surfaces deviate.
  static constexpr double share_of_room = 0.18;
  static constexpr double share_of_flat = 0.1; // a facet with less than this share of the deviations stays as it is
  // Edges become shorter by these factors at once, and in so many rounds.
  static constexpr double least_factor = 0.125, largest_factor = 0.7;
  static constexpr int max_number_of_rounds = 10;
  // The triangles that the meshes of all rounds may have together: a multiple of those of the first one, and a number that any model may
  // have. Each round looks at all of its triangles, which takes seconds for a large model.
  static constexpr double share_of_work = 3, number_of_work = 2.5e6;
  // No edge becomes shorter than this share of the minimum edge.
  static constexpr double share_of_min_edge = 1. / 16;
  // As shares of the longest edge, and of the minimum edge: what is less counts as nothing; surfaces that are closer touch.
  static constexpr double precision = 1e-6, share_of_touch = 0.01;
  // The mesh may become so much larger: by a share of its triangles, and a number that any mesh may have.
  static constexpr double share_of_growth = 2, number_of_growth = 200000;

  // What was done about two patches, or one with itself, whose triangles pass through each other.
  struct Attempt
  {
    Sources_of_patches sources;
    double number_of_triangles = 0;                     // that these add, by an estimate
    std::size_t number_of_pairs = 0;                    // before there were any
    bool is_given_up = false;
  };

  const Model& m_model;
  const Parametric_surface_mesh_criteria& m_criteria;
  double m_min_edge, m_max_edge;
  std::map<Patches, Attempt> m_attempts;
  Sources_of_patches m_sources; // of the finer model
  std::map<std::size_t, Bbox_2> m_boxes; // of patches in their domains
  int m_number_of_rounds = 0;
  double m_work = 0, m_allowed_work = 0; // in triangles

public:
  // `min_edge`, `max_edge`: those in effect
  Intersection_refinement(const Model& model, const Parametric_surface_mesh_criteria& criteria, double min_edge, double max_edge)
    : m_model(model), m_criteria(criteria), m_min_edge(min_edge), m_max_edge(max_edge)
  {}

  // Whether, at two triangles that pass through each other, the surfaces themselves cross or touch.
  bool are_surfaces_in_contact(const Mesh& mesh, const typename Search::Pair& pair)
  {
    const Triangle first = triangle(mesh, pair[0]), second = triangle(mesh, pair[1]);
    if(mesh.parts[pair[0].part].patch == mesh.parts[pair[1].part].patch)
      return false;
    const double length = (std::max)(first.longest_side(), second.longest_side());
    if(!(first.deviation() + second.deviation() > precision * length))
      return true;
    const auto width = Room_between_triangles<Surface>(first, second, precision * length).width();
    return !width || *width < share_of_touch * m_min_edge;
  }

  // Looks at the pairs of triangles that pass through each other. Returns whether the sizes are other ones now.
  // \pre the mesh has its corner points
  bool change_sizes(const Mesh& mesh, const std::vector<typename Search::Pair>& pairs)
  {
    std::map<Patches, std::vector<typename Search::Pair>> pairs_of_patches;
    for(const auto& pair : pairs)
      pairs_of_patches[std::minmax(mesh.parts[pair[0].part].patch, mesh.parts[pair[1].part].patch)].push_back(pair);
    if(m_number_of_rounds == 0)
      m_allowed_work = number_of_work + share_of_work * double(mesh.number_of_faces());
    m_work += double(mesh.number_of_faces());
    const bool is_last = ++m_number_of_rounds > max_number_of_rounds || m_work > m_allowed_work;
    bool is_changed = false;
    for(const auto& of_patches : pairs_of_patches) {
      Attempt& attempt = m_attempts[of_patches.first];
      if(attempt.is_given_up)
        continue;
      Attempt finer = is_last ? Attempt() : this->finer(mesh, of_patches.second, attempt);
      if(!finer.sources.empty() && finer.number_of_triangles < number_of_growth + share_of_growth * double(mesh.number_of_faces())) {
        attempt = std::move(finer);
        is_changed = true;
      }
      else {
        if(of_patches.second.size() >= attempt.number_of_pairs && !attempt.sources.empty()) { // these did not help
          attempt = Attempt();
          is_changed = true;
        }
        attempt.is_given_up = true;
      }
    }
    return is_changed;
  }

  // The model with the sizes. `meshed_faces`: forgets the faces whose sizes are not the same as in the finer model before
  Model finer_model(Meshed_faces<Kernel>& meshed_faces)
  {
    Sources_of_patches sources;
    for(const auto& attempt : m_attempts)
      for(const auto& of_patch : attempt.second.sources) {
        const std::size_t front = m_model.faces()[of_patch.first].other_side_of;
        auto& all = sources[front == Model::no_face ? of_patch.first : front];
        all.insert(all.end(), of_patch.second.begin(), of_patch.second.end());
      }
    Model result = m_model;
    for(const auto& of_patch : sources)
      set_sizes(of_patch.second, result.faces()[of_patch.first]);
    for(std::size_t f = 0; f < result.faces().size(); ++f)
      if(!have_same_sources(f, m_sources, sources))
        meshed_faces.forget(f);
    m_sources = std::move(sources);
    return result;
  }

  // Forgets the faces that the finer model has other sizes for.
  void forget_refined(Meshed_faces<Kernel>& meshed_faces) const
  {
    for(const auto& of_patch : m_sources)
      meshed_faces.forget(of_patch.first);
  }

private:
  static bool have_same_sources(std::size_t patch, const Sources_of_patches& before, const Sources_of_patches& now)
  {
    const auto first = before.find(patch), second = now.find(patch);
    if(first == before.end() || second == now.end())
      return first == before.end() && second == now.end();
    return std::equal(first->second.begin(), first->second.end(), second->second.begin(), second->second.end(),
                      [](const Source& a, const Source& b) { return a.place == b.place && a.length == b.length; });
  }

  template <class Face>
  void set_sizes(std::vector<Source> sources, Face& face) const
  {
    double min_edge = face.min_edge > 0 ? face.min_edge : m_min_edge;
    for(const Source& source : sources)
      min_edge = (std::min)(min_edge, source.length / 2);
    face.min_edge = min_edge;
    auto before = face.sizing_field;
    if(!before && m_criteria.sizing_field())
      before = *m_criteria.sizing_field();
    face.sizing_field = [before, surface = face.surface,
                         lengths = std::make_shared<const Sources>(std::move(sources)), max_edge = m_max_edge](double u, double v) {
      const double length = (std::min)((*lengths)(surface.point(u, v)), max_edge);
      return before ? least_length(length, before(u, v)) : length;
    };
  }

  // The sources of an attempt and those that keep these triangles apart; none if nothing does.
  Attempt finer(const Mesh& mesh, const std::vector<typename Search::Pair>& pairs, const Attempt& before)
  {
    std::map<typename Search::Place, double> lengths; // by triangle
    for(const auto& pair : pairs)
      if(!add_lengths(mesh, pair, lengths))
        return Attempt();
    Attempt result = before;
    if(before.sources.empty())
      result.number_of_pairs = pairs.size();
    for(const auto& length : lengths) {
      const Triangle triangle = this->triangle(mesh, length.first);
      auto& sources = result.sources[mesh.parts[length.first.part].patch];
      sources.push_back({centroid(triangle.corners[0], triangle.corners[1], triangle.corners[2]), length.second});
      for(const auto& corner : triangle.corners) // edges that have them may be on the boundary
        sources.push_back({corner, length.second});
      const double factor = triangle.longest_side() / length.second;
      result.number_of_triangles += factor * factor;
    }
    return lengths.empty() ? Attempt() : result;
  }

  // Returns whether shorter edges can keep the triangles apart. They do not turn a triangle round that faces away from its surface.
  bool add_lengths(const Mesh& mesh, const typename Search::Pair& pair, std::map<typename Search::Place, double>& lengths)
  {
    const Triangle first = triangle(mesh, pair[0]), second = triangle(mesh, pair[1]);
    const double deviations[] = {first.deviation(), second.deviation()}, sum = deviations[0] + deviations[1];
    const double length = (std::max)(first.longest_side(), second.longest_side());
    if(!(sum > precision * length) || first.is_inverted() || second.is_inverted())
      return false;
    std::optional<double> width = Room_between_triangles<Surface>(first, second, precision * length).width();
    if(!width && mesh.parts[pair[0].part].patch != mesh.parts[pair[1].part].patch)
      return false;
    const Triangle* const triangles[] = {&first, &second};
    for(int i = 0; i < 2; ++i) {
      const double longest = triangles[i]->longest_side(), curvature = triangles[i]->curvature(),
                   by_width = width ? std::sqrt(8 * share_of_room * *width / curvature) : longest,
                   wanted = (std::min)((std::max)(by_width, least_factor * longest), largest_factor * longest);
      if(deviations[i] < share_of_flat * sum && curvature * longest * longest < 8 * share_of_flat * sum)
        continue;
      if(wanted < share_of_min_edge * m_min_edge)
        return false;
      double& known = lengths.emplace(pair[i], wanted).first->second;
      known = (std::min)(known, wanted);
    }
    return true;
  }

  Triangle triangle(const Mesh& mesh, const typename Search::Place& place)
  {
    const auto& part = mesh.parts[place.part];
    Triangle result{m_model.faces()[part.patch].surface, box(mesh, part.patch), {}, part.corner_points[place.face]};
    for(std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = part.faces[place.face][i];
      result.corners[i] = v < mesh.points.size() ? mesh.points[v] : part.points[v - part.first_point];
    }
    return result;
  }

  // The box, in the domain of a patch, of the corners of all its triangles.
  const Bbox_2& box(const Mesh& mesh, std::size_t patch)
  {
    const auto found = m_boxes.emplace(patch, Bbox_2());
    if(found.second)
      for(const auto& part : mesh.parts)
        if(part.patch == patch)
          for(const auto& corners : part.corner_points)
            for(const auto& corner : corners)
              found.first->second += corner.bbox();
    return found.first->second;
  }
};

} // namespace internal
} // namespace Parametric_surface_mesher
} // namespace CGAL

#endif // CGAL_PARAMETRIC_SURFACE_MESHER_INTERNAL_DRIVER_INTERSECTION_REFINEMENT_H
