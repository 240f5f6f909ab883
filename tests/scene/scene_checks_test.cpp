// SPDX-License-Identifier: GPL-3.0-or-later
// Keys that are missing, or contradict each other.
#include "scene_texts.h"

namespace hydroscope::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(SceneChecks, MissingKeysOfTheSheet) {
  EXPECT_EQ(error_of(with_line(kTube, 4, "")), "a.toml:2: key 'tube.thickness_mm' is missing");
  EXPECT_EQ(error_of(with_line(kTube, 3, "")),
            "a.toml:2: key 'tube.radius_mm' is missing (or 'tube.outer_radius_mm')");
  EXPECT_EQ(error_of(with_line(kStrip, 3, "")), "a.toml:1: key 'strip.width_mm' is missing");
  EXPECT_EQ(error_of("[mesh]\nthickness_mm = 1\n"), "a.toml:1: key 'mesh.file' is missing");
}

TEST(SceneChecks, MissingKeysOfAKind) {
  EXPECT_EQ(error_of(with_line(kTube, 14, "")),
            "a.toml:9: key 'material.swift_n' is missing (needed with hardening = \"swift\")");
  EXPECT_EQ(error_of(with_line(kTube, 19, "")),
            "a.toml:17: key 'tool.die.radius_mm' is missing (needed with shape = \"cylinder\" or \"torus\")");
  EXPECT_EQ(error_of(with_line(kTube, 22, "")), "a.toml:21: key 'quantity.t_mm.kind' is missing");
  EXPECT_EQ(error_of(kTube + "[tool.other]\n"),
            "a.toml:24: key 'tool.other.file' is missing (needed with shape = \"mesh\" or \"points\")");
  EXPECT_EQ(error_of(kTube + "[frames]\npick = \"interval\"\n"),
            "a.toml:24: key 'frames.interval_s' is missing (needed with pick = \"interval\")");
}

TEST(SceneChecks, KeyWithoutEffect) {
  EXPECT_EQ(error_of(with_line(kTube, 20, "half_width_mm = 3")),
            "a.toml:20: key 'tool.die.half_width_mm': has no effect here; it is for shape = \"box\"");
  EXPECT_EQ(error_of(with_line(kTube, 5, "length_mm = 5\nsector_angle_deg = 3")),
            "a.toml:6: key 'tube.sector_angle_deg': has no effect here; it is for section = \"sector\"");
}

TEST(SceneChecks, OneSheetOnly) {
  EXPECT_EQ(error_of(kTube + "[strip]\nthickness_mm = 1\nwidth_mm = 1\n"),
            "a.toml:24: table [strip] contradicts [tube]: exactly one of [tube], [strip] and [mesh] "
            "describes the sheet");
  EXPECT_EQ(error_of("[material]\nyoungs_modulus_MPa = 1e5\n"),
            "a.toml: the sheet is missing: give one of [tube], [strip] and [mesh]");
  EXPECT_EQ(error_of("[tube]\nradius_mm=30\nthickness_mm=1\nlength_mm=1\nelements_around=4\n"),
            "a.toml: table [material] is missing");
}

TEST(SceneChecks, Tube) {
  EXPECT_EQ(error_of(with_line(kTube, 5, "length_mm = 5\nouter_radius_mm = 31")),
            "a.toml:6: key 'tube.outer_radius_mm': contradicts 'radius_mm'; give one of them");
  EXPECT_EQ(error_of(with_line(kTube, 4, "thickness_mm = 30")),
            "a.toml:4: key 'tube.thickness_mm': 30 is too thick for a shell of radius 30 mm (see "
            "'tube.radius_mm')");
  EXPECT_EQ(error_of(with_line(kTube, 8, "elements_around = 1")),
            "a.toml:8: key 'tube.elements_around': a mesh of one element cannot bend; take 2 or more");
  EXPECT_EQ(error_of(with_line(kTube, 8, "elements_around = 8\nelements_along = 2")),
            "a.toml:9: key 'tube.elements_along': a slice has one row of elements; leave this out");
  EXPECT_EQ(
      error_of(with_line(kTube, 8, "elements_around = 8\ngrading_along = [[0, 1], [3, 2]]")),
      "a.toml:9: key 'tube.grading_along': z = 3 lies outside the modelled length; allowed: -2.5 to 2.5");
}

