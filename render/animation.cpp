// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/animation.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "render/frame_files.h"
#include "render/image/png_file.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

/// Runs a program without a shell and returns its exit code; -1 when it cannot be started.
int run_program(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  // ffmpeg would read keys from the user's terminal.
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", 0, 0);
  posix_spawn_file_actions_addopen(&files, 1, "/dev/null", 1, 0);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, arguments[0], &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failure != 0) return -1;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

void write_mp4(const std::string& directory, const std::string& view, int frames, double frames_per_second,
               const std::string& file) {
  const std::string temporary = directory + "/." + view + ".part.mp4";
  const int code = run_program({"ffmpeg",
                                "-y",
                                "-nostdin",
                                "-loglevel",
                                "error",
                                "-framerate",
                                std::to_string(frames_per_second),
                                "-start_number",
                                "1",
                                "-i",
                                directory + "/" + view + "/%05d.png",
                                "-frames:v",
                                std::to_string(frames),
                                "-vf",
                                "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                "-c:v",
                                "libx264",
                                "-crf",
                                "17",
                                "-pix_fmt",
                                "yuv420p",
                                "-movflags",
                                "+faststart",
                                temporary});
  if (code == 127 || code == -1) throw EnvironmentError("ffmpeg cannot be started (Debian package: ffmpeg)");
  if (code != 0) {
    unlink(temporary.c_str());
    throw EnvironmentError("ffmpeg ended with code " + std::to_string(code) + " while writing " + file);
  }
  if (std::rename(temporary.c_str(), file.c_str()) != 0)
    throw EnvironmentError("cannot write " + file + ": " + std::strerror(errno));
}

void check(bool is_done, const char* what) {
  if (!is_done) throw EnvironmentError(std::string("cannot make the WebP animation: ") + what);
}

WebPConfig make_config() {
  WebPConfig config;
  check(WebPConfigPreset(&config, WEBP_PRESET_DRAWING, 90.0F) != 0, "libwebp of another version");
  config.method = 1;  // 0 (fast) .. 6 (small): the film must not take longer than its frames
  config.use_sharp_yuv = 0;
  return config;
}

void add_frame(WebPAnimEncoder* encoder, const WebPConfig& config, const Image& image, int time_ms) {
  WebPPicture picture;
  check(WebPPictureInit(&picture) != 0, "libwebp of another version");
  const std::unique_ptr<WebPPicture, void (*)(WebPPicture*)> cleanup(&picture, &WebPPictureFree);
  picture.use_argb = 1;
  picture.width = image.width;
  picture.height = image.height;
  check(WebPPictureImportRGBX(&picture, image.rgba.data(), 4 * image.width) != 0, "out of memory");
  check(WebPAnimEncoderAdd(encoder, &picture, time_ms, &config) != 0, WebPAnimEncoderGetError(encoder));
}

void write_webp(const std::string& directory, const std::string& view, int frames, double frames_per_second,
                const std::string& file) {
  WebPAnimEncoderOptions options;
  check(WebPAnimEncoderOptionsInit(&options) != 0, "libwebp of another version");
  const WebPConfig config = make_config();
  std::unique_ptr<WebPAnimEncoder, void (*)(WebPAnimEncoder*)> encoder(nullptr, &WebPAnimEncoderDelete);
  int time_ms = 0;
  for (int number = 1; number <= frames; ++number) {
    const Image image = read_png(make_frame_name(directory, view, number) + ".png").image;
    if (encoder == nullptr) encoder.reset(WebPAnimEncoderNew(image.width, image.height, &options));
    check(encoder != nullptr, "out of memory");
    time_ms = static_cast<int>(std::lround(1000.0 * (number - 1) / frames_per_second));
    add_frame(encoder.get(), config, image, time_ms);
  }
  const int end_ms = static_cast<int>(std::lround(1000.0 * frames / frames_per_second));
  check(WebPAnimEncoderAdd(encoder.get(), nullptr, end_ms, nullptr) != 0,
        WebPAnimEncoderGetError(encoder.get()));
  WebPData data;
  WebPDataInit(&data);
  const std::unique_ptr<WebPData, void (*)(WebPData*)> cleanup(&data, &WebPDataClear);
  check(WebPAnimEncoderAssemble(encoder.get(), &data) != 0, WebPAnimEncoderGetError(encoder.get()));
  write_whole_file(file, std::string_view(reinterpret_cast<const char*>(data.bytes), data.size));
}

}  // namespace

void check_animation(const std::string& kind, double frames_per_second) {
  if (kind != "none" && kind != "webp" && kind != "mp4")
    throw InputError("animation '" + kind + "' is unknown; there are none, webp and mp4");
  if (!(frames_per_second > 0.0 && frames_per_second <= 240.0))
    throw InputError("frames_per_second must lie above 0 and not above 240");
  if (kind == "mp4" && run_program({"ffmpeg", "-version"}) != 0)
    throw EnvironmentError(
        "animation mp4 needs the program ffmpeg, which cannot be started (Debian package: ffmpeg)");
}

std::string make_animation(const std::string& directory, const std::string& view, int frames,
                           const std::string& kind, double frames_per_second) {
  require(frames > 0, "an animation has at least one frame");
  // ffmpeg would end the film at the first hole without a word.
  for (int number = 1; number <= frames; ++number) {
    const std::string frame = make_frame_name(directory, view, number) + ".png";
    if (access(frame.c_str(), R_OK) != 0) throw EnvironmentError("the animation lacks its frame " + frame);
  }
  const std::string file = directory + "/" + view + "." + kind;
  if (kind == "mp4")
    write_mp4(directory, view, frames, frames_per_second, file);
  else
    write_webp(directory, view, frames, frames_per_second, file);
  return file;
}

}  // namespace hydroscope
