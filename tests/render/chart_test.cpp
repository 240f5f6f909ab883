// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "render/chart/axis_scale.h"
#include "render/chart/label_layout.h"
#include "render/chart/line_chart.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr Rgb kRed{200, 0, 0}, kBlue{0, 0, 200};

std::vector<std::string> find_labels(const AxisScale& scale, int count) {
  std::vector<std::string> labels;
  for (const AxisTick& tick : scale.find_ticks(count))
    if (!tick.label.empty()) labels.push_back(tick.label);
  return labels;
}

TEST(AxisScale, TicksOfALinearAxisAreRoundAndInside) {
  const AxisScale scale({.low = 0.0, .high = 35.0}, {});
  EXPECT_EQ(find_labels(scale, 7), (std::vector<std::string>{"0", "5", "10", "15", "20", "25", "30", "35"}));
  const AxisScale fine({.low = 0.995, .high = 1.01}, {});
  EXPECT_EQ(find_labels(fine, 3), (std::vector<std::string>{"0.995", "1.000", "1.005", "1.010"}));
}

TEST(AxisScale, DecadesOfALogarithmicAxisAreLabelled) {
  const AxisScale scale({.scale = ChartScale::kLog, .low = 1e-3, .high = 10.0}, {});
  EXPECT_EQ(find_labels(scale, 8), (std::vector<std::string>{"0.001", "0.01", "0.1", "1", "10"}));
  EXPECT_DOUBLE_EQ(scale.to_unit(0.1), 0.5);
  const AxisScale large({.scale = ChartScale::kLog, .low = 900.0, .high = 3e4}, {});
  EXPECT_EQ(find_labels(large, 8), (std::vector<std::string>{"1000", "2000", "5000", "10000", "20000"}));
  const AxisScale small({.scale = ChartScale::kLog, .low = 1e-9, .high = 1e-6}, {});
  EXPECT_EQ(find_labels(small, 8), (std::vector<std::string>{"10⁻⁹", "10⁻⁸", "10⁻⁷", "10⁻⁶"}));
}

TEST(AxisScale, DataLieInsideAndWhatHasNoLogarithmIsLeftOut) {
  const AxisScale scale({.scale = ChartScale::kLog}, {0.0, 0.2, 30.0, -1.0, std::nan("")});
  EXPECT_FALSE(scale.takes(0.0));
  EXPECT_FALSE(scale.takes(std::numeric_limits<double>::infinity()));
  EXPECT_LT(scale.low(), 0.2);
  EXPECT_GT(scale.low(), 0.02);
  EXPECT_GT(scale.high(), 30.0);
  const AxisScale one({.scale = ChartScale::kLog}, {5.0});
  EXPECT_LT(one.low(), 5.0);
  EXPECT_GT(one.high(), 5.0);
}

TEST(AxisScale, ValuesThatDifferByRoundingHaveAnAxisAroundThem) {
  const AxisScale scale({}, {1.5, std::nextafter(1.5, 2.0)});
  EXPECT_LT(scale.low(), 1.4);
  EXPECT_GT(scale.high(), 1.6);
  EXPECT_LT(scale.find_ticks(8).size(), 20U);
  const AxisScale asked({.low = 1.5, .high = std::nextafter(1.5, 2.0)}, {});
  EXPECT_LT(asked.find_ticks(8).size(), 20U);
}

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height &&
         b.top < a.top + a.height;
}

TEST(LabelLayout, LabelsOfACrowdOverlapNeitherEachOtherNorAPoint) {
  std::vector<LabelWish> wishes;
  std::vector<PixelBox> points;
  for (int i = 0; i < 12; ++i) {
    const double x = 300.0 + 30.0 * (i % 4), y = 300.0 + 30.0 * (i / 4);
    wishes.push_back({x, y, 90, 20, 6.0});
    points.push_back({static_cast<int>(x) - 6, static_cast<int>(y) - 6, 12, 12});
  }
  const PixelBox bounds{0, 0, 800, 600};
  const auto placed = place_labels(wishes, bounds, points);
  ASSERT_EQ(placed.size(), wishes.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    EXPECT_TRUE(placed[i].has_room) << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(placed[i].box, placed[j].box)) << i << ' ' << j;
    for (const PixelBox& point : points) EXPECT_FALSE(overlap(placed[i].box, point)) << i;
  }
}

TEST(LabelLayout, ALabelAtTheEdgeStaysInsideAndALonelyOneBesideItsPoint) {
  const auto placed =
      place_labels({{795.0, 300.0, 90, 20, 6.0}, {100.0, 300.0, 90, 20, 6.0}}, {0, 0, 800, 600}, {});
  EXPECT_LE(placed[0].box.left + placed[0].box.width, 800);
  EXPECT_GT(placed[1].box.left, 100);
  EXPECT_FALSE(placed[1].is_far);
}

TEST(LabelLayout, WithoutRoomItSaysSo) {
  const auto placed =
      place_labels({{50.0, 50.0, 90, 20, 6.0}, {50.0, 50.0, 90, 20, 6.0}}, {0, 30, 100, 40}, {});
  EXPECT_FALSE(placed[0].has_room && placed[1].has_room);
}

TEST(LabelLayout, ALineIsLeftFreeWhereThereIsAnotherPlace) {
  std::vector<std::array<double, 2>> line;
  for (int i = 0; i < 40; ++i) line.push_back({400.0 + 5.0 * i, 300.0});
  const auto placed = place_labels({{400.0, 300.0, 90, 20, 6.0}}, {0, 0, 800, 600}, {}, line);
  for (const auto& point : line)
    EXPECT_FALSE(placed[0].box.holds(static_cast<int>(point[0]), static_cast<int>(point[1])));
}

