// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// mesh_cad bears files that are damaged at random. `damaged_cad_files` in the benchmarks does the same with more files.
#include <Damaged_files.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <unistd.h>

TEST(Damaged_files, are_borne)
{
  const int number_of_files = 150;
  const std::string program = std::string("'") + MESH_CAD_PROGRAM + "' --gamma 0.5 --relative-distance 0.02"; // quick
  const std::string folder = (std::filesystem::temp_directory_path() / ("damaged_" + std::to_string(getpid()))).string();
  std::filesystem::create_directories(folder);
  std::vector<std::string> files = damaged_files::write_shapes(folder);
  // Reading of a damaged BREP file may take all the time that it has.
  files.erase(std::remove_if(files.begin() + 3, files.end(),
                             [](const std::string& file) { return std::filesystem::path(file).extension() == ".brep"; }),
              files.end());
  std::vector<std::size_t> numbers_of_faces;
  for(const std::string& file : files) {
    const damaged_files::Run run(program, file, folder + "/whole.json");
    ASSERT_EQ(0, run.status) << file;
    numbers_of_faces.push_back(run.numbers["faces"]);
  }
  std::mt19937 random(1);
  for(int i = 0; i < number_of_files; ++i) {
    const std::size_t k = i % files.size();
    std::string content = damaged_files::content(files[k]);
    damaged_files::Damage(random, content)();
    const std::string file = folder + "/damaged" + std::filesystem::path(files[k]).extension().string();
    damaged_files::write(file, content);
    EXPECT_EQ("", damaged_files::Run(program, file, folder + "/damaged.json").fault(numbers_of_faces[k]))
      << "file " << i << ", made of " << files[k];
  }
  std::filesystem::remove_all(folder);
}
