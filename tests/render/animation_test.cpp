// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/animation.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "render/frame_files.h"
#include "render/image/png_file.h"
#include "solver/base/error.h"
#include "tests/temporary_folder.h"

namespace hydroscope {
namespace {

class Animation : public testing::Test {
 protected:
  void SetUp() override {
    make_view_folder(folder.path(), "gap", false);
    for (int i = 1; i <= 3; ++i)
      write_png(make_frame_name(folder.path(), "gap", i) + ".png",
                make_image(65, 33, {static_cast<std::uint8_t>(60 * i), 100, 30}));
  }
  /// How many parts of a RIFF file have this four-letter name.
  static int count_parts(const std::string& bytes, const std::string& name) {
    int count = 0;
    for (std::size_t at = bytes.find(name); at != std::string::npos; at = bytes.find(name, at + 4)) ++count;
    return count;
  }

  TemporaryFolder folder;
};

TEST_F(Animation, WebPHoldsEveryFrame) {
  const std::string file = make_animation(folder.path(), "gap", 3, "webp", 20.0);
  EXPECT_EQ(file, folder / "gap.webp");
  const std::string bytes = read_text(file);
  EXPECT_EQ(bytes.substr(0, 4), "RIFF");
  EXPECT_EQ(bytes.substr(8, 4), "WEBP");
  EXPECT_EQ(count_parts(bytes, "ANMF"), 3);
}

TEST_F(Animation, Mp4IsMadeByFfmpegAlsoForOddSizes) {
  const std::string file = make_animation(folder.path(), "gap", 3, "mp4", 20.0);
  EXPECT_EQ(read_text(file).substr(4, 4), "ftyp");
}

TEST_F(Animation, MissingFfmpegIsNamed) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  try {
    check_animation("mp4", 20.0);
    ADD_FAILURE() << "accepted";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("ffmpeg"));
  }
  EXPECT_THROW(make_animation(folder.path(), "gap", 3, "mp4", 20.0), EnvironmentError);
  setenv("PATH", path.c_str(), 1);
}

TEST_F(Animation, AFrameThatIsMissingIsAnErrorNotAShorterFilm) {
  std::filesystem::remove(folder / "gap/00002.png");
  EXPECT_THROW(make_animation(folder.path(), "gap", 3, "webp", 20.0), EnvironmentError);
  EXPECT_FALSE(std::filesystem::exists(folder / "gap.webp"));
  EXPECT_THROW(make_animation(folder.path(), "gap", 3, "mp4", 20.0), EnvironmentError);
  EXPECT_FALSE(std::filesystem::exists(folder / "gap.mp4"));
}

TEST(AnimationOptions, UnknownKindsAreRefused) {
  EXPECT_THROW(check_animation("gif", 20.0), InputError);
  EXPECT_THROW(check_animation("webp", -1.0), InputError);
  EXPECT_NO_THROW(check_animation("webp", 20.0));
}

}  // namespace
}  // namespace hydroscope