TEST(SceneChecks, StripElements) {
  EXPECT_EQ(error_of(with_line(kStrip, 5, "elements_lead_in = 1")),
            "a.toml:1: table [strip]: a mesh of one element cannot bend; take 2 or more");
  EXPECT_EQ(error_of(with_line(kStrip, 5, "")),
            "a.toml:1: key 'strip.elements_lead_in': at least 1 is needed, as 'lead_in_mm' is not 0");
}

TEST(SceneChecks, MaterialTable) {
  const std::string text =
      with_line(with_line(with_line(kTube, 13, ""), 14, ""), 11, "hardening = \"table\"");
  EXPECT_EQ(error_of(with_line(text, 12, "table = [[0.1, 200], [0.2, 300]]")),
            "a.toml:12: key 'material.table': the first row must stand at plastic strain 0");
  EXPECT_EQ(error_of(with_line(text, 12, "table = [[0, 200], [0.2, 190]]")),
            "a.toml:12: key 'material.table': the flow stress falls from 200 to 190 MPa; softening is not "
            "modelled");
}

TEST(SceneChecks, Loads) {
  EXPECT_THAT(error_of(with_line(kTube, 16, "")), StartsWith("a.toml:15: nothing happens: no path"));
  EXPECT_EQ(error_of(with_line(kTube, 16, "control = \"volume\"\npressure_MPa = [[0, 0], [1, 17]]")),
            "a.toml:15: key 'load.volume_ratio' is missing (needed with control = \"volume\")");
  EXPECT_EQ(error_of(kTube + "[ends]\naxial = \"feed\"\n"),
            "a.toml:15: key 'load.axial_feed_mm' is missing (needed with axial = \"feed\" in [ends])");
  EXPECT_EQ(error_of(with_line(kTube, 16, "axial_feed_mm = [[0, 0], [1, 17]]")),
            "a.toml:16: key 'load.axial_feed_mm': has no effect while the ends are held; set axial = "
            "\"feed\" in [ends]");
}

TEST(SceneChecks, EndsAndEdges) {
  EXPECT_EQ(error_of(kTube + "[edge.start]\n"),
            "a.toml:24: table [edge]: only a [strip] has edges; a tube has [ends]");
  EXPECT_EQ(error_of(kStrip + "[ends]\n"),
            "a.toml:14: table [ends] is for tubes; a strip has [edge.start] and [edge.end]");
  EXPECT_EQ(error_of(with_line(kStrip, 9, "hold = [\"x\"]\nmove_x_mm = [[0, 0], [1, 1]]")),
            "a.toml:10: key 'edge.start.move_x_mm': contradicts hold = [\"x\"]");
  EXPECT_EQ(error_of(with_line(kStrip, 9, "hold = [\"z\"]")),
            "a.toml:9: key 'edge.start.hold': \"z\" is not known; allowed: \"x\", \"y\", \"rotation\"");
  EXPECT_EQ(error_of(with_line(kStrip, 9, "hold = [\"rotation\"]\nmoment_N = [[0, 0], [1, 1]]")),
            "a.toml:10: key 'edge.start.moment_N': contradicts hold = [\"rotation\"]");
}

TEST(SceneChecks, ToolSizes) {
  EXPECT_THAT(
      error_of(kTube + "[tool.b]\nshape=\"box\"\nhalf_width_mm=30\nhalf_height_mm=20\ncorner_radius_mm=25\n"),
      HasSubstr("25 is out of range; allowed: 0 to 20"));
  EXPECT_EQ(error_of(with_line(kTube, 20, "direction = [0, 0, 0]")),
            "a.toml:20: key 'tool.die.direction': [0, 0, 0] has no direction");
}

