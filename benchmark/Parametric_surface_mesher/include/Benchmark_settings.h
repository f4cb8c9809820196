// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command line that the benchmark programs have in common.
#ifndef BENCHMARK_SETTINGS_H
#define BENCHMARK_SETTINGS_H

#include "Text_table.h"

#include <boost/program_options.hpp>

#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

class Benchmark_settings
{
  std::string m_usage, m_unit;
  boost::program_options::options_description m_options;

public:
  std::vector<double> sizes; // numbers of triangles, or of another unit
  std::size_t repeat = 3;
  Text_table::Format format = Text_table::PLAIN;

  // `usage` comes before the options in the help text; of several timings the `statistic` counts
  Benchmark_settings(std::string usage, std::vector<double> default_sizes, std::string unit = "triangles",
                     const std::string& statistic = "median")
    : m_usage(std::move(usage)), m_unit(std::move(unit)), m_options("Options"), sizes(std::move(default_sizes))
  {
    using boost::program_options::value;
    std::string default_text;
    for(const double size : sizes)
      default_text += (default_text.empty() ? "" : " ") + text("%.0f", size);
    m_options.add_options()
      ("help", "shows this text")
      ("sizes", value(&sizes)->multitoken()->default_value(sizes, default_text),
       ("numbers of " + m_unit).c_str())
      ("repeat", value(&repeat)->default_value(repeat), ("number of timings, of which the " + statistic + " counts").c_str())
      ("markdown", "prints a Markdown table");
  }

  // to add options of one program
  boost::program_options::options_description& options() { return m_options; }

  // Returns whether there is something to be done. Throws std::exception if a value is unusable.
  bool read(int argc, char** argv)
  {
    namespace po = boost::program_options;
    po::positional_options_description positional;
    positional.add("sizes", -1);
    po::variables_map values;
    po::store(po::command_line_parser(argc, argv).options(m_options).positional(positional).run(), values);
    po::notify(values);
    if(values.count("help"))
      std::cout << m_usage << m_options;
    if(repeat == 0)
      throw std::invalid_argument("--repeat must be positive");
    for(const double size : sizes)
      if(!(size >= 1 && std::isfinite(size)))
        throw std::invalid_argument("a size must be a number of " + m_unit);
    format = values.count("markdown") ? Text_table::MARKDOWN : Text_table::PLAIN;
    return values.count("help") == 0;
  }
};

// The body of main(): `run` returns the table to be printed.
template <class Settings, class Run>
int run_benchmark(int argc, char** argv, Settings& settings, const Run& run)
{
  try {
    if(settings.read(argc, argv))
      run().print(std::cout, settings.format);
  } catch(const std::exception& e) {
    std::cerr << argv[0] << ": " << e.what() << "\n";
    return 2;
  }
  return 0;
}

#endif // BENCHMARK_SETTINGS_H
