// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "app/chart/study.h"
#include "app/chart/study_grid.h"
#include "solver/base/error.h"
#include "tests/app/chart/study_text.h"
#include "tests/temporary_folder.h"

namespace hydroscope {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// What the reader says of a text.
std::string find_fault(const std::string& text) {
  try {
    parse_study(text, "study.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

const char* const kCase = "[case.a]\nscene = \"s.toml\"\n";

TEST(StudyReader, TheGridIsTheProductOfItsAxesInTheirOrder) {
  const Study study = parse_study(make_small_study(), "folder/study.toml");
  ASSERT_EQ(study.cases.size(), 1U);
  EXPECT_EQ(study.cases[0].scene, "folder/small.toml");
  EXPECT_THAT(find_run_ids(study.cases[0]), ElementsAre("4+coarse", "4+fine", "8+coarse", "8+fine"));
  const StudyRun run = make_study_runs(study.cases[0])[2];
  ASSERT_EQ(run.overrides.size(), 2U);
  EXPECT_EQ(run.overrides[0].key + "=" + run.overrides[0].value, "tube.elements_around=8");
  EXPECT_EQ(run.overrides[1].key + "=" + run.overrides[1].value, "increment.tolerance=0.01");
  EXPECT_EQ(run.label, "8 / coarse");
}

TEST(StudyReader, VariantsAndTheFinestRunComeAfterTheGridAndReplaceWhatTheCaseSets) {
  const Study study =
      parse_study(std::string(kCase) +
                      "set.contact.curvature = \"none\"\n"
                      "[case.a.variant.other]\nlabel = \"another\"\nset.contact.curvature = \"symmetric\"\n"
                      "[case.a.finest]\nset.increment.tolerance = 1e-6\n",
                  "study.toml");
  const auto runs = make_study_runs(study.cases[0]);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0].label, "another");
  ASSERT_EQ(runs[0].overrides.size(), 1U);
  EXPECT_EQ(runs[0].overrides[0].value, "\"symmetric\"");
  EXPECT_TRUE(runs[1].is_finest);
  EXPECT_EQ(runs[1].overrides.size(), 2U);
}

TEST(StudyReader, CombinationsCanBeLeftOut) {
  std::string text = make_small_study();
  text.replace(text.find("default"), 0, "without = [\"4+fine\"]\n");
  EXPECT_THAT(find_run_ids(parse_study(text, "s.toml").cases[0]),
              ElementsAre("4+coarse", "8+coarse", "8+fine"));
}

TEST(StudyReader, AnUnknownKeyIsToldWithItsPlaceAndTheNearestOne) {
  EXPECT_THAT(find_fault(std::string(kCase) + "defualt = \"base\"\n"),
              AllOf(HasSubstr("study.toml:3"), HasSubstr("[case.a]"), HasSubstr("'defualt'"),
                    HasSubstr("did you mean 'default'?")));
  EXPECT_THAT(find_fault("[run]\nrepeat = 3\n[case.a]\nscene = \"s\"\n"),
              AllOf(HasSubstr("study.toml:2"), HasSubstr("did you mean 'repeats'?")));
  EXPECT_THAT(find_fault(std::string(kCase) + "[case.a.quantity.q]\nreferense = \"table\"\n"),
              AllOf(HasSubstr("study.toml:4"), HasSubstr("did you mean 'reference'?")));
}

TEST(StudyReader, AnUnknownTableIsTold) {
  EXPECT_THAT(find_fault("[cases.a]\n"), AllOf(HasSubstr("study.toml:1"), HasSubstr("did you mean 'case'?")));
  EXPECT_THAT(find_fault(std::string(kCase) + "[case.a.axes.mesh]\nkey = \"x\"\n"),
              AllOf(HasSubstr("study.toml:3"), HasSubstr("'axes'")));
  EXPECT_THAT(find_fault("title = \"nothing\"\n"), HasSubstr("[case.NAME]"));
}

TEST(StudyReader, AValueOfTheWrongKindIsToldWithWhatIsExpected) {
  EXPECT_THAT(find_fault("[run]\nrepeats = 0\n"), AllOf(HasSubstr("study.toml:2"), HasSubstr("1 to 99")));
  EXPECT_THAT(find_fault("[run]\ntime_limit_s = \"long\"\n"),
              AllOf(HasSubstr("\"long\""), HasSubstr("a number")));
  EXPECT_THAT(find_fault(std::string(kCase) + "timed = 1\n"), HasSubstr("true or false"));
  EXPECT_THAT(find_fault(std::string(kCase) + "[case.a.quantity.q]\nreference = \"tabel\"\n"),
              HasSubstr("did you mean 'table'?"));
}

TEST(StudyReader, QuantitiesNeedAllThatTheirReferenceIsMadeOf) {
  const std::string start = std::string(kCase) + "[case.a.quantity.q]\n";
  EXPECT_THAT(find_fault(start + "reference = \"formula\"\n"), HasSubstr("'formula' expected"));
  EXPECT_THAT(find_fault(start + "reference = \"formula\"\nformula = \"square-die-ring-thicknes\"\n"),
              HasSubstr("did you mean 'square-die-ring-thickness'?"));
  EXPECT_THAT(
      find_fault(start +
                 "reference = \"table\"\nsource = \"x\"\ndriver = \"time_s\"\nat = [1, 2]\nvalues = [1]\n"),
      HasSubstr("one for each of 'at'"));
  EXPECT_THAT(find_fault(start + "reference = \"table\"\nvalues = [1]\n"), HasSubstr("'source' expected"));
  EXPECT_THAT(find_fault(start + "reference = \"finest\"\n"), HasSubstr("[case.a.finest] expected"));
  EXPECT_THAT(find_fault(start + "driver = \"time_s\"\n"), HasSubstr("go together"));
}

TEST(StudyReader, NamesOfRunsAreChecked) {
  std::string text = make_small_study();
  text.replace(text.find("8+fine"), 6, "8+fien");
  EXPECT_THAT(find_fault(text), AllOf(HasSubstr("'8+fien'"), HasSubstr("did you mean '8+fine'?")));
  EXPECT_THAT(find_fault(make_small_study() + "[case.blow.convergence.c]\naxis = \"tolerance\"\n"),
              AllOf(HasSubstr("axis of numbers"), HasSubstr("mesh")));
  EXPECT_THAT(find_fault(make_small_study() + "[case.blow.variant.\"a/b\"]\n"), HasSubstr("letters, digits"));
}

TEST(StudyReader, AWrongSceneKeyIsToldBeforeAnythingRuns) {
  const TemporaryFolder folder;
  std::ofstream(folder / "small.toml") << make_small_scene();
  std::ofstream(folder / "study.toml")
      << make_small_study() << "[case.blow.variant.v]\nset.contact.curvatur = \"none\"\n";
  try {
    read_study(folder / "study.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("study.toml:22"), HasSubstr("contact.curvatur"), HasSubstr("curvature")));
  }
}

TEST(StudyReader, AQuantityThatTheSceneDoesNotHaveIsTold) {
  const TemporaryFolder folder;
  std::ofstream(folder / "small.toml") << make_small_scene();
  std::string text = make_small_study();
  text.replace(text.find("q.r_mm"), 6, "q.x_mm");
  std::ofstream(folder / "study.toml") << text;
  try {
    read_study(folder / "study.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("study.toml:15"), HasSubstr("'q.x_mm'"), HasSubstr("q.r_mm, q.t_mm")));
  }
}

TEST(StudyReader, AMissingTableIsTold) {
  const TemporaryFolder folder;
  std::ofstream(folder / "study.toml") << "[plot.p]\nfile = \"missing.csv\"\nx = \"a\"\ny = \"b\"\n";
  EXPECT_THROW(read_study(folder / "study.toml"), InputError);
}

TEST(StudyReader, AMissingSceneIsTold) {
  const TemporaryFolder folder;
  std::ofstream(folder / "study.toml") << "[case.a]\nscene = \"missing.toml\"\n";
  EXPECT_THROW(read_study(folder / "study.toml"), InputError);
}

}  // namespace
}  // namespace hydroscope
