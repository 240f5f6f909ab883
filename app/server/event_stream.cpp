// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/event_stream.h"

#include <thread>

#include "app/server/api_json.h"

namespace hydroscope {
namespace {

constexpr std::chrono::milliseconds kLook{1'000};  ///< how soon a viewer that has gone is noticed

std::string make_event(const std::string& event, const std::string& data) {
  return "event: " + event + "\ndata: " + data + "\n\n";
}

}  // namespace

EventStream::EventStream(Desk& desk, std::string viewer)
    : desk_(desk), viewer_(std::move(viewer)), place_(desk.news.now()) {
  desk_.news.touch();  // the others see one viewer more
}

EventStream::~EventStream() {
  desk_.viewers.leave(viewer_, Viewers::Time::clock::now());
  desk_.news.touch();
}

std::string EventStream::make_text(const News::Reading& reading) {
  std::string text;
  for (const News::Item& item : reading.items) text += make_event(item.event, item.data);
  if (reading.has_status) text += make_event("status", to_line(desk_.make_status(reading.status, viewer_)));
  if (text.empty() && Clock::now() - last_write_ >= kHeartBeat) text = ": still here\n\n";
  return text;
}

bool EventStream::go_on(httplib::DataSink& sink) {
  const News::Reading reading = desk_.news.wait(place_, kLook);
  if (reading.is_closed) {
    sink.done();
    return true;
  }
  const std::string text = make_text(reading);
  if (text.empty()) return sink.is_writable();
  if (!sink.write(text.data(), text.size())) return false;
  last_write_ = Clock::now();
  std::this_thread::sleep_for(kInterval);
  return true;
}

}  // namespace hydroscope
