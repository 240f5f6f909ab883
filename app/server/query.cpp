// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/query.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "solver/base/error.h"
#include "solver/scene/key_suggestion.h"

namespace hydroscope {
namespace {

/// Values may be long and may hold anything: only their start is quoted.
std::string quote(const std::string& text) {
  constexpr std::size_t kMost = 60;
  return "'" + (text.size() <= kMost ? text : text.substr(0, kMost) + "...") + "'";
}

[[noreturn]] void fail(const std::string& name, const std::string& text, const std::string& what) {
  throw InputError("parameter " + quote(name) + ": " + quote(text) + " " + what);
}

std::string format(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

double parse_real(const std::string& name, const std::string& text, double low, double high) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || at != end || !std::isfinite(value)) fail(name, text, "is not a number");
  if (value < low || value > high)
    fail(name, text, "is out of range; allowed: " + format(low) + " to " + format(high));
  return value;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

}  // namespace

std::string decode_url(std::string_view text, bool plus_is_space) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (c == '+' && plus_is_space) c = ' ';
    if (text[i] == '%') {
      const int high = i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
      const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
      if (high < 0 || low < 0) throw InputError("the address holds a broken %-escape");
      c = static_cast<char>(16 * high + low);
      i += 2;
    }
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      throw InputError("the address holds a control character");
    plain += c;
  }
  return plain;
}

int parse_whole(const std::string& name, const std::string& text, int low, int high) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::invalid_argument || at != end) fail(name, text, "is not a whole number");
  if (error != std::errc{} || value < low || value > high)
    fail(name, text, "is out of range; allowed: " + std::to_string(low) + " to " + std::to_string(high));
  return value;
}

Query Query::parse(std::string_view text) {
  Query query;
  while (!text.empty()) {
    const std::string_view pair = text.substr(0, text.find('&'));
    text.remove_prefix(std::min(pair.size() + 1, text.size()));
    if (pair.empty()) continue;
    const std::size_t equal = std::min(pair.find('='), pair.size());
    const std::string name = decode_url(pair.substr(0, equal), true);
    const std::string value = equal < pair.size() ? decode_url(pair.substr(equal + 1), true) : std::string();
    if (!query.values_.emplace(name, value).second)
      throw InputError("parameter " + quote(name) + " is given twice");
  }
  return query;
}

void Query::allow(const std::vector<std::string>& names) const {
  for (const auto& [name, value] : values_) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string nearest = find_nearest_name(name, names);
    throw InputError("unknown parameter " + quote(name) +
                     (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
  }
}

std::string Query::text(const std::string& name, const std::string& standard) const {
  const auto found = values_.find(name);
  return found == values_.end() ? standard : found->second;
}

std::string Query::need(const std::string& name) const {
  const std::string value = text(name);
  if (value.empty()) throw InputError("parameter '" + name + "' is missing");
  return value;
}

std::string Query::need_id(const std::string& name) const {
  const std::string id = need(name);
  const bool is_plain = std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
  });
  if (!is_plain || id.size() > 64) fail(name, id, "is not allowed; 1 to 64 letters, digits, '-' and '_'");
  return id;
}

double Query::number(const std::string& name, double low, double high, double standard) const {
  return number(name, low, high).value_or(standard);
}

std::optional<double> Query::number(const std::string& name, double low, double high) const {
  if (!has(name)) return std::nullopt;
  return parse_real(name, text(name), low, high);
}

int Query::whole(const std::string& name, int low, int high, int standard) const {
  return has(name) ? parse_whole(name, text(name), low, high) : standard;
}

bool Query::flag(const std::string& name, bool standard) const {
  return choice(name, {"0", "1"}, standard ? "1" : "0") == "1";
}

std::string Query::choice(const std::string& name, const std::vector<std::string>& choices,
                          const std::string& standard) const {
  if (!has(name)) return standard;
  const std::string value = text(name);
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return value;
  std::string list;
  for (const std::string& word : choices) list += (list.empty() ? "" : ", ") + word;
  fail(name, value, "is not allowed; one of: " + list);
}

std::vector<int> Query::whole_list(const std::string& name, std::size_t most, int low, int high) const {
  std::vector<int> numbers;
  std::string rest = text(name);
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    if (numbers.size() == most) fail(name, text(name), "is too long; at most " + std::to_string(most));
    numbers.push_back(parse_whole(name, rest.substr(0, comma), low, high));
    if (comma + 1 == rest.size()) fail(name, text(name), "ends with a comma");
    rest.erase(0, comma + 1);
  }
  return numbers;
}

}  // namespace hydroscope
