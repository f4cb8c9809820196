// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program from outside: command lines, exit statuses and files.
#ifndef PROGRAM_TEST_H
#define PROGRAM_TEST_H

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

// Whether a command of a shell succeeds, as one that asks for a program or a module does.
inline bool succeeds(const std::string& command) { return std::system((command + " > /dev/null 2>&1").c_str()) == 0; }

inline std::string content(const std::filesystem::path& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// A directory of its own for each test, which goes away with it.
class Program_test : public testing::Test
{
protected:
  struct Result
  {
    int status;
    std::string out, err;
  };

  std::string program;
  std::filesystem::path directory;

  explicit Program_test(const std::string& p) : program(p) {}

  void SetUp() override
  {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    directory = std::filesystem::temp_directory_path() / ("program_" + test + "_" + std::to_string(getpid()));
    std::filesystem::create_directories(directory / "files");
  }

  void TearDown() override { std::filesystem::remove_all(directory); }

  std::string file(const std::string& name) const { return (directory / "files" / name).string(); }

  // runs the program in the directory "files", with arguments as in a shell
  Result run(const std::string& arguments) const
  {
    return {status(arguments, "../err"), content(directory / "out"), content(directory / "err")};
  }

  // The same with a terminal as standard error output. What is written there must fit into its buffer: some kilobytes.
  Result run_on_terminal(const std::string& arguments) const
  {
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    EXPECT_GE(terminal, 0);
    EXPECT_EQ(grantpt(terminal), 0);
    EXPECT_EQ(unlockpt(terminal), 0);
    const int kept_open = open(ptsname(terminal), O_RDWR | O_NOCTTY); // else what was written is lost when the program ends
    Result result{status(arguments, ptsname(terminal)), content(directory / "out"), ""};
    EXPECT_EQ(fcntl(terminal, F_SETFL, O_NONBLOCK), 0);
    std::array<char, 4096> buffer;
    for(ssize_t n; (n = read(terminal, buffer.data(), buffer.size())) > 0;)
      result.err.append(buffer.data(), std::size_t(n));
    close(kept_open);
    close(terminal);
    return result;
  }

  std::size_t number_of_files() const
  {
    return std::distance(std::filesystem::directory_iterator(directory / "files"), std::filesystem::directory_iterator());
  }

  nlohmann::json json(const std::string& arguments) const
  {
    const Result result = run(arguments + " --json result.json");
    EXPECT_EQ(result.status, 0) << arguments << "\n" << result.err;
    return nlohmann::json::parse(content(file("result.json")));
  }

#ifdef CGAL_PARAMETRIC_SURFACE_MESHER_USE_PAGE
  // What the page contains that --page writes.
  nlohmann::json data_of_page(const std::string& arguments) const
  {
    const Result result = run(arguments + " --quiet --page page.html");
    EXPECT_EQ(result.status, 0) << arguments << "\n" << result.err;
    const std::string page = content(file("page.html")), begin = "<script id=\"mesh\" type=\"application/json\">";
    const std::size_t first = page.find(begin) + begin.size();
    EXPECT_EQ(page.find("=\"http"), std::string::npos) << "it needs a network";
    return nlohmann::json::parse(page.substr(first, page.find("</script>", first) - first));
  }
#endif

  // One line on stderr that contains `hint`, status 2, nothing on stdout, no file.
  void expect_refused(const std::string& arguments, const std::string& hint) const
  {
    const std::size_t before = number_of_files();
    const Result result = run(arguments);
    EXPECT_EQ(result.status, 2) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << arguments << "\n" << result.err;
    EXPECT_NE(result.err.find(hint), std::string::npos) << arguments << "\n" << result.err;
    EXPECT_EQ(number_of_files(), before) << arguments;
  }

private:
  int status(const std::string& arguments, const std::string& err) const
  {
    const std::string command = "cd '" + (directory / "files").string() + "' && '" + program + "' " + arguments + " > ../out 2> '"
                                + err + "'";
    const int result = std::system(command.c_str());
    return WIFEXITED(result) ? WEXITSTATUS(result) : -1;
  }
};

#endif // PROGRAM_TEST_H