TEST(SceneChecks, ToolForms) {
  const std::string die = kTube + "[tool.b]\nfile=\"b.stl\"\n";
  EXPECT_EQ(error_of(die + "surface = \"points\"\npitch_mm = 0.5\nheight_axis = [-1, -1, 0]\n"), "no error");
  EXPECT_EQ(error_of(die + "surface = \"nagata\"\nnormals = \"max\"\nsearch = \"grid\"\n"), "no error");
  EXPECT_EQ(error_of(die + "surface = \"facets\"\nprojection = \"orthogonal\"\n"), "no error");
  EXPECT_EQ(error_of(kTube + "[tool.b]\nshape = \"points\"\nfile=\"b.grid\"\nnormals = \"facet\"\n"),
            "no error");
  EXPECT_EQ(error_of(die + "surface = \"points\"\n"),
            "a.toml:24: key 'tool.b.pitch_mm' is missing (needed with surface = \"points\")");
  EXPECT_EQ(error_of(die + "pitch_mm = 1\n"),
            "a.toml:26: key 'tool.b.pitch_mm': has no effect here; it is for surface = \"points\"");
  EXPECT_EQ(error_of(die + "projection = \"orthogonal\"\n"),
            "a.toml:26: key 'tool.b.projection': has no effect here; it is for surface = \"facets\"");
  EXPECT_THAT(error_of(die + "surface = \"nagata\"\nnormals = \"facet\"\n"),
              HasSubstr("a.toml:27: key 'tool.b.normals': \"facet\" normals make no Nagata patches"));
  EXPECT_THAT(error_of(die + "surface = \"points\"\npitch_mm = 1\nsearch = \"tree\"\n"),
              HasSubstr("key 'tool.b.search': has no effect with surface = \"points\""));
  EXPECT_THAT(error_of(die + "surface = \"points\"\npitch_mm = 1\nheight_axis = [0, 0, 0]\n"),
              HasSubstr("key 'tool.b.height_axis': [0, 0, 0] has no direction"));
}

TEST(SceneChecks, NamesOfQuantitiesAndTools) {
  EXPECT_EQ(error_of(kTube + "[quantity.s]\nkind = \"sum\"\nof = [\"t_m\"]\n"),
            "a.toml:26: key 'quantity.s.of': no quantity 't_m'; did you mean 't_mm'?");
  EXPECT_EQ(error_of(kTube + "[quantity.f]\nkind = \"contact_force\"\ntool = \"punch\"\n"),
            "a.toml:26: key 'quantity.f.tool': no tool 'punch'; there is: die");
  EXPECT_EQ(error_of(kTube + "[stop]\nquantity = \"x\"\nabove = 1\n"),
            "a.toml:25: key 'stop.quantity': no quantity 'x'; there is: t_mm");
  EXPECT_EQ(error_of(kTube + "[stop]\nquantity = \"t_mm\"\n"),
            "a.toml:24: table [stop]: give 'below' or 'above'");
}

TEST(SceneChecks, QuantitiesThatCombineOthers) {
  EXPECT_EQ(error_of(kTube + "[quantity.s]\nkind = \"ratio\"\nof = [\"t_mm\"]\n"),
            "a.toml:26: key 'quantity.s.of': a ratio takes two names, not 1");
  EXPECT_EQ(error_of(kTube + "[quantity.s]\nkind = \"sum\"\nof = [\"t_mm\"]\nfactors = [1, 2]\n"),
            "a.toml:27: key 'quantity.s.factors': 2 factors for 1 names");
  EXPECT_EQ(
      error_of(kTube +
               "[quantity.a]\nkind = \"sum\"\nof = [\"b\"]\n[quantity.b]\nkind = \"sum\"\nof = [\"a\"]\n"),
      "a.toml:26: key 'quantity.a.of': refers back to 'a' in a circle");
}

TEST(SceneChecks, QuantitiesOfTheOtherSheet) {
  EXPECT_EQ(error_of(with_line(kStrip, 13, "kind = \"volume\"")),
            "a.toml:13: key 'quantity.pull.kind': \"volume\" is measured on a tube, not on a strip");
  EXPECT_EQ(error_of(with_line(kTube, 23, "position = 0.5")),
            "a.toml:23: key 'quantity.t_mm.position': is for strips; give 'angle_deg' and 'z_mm'");
}

TEST(SceneChecks, IncrementBounds) {
  EXPECT_EQ(error_of(kTube + "[increment]\nlargest = 1e-8\n"),
            "a.toml:25: key 'increment.largest': smallest = 1e-06 is above largest = 1e-08");
}

}  // namespace
}  // namespace hydroscope::test
