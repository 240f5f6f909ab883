// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/chart/closed_forms.h"
#include "app/chart/history_table.h"
#include "app/chart/pareto.h"
#include "app/chart/plane_strain_wall.h"
#include "app/chart/study_charts.h"
#include "app/chart/study_progress.h"
#include "app/chart/study_report.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ParetoFront, HoldsWhatNoOtherBeatsInBoth) {
  EXPECT_THAT(find_pareto_front({{1, 9}, {2, 4}, {3, 5}, {4, 1}, {9, 1}, {0.5, 20}}),
              ElementsAre(5, 0, 1, 3));
}

TEST(ParetoFront, WhatIsNoNumberNeverCountsAndEqualsBothDo) {
  const double nan = std::nan("");
  EXPECT_THAT(find_pareto_front({{nan, 0.0}, {1, 1}, {0.0, nan}, {1, 1}}), ElementsAre(1, 3));
  EXPECT_THAT(find_pareto_front({}), IsEmpty());
}

TEST(ParetoFront, BetterMeansBothByMoreThanTheShare) {
  EXPECT_TRUE(is_better({1.0, 1.0}, {1.2, 1.2}, 0.1));
  EXPECT_FALSE(is_better({1.0, 1.0}, {1.2, 1.05}, 0.1));
  EXPECT_FALSE(is_better({1.0, 1.0}, {1.05, 1.2}, 0.1));
  EXPECT_FALSE(is_better({1.0, std::nan("")}, {2.0, 2.0}, 0.1));
}

TEST(FitSlope, FindsThePowerAndLeavesOutWhatHasNoLogarithm) {
  EXPECT_NEAR(fit_slope({0.1, 0.2, 0.4, 0.0}, {0.03, 0.12, 0.48, 1.0}), 2.0, 1e-12);
  EXPECT_TRUE(std::isnan(fit_slope({0.1}, {1.0})));
  EXPECT_TRUE(std::isnan(fit_slope({0.1, 0.1}, {1.0, 2.0})));
}

TEST(HistoryTable, InterpolatesWhereTheDriverFirstPasses) {
  const HistoryTable table({"p", "rho"}, {{0, 10, 20, 30}, {30, 20, 12, 14}});
  EXPECT_DOUBLE_EQ(*table.find_at("p", "rho", 15.0), 16.25);  // 10 + 10 * 5/8
  EXPECT_DOUBLE_EQ(*table.find_at("p", "rho", 13.0), 18.75);  // on the way down, not up again
  EXPECT_DOUBLE_EQ(*table.find_at("p", "rho", 30.0), 0.0);
  EXPECT_FALSE(table.find_at("p", "rho", 11.0));
  EXPECT_THROW(table.find_at("p", "roh", 11.0), InputError);
}

/// M1 and M2 of the verification cases.
Scene make_square(double k, double eps0, double n, double modulus, double thickness) {
  Scene scene;
  scene.sheet = "tube";
  scene.tube.radius = 30.0;
  scene.tube.thickness = thickness;
  scene.material.youngs_modulus = modulus;
  scene.material.poisson = 0.3;
  scene.material.hardening = "swift";
  scene.material.swift_k = k;
  scene.material.swift_eps0 = eps0;
  scene.material.swift_n = n;
  return scene;
}

TEST(ClosedForms, CornerFillingOfM1AsTheNotebookComputedItByItself) {
  const Scene m1 = make_square(550, 0.01, 0.2, 206e3, 1.5);
  const double rho[] = {25, 20, 15, 12, 10, 8}, p[] = {20.860, 28.108, 38.626, 48.684, 58.593, 73.342};
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(calc_closed_form("square-die-frictionless-pressure", m1, rho[i]), p[i], 6e-4) << rho[i];
}

