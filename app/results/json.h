// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace hydroscope {

/// A JSON value; objects keep the order in which their keys were added.
class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;

  Json() = default;
  Json(bool flag) : value_(flag) {}                          // NOLINT(google-explicit-constructor)
  Json(double number) : value_(number) {}                    // NOLINT(google-explicit-constructor)
  Json(int number) : value_(static_cast<double>(number)) {}  // NOLINT(google-explicit-constructor)
  Json(const char* text) : value_(std::string(text)) {}      // NOLINT(google-explicit-constructor)
  Json(std::string text) : value_(std::move(text)) {}        // NOLINT(google-explicit-constructor)
  Json(Array items) : value_(std::move(items)) {}            // NOLINT(google-explicit-constructor)
  Json(Object members) : value_(std::move(members)) {}       // NOLINT(google-explicit-constructor)

  bool is_number() const { return std::holds_alternative<double>(value_); }
  bool is_array() const { return std::holds_alternative<Array>(value_); }
  bool is_object() const { return std::holds_alternative<Object>(value_); }
  bool is_null() const { return std::holds_alternative<std::nullptr_t>(value_); }

  /// These throw InputError when the value is of another kind or the key is missing.
  bool flag() const;
  double number() const;
  const std::string& text() const;
  const Array& items() const;
  const Object& members() const;
  const Json& at(const std::string& key) const;
  const Json* find(const std::string& key) const;

  /// Two spaces an indent, numbers to the last bit; what is not finite becomes null.
  std::string write() const;
  static Json parse(const std::string& text);

 private:
  std::variant<std::nullptr_t, bool, double, std::string, Array, Object> value_ = nullptr;
};

}  // namespace hydroscope
