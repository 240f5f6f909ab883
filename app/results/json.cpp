// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/results/json.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "solver/base/error.h"
#include "solver/scene/number_text.h"

namespace hydroscope {
namespace {

template <class Kind, class Value>
const Kind& get(const Value& value, const char* what) {
  const Kind* found = std::get_if<Kind>(&value);
  if (found == nullptr) throw InputError(std::string("JSON: ") + what + " expected");
  return *found;
}

void write_text(const std::string& text, std::string& out) {
  constexpr const char* kHex = "0123456789abcdef";
  out += '"';
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (code < 0x20) {
      out += "\\u00";
      out += kHex[code >> 4];
      out += kHex[code & 15];
    } else {
      out += c;
    }
  }
  out += '"';
}

bool is_plain(const Json& item) { return item.write().find('\n') == std::string::npos; }

struct Writer {
  std::string& out;
  std::string indent;

  void operator()(std::nullptr_t) const { out += "null"; }
  void operator()(bool flag) const { out += flag ? "true" : "false"; }
  void operator()(double number) const { out += std::isfinite(number) ? format_exact(number) : "null"; }
  void operator()(const std::string& text) const { write_text(text, out); }

  static std::string shift(const std::string& text, const std::string& by) {
    std::string shifted;
    for (const char c : text) {
      shifted += c;
      if (c == '\n') shifted += by;
    }
    return shifted;
  }

  void operator()(const Json::Array& items) const {
    const bool on_one_line = std::all_of(items.begin(), items.end(), is_plain);
    out += '[';
    for (size_t i = 0; i < items.size(); ++i) {
      if (i > 0) out += on_one_line ? ", " : ",";
      if (!on_one_line) out += "\n  ";
      out += shift(items[i].write(), "  ");
    }
    out += on_one_line ? "]" : "\n]";
  }

  void operator()(const Json::Object& members) const {
    if (members.empty()) {
      out += "{}";
      return;
    }
    out += '{';
    for (size_t i = 0; i < members.size(); ++i) {
      out += i > 0 ? ",\n  " : "\n  ";
      write_text(members[i].first, out);
      out += ": " + shift(members[i].second.write(), "  ");
    }
    out += "\n}";
  }
};

class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  Json parse_all() {
    Json value = parse_value(0);
    skip_space();
    if (at_ != text_.size()) fail("nothing more");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& expected) const {
    const auto line =
        1 + std::count(text_.begin(), text_.begin() + static_cast<long>(std::min(at_, text_.size())), '\n');
    throw InputError("JSON, line " + std::to_string(line) + ": " + expected + " expected");
  }

  void skip_space() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos)
      ++at_;
  }

  bool take(char c) {
    skip_space();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  bool take_word(std::string_view word) {
    if (text_.compare(at_, word.size(), word) != 0) return false;
    at_ += word.size();
    return true;
  }

  Json parse_value(int depth) {
    constexpr int kDeepest = 50;
    if (depth > kDeepest) fail("fewer levels");
    skip_space();
    if (take('{')) return parse_object(depth);
    if (take('[')) return parse_array(depth);
    if (take('"')) return parse_text();
    if (take_word("true")) return true;
    if (take_word("false")) return false;
    if (take_word("null")) return {};
    double number = 0.0;
    const char* end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + at_, end, number);
    if (error != std::errc()) fail("a value");
    at_ = static_cast<size_t>(stop - text_.data());
    return number;
  }

  Json parse_object(int depth) {
    Json::Object members;
    if (take('}')) return members;
    do {
      if (!take('"')) fail("a key in quotes");
      std::string key = parse_text();
      if (!take(':')) fail("':'");
      members.emplace_back(std::move(key), parse_value(depth + 1));
    } while (take(','));
    if (!take('}')) fail("'}'");
    return members;
  }

  Json parse_array(int depth) {
    Json::Array items;
    if (take(']')) return items;
    do items.push_back(parse_value(depth + 1));
    while (take(','));
    if (!take(']')) fail("']'");
    return items;
  }

  /// After the opening quote. Of \u only the control characters that we write.
  std::string parse_text() {
    std::string text;
    while (at_ < text_.size() && text_[at_] != '"') {
      char c = text_[at_++];
      if (c != '\\') {
        text += c;
        continue;
      }
      if (at_ >= text_.size()) fail("a character");
      c = text_[at_++];
      if (c == 'n')
        text += '\n';
      else if (c == 't')
        text += '\t';
      else if (c == 'r')
        text += '\r';
      else if (c == 'u')
        text += parse_code();
      else
        text += c;
    }
    if (at_ >= text_.size()) fail("'\"'");
    ++at_;
    return text;
  }

  char parse_code() {
    unsigned code = 0;
    if (at_ + 4 > text_.size()) fail("four digits");
    const auto [stop, error] = std::from_chars(text_.data() + at_, text_.data() + at_ + 4, code, 16);
    if (error != std::errc() || stop != text_.data() + at_ + 4 || code > 0x7f) fail("a code below 0080");
    at_ += 4;
    return static_cast<char>(code);
  }

  const std::string& text_;
  size_t at_ = 0;
};

}  // namespace

bool Json::flag() const { return get<bool>(value_, "true or false"); }
double Json::number() const { return get<double>(value_, "a number"); }
const std::string& Json::text() const { return get<std::string>(value_, "text"); }
const Json::Array& Json::items() const { return get<Array>(value_, "a list"); }
const Json::Object& Json::members() const { return get<Object>(value_, "an object"); }

const Json* Json::find(const std::string& key) const {
  for (const auto& [name, value] : members()) {
    if (name == key) return &value;
  }
  return nullptr;
}

const Json& Json::at(const std::string& key) const {
  const Json* found = find(key);
  if (found == nullptr) throw InputError("JSON: key '" + key + "' expected");
  return *found;
}

std::string Json::write() const {
  std::string out;
  std::visit(Writer{out, ""}, value_);
  return out;
}

Json Json::parse(const std::string& text) { return Parser(text).parse_all(); }

}  // namespace hydroscope
