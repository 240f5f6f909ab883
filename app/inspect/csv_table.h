// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace hydroscope {

/// A table of text with one head line, as history.csv and events.csv are. Every
/// error is an InputError that names file and line.
class CsvTable {
 public:
  /// Lines end with a newline, cells may be quoted; every row has as many cells as the head.
  static CsvTable parse(const std::string& text, const std::string& file);
  static CsvTable read(const std::filesystem::path& file);

  std::size_t rows() const { return rows_.size(); }
  const std::string& file() const { return file_; }
  int line(std::size_t row) const { return lines_[row]; }

  /// Column by its name in the head.
  std::size_t column(const std::string& name) const;
  /// The same, none when the head does not have it: newer columns.
  std::optional<std::size_t> find_column(const std::string& name) const;
  const std::string& text(std::size_t row, std::size_t column) const { return rows_[row][column]; }
  double number(std::size_t row, std::size_t column) const;
  int whole_number(std::size_t row, std::size_t column) const;

  [[noreturn]] void fail(std::size_t row, const std::string& what) const;

 private:
  std::string file_;
  std::vector<std::string> head_;
  std::vector<std::vector<std::string>> rows_;
  std::vector<int> lines_;
};

}  // namespace hydroscope
