// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tool_picture.h"

#include <gtest/gtest.h>

#include "render/image/png_file.h"
#include "solver/base/error.h"
#include "tests/render/synthetic.h"
#include "tests/temporary_folder.h"

namespace hydroscope {
namespace {

class ToolPicture : public testing::Test {
 protected:
  Image draw(const std::vector<int>& highlighted) {
    const auto& die = model->tools[0];
    render_tool_picture(die.mesh, die.normals, highlighted, "die.stl", folder / "die.png",
                        {.size = {320, 180}});
    return read_png(folder / "die.png").image;
  }
  /// Pixels nearer to vermillion than to anything else in such a picture.
  static int count_highlighted(const Image& image) {
    int count = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < 2 * image.width / 3; ++x) {  // left of the legend
        const std::uint8_t* p = image.pixel(x, y);
        if (p[0] > 120 && p[2] < 25) ++count;
      }
    return count;
  }

  std::shared_ptr<const SnapshotModel> model = SyntheticBulge{}.make_model();
  TemporaryFolder folder;
};

TEST_F(ToolPicture, ShowsTheReportedFacets) {
  std::vector<int> some;
  for (int facet = 300; facet < 500; ++facet) some.push_back(facet);
  const int without = count_highlighted(draw({}));
  EXPECT_GT(count_highlighted(draw(some)), without + 100);
}

TEST_F(ToolPicture, AFacetThatIsNotThereIsRefused) { EXPECT_THROW(draw({1000000}), ContractError); }

TEST_F(ToolPicture, AFolderThatIsNotThereIsAReadableError) {
  const auto& die = model->tools[0];
  EXPECT_THROW(render_tool_picture(die.mesh, die.normals, {}, "die", folder / "missing/die.png"),
               EnvironmentError);
}

}  // namespace
}  // namespace hydroscope
