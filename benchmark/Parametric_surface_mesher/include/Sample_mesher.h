// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef SAMPLE_MESHER_H
#define SAMPLE_MESHER_H

#include "Sample_surfaces.h"
#include "measure.h"

#include <CGAL/Parametric_surface_mesh_report.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>

typedef CGAL::Surface_mesh<Sample_kernel::Point_3> Sample_mesh;

// What a mesher took, without the conversion of its result to a `Sample_mesh`.
struct Mesher_run
{
  double seconds;
  double memory; // by how much the peak memory of the process grew, in bytes
  std::optional<CGAL::Parametric_surface_mesh_report> report = {}; // of this package's mesher alone
};

template <class Job>
Mesher_run run_of(const Job& job)
{
  const double memory_before = peak_memory();
  const double seconds = seconds_of(job);
  return {seconds, peak_memory() - memory_before};
}

// A mesher of one sample surface: it is told the edge length and adds to the mesh.
struct Sample_mesher
{
  std::string name;
  std::function<Mesher_run(double edge_length, Sample_mesh& mesh)> run;
};

// The edge length for `size` triangles, whatever a mesher makes of it: their number goes with its inverse square.
inline double calibrated_edge_length(const Sample_mesher& mesher, const Sample& sample, double size)
{
  double edge_length = sample.edge_length(size);
  for(int i = 0; i < 2; ++i) {
    Sample_mesh mesh;
    mesher.run(edge_length, mesh);
    const double excess = mesh.number_of_faces() / size;
    if(std::abs(excess - 1) < 0.03)
      break;
    edge_length *= std::sqrt(excess);
  }
  return edge_length;
}

#endif // SAMPLE_MESHER_H
