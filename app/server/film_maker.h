// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/server/frame_service.h"

namespace hydroscope {

/// A film over kept states.
struct FilmOrder {
  std::string key;  ///< equal for equal films: who orders the same again learns how far it is
  LiveView view;
  std::vector<StateKey> states;
  std::string kind = "webp";  ///< webp | mp4
  double frames_per_second = 10.0;
};

struct FilmProgress {
  int done = 0, of = 0;  ///< pictures; one more than there are states: joining them is the last step
  std::shared_ptr<const std::string> film;  ///< bytes, when it is done
  std::string error;
};

/// Draws films between live pictures and joins them, each with a thread of its own that mostly waits. Keeps
/// the last kMost films. Any thread.
class FilmMaker {
 public:
  static constexpr std::size_t kMost = 4;
  /// Null when there is no such state; it is left out.
  using FindState = std::function<std::shared_ptr<const Snapshot>(StateKey)>;

  FilmMaker(FrameService& frames, FindState find_state);
  ~FilmMaker();
  FilmMaker(const FilmMaker&) = delete;
  FilmMaker& operator=(const FilmMaker&) = delete;

  /// Begins the film, or says how far it is; the oldest of more than kMost is given up.
  FilmProgress ask(const FilmOrder& order);
  /// Gives up what is under way.
  void stop();

 private:
  struct Film;
  void make(Film& film) const;
  /// How many there are.
  int draw_pictures(Film& film, const std::string& folder) const;

  FrameService& frames_;
  const FindState find_state_;
  std::mutex mutex_;
  std::list<std::unique_ptr<Film>> films_;  ///< oldest first
};

}  // namespace hydroscope
