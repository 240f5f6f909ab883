// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "app/inspect/figure_text.h"
#include "app/inspect/ledger_record.h"
#include "app/inspect/ledger_report.h"

namespace hydroscope {
namespace {

using Lines = std::vector<std::vector<std::string>>;

std::string count(int number, const std::string& one, const std::string& many) {
  return std::to_string(number) + " " + (number == 1 ? one : many);
}

std::string tool_name(const Ledger& ledger, int tool) {
  return tool >= 0 ? ledger.tools[static_cast<std::size_t>(tool)] : "-";
}

std::string increment_of(const Ledger& ledger, const std::optional<std::size_t>& event) {
  return event ? std::to_string(ledger.event(*event).increment) : "-";
}

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// "strain", or "release @12".
std::string limiter_text(const IncrementRow& row) {
  return row.limited_by + (row.limited_at >= 0 ? " @" + std::to_string(row.limited_at) : "");
}

std::string make_summary_text(const LedgerSummary& summary, const Ledger& ledger) {
  std::string text;
  if (summary.detachments == 0) text = "nothing let go";
  if (summary.detachments > 0) {
    text = count(summary.detachments, "detachment", "detachments") + " in " +
           count(summary.patches, "patch", "patches") + ": " + std::to_string(summary.verdicts[0]) +
           " physical, " + std::to_string(summary.verdicts[1]) + " noise, " +
           std::to_string(summary.verdicts[2]) + " chatter; " + std::to_string(summary.back) + " came back\n";
    text += "causes:";
    for (const auto& [cause, number] : summary.causes)
      text += (text.back() == ':' ? " " : ", ") + cause + " " + std::to_string(number);
  }
  if (summary.taken_back > 0)
    text += "\n" + count(summary.taken_back, "release", "releases") + " taken back at once (noise)";
  if (summary.episodes > summary.detachments)
    text += "\n" + count(summary.episodes - summary.detachments, "touch", "touches") + " without letting go";
  return text + "\n" + count(summary.nodes, "node", "nodes") + "; open counts from " +
         format_figure(ledger.bounds.opening) + " mm, pulled from " +
         format_figure(100.0 * ledger.bounds.tension) + " % of the fluid's share p A\n";
}

std::vector<std::string> make_patch_line(const Ledger& ledger, int index) {
  const Patch& patch = ledger.patches[static_cast<std::size_t>(index)];
  const bool is_one = patch.first_increment == patch.last_increment;
  return {std::to_string(index + 1),
          std::to_string(patch.nodes),
          tool_name(ledger, patch.tool),
          std::to_string(patch.first_increment) + (is_one ? "" : ".." + std::to_string(patch.last_increment)),
          format_figure(patch.first_time),
          join(patch.causes),
          join(patch.drives),
          format_figure(patch.force_before),
          format_figure(patch.fluid_share),
          format_figure(patch.facet_noise),
          format_figure(patch.gap_reached),
          std::to_string(patch.back),
          limiter_text(ledger.log.row(patch.first_increment)),
          to_string(patch.verdict)};
}

/// The reason of the first episode that was judged as the patch was.
std::string make_reason_line(const Ledger& ledger, int index) {
  const Patch& patch = ledger.patches[static_cast<std::size_t>(index)];
  for (const std::size_t i : patch.episodes) {
    const Episode& episode = ledger.episodes[i];
    if (episode.verdict != patch.verdict) continue;
    return "  " + std::to_string(index + 1) + ": " + to_string(patch.verdict) + ", as node " +
           std::to_string(episode.node) + ": " + episode.reason + "\n";
  }
  return "";
}

std::vector<std::string> make_episode_line(const Ledger& ledger, const Episode& e) {
  const ReleaseFigures& f = e.figures;
  const ContactEvent* let_go = e.let_go ? &ledger.event(*e.let_go) : nullptr;
  const auto shown = [&](double number) { return let_go != nullptr ? format_figure(number) : "-"; };
  return {std::to_string(e.node),
          tool_name(ledger, e.tool),
          increment_of(ledger, e.touched),
          std::to_string(e.changes.size()),
          increment_of(ledger, e.let_go),
          let_go != nullptr ? format_figure(let_go->time) : "-",
          increment_of(ledger, e.back),
          let_go != nullptr ? let_go->cause : "-",
          let_go != nullptr ? format_figure(let_go->force_before) : "-",
          shown(100.0 * f.force_share),
          shown(f.contact_pressure_before) + " > " + shown(f.contact_pressure_after),
          shown(f.gap_reached),
          shown(f.opening_speed),
          let_go != nullptr ? std::to_string(f.toggles) : "-",
          let_go != nullptr ? limiter_text(ledger.log.row(let_go->increment)) : "-",
          e.patch >= 0 ? std::to_string(e.patch + 1) : "-",
          let_go != nullptr ? to_string(e.verdict) : "-"};
}

/// The largest of the most believable ones.
int find_telling_patch(const Ledger& ledger, const std::vector<int>& patches) {
  return *std::min_element(patches.begin(), patches.end(), [&](int a, int b) {
    const Patch& first = ledger.patches[static_cast<std::size_t>(a)];
    const Patch& second = ledger.patches[static_cast<std::size_t>(b)];
    return first.verdict != second.verdict ? first.verdict < second.verdict : first.nodes > second.nodes;
  });
}

std::string make_rest_line(std::size_t left_out) {
  return left_out == 0 ? "" : "... and " + std::to_string(left_out) + " more (--limit 0 shows all)\n";
}

std::string make_patch_table(const Ledger& ledger, const std::vector<int>& patches, std::size_t most) {
  Lines lines = {{"patch", "nodes", "tool", "increment", "time s", "cause", "while", "force N", "p A N",
                  "noise N", "gap mm", "back", "limited by", "verdict"}};
  std::string reasons;
  const std::size_t shown = std::min(most, patches.size());
  for (std::size_t i = 0; i < shown; ++i) {
    lines.push_back(make_patch_line(ledger, patches[i]));
    reasons += make_reason_line(ledger, patches[i]);
  }
  return "\n" + format_columns(lines) + make_rest_line(patches.size() - shown) + "why\n" + reasons;
}

}  // namespace

std::string make_ledger_text(const Ledger& ledger, const std::vector<std::size_t>& chosen,
                             const std::string& name, int most) {
  const LedgerSummary summary = sum_up_ledger(ledger, chosen);
  std::string text = name + ": " + ledger.title + "\n" + make_summary_text(summary, ledger);
  const std::size_t limit = most > 0 ? static_cast<std::size_t>(most) : chosen.size();
  if (!summary.patch_list.empty()) {
    text += make_patch_table(ledger, summary.patch_list, limit);
    text += "to see it: hydroscope render " + name + " --follow detachment --patch " +
            std::to_string(find_telling_patch(ledger, summary.patch_list) + 1) + "\n";
  }
  if (chosen.empty()) return text;
  Lines lines = {{"node", "tool", "touched", "stick/slip", "let go", "time s", "back", "cause", "force N",
                  "% of p A", "contact MPa", "gap mm", "mm/s", "toggles", "limited by", "patch", "verdict"}};
  const std::size_t shown = std::min(limit, chosen.size());
  for (std::size_t i = 0; i < shown; ++i)
    lines.push_back(make_episode_line(ledger, ledger.episodes[chosen[i]]));
  return text + "\n" + format_columns(lines) + make_rest_line(chosen.size() - shown);
}

std::string make_life_text(const Ledger& ledger, int node, const std::string& name) {
  std::string text = name + ": " + ledger.title + "\nnode " + std::to_string(node) + "\n\n";
  Lines lines = {{"increment", "time s", "what", "tool", "cause", "force before N", "force N", "gap mm",
                  "contact MPa", "fluid MPa", "limited by", "verdict"}};
  std::string reasons;
  for (const LifeLine& line : make_life(ledger, node)) {
    const Json record = make_life_record(ledger, node, line);
    const auto figure = [&](const char* key) {
      return record.at(key).is_null() ? "-" : format_figure(record.at(key).number());
    };
    const auto word = [&](const char* key) {
      return record.at(key).is_null() || record.at(key).text().empty() ? "-" : record.at(key).text();
    };
    lines.push_back({std::to_string(line.increment), figure("time_s"), word("what"), word("tool"),
                     word("cause"), figure("force_before_N"), figure("force_N"), figure("gap_mm"),
                     figure("contact_pressure_MPa"), figure("pressure_MPa"),
                     limiter_text(ledger.log.row(line.increment)), word("verdict")});
    if (!record.at("reason").is_null())
      reasons += "  increment " + std::to_string(line.increment) + ": " + word("verdict") + ", " +
                 word("reason") + "\n";
  }
  return text + format_columns(lines) + (reasons.empty() ? "it never let go\n" : "why\n" + reasons);
}

}  // namespace hydroscope
