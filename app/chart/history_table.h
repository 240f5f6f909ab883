// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hydroscope {

/// Numbers of a CSV file by column; a cell that is no number becomes nan.
class HistoryTable {
 public:
  /// Throws InputError when the file is missing or broken.
  explicit HistoryTable(const std::filesystem::path& file);
  HistoryTable(std::vector<std::string> names, std::vector<std::vector<double>> columns)
      : names_(std::move(names)), columns_(std::move(columns)) {}

  std::size_t rows() const { return columns_.empty() ? 0 : columns_.front().size(); }
  bool has(const std::string& name) const;
  const std::vector<std::string>& names() const { return names_; }
  /// Throws InputError that names the nearest column.
  const std::vector<double>& column(const std::string& name) const;

  /// `column` where `driver` first passes `value`, linear between rows; nothing when it never does.
  std::optional<double> find_at(const std::string& column, const std::string& driver, double value) const;

 private:
  std::string file_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace hydroscope
