// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/journal.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <ctime>

#include "app/results/json.h"
#include "solver/base/error.h"

namespace hydroscope {

namespace {

constexpr int kFormat = 1;

/// Now, as "2026-01-31T12:34:56Z".
std::string print_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

std::string print_hex(std::uint64_t number) {
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(number));
  return text.data();
}

std::uint64_t parse_hex(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
  if (error != std::errc() || end != text.data() + text.size())
    throw InputError("'" + text + "' is no hexadecimal number");
  return number;
}

/// One line: within texts JSON has no bare line ends.
std::string write_line(const Json& json) {
  std::string line;
  bool is_indent = false;
  for (const char c : json.write()) {
    is_indent = c == '\n' || (is_indent && c == ' ');
    if (is_indent && c == '\n' && line.ends_with(',')) line += ' ';
    if (!is_indent) line += c;
  }
  return line + "\n";
}

Json make_json(const JournalHead& head) {
  Json::Array overrides(head.overrides.begin(), head.overrides.end()), files;
  for (const auto& [name, digest] : head.files)
    files.push_back(Json::Object{{"file", name}, {"digest", digest}});
  return Json::Object{{"journal", kFormat},      {"version", head.version},
                      {"scene", head.scene},     {"scene_digest", head.scene_digest},
                      {"files", files},          {"overrides", overrides},
                      {"threads", head.threads}, {"started", head.started}};
}

JournalHead read_head(const Json& json) {
  if (json.at("journal").number() != kFormat)
    throw InputError("is of format " + std::to_string(static_cast<int>(json.at("journal").number())) +
                     "; this program reads " + std::to_string(kFormat));
  JournalHead head;
  head.version = json.at("version").text();
  head.scene = json.at("scene").text();
  head.scene_digest = json.at("scene_digest").text();
  for (const Json& file : json.at("files").items())
    head.files.emplace_back(file.at("file").text(), file.at("digest").text());
  for (const Json& item : json.at("overrides").items()) head.overrides.push_back(item.text());
  head.threads = static_cast<int>(json.at("threads").number());
  head.started = json.at("started").text();
  return head;
}

Json make_json(const JournalEntry& entry) {
  Json::Object json{{"branch", entry.branch}, {"increment", entry.increment}, {"time_s", entry.time}};
  if (entry.is_end()) {
    json.emplace_back("end", entry.outcome);
    json.emplace_back("message", entry.message);
  } else {
    json.emplace_back("who", entry.who);
    json.emplace_back("command", entry.command);
  }
  json.emplace_back("state", print_hex(entry.state));
  json.emplace_back("at", print_now());
  return json;
}

JournalEntry read_entry(const Json& json) {
  JournalEntry entry;
  entry.branch = static_cast<int>(json.at("branch").number());
  entry.increment = static_cast<int>(json.at("increment").number());
  entry.time = json.at("time_s").number();
  if (const Json* outcome = json.find("end")) {
    entry.outcome = outcome->text();
    entry.message = json.at("message").text();
  } else {
    entry.who = json.at("who").text();
    entry.command = json.at("command").text();
  }
  entry.state = parse_hex(json.at("state").text());
  entry.at = json.at("at").text();
  return entry;
}

}  // namespace

Journal::Journal(const std::filesystem::path& path, const JournalHead& head) : file_(path) {
  JournalHead stamped = head;
  stamped.started = print_now();
  file_.append(write_line(make_json(stamped)));
}

void Journal::add(JournalEntry entry) { file_.append(write_line(make_json(entry))); }

JournalContents read_journal(const std::filesystem::path& path) {
  const std::string text = read_whole_file(path);
  JournalContents contents;
  int number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    const std::string line = text.substr(start, end - start);
    const bool is_last = end == std::string::npos || end + 1 == text.size();
    start = is_last ? text.size() : end + 1;
    ++number;
    const std::string place = path.string() + ":" + std::to_string(number) + ": ";
    try {
      const Json json = Json::parse(line);
      if (number == 1) {
        contents.head = read_head(json);
      } else {
        contents.entries.push_back(read_entry(json));
      }
    } catch (const InputError& error) {
      if (number == 1 || !is_last) throw InputError(place + "no line of a journal: " + error.what());
      contents.trouble = place + "the last line is broken off and is left out";
    }
  }
  if (number == 0) throw InputError(path.string() + ": is empty; expected a journal");
  return contents;
}

std::string make_digest(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return print_hex(hash);
}

JournalHead make_journal_head(const Scene& scene, const std::string& text) {
  JournalHead head;
  head.version = HYDROSCOPE_VERSION;
  head.scene = scene.file;
  head.scene_digest = make_digest(text);
  const auto add = [&](const std::string& file) {
    if (file.empty()) return;
    head.files.emplace_back(file,
                            make_digest(read_whole_file(std::filesystem::path(scene.directory) / file)));
  };
  for (const auto& [name, tool] : scene.tools) add(tool.file);
  add(scene.mesh.file);
  return head;
}

}  // namespace hydroscope