TEST(ClosedForms, TheElasticPlasticWallMeetsTheIntegrationOfFreeExpansion) {
  // Computed by somebody else's integration: hoop strain, pressure, thickness.
  const Scene m1 = make_square(550, 0.01, 0.2, 206e3, 1.5);
  EXPECT_NEAR(calc_closed_form("expansion-ring-pressure", m1, 30.0 * std::exp(0.01)), 14.2479, 2e-4);
  EXPECT_NEAR(calc_closed_form("expansion-ring-pressure", m1, 30.0 * std::exp(0.05)), 16.6904, 2e-4);
  EXPECT_NEAR(calc_closed_form("expansion-ring-pressure", m1, 30.0 * std::exp(0.0953102)), 17.1323, 2e-4);
  EXPECT_NEAR(1.5 * std::exp(-integrate_wall({206e3, 0.3, 550, 0.01, 0.2}, 0.0953102).thinning), 1.36528,
              2e-5);
  // Below yield: Hooke in plane strain, p = sigma t / r.
  EXPECT_NEAR(integrate_wall({206e3, 0.3, 550, 0.01, 0.2}, 5e-4).hoop_stress, 206e3 / 0.91 * 5e-4, 1e-9);
}

TEST(ClosedForms, ACircularDieTakesWhatThePressureOfTouchingLeaves) {
  Scene m1 = make_square(550, 0.01, 0.2, 206e3, 1.5);
  m1.tools["die"].shape = "cylinder";
  m1.tools["die"].radius = 32.703915;
  EXPECT_NEAR(calc_closed_form("circular-die-contact-pressure", m1, 30.0), 30.0 - 16.9631, 2e-3);
  EXPECT_EQ(calc_closed_form("circular-die-contact-pressure", m1, 10.0), 0.0);
  EXPECT_NEAR(calc_closed_form("circular-die-springback-radius", m1, 0.0), 31.94554, 2e-4);
}

TEST(ClosedForms, StickingLeavesAProfileThatEndsInTheCorner) {
  const Scene scene = make_square(1400, 0.05, 0.5, 193e3, 0.3);
  const double corner = 0.3 * std::pow(9.0 / 30.0, 0.27324);
  EXPECT_NEAR(calc_closed_form("square-die-sticking-thickness", scene, 9.0), corner, 1e-6);
  EXPECT_NEAR(calc_profile_form("square-die-sticking", scene, 0.0, 9.0), 0.3, 1e-12);
  EXPECT_NEAR(calc_profile_form("square-die-sticking", scene, 0.25 * std::numbers::pi, 9.0), corner, 1e-6);
  const double between = calc_profile_form("square-die-sticking", scene, std::atan(0.5), 9.0);
  EXPECT_NEAR(between, 0.3 * std::pow(0.5, 0.27324), 1e-6);
}

TEST(ClosedForms, AWallThatIsNoSwiftTubeIsRefused) {
  Scene scene = make_square(1400, 0.05, 0.5, 193e3, 0.3);
  scene.material.hardening = "voce";
  EXPECT_THROW(calc_closed_form("square-die-ring-thickness", scene, 9.0), InputError);
  scene.sheet = "strip";
  EXPECT_THROW(calc_closed_form("square-die-ring-thickness", scene, 9.0), InputError);
  EXPECT_THROW(
      calc_closed_form("circular-die-contact-pressure", make_square(550, 0.01, 0.2, 206e3, 1.5), 20.0),
      InputError);
}

/// A case of two axes, and one run of each combination.
struct MadeCase {
  MadeCase() {
    one.name = "case";
    one.standard = "a+1";
    one.axes.resize(1);
    one.axes[0].name = "axis";
    one.axes[0].settings.resize(3);
    one.quantities.resize(1);
    one.quantities[0].name = "t";
    result.one = &one;
    add("a+1", 2.0, 1.0, 0);
    add("b+1", 4.0, 3.0, 1);
    add("c+1", 1.0, 8.0, 2);
  }
  void add(const std::string& id, double wall, double error, int setting) {
    RunResult run;
    run.run = {id, id, {}, {setting}, false};
    run.is_known = true;
    run.walls = {wall, wall * 1.1, wall * 0.9};
    run.factorisations = 100 * wall;
    run.error_percent = error;
    result.runs.push_back(run);
  }
  StudyCase one;
  CaseResult result;
};