class LineChartPicture : public testing::Test {
 protected:
  /// Whether a pixel near the data point (x, y), by the place the painter reports, has the colour.
  bool has_colour(const Image& image, double unit_x, double unit_y, Rgb colour, int reach = 1) const {
    const PixelBox& plot = painter.place().plot;
    const int px = plot.left + static_cast<int>(std::lround(unit_x * plot.width));
    const int py = plot.top + static_cast<int>(std::lround((1.0 - unit_y) * plot.height));
    for (int y = py - reach; y <= py + reach; ++y)
      for (int x = px - reach; x <= px + reach; ++x) {
        const std::uint8_t* p = image.pixel(x, y);
        if (std::abs(p[0] - colour[0]) < 12 && std::abs(p[1] - colour[1]) < 12 &&
            std::abs(p[2] - colour[2]) < 12)
          return true;
      }
    return false;
  }

  LineChartPainter painter{{.size = {640, 480}}};
};

TEST_F(LineChartPicture, LinesAndMarkersStandWhereTheirValuesAre) {
  LineChart chart;
  chart.x = {.title = "wall time [s]", .scale = ChartScale::kLog, .low = 0.1, .high = 10.0};
  chart.y = {.title = "error [%]", .low = 0.0, .high = 4.0};
  chart.series.push_back({.x = {0.1, 10.0}, .y = {1.0, 1.0}, .colour = kRed, .line_width = 6.0});
  chart.series.push_back(
      {.x = {1.0}, .y = {3.0}, .colour = kBlue, .marker = ChartMarker::kSquare, .marker_size = 20.0});
  const Image image = painter.draw(chart);
  EXPECT_TRUE(has_colour(image, 0.25, 0.25, kRed));
  EXPECT_TRUE(has_colour(image, 0.75, 0.25, kRed));
  EXPECT_FALSE(has_colour(image, 0.75, 0.35, kRed, 4));
  EXPECT_TRUE(has_colour(image, 0.5, 0.75, kBlue));
  EXPECT_FALSE(has_colour(image, 0.4, 0.75, kBlue, 4));
  EXPECT_TRUE(has_colour(image, 0.9, 0.9, {255, 255, 255}, 0));
}

TEST_F(LineChartPicture, AMissingValueBreaksItsLine) {
  LineChart chart;
  chart.x = {.low = 0.0, .high = 4.0};
  chart.y = {.low = 0.0, .high = 2.0};
  chart.series.push_back({.x = {0.0, 1.0, 2.0, 3.0, 4.0},
                          .y = {1.0, 1.0, std::nan(""), 1.0, 1.0},
                          .colour = kRed,
                          .line_width = 6.0});
  const Image image = painter.draw(chart);
  EXPECT_TRUE(has_colour(image, 0.12, 0.5, kRed));
  EXPECT_TRUE(has_colour(image, 0.88, 0.5, kRed));
  EXPECT_FALSE(has_colour(image, 0.5, 0.5, kRed, 6));
}

TEST_F(LineChartPicture, AFailureIsACrossAboveThePlotAtItsCost) {
  LineChart chart;
  chart.x = {.low = 0.0, .high = 4.0};
  chart.y = {.low = 0.0, .high = 2.0};
  const Image without = painter.draw(chart);
  const int top = painter.place().plot.top;
  chart.failure_title = "failed";
  chart.failures = {{1.0, "facets"}};
  const Image with = painter.draw(chart);
  const PixelBox& plot = painter.place().plot;
  ASSERT_GT(plot.top, top);
  int reds = 0, far = 0;
  for (int y = top; y < plot.top; ++y)
    for (int x = plot.left; x < plot.left + plot.width; ++x) {
      const std::uint8_t* p = with.pixel(x, y);
      if (p[0] < 180 || p[1] > 90) continue;
      const bool is_near = std::abs(x - (plot.left + plot.width / 4)) < 10 && y > top + 20;
      (is_near ? reds : far) += y > top + 20 ? 1 : 0;
    }
  EXPECT_GT(reds, 10);
  EXPECT_EQ(far, 0);
}

TEST_F(LineChartPicture, TheSameChartGivesTheSamePixelsAfterAnother) {
  LineChart chart;
  chart.series.push_back({.name = "a", .x = {1.0, 2.0}, .y = {1.0, 3.0}, .labels = {"first", "second"}});
  const Image first = painter.draw(chart);
  LineChart other = chart;
  other.x.scale = ChartScale::kLog;
  EXPECT_FALSE(painter.draw(other) == first);
  EXPECT_TRUE(painter.draw(chart) == first);
}

TEST_F(LineChartPicture, SeriesOfUnequalLengthAreRefused) {
  LineChart chart;
  chart.series.push_back({.x = {1.0, 2.0}, .y = {1.0}});
  EXPECT_THROW(painter.draw(chart), ContractError);
}

TEST_F(LineChartPicture, AChartWithoutLinesHasItsAxesAndGrid) {
  LineChart chart;
  chart.x = {.low = 0.0, .high = 4.0};
  chart.y = {.low = 0.0, .high = 2.0};
  const Image image = painter.draw(chart);
  const PixelBox& plot = painter.place().plot;
  int dark = 0, grey = 0;
  for (int y = plot.top; y < plot.top + plot.height; ++y) {
    const auto is_dark = [&](int x) { return image.pixel(x, y)[0] < 150; };
    dark += is_dark(plot.left - 1) || is_dark(plot.left) ? 1 : 0;
    grey += image.pixel(plot.left + plot.width * 3 / 16, y)[0] < 240 ? 1 : 0;
  }
  EXPECT_GT(dark, plot.height * 9 / 10);
  EXPECT_GE(grey, 3);
}

}  // namespace
}  // namespace hydroscope
