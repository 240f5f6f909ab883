// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/json_text.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace hydroscope {

std::string JsonText::quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
      out += code;
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string JsonText::written(double number) {
  if (!std::isfinite(number)) return "null";
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, number);
  return {text, end.ptr};
}

void JsonText::add_raw(const std::string& key, const std::string& value) {
  body_ += (body_.empty() ? "  " : ",\n  ") + quoted(key) + ": " + value;
}

void JsonText::add(const std::string& key, const std::vector<double>& numbers) {
  std::string list = "[";
  for (double number : numbers) list += (list.size() > 1 ? ", " : "") + written(number);
  add_raw(key, list + "]");
}

void JsonText::add(const std::string& key, const JsonText& object) {
  if (object.body_.empty()) return add_raw(key, "{}");
  std::string nested = "{\n" + object.body_ + "\n}";
  for (std::size_t at = nested.find('\n'); at != std::string::npos; at = nested.find('\n', at + 3))
    nested.insert(at + 1, "  ");
  add_raw(key, nested);
}

}  // namespace hydroscope
