// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/study_entry.h"

#include <algorithm>
#include <cmath>

#include "solver/base/error.h"
#include "solver/scene/key_suggestion.h"
#include "solver/scene/number_text.h"

namespace hydroscope {
namespace {

std::string quote(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += (c == '"' || c == '\\') ? std::string("\\") + c : std::string(1, c);
  return quoted + "\"";
}

bool read_number(const SourceValue& value, double& number) {
  if (const auto* real = std::get_if<double>(&value.value)) number = *real;
  if (const auto* whole = std::get_if<std::int64_t>(&value.value)) number = static_cast<double>(*whole);
  return (std::holds_alternative<double>(value.value) || std::holds_alternative<std::int64_t>(value.value)) &&
         std::isfinite(number);
}

std::string list_names(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

std::string write_toml(const SourceValue& value) {
  if (const auto* flag = std::get_if<bool>(&value.value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value.value)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&value.value)) {
    const std::string text = format_exact(*real);
    // A real number stays one when it is read again.
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
  }
  if (const auto* text = std::get_if<std::string>(&value.value)) return quote(*text);
  if (const auto* list = std::get_if<SourceValue::List>(&value.value)) {
    std::string items;
    for (const SourceValue& item : *list) items += (items.empty() ? "" : ", ") + write_toml(item);
    return "[" + items + "]";
  }
  return std::get<SourceValue::Other>(value.value).what;
}

void StudyEntry::fail(const std::string& expected) const {
  throw InputError(where() + ": key '" + key() + "': " + write_toml(entry_.value) + ": " + expected +
                   " expected");
}

std::string StudyEntry::text() const {
  const auto* text = std::get_if<std::string>(&entry_.value.value);
  if (text == nullptr) fail("a text in quotes");
  return *text;
}

std::string StudyEntry::one_of(const std::vector<std::string>& choices) const {
  const std::string given = text();
  if (std::find(choices.begin(), choices.end(), given) == choices.end())
    fail_unknown(where(), "key '" + key() + "'", given, choices);
  return given;
}

bool StudyEntry::flag() const {
  const auto* flag = std::get_if<bool>(&entry_.value.value);
  if (flag == nullptr) fail("true or false");
  return *flag;
}

double StudyEntry::number(double low, double high) const {
  double number = 0.0;
  if (!read_number(entry_.value, number) || number < low || number > high)
    fail("a number from " + format_exact(low) + " to " + format_exact(high));
  return number;
}

int StudyEntry::whole_number(int low, int high) const {
  const auto* whole = std::get_if<std::int64_t>(&entry_.value.value);
  if (whole == nullptr || *whole < low || *whole > high)
    fail("a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  return static_cast<int>(*whole);
}

std::vector<double> StudyEntry::numbers() const {
  double number = 0.0;
  if (read_number(entry_.value, number)) return {number};
  const auto* list = std::get_if<SourceValue::List>(&entry_.value.value);
  if (list == nullptr || list->empty()) fail("a number or a list of numbers");
  std::vector<double> numbers;
  for (const SourceValue& item : *list) {
    if (!read_number(item, number)) fail("a number or a list of numbers");
    numbers.push_back(number);
  }
  return numbers;
}

std::vector<std::string> StudyEntry::texts() const {
  if (const auto* text = std::get_if<std::string>(&entry_.value.value)) return {*text};
  const auto* list = std::get_if<SourceValue::List>(&entry_.value.value);
  if (list == nullptr) fail("a text or a list of texts");
  std::vector<std::string> texts;
  for (const SourceValue& item : *list) {
    const auto* text = std::get_if<std::string>(&item.value);
    if (text == nullptr) fail("a text or a list of texts");
    texts.push_back(*text);
  }
  return texts;
}

const SourceValue::List& StudyEntry::list() const {
  const auto* list = std::get_if<SourceValue::List>(&entry_.value.value);
  if (list == nullptr || list->empty()) fail("a list");
  return *list;
}

void fail_unknown(const std::string& where, const std::string& what, const std::string& given,
                  const std::vector<std::string>& known) {
  const std::string nearest = find_nearest_name(given, known);
  throw InputError(where + ": " + what + ": '" + given + "' is unknown; " +
                   (known.empty() ? "there is none" : "one of " + list_names(known) + " expected") +
                   (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

}  // namespace hydroscope
