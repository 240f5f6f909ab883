// SPDX-License-Identifier: GPL-3.0-or-later
// The server with the painter of the program.
#include <gtest/gtest.h>

#include <fstream>

#include "render/image/png_file.h"
#include "tests/app/server/served_scene.h"

namespace hydroscope::test {
namespace {

class ServerPictures : public testing::Test {
 protected:
  Image draw(const std::string& more) const {
    const Got got = scene_.get("/api/frame?viewer=a&format=png&text=0&w=320&h=240&" + more);
    EXPECT_EQ(got.status, 200) << got.body;
    const std::string file = scene_.folder / "picture.png";
    std::ofstream(file, std::ios::binary) << got.body;
    return read_png(file).image;
  }
  ServedScene scene_{nullptr};
};

TEST_F(ServerPictures, ThePictureTurnsWithTheCamera) {
  const Image front = draw("az=90&el=10");
  EXPECT_EQ(front.width, 320);
  EXPECT_EQ(front.height, 240);
  EXPECT_TRUE(front == draw("az=90&el=10"));
  EXPECT_FALSE(front == draw("az=60&el=10"));
  EXPECT_FALSE(front == draw("az=90&el=10&view=thickness"));
}

TEST_F(ServerPictures, WhatIsPickedIsTheNodeUnderThePixel) {
  scene_.run_to_end();
  const std::string view = "viewer=a&w=320&h=240&az=35&el=25";
  const Json box = scene_.get("/api/pick_box?" + view + "&x0=0&y0=0&x1=320&y1=240").json();
  ASSERT_FALSE(box.at("nodes").items().empty());
  EXPECT_EQ(box.at("summary").at("count").number(), static_cast<double>(box.at("nodes").items().size()));
  // Pixel by pixel until the wall is hit.
  Json pick;
  for (int y = 4; y < 240 && (pick.is_null() || pick.at("node").is_null()); y += 4)
    for (int x = 4; x < 320 && (pick.is_null() || pick.at("node").is_null()); x += 4)
      pick = scene_.get("/api/pick?" + view + "&x=" + std::to_string(x) + "&y=" + std::to_string(y)).json();
  ASSERT_FALSE(pick.at("node").is_null());
  const int node = static_cast<int>(pick.at("node").number());
  const Json values = scene_.get("/api/node/" + std::to_string(node)).json();
  for (const char* key : {"thickness_mm", "plastic_strain", "contact_pressure_MPa", "slip_mm"})
    EXPECT_EQ(pick.at(key).number(), values.at(key).number()) << key;
  EXPECT_EQ(pick.at("element_values").at("element").number(), pick.at("element").number());
  EXPECT_TRUE(scene_.get("/api/pick?" + view + "&x=1&y=1").json().at("node").is_null());
}

}  // namespace
}  // namespace hydroscope::test