TEST(StudyCharts, AFailedRunIsACrossWithItsCauseAndNoPoint) {
  MadeCase made;
  made.result.runs[1].cause = "step floor at 43 % of the path (exit code 4)";
  const LineChart chart = make_error_chart(made.result, CostKind::kWall).chart;
  ASSERT_EQ(chart.failures.size(), 1U);
  EXPECT_EQ(chart.failures[0].label, "b+1");
  EXPECT_DOUBLE_EQ(*chart.failures[0].x, 4.0);
  EXPECT_THAT(chart.notes, testing::Contains(HasSubstr("b+1: step floor at 43 %")));
  for (const ChartSeries& series : chart.series)
    EXPECT_THAT(series.labels, testing::Not(testing::Contains("b+1")));
  EXPECT_THAT(make_chart_csv(chart), HasSubstr("\"failed\",\"b+1\",4,"));
}

TEST(StudyCharts, EveryRunIsALabelledPointAtItsMedian) {
  const MadeCase made;
  const LineChart chart = make_error_chart(made.result, CostKind::kWall).chart;
  std::vector<std::string> labels;
  for (const ChartSeries& series : chart.series)
    for (std::size_t i = 0; i < series.labels.size(); ++i) {
      labels.push_back(series.labels[i]);
      if (series.labels[i] == "a+1") {
        EXPECT_DOUBLE_EQ(series.x[i], 2.0);
      }
    }
  EXPECT_THAT(labels, ElementsAre("a+1", "b+1", "c+1"));
  EXPECT_EQ(chart.x.scale, ChartScale::kLog);
  EXPECT_EQ(chart.y.scale, ChartScale::kLog);
}

TEST(StudyReport, SaysWhatTheDefaultBeatsAndWhatBeatsIt) {
  MadeCase made;
  auto sentences = describe_default(made.result);
  ASSERT_EQ(sentences.size(), 4U);
  EXPECT_THAT(sentences[0], HasSubstr("none."));
  EXPECT_THAT(sentences[1], HasSubstr("10 %: b+1."));
  made.one.standard = "b+1";
  EXPECT_THAT(describe_default(made.result)[0], HasSubstr("10 %: a+1."));
}

TEST(StudyReport, TellsMachineFrontAndCauses) {
  MadeCase made;
  made.result.runs[2].cause = "time limit 60 s at 18 % of the path";
  ReportFacts facts;
  facts.machine.processor = "Processor X";
  facts.machine.system = "System Y";
  facts.machine.cores = 2;
  facts.machine.memory_gb = 4.0;
  facts.version = "1.2";
  facts.program_hash = "abc";
  facts.revision = "v1-3";
  const std::string report = make_study_report({}, {{&made.result, {"case-error-wall"}}}, {}, facts);
  for (const char* piece : {"Processor X, 2 cores, 4 GiB", "System Y", "Hydroscope 1.2, hash abc", "v1-3",
                            "| a+1 **(default)** | 1 | 2 (1.8 to 2.2) | 200 | 0 | wall, factorisations |",
                            "**failed**: time limit 60 s", "![case-error-wall](case-error-wall.png)"})
    EXPECT_THAT(report, HasSubstr(piece));
}

TEST(StudyResult, TheMedianIsTheMiddleOne) {
  EXPECT_DOUBLE_EQ(calc_median({3.0, 1.0, 9.0}), 3.0);
  EXPECT_DOUBLE_EQ(calc_median({4.0, 1.0}), 2.5);
  EXPECT_TRUE(std::isnan(calc_median({})));
}

TEST(StudyProgress, TheBarTellsHowFarAndHowLong) {
  EXPECT_EQ(make_study_bar(5, 20, 2, 1, 60.0, "a/b"),
            "[#####...............]  5 of 20 runs, 2 under way, 1 failed, about 3:00 left  a/b");
}

}  // namespace
}  // namespace hydroscope
