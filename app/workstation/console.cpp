// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/console.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>

#include "app/workstation/command.h"
#include "app/workstation/console_text.h"
#include "solver/base/error.h"
#include "solver/scene/key_suggestion.h"

namespace hydroscope {

namespace {

constexpr std::chrono::milliseconds kGlance(200);

struct LookingHelp {
  const char *form, *doc;
};
constexpr LookingHelp kLooking[] = {
    {"status", "Where the analysis stands."},
    {"states", "The kept states; 'back' goes to them."},
    {"node N [INCREMENT]", "Place, wall, contact and margin to letting go of a node; at a kept state."},
    {"quantities", "The quantities of the scene."},
    {"events [N]", "The last N contact events (20)."},
    {"warnings", "All warnings."},
    {"help", "This list."},
    {"quit", "End the run where it stands, write its summary and leave."},
};

std::string make_console_help() {
  const auto line = [](const std::string& form, const std::string& doc) {
    return "  " + form + std::string(form.size() < 20 ? 20 - form.size() : 1, ' ') + doc + "\n";
  };
  std::string help = "steering:\n";
  for (const CommandHelp& item : steering_help()) help += line(item.form, item.doc);
  help += "looking:\n";
  for (const LookingHelp& item : kLooking) help += line(item.form, item.doc);
  return help;
}

int parse_int(const std::string& text, const std::string& what) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw InputError("'" + text + "' is no " + what);
  return number;
}

/// Without blanks at both ends and without what follows a '#' at the start of a word.
std::string strip(std::string line) {
  for (std::size_t at = line.find('#'); at != std::string::npos; at = line.find('#', at + 1)) {
    if (at > 0 && line[at - 1] != ' ' && line[at - 1] != '\t') continue;
    line.resize(at);
    break;
  }
  const std::size_t first = line.find_first_not_of(" \t\r"), last = line.find_last_not_of(" \t\r");
  return first == std::string::npos ? std::string() : line.substr(first, last - first + 1);
}

}  // namespace

