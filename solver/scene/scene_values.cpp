// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/scene_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/scene/key_suggestion.h"
#include "solver/scene/number_text.h"

namespace hydroscope {
namespace {

using Rows2 = std::vector<std::array<double, 2>>;
using Rows4 = std::vector<std::array<double, 4>>;

std::string quote(const std::string& text) { return "\"" + text + "\""; }

std::string join(const std::vector<std::string>& items, const std::string& between) {
  std::string joined;
  for (const std::string& item : items) joined += (joined.empty() ? "" : between) + item;
  return joined;
}

std::string check_range(double number, const KeyRange& range) {
  if (!std::isfinite(number)) return format_exact(number) + " is not a finite number";
  if (number >= range.low && number <= range.high) return {};
  return format_exact(number) + " is out of range; allowed: " + describe_range(range);
}

std::string check_choice(const std::string& text, const std::vector<std::string>& choices) {
  if (choices.empty()) return text.empty() ? "is empty" : std::string();
  if (std::find(choices.begin(), choices.end(), text) != choices.end()) return {};
  const std::string nearest = find_nearest_name(text, choices);
  std::vector<std::string> quoted;
  for (const std::string& choice : choices) quoted.push_back(quote(choice));
  return quote(text) + " is not known; " + (nearest.empty() ? "" : "did you mean " + quote(nearest) + "? ") +
         "allowed: " + join(quoted, ", ");
}

const double* as_number(const SourceValue& value, double& storage) {
  if (const auto* number = std::get_if<double>(&value.value))
    storage = *number;
  else if (const auto* integer = std::get_if<std::int64_t>(&value.value))
    storage = static_cast<double>(*integer);
  else
    return nullptr;
  return &storage;
}

/// Fills one slot; each overload returns what is wrong, or nothing.
struct Assign {
  const SourceValue& value;
  const SceneKey& key;
  const SceneSlot& slot;

  std::string wrong_type() const {
    return format_value(value) + " has the wrong type; expected " + describe_type(key, slot);
  }

  std::string read_number(const SourceValue& from, double& to) const {
    double number = 0.0;
    if (as_number(from, number) == nullptr) return wrong_type();
    to = number;
    return check_range(number, key.range);
  }

  std::string read_integer(const SourceValue& from, int& to) const {
    const auto* integer = std::get_if<std::int64_t>(&from.value);
    if (integer == nullptr) return wrong_type();
    const std::string fault = check_range(static_cast<double>(*integer), key.range);
    if (!fault.empty()) return fault;
    if (*integer > std::numeric_limits<int>::max() || *integer < std::numeric_limits<int>::min()) {
      return std::to_string(*integer) + " is too large";
    }
    to = static_cast<int>(*integer);
    return {};
  }

  template <class Number, size_t N>
  std::string read_fixed(std::array<Number, N>& to) const {
    const auto* list = std::get_if<SourceValue::List>(&value.value);
    if (list == nullptr || list->size() != N) return wrong_type();
    for (size_t i = 0; i < N; ++i) {
      std::string fault;
      if constexpr (std::is_same_v<Number, int>)
        fault = read_integer((*list)[i], to[i]);
      else
        fault = read_number((*list)[i], to[i]);
      if (!fault.empty()) return fault;
    }
    return {};
  }

  template <size_t N>
  std::string read_rows(std::vector<std::array<double, N>>& rows) const {
    const auto* list = std::get_if<SourceValue::List>(&value.value);
    if (list == nullptr) return wrong_type();
    if (list->empty()) return "is an empty list; expected " + describe_type(key, slot);
    rows.clear();
    for (const SourceValue& item : *list) {
      const auto* columns = std::get_if<SourceValue::List>(&item.value);
      if (columns == nullptr || columns->size() != N) {
        return "row " + format_value(item) + " does not fit; expected " + describe_type(key, slot);
      }
      std::array<double, N> row{};
      for (size_t i = 0; i < N; ++i) {
        if (as_number((*columns)[i], row[i]) == nullptr) return wrong_type();
        const std::string fault = check_range(row[i], i == 0 ? KeyRange{} : key.range);
        if (!fault.empty()) return "row " + format_value(item) + ": " + fault;
      }
      if (!rows.empty() && row[0] <= rows.back()[0]) {
        return "the first column must increase from row to row, but " + format_exact(row[0]) + " follows " +
               format_exact(rows.back()[0]);
      }
      rows.push_back(row);
    }
    return {};
  }

  std::string operator()(double* to) const { return read_number(value, *to); }
  std::string operator()(std::optional<double>* to) const {
    double number = 0.0;
    const std::string fault = read_number(value, number);
    if (fault.empty()) *to = number;
    return fault;
  }
  std::string operator()(int* to) const { return read_integer(value, *to); }
  std::string operator()(bool* to) const {
    const bool* flag = std::get_if<bool>(&value.value);
    if (flag == nullptr) return wrong_type();
    *to = *flag;
    return {};
  }
  std::string operator()(std::string* to) const {
    const auto* text = std::get_if<std::string>(&value.value);
    if (text == nullptr) return wrong_type();
    *to = *text;
    return check_choice(*text, key.choices);
  }
  std::string operator()(std::array<double, 2>* to) const { return read_fixed(*to); }
  std::string operator()(std::array<double, 3>* to) const { return read_fixed(*to); }
  std::string operator()(std::array<int, 2>* to) const { return read_fixed(*to); }
  std::string operator()(Rows2* to) const { return read_rows(*to); }
  std::string operator()(Rows4* to) const { return read_rows(*to); }

