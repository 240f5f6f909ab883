// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a check that need no renderer.
#include <gmock/gmock.h>

#include "app/check/baseline.h"
#include "app/check/check_report.h"
#include "app/check/frame_comparison.h"
#include "app/check/sidecar_comparison.h"
#include "solver/base/error.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* kSidecar = R"({
  "frame": 3, "label": "t = 1.0000 s", "pressure_MPa": 20.0,
  "counts": {"free": 40, "stick": 2},
  "range": {"gap": [0, 2]},
  "camera": {"position_mm": [100, 0, 0], "scale_mm": 50},
  "sums": {"gap_mm": 12.5},
  "tools": {"die": {"largest_normal_angle_deg": 1.5, "translation_mm": [null, null, null], "force_N": [0, 0, 0]}},
  "balance": {"scale_N": 1000, "rest_N": [1e-5, 0, 0]},
  "font": "DejaVu Sans", "renderer": "llvmpipe", "lettering_px": [1, 2, 3, 4]
})";

std::vector<std::string> compare_after(const std::string& from, const std::string& to) {
  std::string text = kSidecar;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  return compare_sidecars(Json::parse(kSidecar), Json::parse(text));
}

TEST(SidecarComparison, EqualOnesAreEqual) { EXPECT_THAT(compare_after("{", "{"), IsEmpty()); }

TEST(SidecarComparison, WordsAndCountsAreExact) {
  EXPECT_THAT(compare_after("1.0000 s", "1.0001 s"),
              ElementsAre("label: \"t = 1.0001 s\" instead of \"t = 1.0000 s\""));
  EXPECT_THAT(compare_after("\"stick\": 2", "\"stick\": 3"), ElementsAre("counts.stick: 3 instead of 2"));
  EXPECT_THAT(compare_after("\"frame\": 3", "\"frame\": 3.0000001"), Not(IsEmpty()));
}

TEST(SidecarComparison, CountsOfDetachmentAreExactHoweverLarge) {
  const auto compare = [](const char* expected, const char* got) {
    const auto make = [](const char* rest) {
      return Json::parse(std::string("{\"detachment\": {") + rest + "}}");
    };
    return compare_sidecars(make(expected), make(got));
  };
  EXPECT_THAT(compare("\"toggles\": 2000000", "\"toggles\": 2000001"),
              ElementsAre("detachment.toggles: 2000001 instead of 2000000"));
  EXPECT_THAT(compare("\"nodes_by_toggles\": [9000000, 1]", "\"nodes_by_toggles\": [9000001, 1]"),
              Not(IsEmpty()));
  EXPECT_THAT(compare("\"near_release\": 3", "\"near_release\": 4"), Not(IsEmpty()));
  EXPECT_THAT(compare("\"least_margin\": 0.5", "\"least_margin\": 0.5000001"), IsEmpty());
  EXPECT_THAT(compare("\"least_margin\": 0.5", "\"least_margin\": 0.50001"), Not(IsEmpty()));
}

TEST(SidecarComparison, QuantitiesMayDifferByAMillionth) {
  EXPECT_THAT(compare_after("20.0", "20.00001"), IsEmpty());
  EXPECT_THAT(compare_after("20.0", "20.00003"), ElementsAre(HasSubstr("pressure_MPa")));
  EXPECT_THAT(compare_after("[0, 2]", "[0.000001, 2]"), IsEmpty()) << "of the greatest component";
  EXPECT_THAT(compare_after("[0, 2]", "[0.000003, 2]"), Not(IsEmpty()));
}

TEST(SidecarComparison, SmallNumbersAreMeasuredByTheModel) {
  EXPECT_THAT(compare_after("[100, 0, 0]", "[100, 0.00009, 0]"), IsEmpty());
  // 1e-8 of 1000 N and 1e-6 of 1e-5 N.
  EXPECT_THAT(compare_after("[1e-5, 0, 0]", "[1.9e-5, 0, 0]"), IsEmpty());
  EXPECT_THAT(compare_after("[1e-5, 0, 0]", "[2.1e-5, 0, 0]"), Not(IsEmpty()));
  EXPECT_THAT(compare_after("\"largest_normal_angle_deg\": 1.5", "\"largest_normal_angle_deg\": 1.50009"),
              IsEmpty());
  EXPECT_THAT(compare_after("\"largest_normal_angle_deg\": 1.5", "\"largest_normal_angle_deg\": 1.5002"),
              Not(IsEmpty()));
}

