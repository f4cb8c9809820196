// This file is part of Parametric_surface_mesher, an extension package of CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TEXT_TABLE_H
#define TEXT_TABLE_H

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

// A table of texts, whose columns are aligned: the first to the left, the others, which hold numbers, to the right.
class Text_table
{
public:
  typedef std::vector<std::string> Line;
  enum Format { PLAIN, MARKDOWN };

private:
  std::vector<Line> m_lines; // the first one holds the titles

public:
  explicit Text_table(Line titles) { m_lines.push_back(std::move(titles)); }

  // \pre `line` has as many texts as there are titles
  void add_line(Line line) { m_lines.push_back(std::move(line)); }

  const std::vector<Line>& lines() const { return m_lines; }

  void print(std::ostream& out, Format format) const
  {
    const std::vector<std::size_t> widths = column_widths();
    for(std::size_t i = 0; i < m_lines.size(); ++i) {
      print(out, format, m_lines[i], widths);
      if(i == 0 && format == MARKDOWN)
        print_rule(out, widths);
    }
  }

private:
  std::vector<std::size_t> column_widths() const
  {
    std::vector<std::size_t> widths(m_lines.front().size(), 3);
    for(const Line& line : m_lines)
      for(std::size_t i = 0; i < line.size(); ++i)
        widths[i] = (std::max)(widths[i], line[i].size());
    return widths;
  }

  static void print(std::ostream& out, Format format, const Line& line, const std::vector<std::size_t>& widths)
  {
    out << (format == MARKDOWN ? "| " : "");
    for(std::size_t i = 0; i < line.size(); ++i) {
      const std::string space(widths[i] - line[i].size(), ' ');
      out << (i == 0 ? line[i] + space : (format == MARKDOWN ? " | " : "  ") + space + line[i]);
    }
    out << (format == MARKDOWN ? " |\n" : "\n");
  }

  static void print_rule(std::ostream& out, const std::vector<std::size_t>& widths)
  {
    for(std::size_t i = 0; i < widths.size(); ++i)
      out << (i == 0 ? "| " + std::string(widths[i], '-') : " | " + std::string(widths[i] - 1, '-') + ":");
    out << " |\n";
  }
};

// `value` in the format of std::printf()
inline std::string text(const char* format, double value)
{
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

#endif // TEXT_TABLE_H
