// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Damages CAD files at random and lets mesh_cad mesh them: those of Debian's package occt-misc that are not too large, and shapes made
// here. Prints each file that makes mesh_cad crash, take more than 30 seconds, or succeed though faces are lost; such files are kept.
#include <Damaged_files.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace {

struct Whole_file
{
  std::string name;
  std::size_t number_of_faces;
};

// Files that take mesh_cad more than this are left out, and those that it does not mesh as they are.
const std::size_t largest_size = 300000;

std::vector<std::string> installed_files()
{
  std::vector<std::string> result;
  const std::string folder = "/usr/share/opencascade/data";
  if(std::filesystem::is_directory(folder))
    for(const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
      const std::string ending = entry.path().extension().string();
      if((ending == ".step" || ending == ".iges" || ending == ".brep") && entry.file_size() < largest_size)
        result.push_back(entry.path().string());
    }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  if(argc < 3 || argc > 5) {
    std::cerr << "Usage: damaged_cad_files MESH_CAD FOLDER [NUMBER [SEED]]\n"
              << "FOLDER takes the files. NUMBER is 2000 and SEED is 1 if not given.\n";
    return 2;
  }
  const std::string program = std::string("'") + argv[1] + "'", folder = argv[2];
  const unsigned long number = argc > 3 ? std::stoul(argv[3]) : 2000, seed = argc > 4 ? std::stoul(argv[4]) : 1;
  std::filesystem::create_directories(folder);
  std::vector<std::string> names = damaged_files::write_shapes(folder);
  for(const std::string& name : installed_files())
    names.push_back(name);
  std::vector<Whole_file> files;
  for(const std::string& name : names) {
    const damaged_files::Run run(program, name, folder + "/whole.json");
    if(run.status == 0)
      files.push_back({name, run.numbers["faces"]});
  }
  std::cout << files.size() << " files of " << names.size() << " are meshed while they are whole\n";
  std::size_t number_of_faults = 0;
  std::vector<std::size_t> statuses(3);
  for(unsigned long i = 0; i < number; ++i) {
    std::mt19937 random(static_cast<unsigned int>(seed + i)); // so that each file can be made alone
    const Whole_file& whole = files[i % files.size()];
    std::string content = damaged_files::content(whole.name);
    damaged_files::Damage(random, content)();
    const std::string file = folder + "/damaged_" + std::to_string(i) + std::filesystem::path(whole.name).extension().string();
    damaged_files::write(file, content);
    const damaged_files::Run run(program, file, folder + "/damaged.json");
    const std::string fault = run.fault(whole.number_of_faces);
    if(run.status >= 0 && run.status <= 2)
      ++statuses[std::size_t(run.status)];
    if(fault.empty())
      std::filesystem::remove(file);
    else {
      ++number_of_faults;
      std::cout << file << ", made of " << whole.name << ": " << fault << std::endl;
    }
  }
  std::cout << number << " damaged files: exit status 0 for " << statuses[0] << ", 1 for " << statuses[1] << ", 2 for " << statuses[2]
            << "; " << number_of_faults << " faults\n";
  return number_of_faults == 0 ? 0 : 1;
}
