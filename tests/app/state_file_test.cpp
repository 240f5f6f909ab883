// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/results/state_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "app/results/poly_data_file.h"
#include "sample_run.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

using testing::HasSubstr;

/// Equal to the last bit, also where a value is NaN or minus zero.
template <class Value>
bool is_same(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0);
}

TEST(StateFile, RoundTripKeepsEveryBit) {
  const TemporaryFolder folder;
  const auto model = make_model();
  const auto s = make_snapshot(model, 3);
  write_state(*s, folder.path() / "s.vtp");
  const auto back = read_state(folder.path() / "s.vtp", model);
  EXPECT_EQ(back->model, model);
  EXPECT_EQ(back->increment, 3);
  EXPECT_EQ(back->time, s->time);
  EXPECT_EQ(back->pressure, s->pressure);
  EXPECT_EQ(back->feed, s->feed);
  EXPECT_TRUE(is_same(back->points, s->points));
  EXPECT_TRUE(is_same(back->directors, s->directors));
  EXPECT_TRUE(is_same(back->thickness, s->thickness));
  EXPECT_TRUE(is_same(back->plastic_strain, s->plastic_strain));
  EXPECT_TRUE(is_same(back->contact_state, s->contact_state));
  EXPECT_TRUE(is_same(back->contact_tool, s->contact_tool));
  EXPECT_TRUE(is_same(back->gap, s->gap));
  EXPECT_TRUE(is_same(back->contact_pressure, s->contact_pressure));
  EXPECT_TRUE(is_same(back->contact_force, s->contact_force));
  EXPECT_TRUE(is_same(back->support_force, s->support_force));
  EXPECT_TRUE(is_same(back->tool_force, s->tool_force));
  EXPECT_TRUE(is_same(back->let_go_time, s->let_go_time));
  EXPECT_TRUE(is_same(back->toggles, s->toggles));
  EXPECT_TRUE(is_same(back->release_reference, s->release_reference));
  EXPECT_TRUE(is_same(back->release_threshold, s->release_threshold));
  EXPECT_TRUE(is_same(back->tool_normal, s->tool_normal));
  EXPECT_TRUE(is_same(back->slip, s->slip));
  EXPECT_TRUE(is_same(back->slip_increment, s->slip_increment));
  EXPECT_TRUE(is_same(back->tool_translation, s->tool_translation));
  EXPECT_EQ(back->quantities, s->quantities);
}

TEST(StateFile, ModelRoundTrip) {
  const TemporaryFolder folder;
  const auto model = make_model();
  write_model(*model, folder.path());
  write_state(*make_snapshot(model, 0), folder.path() / "s.vtp");
  const auto back = read_model(folder.path(), folder.path() / "s.vtp");
  EXPECT_EQ(back->title, model->title);
  EXPECT_EQ(back->quads, model->quads);
  EXPECT_TRUE(back->is_pressure_inside);
  ASSERT_EQ(back->mirrors.size(), 2U);
  EXPECT_EQ(back->mirrors[0].normal, model->mirrors[0].normal);
  EXPECT_EQ(back->mirrors[1].point, model->mirrors[1].point);
  ASSERT_EQ(back->tools.size(), 1U);
  EXPECT_EQ(back->tools[0].name, "die");
  EXPECT_TRUE(is_same(back->tools[0].mesh.points, model->tools[0].mesh.points));
  EXPECT_EQ(back->tools[0].mesh.triangles, model->tools[0].mesh.triangles);
  EXPECT_TRUE(is_same(back->tools[0].normals, model->tools[0].normals));
}

TEST(StateFile, NamesTheArraysAsPromised) {
  const TemporaryFolder folder;
  write_state(*make_snapshot(make_model(), 1), folder.path() / "s.vtp");
  const std::string bytes = read_whole_file(folder.path() / "s.vtp");
  for (const char* name :
       {"thickness_mm", "plastic_strain", "contact_state", "gap_mm", "contact_pressure_MPa",
        "contact_force_N", "tool_normal", "slip_mm", "slip_increment_mm", "node_id", "increment", "time_s",
        "pressure_MPa", "feed_mm", "TimeValue", "q.r45_mm"}) {
    EXPECT_THAT(bytes, HasSubstr("Name=\"" + std::string(name) + "\"")) << name;
  }
}

TEST(StateFile, ArraysThatARunLeavesOutAreFilledUp) {
  const TemporaryFolder folder;
  Snapshot s = *make_snapshot(make_model(), 1);
  s.gap.clear();
  s.contact_tool.clear();
  s.slip.clear();
  write_state(s, folder.path() / "s.vtp");
  const auto back = read_state(folder.path() / "s.vtp", s.model);
  EXPECT_TRUE(std::isnan(back->gap.at(0)));
  EXPECT_EQ(back->contact_tool.at(5), -1);
  EXPECT_EQ(back->slip.at(5), Vec3::Zero());
}

TEST(StateFile, AToolThatHasLeftStaysAway) {
  const TemporaryFolder folder;
  Snapshot s = *make_snapshot(make_model(), 1);
  s.tool_translation[0].setConstant(std::numeric_limits<double>::quiet_NaN());
  write_state(s, folder.path() / "s.vtp");
  EXPECT_TRUE(read_state(folder.path() / "s.vtp", s.model)->tool_translation.at(0).hasNaN());
}

TEST(StateFile, WhatTheSolverDidNotSayIsNotMadeUp) {
  const TemporaryFolder folder;
  Snapshot s = *make_snapshot(make_model(), 1);
  s.support_force.clear();
  s.tool_force.clear();
  s.let_go_time.clear();
  s.toggles.clear();
  s.release_reference.clear();
  s.release_threshold.clear();
  write_state(s, folder.path() / "s.vtp");
  const auto back = read_state(folder.path() / "s.vtp", s.model);
  EXPECT_TRUE(back->support_force.empty());
  EXPECT_TRUE(back->tool_force.empty());
  EXPECT_TRUE(back->let_go_time.empty());
  EXPECT_TRUE(back->toggles.empty());
  EXPECT_TRUE(back->release_reference.empty());
  EXPECT_TRUE(back->release_threshold.empty());
}

TEST(StateFile, CutOffAnywhereIsAnError) {
  const TemporaryFolder folder;
  const auto model = make_model();
  const std::filesystem::path file = folder.path() / "s.vtp";
  write_state(*make_snapshot(model, 1), file);
  const std::string bytes = read_whole_file(file);
  const size_t raw_end = bytes.rfind("\n  </AppendedData>");
  for (size_t size = 0; size < raw_end; size += 97) {
    write_whole_file(file, bytes.substr(0, size));
    EXPECT_THROW(read_state(file, model), InputError) << "cut at byte " << size << " of " << bytes.size();
  }
}

TEST(StateFile, DamageIsNamed) {
  const TemporaryFolder folder;
  const auto model = make_model();
  const std::filesystem::path file = folder.path() / "s.vtp";
  write_state(*make_snapshot(model, 1), file);
  std::string bytes = read_whole_file(file);
  bytes.replace(bytes.find("thickness_mm"), 5, "xxxxx");
  write_whole_file(file, bytes);
  try {
    read_state(file, model);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), file.string() + ": damaged state file: array 'thickness_mm' is missing");
  }
}

TEST(StateFile, WrongLengthIsOurFault) {
  Snapshot s = *make_snapshot(make_model(), 1);
  s.thickness.pop_back();
  EXPECT_THROW(write_state(s, "/dev/null/x"), ContractError);
}

}  // namespace
}  // namespace hydroscope::test
