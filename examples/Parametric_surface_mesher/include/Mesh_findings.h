// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the summaries of the programs end with: what is wrong with a mesh, what is good to know of it, and a verdict.
#ifndef MESH_FINDINGS_H
#define MESH_FINDINGS_H

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

// Sentences about a mesh, without a full stop.
struct Mesh_findings
{
  std::vector<std::string> faults;    // what is wrong: the exit status is 1 if there is any
  std::vector<std::string> notes;     // what is good to know
  std::vector<std::string> unchecked; // what was not looked at and might be a fault, as words
  bool is_any_triangle_unmet = false; // whether some of the notes are on triangles that are not as was wanted
};

namespace mesh_patch {

// Appends the first ones of some sentences, and the number of the others, which are called `rest`.
inline void append_first(std::vector<std::string> sentences, const std::string& rest, std::vector<std::string>& result)
{
  const std::size_t most = 5;
  const std::size_t number = sentences.size();
  if(number > most + 1) {
    sentences.resize(most);
    sentences.push_back("and " + std::to_string(number - most) + " more " + rest);
  }
  result.insert(result.end(), std::make_move_iterator(sentences.begin()), std::make_move_iterator(sentences.end()));
}

// One sentence that agrees with the exit status.
inline std::string verdict(const Mesh_findings& findings)
{
  if(!findings.faults.empty())
    return "something is WRONG with the mesh, as said above";
  if(!findings.unchecked.empty()) {
    std::string list;
    for(const std::string& what : findings.unchecked)
      list += (list.empty() ? "" : ", ") + what;
    return "nothing wrong was found, but this was not looked at: " + list;
  }
  return findings.is_any_triangle_unmet ? "nothing is wrong with the mesh" : "all is well";
}

inline void print_findings(std::ostream& out, const Mesh_findings& findings)
{
  for(const std::string& fault : findings.faults)
    out << "  WRONG: " << fault << "\n";
  for(const std::string& note : findings.notes)
    out << "  note: " << note << "\n";
  out << "  verdict: " << verdict(findings) << "\n";
}

} // namespace mesh_patch

#endif // MESH_FINDINGS_H
