// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame_sequence.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "render/image/png_file.h"
#include "render/views.h"
#include "solver/base/error.h"
#include "tests/render/synthetic.h"
#include "tests/temporary_folder.h"

namespace hydroscope {
namespace {

namespace fs = std::filesystem;

/// What stands behind a key on its line.
std::string find_value(const std::string& json, const std::string& key) {
  const std::string start = "\"" + key + "\": ";
  const std::size_t at = json.find(start);
  if (at == std::string::npos) return "missing";
  const std::size_t from = at + start.size();
  const std::string line = json.substr(from, json.find('\n', from) - from);
  return line.ends_with(',') ? line.substr(0, line.size() - 1) : line;
}

class Sequence : public testing::Test {
 protected:
  Sequence() {
    options.size = {160, 90};
    options.smoothing = 1;
    options.animation = "none";
    options.queue_capacity = 2;
  }
  std::shared_ptr<Snapshot> make(int i) { return bulge.make_snapshot(model, 0.2 + 0.08 * i, 10 * i); }
  SequenceReport run(int frames) {
    FrameSequence sequence(options, folder.path());
    for (int i = 0; i < frames; ++i) sequence.submit(make(i), frames);
    return sequence.finish();
  }
  std::string sidecar(const std::string& view, int number) {
    char name[32];
    std::snprintf(name, sizeof name, "/%05d.json", number);
    return read_text(folder.path().string() + "/" + view + name);
  }

  SyntheticBulge bulge{.around = 8, .along = 8};
  std::shared_ptr<const SnapshotModel> model = bulge.make_model();
  FrameOptions options;
  TemporaryFolder folder;
};

TEST_F(Sequence, EveryFrameArrivesInOrder) {
  options.views = {"contact-map", "thickness"};
  const SequenceReport report = run(9);
  EXPECT_EQ(report.frames, 9);
  EXPECT_THAT(report.renderer, testing::HasSubstr("llvmpipe"));
  for (const std::string& view : options.views) {
    // A picture and its sidecar each, and nothing temporary.
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / view), {}), 18) << view;
    for (int i = 0; i < 9; ++i) {
      EXPECT_EQ(find_value(sidecar(view, i + 1), "increment"), std::to_string(10 * i));
      EXPECT_EQ(find_value(sidecar(view, i + 1), "frame"), std::to_string(i + 1));
    }
  }
}

TEST_F(Sequence, SidecarsCountTheSolversNodesAndSumItsForces) {
  options.views = {"contact-map"};
  run(3);
  const auto snapshot = make(2);
  const ClassCounts counts = count_classes(*snapshot);
  const std::string json = sidecar("contact-map", 3);
  EXPECT_EQ(find_value(json, "free"), std::to_string(counts.nodes[0]));
  EXPECT_EQ(find_value(json, "stick"), std::to_string(counts.nodes[1]));
  EXPECT_EQ(find_value(json, "slip"), std::to_string(counts.nodes[2]));
  EXPECT_EQ(find_value(json, "detached_now"), std::to_string(counts.nodes[3]));
  EXPECT_EQ(find_value(json, "nodes"), std::to_string(snapshot->points.size()));
  EXPECT_EQ(find_value(json, "label"), "\"t = 0.3600 s   p = 21.600 MPa   increment 20\"");
  Vec3 sum = Vec3::Zero();
  for (const Vec3& force : snapshot->contact_force) sum += force;
  double x = 0.0;
  ASSERT_EQ(std::sscanf(find_value(json, "contact_N").c_str(), "[%lf", &x), 1);
  EXPECT_EQ(x, sum.x());
}

TEST_F(Sequence, OneRangeCoversAllFrames) {
  options.views = {"thickness", "slip"};
  run(6);
  const auto thickness = [](const Snapshot& s) {
    return *std::min_element(s.thickness.begin(), s.thickness.end());
  };
  const std::string first = find_value(sidecar("thickness", 1), "thickness");
  double low = 0.0, high = 0.0;
  ASSERT_EQ(std::sscanf(first.c_str(), "[%lf, %lf]", &low, &high), 2);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(find_value(sidecar("thickness", i + 1), "thickness"), first);
    EXPECT_LE(low, thickness(*make(i)));
  }
  EXPECT_GE(high, 1.5);
  // Not wider than the data need: within a tenth of the span.
  EXPECT_LT(thickness(*make(5)) - low, 0.1 * (high - low) + 1e-12);
  EXPECT_EQ(find_value(sidecar("slip", 1), "slip-increment"),
            find_value(sidecar("slip", 6), "slip-increment"));
}

TEST_F(Sequence, AGivenRangeIsTakenAndDrawnAtOnce) {
  options.views = {"thickness"};
  options.ranges["thickness"] = {0.25, 2.0};
  FrameSequence sequence(options, folder.path());
  sequence.submit(make(0), 2);
  sequence.submit(make(1), 2);
  // Without finish(): a view with a known range does not wait for the end.
  for (int i = 0; i < 500 && !fs::exists(folder / "thickness/00002.json"); ++i) usleep(20000);
  EXPECT_EQ(find_value(sidecar("thickness", 2), "thickness"), "[0.25, 2]");
  sequence.finish();
}

