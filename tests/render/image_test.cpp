// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/image.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "render/image/canvas.h"
#include "render/image/png_file.h"
#include "solver/base/error.h"
#include "tests/temporary_folder.h"

namespace hydroscope {
namespace {

Image make_pattern(int width, int height) {
  Image image = make_image(width, height, {0, 0, 0});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        image.pixel(x, y)[c] = static_cast<std::uint8_t>((x * 7 + y * 13 + c * 50) % 256);
  return image;
}

TEST(Image, ReductionAveragesAndTurnsUpsideUp) {
  for (int factor : {1, 2, 3}) {
    // Two pixels above each other, drawn from below: the lower one 40, the upper one 200 +- 1.
    std::vector<std::uint8_t> drawn;
    for (int y = 0; y < 2 * factor; ++y)
      for (int x = 0; x < factor; ++x) {
        const auto value =
            static_cast<std::uint8_t>(y < factor ? 40 : 200 + (factor > 1 ? (x + y) % 2 * 2 - 1 : 0));
        drawn.insert(drawn.end(), {value, value, value, 0});
      }
    const Image image = reduced(drawn.data(), 1, 2, factor);
    EXPECT_NEAR(image.pixel(0, 0)[0], 200, 1) << factor;
    EXPECT_EQ(image.pixel(0, 1)[0], 40) << factor;
    EXPECT_EQ(image.pixel(0, 1)[3], 0);
  }
}

TEST(Image, IsLaidOnItsGroundByWhatItLeavesUncovered) {
  Image image = make_image(3, 2, {0, 0, 0});
  for (int y = 0; y < 2; ++y) {
    image.pixel(0, y)[3] = 0;                                // nothing there
    image.pixel(1, y)[0] = 100, image.pixel(1, y)[3] = 128;  // half covered
    image.pixel(2, y)[0] = 200;                              // covered
  }
  lay_on_ground(image, {80, 80, 80}, {160, 160, 160});
  EXPECT_EQ(image.pixel(0, 0)[0], 100);  // a quarter of the way down
  EXPECT_EQ(image.pixel(0, 1)[0], 140);
  EXPECT_NEAR(image.pixel(1, 0)[0], 100 + 50, 1);
  EXPECT_NEAR(image.pixel(1, 0)[1], 50, 1);
  EXPECT_EQ(image.pixel(2, 1)[0], 200);
  EXPECT_EQ(image.pixel(2, 1)[1], 0);
}

TEST(PngFile, ComesBackAsItWasWithItsTexts) {
  const TemporaryFolder folder;
  const Image image = make_pattern(61, 37);
  write_png(folder / "a.png", image, {{"Renderer", "llvmpipe"}});
  const PngPicture read = read_png(folder / "a.png");
  EXPECT_EQ(read.image, image);
  EXPECT_EQ(read.texts.at("Renderer"), "llvmpipe");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1)
      << "no temporary file stays";
}

TEST(PngFile, AFolderThatIsNotThereIsAReadableError) {
  const TemporaryFolder folder;
  try {
    write_png(folder / "missing/a.png", make_pattern(4, 4));
    FAIL() << "accepted";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("missing/a.png"));
  }
}

TEST(PngFile, ACutFileIsNotRead) {
  const TemporaryFolder folder;
  write_png(folder / "a.png", make_pattern(64, 64));
  const std::string bytes = read_text(folder / "a.png");
  std::ofstream(folder / "b.png", std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  EXPECT_THROW(read_png(folder / "b.png"), InputError);
  EXPECT_THROW(read_png(folder / "none.png"), EnvironmentError);
}

TEST(Canvas, LettersCoverPixelsAndStayInTheirBox) {
  Image image = make_image(200, 60, {255, 255, 255});
  Canvas canvas(image);
  const Canvas::TextStyle style{.size = 20, .colour = {0, 0, 0}};
  canvas.text(10, 10, "p = 17.133 MPa", style);
  const auto size = Canvas::text_size("p = 17.133 MPa", style);
  int dark_inside = 0, dark_outside = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const bool is_inside = x >= 10 && x < 10 + size[0] && y >= 10 && y < 10 + size[1];
      if (image.pixel(x, y)[0] < 128) ++(is_inside ? dark_inside : dark_outside);
    }
  EXPECT_GT(dark_inside, 200);
  EXPECT_EQ(dark_outside, 0);
}

TEST(Canvas, DrawingOverTheBorderIsCut) {
  Image image = make_image(10, 10, {0, 0, 0});
  Canvas canvas(image);
  canvas.fill(-5, -5, 100, 8, {255, 0, 0});
  canvas.line(-20, 5, 50, 5, 2, {0, 255, 0});
  EXPECT_EQ(image.pixel(9, 2)[0], 255);
  EXPECT_EQ(image.pixel(9, 8)[0], 0);
  EXPECT_EQ(image.pixel(9, 5)[1], 255);
}

}  // namespace
}  // namespace hydroscope
