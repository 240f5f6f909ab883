// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/news.h"

#include <algorithm>

#include "app/server/api_json.h"

namespace hydroscope {
namespace {

constexpr std::chrono::milliseconds kLook{200};  ///< how soon a close is noticed
constexpr std::chrono::milliseconds kPause{50};  ///< at least, between two looks: 20 a second
constexpr std::chrono::milliseconds kNoPause{0};

}  // namespace

News::News(const Workstation& workstation, OnState on_state)
    : workstation_(workstation), on_state_(std::move(on_state)) {
  status_ = workstation_.status();
  branch_ = status_.branch;
  events_ = workstation_.events().size();
  warnings_ = workstation_.warnings().size();
  on_state_(workstation_.newest(), status_.branch, status_.phase == WorkstationStatus::Phase::kRunning);
  thread_ = std::thread([this] { work(); });
}

News::~News() {
  close();
  thread_.join();
}

void News::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  changed_.notify_all();
}

void News::touch() {
  const std::lock_guard lock(mutex_);
  ++change_;
  changed_.notify_all();
}

void News::add(const std::string& event, std::string data) {
  const std::lock_guard lock(mutex_);
  items_.push_back({++last_item_, event, std::move(data)});
  if (items_.size() > kKept) items_.pop_front();
  changed_.notify_all();
}

void News::look(const WorkstationStatus& status) {
  const bool is_solving = status.phase == WorkstationStatus::Phase::kRunning;
  on_state_(workstation_.newest(), status.branch, is_solving);
  std::vector<Warning> warnings = workstation_.warnings();
  std::vector<ContactEvent> events;
  if (status.branch == branch_) {
    events = workstation_.events(events_);
    events_ += events.size();
  } else {  // what the new branch has from its ancestors is no news
    branch_ = status.branch;
    events_ = workstation_.events().size();
    warnings_ = warnings.size();
  }
  warnings_ = std::min(warnings_, warnings.size());
  for (; warnings_ < warnings.size(); ++warnings_)
    add("warning", to_line(make_warning_json(warnings[warnings_])));
  for (const ContactCounts& counts : count_contact(events))
    add("contact", to_line(make_contact_json(counts)));
  const std::lock_guard lock(mutex_);
  status_ = status;
  ++change_;
  changed_.notify_all();
}

void News::work() {
  std::uint64_t seen = status_.version;
  while (true) {
    const WorkstationStatus status = workstation_.wait_status(seen, kLook);
    const bool is_new = status.version != seen;
    if (is_new) look(status);
    seen = status.version;
    std::unique_lock lock(mutex_);
    if (changed_.wait_for(lock, is_new ? kPause : kNoPause, [this] { return is_closed_; })) return;
  }
}

News::Place News::now() const {
  const std::lock_guard lock(mutex_);
  return {0, last_item_};
}

News::Reading News::wait(Place& place, std::chrono::milliseconds patience) const {
  Reading reading;
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience,
                    [&] { return is_closed_ || place.change != change_ || place.item != last_item_; });
  reading.is_closed = is_closed_;
  reading.has_status = place.change != change_;
  reading.status = status_;
  for (const Item& item : items_)
    if (item.number > place.item) reading.items.push_back(item);
  place = {change_, last_item_};
  return reading;
}

}  // namespace hydroscope
