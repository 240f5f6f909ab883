// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/contact_counts.h"

namespace hydroscope {
namespace {

int* find_count(ContactCounts& counts, EventKind kind) {
  switch (kind) {
    case EventKind::kTouch:
      return &counts.touched;
    case EventKind::kSlip:
      return &counts.slipped;
    case EventKind::kDetach:
      return &counts.detached;
    case EventKind::kRetouch:
      return &counts.retouched;
    case EventKind::kStick:
    case EventKind::kTakenBack:
      break;
  }
  return nullptr;
}

}  // namespace

std::vector<ContactCounts> count_contact(const std::vector<ContactEvent>& events) {
  std::vector<ContactCounts> all;
  for (const ContactEvent& event : events) {
    ContactCounts fresh;
    fresh.increment = event.increment;
    const bool is_new = all.empty() || all.back().increment != event.increment;
    int* count = find_count(is_new ? fresh : all.back(), event.kind);
    if (count == nullptr) continue;
    ++*count;
    if (is_new) all.push_back(fresh);
  }
  return all;
}

}  // namespace hydroscope
