// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/history_table.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "app/chart/study_entry.h"
#include "app/inspect/csv_table.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

double read_cell(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' ? number : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

HistoryTable::HistoryTable(const std::filesystem::path& file) : file_(file.string()) {
  const std::string text = read_whole_file(file);
  const CsvTable table = CsvTable::parse(text, file_);
  std::istringstream head(text.substr(0, text.find_first_of("\r\n")));
  for (std::string name; std::getline(head, name, ',');) {
    std::erase(name, '"');
    names_.push_back(name);
  }
  columns_.resize(names_.size());
  for (std::size_t row = 0; row < table.rows(); ++row)
    for (std::size_t i = 0; i < names_.size(); ++i) columns_[i].push_back(read_cell(table.text(row, i)));
}

bool HistoryTable::has(const std::string& name) const {
  return std::find(names_.begin(), names_.end(), name) != names_.end();
}

const std::vector<double>& HistoryTable::column(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) fail_unknown(file_, "column", name, names_);
  return columns_[static_cast<std::size_t>(found - names_.begin())];
}

std::optional<double> HistoryTable::find_at(const std::string& name, const std::string& driver,
                                            double value) const {
  const std::vector<double>&x = column(driver), &y = column(name);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] == value && std::isfinite(y[i])) return y[i];
    if (i == 0 || !((x[i - 1] < value && value < x[i]) || (x[i] < value && value < x[i - 1]))) continue;
    const double between = y[i - 1] + (value - x[i - 1]) / (x[i] - x[i - 1]) * (y[i] - y[i - 1]);
    if (std::isfinite(between)) return between;
  }
  return std::nullopt;
}

}  // namespace hydroscope