TEST(SidecarComparison, NoNumberIsNotZero) {
  EXPECT_THAT(compare_after("[null, null, null]", "[0, 0, 0]"), ElementsAre(HasSubstr("translation_mm")));
  EXPECT_THAT(compare_after("12.5", "null"), Not(IsEmpty()));
}

TEST(SidecarComparison, WhatIsMissingOrNewIsTold) {
  EXPECT_THAT(compare_after("\"label\": \"t = 1.0000 s\", ", ""), ElementsAre("label is missing"));
  EXPECT_THAT(compare_after("\"label\"", "\"more\": 1, \"label\""), ElementsAre("more was not there before"));
}

TEST(SidecarComparison, TheMachineIsNotCompared) {
  EXPECT_THAT(compare_after("DejaVu Sans", "URW Gothic"), IsEmpty());
  EXPECT_THAT(compare_after("\"llvmpipe\"", "\"llvmpipe 2\""), IsEmpty());
  EXPECT_THAT(compare_after("[1, 2, 3, 4]", "[]"), IsEmpty());
}

TEST(SequenceOrder, HolesAndTimesThatDoNotRise) {
  EXPECT_THAT(check_order({{0, 0, 0.0}, {1, 5, 0.5}, {2, 9, 1.0}}), IsEmpty());
  EXPECT_EQ(check_order({{1, 5, 0.5}}).at(0).text, "states/00000.vtp is missing");
  EXPECT_EQ(check_order({{0, 0, 0.0}, {2, 9, 1.0}}).at(0).frame, 2);
  EXPECT_THAT(check_order({{0, 0, 0.0}, {1, 5, 0.0}}).at(0).text, HasSubstr("time does not rise"));
  EXPECT_THAT(check_order({{0, 5, 0.0}, {1, 5, 0.5}}).at(0).text, HasSubstr("increments do not rise"));
}

TEST(SequenceCompleteness, SaysWhichIsMissingAndWhichIsNew) {
  const std::vector<StateStamp> three = {{0, 0, 0.0}, {1, 5, 0.5}, {2, 9, 1.0}};
  EXPECT_THAT(check_completeness(three, three), IsEmpty());
  const auto fewer = check_completeness(three, {{0, 0, 0.0}, {1, 9, 1.0}});
  ASSERT_EQ(fewer.size(), 2u);
  EXPECT_EQ(describe(fewer[0]), "sequence: 2 frames instead of 3");
  EXPECT_EQ(describe(fewer[1]), "sequence, frame 2: increment 5 (t = 0.5 s) is missing");
  EXPECT_THAT(describe(check_completeness({{0, 0, 0.0}}, three).back()), HasSubstr("was not there before"));
}

TEST(Pictures, AreSpreadOverTheSequence) {
  EXPECT_THAT(pick_pictures(21, 3), ElementsAre(1, 11, 21));
  EXPECT_THAT(pick_pictures(3, 9), ElementsAre(1, 2, 3));
  EXPECT_THAT(pick_pictures(21, 1), ElementsAre(21));
  EXPECT_THAT(pick_pictures(0, 3), IsEmpty());
}

