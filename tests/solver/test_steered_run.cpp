// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "solver/increment/advance.h"
#include "solver/scene/scene_reader.h"
#include "solver/session/build_model.h"
#include "solver/session/scene_change.h"
#include "solver/session/steered_run.h"

namespace hydroscope::test {
namespace {

using testing::HasSubstr;

const std::string kCorner = "tests/baselines/corner.toml";

/// A short tube blown into a box die with friction, at the start.
std::unique_ptr<SteeredRun> start(const std::vector<std::string>& sets = {}) {
  std::vector<SceneOverride> overrides;
  for (const std::string& set : sets) overrides.push_back(make_override(set));
  auto run = std::make_unique<SteeredRun>(read_scene(kCorner, overrides), RunOptions{});
  run->set_source(read_whole_file(kCorner), overrides);
  run->start();
  return run;
}

void go(SteeredRun& run, int increments) {
  for (int i = 0; i < increments; ++i) run.step();
}

std::string find_fault(SteeredRun& run, const std::string& key, const std::string& value) {
  const std::uint64_t before = calc_hash(run.state());
  try {
    run.set(key, value);
  } catch (const InputError& error) {
    EXPECT_EQ(calc_hash(run.state()), before);
    return error.what();
  }
  return "no fault";
}

TEST(SteeredRun, GoesThroughTheStatesOfAdvanceAlone) {
  const Model model = build_model(read_scene(kCorner));
  Scratch scratch(model, 1);
  State state = make_initial_state(model);
  const auto run = start();
  for (int i = 0; i < 45; ++i) {  // past the first touches
    advance(model, state, scratch);
    run->step();
  }
  EXPECT_GT(run->step().report.n_contact, 0);
  advance(model, state, scratch);
  EXPECT_EQ(calc_hash(run->state()), calc_hash(state));
}

TEST(SteeredRun, ComesBackToTheSameBits) {
  const auto run = start();
  go(*run, 30);
  const RunPoint before_touch = run->take_point();
  go(*run, 10);
  const RunPoint in_contact = run->take_point();
  go(*run, 10);
  const std::uint64_t first = calc_hash(run->state());
  run->restore(in_contact);
  EXPECT_NE(calc_hash(run->state()), first);
  go(*run, 10);
  EXPECT_EQ(calc_hash(run->state()), first);
  run->restore(before_touch);
  go(*run, 20);
  EXPECT_EQ(calc_hash(run->state()), first);
  EXPECT_EQ(run->state().increment, 50);
}

TEST(SteeredRun, KeepsTheSameStatesAfterGoingBack) {
  const auto list_kept = [](SteeredRun& run, int until) {
    std::vector<int> kept;
    while (run.state().increment < until) {
      if (run.step().for_state) kept.push_back(run.state().increment);
    }
    return kept;
  };
  const auto run = start({"states.number=20"});
  const RunPoint point = run->take_point();
  const std::vector<int> first = list_kept(*run, 40);
  EXPECT_GT(first.size(), 10U);
  run->restore(point);
  EXPECT_EQ(list_kept(*run, 40), first);
}

TEST(SteeredRun, HaltsExactlyAtATime) {
  const auto run = start();
  const double halt = 1.0 / 3.0;
  int steps = 0;
  while (run->state().time < halt && steps++ < 100) run->step(halt);
  EXPECT_EQ(run->state().time, halt);
  EXPECT_FALSE(run->state().is_at_corner);
  // It goes on as if nothing had been: its step is not that of a fresh start.
  EXPECT_GT(run->state().next_dt, 0.5 * run->model().increment.largest * run->model().end_time);
  run->step();
  EXPECT_GT(run->state().time, halt);
}

TEST(FindCrossing, FindsTheFirstPassageAhead) {
  const Path path{{0.0, 1.0, 2.0, 3.0}, {0.0, 10.0, 4.0, 4.0}};
  EXPECT_DOUBLE_EQ(find_crossing(path, 0.0, 5.0), 0.5);
  EXPECT_DOUBLE_EQ(find_crossing(path, 0.5, 5.0), 1.0 + 5.0 / 6.0);  // falling
  EXPECT_DOUBLE_EQ(find_crossing(path, 0.2, 10.0), 1.0);             // just reached
  EXPECT_DOUBLE_EQ(find_crossing(path, 1.0, 4.0), 2.0);
  EXPECT_EQ(find_crossing(path, 1.0, 10.0), kNoHalt);  // it is there now
  EXPECT_EQ(find_crossing(path, 0.0, 11.0), kNoHalt);
  EXPECT_EQ(find_crossing(path, 2.5, 5.0), kNoHalt);
}

TEST(Set, AFrictionAheadLeavesTheStateAlone) {
  const auto run = start();
  go(*run, 40);
  const std::uint64_t before = calc_hash(run->state());
  run->set("tool.die.friction", "0.2");
  EXPECT_EQ(calc_hash(run->state()), before);
  EXPECT_EQ(run->model().tools[0].friction, 0.2);
  EXPECT_EQ(run->step().report.outcome, Outcome::kRunning);
}

TEST(Set, APathThatBeginsLaterGoesOnFromThePresentValue) {
  const auto run = start();
  go(*run, 10);
  const double now = run->state().time, value = run->model().pressure(now),
               early = run->model().pressure(0.5 * now);
  run->set("load.pressure_MPa", "[[2, 30]]");
  const Path& path = run->model().pressure;
  EXPECT_EQ(path(now), value);
  EXPECT_EQ(path(0.5 * now), early);
  EXPECT_EQ(path(2.0), 30.0);
  EXPECT_EQ(run->model().end_time, 2.0);
  EXPECT_TRUE(run->state().is_at_corner);
  run->step();
  EXPECT_NEAR(run->state().pressure, path(run->state().time), 1e-12);
}

TEST(Set, APathMustNotJump) {
  const auto run = start();
  go(*run, 10);
  const std::string fault = find_fault(*run, "load.pressure_MPa", "[[0, 0], [1, 10]]");
  EXPECT_THAT(fault,
              HasSubstr("set load.pressure_MPa [[0, 0], [1, 10]]: key 'load.pressure_MPa': would jump from"));
  EXPECT_THAT(fault, HasSubstr("expected a path through ["));
  EXPECT_EQ(find_fault(*run, "load.pressure_MPa", "[[0, 0], [1, 20], [2, 25]]"), "no fault");
  EXPECT_THAT(find_fault(*run, "load.pressure_MPa", "[[0, 0], [0.001, 0.02]]"), HasSubstr("would jump"));
}

TEST(Set, IsAsStrictAsAScene) {
  const auto run = start();
  go(*run, 3);
  EXPECT_THAT(find_fault(*run, "tool.die.friction", "-1"), HasSubstr("out of range; allowed"));
  EXPECT_THAT(find_fault(*run, "tool.die.friction", "\"much\""), HasSubstr("wrong type"));
  EXPECT_THAT(find_fault(*run, "tool.die.friction", "[1"), HasSubstr("not a TOML value"));
  EXPECT_THAT(find_fault(*run, "load.pressure_MPa", "[[2, 1], [1, 2]]"), HasSubstr("must increase"));
  EXPECT_THAT(find_fault(*run, "limits.on_necking", "halt"), HasSubstr("not known"));
  EXPECT_THAT(find_fault(*run, "stop.quantity", "t_cornr_mm"), HasSubstr("t_corner_mm"));
}

TEST(Set, WhatAStateStandsOnStays) {
  const auto run = start();
  go(*run, 3);
  for (const auto& [key, value] :
       std::vector<std::pair<std::string, std::string>>{{"tube.thickness_mm", "2"},
                                                        {"tube.elements_around", "9"},
                                                        {"material.swift_K_MPa", "400"},
                                                        {"tool.die.corner_radius_mm", "5"},
                                                        {"tool.other.friction", "0.1"},
                                                        {"shell.thickness_points", "7"},
                                                        {"increment.correction", "none"},
                                                        {"contact.constraint", "penalty"},
                                                        {"load.control", "volume"}}) {
    EXPECT_THAT(find_fault(*run, key, value), HasSubstr("cannot be changed while the run goes on")) << key;
  }
  EXPECT_THAT(find_fault(*run, "tool.die.frction", "0.1"), HasSubstr("did you mean 'tool.die.friction'?"));
  EXPECT_THAT(find_fault(*run, "tube.length_mm", "1"), HasSubstr("what may be changed: load.pressure_MPa, "));
}

TEST(Set, EverySettableKeyIsOneOfTheScenes) {
  const auto run = start();
  for (const std::string& key : settable_keys(run->scene()))
    EXPECT_THAT(find_fault(*run, key, "{}"), Not(HasSubstr("unknown"))) << key;
}

TEST(Set, AToolLeavesAheadOnly) {
  const auto run = start();
  go(*run, 5);
  EXPECT_THAT(find_fault(*run, "tool.die.leaves_at_s", "0.01"), HasSubstr("is over; the present time is"));
  EXPECT_EQ(find_fault(*run, "tool.die.leaves_at_s", "0.9"), "no fault");
}

TEST(Set, GoingBackBringsTheOldSettingsBack) {
  const auto run = start();
  go(*run, 5);
  const RunPoint point = run->take_point();
  go(*run, 5);
  const std::uint64_t first = calc_hash(run->state());
  run->restore(point);
  run->set("increment.largest", "0.005");
  go(*run, 5);
  EXPECT_NE(calc_hash(run->state()), first);
  run->restore(point);
  go(*run, 5);
  EXPECT_EQ(calc_hash(run->state()), first);
}

}  // namespace
}  // namespace hydroscope::test
