// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/inspect_options.h"

#include <algorithm>
#include <sstream>

#include "app/inspect/ledger_report.h"
#include "solver/base/error.h"
#include "solver/scene/key_suggestion.h"

namespace hydroscope {
namespace {

constexpr double kFar = 1e9;       // [mm] or [s]
constexpr int kMost = 2000000000;  // nodes and lines

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

[[noreturn]] void fail_name(const std::string& start, const std::string& given,
                            const std::vector<std::string>& known) {
  std::string list;
  for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
  const std::string nearest = find_nearest_name(given, known);
  throw InputError(start + " " + given + ": one of " + list + " expected" +
                   (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

/// "3-17" or "3".
std::array<int, 2> parse_nodes(const std::string& text) {
  const std::size_t dash = text.find('-', 1);
  const std::string first = text.substr(0, dash);
  const std::string last = dash == std::string::npos ? first : text.substr(dash + 1);
  const std::array<int, 2> nodes = {parse_whole_number("--node-range", first, 0, kMost),
                                    parse_whole_number("--node-range", last, 0, kMost)};
  if (nodes[0] > nodes[1]) throw InputError("--node-range " + text + ": the first is above the last");
  return nodes;
}

std::array<double, 6> parse_region(const std::string& text) {
  const auto parts = split(text, ',');
  if (parts.size() != 6)
    throw InputError("--region " + text + ": six numbers expected, X0,X1,Y0,Y1,Z0,Z1 in mm");
  std::array<double, 6> region{};
  for (std::size_t i = 0; i < 6; ++i) region[i] = parse_number("--region", parts[i], -kFar, kFar);
  for (std::size_t i = 0; i < 6; i += 2)
    if (region[i] > region[i + 1])
      throw InputError("--region " + text + ": " + parts[i] + " is above " + parts[i + 1]);
  return region;
}

std::set<EventKind> parse_kinds(const std::string& text) {
  std::set<EventKind> kinds;
  for (const std::string& name : split(text, ',')) kinds.insert(parse_event_kind(name, "--kind: "));
  if (kinds.empty()) fail_name("--kind", text, event_kind_names());
  return kinds;
}

std::set<Verdict> parse_verdicts(const std::string& text) {
  std::set<Verdict> verdicts;
  const std::vector<std::string> known = {"physical", "noise", "chatter"};
  for (const std::string& name : split(text, ',')) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) fail_name("--verdict", name, known);
    verdicts.insert(static_cast<Verdict>(found - known.begin()));
  }
  if (verdicts.empty()) fail_name("--verdict", text, known);
  return verdicts;
}

void parse_filter(const Arguments& arguments, LedgerFilter& filter) {
  if (arguments.has("--node-range")) filter.nodes = parse_nodes(arguments.get("--node-range"));
  if (arguments.has("--region")) filter.region = parse_region(arguments.get("--region"));
  if (arguments.has("--from")) filter.from = parse_number("--from", arguments.get("--from"), 0.0, kFar);
  if (arguments.has("--to")) filter.to = parse_number("--to", arguments.get("--to"), 0.0, kFar);
  if (filter.from > filter.to) throw InputError("--from " + arguments.get("--from") + ": is after --to");
  if (arguments.has("--kind")) filter.kinds = parse_kinds(arguments.get("--kind"));
  if (arguments.has("--verdict")) filter.verdicts = parse_verdicts(arguments.get("--verdict"));
  filter.sort = arguments.get("--sort", filter.sort);
  const auto& sorts = ledger_sort_names();
  if (std::find(sorts.begin(), sorts.end(), filter.sort) == sorts.end())
    fail_name("--sort", filter.sort, sorts);
}

std::string make_life_report(const Ledger& ledger, const InspectOptions& options, const std::string& name) {
  const int nodes = static_cast<int>(ledger.sheet.neighbours.size());
  if (*options.node >= nodes)
    throw InputError("--node " + std::to_string(*options.node) + ": the sheet has nodes 0 to " +
                     std::to_string(nodes - 1));
  if (options.format == LedgerFormat::kJson) return make_life_json(ledger, *options.node);
  if (options.format == LedgerFormat::kCsv) return make_life_csv(ledger, *options.node);
  return make_life_text(ledger, *options.node, name);
}

}  // namespace

InspectOptions parse_inspect_options(const Arguments& arguments) {
  InspectOptions options;
  if (arguments.has("--json") && arguments.has("--csv")) throw InputError("--csv: not together with --json");
  if (arguments.has("--json")) options.format = LedgerFormat::kJson;
  if (arguments.has("--csv")) options.format = LedgerFormat::kCsv;
  if (arguments.has("--limit")) {
    if (options.format != LedgerFormat::kText)
      throw InputError("--limit: --json and --csv always give all; leave it out");
    options.most = parse_whole_number("--limit", arguments.get("--limit"), 0, kMost);
  }
  if (arguments.has("--node")) {
    options.node = parse_whole_number("--node", arguments.get("--node"), 0, kMost);
    for (const char* other :
         {"--tool", "--node-range", "--region", "--from", "--to", "--kind", "--verdict", "--sort", "--limit"})
      if (arguments.has(other))
        throw InputError(std::string(other) + ": --node shows the whole life of a node; leave it out");
    return options;
  }
  options.tool = arguments.get("--tool");
  parse_filter(arguments, options.filter);
  return options;
}

std::string make_inspect_report(const Ledger& ledger, const InspectOptions& options,
                                const std::string& name) {
  if (options.node) return make_life_report(ledger, options, name);
  LedgerFilter filter = options.filter;
  if (!options.tool.empty()) {
    const auto found = std::find(ledger.tools.begin(), ledger.tools.end(), options.tool);
    if (found == ledger.tools.end()) fail_name("--tool", options.tool, ledger.tools);
    filter.tool = static_cast<int>(found - ledger.tools.begin());
  }
  const auto chosen = select_episodes(ledger, filter);
  if (options.format == LedgerFormat::kJson) return make_ledger_json(ledger, chosen);
  if (options.format == LedgerFormat::kCsv) return make_ledger_csv(ledger, chosen);
  return make_ledger_text(ledger, chosen, name, options.most);
}

}  // namespace hydroscope
