// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/figure_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace hydroscope {
namespace {

bool is_numeric(const std::string& cell) {
  return cell == "far" || cell.find_first_not_of("0123456789.+-e") == std::string::npos;
}

struct Column {
  std::size_t width = 0;
  bool is_right = true;
};

}  // namespace

std::string format_figure(double number) {
  if (std::isnan(number)) return "-";
  if (std::isinf(number)) return "far";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", number);
  return text.data();
}

std::string format_columns(const std::vector<std::vector<std::string>>& lines) {
  std::vector<Column> columns;
  for (std::size_t row = 0; row < lines.size(); ++row) {
    columns.resize(std::max(columns.size(), lines[row].size()));
    for (std::size_t i = 0; i < lines[row].size(); ++i) {
      columns[i].width = std::max(columns[i].width, lines[row][i].size());
      if (row > 0 && !is_numeric(lines[row][i])) columns[i].is_right = false;
    }
  }
  std::string text;
  for (const auto& line : lines) {
    std::string shown;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string padding(columns[i].width - line[i].size(), ' ');
      shown += (i > 0 ? "  " : "") + (columns[i].is_right ? padding + line[i] : line[i] + padding);
    }
    shown.erase(shown.find_last_not_of(' ') + 1);
    text += shown + "\n";
  }
  return text;
}

}  // namespace hydroscope