LineReader::Result LineReader::read(std::string& line, std::chrono::milliseconds patience) {
  for (;;) {
    const std::size_t end = buffer_.find('\n');
    if (end != std::string::npos || (has_ended_ && !buffer_.empty())) {
      line = buffer_.substr(0, end);
      buffer_.erase(0, end == std::string::npos ? end : end + 1);
      return Result::kLine;
    }
    if (has_ended_) return Result::kEnd;
    pollfd item{descriptor_, POLLIN, 0};
    if (poll(&item, 1, static_cast<int>(patience.count())) <= 0) return Result::kNothingYet;
    std::array<char, 4096> bytes{};
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) return Result::kNothingYet;
    if (count <= 0) has_ended_ = true;
    if (count > 0) buffer_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

Console::End Console::run() {
  if (settings_.is_terminal) say(describe_status(workstation_.status()) + "'help' lists the commands.\n");
  prompt();
  int number = 0;
  for (std::string line;;) {
    const LineReader::Result result = reader_.read(line, kGlance);
    if (take_interrupt()) return End::kInterrupted;
    if (result == LineReader::Result::kEnd) return End::kDone;
    if (result == LineReader::Result::kNothingYet) {
      tell_news();
      continue;
    }
    ++number;
    const std::string text = strip(line);
    try {
      if (!text.empty() && !obey(text)) return End::kDone;
    } catch (const InputError& error) {
      if (!settings_.is_terminal)
        throw InputError("standard input:" + std::to_string(number) + ": " + error.what());
      say(std::string(error.what()) + "\n");
    }
    if (is_interrupted_) return End::kInterrupted;
    prompt();
  }
}

bool Console::obey(const std::string& line) {
  const std::size_t space = line.find_first_of(" \t");
  const std::string word = line.substr(0, space);
  const std::string rest = space == std::string::npos ? "" : strip(line.substr(space));
  if (word == "quit" || word == "exit") return false;
  if (look(word, rest)) return true;
  std::vector<std::string> known;
  for (const LookingHelp& item : kLooking)
    known.emplace_back(std::string(item.form).substr(0, std::string(item.form).find(' ')));
  const std::string nearest = find_nearest_name(word, known);
  const CommandReply reply = workstation_.command(line, "console");
  if (!reply.is_done) throw InputError(reply.text + (nearest.empty() ? "" : " (or '" + nearest + "'?)"));
  was_running_ = workstation_.status().phase == WorkstationStatus::Phase::kRunning;
  if (settings_.is_terminal || !was_running_) say(reply.text + "\n");
  if (!settings_.is_terminal && was_running_) wait_halted();
  return true;
}

bool Console::look(const std::string& word, const std::string& rest) {
  const std::shared_ptr<const Snapshot> newest = workstation_.newest();
  if (word == "help") {
    say(make_console_help());
  } else if (word == "status") {
    say(describe_status(workstation_.status()));
  } else if (word == "states") {
    say(describe_kept(workstation_.kept_states()));
  } else if (word == "warnings") {
    say(describe_warnings(workstation_.warnings()));
  } else if (word == "quantities") {
    say(describe_quantities(*newest));
  } else if (word == "events") {
    const int number = rest.empty() ? 20 : parse_int(rest, "number of events");
    say(describe_events(workstation_.events(), *newest, static_cast<std::size_t>(std::max(0, number))));
  } else if (word == "node") {
    if (rest.empty()) throw InputError("'node' lacks the number of a node");
    const std::size_t space = rest.find(' ');
    std::shared_ptr<const Snapshot> snapshot = newest;
    if (space != std::string::npos) {
      const int increment = parse_int(strip(rest.substr(space)), "increment");
      snapshot = workstation_.kept(workstation_.status().branch, increment);
      if (snapshot == nullptr)
        throw InputError("no state is kept of increment " + std::to_string(increment) +
                         " ('states' lists them)");
    }
    say(describe_node(*snapshot, parse_int(rest.substr(0, space), "node")));
  } else {
    return false;
  }
  return true;
}

/// For scripts: the next line is for the halted analysis.
void Console::wait_halted() {
  WorkstationStatus status = workstation_.status();
  while (status.phase == WorkstationStatus::Phase::kRunning) {
    if (take_interrupt()) {
      is_interrupted_ = true;
      return;
    }
    status = workstation_.wait_status(status.version, kGlance);
  }
  tell_news();
}

/// Ctrl-C pauses what runs in a terminal; once more, or in a script, it ends. True: end.
bool Console::take_interrupt() {
  if (settings_.interrupt == nullptr || !settings_.interrupt->exchange(false)) return false;
  if (!settings_.is_terminal || workstation_.status().phase != WorkstationStatus::Phase::kRunning)
    return true;
  workstation_.command("pause", "console");
  tell_news();
  say("Ctrl-C once more ends the run\n");
  prompt();
  return false;
}

/// Warnings as they happen, and that it has halted.
void Console::tell_news() {
  const std::vector<Warning> warnings = workstation_.warnings();
  told_warnings_ = std::min(told_warnings_, warnings.size());
  std::string news = told_warnings_ == warnings.size()
                         ? std::string()
                         : describe_warnings({warnings.begin() + static_cast<std::ptrdiff_t>(told_warnings_),
                                              warnings.end()});
  told_warnings_ = warnings.size();
  const WorkstationStatus status = workstation_.status();
  const bool has_halted = was_running_ && status.phase != WorkstationStatus::Phase::kRunning;
  if (has_halted) {
    was_running_ = false;
    news += describe_status(status);
  }
  if (news.empty()) return;
  say((settings_.is_terminal ? "\n" : "") + news);
  if (has_halted) prompt();
}

void Console::say(const std::string& text) {
  std::fputs(text.c_str(), settings_.output);
  std::fflush(settings_.output);
}

void Console::prompt() {
  if (settings_.is_terminal) say("hydroscope> ");
}

}  // namespace hydroscope
