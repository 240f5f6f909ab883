// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

[[noreturn]] void fail_at(const std::string& file, int line, const std::string& what) {
  throw InputError(file + ":" + std::to_string(line) + ": " + what);
}

/// One record from `position`, which moves behind its newline; `line` counts newlines.
std::vector<std::string> take_record(const std::string& text, const std::string& file, std::size_t& position,
                                     int& line) {
  const int first_line = line;
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  while (position < text.size()) {
    const char c = text[position++];
    if (c == '\n') ++line;
    if (c == '"') {
      const bool is_doubled = is_quoted && position < text.size() && text[position] == '"';
      if (is_doubled) cells.back() += text[position++];
      if (!is_doubled) is_quoted = !is_quoted;
    } else if (c == '\n' && !is_quoted) {
      return cells;
    } else if (c == ',' && !is_quoted) {
      cells.emplace_back();
    } else if (c != '\r' || is_quoted) {
      cells.back() += c;
    }
  }
  fail_at(file, first_line, is_quoted ? "a quoted cell does not end" : "the line is cut off");
}

template <class Number>
bool parse_whole(const std::string& text, Number& number) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end;
}

}  // namespace

CsvTable CsvTable::parse(const std::string& text, const std::string& file) {
  CsvTable table;
  table.file_ = file;
  std::size_t position = 0;
  int line = 1;
  if (text.empty()) fail_at(file, 1, "the head line is missing");
  table.head_ = take_record(text, file, position, line);
  while (position < text.size()) {
    const int start = line;
    table.rows_.push_back(take_record(text, file, position, line));
    table.lines_.push_back(start);
    if (table.rows_.back().size() != table.head_.size())
      fail_at(file, start,
              std::to_string(table.rows_.back().size()) + " cells instead of " +
                  std::to_string(table.head_.size()));
  }
  return table;
}

CsvTable CsvTable::read(const std::filesystem::path& file) {
  return parse(read_whole_file(file), file.string());
}

std::optional<std::size_t> CsvTable::find_column(const std::string& name) const {
  const auto found = std::find(head_.begin(), head_.end(), name);
  if (found == head_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - head_.begin());
}

std::size_t CsvTable::column(const std::string& name) const {
  const auto found = find_column(name);
  if (!found) fail_at(file_, 1, "there is no column '" + name + "'");
  return *found;
}

double CsvTable::number(std::size_t row, std::size_t column) const {
  double number = 0.0;
  if (!parse_whole(text(row, column), number) || !std::isfinite(number))
    fail(row, head_[column] + " = '" + text(row, column) + "': a finite number expected");
  return number;
}

int CsvTable::whole_number(std::size_t row, std::size_t column) const {
  int number = 0;
  if (!parse_whole(text(row, column), number))
    fail(row, head_[column] + " = '" + text(row, column) + "': a whole number expected");
  return number;
}

void CsvTable::fail(std::size_t row, const std::string& what) const { fail_at(file_, lines_[row], what); }

}  // namespace hydroscope
