// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/ledger_record.h"
#include "app/inspect/ledger_report.h"

namespace hydroscope {
namespace {

Json::Object make_summary_record(const LedgerSummary& summary) {
  Json::Object causes;
  for (const auto& [cause, count] : summary.causes) causes.emplace_back(cause, count);
  return {{"episodes", summary.episodes},    {"detachments", summary.detachments},
          {"nodes", summary.nodes},          {"patches", summary.patches},
          {"came_back", summary.back},       {"taken_back", summary.taken_back},
          {"physical", summary.verdicts[0]}, {"noise", summary.verdicts[1]},
          {"chatter", summary.verdicts[2]},  {"causes", causes}};
}

std::vector<Json::Object> make_life_records(const Ledger& ledger, int node) {
  std::vector<Json::Object> records;
  for (const LifeLine& line : make_life(ledger, node))
    records.push_back(make_life_record(ledger, node, line));
  return records;
}

}  // namespace

std::string make_ledger_json(const Ledger& ledger, const std::vector<std::size_t>& chosen) {
  const LedgerSummary summary = sum_up_ledger(ledger, chosen);
  Json::Array patches, episodes;
  for (const int patch : summary.patch_list)
    patches.push_back(make_patch_record(ledger, ledger.patches[static_cast<std::size_t>(patch)]));
  for (const std::size_t i : chosen) episodes.push_back(make_episode_record(ledger, ledger.episodes[i]));
  const Json json = Json::Object{{"title", ledger.title},
                                 {"bounds", Json::Object{{"opening_mm", ledger.bounds.opening},
                                                         {"tension_share", ledger.bounds.tension},
                                                         {"window_increments", ledger.bounds.window},
                                                         {"chatter_toggles", ledger.bounds.chatter_toggles}}},
                                 {"summary", make_summary_record(summary)},
                                 {"patches", patches},
                                 {"episodes", episodes}};
  return json.write() + "\n";
}

std::string make_ledger_csv(const Ledger& ledger, const std::vector<std::size_t>& chosen) {
  std::vector<Json::Object> records;
  for (const std::size_t i : chosen) records.push_back(make_episode_record(ledger, ledger.episodes[i]));
  return make_csv(make_episode_record(ledger, Episode{}), records);
}

std::string make_life_json(const Ledger& ledger, int node) {
  Json::Array lines, episodes;
  for (Json::Object& record : make_life_records(ledger, node)) lines.push_back(std::move(record));
  for (const Episode& episode : ledger.episodes)
    if (episode.node == node) episodes.push_back(make_episode_record(ledger, episode));
  const Json json =
      Json::Object{{"title", ledger.title}, {"node", node}, {"episodes", episodes}, {"life", lines}};
  return json.write() + "\n";
}

std::string make_life_csv(const Ledger& ledger, int node) {
  return make_csv(make_life_record(ledger, node, LifeLine{}), make_life_records(ledger, node));
}

}  // namespace hydroscope
