// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/grid_file.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "solver/base/error.h"
#include "solver/import/mesh_file.h"

namespace hydroscope {

namespace {

constexpr double kMostPoints = 2e7;

/// The words of a text, one after the other, with the line each stands in.
class Words {
 public:
  explicit Words(const std::string& text) : text_(text) {}

  /// Empty at the end.
  std::string_view next() {
    while (at_ < text_.size() && is_between(text_[at_])) {
      if (text_[at_] == '#') {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
      } else {
        line_ += text_[at_++] == '\n' ? 1 : 0;
      }
    }
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_between(text_[at_])) ++at_;
    return std::string_view(text_).substr(start, at_ - start);
  }
  std::size_t line() const { return line_; }

 private:
  static bool is_between(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',' || c == ';' || c == '#';
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

class GridReader {
 public:
  GridReader(const std::string& path, const std::string& text) : path_(path), words_(text) {}

  HeightField read(double unit_scale) {
    if (words_.next() != "hydroscope-grid") fail("a grid file begins with \"hydroscope-grid 1\"");
    if (words_.next() != "1") fail("unknown version, expected \"hydroscope-grid 1\"");
    HeightField field;
    bool has_origin = false, has_pitch = false;
    for (std::string_view word = words_.next(); word != "heights"; word = words_.next()) {
      if (word == "columns") {
        field.columns = read_count();
      } else if (word == "rows") {
        field.rows = read_count();
      } else if (word == "origin") {
        field.origin = unit_scale * read_pair();
        has_origin = true;
      } else if (word == "pitch") {
        field.pitch = unit_scale * read_pair();
        has_pitch = true;
      } else {
        fail((word.empty() ? "the file ends" : "\"" + std::string(word) + "\"") +
             ", expected columns, rows, origin, pitch or heights");
      }
    }
    if (field.columns == 0 || field.rows == 0 || !has_origin || !has_pitch) {
      fail("columns, rows, origin and pitch must stand before heights");
    }
    read_heights(unit_scale, field);
    return field;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    refuse_mesh_file(path_, "line " + std::to_string(words_.line()) + ": " + what);
  }

  double read_number(std::string_view word) const {
    std::string_view digits = word;
    if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
    double value = 0.0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (code != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) {
      fail(word.empty() ? "a number is missing" : "\"" + std::string(word) + "\" is not a number");
    }
    return value;
  }

  int read_count() {
    const double value = read_number(words_.next());
    if (!(value >= 2.0 && value <= kMostPoints) || value != std::floor(value)) {
      fail("columns and rows are whole numbers from 2 on");
    }
    return static_cast<int>(value);
  }

  Vec2 read_pair() {
    const double x = read_number(words_.next());
    return {x, read_number(words_.next())};
  }

  void read_heights(double unit_scale, HeightField& field) {
    const double count = static_cast<double>(field.columns) * field.rows;
    if (count > kMostPoints) fail("more than 20 million points");
    for (double i = 0; i < count; ++i) {
      const std::string_view word = words_.next();
      if (word.empty()) {
        fail("the file ends after " + std::to_string(field.heights.size()) + " of " +
             std::to_string(static_cast<long>(count)) + " heights");
      }
      field.heights.push_back(word == "-" ? std::numeric_limits<double>::quiet_NaN()
                                          : unit_scale * read_number(word));
    }
    const std::string_view rest = words_.next();
    if (!rest.empty()) fail("\"" + std::string(rest) + "\" after the last height");
  }

  const std::string& path_;
  Words words_;
};

void append_number(double value, std::string& text) {
  char digits[32];
  const auto [end, code] = std::to_chars(digits, digits + sizeof digits, value);
  require(code == std::errc(), "a number longer than its room");
  text.append(digits, end);
}

}  // namespace

HeightField read_grid_file(const std::string& file, double unit_scale) {
  const std::string content = read_mesh_content(file);
  HeightField field = GridReader(file, content).read(unit_scale);
  check_height_field(field, file);
  return field;
}

std::string format_grid_file(const HeightField& field) {
  std::string text = "hydroscope-grid 1\ncolumns " + std::to_string(field.columns) + "\nrows " +
                     std::to_string(field.rows) + "\norigin ";
  const auto append_pair = [&](const Vec2& pair) {
    append_number(pair.x(), text);
    text += ' ';
    append_number(pair.y(), text);
  };
  append_pair(field.origin);
  text += "\npitch ";
  append_pair(field.pitch);
  text += "\nheights\n";
  for (int j = 0; j < field.rows; ++j) {
    for (int i = 0; i < field.columns; ++i) {
      if (i > 0) text += ' ';
      if (field.has_point(i, j)) {
        append_number(field.height(i, j), text);
      } else {
        text += '-';
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace hydroscope