TEST(BaselineFile, RoundTripAndStaleFrames) {
  const TemporaryFolder folder;
  Baseline baseline;
  baseline.options.views = {"gap"};
  baseline.options.size = {321, 123};
  baseline.options.azimuth = 1.0 / 3.0;
  baseline.options.most_arrows = 17;
  baseline.options.is_mirrored = false;
  baseline.fingerprint = {{"llvmpipe", "4.5"}, "DejaVu Sans", "0123456789abcdef", "ab"};
  baseline.states = {{0, 0, 0.0}, {1, 7, 0.1}};
  baseline.pictures = {2};
  std::filesystem::create_directory(folder.path() / "gap");
  for (const char* name :
       {"gap/00001.json", "gap/00001.png", "gap/00002.png", "gap/00003.json", "gap/mine.png"})
    std::ofstream(folder / name) << "x";
  write_baseline(baseline, folder.path());
  const Baseline back = read_baseline(folder.path());
  EXPECT_EQ(back.options.views, baseline.options.views);
  EXPECT_EQ(back.options.size, baseline.options.size);
  EXPECT_EQ(back.options.azimuth, baseline.options.azimuth);
  EXPECT_EQ(back.options.most_arrows, 17);
  EXPECT_FALSE(back.options.is_mirrored);
  EXPECT_TRUE(back.fingerprint.is_same(baseline.fingerprint));
  EXPECT_EQ(back.states, baseline.states);
  EXPECT_EQ(back.pictures, baseline.pictures);
  EXPECT_TRUE(std::filesystem::exists(folder / "gap/00001.json"));
  EXPECT_TRUE(std::filesystem::exists(folder / "gap/00002.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "gap/mine.png")) << "foreign files stay";
  EXPECT_FALSE(std::filesystem::exists(folder / "gap/00001.png")) << "a picture no longer kept";
  EXPECT_FALSE(std::filesystem::exists(folder / "gap/00003.json")) << "a frame no longer there";
}

CheckReport make_report() {
  CheckReport report;
  report.frames = 2;
  report.renderer = "llvmpipe <1>";
  report.findings = {{CheckStage::kSequence, "", 0, "1 frames instead of 2"},
                     {CheckStage::kValues, "", 2, "label: \"a\" instead of \"b & c\""},
                     {CheckStage::kPixels, "gap", 2, "x < y"}};
  report.pictures = {{"gap", 2, "x < y", make_image(16, 16, {1, 2, 3}), make_image(16, 16, {1, 2, 30})}};
  return report;
}

TEST(Reports, JUnitHasACaseAFrameAndView) {
  Baseline baseline;
  baseline.options.views = {"gap", "slip"};
  baseline.states = {{0, 0, 0.0}, {1, 7, 0.1}};
  const std::string xml = make_junit_report(make_report(), baseline, "my & run");
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"my &amp; run\" tests=\"7\" failures=\"3\""));
  EXPECT_THAT(xml, HasSubstr("<testcase classname=\"gap\" name=\"frame 2\">\n      <failure type=\"pixels\" "
                             "message=\"x &lt; y\"/>\n    </testcase>"));
  EXPECT_THAT(xml, HasSubstr("message=\"label: &quot;a&quot; instead of &quot;b &amp; c&quot;\""));
  EXPECT_THAT(xml, HasSubstr("<testcase classname=\"slip\" name=\"frame 2\"/>"));
  EXPECT_THAT(xml, HasSubstr("value=\"llvmpipe &lt;1&gt;\""));
}

TEST(Reports, TheTerminalGetsALineAFinding) {
  const std::string text = make_text_report(make_report(), 2);
  EXPECT_THAT(text, HasSubstr("DIFFERENT sequence: 1 frames instead of 2\n"));
  EXPECT_THAT(text, HasSubstr("... and 1 more\n"));
  EXPECT_THAT(text, HasSubstr("3 differences from the baseline\n"));
}

TEST(Reports, ThePageHoldsItsPictures) {
  const std::string page = make_html_report(make_report(), "a <run>");
  EXPECT_THAT(page, HasSubstr("a &lt;run&gt;: 3 differences"));
  EXPECT_THAT(page, HasSubstr("<li>pixels, gap, frame 2: x &lt; y</li>"));
  // "\x89PNG\r\n\x1a\n" in base 64.
  EXPECT_THAT(page, HasSubstr("src=\"data:image/png;base64,iVBORw0KGgo"));
}

}  // namespace
}  // namespace hydroscope::test
