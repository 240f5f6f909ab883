// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene_source.h"

namespace hydroscope {

/// One `key = value` of a study with typed access; every fault is an InputError that names
/// place, key, value and what is expected.
class StudyEntry {
 public:
  explicit StudyEntry(const SourceEntry& entry) : entry_(entry) {}

  const std::string& where() const { return entry_.where; }
  const std::string& key() const { return entry_.path.back(); }

  std::string text() const;
  std::string one_of(const std::vector<std::string>& choices) const;
  bool flag() const;
  double number(double low, double high) const;
  int whole_number(int low, int high) const;
  std::vector<double> numbers() const;     ///< one number, or a list
  std::vector<std::string> texts() const;  ///< one text, or a list
  const SourceValue::List& list() const;

  [[noreturn]] void fail(const std::string& expected) const;

 private:
  const SourceEntry& entry_;
};

/// The value as TOML.
std::string write_toml(const SourceValue& value);

/// Throws InputError for a name that `known` does not hold, with the nearest one that it does.
[[noreturn]] void fail_unknown(const std::string& where, const std::string& what, const std::string& given,
                               const std::vector<std::string>& known);

}  // namespace hydroscope
