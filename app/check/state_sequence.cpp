// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check/state_sequence.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "app/results/state_file.h"
#include "solver/base/error.h"
#include "solver/scene/number_text.h"

namespace hydroscope {
namespace {

int read_number(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  int number = -1;
  const auto end = std::from_chars(stem.data(), stem.data() + stem.size(), number);
  if (end.ptr != stem.data() + stem.size() || number < 0)
    throw InputError(file.string() + ": a state is called NNNNN.vtp");
  return number;
}

ResultFolder find_folder(const std::filesystem::path& place) {
  if (!std::filesystem::exists(place)) throw InputError(place.string() + ": there is no such folder");
  const std::filesystem::path path = place.filename().empty() ? place.parent_path() : place;
  const bool is_states = path.filename() == "states" && !std::filesystem::exists(path / "model.json");
  return {is_states ? (path.has_parent_path() ? path.parent_path() : std::filesystem::path(".")) : path};
}

std::string name(const StateStamp& stamp) { return ResultFolder::state_name(stamp.number); }

std::string describe_increment(const StateStamp& stamp) {
  return "increment " + std::to_string(stamp.increment) + " (t = " + format_exact(stamp.time) + " s)";
}

}  // namespace

StateSequence::StateSequence(const std::filesystem::path& place) : folder_(find_folder(place)) {
  files_ = find_states(folder_);
  model_ = read_model(folder_.path, files_.front());
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const auto state = read(i);
    stamps_.push_back({read_number(files_[i]), state->increment, state->time});
  }
}

std::shared_ptr<const Snapshot> StateSequence::read(std::size_t index) const {
  return read_state(files_.at(index), model_);
}

std::vector<Finding> check_order(const std::vector<StateStamp>& got) {
  std::vector<Finding> findings;
  const auto add = [&findings](const StateStamp& stamp, const std::string& text) {
    findings.push_back({CheckStage::kSequence, "", stamp.number + 1, text});
  };
  for (std::size_t i = 0; i < got.size(); ++i) {
    const int wanted = i == 0 ? 0 : got[i - 1].number + 1;
    if (got[i].number != wanted) add({wanted, 0, 0.0}, ResultFolder::state_name(wanted) + " is missing");
    if (i == 0) continue;
    const StateStamp& before = got[i - 1];
    if (!(got[i].time > before.time))
      add(got[i], "time does not rise: " + format_exact(got[i].time) + " s in " + name(got[i]) + " after " +
                      format_exact(before.time) + " s in " + name(before));
    else if (got[i].increment <= before.increment)
      add(got[i], "increments do not rise: " + std::to_string(got[i].increment) + " in " + name(got[i]) +
                      " after " + std::to_string(before.increment));
  }
  return findings;
}

std::vector<Finding> check_completeness(const std::vector<StateStamp>& expected,
                                        const std::vector<StateStamp>& got) {
  std::vector<Finding> findings;
  if (expected.size() == got.size()) return findings;
  findings.push_back({CheckStage::kSequence, "", 0,
                      std::to_string(got.size()) + " frames instead of " + std::to_string(expected.size())});
  std::set<int> is_there;
  for (const StateStamp& stamp : got) is_there.insert(stamp.increment);
  for (const StateStamp& stamp : expected)
    if (is_there.erase(stamp.increment) == 0)
      findings.push_back(
          {CheckStage::kSequence, "", stamp.number + 1, describe_increment(stamp) + " is missing"});
  for (const StateStamp& stamp : got)
    if (is_there.count(stamp.increment) > 0)
      findings.push_back(
          {CheckStage::kSequence, "", stamp.number + 1, describe_increment(stamp) + " was not there before"});
  return findings;
}

}  // namespace hydroscope
