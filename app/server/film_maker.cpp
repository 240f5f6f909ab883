// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/film_maker.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "render/animation.h"
#include "render/frame_files.h"
#include "render/image/png_file.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

constexpr std::chrono::seconds kDrawPatience{120};
constexpr std::chrono::seconds kFetchTime{60};  ///< a film that is done stays for whoever comes for it
const char* const kPictures = "film";           ///< name of the sequence within its folder

/// A folder of its own that goes away with it.
class PassingFolder {
 public:
  PassingFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "hydroscope-film-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw EnvironmentError("no temporary folder can be made");
    path_ = pattern;
  }
  ~PassingFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace

struct FilmMaker::Film {
  explicit Film(FilmOrder given) : order(std::move(given)) {}
  ~Film() {
    is_given_up = true;
    if (thread.joinable()) thread.join();
  }
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  const FilmOrder order;
  std::atomic<bool> is_given_up{false};
  std::mutex mutex;
  FilmProgress progress;  ///< by `mutex`, as the next
  std::chrono::steady_clock::time_point done_at{};
  std::thread thread;  ///< last: it uses the others

  /// It was done a while ago, and there is more to show now.
  bool is_outdated(const FilmOrder& asked) {
    const std::lock_guard lock(mutex);
    return progress.film != nullptr && asked.states != order.states &&
           std::chrono::steady_clock::now() - done_at > kFetchTime;
  }
  void count() {
    const std::lock_guard lock(mutex);
    ++progress.done;
  }
};

FilmMaker::FilmMaker(FrameService& frames, FindState find_state)
    : frames_(frames), find_state_(std::move(find_state)) {}

FilmMaker::~FilmMaker() { stop(); }

void FilmMaker::stop() {
  std::list<std::unique_ptr<Film>> films;
  {
    const std::lock_guard lock(mutex_);
    films.swap(films_);
  }
  for (const auto& film : films) film->is_given_up = true;
}

FilmProgress FilmMaker::ask(const FilmOrder& order) {
  std::list<std::unique_ptr<Film>> given_up;  // joined when nothing is locked any more
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(films_.begin(), films_.end(),
                                  [&](const auto& film) { return film->order.key == order.key; });
  if (found != films_.end() && (*found)->is_outdated(order)) {
    given_up.splice(given_up.begin(), films_, found);
  } else if (found != films_.end()) {
    const std::lock_guard film_lock((*found)->mutex);
    const FilmProgress progress = (*found)->progress;
    if (!progress.error.empty()) given_up.splice(given_up.begin(), films_, found);
    return progress;
  }
  if (order.states.empty()) throw InputError("there is no kept state to make a film of");
  auto film = std::make_unique<Film>(order);
  film->progress.of = static_cast<int>(order.states.size()) + 1;
  const FilmProgress progress = film->progress;
  film->thread = std::thread([this, &made = *film] { make(made); });
  films_.push_back(std::move(film));
  if (films_.size() > kMost) given_up.splice(given_up.begin(), films_, films_.begin());
  return progress;
}

int FilmMaker::draw_pictures(Film& film, const std::string& folder) const {
  int number = 0;
  for (const StateKey& key : film.order.states) {
    FrameOrder order;
    order.kind = FrameOrder::Kind::kFilm;
    order.viewer = "film " + film.order.key;
    order.view = film.order.view;
    order.snapshot = find_state_(key);
    order.state = key;
    if (film.is_given_up) break;
    if (order.snapshot == nullptr) {
      film.count();
      continue;
    }
    const FrameAnswer answer = frames_.draw(std::move(order), kDrawPatience);
    if (film.is_given_up) break;
    if (answer.kind != FrameAnswer::Kind::kDrawn)
      throw EnvironmentError(answer.error.empty() ? "the pictures could not be drawn" : answer.error);
    write_png(make_frame_name(folder, kPictures, ++number) + ".png", *answer.image);
    film.count();
  }
  return number;
}

void FilmMaker::make(Film& film) const {
  try {
    const PassingFolder folder;
    make_folder(folder.path() / kPictures);
    const int pictures = draw_pictures(film, folder.path());
    if (film.is_given_up) return;
    if (pictures == 0) throw EnvironmentError("no kept state can be read");
    const std::string file =
        make_animation(folder.path(), kPictures, pictures, film.order.kind, film.order.frames_per_second);
    auto bytes = std::make_shared<const std::string>(read_whole_file(file));
    film.count();
    const std::lock_guard lock(film.mutex);
    film.progress.film = std::move(bytes);
    film.done_at = std::chrono::steady_clock::now();
  } catch (const std::exception& error) {
    const std::lock_guard lock(film.mutex);
    film.progress.error = error.what();
  }
}

}  // namespace hydroscope
