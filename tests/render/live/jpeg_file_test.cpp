// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/jpeg_file.h"

#include <gtest/gtest.h>
#include <jpeglib.h>  // after <cstdio>, which it needs

#include <cstdio>
#include <cstdlib>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

Image make_ramp(int width, int height) {
  Image image = make_image(width, height, {0, 0, 0});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      image.pixel(x, y)[0] = static_cast<std::uint8_t>(255 * x / width);
      image.pixel(x, y)[1] = static_cast<std::uint8_t>(255 * y / height);
      image.pixel(x, y)[2] = 90;
      image.pixel(x, y)[3] = static_cast<std::uint8_t>(x);  // must not matter
    }
  return image;
}

Image decode(const std::string& bytes) {
  jpeg_decompress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_decompress(&info);
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&info, TRUE);
  info.out_color_space = JCS_EXT_RGBA;
  jpeg_start_decompress(&info);
  Image image = make_image(static_cast<int>(info.output_width), static_cast<int>(info.output_height), {});
  while (info.output_scanline < info.output_height) {
    JSAMPROW row = image.pixel(0, static_cast<int>(info.output_scanline));
    jpeg_read_scanlines(&info, &row, 1);
  }
  jpeg_finish_decompress(&info);
  jpeg_destroy_decompress(&info);
  return image;
}

int find_largest_difference(const Image& a, const Image& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    if (i % 4 != 3) largest = std::max(largest, std::abs(a.rgba[i] - b.rgba[i]));
  return largest;
}

TEST(Jpeg, DecodesToTheSamePictureWithinAFewLevels) {
  for (const auto& [width, height] : {std::pair{160, 96}, {37, 21}, {1, 1}}) {
    const Image image = make_ramp(width, height);
    const Image back = decode(make_jpeg(image, 95));
    ASSERT_EQ(back.width, width);
    ASSERT_EQ(back.height, height);
    EXPECT_LE(find_largest_difference(image, back), 12) << width;
  }
}

TEST(Jpeg, AThinColouredLineKeepsItsColour) {
  Image image = make_image(64, 64, {255, 255, 255});
  for (int y = 0; y < 64; ++y) image.pixel(31, y)[1] = image.pixel(31, y)[2] = 0;
  const Image back = decode(make_jpeg(image, 85));
  EXPECT_GT(back.pixel(31, 32)[0] - back.pixel(31, 32)[1], 200);
  EXPECT_GT(back.pixel(33, 32)[1], 220) << "its neighbours stay white";
}

TEST(Jpeg, LowerQualityIsSmallerAndTheSamePictureIsTheSameBytes) {
  const Image image = make_ramp(160, 96);
  EXPECT_LT(make_jpeg(image, 30).size(), make_jpeg(image, 95).size());
  EXPECT_EQ(make_jpeg(image, 80), make_jpeg(image, 80));
}

TEST(Jpeg, AlphaIsDropped) {
  Image image = make_ramp(32, 32), opaque = image;
  for (std::size_t i = 3; i < opaque.rgba.size(); i += 4) opaque.rgba[i] = 255;
  EXPECT_EQ(make_jpeg(image, 90), make_jpeg(opaque, 90));
}

TEST(Jpeg, WhatCannotBeAPictureIsRefused) {
  const Image image = make_ramp(8, 8);
  EXPECT_THROW(make_jpeg(image, 0), ContractError);
  EXPECT_THROW(make_jpeg(image, 101), ContractError);
  EXPECT_THROW(make_jpeg(Image{}, 80), ContractError);
  Image torn = image;
  torn.rgba.pop_back();
  EXPECT_THROW(make_jpeg(torn, 80), ContractError);
  // One row more than the format can hold: the library's own error, and no end of the program.
  const Image tall = make_image(1, 65501, {0, 0, 0});
  EXPECT_THROW(make_jpeg(tall, 80), EnvironmentError);
}

}  // namespace
}  // namespace hydroscope
