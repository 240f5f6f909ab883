// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hydroscope {

/// The parameters of a request, read strictly. Every error is an InputError that names the parameter, its
/// value and what is allowed.
class Query {
 public:
  Query() = default;
  /// What follows the question mark of an address. Throws for broken escapes, control characters and a
  /// parameter that is given twice.
  static Query parse(std::string_view text);

  /// Throws for parameters that are not among `names`, with the nearest of them.
  void allow(const std::vector<std::string>& names) const;

  bool has(const std::string& name) const { return values_.count(name) > 0; }
  std::string text(const std::string& name, const std::string& standard = "") const;
  /// Must be there, and not empty.
  std::string need(const std::string& name) const;
  /// Must be there: 1 to 64 letters, digits, `-` and `_`.
  std::string need_id(const std::string& name) const;

  double number(const std::string& name, double low, double high, double standard) const;
  std::optional<double> number(const std::string& name, double low, double high) const;
  int whole(const std::string& name, int low, int high, int standard) const;
  /// "0" or "1".
  bool flag(const std::string& name, bool standard) const;
  /// One of `choices`.
  std::string choice(const std::string& name, const std::vector<std::string>& choices,
                     const std::string& standard) const;
  /// "1,2,3": at most `most` of them, each from `low` to `high`. Empty: none.
  std::vector<int> whole_list(const std::string& name, std::size_t most, int low, int high) const;

 private:
  std::map<std::string, std::string> values_;
};

/// The bytes that a %-escaped text stands for; `plus_is_space` as in forms. Throws InputError for broken
/// escapes and for control characters.
std::string decode_url(std::string_view text, bool plus_is_space);

/// Throws InputError naming `name`; the whole of `text` must be the number.
int parse_whole(const std::string& name, const std::string& text, int low, int high);

}  // namespace hydroscope
