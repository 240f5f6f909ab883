// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hydroscope {

/// Writes one JSON object, a key a line, in the order of the calls.
class JsonText {
 public:
  void add(const std::string& key, const std::string& text) { add_raw(key, quoted(text)); }
  void add(const std::string& key, const char* text) { add_raw(key, quoted(text)); }
  void add(const std::string& key, double number) { add_raw(key, written(number)); }
  void add(const std::string& key, int number) { add_raw(key, std::to_string(number)); }
  void add(const std::string& key, bool is_true) { add_raw(key, is_true ? "true" : "false"); }
  void add(const std::string& key, const std::vector<double>& numbers);
  void add(const std::string& key, const JsonText& object);
  std::string text() const { return "{\n" + body_ + "\n}\n"; }

 private:
  static std::string quoted(const std::string& text);
  static std::string written(double number);  ///< shortest that reads back; not a number: null
  void add_raw(const std::string& key, const std::string& value);

  std::string body_;
};

}  // namespace hydroscope
