// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/ledger_cache.h"

#include "app/inspect/ledger_record.h"
#include "app/server/api_json.h"

namespace hydroscope {
namespace {

Json find_place(const Ledger& ledger, const Episode& episode) {
  if (episode.let_go) return make_vector_json(ledger.event(*episode.let_go).position);
  if (episode.touched) return make_vector_json(ledger.event(*episode.touched).position);
  return {};
}

}  // namespace

std::string make_ledger_text(const std::filesystem::path& folder, StateKey state) {
  const Ledger ledger = read_ledger({folder});
  Json::Array episodes, patches;
  for (const Episode& episode : ledger.episodes) {
    Json::Object record = make_episode_record(ledger, episode);
    record.emplace_back("place_mm", find_place(ledger, episode));
    episodes.emplace_back(std::move(record));
  }
  for (const Patch& patch : ledger.patches) {
    Json::Object record = make_patch_record(ledger, patch);
    record.emplace_back("place_mm", make_vector_json(patch.centre));
    patches.emplace_back(std::move(record));
  }
  return to_line(Json::Object{{"branch", state.branch},
                              {"increment", state.increment},
                              {"episodes", std::move(episodes)},
                              {"patches", std::move(patches)}});
}

bool LedgerCache::is_fresh(StateKey now, bool is_solving) const {
  if (text_ == nullptr || state_.branch != now.branch) return false;
  return state_ == now || (is_solving && Clock::now() < good_until_);
}

std::shared_ptr<const std::string> LedgerCache::get(const std::filesystem::path& folder, StateKey now,
                                                    bool is_solving) {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return !is_busy_; });
  if (is_fresh(now, is_solving)) return text_;
  is_busy_ = true;
  lock.unlock();
  const Clock::time_point begin = Clock::now();
  std::shared_ptr<const std::string> text;
  std::exception_ptr failure;
  try {
    text = std::make_shared<const std::string>(make_ledger_text(folder, now));
  } catch (...) {
    failure = std::current_exception();
  }
  const Clock::time_point end = Clock::now();
  lock.lock();
  is_busy_ = false;
  done_.notify_all();
  if (failure) std::rethrow_exception(failure);
  text_ = text;
  state_ = now;
  good_until_ = end + std::chrono::duration_cast<Clock::duration>(kRest * (end - begin));
  return text;
}

}  // namespace hydroscope