TEST_F(Sequence, TheCameraStandsStillAndAnOrbitTurns) {
  options.views = {"contact-map"};
  run(3);
  EXPECT_EQ(find_value(sidecar("contact-map", 1), "position_mm"),
            find_value(sidecar("contact-map", 3), "position_mm"));
  options.camera = "orbit";
  options.replace = true;
  run(3);
  EXPECT_NE(find_value(sidecar("contact-map", 1), "position_mm"),
            find_value(sidecar("contact-map", 3), "position_mm"));
}

TEST_F(Sequence, PicturesNameTheirRenderer) {
  options.views = {"contact-map"};
  const SequenceReport report = run(1);
  const PngPicture picture = read_png(folder / "contact-map/00001.png");
  EXPECT_THAT(picture.texts.at("Renderer"), testing::HasSubstr(report.renderer));
  EXPECT_EQ(picture.image.width, 160);
  EXPECT_THAT(sidecar("contact-map", 1), testing::HasSubstr(report.renderer));
}

TEST_F(Sequence, TheProducerWaitsForASlowRendererInsteadOfLosingFrames) {
  options.views = {"contact-map", "tool-normals"};
  options.size = {1280, 720};
  options.queue_capacity = 1;
  const SequenceReport report = run(8);
  EXPECT_EQ(report.frames, 8);
  EXPECT_GT(report.seconds_producer_waited, 0.0);
  EXPECT_TRUE(fs::exists(folder / "tool-normals/00008.png"));
}

TEST_F(Sequence, NodesWithoutGapAreCounted) {
  options.views = {"gap"};
  run(1);
  const auto snapshot = make(0);
  const auto without =
      std::count_if(snapshot->gap.begin(), snapshot->gap.end(), [](double g) { return std::isnan(g); });
  ASSERT_GT(without, 0);
  EXPECT_EQ(find_value(sidecar("gap", 1), "nodes_without_value"), std::to_string(without));
}

TEST_F(Sequence, ABrokenSnapshotIsThrownAtFinishAndHoldsNobody) {
  options.views = {"contact-map"};
  FrameSequence sequence(options, folder.path());
  const auto broken = make(1);
  broken->points[3].x() = std::nan("");
  sequence.submit(make(0), 20);
  sequence.submit(broken, 20);
  for (int i = 2; i < 20; ++i) sequence.submit(make(i % 8), 20);
  EXPECT_THROW(sequence.finish(), ContractError);
  EXPECT_TRUE(fs::exists(folder / "contact-map/00001.png"));
  EXPECT_FALSE(fs::exists(folder / "contact-map/00002.png"));
}

TEST_F(Sequence, AFolderThatIsAFileIsRefusedAtOnce) {
  std::ofstream(folder / "frames") << "in the way";
  try {
    FrameSequence sequence(options, folder / "frames");
    FAIL() << "accepted";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(folder / "frames"));
  }
}

TEST_F(Sequence, AFolderThatCannotBeWrittenIsRefusedAtOnce) {
  // The kernel's own folder takes no files from anyone, root included.
  EXPECT_THROW(FrameSequence(options, "/proc/frames"), EnvironmentError);
}

TEST_F(Sequence, AFolderThatGoesAwayIsThrownAtFinish) {
  options.views = {"contact-map"};
  FrameSequence sequence(options, folder / "frames");
  fs::remove_all(folder / "frames");
  for (int i = 0; i < 8; ++i) sequence.submit(make(i), 8);
  EXPECT_THROW(sequence.finish(), EnvironmentError);
}

TEST_F(Sequence, OldFramesAreNotMixedWithNewOnes) {
  options.views = {"contact-map"};
  run(3);
  EXPECT_THROW(FrameSequence(options, folder.path()), InputError);
  options.replace = true;
  run(1);
  EXPECT_FALSE(fs::exists(folder / "contact-map/00002.png"));
}

TEST_F(Sequence, BadOptionsAreRefusedBeforeAnythingIsWritten) {
  const auto check = [&](auto change) {
    FrameOptions bad = options;
    change(bad);
    EXPECT_THROW(FrameSequence(bad, folder / "frames"), InputError);
    EXPECT_FALSE(fs::exists(folder / "frames"));
  };
  check([](FrameOptions& o) { o.views = {"contact"}; });
  check([](FrameOptions& o) { o.theme = "pink"; });
  check([](FrameOptions& o) { o.camera = "moving"; });
  check([](FrameOptions& o) { o.animation = "gif"; });
  check([](FrameOptions& o) { o.frames_per_second = 0.0; });
  check([](FrameOptions& o) { o.smoothing = 0; });
  check([](FrameOptions& o) { o.ranges["gap"] = {1.0, 1.0}; });
}

TEST_F(Sequence, ALookAtNodeThatIsNotThereIsNamed) {
  options.camera = "look-at";
  options.look_at_node = 100000;
  FrameSequence sequence(options, folder.path());
  sequence.submit(make(0), 1);
  EXPECT_THROW(sequence.finish(), InputError);
}

TEST_F(Sequence, LeavingWithoutFinishStopsCleanly) {
  options.views = {"contact-map"};
  {
    FrameSequence sequence(options, folder.path());
    for (int i = 0; i < 3; ++i) sequence.submit(make(i), 3);
  }
  for (const auto& entry : fs::directory_iterator(folder / "contact-map"))
    EXPECT_NE(entry.path().extension(), ".part");
}

TEST_F(Sequence, AnEmptySequenceIsNoError) {
  const SequenceReport report = run(0);
  EXPECT_EQ(report.frames, 0);
  EXPECT_TRUE(report.animations.empty());
}

}  // namespace
}  // namespace hydroscope
