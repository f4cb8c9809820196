// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes random patches from any seed on, audits each mesh, and prints a line for each patch that breaks an invariant. The
// program ends with 1 if there is one, and with 2 at once if one takes too long or crashes.
#include <check_fuzz_case.h>
#include <make_fuzz_case.h>

#include <CGAL/boost/graph/IO/OFF.h>

#include <boost/program_options.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>

namespace {

struct Options
{
  std::uint64_t seed = 1, number = 1000;
  std::uint64_t only = 0;
  bool is_only = false, is_verbose = false;
  unsigned int threads = 1, seconds = 120;
};

std::atomic<std::uint64_t> current_seed{0};

[[noreturn]] void end_at_once(const char* what)
{
  std::printf("%llu: %s\n", static_cast<unsigned long long>(current_seed.load()), what);
  std::fflush(stdout);
  std::_Exit(2);
}

void on_signal(int) { end_at_once("crash"); }

// Ends the program if the same patch is in work for too long.
void watch(unsigned int seconds)
{
  std::thread([seconds] {
    std::uint64_t seed = current_seed;
    for(unsigned int n = 0;; ++n) {
      std::this_thread::sleep_for(std::chrono::seconds(1));
      if(seed != current_seed) {
        seed = current_seed;
        n = 0;
      } else if(n >= seconds)
        end_at_once("takes too long");
    }
  }).detach();
}

Options read_options(int argc, char** argv)
{
  namespace po = boost::program_options;
  Options options;
  po::options_description description("fuzz_patches: meshes random patches and audits the meshes");
  description.add_options()
    ("help", "this text")
    ("seed", po::value(&options.seed)->default_value(1), "the first seed")
    ("number", po::value(&options.number)->default_value(1000), "how many patches")
    ("only", po::value(&options.only), "one seed: prints what is meshed and writes the mesh to fuzz_SEED.off")
    ("threads", po::value(&options.threads)->default_value(1), "the number of threads, if there is oneTBB")
    ("seconds", po::value(&options.seconds)->default_value(120), "how long one patch may take")
    ("verbose", po::bool_switch(&options.is_verbose), "print each patch");
  po::variables_map map;
  po::store(po::parse_command_line(argc, argv, description), map);
  po::notify(map);
  if(map.count("help") > 0) {
    std::cout << description;
    std::exit(EXIT_SUCCESS);
  }
  options.is_only = map.count("only") > 0;
  if(options.is_only) {
    options.seed = options.only;
    options.number = 1;
  }
  return options;
}

struct Totals
{
  std::uint64_t meshed = 0, refused = 0, broken = 0, triangles = 0;
};

void check(std::uint64_t seed, const Options& options, Totals& totals)
{
  current_seed = seed;
  const Fuzz_case fuzz_case = make_fuzz_case(seed);
  if(options.is_only || options.is_verbose)
    std::cout << seed << " is " << fuzz_case.description << std::endl;
  Fuzz_check check(fuzz_case);
  const Audit_findings& findings = check();
  for(const std::string& text : findings.texts())
    std::cout << seed << ": " << text << std::endl;
  totals.broken += !findings.empty();
  totals.refused += !check.refusal().empty();
  totals.meshed += check.result().mesh.number_of_faces() > 0;
  totals.triangles += check.result().mesh.number_of_faces();
  if(options.is_only) {
    std::cout << (check.refusal().empty() ? "meshed" : "refused: " + check.refusal()) << std::endl;
    std::ofstream file("fuzz_" + std::to_string(seed) + ".off");
    file.precision(17);
    CGAL::IO::write_OFF(file, check.result().mesh);
  }
}

} // namespace

int main(int argc, char** argv)
{
  try {
    const Options options = read_options(argc, argv);
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, options.threads);
#endif
    for(const int signal : {SIGSEGV, SIGFPE, SIGABRT, SIGILL})
      std::signal(signal, on_signal);
    watch(options.seconds);
    Totals totals;
    for(std::uint64_t i = 0; i < options.number; ++i)
      check(options.seed + i, options, totals);
    std::cout << options.number << " patches, " << totals.meshed << " meshed with " << totals.triangles << " triangles, "
              << totals.refused << " refused, " << totals.broken << " broken" << std::endl;
    return totals.broken > 0 ? 1 : 0;
  } catch(const std::exception& error) {
    std::cerr << current_seed << ": " << error.what() << '\n';
    return 2;
  }
}