  std::string operator()(Path* to) const {
    Rows2 rows;
    const std::string fault = read_rows(rows);
    if (!fault.empty()) return fault;
    if (rows.front()[0] < 0.0)
      return "times start at " + format_exact(rows.front()[0]) + " s; allowed: 0 s or later";
    *to = {};
    for (const auto& [time, level] : rows) {
      to->times.push_back(time);
      to->values.push_back(level);
    }
    return {};
  }

  std::string operator()(std::vector<double>* to) const {
    const auto* list = std::get_if<SourceValue::List>(&value.value);
    if (list == nullptr) return wrong_type();
    to->clear();
    for (const SourceValue& item : *list) {
      const std::string fault = read_number(item, to->emplace_back());
      if (!fault.empty()) return fault;
    }
    return {};
  }

  std::string operator()(std::vector<std::string>* to) const {
    const auto* list = std::get_if<SourceValue::List>(&value.value);
    if (list == nullptr) return wrong_type();
    to->clear();
    for (const SourceValue& item : *list) {
      const auto* text = std::get_if<std::string>(&item.value);
      if (text == nullptr) return wrong_type();
      const std::string fault = check_choice(*text, key.choices);
      if (!fault.empty()) return fault;
      if (std::find(to->begin(), to->end(), *text) != to->end()) return quote(*text) + " stands twice";
      to->push_back(*text);
    }
    return {};
  }
};

struct TypeName {
  const SceneKey& key;
  std::string unit() const { return key.unit.empty() ? "" : " [" + key.unit + "]"; }
  std::string column() const { return key.unit.empty() ? "value" : key.unit; }

  std::string operator()(const double*) const { return "a number" + unit(); }
  std::string operator()(const std::optional<double>*) const { return "a number" + unit(); }
  std::string operator()(const int*) const { return "a whole number" + unit(); }
  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const std::string*) const { return "text in quotes"; }
  std::string operator()(const std::array<double, 2>*) const { return "two numbers [a, b]" + unit(); }
  std::string operator()(const std::array<double, 3>*) const { return "three numbers [x, y, z]" + unit(); }
  std::string operator()(const std::array<int, 2>*) const { return "two whole numbers [a, b]" + unit(); }
  std::string operator()(const Path*) const { return "a path [[s, " + column() + "], ...]"; }
  std::string operator()(const Rows2*) const { return "rows [[a, b], ...]"; }
  std::string operator()(const Rows4*) const { return "rows [[s, x, y, z], ...]"; }
  std::string operator()(const std::vector<std::string>*) const { return "a list of texts [\"a\", ...]"; }
  std::string operator()(const std::vector<double>*) const { return "a list of numbers [a, ...]"; }
};

struct Format {
  template <class Item>
  static std::string list(const Item& items) {
    std::vector<std::string> texts;
    for (const auto& item : items) texts.push_back(Format{}(&item));
    return "[" + join(texts, ", ") + "]";
  }
  std::string operator()(const double* number) const { return format_exact(*number); }
  std::string operator()(const std::optional<double>* number) const {
    return *number ? format_exact(**number) : "";
  }
  std::string operator()(const int* number) const { return std::to_string(*number); }
  std::string operator()(const bool* flag) const { return *flag ? "true" : "false"; }
  std::string operator()(const std::string* text) const { return text->empty() ? "" : quote(*text); }
  std::string operator()(const Path* path) const {
    Rows2 rows;
    for (size_t i = 0; i < path->times.size(); ++i) rows.push_back({path->times[i], path->values[i]});
    return (*this)(&rows);
  }
  template <class Item, size_t N>
  std::string operator()(const std::array<Item, N>* items) const {
    return list(*items);
  }
  template <class Item>
  std::string operator()(const std::vector<Item>* items) const {
    return items->empty() ? "" : list(*items);
  }
};

}  // namespace

std::string assign_value(const SourceValue& value, const SceneKey& key, const SceneSlot& slot) {
  return std::visit(Assign{value, key, slot}, slot);
}

std::string describe_type(const SceneKey& key, const SceneSlot& slot) {
  return std::visit(TypeName{key}, slot);
}

std::string format_slot(const SceneSlot& slot) { return std::visit(Format{}, slot); }

std::string describe_range(const KeyRange& range) {
  const bool low = std::isfinite(range.low), high = std::isfinite(range.high);
  if (low && high) return format_exact(range.low) + " to " + format_exact(range.high);
  if (low) return "at least " + format_exact(range.low);
  if (high) return "at most " + format_exact(range.high);
  return {};
}

std::string format_value(const SourceValue& value) {
  constexpr size_t kLongest = 60;
  std::string text;
  if (const auto* flag = std::get_if<bool>(&value.value))
    text = *flag ? "true" : "false";
  else if (const auto* integer = std::get_if<std::int64_t>(&value.value))
    text = std::to_string(*integer);
  else if (const auto* number = std::get_if<double>(&value.value))
    text = format_exact(*number);
  else if (const auto* words = std::get_if<std::string>(&value.value))
    text = quote(*words);
  else if (const auto* other = std::get_if<SourceValue::Other>(&value.value))
    text = other->what;
  else {
    std::vector<std::string> items;
    for (const SourceValue& item : std::get<SourceValue::List>(value.value))
      items.push_back(format_value(item));
    text = "[" + join(items, ", ") + "]";
  }
  if (text.size() > kLongest) text = text.substr(0, kLongest - 3) + "...";
  return text;
}

}  // namespace hydroscope
